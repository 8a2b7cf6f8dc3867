#!/usr/bin/env bash
# Makes the archive for machines without Rust: the program as a static binary for Linux on
# x86-64, which needs no library of the machine, with licences, the sweep files, completions
# and manual pages, and the Python wheel where scripts/wheel.sh makes one; and its SHA-256.
#
#   scripts/release.sh [FOLDER]
#
# FOLDER  where the archive goes [default: dist]
#
# Needs a Rust toolchain for Linux on x86-64 and the C library to link with, libc.a: libc6-dev on
# Debian, glibc-static on Fedora. What a release build has made is used again, and afterwards
# target/release/sweep is the static program until the next build.
# docs/without-rust.md explains how the archive is used, and what glibc's licence asks of those who
# pass it on.
set -euo pipefail
cd "$(dirname "$0")/.."

refuse() {
    printf 'release.sh: %s\n' "$*" >&2
    exit 1
}

target=x86_64-unknown-linux-gnu
dist=${1:-dist}
version=$(cargo pkgid --locked -p drillstring)
version=${version##*[#@]}
name=drillstring-sweep-$version-x86_64-linux

[[ $(rustc --print host-tuple) == "$target" ]] || refuse "the program is built on $target only"
[[ -f $(cc -print-file-name=libc.a) ]] ||
    refuse "there is no libc.a to link with: it is in libc6-dev on Debian, glibc-static on Fedora"
# Of a release, the engine of the pages has to be made from its sources.
scripts/renew-page-engine.sh --check
# With what `sweep export --format parquet` needs.
cargo rustc --release --locked -p drillstring --bin sweep --features parquet -- \
    -C target-feature=+crt-static -C strip=symbols
sweep=${CARGO_TARGET_DIR:-target}/release/sweep

mkdir -p "$dist"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$work/$name
mkdir -p "$folder"/{bin,completions,man/man1,scripts}
cp "$sweep" "$folder/bin/"
cp README.md ARCHITECTURE.md CHANGELOG.md CITATION.cff CONTRIBUTING.md LICENSE-* "$folder/"
cp crates/plot/src/fonts/LICENSE* "$folder/LICENSE-DEJAVU"
cp -R docs sweeps "$folder/"
cp scripts/slurm.sh "$folder/scripts/"
scripts/licences.sh "$folder/licences" -p drillstring --features parquet --target "$target"
# glibc asks for more: see docs/without-rust.md.
mkdir "$folder/licences/glibc"
for file in /usr/share/doc/libc6-dev/copyright /usr/share/common-licenses/LGPL-2.1 \
    /usr/share/licenses/glibc/{COPYING.LIB,LICENSES}; do
    if [[ -f $file ]]; then
        cp "$file" "$folder/licences/glibc/"
    fi
done
[[ -n $(ls "$folder/licences/glibc") ]] || refuse "the licence of glibc is not found"
cat >"$folder/licences/glibc/README" <<END
bin/sweep uses the GNU C Library, which is covered by the GNU Lesser General Public License 2.1,
and holds it: $(ldd --version | sed -n '1s/^ldd //p').
Its sources are at https://ftp.gnu.org/gnu/glibc/ and with the distribution that is named.
To link the program with another version, run scripts/release.sh in the sources of the program
on a machine that has it. They are those of $("$sweep" --version).
END
"$sweep" completions bash >"$folder/completions/sweep.bash"
"$sweep" completions zsh >"$folder/completions/_sweep"
"$sweep" completions fish >"$folder/completions/sweep.fish"
"$sweep" man >"$folder/man/man1/sweep.1"
# commands [GROUP]: the commands of the program or of a group of them
commands() {
    "$sweep" "$@" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z-]*\) .*/\1/p' | grep -vx help
}
for command in $(commands); do
    "$sweep" man "$command" >"$folder/man/man1/sweep-$command.1"
done
for study in $(commands study); do
    "$sweep" man study "$study" >"$folder/man/man1/sweep-study-$study.1"
done

if command -v python3 >/dev/null; then
    rm -f dist/drillstring-*.whl
    scripts/wheel.sh
    cp dist/drillstring-*.whl "$folder/"
else
    echo "release.sh: there is no Python: its wheel is left out" >&2
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
