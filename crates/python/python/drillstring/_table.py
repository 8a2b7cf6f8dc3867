"""Tables of labels and measures: what a run answers, or a results folder holds."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import matplotlib.axes
    import xarray

__all__ = ["About", "Curve", "Table"]


@dataclass(frozen=True)
class About:
    """What the rows of a table are of."""

    title: str  #: one line for pictures
    axes: tuple[str, ...]  #: columns of what differs between cases
    methods: tuple[str, ...]
    cases: int  #: of the whole sweep; of a trace, of the grid that it chooses from
    design: str | None  #: kind of the design, as in a sweep file
    map_axes: tuple[str, str] | None  #: what a map has to the right and upwards
    log_axes: tuple[str, ...]  #: those whose values are even in the logarithm
    surface_speed_rpm: float | None  #: where no axis has it
    units: Literal["si", "field"]  #: what pictures show; tables are in SI units

    @classmethod
    def of(cls, parts: Mapping[str, Any]) -> About:
        """Of what the engine says."""
        lists = ((name, value) for name, value in parts.items() if isinstance(value, list))
        return cls(**{**parts, **{name: tuple(value) for name, value in lists}})


@dataclass(frozen=True)
class Curve:
    """An analytic limit of a motion: of one axis along another."""

    name: str
    motion: str  #: "torsion", "lateral" or "axial"
    along: str
    limited: str
    colour: str | None  #: of the method whose limit it is
    pieces: list[list[list[float]]]  #: points of each piece: along, limited


class Table(dict[str, "NDArray[Any]"]):
    """Columns by name, those of ``labels.csv`` in its order: an array each, a row for each case
    and method.

    ``pandas.DataFrame(table)`` and ``polars.DataFrame(table)`` take it as it is. Words that a row
    lacks are ``None``, numbers not a number.
    """

    about: About
    _curves: Callable[[], list[Curve]] | list[Curve]

    def __init__(
        self,
        columns: Mapping[str, NDArray[Any]],
        about: About,
        curves: Callable[[], list[Curve]] | list[Curve],
    ) -> None:
        super().__init__(columns)
        self.about = about
        self._curves = curves

    @property
    def rows(self) -> int:
        """Number of rows."""
        return len(self["case"])

    def curves(self) -> list[Curve]:
        """The analytic limits over the axes of the design, as its map draws them."""
        return self._curves() if callable(self._curves) else self._curves

    def to_xarray(self) -> xarray.Dataset:
        """The table of a grid as a dataset of xarray: every column over the axes of the design and
        ``method``, with its ``long_name`` and its ``units``.

        Words that a row lacks are empty. Designs other than a whole grid are refused. Needs xarray.
        """
        from ._xarray import dataset

        return dataset(self)

    def plot(
        self,
        motion: str | None = None,
        *,
        x: str | None = None,
        y: str | None = None,
        where: Mapping[str, float] | None = None,
        limits: bool = True,
        ax: matplotlib.axes.Axes | None = None,
    ) -> matplotlib.axes.Axes:
        """Draw a regime map as the command has it, and return its axes. Needs matplotlib.

        A case is a circle where every method finds sustained vibration, a cross where none does, a
        square where they differ. ``x`` and ``y`` are columns: by default those of the map; of one
        axis alone, a row of symbols for each method, or any column of numbers as ``y``. ``where``
        gives other axes of a grid the value at which it is cut. ``limits=False`` leaves out the
        analytic limits, which take a moment to compute where the table is of a run.
        """
        from ._plot import draw_map

        return draw_map(self, motion, x, y, where, limits, ax)

    def __repr__(self) -> str:
        return f"<Table of {self.rows} rows: {', '.join(self)}>"


def column_of(table: Mapping[str, NDArray[Any]], name: str) -> NDArray[Any]:
    """A column that is asked for by name."""
    from ._drillstring import DrillstringError

    if name not in table:
        raise DrillstringError(f"{name!r} is no column: there are {', '.join(table)}")
    return table[name]
