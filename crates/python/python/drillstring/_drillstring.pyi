from collections.abc import Callable, Iterable, Sequence
from os import PathLike
from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from ._parts import (
    Bending,
    BitTorque,
    EccentricMass,
    Impulse,
    Material,
    Section,
    TabulatedFriction,
    TopDrive,
    Wall,
)

__all__ = [
    "Approach",
    "Drillstring",
    "DrillstringError",
    "DrillstringWarning",
    "Modes",
    "Motion",
    "Outcome",
    "Responses",
    "Simulation",
    "Sweep",
    "SweepFileError",
    "_TEMPLATE",
    "__version__",
    "_analyse",
    "_column_words",
    "_method_colour",
    "_motion_title",
    "_read_results",
    "_site_title",
    "_symbols",
    "_symbols_of_cases",
]

_TEMPLATE: str
__version__: str

class DrillstringError(ValueError): ...

class SweepFileError(DrillstringError):
    file: str
    line: int | None
    key: str | None
    message: str

class DrillstringWarning(UserWarning): ...

def _analyse(
    folders: Sequence[str | PathLike[str]], by: Sequence[Sequence[str]], bins: int
) -> tuple[dict[str, NDArray[Any]], dict[str, NDArray[Any]]]: ...
def _read_results(folder: str | PathLike[str], memory: str | None) -> dict[str, Any]: ...
def _symbols(motion: str, methods: int, certified: bool) -> list[tuple[str, str, str]]: ...
def _symbols_of_cases(
    motion: str,
    cases: Sequence[int],
    labels: Sequence[str | None],
    certified: Sequence[bool | None] | None,
) -> list[tuple[int, str | None]]: ...
def _motion_title(motion: str) -> str: ...
def _method_colour(method: str) -> str | None: ...
def _column_words(name: str, units: str) -> tuple[str, str, float]: ...
def _site_title(distance: float, units: str) -> str: ...
@final
class Approach:
    @property
    def free_position(self) -> tuple[float, float]: ...
    @property
    def previous_position(self) -> tuple[float, float]: ...
    @property
    def compliance(self) -> float: ...
    @property
    def free_speed(self) -> float: ...
    @property
    def spin_compliance(self) -> float: ...
    @property
    def rate(self) -> float: ...

@final
class Motion:
    @property
    def sites(self) -> NDArray[np.float64]: ...
    @property
    def time(self) -> NDArray[np.float64]: ...
    @property
    def speeds(self) -> NDArray[np.float64]: ...
    @property
    def bit_speed(self) -> NDArray[np.float64] | None: ...
    @property
    def bit_torque(self) -> NDArray[np.float64] | None: ...
    @property
    def surface_torque(self) -> NDArray[np.float64] | None: ...
    @property
    def surface_speed(self) -> NDArray[np.float64] | None: ...
    @property
    def weight_on_bit(self) -> NDArray[np.float64] | None: ...
    @property
    def rate_of_penetration(self) -> NDArray[np.float64] | None: ...
    @property
    def depth_of_cut(self) -> NDArray[np.float64] | None: ...
    @property
    def bit_angle(self) -> NDArray[np.float64] | None: ...
    @property
    def bit_depth(self) -> NDArray[np.float64] | None: ...
    @property
    def rock_depth(self) -> NDArray[np.float64] | None: ...
    @property
    def positions(self) -> NDArray[np.float64] | None: ...
    @property
    def wall_forces(self) -> NDArray[np.float64] | None: ...
    @property
    def normal_forces(self) -> NDArray[np.float64] | None: ...
    @property
    def wall_torques(self) -> NDArray[np.float64] | None: ...
    @property
    def touches(self) -> NDArray[np.bool_] | None: ...
    @property
    def rolls(self) -> NDArray[np.bool_] | None: ...
    def __len__(self) -> int: ...

@final
class Outcome:
    @property
    def torsion(self) -> str | None: ...
    @property
    def lateral(self) -> str | None: ...
    @property
    def ended(self) -> str: ...
    @property
    def simulated(self) -> float: ...
    @property
    def measures(self) -> dict[str, float]: ...

@final
class Responses:
    @property
    def method(self) -> str: ...
    @property
    def sampling_frequency(self) -> float: ...
    @property
    def longest_time(self) -> float: ...
    @property
    def sites(self) -> NDArray[np.float64]: ...
    @property
    def torques(self) -> list[int]: ...
    @property
    def from_surface(self) -> NDArray[np.float64] | None: ...
    @property
    def from_torques(self) -> NDArray[np.float64] | None: ...
    @property
    def from_forces(self) -> NDArray[np.float64] | None: ...
    @property
    def torsion_margin(self) -> float | None: ...
    @property
    def bending_margin(self) -> float | None: ...
    def simulate(
        self,
        surface_speed: float,
        duration: float,
        *,
        bit: BitTorque | TabulatedFriction | Callable[[float, float, float], float] | None = None,
        walls: Sequence[Wall | Any] | None = None,
        impulses: Sequence[Impulse] = ...,
        eccentric_masses: Sequence[EccentricMass] = ...,
        rise: float = 0.0,
    ) -> Motion: ...
    def regimes(
        self,
        surface_speed: float,
        duration: float,
        *,
        closing_window: float,
        bit: BitTorque | TabulatedFriction | Callable[[float, float, float], float] | None = None,
        walls: Sequence[Wall | Any] | None = None,
        impulses: Sequence[Impulse] = ...,
        eccentric_masses: Sequence[EccentricMass] = ...,
        rise: float = 0.0,
    ) -> Outcome: ...

