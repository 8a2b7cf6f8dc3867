#!/usr/bin/env bash
# Builds the wheel of the Python package into dist/. Needs Python 3.10 or later with venv
# and pip; maturin goes into a separate venv below target/. What the workspace has built
# with --release is used again.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR="$PWD/${CARGO_TARGET_DIR:-target}"

venv=target/python-env
[[ -x $venv/bin/python ]] || python3 -m venv "$venv"
[[ -x $venv/bin/maturin ]] || "$venv/bin/pip" install --quiet 'maturin>=1.9,<2'
"$venv/bin/maturin" build --release --locked --out dist \
    --manifest-path crates/python/Cargo.toml --interpreter "$venv/bin/python" "$@"
