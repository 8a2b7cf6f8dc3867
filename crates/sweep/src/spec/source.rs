//! A sweep file and its bases as one table that still knows on which line of
//! which file each value stands.

use std::collections::HashMap;
use std::fmt;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::printable::steers;

/// A base of a base of a base is deep enough; more is a circle.
const DEEPEST_BASE: usize = 8;

/// Keys that say the same in another way: a file gives one of each pair, and it
/// replaces the other of its base.
const RIVALS: [(&str, &str); 3] = [
    ("accuracy", "methods"),
    ("accuracy", "method"),
    ("accuracy", "sampling_frequency_hz"),
];

/// Gives the text of a file: from the disk or, in tests, from memory.
pub type TextOf<'a> = &'a dyn Fn(&Path) -> std::io::Result<String>;

/// One clear sentence about a sweep file that cannot be used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SpecError {
    file: PathBuf,
    line: Option<usize>,
    key: Option<String>,
    message: String,
}

impl SpecError {
    /// What is wrong, without the place.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for SpecError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = self.file.display();
        let line = self
            .line
            .map_or_else(String::new, |line| format!(":{line}"));
        let key = (self.key.as_ref()).map_or_else(String::new, |key| format!(": `{key}`"));
        let text = format!("{file}{line}{key}: {}", self.message);
        // What the file says in quotes may not break the line or steer a terminal.
        f.write_str(&text.replace(steers, " "))
    }
}

impl std::error::Error for SpecError {}

/// Where a value stands.
#[derive(Debug, Clone, Copy)]
struct Place {
    file: usize,
    line: usize,
}

/// The merged table of a sweep file and its bases.
#[derive(Debug, Clone)]
pub struct Source {
    table: toml::Table,
    files: Vec<PathBuf>,
    /// Key path (`string.sections[0].repeat`) to place.
    places: HashMap<String, Place>,
}

impl Source {
    /// Reads a sweep file and, first, the file it names as its `base`.
    ///
    /// # Errors
    /// Where a file cannot be read or is not TOML, or the bases go in a circle.
    pub fn read(path: &Path, text_of: TextOf) -> Result<Self, SpecError> {
        let mut source = Self {
            table: toml::Table::new(),
            files: Vec::new(),
            places: HashMap::new(),
        };
        source.add_file(path, text_of)?;
        Ok(source)
    }

    /// Puts a value in place of what the files say at a key of their top level.
    pub fn put(&mut self, key: &str, value: toml::Value) {
        self.replace(key);
        self.table.insert(key.to_owned(), value);
    }

    /// Whether the files give a key of their top level.
    pub fn gives(&self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// The folder of the file that gives `key`, where files it names are.
    pub fn folder_of(&self, key: &str) -> &Path {
        let file = self.places.get(key).map_or(0, |place| place.file);
        self.files[file].parent().unwrap_or(Path::new(""))
    }

    /// The merged table as a typed value.
    ///
    /// # Errors
    /// Where a key is unknown or missing or a value has another type.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, SpecError> {
        serde_path_to_error::deserialize(self.table.clone()).map_err(|error| {
            let path = error.path().to_string();
            let message = error.into_inner().message().trim().to_owned();
            self.type_error(&path, &message, &keys_of::<T>())
        })
    }

    /// An error about the value at `key`; where it is not given, about the
    /// table around it.
    pub fn error(&self, key: &str, message: impl Into<String>) -> SpecError {
        let mut known = key;
        let place = loop {
            match (self.places.get(known), known.rfind(['.', '['])) {
                (Some(place), _) => break Some(*place),
                (None, Some(end)) => known = &known[..end],
                (None, None) => break None,
            }
        };
        SpecError {
            file: self.files[place.map_or(0, |place| place.file)].clone(),
            line: place.map(|place| place.line),
            key: Some(key.to_owned()),
            message: message.into(),
        }
    }

