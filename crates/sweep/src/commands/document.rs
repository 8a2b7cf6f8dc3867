//! `--json`: what a command found, as one JSON document on standard output, for programs.

use anyhow::Result;
use serde::ser::{SerializeMap, SerializeSeq};
use serde::{Serialize, Serializer};

use super::terminal::say;
use crate::program::PROGRAM;
use campaign::printable::printable_json;
use campaign::records::{Field, Kind};

/// Version of these documents. It rises where a field goes, or gets another name or meaning;
/// further fields do not change it.
const FORMAT_VERSION: u32 = 1;

/// What a command found, and what is needed to read that.
#[derive(Serialize)]
struct Document<'a, T> {
    command: &'a str,
    format_version: u32,
    program: &'static str,
    #[serde(flatten)]
    found: &'a T,
}

/// The document of a command on one line. Numbers read back exactly; those that are not finite are
/// null.
///
/// # Errors
/// Where what was found has no form in JSON.
pub fn document(command: &str, found: &impl Serialize) -> Result<String> {
    let json = serde_json::to_string(&Document {
        command,
        format_version: FORMAT_VERSION,
        program: PROGRAM,
        found,
    })?;
    Ok(printable_json(&json).into_owned() + "\n")
}

/// Prints it.
///
/// # Errors
/// As [`document`], and where standard output cannot be written.
pub fn say_document(command: &str, found: &impl Serialize) -> Result<()> {
    say(&document(command, found)?)
}

/// Rows of a table as objects by the names of its columns.
pub struct ByColumn<'a, const COLUMNS: usize> {
    /// Names of the columns.
    pub columns: &'a [(&'static str, Kind); COLUMNS],
    /// The rows.
    pub rows: Vec<[Field<'a>; COLUMNS]>,
}

impl<const COLUMNS: usize> Serialize for ByColumn<'_, COLUMNS> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut rows = serializer.serialize_seq(Some(self.rows.len()))?;
        for row in &self.rows {
            rows.serialize_element(&Row(self.columns, row))?;
        }
        rows.end()
    }
}

struct Row<'a, const COLUMNS: usize>(
    &'a [(&'static str, Kind); COLUMNS],
    &'a [Field<'a>; COLUMNS],
);

impl<const COLUMNS: usize> Serialize for Row<'_, COLUMNS> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(COLUMNS))?;
        for ((name, _), field) in self.0.iter().zip(self.1) {
            map.serialize_entry(name, field)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_document_is_one_line_whose_numbers_read_back_exactly() {
        #[derive(Serialize)]
        struct Found {
            numbers: [f64; 4],
            text: &'static str,
        }
        let found = Found {
            numbers: [0.1 + 0.2, 1e-320, f64::NAN, f64::INFINITY],
            text: "a\nb\u{1b}\u{202e}",
        };
        let text = document("summary", &found).expect("a document");
        assert_eq!(text.matches('\n').count(), 1, "{text}");
        assert!(!text.contains('\u{202e}'), "{text}");
        let read: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(read["numbers"][0].to_string(), "0.30000000000000004");
        let tiny: f64 = read["numbers"][1].to_string().parse().expect("a number");
        assert_eq!(tiny, 1e-320);
        assert!(read["numbers"][2].is_null() && read["numbers"][3].is_null());
        assert_eq!(read["text"], found.text);
        assert_eq!(read["format_version"], 1);
    }
}
