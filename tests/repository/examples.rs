//! Examples in the documentation of the libraries: what a public module is for is shown by a few
//! lines that run, with an assertion.

use std::fs;
use std::path::{Path, PathBuf};

use syn::visit::Visit;

use crate::{root, rust_files};

/// The libraries, with the fewest examples that each has.
const LIBRARIES: [(&str, usize); 7] = [
    ("numerics", 6),
    ("linear", 25),
    ("sim", 20),
    ("campaign", 8),
    ("limits", 2),
    ("results", 4),
    ("plot", 6),
];

/// Of the libraries that others build on, public modules without an example: what the library
/// itself is made of, or plain results of what another module's example shows.
const WITHOUT: [&str; 5] = [
    "linear::elements::newmark",
    "linear::elements::reduction",
    "linear::elements::stepped",
    "sim::watch::along",
    "sim::watch::surface",
];

/// The documentation of a file, item by item.
#[derive(Default)]
struct Documentation {
    texts: Vec<String>,
}

impl<'a> Visit<'a> for Documentation {
    fn visit_file(&mut self, file: &'a syn::File) {
        self.add(&file.attrs);
        syn::visit::visit_file(self, file);
    }

    fn visit_item(&mut self, item: &'a syn::Item) {
        match item {
            syn::Item::Const(it) => self.add(&it.attrs),
            syn::Item::Enum(it) => self.add(&it.attrs),
            syn::Item::Fn(it) => self.add(&it.attrs),
            syn::Item::Struct(it) => self.add(&it.attrs),
            syn::Item::Trait(it) => self.add(&it.attrs),
            _ => {}
        }
        syn::visit::visit_item(self, item);
    }

    fn visit_impl_item_fn(&mut self, function: &'a syn::ImplItemFn) {
        self.add(&function.attrs);
    }
}

impl Documentation {
    fn add(&mut self, attributes: &[syn::Attribute]) {
        let lines = attributes.iter().filter_map(|it| match &it.meta {
            syn::Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
                syn::Expr::Lit(syn::ExprLit {
                    lit: syn::Lit::Str(line),
                    ..
                }) => Some(line.value()),
                _ => None,
            },
            _ => None,
        });
        self.texts.push(lines.collect::<Vec<_>>().join("\n"));
    }
}

/// The examples of a text that run: a fence without a word, or with `rust`.
fn examples(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut fences = text.split("```").skip(1);
    while let (Some(inside), _) = (fences.next(), fences.next()) {
        let (word, code) = inside.split_once('\n').unwrap_or(("", inside));
        if ["", "rust"].contains(&word.trim()) {
            found.push(code.to_owned());
        }
    }
    found
}

/// The examples of a file.
fn examples_of(file: &Path) -> Vec<String> {
    let mut documentation = Documentation::default();
    documentation.visit_file(&syn::parse_file(&fs::read_to_string(file).unwrap()).unwrap());
    let texts = documentation.texts.iter();
    texts.flat_map(|text| examples(text)).collect()
}

fn sources(library: &str) -> PathBuf {
    root().join("crates").join(library).join("src")
}

/// The public modules declared in a file, each with its path and its file, and those in them.
fn public_modules(file: &Path, path: &str) -> Vec<(String, PathBuf)> {
    let parsed = syn::parse_file(&fs::read_to_string(file).unwrap()).unwrap();
    let folder = match file.file_stem().and_then(|stem| stem.to_str()) {
        Some("lib" | "mod") => file.with_file_name(""),
        _ => file.with_extension(""),
    };
    let mut found = Vec::new();
    for item in &parsed.items {
        let syn::Item::Mod(module) = item else {
            continue;
        };
        if !matches!(module.vis, syn::Visibility::Public(_)) || module.content.is_some() {
            continue;
        }
        let name = module.ident.to_string();
        let files = [
            folder.join(&name).with_extension("rs"),
            folder.join(&name).join("mod.rs"),
        ];
        let file = files.into_iter().find(|it| it.exists()).unwrap();
        let path = format!("{path}::{name}");
        found.extend(public_modules(&file, &path));
        found.push((path, file));
    }
    found
}

/// Whether a module, or one within it, has an example.
fn has_example(file: &Path) -> bool {
    let below = match file.ends_with("mod.rs") {
        true => file.with_file_name(""),
        false => file.with_extension(""),
    };
    let below = if below.is_dir() {
        rust_files(&below)
    } else {
        Vec::new()
    };
    let mut files = below.iter().map(PathBuf::as_path).chain([file]);
    files.any(|file| !examples_of(file).is_empty())
}

#[test]
fn every_public_module_of_the_libraries_has_an_example() {
    let mut without = Vec::new();
    for (library, fewest) in [("numerics", 4), ("linear", 15), ("sim", 15)] {
        let modules = public_modules(&sources(library).join("lib.rs"), library);
        assert!(modules.len() > fewest, "{modules:?}");
        let bare = modules.into_iter().filter(|(_, file)| !has_example(file));
        without.extend(bare.map(|(path, _)| path));
    }
    without.sort();
    assert_eq!(without, WITHOUT);
}

#[test]
fn every_example_asserts_something() {
    for (library, fewest) in LIBRARIES {
        let files = rust_files(&sources(library));
        let mut count = 0;
        for file in &files {
            for example in examples_of(file) {
                assert!(example.contains("assert"), "{}: {example}", file.display());
                count += 1;
            }
        }
        assert!(count >= fewest, "{library} has {count} examples");
        let manifest = fs::read_to_string(sources(library).join("../Cargo.toml")).unwrap();
        assert!(!manifest.contains("doctest = false"), "{library}");
    }
}

/// The test itself.
#[test]
fn an_example_is_found_where_it_runs() {
    let text = "Words.\n```text\na ──> b\n```\nMore.\n```\nassert!(true);\n```\n```ignore\nx\n```";
    assert_eq!(examples(text), ["assert!(true);\n"]);
}
