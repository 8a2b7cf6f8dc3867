# The commands that are typed most, each as it stands: https://just.systems

# These commands
default:
    @just --list

# Build the program: target/release/sweep
build:
    cargo build --release --locked

# Run a sweep: just run sweeps/fig09.toml --methods held
run *ARGS:
    cargo run --release --locked -- run {{ARGS}}

# Run the tests of a crate whose names contain a word: just test sim wall
test CRATE NAME="":
    cargo test --release --locked --manifest-path crates/{{CRATE}}/Cargo.toml {{NAME}}

# Run all tests
test-all:
    cargo test --release --locked --workspace

# Format, and lint a crate: just lint sim
lint CRATE:
    cargo fmt --all
    cargo clippy --release --locked --manifest-path crates/{{CRATE}}/Cargo.toml --all-targets -- -D warnings

# Compare the labels of the paper's maps with the reference
labels:
    cargo run --release --locked -- check sweeps/fig09.toml results/reference/fig09.csv
    cargo run --release --locked -- check sweeps/fig14.toml results/reference/fig14.csv
    cargo run --release --locked -- check sweeps/fig17.toml results/reference/fig17.csv

# Read the documentation of the crates
doc:
    cargo doc --open --workspace --no-deps

# Renew the tables of keys in docs/sweep-file.md
guide:
    UPDATE_GUIDE=1 cargo test --release --locked -p drillstring-campaign the_tables_of_the_guide

# Build the Python wheel into dist/
wheel:
    scripts/wheel.sh

# All checks, as CI runs them
ci:
    .ci/run
