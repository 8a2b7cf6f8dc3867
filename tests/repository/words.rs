//! The words of the program: plain English and the terms of drilling and numerics.
//!
//! [`EVERYWHERE`] lists words that are wrong in comments, names, messages and the guide,
//! [`FOR_USERS`] those that are wrong only where users read them. Each says what to write instead,
//! and in which phrases the word is right after all; a phrase that no text has any more is to be
//! removed.

use std::collections::HashMap;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::root;

/// A word or a phrase that is wrong.
struct Wrong {
    /// Spellings, in lower case, with one space between words.
    words: &'static [&'static str],
    /// What to write instead.
    instead: &'static str,
    /// Phrases in which it is right.
    right: &'static [&'static str],
    /// Whether it is wrong only where a clause ends with it.
    at_end: bool,
}

const fn wrong(words: &'static [&'static str], instead: &'static str) -> Wrong {
    Wrong {
        words,
        instead,
        right: &[],
        at_end: false,
    }
}

impl Wrong {
    const fn but(self, right: &'static [&'static str]) -> Self {
        Self { right, ..self }
    }

    const fn at_end(self) -> Self {
        Self {
            at_end: true,
            ..self
        }
    }
}

/// Wrong in comments, names, messages, help and the guide.
const EVERYWHERE: &[Wrong] = &[
    wrong(
        &["told", "foretold", "untold"],
        "reported, given, classified; predicted; undetermined for what cannot be known",
    ),
    wrong(&["cannot be", "can be none"], "is invalid, is impossible").at_end(),
    wrong(
        &["is none", "are none", "was none", "were none"],
        "is missing, is invalid, does not exist",
    )
    .but(&["there is none", "there are none"]),
    wrong(
        &["comes to", "come to", "came to", "coming to"],
        "equals, reaches, tends to",
    )
    .but(&["comes to rest"]),
    wrong(
        &["goes on", "go on", "went on", "going on", "gone on"],
        "continues",
    ),
    wrong(&["hangs on", "hang on", "hung on"], "depends on"),
    wrong(&["beside"], "next to, together with, in addition to"),
    wrong(&["so many"], "a number of, this number of"),
    wrong(&["whatever"], "any, for any, regardless of"),
    wrong(&["whoever"], "the user, anyone who"),
    wrong(&["nobody"], "no user, no one; or say what is unknown"),
    wrong(
        &["of its own", "of their own", "of one's own"],
        "its own …, a separate …; user-defined",
    )
    .at_end(),
    wrong(
        &["knock", "knocks", "knocked", "blow", "blows"],
        "impulse, impact",
    ),
    wrong(&["caught again"], "re-sticks, sticks again"),
    wrong(&["set going"], "started"),
    wrong(&["stands off", "stand off"], "has clearance"),
    wrong(
        &["what comes back", "comes back of", "nothing brings back"],
        "reflection coefficient; rigid-body modes, without a restoring force",
    ),
    wrong(&["stranger", "strangers"], "foreign, unknown"),
    wrong(&["how large a part"], "which fraction"),
    wrong(&["passed over", "passes over"], "ignored"),
    wrong(&["looked at"], "examined, observed, compared, read"),
];

/// Wrong in messages, help and the guide; the field's words within the numerics.
const FOR_USERS: &[Wrong] = &[
    wrong(&["tap", "taps"], "impulse response, its samples or steps"),
    wrong(
        &["sheet of pictures", "sheets of pictures"],
        "chart, overview",
    ),
];

/// Names in files and old options that stay, as literals of their own: columns, values, keys.
const KEPT: [(&str, &str); 9] = [
    ("foretold", "a column of version 0.1.0"),
    ("untold", "a value in window.csv"),
    ("blow", "a column of contacts.csv"),
    ("knock", "a value in contacts.csv"),
    ("knocked_at_m", "a column of contacts.csv"),
    ("knock_ratio", "a column of contacts.csv"),
    ("knock-at", "an option of contacts, before --impulse-at"),
    ("knocks", "an option of contacts, before --impulses"),
    ("blows", "an option of contacts, before --impulses-along"),
];

/// Names of the standard libraries that are one word, as Rust and Python spell them.
const STANDARD: [&str; 3] = ["None", "is_none", "is_none_or"];

