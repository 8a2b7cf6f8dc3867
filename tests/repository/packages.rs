//! What a registry takes: each crate describes itself, is named for the registry, asks for the
//! others by version, and has all its files in its folder.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use syn::visit::Visit;

use crate::structure::is_of_tests;
use crate::{root, rust_files};

/// A crate: its folder, and its manifest.
struct Crate {
    folder: PathBuf,
    manifest: toml::Table,
}

fn crates() -> Vec<Crate> {
    let folders = fs::read_dir(root().join("crates")).unwrap();
    let folders = folders.map(|entry| entry.unwrap().path());
    let crates = folders.map(|folder| {
        let manifest = fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        let manifest = manifest.parse().unwrap();
        Crate { folder, manifest }
    });
    crates.collect()
}

impl Crate {
    fn package(&self) -> &toml::Table {
        self.manifest["package"].as_table().unwrap()
    }

    fn is_published(&self) -> bool {
        !self.package().contains_key("publish")
    }

    fn name(&self) -> &str {
        self.package()["name"].as_str().unwrap()
    }
}

#[test]
fn every_crate_describes_itself() {
    let mut descriptions = BTreeSet::new();
    for it in crates() {
        let mut keys = vec!["license", "authors", "readme", "keywords", "categories"];
        if it.is_published() {
            keys.extend(["documentation", "exclude"]);
        }
        for key in keys {
            assert!(it.package().contains_key(key), "{key} of {}", it.name());
        }
        let description = it.package()["description"].as_str().unwrap().to_owned();
        assert!(descriptions.insert(description), "{}", it.name());
        let licences = ["LICENSE-MIT", "LICENSE-APACHE"];
        let has_all = licences.iter().all(|name| it.folder.join(name).exists());
        assert!(has_all || !it.is_published(), "licences of {}", it.name());
    }
}

/// The folder and what code calls a crate is short; the registry knows it by the whole name.
#[test]
fn packages_are_named_for_the_registry() {
    for it in crates() {
        let folder = it.folder.file_name().unwrap().to_str().unwrap();
        let expected = match folder {
            "sweep" => "drillstring".to_owned(),
            folder => format!("drillstring-{folder}"),
        };
        assert_eq!(it.name(), expected);
        if folder != "python" {
            assert_eq!(it.manifest["lib"]["name"].as_str(), Some(folder));
        }
    }
}

/// The Python package, a workspace for itself, has the version of the others.
#[test]
fn all_have_one_version() {
    for it in crates() {
        let version = &it.package()["version"];
        let is_shared = version.get("workspace").is_some();
        assert!(is_shared || version.as_str() == Some(env!("CARGO_PKG_VERSION")));
    }
}

/// Where a published crate needs another, the registry has to know which.
#[test]
fn crates_ask_for_each_other_by_version() {
    let workspace: toml::Table = fs::read_to_string(root().join("Cargo.toml"))
        .unwrap()
        .parse()
        .unwrap();
    let workspace = workspace["workspace"].as_table().unwrap();
    let version = &workspace["package"]["version"];
    let shared = &workspace["dependencies"];
    let all = crates();
    for it in all.iter().filter(|it| it.is_published()) {
        for (name, asked) in it.manifest["dependencies"].as_table().unwrap() {
            let is_of_workspace = |other: &&Crate| other.folder.ends_with(name);
            let Some(other) = all.iter().find(is_of_workspace) else {
                continue;
            };
            assert!(other.is_published(), "{} needs {name}", it.name());
            assert_eq!(asked["workspace"].as_bool(), Some(true), "{}", it.name());
            assert_eq!(&shared[name]["version"], version, "{name}");
            assert_eq!(shared[name]["package"].as_str(), Some(other.name()));
        }
    }
}

/// Files that a source has built in, without what only its tests have.
#[derive(Default)]
struct BuiltIn {
    files: Vec<String>,
}

impl<'a> Visit<'a> for BuiltIn {
    fn visit_item_mod(&mut self, module: &'a syn::ItemMod) {
        if !is_of_tests(module) {
            syn::visit::visit_item_mod(self, module);
        }
    }

    fn visit_macro(&mut self, it: &'a syn::Macro) {
        if it.path.is_ident("include_str") || it.path.is_ident("include_bytes") {
            let file: syn::LitStr = it.parse_body().unwrap();
            self.files.push(file.value());
        }
        if it.path.is_ident("concat") {
            let parts = syn::punctuated::Punctuated::<syn::Expr, syn::Token![,]>::parse_terminated;
            if let Ok(parts) = it.parse_body_with(parts) {
                parts.iter().for_each(|part| self.visit_expr(part));
            }
        }
    }
}

/// A package is its folder: what is built in lies there, or has a link there.
#[test]
fn what_is_built_in_is_in_the_package() {
    let mut seen = 0;
    for it in crates().iter().filter(|it| it.is_published()) {
        let of_tests = modules_of_tests(&it.folder);
        for path in rust_files(&it.folder.join("src")) {
            if of_tests.iter().any(|module| path.starts_with(module)) {
                continue;
            }
            let mut built_in = BuiltIn::default();
            built_in.visit_file(&syn::parse_file(&fs::read_to_string(&path).unwrap()).unwrap());
            for file in built_in.files {
                let depth = path.strip_prefix(&it.folder).unwrap().components().count() - 1;
                let ups = file.split('/').filter(|part| *part == "..").count();
                assert!(ups <= depth, "{file} in {}", path.display());
                assert!(path.with_file_name("").join(&file).exists(), "{file}");
                seen += 1;
            }
        }
    }
    assert!(seen > 20, "{seen}");
}

/// Files and folders of the modules that are built for tests alone, where they have their own.
fn modules_of_tests(folder: &std::path::Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in rust_files(&folder.join("src")) {
        let file = syn::parse_file(&fs::read_to_string(&path).unwrap()).unwrap();
        let around = match path.file_stem().and_then(|stem| stem.to_str()) {
            Some("mod" | "lib" | "main") => path.with_file_name(""),
            _ => path.with_extension(""),
        };
        for item in &file.items {
            if let syn::Item::Mod(module) = item {
                if module.content.is_none() && is_of_tests(module) {
                    let module = around.join(module.ident.to_string());
                    found.extend([module.with_extension("rs"), module]);
                }
            }
        }
    }
    found
}
