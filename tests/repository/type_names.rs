//! One name, one public type: no crate has two of them by the same.

use std::collections::BTreeMap;

use syn::visit::{self, Visit};
use syn::{Ident, ItemEnum, ItemMod, ItemStruct, ItemTrait, ItemType, Visibility};

use crate::structure::is_of_tests;
use crate::{root, rust_files};

/// The public types of a crate, and the files that each name is in; tests do not count.
#[derive(Default)]
struct PublicTypes {
    file: String,
    found: BTreeMap<String, Vec<String>>,
}

impl PublicTypes {
    fn add(&mut self, visibility: &Visibility, name: &Ident) {
        if let Visibility::Public(_) = visibility {
            let files = self.found.entry(name.to_string()).or_default();
            files.push(self.file.clone());
        }
    }
}

impl<'a> Visit<'a> for PublicTypes {
    fn visit_item_mod(&mut self, module: &'a ItemMod) {
        if !is_of_tests(module) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_struct(&mut self, item: &'a ItemStruct) {
        self.add(&item.vis, &item.ident);
    }

    fn visit_item_enum(&mut self, item: &'a ItemEnum) {
        self.add(&item.vis, &item.ident);
    }

    fn visit_item_trait(&mut self, item: &'a ItemTrait) {
        self.add(&item.vis, &item.ident);
    }

    fn visit_item_type(&mut self, item: &'a ItemType) {
        self.add(&item.vis, &item.ident);
    }
}

/// Two types of one name in a crate are distinguished by their paths alone, which a reader does not see.
#[test]
fn no_two_public_types_of_a_crate_have_one_name() {
    let crates = std::fs::read_dir(root().join("crates")).unwrap();
    let mut all = Vec::new();
    for entry in crates {
        let folder = entry.unwrap().path();
        let mut types = PublicTypes::default();
        for file in rust_files(&folder.join("src")) {
            types.file = file.strip_prefix(root()).unwrap().display().to_string();
            let text = std::fs::read_to_string(&file).unwrap();
            types.visit_file(&syn::parse_file(&text).unwrap());
        }
        let doubled = types.found.into_iter().filter(|(_, files)| files.len() > 1);
        all.extend(doubled.map(|(name, files)| format!("{name}: {}", files.join(", "))));
    }
    assert!(
        all.is_empty(),
        "public types of one name:\n{}",
        all.join("\n")
    );
}
