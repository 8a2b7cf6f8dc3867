"""What strings and scenes are made of; their numbers are checked where they are used."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Material:
    """What pipe, joints and collars are made of."""

    shear_modulus: float = 80e9  #: Pa
    density: float = 7850.0  #: kg/m³


@dataclass(frozen=True)
class Tube:
    """A uniform piece of tube."""

    length: float  #: m
    inner_radius: float  #: m
    outer_radius: float  #: m


@dataclass(frozen=True)
class Section:
    """A cell of tubes, from the top down, repeated."""

    parts: Sequence[Tube]
    repeat: int = 1


@dataclass(frozen=True)
class TopDrive:
    """A motor that a controller holds at its speed."""

    inertia: float  #: kg m²
    proportional_gain: float  #: N m s/rad
    integral_gain: float  #: N m/rad


@dataclass(frozen=True)
class Bending:
    """Constants of a string that bends, and how the surface holds it."""

    youngs_modulus: float = 210e9  #: Pa
    damping: float = 0.0  #: N s/m per metre of string
    compression: float = 0.0  #: N; tension where negative
    support: Literal["free", "pinned", "clamped"] = "free"


@dataclass(frozen=True)
class BitTorque:
    """Torque between bit and rock: stuck up to the static one, turning against the dynamic one."""

    torque_static: float  #: N m
    torque_dynamic: float  #: N m
    decay_speed: float = 0.0  #: rad/s over which the one falls to the other; 0 at once


@dataclass(frozen=True)
class TabulatedFriction:
    """Torque against the speed of the bit, by values that straight lines join: stuck up to the
    static torque, turning against that of its speed, either way, and beyond the last speed against
    the last torque."""

    speeds: Sequence[float]  #: rad/s, from zero up
    torques: Sequence[float]  #: N m, one for each speed
    torque_static: float | None = None  #: N m; the torque at zero where it is not given

    @classmethod
    def sampled(
        cls,
        torque: Callable[[float], float],
        fastest: float,
        steps: int = 1000,
        *,
        torque_static: float | None = None,
    ) -> TabulatedFriction:
        """The table of a function from speed (rad/s) to torque (N m), called at equal steps from
        zero up to ``fastest``. Between them it is a straight line: take as many as its curvature
        asks for."""
        speeds = [fastest * step / steps for step in range(steps + 1)]
        return cls(speeds, [torque(speed) for speed in speeds], torque_static)


@dataclass(frozen=True)
class Wall:
    """The borehole wall at a site, Hertzian, with Coulomb friction."""

    clearance: float  #: m
    friction: float  #: coefficient, the static one where it falls
    radius: float  #: radius of the string there, m
    stiffness: float = math.inf  #: N/m^1.5; infinite for a rigid wall
    dynamic_ratio: float = 1.0  #: dynamic coefficient in parts of the static one
    stribeck_speed: float = 0.0  #: m/s


@dataclass(frozen=True)
class Impulse:
    """A lateral impulse at a site, a raised cosine."""

    amount: float  #: N s
    site: int = 0
    start: float = 0.0  #: s
    duration: float = 0.02  #: s
    direction: float = 0.0  #: rad from the x axis


@dataclass(frozen=True)
class EccentricMass:
    """An unbalanced mass that turns with the string.

    With ``responses(masses=...)`` the string carries it, which is exact; without, its force is that of
    Section 5.2.3, right well below the first critical speed in bending.
    """

    mass: float  #: kg
    offset: float  #: m
    site: int = 0
