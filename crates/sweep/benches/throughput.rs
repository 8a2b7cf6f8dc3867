//! Whole commands on one thread and on all: `cargo bench -p drillstring`.
#![allow(missing_docs, reason = "benchmarks are no interface")]

use std::process::Command;

use divan::Bencher;

fn main() {
    divan::main();
}

/// Runs a shipped sweep; `more` are options.
fn run(bencher: Bencher, figure: &str, more: &[&str]) {
    let folder = tempfile::tempdir().unwrap();
    let file = format!("{}/../../sweeps/{figure}.toml", env!("CARGO_MANIFEST_DIR"));
    bencher.bench(|| {
        let status = Command::new(env!("CARGO_BIN_EXE_sweep"))
            .args(["run", &file, "--quiet", "--fresh", "--out"])
            .arg(folder.path())
            .args(more)
            .status()
            .unwrap();
        assert!(status.success());
    });
}

const FIGURES: [&str; 3] = ["fig09", "fig14", "fig17"];

#[divan::bench(args = FIGURES, sample_count = 3, sample_size = 1)]
fn all_threads(bencher: Bencher, figure: &str) {
    run(bencher, figure, &[]);
}

#[divan::bench(args = FIGURES, sample_count = 3, sample_size = 1)]
fn one_thread(bencher: Bencher, figure: &str) {
    run(bencher, figure, &["--jobs", "1"]);
}

#[divan::bench(args = FIGURES, sample_count = 3, sample_size = 1)]
fn every_case_to_its_end(bencher: Bencher, figure: &str) {
    run(bencher, figure, &["--full"]);
}
