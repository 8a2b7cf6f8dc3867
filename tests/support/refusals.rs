//! What a refusal is: one line of error, an exit code, and nothing left behind.

use crate::support::{Answer, SMALL, Workplace, with};

pub const RUN: [&str; 4] = ["run", "small.toml", "--out", "results"];

/// Runs `arguments`, which must fail with one line of error and leave the
/// folder as it was.
#[track_caller]
pub fn fails(place: &Workplace, arguments: &[&str]) -> Answer {
    let before = place.files();
    let answer = place.sweep(arguments);
    assert!(answer.errors.starts_with("error: "), "{answer:?}");
    assert_eq!(answer.errors.lines().count(), 1, "{answer:?}");
    assert_eq!(answer.output, "");
    assert!(place.files() == before, "{:?}", place.files().keys());
    answer
}

/// As [`fails`], for what the user can mend; the message has all the words.
#[track_caller]
pub fn refused(place: &Workplace, arguments: &[&str], words: &[&str]) {
    let answer = fails(place, arguments);
    assert_eq!(answer.code, 2, "{answer:?}");
    for word in words {
        assert!(answer.errors.contains(word), "no {word:?} in {answer:?}");
    }
}

/// The line (from 1) of the only one that holds `piece`.
#[track_caller]
pub fn line_of(text: &str, piece: &str) -> usize {
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, line)| line.contains(piece));
    let (line, _) = lines
        .next()
        .unwrap_or_else(|| panic!("no {piece:?} in\n{text}"));
    assert!(lines.next().is_none(), "{piece:?} is there twice");
    line
}

/// A sweep file is refused at the line that holds `at`, naming `key` and
/// saying `meant`.
#[track_caller]
pub fn refused_at(text: &str, at: &str, key: &str, meant: &str) {
    refused_at_line(text, line_of(text, at), key, meant);
}

#[track_caller]
fn refused_at_line(text: &str, line: usize, key: &str, meant: &str) {
    let place = format!("error: small.toml:{line}: `{key}`: ");
    refused(&Workplace::with_small(text), &RUN, &[&place, meant]);
}

/// A table of mistakes in [`SMALL`], one a line:
///
/// `piece => what is there instead | key | what is meant | piece of the line`
///
/// The key and the line must be named. The line is that where what is there
/// instead ends, unless a piece of another is given; `⏎` breaks a line.
#[track_caller]
pub fn each_is_refused(mistakes: &str) {
    for row in mistakes
        .lines()
        .map(str::trim_start)
        .filter(|row| !row.is_empty())
    {
        let row = row.replace('⏎', "\n");
        let (piece, row) = row.split_once(" => ").unwrap();
        let fields: Vec<&str> = row.split(" | ").collect();
        let (instead, key, meant) = (fields[0], fields[1], fields[2]);
        let text = with(SMALL, piece, instead);
        let line = fields.get(3).map_or_else(
            || {
                let end = SMALL.find(piece).unwrap() + instead.trim_end().len();
                1 + text[..end].matches('\n').count()
            },
            |at| line_of(&text, at),
        );
        refused_at_line(&text, line, key, meant);
    }
}
