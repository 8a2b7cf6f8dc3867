#!/usr/bin/env bash
# Puts the licences of all that a package is built from into a folder, a folder for each
# dependency: what is passed on in binary form asks to be named with its licence.
#
#   scripts/licences.sh FOLDER OPTION_OF_CARGO_TREE...
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$1
shift

# Procedural macros are in no binary.
cargo tree --locked --edges normal --prefix none --format '{p};{l}' "$@" |
    sed -n 's/ (\*)$//; s/^\([^ ;]*\) v\([^ ;]*\);/\1-\2;/p' | LC_ALL=C sort -u |
    while IFS=';' read -r package licence; do
        mkdir -p "$folder/$package"
        find "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/"$package" -maxdepth 1 -type f \
            \( -iname 'licen[cs]e*' -o -iname 'copying*' -o -iname 'unlicense*' -o -iname 'notice*' \) \
            -exec cp {} "$folder/$package/" \;
        if [[ -z $(ls "$folder/$package") ]]; then
            echo "The sources of $package hold no text of a licence; its manifest says: $licence" \
                >"$folder/$package/LICENCE"
        fi
    done
