//! Everything the program and the Python package are built from may be passed on under MIT or
//! Apache-2.0, and is built in one version.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

use serde::Deserialize;
use spdx::{Expression, ParseMode};

/// Licences that ask for little more than to be named. Each is needed.
const ALLOWED: [&str; 7] = [
    "Apache-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "CC0-1.0",
    "MIT",
    "Unicode-3.0",
    "Zlib",
];

/// Beside these, what builds the Python package and is not in it: `target-lexicon`, below pyo3.
const ALLOWED_TO_BUILD_PYTHON: &str = "Apache-2.0 WITH LLVM-exception";

/// Old versions beside the newest of the same package, and who holds on to them.
const ACCEPTED: [(&str, &str, &str); 7] = [
    ("equator", "0.2", "nano-gemm, below faer"),
    ("equator-macro", "0.2", "equator 0.2"),
    ("getrandom", "0.2", "const-random, below parquet"),
    ("getrandom", "0.3", "ahash, below parquet"),
    ("miniz_oxide", "0.8", "png"),
    ("r-efi", "5", "getrandom 0.3"),
    ("syn", "2", "equator-macro 0.2 and others; only to build"),
];

/// Whether the allowed licences meet an SPDX expression, or an old one with `/`.
/// No expression, or none that can be understood, is never met.
fn is_met(expression: &str, allowed: &[&str]) -> bool {
    let terms = Expression::parse_mode(expression, ParseMode::LAX);
    terms.is_ok_and(|terms| terms.evaluate(|term| allowed.contains(&term.to_string().as_str())))
}

/// Folders of the two workspaces, seen from the crate of this test.
const WORKSPACE: &str = "../..";
const PYTHON: &str = "../python";

/// Every package of a workspace with its version, and its licence: those that end up in what is
/// built and those that run to build it, on any platform. What only the tests
/// need is not passed on. `cargo tree` leaves out what `cargo metadata` lists
/// though no feature asks for it.
///
/// # Errors
/// What cargo says where it does not know, such as that there is no network.
fn licences(workspace: &str) -> Result<BTreeMap<String, String>, String> {
    // The licences of other platforms' packages are in packages that a build here
    // does not download. Cargo does so now; without a network, this platform's
    // own must do.
    let tree = tree(workspace, &["--target", "all"]).or_else(|error| {
        eprintln!("only the packages of this platform are looked at: {error}");
        tree(workspace, &["--offline"])
    })?;
    let lines = tree.lines().filter(|line| !line.is_empty());
    let pairs = lines.map(|line| {
        let (package, licence) = line.rsplit_once('|').unwrap();
        let licence = licence.trim_end_matches(" (*)");
        (package.to_owned(), licence.to_owned())
    });
    Ok(pairs.collect())
}

fn tree(workspace: &str, arguments: &[&str]) -> Result<String, String> {
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| env!("CARGO").to_owned());
    let output = Command::new(cargo)
        .args(["tree", "--locked", "--workspace", "--all-features"])
        .args(["--edges", "no-dev"])
        .args(["--prefix", "none", "--format", "{p}|{l}"])
        .args(arguments)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join(workspace))
        .output()
        .map_err(|error| error.to_string())?;
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    match output.status.success() {
        true => Ok(text(&output.stdout)),
        false => Err(text(&output.stderr)),
    }
}

/// Packages whose licence is not met by those allowed.
fn refused<'a>(
    licences: &'a BTreeMap<String, String>,
    allowed: &[&str],
) -> Vec<(&'a String, &'a String)> {
    let pairs = licences.iter();
    pairs
        .filter(|(_, licence)| !is_met(licence, allowed))
        .collect()
}

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

