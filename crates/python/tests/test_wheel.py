"""The wheel that is installed: where it runs, and what is in it."""

import importlib.metadata
import platform
import re
import sys

import pytest

import drillstring._drillstring as engine

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
