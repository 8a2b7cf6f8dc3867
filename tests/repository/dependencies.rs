//! The Python package, a separate workspace, is built from the versions of this one. `deny.toml`,
//! which CI checks, says what both may be built from.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use serde::Deserialize;

#[derive(Deserialize)]
struct Lock {
    package: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
}

/// The packages of a workspace's lock file.
fn locked(workspace: &str) -> Vec<Package> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(workspace);
    packages(&std::fs::read_to_string(folder.join("Cargo.lock")).unwrap())
}

fn packages(lock: &str) -> Vec<Package> {
    toml::from_str::<Lock>(lock).unwrap().package
}

/// Versions in a lock file that another lacks, of packages that it has.
fn differing(packages: &[Package], from: &[Package]) -> Vec<String> {
    let names: BTreeSet<&str> = from.iter().map(|package| package.name.as_str()).collect();
    let lacks = |package: &Package| {
        let is = |other: &Package| other.name == package.name && other.version == package.version;
        names.contains(package.name.as_str()) && !from.iter().any(is)
    };
    (packages.iter().filter(|package| lacks(package)))
        .map(|package| format!("{} {}", package.name, package.version))
        .collect()
}

/// Its numbers are those of the command to the last bit, and the build of the one serves the
/// other.
#[test]
fn the_python_package_is_built_from_the_versions_of_the_workspace() {
    let differing = differing(&locked("../python"), &locked("../.."));
    assert!(differing.is_empty(), "{differing:#?}");
}

/// The features of each package that a manifest's default members are built from: for what runs, and
/// for what builds it.
fn features(manifest: &str) -> BTreeMap<String, BTreeSet<String>> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join(manifest);
    let tree = Command::new(env!("CARGO"))
        .args(["tree", "--locked", "--offline", "--no-dedupe"])
        .args(["--edges", "normal,build", "--prefix", "none"])
        .args(["--format", "{p};{f}", "--manifest-path"])
        .arg(manifest)
        .output()
        .unwrap();
    assert!(tree.status.success(), "{tree:?}");
    let mut features = BTreeMap::<_, BTreeSet<_>>::new();
    for line in String::from_utf8(tree.stdout).unwrap().lines() {
        let (package, of_package) = line.split_once(';').unwrap();
        let found = features.entry(package.to_owned()).or_default();
        found.insert(of_package.to_owned());
    }
    features
}

/// What is built with other features is built again: nearly all, where it is below `faer`.
#[test]
fn the_wheel_is_made_of_what_the_program_is_built_from() {
    let program = features("../sweep/Cargo.toml");
    let wheel = features("../python/Cargo.toml");
    let shared = wheel
        .iter()
        .filter(|(package, _)| program.contains_key(*package));
    assert!(shared.clone().count() > 100);
    let differing: Vec<_> = shared
        .filter(|(package, features)| !features.is_subset(&program[*package]))
        .collect();
    assert!(differing.is_empty(), "{differing:#?}");
}

#[test]
fn a_version_that_the_other_lock_lacks_is_found() {
    let workspace = lock(&[("one", "0.2.9"), ("one", "0.20.1"), ("two", "1.0.0")]);
    let python = lock(&[("one", "0.20.1"), ("two", "1.0.1"), ("three", "2.0.0")]);
    assert_eq!(differing(&python, &workspace), ["two 1.0.1"]);
}

/// The packages of a lock file with these names and versions.
fn lock(pairs: &[(&str, &str)]) -> Vec<Package> {
    let tables = pairs.iter().map(|(name, version)| {
        format!("[[package]]\nname = \"{name}\"\nversion = \"{version}\"\n")
    });
    packages(&tables.collect::<String>())
}