/// Old versions in a lock file that are not accepted, and accepted ones that are
/// not there. The file has all platforms' packages, those of the tests too. Cargo
/// takes no two compatible versions, and lists the newest last.
fn complaints(packages: &[Package], accepted: &[(&str, &str, &str)]) -> Vec<String> {
    let pairs = packages.windows(2);
    let old: Vec<&Package> = pairs
        .filter(|pair| pair[0].name == pair[1].name)
        .map(|pair| &pair[0])
        .collect();
    let is = |package: &Package, name: &str, start: &str| {
        package.name == name && package.version.starts_with(&format!("{start}."))
    };
    let unexpected = (old.iter())
        .filter(|old| !accepted.iter().any(|(name, start, _)| is(old, name, start)))
        .map(|old| format!("{} {} is there beside a newer one", old.name, old.version));
    let unneeded = (accepted.iter())
        .filter(|(name, start, _)| !old.iter().any(|old| is(old, name, start)))
        .map(|(name, start, _)| format!("{name} {start} need not be accepted any more"));
    unexpected.chain(unneeded).collect()
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

#[test]
fn every_package_has_a_licence_that_goes_with_ours() {
    let licences = licences(WORKSPACE).unwrap();
    let refused = refused(&licences, &ALLOWED);
    assert!(refused.is_empty(), "{refused:#?}");
}

/// Where there is a network, or the package was built: without, its own packages are not here.
#[test]
fn what_the_python_package_is_built_from_has_such_a_licence_too() {
    let licences = match licences(PYTHON) {
        Ok(licences) => licences,
        Err(error) => return eprintln!("not looked at: {error}"),
    };
    assert!(licences.keys().any(|package| package.starts_with("pyo3 ")));
    let other = refused(&licences, &ALLOWED);
    assert!(!other.is_empty(), "{ALLOWED_TO_BUILD_PYTHON} is not needed");
    for (package, licence) in other {
        assert_eq!(licence, ALLOWED_TO_BUILD_PYTHON, "{package}");
    }
}

#[test]
fn every_allowed_licence_is_needed() {
    let licences = licences(WORKSPACE).unwrap();
    for without in ALLOWED {
        let others: Vec<&str> = ALLOWED.into_iter().filter(|one| *one != without).collect();
        let needed = licences.values().any(|licence| !is_met(licence, &others));
        assert!(needed, "no package needs {without}");
    }
}

#[test]
fn no_package_is_there_in_two_versions_without_a_reason() {
    let complaints = complaints(&locked(WORKSPACE), &ACCEPTED);
    assert!(complaints.is_empty(), "{complaints:#?}");
}

/// Its numbers are those of the command to the last bit, and the build of the one serves the
/// other.
#[test]
fn the_python_package_is_built_from_the_versions_of_the_workspace() {
    let (python, workspace) = (locked(PYTHON), locked(WORKSPACE));
    let differing = differing(&python, &workspace);
    assert!(differing.is_empty(), "{differing:#?}");
    let is_own = |package: &Package| workspace.iter().all(|other| other.name != package.name);
    let own: Vec<Package> = python.into_iter().filter(is_own).collect();
    let complaints = complaints(&own, &[]);
    assert!(complaints.is_empty(), "{complaints:#?}");
}

#[test]
fn a_licence_expression_is_met_by_what_is_allowed() {
    for expression in [
        "MIT",
        "MIT OR Apache-2.0",
        "MIT/Apache-2.0",
        "Unlicense / MIT",
        "GPL-2.0 OR MIT",
        "(MIT OR GPL-3.0-only) AND Unicode-3.0",
        "Apache-2.0 WITH LLVM-exception OR Apache-2.0",
        "MIT OR GPL-3.0-only AND Unicode-3.0",
    ] {
        assert!(is_met(expression, &ALLOWED), "{expression}");
    }
    for expression in [
        "",
        "GPL-3.0-only",
        "LGPL-2.1-or-later OR GPL-2.0",
        "MIT AND GPL-3.0-only",
        "GPL-3.0-only/MPL-2.0",
        "(MIT OR GPL-3.0-only) AND MPL-2.0",
        "(MIT AND MPL-2.0) OR GPL-3.0-only",
        "GPL-2.0-only WITH Classpath-exception-2.0",
        "Apache-2.0 WITH LLVM-exception",
        "LicenseRef-MIT",
        "Mitt",
        "MIT OR",
        "(MIT",
        "MIT Apache-2.0",
    ] {
        assert!(!is_met(expression, &ALLOWED), "{expression}");
    }
}

#[test]
fn an_old_version_is_accepted_as_long_as_it_is_there() {
    let lock = lock(&[("one", "0.2.9"), ("one", "0.20.1"), ("two", "1.0.0")]);
    assert!(complaints(&lock, &[("one", "0.2", "")]).is_empty());
    assert_eq!(
        complaints(&lock, &[]),
        ["one 0.2.9 is there beside a newer one"]
    );
    assert_eq!(
        complaints(&lock, &[("one", "0.2", ""), ("two", "1", "")]),
        ["two 1 need not be accepted any more"]
    );
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
