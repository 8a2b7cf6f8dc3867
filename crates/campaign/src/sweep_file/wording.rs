//! What the reader of keys says of a mistake, in the user's words.

use serde::de::DeserializeOwned;
use thiserror::Error;

use crate::quantities::Axis;

/// The key and the sentence of an error that Serde tells of a path: what was meant by an
/// unknown key or choice, what is missing, what was expected. A key of the file itself
/// may have slipped into the table above it.
pub fn in_words(path: &str, message: &str, file_keys: &[String]) -> (String, String) {
    let path = if path == "." { "" } else { path };
    let quoted: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    if let Some(missing) = message.strip_prefix("missing field ").and(quoted.first()) {
        return (join(path, missing), "is missing".to_owned());
    }
    if let Some((found, expected)) = message
        .strip_prefix("invalid type: ")
        .or(message.strip_prefix("invalid value: "))
        .and_then(|words| words.rsplit_once(", expected "))
    {
        let is_choice = expected == CHOICE;
        let (found, expected) = (kind(found), kind(expected));
        let mut message = format!("expected {expected}, found {found}");
        // A list, such as that of the sites, below the table of its choices.
        let name = path.rsplit_once('.').map(|(_, name)| name);
        if is_choice && file_keys.iter().any(|key| Some(key.as_str()) == name) {
            message += "; a list belongs above the first [table] of the file";
        }
        return (path.to_owned(), message);
    }
    let Some(unknown) = message.strip_prefix("unknown ").and(quoted.first()) else {
        return (path.to_owned(), message.to_owned());
    };
    let what = if message.starts_with("unknown field") {
        "unknown key"
    } else {
        "unknown choice"
    };
    let choices = &quoted[1..];
    let is_misplaced = what == "unknown key" && file_keys.iter().any(|key| key == unknown);
    let hint = match nearest(unknown, choices) {
        _ if is_misplaced => "it belongs above the first [table] of the file".to_owned(),
        Some(choice) => format!("did you mean `{choice}`?"),
        None => format!("known here: {}", choices.join(", ")),
    };
    let key = match what {
        "unknown choice" => path.to_owned(),
        _ if path.ends_with(unknown) => path.to_owned(),
        _ => join(path, unknown),
    };
    (key, format!("{what} `{unknown}`; {hint}"))
}

/// A name that is that of no axis, with what may have been meant.
#[derive(Debug, Error)]
#[error("unknown axis `{name}`; {hint}")]
pub struct UnknownAxis {
    name: String,
    hint: String,
}

/// The axis of a name that a person gave.
///
/// # Errors
/// Where there is none.
pub fn axis_named(name: &str) -> Result<Axis, UnknownAxis> {
    Axis::from_name(name).ok_or_else(|| UnknownAxis {
        name: name.to_owned(),
        hint: match nearest(name, &Axis::NAMES) {
            Some(known) => format!("did you mean `{known}`?"),
            None => format!("known: {}", Axis::NAMES.join(", ")),
        },
    })
}

/// The axis of a name, as [`axis_named`], or of its twin in field units; and what numbers under
/// that are multiplied by.
///
/// # Errors
/// What is meant, where there is none of this name.
pub fn axis_in_units(name: &str) -> Result<(Axis, f64), UnknownAxis> {
    match Axis::from_name(name)
        .is_none()
        .then(|| Axis::from_field_name(name))
    {
        Some(Some(found)) => Ok(found),
        _ => axis_named(name).map(|axis| (axis, 1.0)),
    }
}

/// What was meant by a word that is not among the choices: one without its unit, or
/// one misspelt.
pub fn nearest<'a>(word: &str, choices: &[&'a str]) -> Option<&'a str> {
    let begins = |choice: &&&str| {
        let rest = choice.strip_prefix(word);
        rest.is_some_and(|rest| rest.starts_with('_'))
    };
    let mut begun = choices.iter().filter(begins);
    if let (Some(choice), None) = (begun.next(), begun.next()) {
        return Some(choice);
    }
    // No word is nearer than it is longer or shorter: of a long one nothing needs to be compared.
    let letters = word.chars().count();
    let most = |choice: &str| choice.len() / 3 + 1;
    let near = choices
        .iter()
        .filter(|choice| choice.chars().count().abs_diff(letters) <= most(choice));
    let distances = near.map(|choice| (strsim::damerau_levenshtein(choice, word), *choice));
    let (distance, choice) = distances.min()?;
    (distance <= most(choice)).then_some(choice)
}

/// The keys that a table may have, as its reader names them when it finds another.
pub fn keys_of<T: DeserializeOwned>() -> Vec<String> {
    let unknown = toml::Table::from_iter([("?".to_owned(), toml::Value::Boolean(true))]);
    // As keys are read, so that no table is compiled twice.
    let Err(error) = serde_path_to_error::deserialize::<_, T>(unknown) else {
        return Vec::new();
    };
    let quoted = error.inner().message().split('`').skip(1).step_by(2);
    quoted.skip(1).map(str::to_owned).collect()
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// How Serde calls one of several words.
const CHOICE: &str = "string only";

/// The kinds of values as the user knows them.
fn kind(kind: &str) -> &str {
    match kind {
        "f64" => "a number",
        "u64" | "usize" => "a whole number, zero or more",
        "map" | "a map" => "a table",
        "sequence" | "a sequence" => "an array",
        CHOICE => "a string",
        "unit variant" => "another kind of value",
        _ if kind.starts_with("struct ") => "a table",
        _ => kind,
    }
}
