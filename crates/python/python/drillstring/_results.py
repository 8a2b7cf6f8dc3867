"""Results folders: what is in them, how often each regime occurs, and where none is near."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple

from numpy.typing import NDArray

from ._drillstring import _analyse, _read_results
from ._table import About, Curve, Table

__all__ = ["Analysis", "Folders", "Results", "StaticString", "Window", "analyse", "paths"]

Folders = str | PathLike[str] | Sequence[str | PathLike[str]]


@dataclass(frozen=True)
class Results:
    """A results folder: of a run, a part of one, several merged, or one that is not finished."""

    folder: Path
    table: Table
    """The rows of ``labels.csv``, of the same types as `Sweep.run` gives them."""
    boundary: dict[str, NDArray[Any]]
    """The columns of ``boundary.csv``; no rows where the run is not finished."""
    failures: dict[str, NDArray[Any]]
    """The columns of ``failures.csv``: cases without an answer, each with its reason and the
    command that repeats it."""
    manifest: dict[str, Any]
    """What was run: ``manifest.json``."""
    so_far: tuple[int, int | None] | None
    """Of a run that is not finished, simulations done, and in all where that is known."""

    @classmethod
    def read(cls, folder: str | PathLike[str], *, memory: str | None = None) -> Results:
        """Read a results folder that ``sweep run`` or ``sweep merge`` wrote, of this version or an
        earlier one.

        Its tables are held to the checksums of its manifest. Cases that a run that is not finished
        has not answered by every method are left out.
        """
        found = _read_results(folder, memory)
        curves = [Curve(**curve) for curve in found["curves"]]
        return cls(
            folder=Path(folder),
            table=Table(found["labels"], About.of(found["about"]), curves),
            boundary=found["boundary"],
            failures=found["failures"],
            manifest=json.loads(found["manifest"]),
            so_far=found["so_far"],
        )

    def __repr__(self) -> str:
        about = self.table.about
        return f"<Results in {self.folder}: {self.table.rows} rows by {', '.join(about.methods)}>"


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


class StaticString(NamedTuple):
    """A string at rest in its hole, as ``sweep inspect`` finds it."""

    numbers: dict[str, Any]
    """What the key ``lying`` of its JSON has."""
    along: dict[str, NDArray[Any]]
    """The columns of ``static_string.csv``."""
    sites: dict[str, NDArray[Any]]
    """The columns of ``static_contacts.csv``; of what is not there NaN."""


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
