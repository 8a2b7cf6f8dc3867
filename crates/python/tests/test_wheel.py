"""The wheel that is installed: where it runs, and what is in it."""

import importlib.metadata
import json
import os
import platform
import re
import subprocess
import sys
import tarfile

import pytest

import drillstring as ds
import drillstring._drillstring as engine
from conftest import ROOT

INSTALLED = importlib.metadata.distribution("drillstring")
ON_GLIBC = sys.platform == "linux" and platform.libc_ver()[0] == "glibc"


@pytest.mark.skipif(not ON_GLIBC, reason="of wheels for Linux with glibc")
def test_val_the_wheel_runs_with_glibc_2_28():
    tags = re.findall(r"^Tag: (.+)$", INSTALLED.read_text("WHEEL"), re.MULTILINE)
    assert len(tags) == 1
    assert tags[0].startswith("cp310-abi3-manylinux_2_28_"), tags
    # As the loader of the machine would look for them.
    with open(engine.__file__, "rb") as file:
        versions = re.findall(rb"\0GLIBC_(\d+)\.(\d+)(?=[.\0])", file.read())
    assert versions
    assert max(tuple(map(int, version)) for version in versions) <= (2, 28)


def test_the_version_is_that_of_the_package():
    assert ds.__version__ == INSTALLED.version
    assert f'version = "{ds.__version__}"' in (ROOT / "crates/python/Cargo.toml").read_text()


def test_licences_of_all_that_is_built_in_are_inside():
    within = re.compile(r"drillstring-.*\.dist-info/licenses/licences/(.+)")
    found = {match[1] for path in INSTALLED.files if (match := within.match(str(path)))}
    own = {"LICENSE-MIT", "LICENSE-APACHE", "LICENSE-JOE-KUO"}
    assert own <= found
    dependencies = {name.split("/")[1] for name in found - own}
    # Of the packages that it is locked to; procedural macros and what only builds are in no binary.
    lock = (ROOT / "crates/python/Cargo.lock").read_text()
    packages = re.findall(r'name = "(.+)"\nversion = "(.+)"\nsource', lock)
    locked = {f"{name}-{version}": name for name, version in packages}
    assert dependencies <= set(locked)
    names = {locked[package] for package in dependencies}
    assert {"faer", "libm", "numpy", "pyo3", "rayon", "realfft", "serde", "toml"} <= names
    assert len(names) > 100


def test_the_metadata_is_that_of_a_package_one_can_publish():
    metadata = INSTALLED.metadata
    assert metadata["License-Expression"] == "MIT OR Apache-2.0"
    assert metadata["Requires-Python"] == ">=3.10"
    assert "stick-slip" in metadata["Keywords"]
    assert metadata["Description-Content-Type"].startswith("text/markdown")
    checked = subprocess.run(
        [sys.executable, "-m", "twine", "check", "--strict", *(ROOT / "dist").glob("*.whl")],
        capture_output=True,
        text=True,
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_the_source_distribution_has_every_crate_that_it_is_built_from(tmp_path):
    """To build it takes minutes: that Cargo finds all of it is the part that can break."""
    maturin = [os.path.join(os.path.dirname(sys.executable), "maturin"), "sdist"]
    manifest = ROOT / "crates/python/Cargo.toml"
    made = subprocess.run(
        [*maturin, "--manifest-path", manifest, "--out", tmp_path], capture_output=True, text=True
    )
    assert made.returncode == 0, made.stderr
    (archive,) = tmp_path.glob("drillstring-*.tar.gz")
    with tarfile.open(archive) as file:
        file.extractall(tmp_path, filter="data")
    unpacked = tmp_path / archive.name.removesuffix(".tar.gz")
    assert list(unpacked.glob("**/LICENSE-JOE-KUO"))
    described = subprocess.run(
        ["cargo", "metadata", "--locked", "--offline", "--format-version", "1"],
        cwd=unpacked / "python",
        capture_output=True,
        text=True,
    )
    assert described.returncode == 0, described.stderr
    own = [it for it in json.loads(described.stdout)["packages"] if it["source"] is None]
    needed = {f"drillstring-{crate}" for crate in ["linear", "sim", "campaign", "results"]}
    assert needed <= {it["name"] for it in own}
    assert all(it["manifest_path"].startswith(str(unpacked)) for it in own)
