"""Results folders: what is read from them equals what is in their files, and what a run answers."""

import json
import shutil

import numpy as np
import pandas
import pytest

import drillstring as ds
from test_same_as_command import SENSITIVITY, TRACE, WALL, assert_same_columns, written
from test_schema import SMALL


@pytest.fixture(scope="module")
def folder(command, tmp_path_factory):
    """Fig. 9 as the command has it."""
    out = tmp_path_factory.mktemp("fig09") / "out"
    command("run", "sweeps/fig09.toml", "--out", out, "--quiet")
    return out


@pytest.fixture(scope="module")
def results(folder):
    return ds.Results.read(folder)


def assert_same(one, other):
    assert list(one) == list(other)
    for name, column in one.items():
        assert column.dtype == other[name].dtype, name
        assert np.array_equal(column, other[name], equal_nan=column.dtype.kind == "f"), name


def test_a_folder_has_the_rows_that_a_run_gives_with_their_types(results, folder):
    table = ds.Sweep.read("sweeps/fig09.toml").run()
    assert_same(results.table, table)
    assert results.table.about == table.about
    assert results.table.curves() == table.curves()
    assert_same_columns(results.table, folder / "labels.csv")
    assert_same_columns(results.boundary, folder / "boundary.csv")
    assert len(results.failures["case"]) == 0
    assert results.so_far is None
    assert results.manifest["cases"] == 500
    assert results.manifest == json.loads((folder / "manifest.json").read_text())


@pytest.mark.parametrize("text", [WALL, TRACE, SENSITIVITY], ids=["wall", "trace", "sensitivity"])
def test_folders_of_other_designs_are_read(command, tmp_path, text):
    out = tmp_path / "out"
    command("run", written(tmp_path, text), "--out", out, "--quiet")
    table = ds.Results.read(out).table
    assert_same_columns(table, out / "labels.csv")
    assert_same(table, ds.Sweep.read(tmp_path / "own.toml").run())


def test_shards_and_what_is_merged_of_them_are_read(command, folder, tmp_path):
    shards = [tmp_path / f"shard-{shard}" for shard in range(2)]
    for shard, out in enumerate(shards):
        shard = ["--shard", f"{shard}/2", "--out", out, "--quiet"]
        command("run", "sweeps/fig09.toml", *shard)
    parts = [ds.Results.read(shard) for shard in shards]
    assert sum(part.table.rows for part in parts) == 1500
    assert parts[1].manifest["shard"]
    with pytest.raises(ds.DrillstringError, match="250 of the 500 cases of the grid are here: merge"):
        parts[0].table.to_xarray()
    command("merge", *shards, "--out", tmp_path / "merged")
    assert_same(ds.Results.read(tmp_path / "merged").table, ds.Results.read(folder).table)


def test_a_folder_of_an_earlier_version_is_read_with_a_warning(folder, tmp_path):
    old = tmp_path / "old"
    shutil.copytree(folder, old)
    (old / "records.jsonl.gz").unlink()
    manifest = json.loads((old / "manifest.json").read_text())
    del manifest["files"]
    (old / "manifest.json").write_text(json.dumps(manifest))
    earlier = "foretold"
    labels = (old / "labels.csv").read_text().replace(",predicted,", f",{earlier},", 1)
    (old / "labels.csv").write_text(labels)
    with pytest.warns(ds.DrillstringWarning, match="not verified"):
        table = ds.Results.read(old).table
    assert_same(table, ds.Results.read(folder).table)


def test_failures_are_read_with_their_reasons(command, tmp_path):
    # The last value makes no tube.
    axis = "section_0_part_0_inner_radius_m = { values = [0.05, 0.126] }"
    text = SMALL.replace("[design.axes]\n", f"[design.axes]\n{axis}\n")
    out = tmp_path / "out"
    command("run", written(tmp_path, text), "--out", out, "--quiet", code=3)
    results = ds.Results.read(out)
    assert_same_columns(results.failures, out / "failures.csv")
    assert list(results.failures["case"]) == list(range(6, 12))
    assert results.table["torsion"][6] is None and results.table["status"][6] == "failed"
    assert (results.table.to_xarray().status[1] == "failed").all()


def test_what_is_no_results_folder_is_refused(folder, tmp_path):
    with pytest.raises(ds.DrillstringError, match="is not a folder"):
        ds.Results.read(tmp_path / "nowhere")
    with pytest.raises(ds.DrillstringError, match="holds no results"):
        ds.Results.read(tmp_path)
    damaged = tmp_path / "damaged"
    shutil.copytree(folder, damaged)
    with open(damaged / "labels.csv", "a") as labels:
        labels.write("\n")
    with pytest.raises(ds.DrillstringError, match="labels.csv"):
        ds.Results.read(damaged)
    with pytest.raises(ds.DrillstringError, match="of memory, more than"):
        ds.Results.read(folder, memory="1000")


def test_a_grid_is_a_dataset_over_its_axes_with_units(results):
    dataset = results.table.to_xarray()
    assert dict(dataset.sizes) == {"surface_speed_rpm": 25, "weight_on_bit_kn": 20, "method": 3}
    assert dataset.attrs["title"] == results.table.about.title
    assert dataset.period_s.attrs == {"long_name": "Period of stick-slip", "units": "s"}
    assert dataset.surface_speed_rpm.attrs == {"long_name": "Surface speed Ω", "units": "rpm"}
    frame = pandas.DataFrame(results.table)
    back = dataset.to_dataframe().reset_index()
    keys = [*results.table.about.axes, "method"]
    one = frame.sort_values(keys, ignore_index=True)
    other = back.sort_values(keys, ignore_index=True)
    for name in ["case", "torsion", "period_s", "sticks"]:
        assert list(one[name].astype(str)) == list(other[name].astype(str)), name
    assert (dataset.lateral == "").all()


def test_other_designs_say_why_they_are_no_dataset():
    axes = {"surface_speed_rpm": {"from": 0.1, "to": 0.3}}
    design = {"kind": "monte-carlo", "cases": 4, "seed": 1, "axes": axes}
    base = {"base": "sweeps/academic.toml", "methods": ["held"]}
    base["bit"] = {"torque_dynamic_nm": 2000}
    sweep = ds.Sweep.from_dict({**base, "design": design})
    with pytest.raises(ds.DrillstringError, match="are drawn at random: xarray has arrays over"):
        sweep.run().to_xarray()
