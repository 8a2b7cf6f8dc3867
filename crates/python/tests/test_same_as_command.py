"""What the package answers is what the command writes, bit for bit: it writes the shortest
text that gives a number back exactly."""

import csv
import json
import math
import os
import time

import numpy as np
import pytest

import drillstring as ds

RPM = math.tau / 60


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def same(value, text):
    """Whether a value is what a field of a table says."""
    if text == "":
        return value is None or (isinstance(value, float) and math.isnan(value))
    if isinstance(value, (bool, np.bool_)):
        return text == str(value).lower()
    if isinstance(value, str):
        return value == text
    return float(value) == float(text)


def assert_same_table(table, path):
    rows = read(path)
    assert list(table) == list(rows[0])
    assert table.rows == len(rows)
    for name, column in table.items():
        for index, row in enumerate(rows):
            assert same(column[index], row[name]), (name, index, column[index], row[name])


WALL = """
base = "fig12.toml"
methods = ["quadrature", "held"]
time_s = 4

[design]
kind = "grid"

[design.axes]
friction = { values = [0.1, 2.0] }
impulse_ratio = { values = [0.5, 3] }
"""

STRINGS = """
base = "academic.toml"
bit = { rock = "sandstone" }
certify = true
methods = ["held", "finite-element"]

[design]
kind = "monte-carlo"
cases = 6
seed = 3

[design.axes]
torsional_damping_nms_rad_m = { from = 5, to = 20 }
surface_speed_rpm = { from = 0.1, to = 0.4 }
weight_on_bit_kn = { from = 20, to = 80 }
"""

TRACE = """
base = "academic.toml"
bit = { rock = "sandstone" }
methods = ["held"]

[design]
kind = "trace"

[design.axes]
surface_speed_rpm = { from = 0.02, to = 0.6, count = 9 }
weight_on_bit_kn = { from = 5, to = 100, count = 9 }
"""


def test_fig_9_is_that_of_the_command(command, tmp_path):
    command("run", "sweeps/fig09.toml", "--out", tmp_path, "--quiet")
    table = ds.Sweep.read("sweeps/fig09.toml").run()
    assert_same_table(table, tmp_path / "labels.csv")
    assert set(table["torsion"]) == {"stick_slip", "smooth"}


@pytest.mark.parametrize("text", [WALL, STRINGS, TRACE], ids=["wall", "strings", "trace"])
def test_a_sweep_from_a_text_is_that_of_a_file(command, tmp_path, text):
    text = text.replace('base = "', 'base = "sweeps/')
    sweep = ds.Sweep.from_toml(text, name="own")
    table = sweep.run(threads=2)
    file = tmp_path / "own.toml"
    file.write_text(text.replace('base = "', f'base = "{os.getcwd()}/'))
    command("run", file, "--out", tmp_path / "out", "--quiet")
    assert_same_table(table, tmp_path / "out" / "labels.csv")


def test_as_many_threads_run_as_slurm_allots(monkeypatch):
    sweep = ds.Sweep.read("sweeps/fig17.toml", methods=["held"])

    class Seen(Exception):
        pass

    def threads_of_a_run(allotted):
        monkeypatch.setenv("SLURM_CPUS_PER_TASK", allotted)

        def look(done, total):
            # Those of the run before have ended by then.
            if done > 20:
                raise Seen(len(os.listdir("/proc/self/task")))

        with pytest.raises(Seen) as seen:
            sweep.run(progress=look)
        time.sleep(0.5)
        return seen.value.args[0]

    assert threads_of_a_run("6") - threads_of_a_run("2") == 4


def test_impossible_values_of_slurm_are_ignored_with_a_warning(monkeypatch):
    monkeypatch.setenv("SLURM_CPUS_PER_TASK", "many")
    sweep = ds.Sweep.read("sweeps/fig09.toml", methods=["held"])
    with pytest.warns(ds.DrillstringWarning, match='SLURM_CPUS_PER_TASK="many" is ignored'):
        sweep.run()


