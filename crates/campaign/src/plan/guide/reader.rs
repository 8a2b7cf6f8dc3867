//! Ranges and defaults of the types, held to what the reader of a sweep file does.

use serde_json::Value as Json;
use toml::{Table, Value};

use super::page::Types;
use super::{CHAPTERS, Chapter, OF_BASES, read};
use crate::quantities::unit_of;
use crate::sweep_file::file::FileContent;

/// The table at a path of an example.
fn table_at<'a>(example: &'a mut Value, path: &str) -> &'a mut Table {
    let steps = path.split('.').filter(|step| !step.is_empty());
    let found = steps.fold(example, |value, step| match step.parse::<usize>() {
        Ok(index) => &mut value[index],
        Err(_) => &mut value[step],
    });
    found.as_table_mut().unwrap()
}

/// The example with one key changed, or without it.
fn example_with(chapter: &Chapter, key: &str, value: Option<Value>) -> Table {
    let mut example = Value::Table(toml::from_str(chapter.example).unwrap());
    let table = table_at(&mut example, chapter.path);
    match value {
        Some(value) => table.insert(key.to_owned(), value),
        None => table.remove(key),
    };
    example.as_table().unwrap().clone()
}

/// How the reader refuses a value far too large.
fn refusals(chapter: &Chapter, key: &str) -> [String; 2] {
    [Value::Float(1e300), Value::Integer(i64::MAX)].map(|value| {
        let text = toml::to_string(&example_with(chapter, key, Some(value))).unwrap();
        read(&text)
            .err()
            .map_or_else(String::new, |error| error.message().to_owned())
    })
}

/// Holds the ends of a range and a unit to what the reader says of a value too large.
fn check_range(at: &str, ends: Option<[f64; 2]>, unit: &str, refusals: &[String]) {
    let is_checked = |refusal: &String| refusal.contains("is not between");
    let Some([from, to]) = ends else {
        let is_free = !refusals.iter().any(is_checked);
        assert!(is_free, "{at} has a range: {refusals:?}");
        return;
    };
    let space = if unit.is_empty() { "" } else { " " };
    let expected = [
        format!("is not between {from} and {to}{space}{unit}"),
        format!("is out of range: {from} to {to}"),
        format!("more than {to}"),
    ];
    let is_expected = |refusal: &String| expected.iter().any(|words| refusal.contains(words));
    assert!(
        refusals.iter().any(is_expected),
        "{at}: {from} to {to} {unit}, but {refusals:?}"
    );
}

#[test]
fn the_schema_has_the_ranges_of_the_reader() {
    let types = Types::new();
    for chapter in &CHAPTERS {
        for (key, property) in types.keys(chapter) {
            let ends = [&property["minimum"], &property["maximum"]].map(Json::as_f64);
            let ends = match ends {
                [Some(from), Some(to)] => Some([from, to]),
                _ => None,
            };
            // Those of an axis are its own.
            let is_of_axis = chapter.heading == "An axis" && ends.is_none();
            if !OF_BASES.contains(&key.as_str()) && !is_of_axis {
                let at = format!("{}: {key}", chapter.heading);
                let unit = unit_of(&key).unwrap_or_default();
                check_range(&at, ends, unit, &refusals(chapter, &key));
            }
        }
    }
}

#[test]
fn the_schema_has_the_defaults_of_the_reader() {
    let types = Types::new();
    for chapter in &CHAPTERS {
        for (key, property) in types.keys(chapter) {
            let at = format!("{}: {key}", chapter.heading);
            let content =
                |value| -> Result<FileContent, _> { example_with(chapter, &key, value).try_into() };
            let without = content(None);
            if types.is_required(chapter, &key) {
                assert!(without.is_err(), "{at} has a default");
            } else if property["default"].is_null() {
                assert!(without.is_ok(), "{at} is required");
            } else {
                let value = Value::try_from(&property["default"]).unwrap();
                assert_eq!(content(Some(value)), without, "{at}");
            }
        }
    }
}