    /// Serde's words in the user's: what was meant by an unknown key or
    /// choice, what is missing, what was expected. A key of the file itself may
    /// have slipped into the table above it.
    fn type_error(&self, path: &str, message: &str, file_keys: &[String]) -> SpecError {
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

    fn add_file(&mut self, path: &Path, text_of: TextOf) -> Result<(), SpecError> {
        let file = self.files.len();
        self.files.push(path.to_owned());
        let unusable = |line, key: Option<&str>, message: String| SpecError {
            file: path.to_owned(),
            line,
            key: key.map(str::to_owned),
            message,
        };
        let text = text_of(path)
            .map_err(|error| unusable(None, None, format!("cannot be read: {error}")))?;
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
            if self.files.len() > DEEPEST_BASE {
                let message = "the bases go in a circle".to_owned();
                return Err(unusable(Some(line), Some("base"), message));
            }
            let base = path.parent().unwrap_or(Path::new("")).join(base.as_ref());
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
                (Some(_), false) => self.replace(other),
                (None, true) => self.replace(one),
                (None, false) => {}
            }
        }
        let merged = std::mem::take(&mut self.table);
        self.table = self.merge(file, &lines, merged, table.get_ref(), "");
        Ok(())
    }

    /// Lays `over` on `under`: tables key by key, anything else as a whole, and
    /// a `[design]` as a whole too.
    fn merge(
        &mut self,
        file: usize,
        lines: &LineNumbers,
        mut under: toml::Table,
        over: &DeTable,
        path: &str,
    ) -> toml::Table {
        for (key, value) in over {
            let key_path = join(path, key.get_ref());
            if key_path == "base" {
                continue;
            }
            let line = lines.of(key.span().start);
            let below = match (value.get_ref(), under.remove(key.get_ref().as_ref())) {
                (DeValue::Table(_), Some(toml::Value::Table(below))) if key_path != "design" => {
                    Some(below)
                }
                (_, Some(_)) => {
                    self.forget(&key_path);
                    None
                }
                (_, None) => None,
            };
            self.places.insert(key_path.clone(), Place { file, line });
            let merged = self.value(file, lines, below, value, &key_path);
            under.insert(key.get_ref().to_string(), merged);
        }
        under
    }

    fn value(
        &mut self,
        file: usize,
        lines: &LineNumbers,
        below: Option<toml::Table>,
        value: &Spanned<DeValue>,
        path: &str,
    ) -> toml::Value {
        match value.get_ref() {
            DeValue::Table(table) => {
                toml::Value::Table(self.merge(file, lines, below.unwrap_or_default(), table, path))
            }
            DeValue::Array(items) => {
                let items = items.iter().enumerate().map(|(index, item)| {
                    let path = format!("{path}[{index}]");
                    let line = lines.of(item.span().start);
                    self.places.insert(path.clone(), Place { file, line });
                    self.value(file, lines, None, item, &path)
                });
                toml::Value::Array(items.collect())
            }
            scalar => plain(scalar),
        }
    }

    /// Takes out what a base gave at a key that another replaces.
    fn replace(&mut self, key: &str) {
        self.table.remove(key);
        self.forget(key);
    }

    /// Forgets the places of a value that is replaced as a whole.
    fn forget(&mut self, key: &str) {
        self.places.retain(|path, _| {
            !path
                .strip_prefix(key)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        });
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

/// A scalar without its place. A whole number too large for its type becomes
/// the nearest other one, which is refused at its place unless it makes sense.
fn plain(value: &DeValue) -> toml::Value {
    match value {
        DeValue::String(text) => toml::Value::String(text.to_string()),
        DeValue::Boolean(choice) => toml::Value::Boolean(*choice),
        DeValue::Datetime(time) => toml::Value::Datetime(*time),
        DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix())
            .map_or_else(
                |_| toml::Value::Float(number.as_str().parse().unwrap_or(f64::INFINITY)),
                toml::Value::Integer,
            ),
        DeValue::Float(number) => number.as_str().parse().map_or_else(
            |_| toml::Value::String(number.to_string()),
            toml::Value::Float,
        ),
        DeValue::Array(_) | DeValue::Table(_) => toml::Value::Table(toml::Table::new()),
    }
}

/// Byte offsets to line numbers.
struct LineNumbers {
    starts: Vec<usize>,
}

impl LineNumbers {
    fn new(text: &str) -> Self {
        let after_breaks = text.match_indices('\n').map(|(at, _)| at + 1);
        Self {
            starts: std::iter::once(0).chain(after_breaks).collect(),
        }
    }

    fn of(&self, offset: usize) -> usize {
        self.starts.partition_point(|&start| start <= offset)
    }
}
