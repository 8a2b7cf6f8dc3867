#!/usr/bin/env bash
# Makes the engine of the pages that `sweep report` and `sweep explore` write anew, where a
# change of the crates linear, sim, campaign or page is to reach them:
# crates/sweep/src/page/engine.wasm.gz. It is kept in the repository, so that the program is
# built without this.
set -euo pipefail
cd "$(dirname "$0")/.."

target=wasm32-unknown-unknown
rustup target list --installed | grep -qx "$target" || rustup target add "$target"

# `simd128` is in every browser of the last years; it is what a page's speed needs.
RUSTFLAGS="-C target-feature=+simd128" \
    cargo build --locked --profile page -p page --target "$target" "$@"

made=target/$target/page/page.wasm
small=$(mktemp)
trap 'rm -f "$small"' EXIT
cp "$made" "$small"
if command -v wasm-opt >/dev/null; then
    wasm-opt -O3 --enable-simd --enable-bulk-memory "$made" -o "$small"
fi
# No name and no time in it: the same engine is the same bytes.
gzip --best --no-name <"$small" >crates/sweep/src/page/engine.wasm.gz
printf 'crates/sweep/src/page/engine.wasm.gz: %s bytes, %s unpacked\n' \
    "$(stat -c %s crates/sweep/src/page/engine.wasm.gz)" "$(stat -c %s "$small")"
