#!/usr/bin/env bash
# Holds the packages of Cargo.lock against the advisory list of RustSec, and records them in
# .ci/advisories.txt with the date of the list, for machines that cannot reach it: there a test
# asks that each package was checked (tests/repository/dependencies.rs).
#
#   scripts/check-advisories.sh [CLONE]    with a clone of the list, or with the list as it is now
#
# Needs cargo-deny; DENY names it where it is not `cargo deny`.
set -euo pipefail
source=${1:-https://github.com/RustSec/advisory-db}
[[ ! -d $source ]] || source=$(cd "$source" && pwd)
cd "$(dirname "$0")/.."

# Under the name by which cargo-deny looks for a clone of that address.
folder=$PWD/target/advisories
clone=$folder/advisory-db-3157b0e258782691
rm -rf "$folder"
mkdir -p "$folder"
git clone --quiet "$source" "$clone"
# A list of any age: its date is recorded.
sed "s|^\[advisories\]|&\ndb-path = \"$folder\"\nmaximum-db-staleness = \"P10Y\"|" deny.toml >"$folder/deny.toml"
cargo fetch --quiet --locked
${DENY:-cargo deny} --offline --locked --config "$folder/deny.toml" check advisories

{
    echo "# Packages of Cargo.lock without a known vulnerability, by scripts/check-advisories.sh"
    git -C "$clone" show -s --format='# with the advisory list of RustSec of %cs, commit %H.'
    # Those of the workspace have no source.
    sed -n '/^name/{N;N;s/name = "\(.*\)"\nversion = "\(.*\)"\nsource.*/\1 \2/p}' Cargo.lock
} >.ci/advisories.txt
