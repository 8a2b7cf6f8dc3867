//! A sweep file and its bases as one table that still knows on which line of
//! which file each value stands.

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::error::SweepFileError;
use super::in_file_units::FileUnits;
use super::placed::{LineNumbers, Placed, Twice};
use super::rivals::{RIVALS, Rivals};
use super::units::key_in_si;
use super::wording::{in_words, keys_of};
use crate::quantities::{Axis, within};
use crate::text_file::LARGEST_SWEEP_FILE;

/// More files than this, each the base of the one before, are a mistake.
const MOST_FILES: usize = 64;

/// The key of a table that says what one in SI units does, in any unit.
fn key_as_written<'a, 'text>(
    table: &'a DeTable<'text>,
    name: &str,
) -> Option<&'a Spanned<DeString<'text>>> {
    let says_the_same = |key: &&Spanned<DeString>| {
        let key = key.get_ref().as_ref();
        key == name || key_in_si(key).is_some_and(|(in_si, _)| in_si == name)
    };
    table.keys().find(says_the_same)
}

pub use crate::text_file::TextOf;

/// The merged table of a sweep file and its bases.
#[derive(Debug, Clone)]
pub struct Source {
    /// Shared by copies of a sweep.
    merged: Arc<Placed>,
    files: Vec<PathBuf>,
    /// Their bytes.
    size: u64,
}

/// An error about an unknown key, which is called as the file has it.
fn as_written(mut error: SweepFileError, key: &str) -> SweepFileError {
    let written = error.key.clone().unwrap_or_default();
    let [name, written] = [key, &written]
        .map(|key| format!("unknown key `{}`", key.rsplit('.').next().unwrap_or(key)));
    error.message = error.message.replacen(&name, &written, 1);
    error
}

impl Source {
    /// Reads a sweep file and, first, the file it names as its `base`.
    ///
    /// # Errors
    /// Where a file cannot be read or is not TOML, or the bases go in a circle.
    pub fn read(path: &Path, text_of: TextOf) -> Result<Self, SweepFileError> {
        let mut source = Self {
            merged: Arc::default(),
            files: Vec::new(),
            size: 0,
        };
        source.add_file(path, text_of)?;
        Ok(source)
    }

    /// Puts a value in place of what the files say at a key of their top level.
    pub fn put(&mut self, key: &str, value: toml::Value) {
        Arc::make_mut(&mut self.merged).remove(key);
        Arc::make_mut(&mut self.merged)
            .table
            .insert(key.to_owned(), value);
    }

    /// Puts a value into a table, as if it stood where another key of it does.
    pub fn put_next_to(&mut self, table: &str, neighbour: &str, key: &str, value: toml::Value) {
        Arc::make_mut(&mut self.merged).put_next_to(table, neighbour, key, value);
    }

    /// What the files say at a key of a table, where they say anything.
    pub fn value_at(&self, table: &str, key: &str) -> Option<&toml::Value> {
        self.merged.table.get(table)?.get(key)
    }

    /// The same, where it is a text.
    pub fn text_at(&self, table: &str, key: &str) -> Option<String> {
        self.value_at(table, key)?.as_str().map(str::to_owned)
    }

    /// Bytes of the sweep file and its bases.
    pub fn bytes(&self) -> u64 {
        self.size
    }

    /// Whether the files give a key of their top level.
    pub fn gives(&self, key: &str) -> bool {
        self.merged.table.contains_key(key)
    }

    /// Whether they give a key of a table in a table.
    pub fn gives_within(&self, [outer, inner]: [&str; 2], key: &str) -> bool {
        let table = self.value_at(outer, inner);
        table.and_then(|table| table.get(key)).is_some()
    }

    /// Whether they give a key, by its path of tables, `string.bending.damping_ns_m2`.
    pub fn gives_path(&self, path: &str) -> bool {
        let (first, rest) = path.split_once('.').unwrap_or((path, ""));
        let names = rest.split('.').filter(|name| !name.is_empty());
        let first = self.merged.table.get(first);
        names.fold(first, |table, name| table?.get(name)).is_some()
    }

    /// Whether the sweep file itself gives a key of its top level, not a base of it.
    pub fn gives_itself(&self, key: &str) -> bool {
        let place = self.merged.find(key).map(|(place, _)| place.file);
        self.gives(key) && place == Some(0)
    }

    /// The sweep file itself.
    pub fn file(&self) -> &Path {
        &self.files[0]
    }

