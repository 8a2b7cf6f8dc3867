#!/usr/bin/env bash
# Builds the wheel of the Python package into dist/. Needs Python 3.10 or later with venv
# and pip; maturin goes into a separate venv below target/. What the workspace has built
# with --release is used again.
#
#   scripts/wheel.sh [OPTION OF MATURIN...]
#
# On Linux the wheel runs with glibc 2.28 (RHEL 8, Debian 10) and later: it is linked by Zig, which
# knows the symbols of every glibc, also in the venv. maturin refuses a wheel that needs a later one.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR="$PWD/${CARGO_TARGET_DIR:-target}"
glibc=2.28

venv=target/python-env
python=$venv/bin/python
[[ -x $python ]] || python3 -m venv "$venv"
# install MODULE REQUIREMENT: into the venv, by its own interpreter: scripts in it name the place
# where it was made, which may be another.
install() {
    "$python" -c "import $1" 2>/dev/null || "$python" -m pip install --quiet "$2"
}
install maturin 'maturin>=1.9,<2'

options=()
linking=()
host=$(rustc --print host-tuple)

# What pyproject.toml names as `license-files`.
licences=crates/python/licences
rm -rf "$licences"
mkdir -p "$licences"
cp LICENSE-* "$licences/"
scripts/licences.sh "$licences/dependencies" -p drillstring-python --target "$host"

if [[ $host == *-linux-gnu ]]; then
    install ziglang 'ziglang>=0.15,<0.18'
    # As `maturin build --zig` has it, of the last step alone: with that option all that is below
    # the package would be built again.
    zig=$("$python" -c 'import ziglang; print(ziglang.__path__[0])')/zig
    export CARGO_ZIGBUILD_ZIG_PATH=$zig ZIG_GLOBAL_CACHE_DIR=$CARGO_TARGET_DIR/zig-cache
    linker=$CARGO_TARGET_DIR/link-for-glibc-$glibc
    # Zig links its own unwinder in place of libgcc_s, which each Linux has: a thread that
    # Python ends by pthread_exit is unwound by libgcc_s and crashes in frames that ask the other.
    unwinder=$(cc -print-file-name=libgcc_s.so.1)
    printf '#!/bin/sh\nexec "%s" zig cc -- -g -target %s-linux-gnu.%s "$@" "%s"\n' \
        "$PWD/$venv/bin/maturin" "${host%%-*}" "$glibc" "$unwinder" >"$linker"
    chmod +x "$linker"
    options+=(--compatibility "manylinux_${glibc/./_}")
    linking+=(-- -C "linker=$linker")
fi
"$venv/bin/maturin" build --release --locked --out dist \
    --manifest-path crates/python/Cargo.toml --interpreter "$python" "${options[@]}" "$@" \
    "${linking[@]}"
