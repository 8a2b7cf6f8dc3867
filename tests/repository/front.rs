//! What a reader meets first: the README, the lists of commands, of shipped sweeps and of columns,
//! the citation.

use std::collections::BTreeSet;
use std::path::Path;

use crate::support::Workplace;

fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Bytes that the README may have: it is read in a minute.
const MOST_BYTES: usize = 6000;
/// Where both maps are to be: on the first screen.
const FIRST_SCREEN: usize = 1500;

#[test]
fn the_readme_is_short_and_begins_with_both_maps() {
    let readme = text("README.md");
    assert!(readme.len() <= MOST_BYTES, "{} bytes", readme.len());
    for map in ["fig09-map.png", "well_12in-map.png"] {
        let place = readme.find(&format!("](docs/images/{map})"));
        assert!(place.is_some_and(|place| place < FIRST_SCREEN), "{map}");
    }
}

/// The main job and the tests, as `.ci/run` and readers type them.
#[test]
fn the_readme_has_both_commands() {
    let readme = text("README.md");
    for command in [
        "cargo run --release -- run sweeps/fig09.toml",
        "cargo test --release --workspace",
    ] {
        assert!(readme.lines().any(|line| line == command), "{command}");
    }
}

/// The commands of the program, or of a group of them, as it lists them.
fn commands(group: &[&str]) -> Vec<String> {
    let answer = Workplace::new().sweep(&[group, &["--help"]].concat());
    assert_eq!(answer.code, 0, "{answer:?}");
    let (_, list) = answer.output.split_once("Commands:\n").unwrap();
    let lines = list.lines().take_while(|line| !line.is_empty());
    let names = lines.filter_map(|line| line.strip_prefix("  "));
    names
        .filter(|line| line.starts_with(char::is_alphabetic))
        .map(|line| line.split(' ').next().unwrap().to_owned())
        .collect()
}

#[test]
fn every_command_is_in_the_readme_and_on_its_page() {
    let (readme, page) = (text("README.md"), text("docs/commands.md"));
    let (commands, studies) = (commands(&[]), commands(&["study"]));
    assert!(commands.len() > 15 && studies.len() > 3, "{commands:?}");
    for name in &commands {
        let name = format!("`sweep {name}");
        assert!(readme.contains(&name), "{name}` in README.md");
        assert!(
            page.contains(&format!("| {name}")),
            "{name}` in docs/commands.md"
        );
    }
    for name in studies.iter().filter(|name| *name != "help") {
        assert!(readme.contains(&format!("{name}`")), "{name} in README.md");
        let row = format!("| `sweep study {name}");
        assert!(page.contains(&row), "{row}` in docs/commands.md");
    }
}

/// The table names every file by its name without `.toml`, and the files that these read in full.
#[test]
fn every_shipped_sweep_is_in_the_table() {
    let page = text("sweeps/README.md");
    let named: BTreeSet<&str> = page.split('`').skip(1).step_by(2).collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../sweeps");
    for entry in std::fs::read_dir(folder).unwrap() {
        let file = entry.unwrap().file_name().into_string().unwrap();
        let name = file.strip_suffix(".toml").unwrap_or(&file);
        assert!(name == "README.md" || named.contains(name), "{file}");
    }
}

#[test]
fn every_column_is_on_the_page_of_results() {
    let page = text("docs/results.md");
    for column in campaign::records::COLUMNS {
        assert!(
            page.contains(&format!("`{}`", column.name)),
            "{}",
            column.name
        );
    }
}

#[test]
fn the_citation_is_of_this_version() {
    let version = format!("\nversion: {}\n", env!("CARGO_PKG_VERSION"));
    assert!(text("CITATION.cff").contains(&version), "{version}");
}

/// Commands that developers and CI type name files that are there.
#[test]
fn typed_commands_name_files_that_are_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut seen = 0;
    for file in [
        "justfile",
        "CONTRIBUTING.md",
        ".github/workflows/ci.yml",
        ".github/workflows/release.yml",
    ] {
        let text = text(file);
        let is_of_path = |c: char| c.is_alphanumeric() || "./-_".contains(c);
        let words = text.split(|c| !is_of_path(c));
        let folders = ["scripts/", ".ci/", "sweeps/", "results/reference/"];
        for word in words.filter(|word| folders.iter().any(|it| word.starts_with(it))) {
            let path = word.trim_end_matches('.');
            assert!(root.join(path).exists(), "{path} in {file}");
            seen += 1;
        }
    }
    assert!(seen > 10, "{seen}");
}
