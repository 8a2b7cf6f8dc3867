#!/usr/bin/env bash
# Renews the pictures of the guide, docs/images, from the sweep files that are shipped:
# two or three minutes on two cores. What the commands say, the numbers that the guide
# quotes, goes to standard output. Three pictures take minutes and are copied by hand:
# tradeoff.png from `sweep tradeoff`, stability.png from `sweep stability`, contacts_limit.png
# from `sweep contacts`.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
images=docs/images
mkdir -p "$images"

cargo build --release --locked --quiet -p sweep
sweep=target/release/sweep

# keep FIGURE PICTURE...: copies pictures of a figure, by its name and theirs
keep() {
    local figure=$1 picture
    shift
    for picture in "$@"; do
        cp "$folder/$figure/$picture.png" "$images/$figure-$picture.png"
    done
}

"$sweep" inspect sweeps/fig10.toml --out "$folder/fig06"
keep fig06 inspect

for figure in fig07a fig07b fig08a fig08b fig11 fig16a; do
    "$sweep" simulate "sweeps/$figure.toml" --out "$folder/$figure"
    keep "$figure" history
done
"$sweep" simulate sweeps/fig16b.toml --film --film-to 2.5 --out "$folder/fig16b"
keep fig16b history contacts film
"$sweep" simulate sweeps/fig16b_found.toml --out "$folder/fig16b_found"
keep fig16b_found contacts
for figure in fig10 fig12 fig15; do
    "$sweep" simulate "sweeps/$figure.toml" --out "$folder/$figure"
    keep "$figure" history orbit
done
"$sweep" simulate sweeps/fig13.toml --case 0,1 --out "$folder/fig13"
keep fig13 string

for figure in fig09 fig09_certified fig14 fig17 fig17_trace well_12in well_12in_soft_torque; do
    "$sweep" run "sweeps/$figure.toml" --out "$folder/$figure"
    keep "$figure" map
done

window=well_12in_window
"$sweep" run "sweeps/$window.toml" --out "$folder/$window"
"$sweep" window "sweeps/$window.toml" "$folder/$window" --held-at 0,15.6,29.4 --orders 1,2
keep "$window" window

"$sweep" new "$folder/my-sweep.toml"
"$sweep" run "$folder/my-sweep.toml" --out "$folder/first"
keep first map
du -ch "$images"/*.png | tail -n 1
