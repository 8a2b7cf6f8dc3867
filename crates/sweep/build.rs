//! Tells the program which commit it is built from, where that is known, so that
//! results say what made them and shards of different builds are not joined.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    // A path that does not exist would run this at every build.
    for path in ["../../.git/HEAD", "../../.git/logs/HEAD"] {
        if Path::new(path).exists() {
            println!("cargo::rerun-if-changed={path}");
        }
    }
    let commit = Command::new("git")
        .args(["rev-parse", "--short=12", "HEAD"])
        .output()
        .ok()
        .filter(|output| output.status.success())
        .and_then(|output| String::from_utf8(output.stdout).ok());
    let version = env!("CARGO_PKG_VERSION");
    match commit {
        Some(commit) => println!(
            "cargo::rustc-env=SWEEP_VERSION={version} ({})",
            commit.trim()
        ),
        None => println!("cargo::rustc-env=SWEEP_VERSION={version}"),
    }
}
