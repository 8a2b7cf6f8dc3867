"""A bit that cuts what its blades leave: its sweeps, cases and windows, as the command has them."""

import matplotlib
import numpy as np
import pytest

import drillstring as ds
from conftest import ROOT
from test_same_as_command import assert_same_table, read, same, written

matplotlib.use("Agg")

CUTTING = (ROOT / "tests/support/cutting.toml").read_text()


@pytest.fixture
def file(tmp_path):
    return written(tmp_path, CUTTING)


def test_a_table_is_that_of_the_command(command, tmp_path, file):
    table = ds.Sweep.read(file).run()
    assert set(table["axial"]) == {"axial_chatter", "bit_bounce"}
    assert (table["rate_of_penetration_m_h"] > 0).all()
    command("run", file, "--out", tmp_path / "out", "--quiet")
    assert_same_table(table, tmp_path / "out" / "labels.csv")
    ax = table.plot("axial")
    assert ax.get_xlabel() and ax.get_ylabel()


def test_a_motion_is_that_of_the_command(command, tmp_path, file):
    command("simulate", file, "--case", 3, "--out", tmp_path / "one")
    simulation = ds.Sweep.read(file).simulate(case=3)
    history, (case,) = read(tmp_path / "one" / "history.csv"), read(tmp_path / "one" / "case.csv")
    assert all(same(simulation.row[name], text) for name, text in case.items())
    motion = simulation.motion
    for values, column in [
        (1e-3 * motion.weight_on_bit, "weight_on_bit_kn"),
        (1e3 * motion.depth_of_cut, "depth_of_cut_mm"),
        (1e3 * motion.bit_depth, "bit_depth_mm"),
        (1e3 * motion.rock_depth, "rock_depth_mm"),
        (3600 * motion.rate_of_penetration, "rate_of_penetration_m_h"),
        (motion.bit_angle / (2 * np.pi), "bit_turns"),
    ]:
        theirs = np.array([float(row[column]) for row in history])
        assert np.allclose(values, theirs, rtol=1e-14, atol=0), column
    labels = [ax.get_ylabel() for ax in simulation.plot()]
    for words in ["Weight on bit (kN)", "Depth of cut (mm)", "Depth of the bit (mm)"]:
        assert words in labels


def test_what_the_bit_feels_is_how_its_rate_changes(file):
    simulation = ds.Sweep.read(file).simulate(case=3)
    motion, row = simulation.motion, simulation.row
    accelerations = np.diff(motion.rate_of_penetration) / np.diff(motion.time) / 9.80665
    peak = row["axial_acceleration_step_peak_g"]
    assert np.isclose(np.abs(accelerations), peak, rtol=1e-9).any()
    assert 0 < row["axial_acceleration_step_rms_g"] < peak
    assert 0 < row["axial_acceleration_band_rms_g"] < row["axial_acceleration_band_peak_g"] < peak


def test_the_rock_is_left_as_deep_as_its_deepest_cut(file):
    motion = ds.Sweep.read(file).simulate(case=3).motion
    off_bottom = motion.depth_of_cut < 0
    assert off_bottom.any() and not off_bottom.all()
    assert np.array_equal(motion.rock_depth[~off_bottom], motion.bit_depth[~off_bottom])
    assert (motion.rock_depth[off_bottom] > motion.bit_depth[off_bottom]).all()


def test_a_bit_that_does_not_cut_has_no_depth_of_cut():
    motion = ds.Sweep.read("sweeps/fig09.toml").simulate().motion
    for name in [
        "weight_on_bit",
        "rate_of_penetration",
        "depth_of_cut",
        "bit_angle",
        "bit_depth",
        "rock_depth",
    ]:
        assert getattr(motion, name) is None


def test_the_best_point_of_a_window_drills_fastest(command, tmp_path, file):
    grid = CUTTING.replace("values = [10, 30]", "from = 5, to = 30, count = 6")
    file = written(tmp_path, grid)
    command("run", file, "--out", tmp_path / "out", "--quiet")
    sweep = ds.Sweep.read(file)
    nothing = sweep.window(tmp_path / "out")
    assert nothing.best is None
    cells, best = sweep.window(tmp_path / "out", accept_chatter=True)
    rates = cells["rate_of_penetration_m_h"]
    assert best["rate_of_penetration_m_h"] in rates
    assert best["rate_of_penetration_m_h"] <= rates[cells["standing"] == "safe"].max()


def test_a_wrong_key_is_named(tmp_path):
    wrong = CUTTING.replace("blades = 4", "blades = 40")
    with pytest.raises(ds.SweepFileError) as error:
        ds.Sweep.read(written(tmp_path, wrong))
    assert error.value.key == "bit.cutting.blades"
