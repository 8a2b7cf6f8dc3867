//! The guide and the other pages name files that are there, and tests that are.

use std::path::{Path, PathBuf};

use crate::root;

/// Pages that are not in the folder of the guide.
const OTHER_PAGES: [&str; 5] = [
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
    "sweeps/README.md",
    "crates/python/README.md",
];

/// The pages of the guide, without its two lists of pages.
fn pages_of_guide() -> Vec<PathBuf> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap();
    let mut pages: Vec<PathBuf> = docs.map(|entry| entry.unwrap().path()).collect();
    pages.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    pages.retain(|path| !LISTS.iter().any(|list| path.ends_with(list)));
    assert!(pages.len() > 25, "{}", pages.len());
    pages
}

/// The two lists of the guide's pages.
const LISTS: [&str; 2] = ["SUMMARY.md", "README.md"];

/// Every page with its text.
fn pages() -> Vec<(PathBuf, String)> {
    let lists = LISTS.map(|list| root().join("docs").join(list));
    let others = OTHER_PAGES.map(|page| root().join(page));
    let all = pages_of_guide().into_iter().chain(lists).chain(others);
    let read = |path: PathBuf| (path.clone(), std::fs::read_to_string(path).unwrap());
    all.map(read).collect()
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

/// The set of pages has no page that nothing leads to, and is read in one order.
#[test]
fn every_page_is_in_the_summary_and_in_the_index_in_the_same_order() {
    let pages = pages_of_guide();
    let names: Vec<&str> = (pages.iter())
        .map(|page| page.file_name().unwrap().to_str().unwrap())
        .collect();
    let [summary, index] = LISTS.map(|list| {
        let text = std::fs::read_to_string(root().join("docs").join(list)).unwrap();
        let links = between(&text, "](", ")").into_iter();
        let listed: Vec<String> = links
            .filter(|link| names.contains(link))
            .map(str::to_owned)
            .collect();
        for name in &names {
            let times = listed.iter().filter(|link| link == name).count();
            assert_eq!(times, 1, "{name} in docs/{list}");
        }
        listed
    });
    assert_eq!(summary, index);
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
