//! The program, with Parquet and without it, and the Python package are built from the same.
//! `deny.toml`, which CI checks, says what from.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::{root, rust_files};

/// The features of each package that others are built from.
fn features(of: &[&str]) -> BTreeMap<String, BTreeSet<String>> {
    let tree = Command::new(env!("CARGO"))
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .args(["tree", "--locked", "--offline", "--no-dedupe"])
        .args(["--prefix", "none", "--format", "{p};{f}"])
        .args(of)
        .output()
        .unwrap();
    assert!(tree.status.success(), "{tree:?}");
    let mut features = BTreeMap::<_, BTreeSet<_>>::new();
    for line in String::from_utf8(tree.stdout).unwrap().lines() {
        if let Some((package, of_package)) = line.split_once(';') {
            let found = features.entry(package.to_owned()).or_default();
            found.insert(of_package.trim_end_matches(" (*)").to_owned());
        }
    }
    features
}

/// What is built with other features is built again: nearly all, where it is below `faer`.
#[track_caller]
fn are_built_from_the_same(one: &[&str], other: &[&str]) {
    let [one, other] = [features(one), features(other)];
    let differing: Vec<_> = (one.iter())
        .filter_map(|(package, features)| Some((package, features, other.get(package)?)))
        .filter(|(package, ..)| !package.starts_with("drillstring "))
        .filter(|(_, features, others)| !features.is_subset(others))
        .collect();
    assert!(differing.is_empty(), "{differing:#?}");
    let shared = one.keys().filter(|package| other.contains_key(*package));
    assert!(shared.count() > 100);
}

const PROGRAM: &[&str] = &["--package=drillstring", "--edges=normal,build"];
const RELEASED: &[&str] = &[
    "--package=drillstring",
    "--features=parquet",
    "--edges=normal,build",
];

/// Its numbers are those of the command to the last bit, and the build of the one serves the other.
#[test]
fn the_wheel_is_made_of_what_the_program_is_built_from() {
    let wheel = ["--package=drillstring-python", "--edges=normal,build"];
    are_built_from_the_same(&wheel, PROGRAM);
    are_built_from_the_same(&wheel, RELEASED);
}

/// A release is what was tested, and takes no build for itself.
#[test]
fn a_release_is_made_of_what_the_tests_are_built_from() {
    let tests = [
        "--workspace",
        "--features=parquet",
        "--edges=normal,build,dev",
    ];
    are_built_from_the_same(RELEASED, &tests);
    are_built_from_the_same(PROGRAM, &tests);
}

/// What is generic, and large: each crate that calls it compiles it again, and so do its tests.
const GENERIC: [&str; 4] = ["faer", "gemm", "realfft", "rustfft"];

/// Calls of it, where a plan or a matrix comes from `numerics`.
const CALLS: [&str; 9] = [
    "FftPlanner",
    ".partial_piv_lu(",
    ".full_piv_lu(",
    ".llt(",
    ".qr(",
    ".svd(",
    ".eigenvalues(",
    ".self_adjoint_eigen",
    ".norm_l2(",
];

/// Transforms are planned and matrices decomposed in `numerics` alone.
#[test]
fn what_is_generic_and_large_is_compiled_once() {
    let mut callers = BTreeSet::new();
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let folder = entry.unwrap().path();
        let name = folder.file_name().unwrap().to_str().unwrap().to_owned();
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        let tables = ["dependencies", "dev-dependencies", "build-dependencies"];
        let tables = tables.iter().filter_map(|it| manifest.get(*it)?.as_table());
        let mut needed = tables.flat_map(|table| table.keys());
        if needed.any(|package| GENERIC.contains(&package.as_str())) {
            callers.insert(name.clone());
        }
        for file in rust_files(&folder) {
            let text = fs::read_to_string(file).unwrap();
            if CALLS.iter().any(|call| text.contains(call)) {
                callers.insert(name.clone());
            }
        }
    }
    assert_eq!(callers, BTreeSet::from(["numerics".to_owned()]));
}

/// Where the list of known vulnerabilities cannot be reached. `scripts/check-advisories.sh` renews it.
#[test]
fn each_package_was_held_against_the_list_of_known_vulnerabilities() {
    let checked = fs::read_to_string(root().join(".ci/advisories.txt")).unwrap();
    let checked: BTreeSet<&str> = checked.lines().collect();
    let lock: toml::Table = (fs::read_to_string(root().join("Cargo.lock")).unwrap())
        .parse()
        .unwrap();
    let packages = lock["package"].as_array().unwrap();
    let of_others = packages.iter().filter(|it| it.get("source").is_some());
    let unchecked: Vec<String> = of_others
        .map(|it| {
            ["name", "version"]
                .map(|key| it[key].as_str().unwrap())
                .join(" ")
        })
        .filter(|package| !checked.contains(package.as_str()))
        .collect();
    assert!(unchecked.is_empty(), "not checked: {unchecked:?}");
    assert!(packages.len() > 100);
}