@pytest.mark.parametrize("threads", [1, 3])
def test_threads_do_not_change_a_table(threads):
    sweep = ds.Sweep.read("sweeps/fig09.toml", methods=["held"])
    one, other = sweep.run(threads=threads), sweep.run(threads=2)
    for name in one:
        assert np.array_equal(one[name], other[name], equal_nan=one[name].dtype.kind == "f")


@pytest.mark.parametrize("figure", ["fig08b", "fig12"])
def test_a_history_is_that_of_the_command(command, tmp_path, figure):
    command("simulate", f"sweeps/{figure}.toml", "--out", tmp_path)
    sweep = ds.Sweep.read(f"sweeps/{figure}.toml")
    history, cases = read(tmp_path / "history.csv"), read(tmp_path / "case.csv")
    for method, case in zip(sweep.methods, cases, strict=True):
        simulation = sweep.simulate(method=method)
        assert all(same(simulation.row[name], text) for name, text in case.items())
        motion = simulation.motion
        rows = [row for row in history if row["method"] == method]
        assert len(rows) == len(motion)
        name = "bit" if figure == "fig08b" else next(
            key for key in rows[0] if key.endswith("_speed_rpm")
        ).removesuffix("_speed_rpm")
        column = lambda key: np.array([float(row[key]) for row in rows])
        assert np.array_equal(motion.time, column("time_s"))
        assert np.array_equal(motion.speeds[0] / RPM, column(f"{name}_speed_rpm"))
        if figure == "fig08b":
            assert np.array_equal(-motion.bit_torque, column("torque_on_bit_nm"))
        else:
            assert np.array_equal(1e3 * motion.positions[0, :, 0], column(f"{name}_x_mm"))
            assert np.array_equal(motion.wall_forces[0, :, 1], column(f"{name}_wall_force_y_n"))
            assert motion.touches.any() and motion.rolls.any()


def test_what_is_set_is_set_as_by_the_command(command, tmp_path):
    arguments = ["--case", 3, "--set", "surface_speed_rpm=0.3", "--methods", "held"]
    command("simulate", "sweeps/fig09.toml", *arguments, "--out", tmp_path)
    sweep = ds.Sweep.read("sweeps/fig09.toml", methods=["held"])
    row = sweep.simulate(3, set={"surface_speed_rpm": 0.3}).row
    (case,) = read(tmp_path / "case.csv")
    assert list(row) == list(case)
    assert all(same(row[name], text) for name, text in case.items())


def test_an_accuracy_is_chosen_as_by_the_command(command, tmp_path):
    command("run", "sweeps/fig09_accuracy.toml", "--out", tmp_path, "--quiet")
    sweep = ds.Sweep.read("sweeps/fig09_accuracy.toml")
    assert_same_table(sweep.run(), tmp_path / "labels.csv")


def assert_same_columns(columns, path):
    rows = read(path)
    assert rows
    assert list(columns) == list(rows[0])
    for name, column in columns.items():
        assert len(column) == len(rows), name
        for value, row in zip(column, rows):
            assert same(value, row[name]), (name, value, row[name])


SENSITIVITY = """
base = "academic.toml"
bit = { rock = "sandstone" }
methods = ["held"]

[design]
kind = "sensitivity"
cases = 24
seed = 5

[design.axes]
surface_speed_rpm = { from = 0.02, to = 0.6 }
weight_on_bit_kn = { from = 20, to = 80 }
"""

GRID = """
base = "academic.toml"
bit = { rock = "sandstone" }
methods = ["held", "quadrature"]

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 0.02, to = 0.6, count = 6 }
weight_on_bit_kn = { from = 20, to = 80, count = 6 }
"""


def written(tmp_path, text):
    """A separate sweep file."""
    file = tmp_path / "own.toml"
    file.write_text(text.replace('base = "', f'base = "{os.getcwd()}/sweeps/'))
    return file


