//! A sweep file and its bases as one table that still knows on which line of
//! which file each value stands.

use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue};

use super::error::SweepFileError;
use super::placed::{LineNumbers, Placed};
use crate::quantities::{Axis, within};
use crate::text_file::LARGEST_SWEEP_FILE;

/// More files than this, each the base of the one before, are a mistake of whoever
/// writes them.
const MOST_FILES: usize = 64;

/// Keys that say the same in another way: a file gives one of each pair, and it
/// replaces the other of its base.
const RIVALS: [(&str, &str); 3] = [
    ("accuracy", "methods"),
    ("accuracy", "method"),
    ("accuracy", "sampling_frequency_hz"),
];

/// Gives the text of a file that has at most so many bytes: from the disk or, in
/// tests, from memory.
pub type TextOf<'a> = &'a dyn Fn(&Path, u64) -> std::io::Result<String>;

/// The merged table of a sweep file and its bases.
#[derive(Debug, Clone)]
pub struct Source {
    merged: Placed,
    files: Vec<PathBuf>,
    /// Their bytes.
    size: u64,
}

impl Source {
    /// Reads a sweep file and, first, the file it names as its `base`.
    ///
    /// # Errors
    /// Where a file cannot be read or is not TOML, or the bases go in a circle.
    pub fn read(path: &Path, text_of: TextOf) -> Result<Self, SweepFileError> {
        let mut source = Self {
            merged: Placed::default(),
            files: Vec::new(),
            size: 0,
        };
        source.add_file(path, text_of)?;
        Ok(source)
    }

    /// Puts a value in place of what the files say at a key of their top level.
    pub fn put(&mut self, key: &str, value: toml::Value) {
        self.merged.remove(key);
        self.merged.table.insert(key.to_owned(), value);
    }

    /// Whether the files give a key of their top level.
    pub fn gives(&self, key: &str) -> bool {
        self.merged.table.contains_key(key)
    }

    /// The folder of the file that gives `key`, where files it names are.
    pub fn folder_of(&self, key: &str) -> &Path {
        let file = self.merged.find(key).map_or(0, |place| place.file);
        self.files[file].parent().unwrap_or(Path::new(""))
    }

