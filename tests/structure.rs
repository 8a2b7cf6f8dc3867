//! The structure of the three crates: imports run one way, between files and between
//! folders. What an import names counts where it is defined, however many re-exports it
//! comes through; tests within a file, and re-exports themselves, do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

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
                "tests" | "fuzz" | "guide" => continue,
                _ => within(name),
            };
            self.read_file(&fs::read_to_string(&path).unwrap(), module);
        }
    }

    fn read_file(&mut self, text: &str, module: Module) {
        let code = without_comments_and_tests(text);
        let (mut imports, mut reexports) = (Vec::new(), BTreeMap::new());
        for (statement, is_reexport) in use_statements(&code) {
            for (path, name) in expanded(&statement) {
                if is_reexport {
                    reexports.insert(name, path);
                } else {
                    imports.push(path);
                }
            }
        }
        imports.extend(inline_paths(&code));
        self.imports.insert(module.clone(), imports);
        self.reexports.insert(module, reexports);
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

fn without_comments_and_tests(text: &str) -> String {
    let code = text
        .split("#[cfg(test)]\nmod tests {")
        .next()
        .unwrap_or_default();
    let lines = code.lines().map(|line| match line.find("//") {
        // Not that of an address.
        Some(place) if !line[..place].ends_with(':') => &line[..place],
        _ => line,
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// What is between `use` and the semicolon, and whether it is a re-export.
fn use_statements(code: &str) -> Vec<(String, bool)> {
    let mut found = Vec::new();
    let mut lines = code.lines();
    while let Some(line) = lines.next() {
        let line = line.trim_start();
        let is_reexport = line.starts_with("pub");
        let visible = match line.strip_prefix("pub") {
            Some(rest) => rest.trim_start_matches(|letter| letter != ' ').trim_start(),
            None => line,
        };
        let Some(begin) = visible.strip_prefix("use ") else {
            continue;
        };
        let mut statement = begin.to_owned();
        while !statement.contains(';') {
            let Some(next) = lines.next() else { break };
            statement += next.trim();
        }
        found.push((statement.replace(';', ""), is_reexport));
    }
    found
}

/// Every path of a use statement with the name it gets: braces multiplied out.
fn expanded(statement: &str) -> Vec<(Vec<String>, String)> {
    let statement = statement.trim();
    if let Some((before, inner)) = statement.split_once('{') {
        let inner = inner.trim_end().strip_suffix('}').unwrap_or(inner);
        let parts = split_at_commas(inner);
        return (parts.iter())
            .flat_map(|part| expanded(&format!("{before}{}", part.trim())))
            .collect();
    }
    let (path, name) = match statement.split_once(" as ") {
        Some((path, name)) => (path, Some(name.trim().to_owned())),
        None => (statement, None),
    };
    let mut segments: Vec<String> = path
        .split("::")
        .map(|part| part.trim().to_owned())
        .collect();
    if segments
        .last()
        .is_some_and(|last| last == "self" || last == "*")
    {
        segments.pop();
    }
    let name = name
        .or_else(|| segments.last().cloned())
        .unwrap_or_default();
    vec![(segments, name)]
}

fn split_at_commas(inner: &str) -> Vec<String> {
    let (mut parts, mut depth) = (vec![String::new()], 0);
    for letter in inner.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if letter == ',' && depth == 0 {
            parts.push(String::new());
        } else if let Some(part) = parts.last_mut() {
            part.push(letter);
        }
    }
    parts.retain(|part| !part.trim().is_empty());
    parts
}

/// Paths from the root of the crate that stand in the code itself.
fn inline_paths(code: &str) -> Vec<Vec<String>> {
    let is_of_path = |letter: char| letter.is_alphanumeric() || letter == '_' || letter == ':';
    let starts = code.match_indices("crate::").filter(|(place, _)| {
        let before = code[..*place].chars().next_back();
        !before.is_some_and(|letter| is_of_path(letter) || letter == '$')
    });
    let texts = starts.map(|(place, _)| {
        let rest = &code[place..];
        let end = rest.find(|letter| !is_of_path(letter));
        &rest[..end.unwrap_or(rest.len())]
    });
    texts
        .map(|text| {
            let segments = text.split("::").filter(|segment| !segment.is_empty());
            segments.map(str::to_owned).collect()
        })
        .collect()
}

/// Every node that one leads to.
fn reachable<'a>(reach: &BTreeMap<&'a str, BTreeSet<&'a str>>, from: &'a str) -> BTreeSet<&'a str> {
    let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
    while let Some(node) = open.pop() {
        let next = reach.get(node).into_iter().flatten();
        open.extend(next.filter(|node| seen.insert(**node)).copied());
    }
    seen
}

/// Groups of nodes of which each leads to each.
fn circles(arrows: &BTreeSet<(String, String)>) -> Vec<Vec<String>> {
    let mut reach: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    for (from, to) in arrows {
        reach.entry(from).or_default().insert(to);
    }
    let all: BTreeMap<&str, BTreeSet<&str>> = (reach.keys())
        .map(|node| (*node, reachable(&reach, node)))
        .collect();
    let mut found: Vec<Vec<String>> = Vec::new();
    for (node, others) in &all {
        let back = |other: &&&str| {
            all.get(**other)
                .is_some_and(|reached| reached.contains(node))
        };
        let group: Vec<String> = others
            .iter()
            .filter(back)
            .map(|it| (*it).to_owned())
            .collect();
        if group.len() > 1 && !found.contains(&group) {
            found.push(group);
        }
    }
    found
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

#[test]
fn imports_run_one_way() {
    let mut found = Vec::new();
    for name in ["linear", "sim", "sweep"] {
        let modules = Crate::read(name);
        let arrows = modules.arrows();
        assert!(arrows.len() > 30, "{name} was not read: {arrows:?}");
        let folders: BTreeSet<Module> = (modules.imports.keys())
            .filter(|module| !module.is_empty())
            .map(|module| module[..module.len() - 1].to_vec())
            .collect();
        for folder in folders {
            for circle in circles(&between_neighbours(&arrows, &folder)) {
                let place = [vec![name.to_owned()], folder.clone()].concat().join("::");
                found.push(format!("{place}: {}", circle.join(", ")));
            }
        }
    }
    assert!(found.is_empty(), "circles:\n{}", found.join("\n"));
}

/// The test itself: a circle through a re-export is found, a re-export alone is none.
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
    assert_eq!(circle(&modules), [["a", "b"]]);
}
