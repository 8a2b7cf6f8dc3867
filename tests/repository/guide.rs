//! The guide and the README name files that are there, and tests that are.

use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Every page with its text.
fn pages() -> Vec<(PathBuf, String)> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap();
    let mut pages: Vec<PathBuf> = docs.map(|entry| entry.unwrap().path()).collect();
    pages.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    pages.push(root().join("README.md"));
    assert!(pages.len() > 9);
    let read = |path: PathBuf| (path.clone(), std::fs::read_to_string(path).unwrap());
    pages.into_iter().map(read).collect()
}

/// What stands between two pieces, wherever both are on one line.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Vec<&'a str> {
    let mut found = Vec::new();
    for mut line in text.lines() {
        while let Some((_, after)) = line.split_once(start) {
            let Some((inside, rest)) = after.split_once(end) else {
                break;
            };
            found.push(inside);
            line = rest;
        }
    }
    found
}

#[test]
fn every_link_leads_somewhere() {
    for (page, text) in pages() {
        for link in between(&text, "](", ")") {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            if file.starts_with("http") {
                continue;
            }
            let target = match file {
                "" => page.clone(),
                _ => page.parent().unwrap().join(file),
            };
            assert!(target.exists(), "{link} in {}", page.display());
            if !heading.is_empty() {
                let text = std::fs::read_to_string(&target).unwrap();
                let mut headings = text.lines().filter(|line| line.starts_with('#'));
                let is_it = |line: &str| anchor(line) == heading;
                assert!(headings.any(is_it), "{link} in {}", page.display());
            }
        }
    }
}

/// The set of pages has no page that nothing leads to.
#[test]
fn every_page_is_in_the_summary_and_in_the_index() {
    let docs = root().join("docs");
    let listed = |list: &str| std::fs::read_to_string(docs.join(list)).unwrap();
    for (list, text) in [
        ("SUMMARY.md", listed("SUMMARY.md")),
        ("README.md", listed("README.md")),
    ] {
        let links = between(&text, "](", ")");
        for (page, _) in pages() {
            let name = page.file_name().unwrap().to_str().unwrap();
            let is_list = ["README.md", "SUMMARY.md"].contains(&name);
            assert!(
                is_list || links.contains(&name),
                "{name} is not in docs/{list}"
            );
        }
    }
}

/// How a heading is linked to.
fn anchor(heading: &str) -> String {
    let words = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = words
        .chars()
        .filter(|&c| c.is_alphanumeric() || " -_".contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn every_file_that_is_named_is_there() {
    let folders = ["sweeps/", "scripts/", "crates/", "tests/"];
    for (page, text) in pages() {
        let words = between(&text, "`", "`")
            .into_iter()
            .flat_map(str::split_whitespace);
        for name in words.filter(|word| folders.iter().any(|folder| word.starts_with(folder))) {
            assert!(root().join(name).exists(), "{name} in {}", page.display());
        }
    }
}

/// On the pages that argue, `a_sentence_in_quotes_like_this` is the name of a test, or else a key.
#[test]
fn every_test_that_is_named_is_there() {
    let mut sources = String::new();
    for folder in ["tests", "crates"] {
        read_all(&root().join(folder), &mut sources);
    }
    for page in ["methods", "errata", "validation"] {
        let text = std::fs::read_to_string(root().join(format!("docs/{page}.md"))).unwrap();
        let is_sentence = |name: &&str| name.matches('_').count() >= 4;
        for name in between(&text, "`", "`").into_iter().filter(is_sentence) {
            let is_test = sources.contains(&format!("fn {name}("));
            let is_key = sources.contains(&format!("pub {name}:"));
            assert!(is_test || is_key, "{name} in {page}");
        }
    }
}

fn read_all(folder: &Path, sources: &mut String) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            read_all(&path, sources);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            sources.push_str(&std::fs::read_to_string(path).unwrap());
        }
    }
}
