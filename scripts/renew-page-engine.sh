#!/usr/bin/env bash
# The engine of the pages that `sweep report` and `sweep explore` write,
# crates/sweep/src/page/engine.wasm.gz, with engine.txt, which says what it was made from. It is
# kept in the repository, so that the program is built without a WebAssembly target.
#
#   scripts/renew-page-engine.sh           makes it from the sources
#   scripts/renew-page-engine.sh --check   says whether it was made from the sources as they are;
#                                          in a release it must be, and is made again to prove it
#
# docs/explore.md says when it is renewed. A release is where CHANGELOG.md begins with a version,
# or a tag v* is.
set -euo pipefail
cd "$(dirname "$0")/.."

engine=crates/sweep/src/page/engine.wasm.gz
record=crates/sweep/src/page/engine.txt
target=wasm32-unknown-unknown

refuse() {
    printf 'renew-page-engine.sh: %s\n' "$*" >&2
    exit 1
}

# The crates in it, the versions of those below them, the profiles and how it is made.
digest_of_sources() {
    find Cargo.toml Cargo.lock scripts/renew-page-engine.sh \
        crates/{numerics,linear,sim,campaign,page}/{Cargo.toml,src} -type f -print0 |
        LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum | cut -d' ' -f1
}

recorded() { sed -n "s/^$1: //p" "$record"; }

is_release() {
    [[ $(grep -m1 '^## ' CHANGELOG.md) != '## Unreleased' ||
        -n $(git tag --points-at HEAD 'v*' 2>/dev/null) ]]
}

# Makes the engine; its place is then in `made`.
make_engine() {
    rustup target list --installed | grep -qx "$target" || rustup target add "$target"
    # `simd128` is in every browser of the last years; it is what a page's speed needs. Paths of
    # this machine would make it another engine on each.
    RUSTFLAGS="-C target-feature=+simd128 --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo" \
        cargo build --locked --profile page -p drillstring-page --target "$target"
    made=${CARGO_TARGET_DIR:-target}/$target/page/page.wasm
}

check() {
    if [[ $(recorded sources) != "$(digest_of_sources)" ]]; then
        ! is_release || refuse "$engine is older than the sources of this release: run this without --check"
        echo "$engine is older than the sources, as it may be between releases"
        return
    fi
    echo "$engine was made from these sources, says $record"
    is_release || return 0
    if [[ $(rustc --version) != "$(recorded compiler)" ]]; then
        RUSTUP_TOOLCHAIN=$(recorded compiler | cut -d' ' -f2)
        export RUSTUP_TOOLCHAIN
        rustup toolchain install --profile minimal "$RUSTUP_TOOLCHAIN"
    fi
    make_engine
    gzip --decompress --stdout "$engine" | cmp - "$made" ||
        refuse "$engine is not what these sources make"
    echo "and these sources make it, byte for byte"
}

case ${1:-} in
--check) check ;;
'')
    make_engine
    # No name and no time in it: the same engine is the same bytes.
    gzip --best --no-name <"$made" >"$engine"
    printf '%s: %s\n' sources "$(digest_of_sources)" compiler "$(rustc --version)" >"$record"
    printf '%s: %s bytes, %s unpacked\n' "$engine" "$(stat -c %s "$engine")" "$(stat -c %s "$made")"
    ;;
*) refuse "usage: scripts/renew-page-engine.sh [--check]" ;;
esac
