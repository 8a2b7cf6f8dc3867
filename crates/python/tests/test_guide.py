"""Every snippet of docs/python.md, one after another in one session, as a reader types them."""

import re
import shutil
import sys

import matplotlib
import pytest

import drillstring as ds
from conftest import ROOT

matplotlib.use("Agg")

PAGE = (ROOT / "docs/python.md").read_text()


def test_every_snippet_of_the_guide_runs(command, tmp_path, monkeypatch, capsys):
    shutil.copytree(ROOT / "sweeps", tmp_path / "sweeps")
    for name in ["fig09", "fig14"]:
        command("run", f"sweeps/{name}.toml", "--out", tmp_path / "results" / name, "--quiet")
    monkeypatch.chdir(tmp_path)
    snippets = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    assert len(snippets) == PAGE.count("```python") > 8
    session = {}
    for snippet in snippets:
        exec(compile(snippet, "docs/python.md", "exec"), session)
    assert (tmp_path / "my-map.png").stat().st_size > 10_000
    assert (tmp_path / "fig09.png").stat().st_size > 10_000
    assert set(session["table"]["torsion"]) == {"stick_slip", "smooth"}
    assert session["simulation"].row["torsion"] in {"stick_slip", "smooth"}
    assert len(session["axes"][0].lines) == 2
    assert session["outcome"].torsion in {"stuck", "smooth", "stick_slip"}
    assert session["own"].cases == 3


def test_a_new_sweep_is_that_of_the_command(command, tmp_path):
    command("new", tmp_path / "theirs.toml")
    ds.Sweep.new(tmp_path / "ours.toml")
    assert (tmp_path / "ours.toml").read_text() == (tmp_path / "theirs.toml").read_text()
    with pytest.raises(ds.DrillstringError, match="is there already: give another name, or force"):
        ds.Sweep.new(tmp_path / "ours.toml")
    assert ds.Sweep.new(tmp_path / "ours.toml", force=True).cases > 1


def test_what_is_not_installed_is_named(monkeypatch):
    table = ds.Sweep.read("sweeps/fig09.toml", methods=["quadrature"]).run()
    for module in ["xarray", "matplotlib.pyplot"]:
        monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match="to_xarray needs xarray: pip install xarray"):
        table.to_xarray()
    with pytest.raises(ImportError, match="plot needs matplotlib: pip install matplotlib"):
        table.plot()


@pytest.mark.parametrize("name", sorted(ds.__all__))
def test_every_public_name_has_its_documentation(name):
    assert getattr(ds, name).__doc__
