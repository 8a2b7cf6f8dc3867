"""What results folders say: how often each regime occurs, and where none is near."""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from typing import Any, NamedTuple

from numpy.typing import NDArray

from ._drillstring import _analyse

__all__ = ["Analysis", "Folders", "Window", "analyse", "paths"]

Folders = str | PathLike[str] | Sequence[str | PathLike[str]]


class Analysis(NamedTuple):
    """What ``sweep analyse`` writes, columns by name."""

    counts: dict[str, NDArray[Any]]
    """A row for each set of axes, cell, method and regime: how many cases, of how many, and the
    fraction with its 95 % interval."""
    indices: dict[str, NDArray[Any]]
    """Of a sensitivity design a row for each method, quantity and axis: Sobol's indices with their
    intervals; no rows of others."""


class Window(NamedTuple):
    """What ``sweep window`` finds over weight on bit and surface speed."""

    cells: dict[str, NDArray[Any]]
    """The columns of ``window.csv``."""
    best: dict[str, Any] | None
    """The best point: where it is, the part of either axis by which it may be off
    (``clearance``), how it stands, and whether that is as much as was asked for. ``None`` where
    nothing is safe."""


def paths(folders: Folders) -> list[str]:
    """One folder or several, as a list."""
    if isinstance(folders, (str, PathLike)):
        return [fspath(folders)]
    return [fspath(folder) for folder in folders]


def analyse(
    folders: Folders, *, by: Sequence[str | Sequence[str]] = (), bins: int = 10
) -> Analysis:
    """Count how often each regime occurs in a results folder, or in shards of one sweep, as
    ``sweep analyse`` does.

    Cases are counted in all, over each axis, and over each of ``by``: an axis by its name, or two.
    An axis of more than a few values has ``bins`` ranges.
    """
    sets = [[axes] if isinstance(axes, str) else list(axes) for axes in by]
    return Analysis(*_analyse(paths(folders), sets, bins))
