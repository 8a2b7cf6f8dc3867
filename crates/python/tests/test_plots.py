"""Pictures by matplotlib: what is drawn, where and in which colours, as the command has it."""

import re

import matplotlib
import numpy as np
import pytest

import drillstring as ds

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import to_hex  # noqa: E402

from test_same_as_command import SENSITIVITY, read, written  # noqa: E402


@pytest.fixture(autouse=True)
def closed():
    yield
    plt.close("all")


def texts(svg):
    """What is written in a picture, lines of a text joined."""
    return " ".join(re.findall(r"<text[^>]*>([^<]*)</text>", svg))


@pytest.fixture(scope="module")
def sweep():
    return ds.Sweep.read("sweeps/fig09.toml")


@pytest.fixture(scope="module")
def table(sweep):
    return sweep.run()


def symbols(ax):
    """Number of symbols, and their colour, by the first words of their meaning."""
    drawn = {}
    for points in ax.collections:
        colour = to_hex(np.concatenate([points.get_edgecolor(), points.get_facecolor()])[0])
        drawn[points.get_label().split(" (")[0]] = (len(points.get_offsets()), colour.upper())
    return drawn


def test_val_a_map_has_the_symbols_colours_and_words_of_the_command(command, table, tmp_path):
    command("run", "sweeps/fig09.toml", "--out", tmp_path, "--quiet")
    svg = (tmp_path / "map.svg").read_text()
    ax = table.plot()
    methods = len(table.about.methods)
    sticking = (table["torsion"].reshape(-1, methods) == "stick_slip").sum(axis=1)
    expected = {
        "stick-slip by all methods": np.count_nonzero(sticking == methods),
        "smooth by all methods": np.count_nonzero(sticking == 0),
        "methods differ": np.count_nonzero((sticking > 0) & (sticking < methods)),
    }
    drawn = symbols(ax)
    assert {words: count for words, (count, _) in drawn.items()} == expected
    said = texts(svg)
    for words, (_, colour) in drawn.items():
        assert words in said and colour in svg
    for label in (ax.get_xlabel(), ax.get_ylabel(), ax.get_title()):
        assert label in said
    assert ax.get_xlabel() == "Weight on bit W (kN)"
    assert ax.get_ylabel() == "Surface speed Ω (rpm)"


def test_val_limits_of_a_map_are_those_of_boundary_csv(command, table, tmp_path):
    command("run", "sweeps/fig09.toml", "--out", tmp_path, "--quiet")
    rows = read(tmp_path / "boundary.csv")
    lines = {line.get_label(): line for line in table.plot().lines}
    assert set(lines) == {
        f"one-slip estimate (Eq. 74), {method}" for method in table.about.methods
    }
    for method in table.about.methods:
        x, y = lines[f"one-slip estimate (Eq. 74), {method}"].get_data()
        of_method = [row for row in rows if row["method"] == method]
        assert list(x[:-1]) == [float(row["weight_on_bit_kn"]) for row in of_method]
        assert list(y[:-1]) == [float(row["surface_speed_rpm"]) for row in of_method]
    assert not table.plot(limits=False).lines


def test_axes_are_swapped_and_drawn_on_those_of_the_caller(table):
    _, ax = plt.subplots()
    assert table.plot(x="surface_speed_rpm", ax=ax) is ax
    assert ax.get_xlabel().startswith("Surface speed")
    assert ax.get_ylabel().startswith("Weight on bit")


def test_a_measure_is_drawn_over_an_axis_with_the_regimes(table):
    ax = table.plot(x="weight_on_bit_kn", y="bit_speed_peak_rpm")
    assert ax.get_ylabel() == "Greatest bit speed (rpm)"
    assert sum(count for count, _ in symbols(ax).values()) == table.rows


ONE_AXIS = """
base = "academic.toml"
bit = { torque_dynamic_nm = 2000 }
methods = ["held", "quadrature"]
units = "field"

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 0.02, to = 0.6, count = 6 }
"""


def test_one_axis_has_a_row_of_symbols_for_each_method(tmp_path):
    ax = ds.Sweep.read(written(tmp_path, ONE_AXIS)).run().plot()
    assert [tick.get_text() for tick in ax.get_yticklabels()] == ["held", "quadrature"]
    assert set(symbols(ax)) == {"stick-slip", "smooth"}
    assert sum(count for count, _ in symbols(ax).values()) == 12


def test_random_cases_are_drawn_where_they_lie(tmp_path):
    table = ds.Sweep.read(written(tmp_path, SENSITIVITY)).run()
    assert sum(count for count, _ in symbols(table.plot()).values()) == table.rows


THREE_AXES = """
base = "academic.toml"
methods = ["held"]
units = "field"
bit = { rock = "sandstone" }

[design]
kind = "grid"

[design.axes]
torsional_damping_nms_rad_m = { values = [0.5, 1.0] }
surface_speed_rpm = { from = 0.02, to = 0.6, count = 4 }
weight_on_bit_kn = { from = 20, to = 80, count = 5 }
"""


def test_a_grid_of_three_axes_is_cut_in_units_of_the_file(tmp_path):
    table = ds.Sweep.read(written(tmp_path, THREE_AXES)).run()
    with pytest.raises(ds.DrillstringError, match=r"further axis: choose where=.* of 0\.5, 1"):
        table.plot()
    with pytest.raises(ds.DrillstringError, match=r"no case has .* = 0\.7: there are 0\.5, 1"):
        table.plot(where={"torsional_damping_nms_rad_m": 0.7})
    ax = table.plot(where={"torsional_damping_nms_rad_m": 0.5})
    assert sum(count for count, _ in symbols(ax).values()) == 20
    labels = ax.get_xlabel() + ax.get_ylabel()
    assert "(klbf)" in labels
    weights = ax.collections[0].get_offsets()[:, 0 if "(klbf)" in ax.get_xlabel() else 1]
    assert weights.max() <= 80 / 4.44 and len(ax.get_title()) > 3


def test_wrong_arguments_are_refused_in_words(table):
    with pytest.raises(ds.DrillstringError, match="is no column: there are case, method"):
        table.plot(y="period")
    with pytest.raises(ds.DrillstringError, match="motion \"sideways\": not torsion or lateral"):
        table.plot("sideways")
    with pytest.raises(ds.DrillstringError, match="`Sweep.simulate\\(0\\).plot\\(\\)` draws one"):
        ds.Sweep.read("sweeps/fig08b.toml").run().plot()


@pytest.mark.parametrize("name", ["fig08b", "fig12"])
def test_a_history_has_the_panels_of_the_command(command, tmp_path, name):
    command("simulate", f"sweeps/{name}.toml", "--out", tmp_path)
    (picture,) = [path for path in tmp_path.glob("history.svg")]
    said = texts(picture.read_text())
    sweep = ds.Sweep.read(f"sweeps/{name}.toml")
    axes = sweep.simulate().plot()
    again = sweep.simulate(method=sweep.methods[-1]).plot(axes=axes)
    assert again == axes
    assert len(axes[0].lines) == 2
    for ax in axes:
        assert ax.get_ylabel() in said
    assert axes[-1].get_xlabel() == "Time t (s)"


def test_a_motion_without_labels_is_refused(table):
    with pytest.raises(ds.DrillstringError, match="no case has a label for 'lateral': there are"):
        table.plot("lateral")
