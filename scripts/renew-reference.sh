#!/usr/bin/env bash
# Renews the label files in results/reference on purpose, after a change that is
# meant to change labels. Look at the difference in git before committing it.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Case, method, axes and labels; the measures may change in their last digits.
labels_only() {
    awk -F, '
        NR == 1 {
            for (i = 1; i <= NF; i++)
                if ($i !~ /_(s|nm|mm|kn|m)$/ && $i !~ /^(sticks|stick_slip_|bit_speed|contact_|rolling_|precession_|ambiguous|predicted|simulated|ended|status)/ || $i == "weight_on_bit_kn")
                    kept[++count] = i
        }
        {
            line = $(kept[1])
            for (k = 2; k <= count; k++) line = line "," $(kept[k])
            print line
        }' "$1"
}

for figure in fig09 fig14 fig17; do
    cargo run --release --locked --quiet -- \
        run "sweeps/${figure}_reference.toml" --out "$folder/$figure" --quiet
    labels_only "$folder/$figure/labels.csv" > "$folder/$figure.csv"
    mv "$folder/$figure.csv" "results/reference/$figure.csv"
done
git --no-pager diff --stat -- results/reference