def test_an_analysis_is_that_of_the_command(command, tmp_path):
    file, out = written(tmp_path, SENSITIVITY), tmp_path / "out"
    command("run", file, "--out", out, "--quiet")
    by = ["--by", "surface_speed_rpm,weight_on_bit_kn", "--bins", 3]
    tables = ["--out", tmp_path / "counts.csv", "--indices", tmp_path / "indices.csv"]
    command("analyse", out, *by, *tables)
    found = ds.analyse(out, by=[("surface_speed_rpm", "weight_on_bit_kn")], bins=3)
    assert_same_columns(found.counts, tmp_path / "counts.csv")
    assert_same_columns(found.indices, tmp_path / "indices.csv")
    with pytest.raises(ds.DrillstringError, match="do not differ in friction; they do in"):
        ds.analyse(out, by=["friction"])
    with pytest.raises(ds.DrillstringError, match="hold the same cases"):
        ds.analyse([out, out])
    with pytest.raises(ds.DrillstringError, match="holds no results"):
        ds.analyse(tmp_path)


@pytest.mark.parametrize("text", [GRID, STRINGS], ids=["grid", "strings"])
def test_a_window_is_that_of_the_command(command, tmp_path, text):
    file, out = written(tmp_path, text), tmp_path / "out"
    command("run", file, "--out", out, "--quiet")
    options = ["--bins", 2, "--risk", 0.4, "--clearance", 0.02]
    said = command("window", file, out, *options).stdout
    window = ds.Sweep.read(file).window(out, bins=2, risk=0.4, clearance=0.02)
    assert_same_columns(window.cells, out / "window.csv")
    if text == GRID:
        speed = f"{window.best['surface_speed_rpm']:.3g} rpm"
        assert speed in said and window.best["standing"] == "safe"
    with pytest.raises(ds.DrillstringError, match="the string does not bend"):
        ds.Sweep.read(file).window(out, held_at=[0])


def test_whirl_limits_are_those_of_a_map_at_its_speeds():
    sweep = ds.Sweep.read("sweeps/fig14.toml")
    limits = sweep.limits()
    speeds = limits["surface_speed_rpm"]
    found = sweep.whirl_limits(speeds.min(), speeds.max())
    assert len(speeds) > 1 and list(found) == list(limits)
    for name, column in limits.items():
        assert list(map(str, found[name])) == list(map(str, column)), name
    assert len(ds.Sweep.read("sweeps/fig09.toml").whirl_limits(1, 2)["friction"]) == 0


@pytest.mark.parametrize("bit", [None, "pinned"])
def test_a_string_at_rest_is_that_of_the_command(command, tmp_path, bit):
    file, held = "sweeps/well_12in_low_side.toml", [] if bit is None else ["--bit", bit]
    options = ["--methods", "finite-element", "--json", "--out", tmp_path]
    said = json.loads(command("inspect", file, *held, *options).stdout)
    found = ds.Sweep.read(file).static_string(bit=bit)
    lying = said["lying"]
    # What is said of any string that lies.
    assert "no bound" in lying.pop("whirl_if_triggered")
    assert found.numbers == lying
    assert_same_columns(found.along, tmp_path / "static_string.csv")
    assert_same_columns(found.sites, tmp_path / "static_contacts.csv")
    with pytest.raises(ds.DrillstringError, match='"glued" is neither "contact", "pinned" nor'):
        ds.Sweep.read(file).static_string(bit="glued")
    assert ds.Sweep.read("sweeps/fig14.toml").static_string() is None


@pytest.mark.parametrize("name", ["fig09", "fig14"])
def test_limits_are_those_of_the_command(command, tmp_path, name):
    limits = ds.Sweep.read(f"sweeps/{name}.toml").limits()
    command("run", f"sweeps/{name}.toml", "--out", tmp_path, "--quiet")
    assert len(read(tmp_path / "boundary.csv")) > 1
    assert_same_columns(limits, tmp_path / "boundary.csv")
