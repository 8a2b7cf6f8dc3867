"""What the tests share: the repository, and the command that the package is held against."""

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session", autouse=True)
def at_root():
    """Sweep files are named from the root of the repository."""
    os.chdir(ROOT)


@pytest.fixture(scope="session")
def command():
    """Runs the command `sweep`, built with --release beforehand."""
    program = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "sweep"
    if not program.exists():
        pytest.fail(f"{program} is not there: cargo build --release")

    def run(*arguments, code=0):
        done = subprocess.run(
            [program, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT
        )
        assert done.returncode == code, done.stderr
        return done

    return run
