"""Sweeps: what a file says, and its run."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._drillstring import _TEMPLATE, Drillstring, DrillstringError, Responses, Simulation
from ._drillstring import Sweep as _Sweep
from ._results import Folders, StaticString, Window, paths
from ._table import About, Curve, Table

__all__ = ["Sweep"]


class Sweep:
    """A sweep file, read and ready to run."""

    __slots__ = ("_sweep",)
    _sweep: _Sweep

    def __init__(self) -> None:
        raise TypeError("use Sweep.read, Sweep.new, Sweep.from_toml or Sweep.from_dict")

    @classmethod
    def _of(cls, sweep: _Sweep) -> Sweep:
        made = object.__new__(cls)
        made._sweep = sweep
        return made

    @classmethod
    def read(cls, path: str | PathLike[str], *, methods: Sequence[str] | None = None) -> Sweep:
        """Read a sweep file, with these methods instead of the file's."""
        return cls._of(_Sweep.read(path, methods=methods))

    @classmethod
    def new(cls, path: str | PathLike[str], *, force: bool = False) -> Sweep:
        """Write a commented sweep file to start from, as ``sweep new`` does, and read it. One that is
        there is written over where ``force`` says so."""
        try:
            with open(path, "w" if force else "x", encoding="utf-8") as file:
                file.write(_TEMPLATE)
        except FileExistsError:
            raise DrillstringError(
                f"{path} is there already: give another name, or force=True to write over it"
            ) from None
        return cls.read(path)

    @classmethod
    def from_toml(
        cls,
        text: str,
        *,
        name: str = "sweep",
        folder: str | PathLike[str] = "",
        methods: Sequence[str] | None = None,
    ) -> Sweep:
        """The sweep of a text as in a sweep file; files that it names are in a folder."""
        return cls._of(_Sweep.from_toml(text, name=name, folder=folder, methods=methods))

    @classmethod
    def from_dict(
        cls,
        table: Mapping[str, Any],
        *,
        name: str = "sweep",
        folder: str | PathLike[str] = "",
        methods: Sequence[str] | None = None,
    ) -> Sweep:
        """The sweep of a table as a sweep file has it, numbers and arrays of NumPy among them."""
        text = json.dumps(table, default=_plain)
        return cls._of(_Sweep._from_json(text, name, folder, methods))

    def __reduce__(self) -> tuple[Any, ...]:
        return Sweep._of_parts, self._sweep._parts()

    @classmethod
    def _of_parts(cls, *parts: Any) -> Sweep:
        return cls._of(_Sweep._from_texts(*parts))

    def __repr__(self) -> str:
        return repr(self._sweep)

    @property
    def name(self) -> str:
        """The file's name without its ending."""
        return self._sweep.name

    @property
    def title(self) -> str:
        """One line for pictures."""
        return self._sweep.title

    @property
    def methods(self) -> list[str]:
        """Names of the linear methods."""
        return self._sweep.methods

    @property
    def axes(self) -> list[str]:
        """Names of what the design varies, the columns of the table."""
        return self._sweep.axes

    @property
    def cases(self) -> int:
        """Number of cases; of a trace, of the grid that it chooses from."""
        return self._sweep.cases

    @property
    def content(self) -> dict[str, Any]:
        """The file as it is written, its bases merged in."""
        content: dict[str, Any] = json.loads(self._sweep._json(), object_hook=_given)
        return content

    @property
    def string(self) -> Drillstring:
        """The string as the file says it."""
        return self._sweep.string

    @property
    def sites(self) -> list[float]:
        """Distances of the sites from the bit, m."""
        return self._sweep.sites

    @property
    def sampling_frequency(self) -> float:
        """Sampling frequency, Hz."""
        return self._sweep.sampling_frequency

    def values(self, case: int) -> dict[str, float]:
        """The values of a case along the axes."""
        return self._sweep.values(case)

    def responses(self, method: str | None = None) -> Responses:
        """The impulse responses by which a run steps the string as the file says it, by the first
        method or one that is named."""
        return self._sweep.responses(method)

    def simulate(
        self,
        case: int = 0,
        *,
        set: Mapping[str, float] | None = None,
        method: str | None = None,
        full: bool = False,
        allow_unstable: bool = False,
        memory: str | None = None,
    ) -> Simulation:
        """Follow a case to the end of its time, as ``sweep simulate`` does, by the first method
        or one that is named; ``set`` gives axes other values."""
        return self._sweep.simulate(
            case,
            set=None if set is None else dict(set),
            method=method,
            full=full,
            allow_unstable=allow_unstable,
            memory=memory,
        )

    def limits(self, *, memory: str | None = None) -> dict[str, NDArray[Any]]:
        """The analytic limits: the columns of ``boundary.csv``, as ``sweep run`` writes it.

        Of stick-slip the one-slip estimate (Eq. 74) for every method, which is no limit; of whirl
        the friction that sustains it steadily.
        """
        return self._sweep._limits(memory=memory)

    def whirl_limits(self, least_rpm: float, most_rpm: float) -> dict[str, NDArray[Any]]:
        """The friction that sustains whirl between two surface speeds, by the same columns, of the
        string and walls as the file has them, for any design. No rows without a wall.
        """
        return self._sweep._whirl_limits(least_rpm, most_rpm)

    def static_string(self, *, bit: str | None = None) -> StaticString | None:
        """How the string lies at rest in its hole, as ``sweep inspect`` finds it: forces, bending
        moments, stresses. ``bit`` says what holds the bit sideways, ``"contact"``, ``"pinned"`` or
        ``"free"``; left out, its wall where it is a site. ``None`` where the course of the well is
        not known, or the string has no wall.
        """
        found = self._sweep._static_string(bit=bit)
        if found is None:
            return None
        numbers, along, sites = found
        return StaticString(json.loads(numbers), along, sites)

    def window(
        self,
        folders: Folders | None = None,
        *,
        orders: Sequence[float] = (1.0,),
        held_at: Sequence[float] | None = None,
        margin: float = 0.1,
        risk: float = 0.1,
        bins: int = 10,
        clearance: float = 0.05,
        accept_chatter: bool = False,
    ) -> Window:
        """Where, over weight on bit and surface speed, no limit is near, as ``sweep window`` finds
        it from results folders of this string; where none is named, from ``results/NAME``.

        ``orders`` are multiples of the surface speed that shake the string sideways, ``held_at``
        the places that hold it (from the bit, in m or the file's units), ``margin`` the part by
        which critical speeds and friction may be off, ``risk`` the part of random cases with
        vibration up to which a cell is safe, ``bins`` the ranges that they are counted in, and
        ``clearance`` the part of either axis that the best point keeps from every limit. Of a bit
        that cuts, ``accept_chatter`` counts axial chatter as safe while the bit stays in its rock.
        """
        cells, best = self._sweep._window(
            None if folders is None else paths(folders),
            orders=list(orders),
            held_at=None if held_at is None else list(held_at),
            margin=margin,
            risk=risk,
            bins=bins,
            clearance=clearance,
            accept_chatter=accept_chatter,
        )
        return Window(cells, best)

    def run(
        self,
        *,
        threads: int | None = None,
        progress: Callable[[int, int], object] | None = None,
        full: bool = False,
        allow_unstable: bool = False,
        memory: str | None = None,
    ) -> Table:
        """Run every case by every method, as ``sweep run`` does.

        ``threads`` are as many as Slurm allots, or as there are cores, where none are given.
        ``progress`` is called ten times a second with the number of simulations done and their total.
        Ctrl-C and what it raises end the run.
        """
        columns = self._sweep._run(
            threads=threads,
            progress=progress,
            full=full,
            allow_unstable=allow_unstable,
            memory=memory,
        )
        return Table(columns, About.of(self._sweep._about()), self._curves)

    def _curves(self) -> list[Curve]:
        return [Curve(**curve) for curve in self._sweep._limit_curves()]


def _given(table: dict[str, Any]) -> dict[str, Any]:
    # A sweep file has no way to say that a key is not given but to leave it out.
    return {key: value for key, value in table.items() if value is not None}


def _plain(value: Any) -> Any:
    if isinstance(value, (np.generic, np.ndarray)):
        return value.tolist()
    raise TypeError(f"a sweep has no value such as {value!r}")
