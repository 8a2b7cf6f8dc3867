//! Every piece of a sweep file in the README and the guide, taken as a reader does who copies it:
//! each is accepted, and gives the numbers that are printed next to it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::root;
use crate::support::Workplace;

/// A piece of a sweep file on a page.
struct Snippet {
    page: &'static str,
    /// What only this piece of its page has.
    known_by: &'static str,
    /// What a reader puts before it.
    after: After,
    /// Labels that its page prints: method, label, and how many.
    printed: &'static [(&'static str, &'static str, usize)],
}

/// What a piece of a sweep file is put after.
enum After {
    /// Nothing: it is a file, or names its base.
    Nothing,
    /// A line that names a base.
    Base(&'static str),
    /// The file of `sweep new`, in place of its tables of the same names.
    New,
    /// It is of another file than a sweep's, or goes with no shipped one.
    Other,
}

const SNIPPETS: [Snippet; 25] = [
    snippet("docs/certain.md", "certify", After::Nothing),
    snippet("docs/ci.md", "fig09_reference.csv", After::Nothing),
    snippet(
        "docs/cutting.md",
        "relief_deg",
        After::Base("academic_turning.toml"),
    ),
    Snippet {
        printed: &[("held", "stick_slip", 17)],
        ..snippet("docs/cutting.md", "fig09.toml", After::Nothing)
    },
    snippet("docs/cutting.md", "start_number", After::Nothing),
    snippet(
        "docs/damping.md",
        "loss_factor",
        After::Base("well_12in.toml"),
    ),
    Snippet {
        printed: &[
            ("held", "stick_slip", 56),
            ("quadrature", "stick_slip", 56),
            ("finite-element", "stick_slip", 56),
        ],
        ..snippet("docs/damping.md", "660", After::Nothing)
    },
    snippet("docs/extending.md", "[dependencies]", After::Other),
    snippet("docs/first-map.md", "repeat = 295", After::New),
    snippet("docs/first-map.md", "[40, 1500]", After::New),
    snippet("docs/first-map.md", "methods", After::New),
    snippet("docs/limits.md", "trace", After::Nothing),
    snippet(
        "docs/low-side.md",
        "inclination_deg",
        After::Base("well_12in_low_side.toml"),
    ),
    snippet(
        "docs/low-side.md",
        "[[tools]]",
        After::Base("well_12in_low_side.toml"),
    ),
    snippet(
        "docs/sweep-file.md",
        "the drillstring of the paper's Table 2",
        After::Nothing,
    ),
    snippet(
        "docs/sweep-file.md",
        "accuracy =",
        After::Base("fig09_without_methods.toml"),
    ),
    snippet("docs/sweep-file.md", "Hertzian", After::Nothing),
    snippet("docs/sweep-file.md", "triangular", After::Other),
    snippet("docs/unknowns.md", "monte-carlo", After::Nothing),
    snippet("docs/unknowns.md", "sensitivity", After::Nothing),
    Snippet {
        printed: &[
            ("held", "stick_slip", 247),
            ("finite-element", "stick_slip", 246),
        ],
        ..snippet("docs/well.md", "bha_12in.csv", After::Nothing)
    },
    snippet(
        "docs/well.md",
        "inclination_deg",
        After::Base("well_12in_contacts.toml"),
    ),
    snippet(
        "docs/well.md",
        "wherever the string",
        After::Base("well_12in_contacts.toml"),
    ),
    snippet(
        "docs/well.md",
        "well_b_survey.csv",
        After::Base("well_b_drilling.toml"),
    ),
    snippet(
        "docs/well.md",
        "speed_at_stall_rpm",
        After::Base("well_12in.toml"),
    ),
];

const fn snippet(page: &'static str, known_by: &'static str, after: After) -> Snippet {
    Snippet {
        page,
        known_by,
        after,
        printed: &[],
    }
}

/// Bases that are no shipped file, made of one for a piece that goes with it.
const BASES: [(&str, &str); 2] = [
    (
        "academic_turning.toml",
        "base = \"academic.toml\"\nsurface_speed_rpm = 120\n",
    ),
    (
        "fig09_without_methods.toml",
        "base = \"academic.toml\"\n[bit]\nrock = \"sandstone\"\n[design]\nkind = \"grid\"\n\
         [design.axes]\nsurface_speed_rpm = { values = [0.1, 0.3] }\n\
         weight_on_bit_kn = { values = [50] }\n",
    ),
];

/// A folder with all that is shipped in `sweeps`.
fn workplace() -> Workplace {
    let place = Workplace::new();
    for entry in std::fs::read_dir(root().join("sweeps")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap();
        place.write(name, std::fs::read(&path).unwrap());
    }
    for (name, text) in BASES {
        place.write(name, text);
    }
    place
}

/// The pieces of sweep files on a page.
fn pieces(text: &str) -> Vec<String> {
    let blocks = text.split("```toml\n").skip(1);
    let piece = |block: &str| block.split("```").next().unwrap().to_owned();
    blocks.map(piece).collect()
}

/// A text whose tables and lines are replaced by those of a piece with the same names.
fn replaced(text: &str, piece: &str) -> String {
    let mut whole: toml::Table = text.parse().unwrap();
    let own: toml::Table = piece.parse().unwrap();
    for (key, value) in own {
        match (whole.get_mut(&key), value) {
            (Some(toml::Value::Table(known)), toml::Value::Table(new)) => known.extend(new),
            (_, value) => drop(whole.insert(key, value)),
        }
    }
    whole.to_string()
}

/// A dependency whose package has another name is not found without it.
#[test]
fn the_libraries_are_taken_by_the_names_of_their_packages() {
    let page = std::fs::read_to_string(root().join("docs/extending.md")).unwrap();
    let piece = pieces(&page)
        .into_iter()
        .find(|piece| piece.contains("[dependencies]"));
    let table: toml::Table = piece.unwrap().parse().unwrap();
    let dependencies = table["dependencies"].as_table().unwrap();
    assert!(!dependencies.is_empty());
    for (name, dependency) in dependencies {
        let path = dependency["path"]
            .as_str()
            .unwrap()
            .trim_start_matches("…/");
        let manifest = std::fs::read_to_string(root().join(path).join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        let package = dependency.get("package").and_then(|it| it.as_str());
        assert_eq!(
            package.unwrap_or(name),
            manifest["package"]["name"].as_str().unwrap()
        );
        assert_eq!(name, manifest["lib"]["name"].as_str().unwrap());
    }
}

#[test]
fn every_snippet_gives_what_its_page_prints() {
    let mut pages = vec![PathBuf::from("README.md")];
    for entry in std::fs::read_dir(root().join("docs")).unwrap() {
        let name = entry.unwrap().file_name();
        pages.push(Path::new("docs").join(name));
    }
    let mut seen = 0;
    for page in pages
        .iter()
        .filter(|page| page.extension().is_some_and(|it| it == "md"))
    {
        let text = std::fs::read_to_string(root().join(page)).unwrap();
        for piece in pieces(&text) {
            let mut known = SNIPPETS
                .iter()
                .filter(|known| Path::new(known.page) == page);
            let known = known.find(|known| piece.contains(known.known_by));
            let snippet = known.unwrap_or_else(|| panic!("a new one in {page:?}:\n{piece}"));
            holds(snippet, &piece, &text);
            seen += 1;
        }
    }
    assert_eq!(seen, SNIPPETS.len(), "one that is no longer there");
}

fn holds(snippet: &Snippet, piece: &str, page: &str) {
    let place = workplace();
    let text = match snippet.after {
        After::Nothing => piece.to_owned(),
        After::Base(base) => format!("base = \"{base}\"\n{piece}"),
        After::New => {
            let answer = place.sweep(&["new", "new.toml"]);
            assert_eq!(answer.code, 0, "{answer:?}");
            replaced(
                &std::fs::read_to_string(place.path("new.toml")).unwrap(),
                piece,
            )
        }
        After::Other => return,
    };
    place.write("snippet.toml", &text);
    if snippet.printed.is_empty() {
        let answer = place.sweep(&["run", "snippet.toml", "--dry-run"]);
        assert_eq!(answer.code, 0, "{}: {answer:?}\n{text}", snippet.page);
        return;
    }
    let answer = place.sweep(&["run", "snippet.toml", "--quiet"]);
    assert_eq!(answer.code, 0, "{}: {answer:?}\n{text}", snippet.page);
    let labels = std::fs::read_to_string(place.path("results/snippet/labels.csv")).unwrap();
    let counts = counts(&labels);
    for (method, label, count) in snippet.printed {
        let found = counts.get(&(*method, *label)).copied().unwrap_or(0);
        assert_eq!(found, *count, "{}: {method}, {label}", snippet.page);
        let mut words = page.split(|c: char| !c.is_alphanumeric());
        let is_printed = words.any(|word| word == count.to_string());
        assert!(is_printed, "{}: {count} is not printed", snippet.page);
    }
}

/// How many rows of each method have each label of torsion.
fn counts(labels: &str) -> BTreeMap<(&str, &str), usize> {
    let mut rows = labels
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let place = |name: &str| header.iter().position(|column| *column == name).unwrap();
    let (method, torsion) = (place("method"), place("torsion"));
    let mut counts = BTreeMap::new();
    for row in rows {
        *counts.entry((row[method], row[torsion])).or_default() += 1;
    }
    counts
}
