//! The structure of the crates: imports run one way, between files and between
//! folders. What an import names counts where it is defined, however many re-exports it
//! comes through; tests within a file, and re-exports themselves, do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use syn::visit::{self, Visit};
use syn::{Ident, ItemMod, ItemUse, UseTree, VisRestricted, Visibility};

/// A module by its path from the root of the crate, which is empty.
type Module = Vec<String>;

/// A crate's modules with what they import and re-export.
struct Crate {
    imports: BTreeMap<Module, Vec<Vec<String>>>,
    /// Of each module, names with the paths they stand for.
    reexports: BTreeMap<Module, BTreeMap<String, Vec<String>>>,
}

/// Which module uses which.
type Arrows = BTreeSet<(Module, Module)>;

impl Crate {
    fn read(name: &str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name);
        let mut found = Self {
            imports: BTreeMap::new(),
            reexports: BTreeMap::new(),
        };
        found.read_folder(&root.join("src"), &Vec::new());
        found
    }

    fn read_folder(&mut self, folder: &Path, module: &Module) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            let within = |name: String| [module.clone(), vec![name]].concat();
            if path.is_dir() {
                self.read_folder(&path, &within(name.clone()));
            }
            if path.extension().is_none_or(|extension| extension != "rs") {
                continue;
            }
            let module = match name.as_str() {
                "lib" | "main" | "mod" => module.clone(),
                // Of the tests of a module.
                "tests" => continue,
                _ => within(name),
            };
            self.read_file(&fs::read_to_string(&path).unwrap(), module);
        }
    }

    fn read_file(&mut self, text: &str, module: Module) {
        let mut file = SourceFile::default();
        file.visit_file(&syn::parse_file(text).unwrap());
        // A library and its program are one root.
        (self.imports.entry(module.clone()).or_default()).extend(file.imports);
        (self.reexports.entry(module).or_default()).extend(file.reexports);
    }

    /// The module in which a path, written in a module, is defined; none if it leads out
    /// of the crate.
    fn home(&self, path: &[String], from: &Module) -> Option<Module> {
        let mut at = from.clone();
        let mut rest = path.iter().peekable();
        match path.first()?.as_str() {
            "crate" => {
                at.clear();
                rest.next();
            }
            "self" => {
                rest.next();
            }
            "super" => {
                while rest.next_if(|segment| *segment == "super").is_some() {
                    at.pop();
                }
            }
            first => {
                let child = [at.clone(), vec![first.to_owned()]].concat();
                if !self.imports.contains_key(&child) {
                    return None;
                }
            }
        }
        while let Some(segment) = rest.next() {
            let child = [at.clone(), vec![segment.clone()]].concat();
            if self.imports.contains_key(&child) {
                at = child;
                continue;
            }
            let Some(stands_for) = self.reexports[&at].get(segment) else {
                break;
            };
            let whole: Vec<String> = stands_for.iter().chain(rest).cloned().collect();
            return self.home(&whole, &at);
        }
        Some(at)
    }

    fn arrows(&self) -> Arrows {
        let mut arrows = Arrows::new();
        for (module, paths) in &self.imports {
            let homes = paths.iter().filter_map(|path| self.home(path, module));
            arrows.extend(
                homes
                    .filter(|home| home != module)
                    .map(|home| (module.clone(), home)),
            );
        }
        arrows
    }
}

/// Whether a module is compiled for tests only.
pub fn is_of_tests(module: &ItemMod) -> bool {
    module.attrs.iter().any(|attribute| {
        let condition = attribute.parse_args::<Ident>();
        attribute.path().is_ident("cfg") && condition.is_ok_and(|word| word == "test")
    })
}

/// What one file names of others.
#[derive(Default)]
struct SourceFile {
    imports: Vec<Vec<String>>,
    reexports: BTreeMap<String, Vec<String>>,
}

