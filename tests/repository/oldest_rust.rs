//! The program is built by the oldest compiler that `Cargo.toml` names, as far as a newer one can
//! tell: Clippy (`incompatible_msrv`) knows what the standard library had, and here is what it does
//! not look at. The workflow of GitHub builds with the oldest itself.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde::Deserialize;
use syn::BinOp;
use syn::visit::Visit;

use crate::{root, rust_files};

#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    rust_version: Option<String>,
}

/// Packages of a lock file, with which the workspace is taken as it is.
fn packages(lock: &Path) -> Vec<Package> {
    let folder = tempfile::tempdir().unwrap();
    for name in ["Cargo.toml", "README.md", "crates", "tests"] {
        std::os::unix::fs::symlink(root().join(name), folder.path().join(name)).unwrap();
    }
    fs::copy(lock, folder.path().join("Cargo.lock")).unwrap();
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--locked", "--format-version", "1"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    serde_json::from_slice::<Metadata>(&output.stdout)
        .unwrap()
        .packages
}

/// The minor version, of `1.85` or `1.85.0`.
fn minor(version: &str) -> u32 {
    version.split('.').nth(1).unwrap().parse().unwrap()
}

/// The lock of the program and the wheel has newer versions of some, which ask for more.
#[test]
fn no_dependency_asks_for_a_newer_compiler() {
    let packages = packages(&root().join(".ci/oldest-rust.lock"));
    let own = packages.iter().find(|it| it.name == "drillstring").unwrap();
    let oldest = minor(own.rust_version.as_ref().unwrap());
    let newer: Vec<&str> = (packages.iter())
        .filter(|it| {
            it.rust_version
                .as_deref()
                .is_some_and(|version| minor(version) > oldest)
        })
        .map(|it| it.name.as_str())
        .collect();
    assert!(
        newer.is_empty(),
        "they need more than Rust 1.{oldest}: {newer:?}"
    );
    assert!(packages.len() > 100);
}

/// `if a && let b = c`, which Rust has since 1.88.
#[derive(Default)]
struct LetChains {
    count: usize,
}

impl<'a> Visit<'a> for LetChains {
    fn visit_expr_binary(&mut self, it: &'a syn::ExprBinary) {
        let has_let = [&it.left, &it.right]
            .iter()
            .any(|side| matches!(***side, syn::Expr::Let(_)));
        if has_let && matches!(it.op, BinOp::And(_)) {
            self.count += 1;
        }
        syn::visit::visit_expr_binary(self, it);
    }
}

fn let_chains(text: &str) -> usize {
    let mut chains = LetChains::default();
    chains.visit_file(&syn::parse_file(text).unwrap());
    chains.count
}

#[test]
fn no_source_has_a_chain_of_lets() {
    for folder in ["crates", "tests"] {
        for path in rust_files(&root().join(folder)) {
            let count = let_chains(&fs::read_to_string(&path).unwrap());
            assert_eq!(count, 0, "{}", path.display());
        }
    }
}

#[test]
fn a_chain_of_lets_is_found() {
    let chain = "fn f() { if let Some(x) = y() && x > 0 && let Some(z) = w(x) {} }";
    assert_eq!(let_chains(chain), 2);
    assert_eq!(let_chains("fn f() { if let Some(x) = y() { x && z } }"), 0);
}
