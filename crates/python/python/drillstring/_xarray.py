"""Tables of grids as datasets of xarray."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._drillstring import DrillstringError, _column_words

if TYPE_CHECKING:
    import xarray

    from ._table import Table

# How cases lie where not on a grid.
SCATTERED = {
    "list": "lie where its file says",
    "monte-carlo": "are drawn at random",
    "sensitivity": "are drawn at random",
    "trace": "lie along its limits",
}


def dataset(table: Table) -> xarray.Dataset:
    """The columns of a table over the axes of its design and ``method``."""
    try:
        import xarray
    except ImportError:
        raise ImportError("to_xarray needs xarray: pip install xarray") from None
    about = table.about
    if about.design != "grid":
        why = SCATTERED.get(str(about.design), "are on no grid")
        raise DrillstringError(
            f"cases of the design {about.design!r} {why}: xarray has arrays over grids; "
            "pandas.DataFrame(table) takes any design"
        )
    if table.rows != about.cases * len(about.methods):
        raise DrillstringError(
            f"{table.rows // len(about.methods)} of the {about.cases} cases of the grid are here: "
            "merge its shards or finish its run first"
        )
    coordinates: dict[str, Any] = {}
    places = []
    for name in about.axes:
        values, place = np.unique(table[name], return_inverse=True)
        coordinates[name] = (name, values, _attributes(name))
        places.append(place.reshape(-1))
    methods = list(about.methods)
    coordinates["method"] = methods
    places.append(np.array([methods.index(method) for method in table["method"]]))
    sizes = [len(coordinates[name][1]) for name in about.axes] + [len(methods)]
    # Rows are sorted by case, and the last axis changes fastest; this holds for any order.
    order = np.ravel_multi_index(tuple(places), sizes)
    if int(np.prod(sizes)) != table.rows or len(np.unique(order)) != table.rows:
        raise DrillstringError("two cases of the grid have the same values")
    dimensions = [*about.axes, "method"]
    variables = {}
    for name, column in table.items():
        if name in dimensions:
            continue
        values = _plain(column)
        array = np.empty_like(values)
        array[order] = values
        variables[name] = (dimensions, array.reshape(sizes), _attributes(name))
    return xarray.Dataset(variables, coordinates, {"title": about.title})


def _attributes(name: str) -> dict[str, str]:
    words, unit, _ = _column_words(name, "si")
    return {"long_name": words, **({"units": unit} if unit else {})}


def _plain(column: NDArray[Any]) -> NDArray[Any]:
    # Words of any length, missing ones empty, as files of xarray hold them; flags that a row lacks
    # are not a number.
    if column.dtype != object:
        return column
    if all(value is None or isinstance(value, bool) for value in column):
        if all(value is None for value in column):
            return np.full(len(column), "")
        return np.array([np.nan if value is None else float(value) for value in column])
    return np.array(["" if value is None else value for value in column])
