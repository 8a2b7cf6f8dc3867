//! What the names of tests say, and what keeps tests from being left out.

use std::path::{Path, PathBuf};

/// A test: the file that it is in, its name, and why it is ignored, if it is.
struct Test {
    file: PathBuf,
    name: String,
    ignored: Option<String>,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The Rust files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    paths
        .flat_map(|path| match path.is_dir() {
            true => files(&path),
            false => vec![path],
        })
        .filter(|path| path.extension().is_some_and(|end| end == "rs"))
        .collect()
}

/// The tests of a file, within macros too.
fn tests_of(file: &Path) -> Vec<Test> {
    let text = std::fs::read_to_string(file).unwrap();
    let pieces = text.split("#[test]\n").skip(1);
    pieces
        .map(|piece| {
            let (before, after) = piece.split_once("fn ").expect("a function");
            let reason = before.split_once("#[ignore");
            Test {
                file: file.strip_prefix(root()).unwrap().to_owned(),
                name: after.split('(').next().unwrap().to_owned(),
                ignored: reason.map(|(_, rest)| {
                    let text = rest.split_once("= \"").expect("a reason").1;
                    text.split('"').next().unwrap().to_owned()
                }),
            }
        })
        .collect()
}

fn all_tests() -> Vec<Test> {
    let mut all = Vec::new();
    for folder in ["tests", "crates"] {
        all.extend(
            files(&root().join(folder))
                .iter()
                .flat_map(|it| tests_of(it)),
        );
    }
    assert!(all.len() > 1000, "{}", all.len());
    all
}

/// What cannot run everywhere is ignored with what it needs, in a program whose ignored tests
/// `.ci/run` runs; nothing else is ignored.
#[test]
fn ignored_tests_say_what_they_need_and_ci_runs_them() {
    let ci = std::fs::read_to_string(root().join(".ci/run")).unwrap();
    let ignored: Vec<Test> = (all_tests().into_iter())
        .filter(|test| test.ignored.is_some())
        .collect();
    assert!(ignored.len() > 8, "{}", ignored.len());
    for Test {
        file,
        name,
        ignored,
    } in ignored
    {
        let reason = ignored.unwrap();
        assert!(
            ["needs Slurm", "needs Node", "needs Node and Chromium"].contains(&&*reason),
            "{name}: {reason}"
        );
        // tests/PROGRAM/…
        let program = file.components().nth(1).unwrap().as_os_str();
        let call = format!("\nignored {} ", program.to_str().unwrap());
        assert!(ci.contains(&call), "{name} is not run by .ci/run: {call:?}");
    }
}
