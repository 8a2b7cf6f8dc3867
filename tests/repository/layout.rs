//! A file of tests that no other names as its module would never run: the workspace has no package
//! at its root, and test programs are folders.

use std::path::{Path, PathBuf};

use crate::root;

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The files and folders in a folder.
fn within(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().path()).collect()
}

fn stem(path: &Path) -> &str {
    path.file_stem().unwrap().to_str().unwrap()
}

/// Counts the Rust files of a folder, each a module of the file `parent`.
fn modules(folder: &Path, parent: &Path) -> usize {
    let known = text(parent);
    let mut seen = 0;
    for path in within(folder) {
        if path.is_dir() {
            let own = folder.join(format!("{}.rs", stem(&path)));
            seen += modules(&path, &own);
        } else if path.extension().is_some_and(|it| it == "rs") && path != *parent {
            let declaration = format!("mod {};", stem(&path));
            assert!(
                known.contains(&declaration),
                "{} is not declared",
                path.display()
            );
            seen += 1;
        }
    }
    seen
}

#[test]
fn every_test_file_is_declared() {
    let manifest = text(&root().join("crates/sweep/Cargo.toml"));
    let mut seen = 0;
    let of_crates =
        ["numerics", "linear", "sim", "statics"].map(|name| format!("crates/{name}/tests"));
    for tests in of_crates.iter().map(String::as_str).chain(["tests"]) {
        for program in within(&root().join(tests)) {
            let main = program.join("main.rs");
            let name = stem(&program);
            if ["support", "page"].contains(&name) {
                continue;
            }
            let declaration = format!("path = \"../../tests/{name}/main.rs\"");
            let is_known = tests != "tests" || manifest.contains(&declaration);
            assert!(is_known, "{name} is not declared");
            seen += modules(&program, &main);
        }
    }
    assert!(seen > 50, "{seen}");
}
