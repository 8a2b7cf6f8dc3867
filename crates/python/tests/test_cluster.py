"""The recipe for Dask in docs/cluster.md, as it is there, with Dask where that is installed."""

import re
import sys
import types

import pandas
import pytest

import drillstring
from conftest import ROOT

PAGE = (ROOT / "docs" / "cluster.md").read_text()


class InOrder:
    """Does at once what Dask's client does elsewhere."""

    def map(self, function, values):
        return [function(value) for value in values]

    def gather(self, results):
        return results


@pytest.fixture
def dask(monkeypatch):
    try:
        import dask.distributed
    except ImportError:
        package, module = types.ModuleType("dask"), types.ModuleType("dask.distributed")
        package.distributed, module.Client = module, InOrder
        monkeypatch.setitem(sys.modules, "dask", package)
        monkeypatch.setitem(sys.modules, "dask.distributed", module)
    else:
        # In threads, whose functions need no file to be found in.
        client = dask.distributed.Client
        monkeypatch.setattr(dask.distributed, "Client", lambda: client(processes=False))


def test_parts_by_dask_are_the_rows_of_one_sweep(dask):
    (code,) = re.findall(r"```python\n(import dask.*?)```", PAGE, re.DOTALL)
    # Of a quarter of the cases.
    code = code.replace('"count": 10', '"count": 3')
    names = {"__name__": "__main__"}
    exec(code, names)
    frame = names["frame"]
    axes = {
        "impulse_ratio": {"from": 1, "to": 10, "count": 3},
        "friction": {"values": names["frictions"]},
    }
    sweep = {"base": "fig14.toml", "design": {"kind": "grid", "axes": axes}}
    whole = pandas.DataFrame(drillstring.Sweep.from_dict(sweep, folder="sweeps").run())
    by = ["friction", "impulse_ratio", "method"]
    one, other = (table.sort_values(by, ignore_index=True) for table in (frame, whole))
    # By its number a case that has settled is followed to its end all the same.
    by_number = ["case", "predicted", "ended", "simulated_s"]
    pandas.testing.assert_frame_equal(
        one.drop(columns=by_number), other.drop(columns=by_number), rtol=1e-4
    )
    assert one["lateral"].equals(other["lateral"])