    /// The folder of the file that gives `key`, where files it names are.
    pub fn folder_of(&self, key: &str) -> &Path {
        let file = self.merged.find(key).map_or(0, |(place, _)| place.file);
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
            let (key, message) = in_words(&path, &message, &keys_of::<T>());
            as_written(self.error(&key, message), &key)
        })
    }

    /// An error about the value at `key`, with numbers and keys in the units of the file; where it is
    /// not given, about the table around it.
    pub fn error(&self, key: &str, message: impl Into<String>) -> SweepFileError {
        let are_field =
            self.merged.table.get("units").and_then(toml::Value::as_str) == Some("field");
        let mut error = self.error_verbatim(key, message);
        let units = FileUnits::new(are_field, error.key.as_deref().unwrap_or_default());
        error.message = units.convert(&error.message);
        if error.file != self.files[0] && error.message.contains("leave it out") {
            let sweep = self.files[0].display();
            // Keys are taken out, not single entries of lists.
            let key = key.split('[').next().unwrap_or(key);
            error.message += &format!(" (`without = [{key:?}]` in {sweep})");
        }
        error
    }

    /// The same with a message as it is, such as one about another file.
    pub fn error_verbatim(&self, key: &str, message: impl Into<String>) -> SweepFileError {
        let (place, key) = match self.merged.find(key) {
            Some((place, written)) => (Some(place), written),
            None => (None, key.to_owned()),
        };
        SweepFileError {
            file: self.files[place.map_or(0, |place| place.file)].clone(),
            line: place.map(|place| place.line),
            key: Some(key),
            message: message.into(),
        }
    }

    /// Refuses the value at `key` where it is wrong.
    ///
    /// # Errors
    /// Where it is.
    pub fn refuse_if(
        &self,
        is_wrong: bool,
        key: &str,
        message: impl Into<String>,
    ) -> Result<(), SweepFileError> {
        if is_wrong {
            return Err(self.error(key, message));
        }
        Ok(())
    }

    /// What a check says of the value at `key`.
    ///
    /// # Errors
    /// What the check says, with the place.
    pub fn checked<T>(
        &self,
        key: &str,
        result: Result<T, impl Display>,
    ) -> Result<T, SweepFileError> {
        result.map_err(|error| self.error(key, error.to_string()))
    }

    /// Refuses a value at `key` that a quantity does not have.
    ///
    /// # Errors
    /// Where it does not.
    pub fn check_axis(&self, key: &str, axis: Axis, value: f64) -> Result<(), SweepFileError> {
        self.checked(key, axis.check(value))
    }

    /// The value at `key`, which is in a range.
    ///
    /// # Errors
    /// Where it is not.
    pub fn within(
        &self,
        key: &str,
        value: f64,
        least: f64,
        most: f64,
        unit: &'static str,
    ) -> Result<f64, SweepFileError> {
        self.checked(key, within(value, least, most, unit).map(|()| value))
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
            let no_base = |message: String| unusable(Some(line), Some("base"), message);
            let DeValue::String(base) = value.get_ref() else {
                return Err(no_base("names a file, so it is a string".to_owned()));
            };
            let base = path.parent().unwrap_or(Path::new("")).join(base.as_ref());
            if let Some(reason) = self.reason_against(&base) {
                return Err(no_base(reason));
            }
            self.add_file(&base, text_of)
                .map_err(|error| match error.line {
                    None => no_base(error.to_string()),
                    Some(_) => error,
                })?;
        }
        let given = table.get_ref();
        if let Some((key, value)) = given.get_key_value("without") {
            let line = lines.of(key.span().start);
            let refused = |message: String| unusable(Some(line), Some("without"), message);
            let paths = value.get_ref().as_array();
            for path in paths.ok_or_else(|| refused("is a list of keys of the base".to_owned()))? {
                let DeValue::String(path) = path.get_ref() else {
                    return Err(refused(
                        "names keys of the base, so they are strings".to_owned(),
                    ));
                };
                if !Arc::make_mut(&mut self.merged).take_out(path) {
                    return Err(refused(format!("the base has no `{path}`")));
                }
            }
        }
        for Rivals(table, one, other) in RIVALS {
            let around = match table {
                "" => Some(given),
                name => given.get(name).and_then(|value| value.get_ref().as_table()),
            };
            let Some(around) = around else {
                continue;
            };
            match [one, other].map(|name| key_as_written(around, name)) {
                [Some(key), Some(other)] => {
                    let line = lines.of(key.span().start);
                    let other = other.get_ref();
                    let message = format!("conflicts with `{other}`: give only one");
                    return Err(unusable(Some(line), Some(key.get_ref()), message));
                }
                [Some(_), None] => Arc::make_mut(&mut self.merged).remove_in(table, other),
                [None, Some(_)] => Arc::make_mut(&mut self.merged).remove_in(table, one),
                [None, None] => {}
            }
        }
        Arc::make_mut(&mut self.merged)
            .lay_over(given, file, &lines)
            .map_err(|Twice { line, key, other }| {
                let message = format!("says the same as `{other}`; give one of them");
                unusable(Some(line), Some(&key), message)
            })
    }

    /// Why a file is refused as a base, if it is.
    fn reason_against(&self, base: &Path) -> Option<String> {
        let same = |path: &Path| std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let file = same(base);
        if self.files.iter().any(|known| same(known) == file) {
            let base = base.display();
            return Some(format!(
                "the bases go in a circle: {base} would be its own base"
            ));
        }
        (self.files.len() >= MOST_FILES).then(|| {
            format!("there are more than {MOST_FILES} files, each the base of the one before")
        })
    }
}