    /// The merged table as a typed value.
    ///
    /// # Errors
    /// Where a key is unknown or missing or a value has another type.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, SweepFileError> {
        serde_path_to_error::deserialize(self.merged.table.clone()).map_err(|error| {
            let path = error.path().to_string();
            let message = error.into_inner().message().trim().to_owned();
            self.type_error(&path, &message, &keys_of::<T>())
        })
    }

    /// An error about the value at `key`; where it is not given, about the
    /// table around it.
    pub fn error(&self, key: &str, message: impl Into<String>) -> SweepFileError {
        let place = self.merged.find(key);
        SweepFileError {
            file: self.files[place.map_or(0, |place| place.file)].clone(),
            line: place.map(|place| place.line),
            key: Some(key.to_owned()),
            message: message.into(),
        }
    }

    /// What a check says of the value at `key`.
    ///
    /// # Errors
    /// What the check says, with the place.
    pub fn checked<T>(&self, key: &str, result: Result<T, String>) -> Result<T, SweepFileError> {
        result.map_err(|message| self.error(key, message))
    }

    /// Refuses a value at `key` that a quantity cannot have.
    ///
    /// # Errors
    /// Where it cannot.
    pub fn check_axis(&self, key: &str, axis: Axis, value: f64) -> Result<(), SweepFileError> {
        self.checked(key, axis.check(value))
    }

    /// Refuses a value at `key` outside a range.
    ///
    /// # Errors
    /// Where it is.
    pub fn within(
        &self,
        key: &str,
        value: f64,
        least: f64,
        most: f64,
        unit: &str,
    ) -> Result<(), SweepFileError> {
        self.checked(key, within(value, least, most, unit))
    }

    /// An error about the sweep file as a whole.
    pub fn error_of_file(&self, message: impl Into<String>) -> SweepFileError {
        SweepFileError {
            file: self.files[0].clone(),
            line: None,
            key: None,
            message: message.into(),
        }
    }

    /// Serde's words in the user's: what was meant by an unknown key or
    /// choice, what is missing, what was expected. A key of the file itself may
    /// have slipped into the table above it.
    fn type_error(&self, path: &str, message: &str, file_keys: &[String]) -> SweepFileError {
        let path = if path == "." { "" } else { path };
        let quoted: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
        if let Some(missing) = message.strip_prefix("missing field ").and(quoted.first()) {
            return self.error(&join(path, missing), "is missing");
        }
        if let Some((found, expected)) = message
            .strip_prefix("invalid type: ")
            .or(message.strip_prefix("invalid value: "))
            .and_then(|words| words.rsplit_once(", expected "))
        {
            let (found, expected) = (in_words(found), in_words(expected));
            return self.error(path, format!("expected {expected}, found {found}"));
        }
        let Some(unknown) = message.strip_prefix("unknown ").and(quoted.first()) else {
            return self.error(path, message);
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
        self.error(&key, format!("{what} `{unknown}`; {hint}"))
    }

    fn add_file(&mut self, path: &Path, text_of: TextOf) -> Result<(), SweepFileError> {
        let file = self.files.len();
        self.files.push(path.to_owned());
        let unusable = |line, key: Option<&str>, message: String| SweepFileError {
            file: path.to_owned(),
            line,
            key: key.map(str::to_owned),
            message,
        };
        let text = text_of(path, LARGEST_SWEEP_FILE)
            .map_err(|error| unusable(None, None, format!("cannot be read: {error}")))?;
        self.size += text.len() as u64;
        if self.size > LARGEST_SWEEP_FILE {
            let most = LARGEST_SWEEP_FILE >> 20;
            let message = format!("this and what it is a base of are larger than {most} MiB");
            return Err(unusable(None, None, message));
        }
        let lines = LineNumbers::new(&text);
        let table = DeTable::parse(&text).map_err(|error| {
            let line = error.span().map(|span| lines.of(span.start));
            let message = match line.and_then(|line| text.lines().nth(line - 1)) {
                Some(text) => format!("{}: `{}`", error.message(), text.trim()),
                None => error.message().to_owned(),
            };
            unusable(line, None, message)
        })?;
        if let Some((key, value)) = table.get_ref().get_key_value("base") {
            let line = lines.of(key.span().start);
            let DeValue::String(base) = value.get_ref() else {
                let message = "names a file, so it is a string".to_owned();
                return Err(unusable(Some(line), Some("base"), message));
            };
            let base = path.parent().unwrap_or(Path::new("")).join(base.as_ref());
            self.refuse_circle(&base)
                .map_err(|message| unusable(Some(line), Some("base"), message))?;
            self.add_file(&base, text_of)
                .map_err(|error| match error.line {
                    None => unusable(Some(line), Some("base"), error.to_string()),
                    Some(_) => error,
                })?;
        }
        let given = table.get_ref();
        for (one, other) in RIVALS {
            match (given.get_key_value(one), given.contains_key(other)) {
                (Some((key, _)), true) => {
                    let line = lines.of(key.span().start);
                    let message = format!("is given instead of `{other}`, not beside it");
                    return Err(unusable(Some(line), Some(one), message));
                }
                (Some(_), false) => self.merged.remove(other),
                (None, true) => self.merged.remove(one),
                (None, false) => {}
            }
        }
        self.merged.lay_over(given, file, &lines);
        Ok(())
    }

    /// A file that is read already is no base of the last one.
    fn refuse_circle(&self, base: &Path) -> Result<(), String> {
        let same = |path: &Path| std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let file = same(base);
        if self.files.iter().any(|known| same(known) == file) {
            let base = base.display();
            return Err(format!(
                "the bases go in a circle: {base} would be its own base"
            ));
        }
        if self.files.len() >= MOST_FILES {
            return Err(format!(
                "there are more than {MOST_FILES} files, each the base of the one before"
            ));
        }
        Ok(())
    }
}

/// What was meant by a word that is none of the choices: one without its unit, or
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
    let distances = choices
        .iter()
        .map(|choice| (strsim::damerau_levenshtein(choice, word), *choice));
    let (distance, choice) = distances.min()?;
    (distance <= choice.len() / 3 + 1).then_some(choice)
}

/// The keys that a table may have, as its reader names them when it finds another.
pub(super) fn keys_of<T: DeserializeOwned>() -> Vec<String> {
    let unknown = toml::Table::from_iter([("?".to_owned(), toml::Value::Boolean(true))]);
    let Err(error) = unknown.try_into::<T>() else {
        return Vec::new();
    };
    let quoted = error.message().split('`').skip(1).step_by(2);
    quoted.skip(1).map(str::to_owned).collect()
}

fn join(path: &str, key: &str) -> String {
    if path.is_empty() {
        key.to_owned()
    } else {
        format!("{path}.{key}")
    }
}

/// The kinds of values as the user knows them.
fn in_words(kind: &str) -> &str {
    match kind {
        "f64" => "a number",
        "u64" | "usize" => "a whole number, zero or more",
        "map" | "a map" => "a table",
        "sequence" | "a sequence" => "an array",
        "string only" => "a string",
        "unit variant" => "another kind of value",
        _ if kind.starts_with("struct ") => "a table",
        _ => kind,
    }
}
