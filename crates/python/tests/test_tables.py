"""Tables go to pandas and polars as they are, and sweeps to other processes."""

import copy
import pickle

import numpy as np
import pandas
import polars
import pytest

import drillstring as ds


@pytest.fixture(scope="module")
def sweep():
    return ds.Sweep.read("sweeps/fig09.toml", methods=["held", "quadrature"])


@pytest.fixture(scope="module")
def table(sweep):
    return sweep.run()


def test_a_table_goes_to_pandas_and_polars_and_back(table):
    one, other = pandas.DataFrame(table), polars.DataFrame(table)
    assert list(one.columns) == list(other.columns) == list(table)
    assert len(one) == len(other) == table.rows == 1000
    for name, column in table.items():
        there = other[name].to_numpy()
        if column.dtype.kind == "f":
            assert np.array_equal(one[name].to_numpy(), column, equal_nan=True), name
            assert np.array_equal(there, column, equal_nan=True), name
        else:
            missing = [value is None for value in column]
            assert list(one[name].isna()) == list(other[name].is_null()) == missing, name
            assert list(one[name].dropna()) == list(there[~np.array(missing)]), name
            assert list(one[name].dropna()) == [it for it in column if it is not None], name
    # There is no wall.
    assert one["lateral"].isna().all() and not one["torsion"].isna().any()
    assert table["case"].dtype == table["sticks"].dtype == np.int64


def test_a_table_is_in_the_order_of_cases_and_methods(sweep, table):
    assert list(table["case"][:4]) == [0, 0, 1, 1]
    assert list(table["method"][:2]) == sweep.methods == ["held", "quadrature"]
    values = sweep.values(7)
    assert {name: table[name][14] for name in sweep.axes} == values


def test_a_sweep_is_pickled_and_copied(sweep, tmp_path, monkeypatch):
    pickled = pickle.dumps(sweep)
    # Its files need not be there.
    monkeypatch.chdir(tmp_path)
    for made in [pickle.loads(pickled), copy.copy(sweep), copy.deepcopy(sweep)]:
        assert made.content == sweep.content
        assert made.values(3) == sweep.values(3)


def test_numbers_of_numpy_are_numbers_of_a_table():
    table = {"base": "sweeps/academic.toml", "surface_speed_rpm": np.float64(0.2)}
    table["bit"] = {"rock": "sandstone"}
    axes = {"weight_on_bit_kn": {"values": np.linspace(20, 80, 3)}}
    sweep = ds.Sweep.from_dict({**table, "design": {"kind": "grid", "axes": axes}})
    assert sweep.cases == 3
    assert sweep.values(1) == {"weight_on_bit_kn": 50}
