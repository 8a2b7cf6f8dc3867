"""Sweeps of an efficient model of drillstring dynamics, after T. Butlin and R. S. Langley (2015).

Everything is in SI units but what a sweep file or a table names otherwise. Sites are numbered
from the surface down, from 0; the bit, where it is one, is the last.
"""

from ._drillstring import (
    Approach,
    Drillstring,
    DrillstringError,
    DrillstringWarning,
    Modes,
    Motion,
    Outcome,
    Responses,
    Simulation,
    SweepFileError,
    __version__,
)
from ._parts import (
    Bending,
    BitTorque,
    EccentricMass,
    Impulse,
    Material,
    Section,
    TabulatedFriction,
    TopDrive,
    Tube,
    Wall,
)
from ._results import Analysis, Results, StaticString, Window, analyse
from ._sweep import Sweep
from ._table import About, Curve, Table

__all__ = [
    "About",
    "Analysis",
    "Approach",
    "Bending",
    "BitTorque",
    "Curve",
    "Drillstring",
    "DrillstringError",
    "DrillstringWarning",
    "EccentricMass",
    "Impulse",
    "Material",
    "Modes",
    "Motion",
    "Outcome",
    "Responses",
    "Results",
    "Section",
    "Simulation",
    "StaticString",
    "Sweep",
    "SweepFileError",
    "Table",
    "TabulatedFriction",
    "TopDrive",
    "Tube",
    "Wall",
    "Window",
    "__version__",
    "analyse",
]
