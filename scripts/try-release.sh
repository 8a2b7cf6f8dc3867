#!/usr/bin/env bash
# Tries an archive of scripts/release.sh as a machine without anything would: its checksums, then
# the program in a root that is empty but for random numbers, with a sweep file that it wrote
# itself, and, where there is a Python, with no system call later than those of Linux 3.10.
#
#   scripts/try-release.sh ARCHIVE.tar.gz
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
archive=$(readlink -f "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$(dirname "$archive")" && sha256sum --check "$(basename "$archive").sha256")
tar -xzf "$archive" -C "$work"
unpacked=$(echo "$work"/drillstring-sweep-*)
(cd "$unpacked" && sha256sum --quiet --check SHA256SUMS)

root=$work/root
mkdir -p "$root"
cp "$unpacked/bin/sweep" "$root/"
if [[ $EUID -eq 0 ]]; then
    into=(chroot "$root")
elif unshare --map-root-user true 2>/dev/null; then
    into=(unshare --map-root-user chroot "$root")
else
    echo "try-release.sh: an empty root needs root or user namespaces: not tried" >&2
    exit 0
fi
# answers COMMAND...: a map and a page of a sweep file written for this, each file of which must
# exist
answers() {
    "$@" /sweep new --force my-sweep.toml
    "$@" /sweep run my-sweep.toml --out results --fresh
    "$@" /sweep report results
    "$@" /sweep export results --format parquet
    "$@" /sweep simulate my-sweep.toml --case 5 --out results/case
    "$@" /sweep export results/case --table history --format parquet
    for file in labels.{csv,parquet} manifest.json map.png report.html case/history.parquet; do
        [[ -s $root/results/$file ]]
    done
}

# Where no call gives random numbers, they come from files that every machine has: of Linux 3.10, and
# wherever Parquet is written, as a static program cannot ask the C library whether it has the call.
mkdir "$root/dev"
for file in random urandom; do
    head -c 65536 /dev/urandom >"$root/dev/$file"
done

answers "${into[@]}"
(cd "$root" && find . -type f | LC_ALL=C sort)
if command -v python3 >/dev/null; then
    answers "$here/old-kernel.py" "${into[@]}"
else
    echo "try-release.sh: no python3: tried on this kernel only" >&2
fi
