#!/usr/bin/env bash
# Renews results/reference/fig09.csv on purpose, after a change that is meant to
# change labels. Look at the difference in git before committing it.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cargo run --release --locked -- run sweeps/fig09_reference.toml --out "$folder" --quiet
# Case, method, axes and label; the measures may change in their last digits.
columns=case,method,surface_speed_rpm,weight_on_bit_kn,torsion
awk -F, -v columns="$columns" '
    NR == 1 {
        count = split(columns, names, ",")
        for (i = 1; i <= NF; i++) place[$i] = i
    }
    {
        line = ""
        for (i = 1; i <= count; i++) line = line (i > 1 ? "," : "") $(place[names[i]])
        print line
    }' "$folder/labels.csv" > "$folder/reference.csv"
mv "$folder/reference.csv" results/reference/fig09.csv
git --no-pager diff --stat -- results/reference
