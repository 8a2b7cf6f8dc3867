#!/usr/bin/env bash
# Makes the archive for machines without Rust: the program as a static binary for Linux on
# x86-64, which needs no library of the machine, with licences, the sweep files, completions
# and manual pages, and the Python wheel where scripts/wheel.sh makes one; and its SHA-256.
#
#   scripts/release.sh [FOLDER]
#
# FOLDER  where the archive goes [default: dist]
#
# Needs a Rust toolchain and nothing else; without the standard library for musl, rustup,
# which fetches it. docs/without-rust.md tells how the archive is used.
set -euo pipefail
cd "$(dirname "$0")/.."

refuse() {
    printf 'release.sh: %s\n' "$*" >&2
    exit 1
}

target=x86_64-unknown-linux-musl
dist=${1:-dist}
version=$(cargo pkgid --locked -p sweep)
version=${version##*[#@]}
name=drillstring-sweep-$version-x86_64-linux

if [[ ! -d $(rustc --print target-libdir --target "$target") ]]; then
    command -v rustup >/dev/null ||
        refuse "the standard library for $target is not here, and no rustup to fetch it"
    rustup target add "$target" ||
        refuse "rustup cannot fetch the standard library for $target: is there a network?"
fi
cargo rustc --release --locked -p sweep --bin sweep --target "$target" -- -C strip=symbols
sweep=${CARGO_TARGET_DIR:-target}/$target/release/sweep

mkdir -p "$dist"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/$name
mkdir -p "$folder"/{bin,completions,man/man1,scripts}
cp "$sweep" "$folder/bin/"
cp README.md CHANGELOG.md LICENSE-* "$folder/"
cp crates/sweep/src/plot/fonts/LICENSE* "$folder/LICENSE-DEJAVU"
cp -R docs sweeps "$folder/"
cp scripts/slurm.sh "$folder/scripts/"
# What the program is built from asks to be named with its licence.
cargo tree --locked -p sweep --edges normal --target "$target" --prefix none --format '{p}' |
    sed -n 's/ (\*)$//; s/^\([^ ]*\) v\([^ ]*\)$/\1-\2/p' | LC_ALL=C sort -u |
    while read -r package; do
        mkdir -p "$folder/licences/$package"
        find "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/"$package" -maxdepth 1 -type f \
            \( -iname 'licen[cs]e*' -o -iname 'copying*' -o -iname 'unlicense*' -o -iname 'notice*' \) \
            -exec cp {} "$folder/licences/$package/" \;
    done
"$sweep" completions bash >"$folder/completions/sweep.bash"
"$sweep" completions zsh >"$folder/completions/_sweep"
"$sweep" completions fish >"$folder/completions/sweep.fish"
"$sweep" man >"$folder/man/man1/sweep.1"
"$sweep" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' | grep -vx help |
    while read -r command; do
        "$sweep" man "$command" >"$folder/man/man1/sweep-$command.1"
    done

if [[ -x scripts/wheel.sh ]]; then
    rm -f dist/drillstring-*.whl
    scripts/wheel.sh
    cp dist/drillstring-*.whl "$folder/"
else
    echo "release.sh: there is no scripts/wheel.sh: the Python wheel is left out" >&2
fi

# The same bytes of the same commit: names in order, no owner, the time of the commit.
time=$(git log -1 --format=%ct 2>/dev/null || echo 0)
(cd "$folder" && find . -type f ! -name SHA256SUMS -print0 | LC_ALL=C sort -z |
    xargs -0 sha256sum >"$work/SHA256SUMS" && mv "$work/SHA256SUMS" .)
archive=$dist/$name.tar.gz
tar --create --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$time" \
    --directory="$work" "$name" | gzip -9 -n >"$archive"
(cd "$dist" && sha256sum "$name.tar.gz" >"$name.tar.gz.sha256")
ls -l "$archive" "$archive.sha256"