impl<'a> Visit<'a> for SourceFile {
    fn visit_item_mod(&mut self, module: &'a ItemMod) {
        if !is_of_tests(module) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_use(&mut self, item: &'a ItemUse) {
        for (path, name) in leaves(&item.tree, Vec::new()) {
            match item.vis {
                Visibility::Inherited => self.imports.push(path),
                _ => drop(self.reexports.insert(name, path)),
            }
        }
    }

    /// `pub(super)` imports nothing.
    fn visit_vis_restricted(&mut self, _: &'a VisRestricted) {}

    /// Paths that stand in the code itself; a single name may be that of a variable.
    fn visit_path(&mut self, path: &'a syn::Path) {
        let segments = path.segments.iter().map(|part| part.ident.to_string());
        let segments: Vec<String> = segments.collect();
        if segments.len() > 1 {
            self.imports.push(segments);
        }
        visit::visit_path(self, path);
    }
}

/// Every path of a use statement with the name it gets.
fn leaves(tree: &UseTree, mut before: Vec<String>) -> Vec<(Vec<String>, String)> {
    let (last, name) = match tree {
        UseTree::Path(path) => {
            before.push(path.ident.to_string());
            return leaves(&path.tree, before);
        }
        UseTree::Group(group) => {
            let trees = group.items.iter();
            return trees
                .flat_map(|tree| leaves(tree, before.clone()))
                .collect();
        }
        UseTree::Name(name) => (&name.ident, &name.ident),
        UseTree::Rename(rename) => (&rename.ident, &rename.rename),
        UseTree::Glob(_) => return vec![(before, "*".to_owned())],
    };
    if last != "self" {
        before.push(last.to_string());
    }
    vec![(before, name.to_string())]
}

/// Groups of nodes of which each leads to each.
fn circles(arrows: &BTreeSet<(String, String)>) -> BTreeSet<Vec<String>> {
    let reached = |from: &String| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(node) = open.pop() {
            let next = arrows.iter().filter(|(begin, _)| begin == node);
            open.extend(next.filter_map(|(_, to)| seen.insert(to).then_some(to)));
        }
        seen
    };
    let groups = arrows.iter().map(|(node, _)| {
        let others = reached(node).into_iter();
        let group = others.filter(|other| reached(other).contains(node));
        group.cloned().collect()
    });
    groups.filter(|group: &Vec<_>| group.len() > 1).collect()
}

/// Arrows between the files and folders of one folder, its own file among them.
fn between_neighbours(arrows: &Arrows, folder: &Module) -> BTreeSet<(String, String)> {
    let entry = |module: &Module| -> Option<String> {
        let rest = module.strip_prefix(folder.as_slice())?;
        Some(
            rest.first()
                .cloned()
                .unwrap_or_else(|| "(its own file)".to_owned()),
        )
    };
    let pairs = arrows
        .iter()
        .filter_map(|(from, to)| Some((entry(from)?, entry(to)?)));
    pairs.filter(|(from, to)| from != to).collect()
}

/// The crates and what each uses of the others, as ARCHITECTURE.md has them.
fn drawn() -> BTreeMap<String, BTreeSet<String>> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../ARCHITECTURE.md");
    let text = fs::read_to_string(page).unwrap();
    let names = |cell: &str| -> Vec<String> {
        let names = cell.split('`').skip(1).step_by(2);
        names.map(str::to_owned).collect()
    };
    let rows = text.lines().filter(|line| line.starts_with("| `"));
    rows.map(|row| {
        let cells: Vec<&str> = row.split('|').collect();
        let name = names(cells[1]).remove(0);
        (name, names(cells[3]).into_iter().collect())
    })
    .collect()
}

#[test]
fn the_architecture_is_that_of_the_manifests() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folders = fs::read_dir(&crates).unwrap();
    let names: BTreeSet<String> = folders
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let used = |name: &String| {
        let manifest = fs::read_to_string(crates.join(name).join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        let dependencies = manifest["dependencies"].as_table().unwrap().keys();
        dependencies
            .filter(|dependency| names.contains(*dependency))
            .cloned()
            .collect::<BTreeSet<String>>()
    };
    let built: BTreeMap<_, _> = names
        .iter()
        .map(|name| (name.clone(), used(name)))
        .collect();
    assert_eq!(drawn(), built);
}

#[test]
fn imports_run_one_way() {
    let mut found = Vec::new();
    // All but the strings of tests, a handful of functions.
    for name in drawn().keys().filter(|name| *name != "problems") {
        let modules = Crate::read(name);
        let arrows = modules.arrows();
        assert!(modules.imports.len() > 3, "{name} was not read");
        assert!(!arrows.is_empty(), "{name} has no imports");
        let folders: BTreeSet<Module> = (modules.imports.keys())
            .filter(|module| !module.is_empty())
            .map(|module| module[..module.len() - 1].to_vec())
            .collect();
        for folder in folders {
            for circle in circles(&between_neighbours(&arrows, &folder)) {
                let place = [vec![name.clone()], folder.clone()].concat().join("::");
                found.push(format!("{place}: {}", circle.join(", ")));
            }
        }
    }
    assert!(found.is_empty(), "circles:\n{}", found.join("\n"));
}

/// Pictures are of plain data: what draws them knows no drillstring.
#[test]
fn the_plotter_depends_on_no_other_crate_of_the_workspace() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let manifest = fs::read_to_string(crates.join("plot/Cargo.toml")).unwrap();
    assert!(manifest.contains("tiny-skia.workspace"));
    for name in ["linear", "sim", "campaign", "page", "sweep", "problems"] {
        let named = manifest.contains(&format!("\n{name}.workspace"));
        assert!(
            !named && !manifest.contains(&format!("../{name}")),
            "{name}"
        );
    }
}

/// The test itself: a circle through a re-export is found, a re-export alone is no circle.
#[test]
fn a_circle_through_a_reexport_is_found() {
    let mut modules = Crate {
        imports: BTreeMap::new(),
        reexports: BTreeMap::new(),
    };
    let module = |path: &[&str]| {
        path.iter()
            .map(|part| (*part).to_owned())
            .collect::<Module>()
    };
    modules.read_file("mod a;\nmod b;\npub use b::{One, Two as Three};\n", vec![]);
    modules.read_file(
        "use crate::Three; // and crate::c\nfn f() {}",
        module(&["a"]),
    );
    modules.read_file("struct One;", module(&["b"]));
    let circle = |modules: &Crate| circles(&between_neighbours(&modules.arrows(), &vec![]));
    assert_eq!(modules.arrows().len(), 1);
    assert!(circle(&modules).is_empty());
    modules.read_file("fn f() { crate::a::f() }", module(&["b"]));
    assert_eq!(circle(&modules).first().unwrap(), &["a", "b"]);
}
