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

# Pages of docs/, the README as program.md and the shipped sweeps as sweeps.md: links between them stay
# within one folder there, and other files of the repository are named, not linked.
source=target/book-source
rm -rf "$source"
mkdir -p "$source"
cp -r docs/. "$source"
rm "$source/book.toml"
sed -E -e 's#\]\(sweeps/README\.md#](sweeps.md#g; s#\]\(docs/#](#g' \
    -e 's#\[([^]]*)\]\((CONTRIBUTING|ARCHITECTURE|CHANGELOG|CITATION|LICENSE)[^)]*\)#\1#g' \
    README.md >"$source/program.md"
sed -e 's#](\.\./docs/#](#g' sweeps/README.md >"$source/sweeps.md"
sed -i -E -e 's#\]\(\.\./README\.md#](program.md#g; s#\]\(\.\./sweeps/README\.md#](sweeps.md#g' \
    -e 's#\[([^]]*)\]\(\.\./[^)]*\)#\1#g' "$source"/*.md
sed -i -e 's#^- \[First map#- [The program](program.md)\n&#' \
    -e 's#^- \[A results folder.*#&\n- [The shipped sweeps](sweeps.md)#' "$source/SUMMARY.md"

mdbook build docs
echo "target/book/index.html"