/// Words that begin another clause, or a phrase that says where or how: before these a clause ends.
const AFTER_CLAUSE: [&str; 38] = [
    "and", "are", "as", "at", "because", "but", "by", "can", "for", "from", "has", "have", "here",
    "how", "in", "is", "it", "its", "nor", "of", "on", "one", "or", "so", "than", "that", "the",
    "their", "there", "to", "under", "was", "what", "where", "which", "who", "with", "without",
];

/// The texts of the repository by their paths from its root. Of the changelog, what is not
/// released yet.
fn texts() -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    for place in [
        ".ci",
        "ARCHITECTURE.md",
        "CHANGELOG.md",
        "CONTRIBUTING.md",
        "README.md",
        "crates",
        "docs",
        "scripts",
        "sweeps",
        "tests",
    ] {
        list(&root().join(place), &mut files);
    }
    let this = Path::new("tests/repository/words.rs");
    let relative = |path: PathBuf| path.strip_prefix(root()).unwrap().to_owned();
    let mut texts: Vec<(PathBuf, String)> = (files.into_iter().map(relative))
        .filter(|path| path != this)
        .map(|path| {
            let text = std::fs::read_to_string(root().join(&path)).unwrap();
            let released = text.match_indices("\n## ").nth(1);
            let end = released.filter(|_| path == Path::new("CHANGELOG.md"));
            let text = end
                .map_or(text.as_str(), |(end, _)| &text[..end])
                .to_owned();
            (path, text)
        })
        .collect();
    texts.sort();
    assert!(texts.len() > 900, "{}", texts.len());
    texts
}

fn list(path: &Path, files: &mut Vec<PathBuf>) {
    const TEXTS: [&str; 12] = [
        "css", "html", "ipynb", "js", "md", "mjs", "py", "pyi", "rs", "sh", "toml", "txt",
    ];
    let name = path.file_name().unwrap().to_str().unwrap();
    if path.is_dir() {
        let is_built = name == "target" || name == "fonts" || name.starts_with(".venv");
        let entries = (!is_built).then(|| std::fs::read_dir(path).unwrap());
        for entry in entries.into_iter().flatten() {
            list(&entry.unwrap().path(), files);
        }
    } else if name == "run"
        || path
            .extension()
            .is_some_and(|end| TEXTS.iter().any(|it| end == *it))
    {
        files.push(path.to_owned());
    }
}

/// A word of a text in lower case, or a mark between words, and its line from 1.
type Word = (String, usize);

/// The words of a text. Marks of comments at the beginning of a line and `\` at its end join lines;
/// `snake_case` and `CamelCase` are words in a row.
fn words(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        let marks = ["///", "//!", "//", "* ", "# ", "#:"];
        let mark = marks.iter().find_map(|mark| line.strip_prefix(mark));
        let line = mark.unwrap_or(line).trim_end_matches('\\');
        let is_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '\'' || c == '’';
        let mut rest = line;
        while let Some(first) = rest.chars().next() {
            let name = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
            let end = if name == 0 { first.len_utf8() } else { name };
            let (piece, after) = rest.split_at(end);
            rest = after;
            if STANDARD.contains(&piece) {
                words.push((piece.to_owned(), index + 1));
            } else if name > 0 {
                words.extend(parts(piece).into_iter().map(|part| (part, index + 1)));
            } else if !first.is_whitespace() {
                words.push((piece.to_owned(), index + 1));
            }
        }
    }
    words
}

/// The words of a name, in lower case.
fn parts(name: &str) -> Vec<String> {
    let mut parts = vec![String::new()];
    let mut was_lower = false;
    for c in name.replace('’', "'").trim_matches('\'').chars() {
        if c == '_' || (c.is_uppercase() && was_lower) {
            parts.push(String::new());
        }
        if c != '_' {
            parts.last_mut().unwrap().extend(c.to_lowercase());
        }
        was_lower = c.is_lowercase();
    }
    parts.retain(|part| !part.is_empty());
    parts
}

/// A text in words, with the places of each.
struct Words {
    all: Vec<Word>,
    places: HashMap<String, Vec<usize>>,
}

impl Words {
    fn of(text: &str) -> Self {
        let all = words(text);
        let mut places: HashMap<String, Vec<usize>> = HashMap::new();
        for (place, (word, _)) in all.iter().enumerate() {
            places.entry(word.clone()).or_default().push(place);
        }
        Self { all, places }
    }

