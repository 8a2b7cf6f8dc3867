//! What users' scripts hold on to: the commands, the files they write, the
//! exit codes.

mod check;
mod check_formats;
mod contacts;
mod designs;
mod film;
mod manifest;
mod methods;
mod modes;
mod new;
mod promises;
mod reference;
mod responses;
mod run;
mod same_case;
mod sampling;
mod single_case;
mod stability;
mod studies;
mod terminal;
mod unstable;
mod words;

use std::collections::BTreeSet;

use crate::support::{Answer, CUTTING, SMALL, Workplace, with};

const RESULTS: [&str; 7] = [
    "boundary.csv",
    "failures.csv",
    "labels.csv",
    "manifest.json",
    "map.png",
    "map.svg",
    "records.jsonl.gz",
];

/// What was said on the error stream, but for what choosing for an accuracy took.
fn complaints(errors: &str) -> String {
    let lines = errors.split_inclusive('\n');
    lines
        .filter(|line| !line.starts_with("accuracy: "))
        .collect()
}

/// Runs what must succeed without a word of warning.
#[track_caller]
fn succeeds(place: &Workplace, arguments: &[&str]) -> Answer {
    let answer = place.sweep(arguments);
    let complaints = complaints(&answer.errors);
    assert_eq!((answer.code, complaints.as_str()), (0, ""), "{answer:?}");
    answer
}

/// Runs a sweep file into a folder.
#[track_caller]
fn run(place: &Workplace, file: &str, out: &str) -> Answer {
    succeeds(place, &["run", file, "--out", out])
}

fn text(place: &Workplace, file: &str) -> String {
    std::fs::read_to_string(place.path(file)).unwrap()
}

#[track_caller]
fn is_png(place: &Workplace, file: &str) {
    let picture = std::fs::read(place.path(file)).unwrap();
    assert!(picture.starts_with(b"\x89PNG\r\n\x1a\n"), "{file}");
}

/// [`SMALL`] by two methods.
fn by_two_methods(other: &str) -> String {
    let two = format!("\"quadrature\", \"{other}\"");
    with(SMALL, "\"quadrature\"", &two)
}

/// The columns of the labels in a folder.
#[track_caller]
fn labels<const N: usize>(place: &Workplace, folder: &str, wanted: [&str; N]) -> Vec<[String; N]> {
    columns(
        &table(&text(place, &format!("{folder}/labels.csv"))),
        wanted,
    )
}

fn names_in(place: &Workplace, folder: &str) -> BTreeSet<String> {
    std::fs::read_dir(place.path(folder))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

fn names<const N: usize>(names: [&str; N]) -> BTreeSet<String> {
    names.map(str::to_owned).into()
}

/// The cells of a CSV file, header first.
fn table(text: &str) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(text.as_bytes());
    reader
        .records()
        .map(|record| record.unwrap().iter().map(str::to_owned).collect())
        .collect()
}

/// The given columns of a table, without its header.
#[track_caller]
fn columns<const N: usize>(table: &[Vec<String>], wanted: [&str; N]) -> Vec<[String; N]> {
    let places = wanted.map(|name| {
        let place = table[0].iter().position(|field| field == name);
        place.unwrap_or_else(|| panic!("no column {name} in {:?}", table[0]))
    });
    let row = |row: &Vec<String>| places.map(|place| row[place].clone());
    table[1..].iter().map(row).collect()
}

fn manifest(place: &Workplace, folder: &str) -> serde_json::Value {
    serde_json::from_str(&text(place, &format!("{folder}/manifest.json"))).unwrap()
}
