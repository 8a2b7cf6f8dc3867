#!/usr/bin/env bash
# Renews the pictures of the guide, docs/images, from the sweep files that are shipped: some ten
# minutes on two cores that have nothing else to do, for times are among what is drawn. What the
# commands say, the numbers that the guide quotes, goes to standard output. The overviews of
# pictures need Node and Chromium. Two pictures are copied by hand: the maps of `sweep run
# sweeps/well_b_fit.toml` and of the twenty thousand cases of docs/unknowns.md.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
images=docs/images
mkdir -p "$images"

cargo build --release --locked --quiet -p drillstring
sweep=target/release/sweep

# keep FIGURE PICTURE...: copies pictures of a figure, by its name and theirs
keep() {
    local figure=$1 picture
    shift
    for picture in "$@"; do
        cp "$folder/$figure/$picture.png" "$images/$figure-$picture.png"
    done
}

"$sweep" inspect sweeps/fig06.toml --out "$folder/fig06"
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

for figure in well_b well_b_rest; do
    "$sweep" simulate "sweeps/$figure.toml" --out "$folder/$figure"
    keep "$figure" history
done
"$sweep" simulate sweeps/well_12in_cutting.toml --set surface_speed_rpm=100 \
    --set weight_on_bit_kn=80 --out "$folder/well_12in_cutting_cut"
cp "$folder/well_12in_cutting_cut/cut.png" "$images/well_12in_cutting-cut.png"
"$sweep" inspect sweeps/well_12in_low_side.toml --out "$folder/well_12in_low_side_at_rest"
cp "$folder/well_12in_low_side_at_rest/static_string.png" \
    "$images/well_12in_low_side-static_string.png"
"$sweep" inspect sweeps/well_12in.toml --modes --out "$folder/well_12in"
keep well_12in campbell

for figure in fig09 fig09_certified fig14 fig17 fig17_trace well_12in well_12in_soft_torque \
    well_12in_mud well_12in_cutting well_12in_low_side well_12in_on_bottom fig09_cutting \
    axial_aarsnes; do
    "$sweep" run "sweeps/$figure.toml" --out "$folder/$figure"
    keep "$figure" map
done

# Fig. 9 on the axes of fig09_cutting, by the torque that the paper assumes.
cat >"$folder/fig09_to_compare.toml" <<END
base = "$PWD/sweeps/fig09.toml"
title = "Fig. 9: a torque that falls when the bit slips"
methods = ["held"]

[design]
kind = "grid"

[design.axes]
surface_speed_rpm = { from = 0.1, to = 1.5, count = 15 }
weight_on_bit_kn = { from = 10, to = 100, count = 10 }
END
"$sweep" run "$folder/fig09_to_compare.toml" --out "$folder/fig09_to_compare"
keep fig09_to_compare map
"$sweep" simulate sweeps/axial_richard.toml --out "$folder/axial_richard"
keep axial_richard history

window=well_12in_window
"$sweep" run "sweeps/$window.toml" --out "$folder/$window"
"$sweep" window "sweeps/$window.toml" "$folder/$window" --held-at 0,15.6,29.4 --orders 1,2
keep "$window" window

# The snippet of docs/cutting.md.
cat >"$folder/well_12in_starts.toml" <<END
base = '$PWD/sweeps/well_12in_cutting.toml'
title = "12¼-inch well, five starts by chance at each point"
[design]
kind = "grid"
[design.axes]
surface_speed_rpm = { from = 40, to = 220, count = 10 }
weight_on_bit_kn = { from = 20, to = 160, count = 8 }
start_number = { from = 1, to = 5, count = 5 }
END
"$sweep" run "$folder/well_12in_starts.toml" --out "$folder/well_12in_starts"
keep well_12in_starts map

"$sweep" window sweeps/well_12in_cutting.toml "$folder/well_12in_cutting"
keep well_12in_cutting window

"$sweep" new "$folder/my-sweep.toml"
"$sweep" run "$folder/my-sweep.toml" --out "$folder/first"
keep first map

for study in tradeoff stability contacts; do
    "$sweep" study "$study" --out "$folder/$study"
done
"$sweep" study tradeoff --in-mud --out "$folder/tradeoff_in_mud"
"$sweep" study stability --in-mud --out "$folder/stability_in_mud" \
    --family hilbert,direct-idft,newmark,formulas,stiffness,sites,tail,joints
for study in tradeoff stability; do
    cp "$folder/${study}_in_mud/$study.png" "$images/${study}_in_mud.png"
done
cp "$folder/tradeoff/tradeoff.png" "$folder/stability/stability.png" \
    "$folder/contacts/contacts_limit.png" "$images/"

# overview NUMBER PICTURE...: puts pictures at the width of a column side by side
paper=(--width 90mm --font-size 8pt --format png)
overview() {
    local number=$1 picture
    shift
    local files=()
    for picture in "$@"; do
        files+=("$folder/paper/$picture.png")
    done
    scripts/overview-of-pictures.mjs "$images/pictures_90mm_$number.png" "${files[@]}"
}
for figure in fig07a fig08b fig11 fig12 fig15 fig16a; do
    "$sweep" simulate "sweeps/$figure.toml" --out "$folder/paper/$figure" "${paper[@]}"
done
"$sweep" simulate sweeps/fig13.toml --case 0,1 --out "$folder/paper/fig13" "${paper[@]}"
"$sweep" simulate sweeps/fig16b.toml --film --film-to 2.5 --out "$folder/paper/fig16b" "${paper[@]}"
"$sweep" inspect sweeps/fig06.toml --out "$folder/paper/fig06" "${paper[@]}"
"$sweep" inspect sweeps/well_12in.toml --out "$folder/paper/well_12in" "${paper[@]}"
for figure in fig09 fig09_certified fig14 fig17 fig17_trace; do
    cp -r "$folder/$figure" "$folder/paper/$figure"
    "$sweep" plot "$folder/paper/$figure" "${paper[@]}"
done
overview 1 fig06/inspect fig07a/history fig08b/history fig09/map fig09_certified/map fig11/history \
    fig12/{history,orbit,contacts,string} fig13/{string,orbit}
overview 2 fig14/map fig17/map fig17_trace/map fig15/{history,orbit} fig16a/history \
    fig16b/{contacts,film,orbit,string} well_12in/{inspect,top_drive}
du -ch "$images"/*.png | tail -n 1