@final
class Simulation:
    @property
    def row(self) -> dict[str, Any]: ...
    @property
    def motion(self) -> Motion | None: ...
    @property
    def failure(self) -> str | None: ...
    def plot(self, *, axes: Sequence[Any] | None = None) -> list[Any]: ...

@final
class Modes:
    @property
    def frequencies(self) -> NDArray[np.float64]: ...
    @property
    def damping_ratios(self) -> NDArray[np.float64] | None: ...
    @property
    def depths(self) -> NDArray[np.float64]: ...
    @property
    def shapes(self) -> NDArray[np.float64]: ...

@final
class Drillstring:
    def __new__(
        cls,
        sections: Sequence[Section],
        *,
        material: Material,
        torsional_damping: float,
        top_drive: TopDrive | None = None,
    ) -> Drillstring: ...
    @property
    def length(self) -> float: ...
    @property
    def torsional_damping(self) -> float: ...
    @property
    def torsional_stiffness(self) -> float: ...
    @property
    def torsional_travel_time(self) -> float: ...
    @property
    def sampling_frequency(self) -> float: ...
    def responses(
        self,
        method: str = "held",
        *,
        longest_time: float,
        sites: Sequence[float] | None = None,
        torques: Sequence[int] | None = None,
        bending: Bending | None = None,
        sampling_frequency: float | None = None,
        transform: float | None = None,
        elements_per_cell: int = 20,
        gamma: float = 0.52,
        beta: float | None = None,
        masses: Sequence[float] | None = None,
    ) -> Responses: ...
    def torsion_response(
        self, frequencies: Iterable[float], *, sites: Sequence[float] | None = None
    ) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]: ...
    def bending_response(
        self,
        frequencies: Iterable[float],
        *,
        bending: Bending,
        sites: Sequence[float] | None = None,
    ) -> NDArray[np.complex128]: ...
    def torsional_modes(self, count: int, *, depths: int = 201) -> Modes: ...
    def bending_modes(self, count: int, *, bending: Bending, depths: int = 201) -> Modes: ...

@final
class Sweep:
    @staticmethod
    def read(path: str | PathLike[str], *, methods: Sequence[str] | None = None) -> Sweep: ...
    @staticmethod
    def from_toml(
        text: str,
        *,
        name: str = "sweep",
        folder: str | PathLike[str] = ...,
        methods: Sequence[str] | None = None,
    ) -> Sweep: ...
    @staticmethod
    def _from_json(
        json: str, name: str, folder: str | PathLike[str], methods: Sequence[str] | None
    ) -> Sweep: ...
    @staticmethod
    def _from_texts(
        path: str | PathLike[str], methods: Sequence[str], texts: Any, has_lines: bool
    ) -> Sweep: ...
    def _parts(self) -> tuple[Any, ...]: ...
    @property
    def name(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def methods(self) -> list[str]: ...
    @property
    def axes(self) -> list[str]: ...
    @property
    def cases(self) -> int: ...
    @property
    def string(self) -> Drillstring: ...
    @property
    def sites(self) -> list[float]: ...
    @property
    def sampling_frequency(self) -> float: ...
    def values(self, case: int) -> dict[str, float]: ...
    def _json(self) -> str: ...
    def responses(self, method: str | None = None) -> Responses: ...
    def simulate(
        self,
        case: int = 0,
        *,
        set: dict[str, float] | None = None,
        method: str | None = None,
        full: bool = False,
        allow_unstable: bool = False,
        memory: str | None = None,
    ) -> Simulation: ...
    def _limits(self, *, memory: str | None = None) -> dict[str, NDArray[Any]]: ...
    def _limit_curves(self, *, memory: str | None = None) -> list[dict[str, Any]]: ...
    def _about(self) -> dict[str, Any]: ...
    def _whirl_limits(self, least: float, most: float) -> dict[str, NDArray[Any]]: ...
    def _static_string(
        self, *, bit: str | None = None
    ) -> tuple[str, dict[str, NDArray[Any]], dict[str, NDArray[Any]]] | None: ...
    def _window(
        self,
        folders: Sequence[str | PathLike[str]] | None,
        *,
        orders: Sequence[float],
        held_at: Sequence[float] | None,
        margin: float,
        risk: float,
        bins: int,
        clearance: float,
        accept_chatter: bool,
    ) -> tuple[dict[str, NDArray[Any]], dict[str, Any] | None]: ...
    def _run(
        self,
        *,
        threads: int | None = None,
        progress: Callable[[int, int], object] | None = None,
        full: bool = False,
        allow_unstable: bool = False,
        memory: str | None = None,
    ) -> dict[str, NDArray[Any]]: ...
