"""Pictures by matplotlib that look like those of the command: symbols, colours and words are its own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._drillstring import (
    DrillstringError,
    Motion,
    _column_words,
    _method_colour,
    _motion_title,
    _site_title,
    _symbols,
    _symbols_of_cases,
)
from ._table import Curve, Table, column_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._drillstring import Simulation

MOTIONS = ("torsion", "lateral", "axial")

# Marker of matplotlib, whether it is filled, and its line in parts of its radius.
MARKERS = {
    "circle": ("o", False, 0.28),
    "cross": ("x", True, 0.26),
    "square": ("s", False, 0.42),
    "disc": ("o", True, 0.1),
    "heavy_cross": ("x", True, 0.6),
    "diamond": ("D", False, 0.3),
    "filled_diamond": ("D", True, 0.1),
    "triangle": ("^", False, 0.32),
}

DASHES = ("-", (0, (6, 3)), (0, (1.5, 2)), (0, (6, 2, 1.5, 2)))
LINE_WIDTHS = (1.2, 1.8, 2.2, 1.6)

RPM = 2 * np.pi / 60


def draw_map(
    table: Table,
    motion: str | None,
    x: str | None,
    y: str | None,
    where: Mapping[str, float] | None,
    limits: bool,
    ax: Axes | None,
) -> Axes:
    """The map of a table: see `Table.plot`."""
    motion = _labelled_motion(table, motion)
    title = _motion_title(motion)
    x, y = _map_axes(table, x, y)
    kept = _cut(table, [x, y], where or {})
    rows = {name: column[kept] for name, column in table.items()}
    ax = _axes(ax)
    if y is None:
        _draw_rows(ax, rows, motion, x, table)
    elif y not in table.about.axes:
        _draw_measure(ax, rows, motion, x, y, table)
    else:
        _draw_cases(ax, rows, motion, x, y, table)
        _label(ax.set_ylabel, y, table)
    _label(ax.set_xlabel, x, table)
    for name, scale, column in [(x, ax.set_xscale, rows[x]), (y, ax.set_yscale, rows.get(y or ""))]:
        if name in table.about.log_axes and column is not None and np.min(column) > 0:
            scale("log")
    if limits and y is not None:
        view = ax.get_xlim(), ax.get_ylim()
        _draw_limits(ax, table, motion, (x, y), rows)
        ax.set(xlim=view[0], ylim=view[1])
    several = sum(_has_labels(table, other) for other in MOTIONS) > 1
    ax.set_title(f"{table.about.title}: {title.lower()}" if several else table.about.title)
    if ax.get_legend_handles_labels()[0]:
        ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False, fontsize="small")
    return ax


def draw_history(simulation: Simulation, axes: Sequence[Axes] | None) -> list[Axes]:
    """The motion of a case over time: see `Simulation.plot`."""
    motion = simulation.motion
    if motion is None:
        raise DrillstringError(f"the case has no answer: {simulation.failure}")
    panels = _panels(motion)
    if axes is None:
        figure, grid = _pyplot().subplots(
            len(panels),
            1,
            sharex=True,
            squeeze=False,
            layout="constrained",
            figsize=(7, 1 + 1.8 * len(panels)),
        )
        axes = list(grid[:, 0])
    if len(axes) != len(panels):
        raise DrillstringError(f"{len(axes)} axes for {len(panels)} panels")
    method = str(simulation.row["method"])
    for ax, (label, values) in zip(axes, panels):
        ax.plot(motion.time, values, color=_method_colour(method), lw=1.2, label=method)
        ax.set_ylabel(label)
    axes[-1].set_xlabel("Time t (s)")
    axes[0].legend(loc="upper right", frameon=False, fontsize="small")
    return list(axes)


def _panels(motion: Motion) -> list[tuple[str, NDArray[np.float64]]]:
    # As `sweep simulate` has them: the radius at every site of a string that moves sideways, else
    # speeds from the bit up and the torque on it; how a bit cuts; what the surface does where that
    # is followed.
    panels: list[tuple[str, NDArray[np.float64]]] = []
    positions, sites = motion.positions, list(enumerate(motion.sites))
    if positions is not None:
        for site, distance in sites:
            radius = 1e3 * np.hypot(positions[site, :, 0], positions[site, :, 1])
            panels.append((f"Radius at {_site_title(distance, 'si')} (mm)", radius))
    else:
        for site, distance in reversed(sites):
            place = "Bit speed" if distance == 0 else f"Speed {_site_title(distance, 'si')}"
            panels.append((f"{place} (rpm)", motion.speeds[site] / RPM))
        if motion.bit_torque is not None:
            panels.append(("Torque on bit (kN m)", -1e-3 * motion.bit_torque))
    for label, in_unit, values in (
        ("Weight on bit (kN)", 1e-3, motion.weight_on_bit),
        ("Depth of cut (mm)", 1e3, motion.depth_of_cut),
        ("Depth of the bit (mm)", 1e3, motion.bit_depth),
    ):
        if values is not None:
            panels.append((label, in_unit * values))
    if motion.surface_torque is not None:
        panels.append(("Torque at surface (kN m)", 1e-3 * motion.surface_torque))
    if positions is None and motion.surface_speed is not None:
        panels.append(("Surface speed (rpm)", motion.surface_speed / RPM))
    return panels


def _pyplot() -> Any:
    try:
        import matplotlib.pyplot
    except ImportError:
        raise ImportError("plot needs matplotlib: pip install matplotlib") from None
    return matplotlib.pyplot


def _axes(ax: Axes | None) -> Axes:
    if ax is not None:
        return ax
    made: Axes = _pyplot().subplots(figsize=(9.5, 5), layout="constrained")[1]
    return made


def _has_labels(table: Mapping[str, NDArray[Any]], motion: str) -> bool:
    return any(label is not None for label in table.get(motion, ()))


def _labelled_motion(table: Table, asked: str | None) -> str:
    # The one asked for, or the first that cases are labelled by.
    with_labels = [motion for motion in MOTIONS if _has_labels(table, motion)]
    if not with_labels:
        raise DrillstringError("no case has a label")
    if asked in MOTIONS and asked not in with_labels:
        raise DrillstringError(
            f"no case has a label for {asked!r}: there are labels for {with_labels[0]!r} alone"
        )
    return asked or with_labels[0]


def _map_axes(table: Table, x: str | None, y: str | None) -> tuple[str, str | None]:
    about = table.about
    if not about.axes:
        raise DrillstringError("the cases do not differ: `Sweep.simulate(0).plot()` draws one")
    for name in (x, y):
        if name is not None and column_of(table, name).dtype == object:
            raise DrillstringError(f"{name!r} has no numbers")
    of_map = about.map_axes or about.axes[:2]
    if x is None:
        x = next(name for name in of_map if name != y)
    if y is None:
        y = next((name for name in (*reversed(of_map), *about.axes) if name != x), None)
    return x, y


def _cut(
    table: Table, shown: Sequence[str | None], where: Mapping[str, float]
) -> NDArray[np.bool_]:
    # The rows on a map; of a grid, those at one value of each axis that is not on it.
    about, kept = table.about, np.ones(table.rows, dtype=bool)
    needs_cut = about.design == "grid" and all(name in about.axes for name in shown)
    for name in [*where, *(name for name in about.axes if name not in where)]:
        column = column_of(table, name)
        values = np.unique(column)
        listed = ", ".join(f"{value:.6g}" for value in values[:12])
        listed += ", …" if len(values) > 12 else ""
        if name in where:
            at = np.isclose(column, where[name], rtol=1e-9, atol=0.0)
            if not at.any():
                raise DrillstringError(f"no case has {name} = {where[name]}: there are {listed}")
            kept &= at
        elif name not in shown and needs_cut and len(values) > 1:
            raise DrillstringError(
                f"the grid has a further axis: choose where={{{name!r}: …}} of {listed}"
            )
    if not kept.any():
        raise DrillstringError("no case has all of these values")
    return kept


def _shown(name: str, table: Table) -> float:
    factor: float = _column_words(name, table.about.units)[2]
    return factor


def _label(put: Any, name: str, table: Table) -> None:
    words, unit, _ = _column_words(name, table.about.units)
    put(f"{words} ({unit})" if unit else words)


def _symbols_at(
    rows: Mapping[str, NDArray[Any]], motion: str, cases: NDArray[Any]
) -> list[tuple[int, str | None]]:
    certified = rows.get(f"{motion}_certified")
    return _symbols_of_cases(
        motion,
        cases.tolist(),
        column_of(rows, motion).tolist(),
        None if certified is None else certified.tolist(),
    )


def _draw_symbols(
    ax: Axes,
    places: NDArray[np.float64],
    symbols: Sequence[str | None],
    meanings: Sequence[tuple[str, str, str]],
) -> None:
    # As large as their mean distance allows, within legible limits (points).
    size = ax.get_window_extent()
    scale = 72.0 / ax.figure.dpi
    distance = scale * np.sqrt(size.width * size.height / max(len(symbols), 1))
    radius = float(np.clip(0.28 * distance, 1.5, 4.0))
    of_each = np.array([symbol or "" for symbol in symbols])
    for name, colour, meaning in meanings:
        at = of_each == name
        if not at.any():
            continue
        marker, filled, line = MARKERS[name]
        face: Any = {"color": colour} if filled else {"facecolors": "none", "edgecolors": colour}
        ax.scatter(
            places[at, 0],
            places[at, 1],
            s=(2 * radius) ** 2,
            marker=marker,
            linewidths=max(line * radius, 0.7),
            label=meaning,
            zorder=3,
            **face,
        )
    missing = int(np.count_nonzero(of_each == ""))
    if missing:
        words = f"not shown: {missing} of {len(symbols)}, undetermined"
        ax.plot([], [], " ", label=words)


def _draw_cases(
    ax: Axes, rows: Mapping[str, NDArray[Any]], motion: str, x: str, y: str, table: Table
) -> None:
    methods = table.about.methods
    found = _symbols_at(rows, motion, rows["case"])
    first = np.array([row for row, _ in found])
    places = np.column_stack([_shown(name, table) * rows[name][first] for name in (x, y)])
    meanings = _symbols(motion, len(methods), f"{motion}_certified" in rows)
    on_map = {symbol for _, symbol in found}
    named = [
        (name, colour, meaning + (f" ({', '.join(methods)})" if index == 0 else ""))
        for index, (name, colour, meaning) in enumerate(
            meaning for meaning in meanings if meaning[0] in on_map
        )
    ]
    _draw_symbols(ax, places, [symbol for _, symbol in found], named)


def _draw_rows(
    ax: Axes, rows: Mapping[str, NDArray[Any]], motion: str, x: str, table: Table
) -> None:
    # Over one axis: a row of symbols for each method.
    methods = list(table.about.methods)
    upwards = np.array([methods.index(method) for method in rows["method"]], dtype=float)
    _draw_each(ax, rows, motion, np.column_stack([_shown(x, table) * rows[x], upwards]))
    ax.set_yticks(range(len(methods)), methods)
    ax.set_ylim(len(methods) - 0.5, -0.5)


def _draw_measure(
    ax: Axes, rows: Mapping[str, NDArray[Any]], motion: str, x: str, y: str, table: Table
) -> None:
    # A measure over an axis, with the regime of each row.
    places = np.column_stack([_shown(name, table) * rows[name] for name in (x, y)])
    for method in table.about.methods:
        of_method = places[rows["method"] == method]
        if len(table.about.axes) == 1:
            sorted_places = of_method[np.argsort(of_method[:, 0], kind="stable")]
            ax.plot(*sorted_places.T, color=_method_colour(method), lw=1.0, label=method, zorder=2)
    _draw_each(ax, rows, motion, places)
    _label(ax.set_ylabel, y, table)


def _draw_each(
    ax: Axes, rows: Mapping[str, NDArray[Any]], motion: str, places: NDArray[np.float64]
) -> None:
    found = _symbols_at(rows, motion, np.arange(len(places)))
    meanings = _symbols(motion, 1, f"{motion}_certified" in rows)
    _draw_symbols(ax, places, [symbol for _, symbol in found], meanings)


def _draw_limits(
    ax: Axes,
    table: Table,
    motion: str,
    shown: tuple[str, str],
    rows: Mapping[str, NDArray[Any]],
) -> None:
    drawn = 0
    speed = table.about.surface_speed_rpm
    held = {**({} if speed is None else {"surface_speed_rpm": np.array([speed])}), **rows}
    for curve in table.curves():
        points = _on_map(curve, shown, held) if curve.motion == motion else None
        if points is None:
            continue
        scaled = points * [_shown(name, table) for name in shown]
        style: Any = {"ls": DASHES[drawn % 4], "lw": LINE_WIDTHS[drawn % 4]}
        ax.plot(*scaled.T, color=curve.colour or "black", label=curve.name, zorder=4, **style)
        drawn += 1


def _on_map(
    curve: Curve, shown: tuple[str, str], rows: Mapping[str, NDArray[Any]]
) -> NDArray[np.float64] | None:
    # Points to the right and upwards, with gaps between pieces; across the map where what the limit
    # depends on has one value. None where the map has not its axes.
    gap = np.full((1, 2), np.nan)
    pieces = [np.array(piece, dtype=float).reshape(-1, 2) for piece in curve.pieces]
    if {curve.along, curve.limited} == set(shown):
        order = [0, 1] if curve.along == shown[0] else [1, 0]
        joined = [part for piece in pieces for part in (piece[:, order], gap)]
        return np.concatenate(joined) if joined else None
    if curve.limited not in shown or curve.along in shown or curve.along not in rows:
        return None
    values = np.unique(rows[curve.along])
    if len(values) != 1:
        return None
    within = [piece for piece in pieces if piece[:, 0].min() <= values[0] <= piece[:, 0].max()]
    if not within:
        return None
    place = shown.index(curve.limited)
    across = np.array([rows[shown[1 - place]].min(), rows[shown[1 - place]].max()])
    parts = []
    for piece in within:
        points = np.empty((2, 2))
        ascending = np.argsort(piece[:, 0], kind="stable")
        points[:, place] = np.interp(values[0], *piece[ascending].T)
        points[:, 1 - place] = across
        parts += [points, gap]
    return np.concatenate(parts)