    /// Where a phrase is: ranges of words.
    fn places(&self, phrase: &str) -> Vec<Range<usize>> {
        let parts: Vec<&str> = phrase.split(' ').collect();
        let starts = self.places.get(parts[0]).into_iter().flatten();
        let ranges = starts.map(|&start| start..start + parts.len());
        let is_it = |range: &Range<usize>| {
            let found = self.all.get(range.clone());
            found.is_some_and(|found| found.iter().zip(&parts).all(|(word, part)| word.0 == *part))
        };
        ranges.filter(is_it).collect()
    }
}

/// Every wrong word of a text: its line, the word, what to write instead.
fn faults(text: &str, list: &[Wrong]) -> Vec<(usize, String, &'static str)> {
    let mut text = text.to_owned();
    for (kept, _) in KEPT {
        for quote in ['"', '`'] {
            text = text.replace(&format!("{quote}{kept}{quote}"), "\"\"");
        }
    }
    let words = Words::of(&text);
    let mut found = Vec::new();
    for wrong in list {
        let right = wrong.right.iter().flat_map(|phrase| words.places(phrase));
        let right: Vec<Range<usize>> = right.collect();
        let is_wrong = |range: &Range<usize>| {
            !right.iter().any(|right| right.contains(&range.start))
                && (!wrong.at_end || ends_clause(words.all.get(range.end)))
        };
        for phrase in wrong.words {
            let ranges = words.places(phrase).into_iter().filter(is_wrong);
            let line = |range: Range<usize>| words.all[range.start].1;
            found.extend(ranges.map(|range| (line(range), (*phrase).to_owned(), wrong.instead)));
        }
    }
    found
}

/// Whether a clause ends before a word. A value that is put in, as in `{name}`, is a word.
fn ends_clause(next: Option<&Word>) -> bool {
    next.is_none_or(|(word, _)| {
        let is_word = word == "{" || word.starts_with(char::is_alphanumeric);
        !is_word || AFTER_CLAUSE.contains(&word.as_str())
    })
}

/// The literals of a Rust source that are sentences, without values that are put in, and the lines
/// at which they begin.
fn sentences(source: &str) -> Vec<(usize, String)> {
    let mut literals = Vec::new();
    collect(TokenStream::from_str(source).unwrap(), &mut literals);
    let is_sentence = |text: &String| text.contains('"') && text.contains(' ');
    let sentences = literals.into_iter().filter(is_sentence).map(|text| {
        let before = source.find(&text).map_or("", |at| &source[..at]);
        let pieces = text.split('{');
        let outside = pieces.map(|it| it.split_once('}').map_or(it, |it| it.1));
        (1 + before.matches('\n').count(), outside.collect())
    });
    sentences.collect()
}

/// The literals of a source but its comments.
fn collect(tokens: TokenStream, literals: &mut Vec<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => {
                let first = group.stream().into_iter().next();
                let is_comment = group.delimiter() == Delimiter::Bracket
                    && first.is_some_and(|first| first.to_string() == "doc");
                if !is_comment {
                    collect(group.stream(), literals);
                }
            }
            TokenTree::Literal(literal) => literals.push(literal.to_string()),
            _ => {}
        }
    }
}

