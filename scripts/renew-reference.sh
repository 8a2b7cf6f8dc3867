#!/usr/bin/env bash
# Renews the label files in results/reference on purpose, after a change that is
# meant to change labels. Look at the difference in git before committing it.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# renew FIGURE MARGIN AXIS: labels of the cases that are listed for a figure, but for those of
# which one changes within the margin.
renew() {
    local sweep=(cargo run --release --locked --quiet --)
    "${sweep[@]}" run "sweeps/$1_reference.toml" --out "$folder/$1" --quiet
    "${sweep[@]}" reference "$folder/$1" --margin "$2" --along "$3" \
        --out "results/reference/$1.csv"
}

renew fig09 3% surface_speed_rpm
renew fig14 5% friction
renew fig17 10% friction
renew axial_aarsnes 10% surface_speed_rpm,feed_m_h
git --no-pager diff --stat -- results/reference
