#!/usr/bin/env bash
# Makes the guide one searchable set of pages, in target/book, by mdBook; formulas
# become MathML, so that nothing is fetched to read them. Installs what it needs of
# crates.io into target/tools, some minutes the first time.
set -euo pipefail
cd "$(dirname "$0")/.."

tools=$PWD/target/tools
PATH=$tools/bin:$PATH
has() { command -v "$1" >/dev/null; }
install() { cargo install --locked --quiet --root "$tools" "$@"; }
has mdbook || install mdbook@0.5.4 --no-default-features --features search
has mdbook-katex || install mdbook-katex@0.10.0

# Pages of docs/ and the README: links between the two stay within one folder
# there, and files of the code are named, not linked.
source=target/book-source
rm -rf "$source"
mkdir -p "$source"
cp -r docs/. "$source"
rm "$source/book.toml"
sed -e 's#](docs/#](#g' README.md >"$source/program.md"
sed -i -e 's#](\.\./README\.md#](program.md#g' -E -e 's#\[([^]]*)\]\(\.\./[^)]*\)#\1#g' "$source"/*.md
sed -i -e 's#^- \[First map#- [The program](program.md)\n&#' "$source/SUMMARY.md"

mdbook build docs
echo "target/book/index.html"
