//! The tables of the page as the types have them.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value as Json;

use super::{CHAPTERS, Chapter, OF_BASES, PAGE};
use crate::quantities::unit_of;
use crate::sweep_file::schema::{of_sweep_files, of_types};

/// How the table of keys of a chapter begins.
const HEADER: &str = "| key | unit | default | range | is |\n|---|---|---|---|---|\n";

/// The schema of the types, in which tables are found by their paths.
pub struct Types(Json);

impl Types {
    pub fn new() -> Self {
        Self(of_types())
    }

    /// The definition that a schema is, or refers to.
    fn resolved<'a>(&'a self, schema: &'a Json) -> &'a Json {
        let name = schema["$ref"].as_str();
        name.map_or(schema, |name| &self.0["$defs"][type_name(name)])
    }

    /// The table at a path.
    fn table(&self, path: &str) -> &Json {
        let steps = path.split('.').filter(|step| !step.is_empty());
        steps.fold(&self.0, |table, step| {
            let is_item = step.parse::<usize>().is_ok();
            let found = match is_item {
                true => &table["items"],
                false => &table["properties"][step],
            };
            self.resolved(found)
        })
    }

    /// The keys of a chapter with their schemas.
    pub fn keys(&self, chapter: &Chapter) -> BTreeMap<String, Json> {
        let properties = self.table(chapter.path)["properties"].as_object();
        let mut keys: BTreeMap<String, Json> = (properties.unwrap().clone()).into_iter().collect();
        if chapter.path.is_empty() {
            for key in OF_BASES {
                let property = of_sweep_files()["properties"][key].clone();
                keys.insert(key.to_owned(), property);
            }
        }
        keys
    }

    /// Whether a key has no default.
    pub fn is_required(&self, chapter: &Chapter, key: &str) -> bool {
        let required = self.table(chapter.path)["required"].as_array();
        required.is_some_and(|required| required.iter().any(|name| name == key))
    }

    /// The row of a key in the page.
    fn row(&self, chapter: &Chapter, key: &str, property: &Json) -> String {
        let unit = unit_of(key).unwrap_or_default();
        let default = match &property["default"] {
            _ if self.is_required(chapter, key) => "required".to_owned(),
            Json::Null => "–".to_owned(),
            value => format!("`{value}`"),
        };
        let range = self.range(property);
        let description = property["description"].as_str().unwrap_or_default();
        let choices = self.choices(property).into_iter().map(|(word, means)| {
            let end = if means.ends_with('.') { "" } else { "." };
            format!(" `{word}`: {means}{end}")
        });
        let choices: String = choices.collect();
        let description = format!("{description}{choices}");
        let row = format!("| `{key}` | {unit} | {default} | {range} | {description} |\n");
        row.replace("|  |", "| |")
    }

    /// What a key may be.
    fn range(&self, property: &Json) -> String {
        match property["$ref"].as_str().map(type_name) {
            Some("Axis") => return "an axis".to_owned(),
            Some("Measure") => return "a measure".to_owned(),
            Some("Accuracy") => return "\"0.01 %\" to \"50 %\", or 0.0001 to 0.5".to_owned(),
            _ => {}
        }
        let bound = |keyword: &str| property[keyword].as_f64();
        let ends = [
            bound("minimum"),
            bound("exclusiveMinimum"),
            bound("maximum"),
        ];
        match ends {
            [Some(least), _, Some(most)] => return format!("{least} to {most}"),
            [_, Some(least), Some(most)] => return format!("above {least}, to {most}"),
            [Some(least), ..] => return format!("{least} or more"),
            [_, Some(least), _] => return format!("above {least}"),
            _ => {}
        }
        let choices = self.choices(property).into_iter();
        let choices: Vec<String> = choices.map(|(word, _)| format!("`{word}`")).collect();
        let choices = choices.join(", ");
        match self.resolved(property)["type"].as_str() {
            Some("boolean") => "`true`, `false`".to_owned(),
            Some("array") if !choices.is_empty() => format!("list of {choices}"),
            Some("array") => "list".to_owned(),
            Some("object") => "table".to_owned(),
            _ if !choices.is_empty() => choices,
            Some("string") => "text".to_owned(),
            _ => "a number".to_owned(),
        }
    }

    /// The words that a key, or an item of its list, may be, and what each means.
    fn choices(&self, property: &Json) -> Vec<(String, String)> {
        if property["$ref"].as_str().map(type_name) == Some("Measure") {
            return Vec::new();
        }
        let own = self.resolved(property);
        let schema = if own["items"].is_null() {
            own
        } else {
            self.resolved(&own["items"])
        };
        let choices = schema["oneOf"].as_array().into_iter().flatten();
        let text = |value: &Json| value.as_str().unwrap_or_default().to_owned();
        choices
            .map(|choice| (choice["const"].to_string(), text(&choice["description"])))
            .collect()
    }

    /// A page with the rows of every key, in the order that it has them, those that are new last.
    fn renewed(&self, page: &str) -> String {
        CHAPTERS.iter().fold(page.to_owned(), |page, chapter| {
            let heading = format!("\n## {}\n", chapter.heading);
            let start = page
                .find(&heading)
                .unwrap_or_else(|| panic!("no chapter {heading}"));
            let start = start + page[start..].find(HEADER).unwrap() + HEADER.len();
            let is_row = |line: &&str| line.starts_with("| `");
            let old: Vec<&str> = page[start..]
                .split_inclusive('\n')
                .take_while(is_row)
                .collect();
            let end = start + old.concat().len();
            let mut keys = self.keys(chapter);
            let mut rows = String::new();
            for line in old {
                let key = line.split('`').nth(1).unwrap();
                if let Some(property) = keys.remove(key) {
                    rows += &self.row(chapter, key, &property);
                }
            }
            for (key, property) in &keys {
                rows += &self.row(chapter, key, property);
            }
            format!("{}{rows}{}", &page[..start], &page[end..])
        })
    }
}

/// The name of a definition, of what refers to it.
fn type_name(reference: &str) -> &str {
    reference.rsplit('/').next().unwrap()
}

/// With `UPDATE_GUIDE=1` the page is written instead.
#[test]
fn the_tables_of_the_guide_are_those_of_the_types() {
    let renewed = Types::new().renewed(PAGE);
    if std::env::var_os("UPDATE_GUIDE").is_some() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/sweep-file.md");
        return std::fs::write(path, renewed).unwrap();
    }
    let lines = PAGE.lines().zip(renewed.lines());
    let differing: Vec<_> = lines
        .filter(|(page, types)| page != types)
        .take(3)
        .collect();
    assert!(
        renewed == PAGE,
        "docs/sweep-file.md is not what the types are: {differing:#?}\n\
         UPDATE_GUIDE=1 cargo test -p drillstring-campaign the_tables_of_the_guide"
    );
}

/// A table that is new has a chapter.
#[test]
fn every_table_of_the_types_has_a_chapter() {
    let types = Types::new();
    for (name, definition) in types.0["$defs"].as_object().unwrap() {
        let mut tables = CHAPTERS.iter().map(|chapter| types.table(chapter.path));
        let is_table = definition["properties"].is_object();
        assert!(
            !is_table || tables.any(|table| table == definition),
            "{name}"
        );
    }
}

#[test]
fn every_key_says_what_it_is() {
    let types = Types::new();
    for chapter in &CHAPTERS {
        for (key, property) in types.keys(chapter) {
            let description = property["description"].as_str().unwrap_or_default();
            let described = description.len() > "Where.".len();
            assert!(described, "{}: {key}", chapter.heading);
        }
    }
}
