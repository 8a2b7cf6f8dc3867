//! `[string] file`: a BHA sheet, as CSV or a spreadsheet, in the place of the sections. Columns
//! are found by name and unit; every row becomes a section, held against its weight.

mod columns;
mod joints;
mod rows;

use std::path::Path;

use toml::Value;

use super::error::SweepFileError;
use super::source::{Source, TextOf};
use crate::quantities::Units;
use crate::sweep_file::cells::Cells;
use columns::Columns;
use rows::{Row, rows_of};

pub use joints::Told;

/// What a sheet's weights come to, and what is passed over of it.
#[derive(Debug, Clone, Default)]
pub struct SheetNotes {
    /// The sheet, as the file names it.
    pub file: String,
    /// What each row with a weight comes to.
    pub rows: Vec<Told>,
    /// Names of columns that say nothing here.
    pub passed_over: Vec<String>,
}

/// Puts the sections of the sheet that the file names, if it does, in the place of its own.
///
/// # Errors
/// Where the sheet cannot be read, lacks a column, or has a row that is no tube; the message
/// names its line.
pub fn put_sections(
    source: &mut Source,
    text_of: TextOf,
) -> Result<Option<SheetNotes>, SweepFileError> {
    let Some(file) = source.text_at("string", "file") else {
        let message = "says in which order the rows of a `file` are: there is none";
        let is_idle = source.value_at("string", "order").is_some();
        source.refuse_if(is_idle, "string.order", message)?;
        return Ok(None);
    };
    // What else is missing is told where the whole file is read.
    let density = source.value_at("string", "density_kg_m3");
    let Some(density) = density.and_then(number).filter(|density| *density > 0.0) else {
        return Ok(None);
    };
    let path = source.folder_of("string.file").join(&file);
    let (sections, rows, passed_over) =
        read(&path, density, text_of).map_err(|message| source.error("string.file", message))?;
    let mut sections: Vec<(Value, Told)> = sections.into_iter().zip(rows).collect();
    // What else it may say is refused where the whole file is read.
    if source.text_at("string", "order").as_deref() == Some("from-bit") {
        sections.reverse();
    }
    let (sections, rows) = sections.into_iter().unzip();
    source.put_beside("string", "file", "sections", Value::Array(sections));
    Ok(Some(SheetNotes {
        file,
        rows,
        passed_over,
    }))
}

impl SheetNotes {
    /// What the weights of rows come to that are not those of their dimensions.
    pub fn lines(&self, units: Units) -> impl Iterator<Item = String> {
        let words = move |row: &Told| Some(format!("{}: {}", row.name, row.words(units)?));
        self.rows.iter().filter_map(words)
    }

    /// What is doubtful, each with its place.
    pub fn doubts(&self, units: Units) -> impl Iterator<Item = String> {
        let doubtful = self.rows.iter().filter(|row| row.is_doubtful());
        let rows = doubtful.filter_map(move |row| {
            let (file, line, name) = (&self.file, row.line, &row.name);
            Some(format!("{file}:{line}: {name}: {}", row.words(units)?))
        });
        let passed_over = (!self.passed_over.is_empty()).then(|| {
            let names = self.passed_over.join("`, `");
            format!("{}: columns that say nothing here: `{names}`", self.file)
        });
        passed_over.into_iter().chain(rows)
    }
}

type Read = (Vec<Value>, Vec<Told>, Vec<String>);

/// Sections in the order of the sheet, what each row comes to, and columns passed over.
fn read(path: &Path, density: f64, text_of: TextOf) -> Result<Read, String> {
    let name = path.display();
    let cells = Cells::read(path, text_of).map_err(|reason| format!("{name}{reason}"))?;
    let columns = Columns::find(&cells.header)
        .map_err(|message| format!("{name}:{}: {message}", cells.header_line))?;
    let rows: Vec<Row> = rows_of(&cells, &columns).map_err(|reason| format!("{name}:{reason}"))?;
    if rows.is_empty() {
        return Err(format!("{name} has no row"));
    }
    let (sections, told) = (rows.iter())
        .map(|row| joints::section(row, density).map_err(|reason| format!("{name}:{reason}")))
        .collect::<Result<(Vec<Value>, Vec<Told>), String>>()?;
    Ok((sections, told, columns.passed_over))
}

fn number(value: &Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|number| number as f64))
}