/// A page without code: blocks, and pieces between backticks.
fn without_code(page: &str) -> String {
    let mut is_code = false;
    let lines = page.lines().map(|line| {
        let is_fence = line.trim_start().starts_with("```");
        is_code ^= is_fence;
        match is_code || is_fence {
            true => String::new(),
            false => line.split('`').step_by(2).collect::<Vec<_>>().join("x"),
        }
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// What users read of a text, with the lines at which it begins: pages and sweep files, comments that
/// are help or descriptions of keys, and sentences of programs.
fn for_users(path: &Path, text: &str) -> Vec<(usize, String)> {
    let ends_in = |end: &str| path.extension().is_some_and(|it| it == end);
    let is_help = ["crates/sweep/src/cli", "crates/campaign/src/sweep_file"];
    let of_tests = ["tests", "tests.rs", "benches", "validation", "examples"];
    if ends_in("md") {
        vec![(1, without_code(text))]
    } else if path.starts_with("sweeps") || is_help.iter().any(|folder| path.starts_with(folder)) {
        vec![(1, text.to_owned())]
    } else if ends_in("rs")
        && !path
            .iter()
            .any(|part| of_tests.iter().any(|it| part == *it))
    {
        let tests = text.find("#[cfg(test)]\nmod tests {");
        sentences(&text[..tests.unwrap_or(text.len())])
    } else {
        Vec::new()
    }
}

#[test]
fn texts_are_in_plain_words() {
    let mut lines = Vec::new();
    for (path, text) in texts() {
        let mut report = |first: usize, text: &str, list| {
            for (line, word, instead) in faults(text, list) {
                let (path, line) = (path.display(), first + line - 1);
                lines.push(format!(
                    "{path}:{line}: “{word}”; write instead: {instead}\n"
                ));
            }
        };
        report(1, &text, EVERYWHERE);
        for (first, shown) in for_users(&path, &text) {
            report(first, &shown, FOR_USERS);
        }
    }
    assert!(
        lines.is_empty(),
        "{} wrong words (tests/repository/words.rs lists them). Write each sentence anew, so that it \
         is good English with the other word:\n{}",
        lines.len(),
        lines.concat()
    );
}

/// On pages, but for headings; "in in" is inches, and `x` code that is left out.
#[test]
fn no_word_stands_twice() {
    let mut found = Vec::new();
    for (path, text) in texts() {
        if path.extension().is_none_or(|it| it != "md") {
            continue;
        }
        let page = without_code(&text);
        let is_text = |line: &&str| !line.starts_with('#');
        let lines = page.lines().filter(is_text);
        let words: Vec<&str> = lines.flat_map(str::split_whitespace).collect();
        let twice = words.windows(2).filter(|pair| {
            let is_word = pair[0].chars().all(char::is_alphanumeric);
            is_word && pair[0] == pair[1] && !["in", "x"].contains(&pair[0])
        });
        found.extend(twice.map(|pair| format!("{}: {} {}\n", path.display(), pair[0], pair[1])));
    }
    assert!(found.is_empty(), "{}", found.concat());
}

/// Exceptions that nothing needs any more would hide new faults.
#[test]
fn every_exception_is_needed() {
    let texts = texts();
    let all: Vec<Words> = texts.iter().map(|(_, text)| Words::of(text)).collect();
    for phrase in EVERYWHERE.iter().chain(FOR_USERS).flat_map(|it| it.right) {
        let is_there = all.iter().any(|words| !words.places(phrase).is_empty());
        assert!(is_there, "no text has “{phrase}”");
    }
    for (kept, why) in KEPT {
        let quoted = ['"', '`'].map(|quote| format!("{quote}{kept}{quote}"));
        let is_there = |(_, text): &(PathBuf, String)| quoted.iter().any(|it| text.contains(it));
        assert!(texts.iter().any(is_there), "{kept}: {why}");
    }
}

/// The test itself.
#[test]
fn wrong_words_are_found_in_sentences_and_names() {
    let found = |text: &str| -> Vec<(usize, String)> {
        let faults = faults(text, EVERYWHERE).into_iter();
        faults.map(|(line, word, _)| (line, word)).collect()
    };
    let fault = |line: usize, word: &str| vec![(line, word.to_owned())];
    assert_eq!(found("/// It is\n/// told."), fault(2, "told"));
    assert_eq!(
        found("a value that cannot\n/// be, is refused"),
        fault(1, "cannot be")
    );
    assert_eq!(
        found("fn what_cannot_be_is_refused()"),
        fault(1, "cannot be")
    );
    assert_eq!(found("\"it goes \\\n   on\""), fault(1, "goes on"));
    assert_eq!(found("enum Told {"), fault(1, "told"));
    assert_eq!(found("a wall of its own."), fault(1, "of its own"));
    assert_eq!(found("where the limit is none"), fault(1, "is none"));
    for right in [
        "the file cannot be read",
        "{path} cannot be {what}",
        "one of its own frequencies",
        "if value.is_none() {",
        "value is None",
        "there is none",
        "(\"blow\", kind)",
        "it goes along; on its way",
    ] {
        assert_eq!(found(right), [], "{right}");
    }
    assert_eq!(parts("WindowView_of2"), ["window", "view", "of2"]);
    let source = "/// taps\nfn f(taps: u8) { g(\"{taps} samples\", \"of taps\", \"taps\"); }";
    let expected = [
        (2, "\" samples\"".to_owned()),
        (2, "\"of taps\"".to_owned()),
    ];
    assert_eq!(sentences(source), expected);
    assert_eq!(without_code("a `tap` b\n```\ntaps\n```"), "a x b\n\n\n");
}
