//! `[string] file`: a BHA sheet, as CSV or a spreadsheet, in the place of the sections. Columns
//! are found by name and unit; every row becomes a section, held against its weight.

mod bit_size;
mod columns;
mod joints;
mod kind;
mod rows;

use std::path::Path;

use serde::Serialize;
use toml::Value;

use super::error::SweepFileError;
use super::source::{Source, TextOf};
use crate::quantities::Units;
use crate::tables::Table;
use crate::words::counted;
use columns::{NO_LENGTH, Quantity, SheetColumns, WANTED};
use kind::{MUD_MOTOR, is_from_bit, not_modelled};
use rows::{SheetRow, rows_of};

pub use bit_size::diameter_in_name;
pub use joints::WeightCheck;
pub use kind::ToolKind;

/// How a sheet's weights were treated, and what is ignored of it.
#[derive(Debug, Clone, Default, Serialize)]
pub struct SheetNotes {
    /// The sheet, as the file names it.
    pub file: String,
    /// The check of each row with a weight.
    #[serde(rename = "weights")]
    pub rows: Vec<WeightCheck>,
    /// Names of columns that are not used.
    #[serde(rename = "ignored_columns")]
    pub ignored: Vec<String>,
    /// Lines below the headings that begin with `#`, which are comments.
    #[serde(skip)]
    pub comments: Vec<usize>,
    /// Lines that add up others, which are ignored.
    #[serde(skip)]
    pub totals: Vec<usize>,
    /// Whether the rows are from the bit up, where they say so themselves.
    #[serde(skip)]
    pub order_inferred: Option<bool>,
}

/// Replaces the sections of the file by those of the sheet that it names, if it does.
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
    // What else is missing is reported where the whole file is read.
    let density = source.value_at("string", "density_kg_m3");
    let Some(density) = density.and_then(number).filter(|density| *density > 0.0) else {
        return Ok(None);
    };
    let path = source.folder_of("string.file").join(&file);
    let mut sheet = read(&path, density, text_of)
        .map_err(|message| source.error_verbatim("string.file", message))?;
    // What else it may say is refused where the whole file is read.
    let given = source.text_at("string", "order");
    let (order_inferred, is_from_bit) = match given.as_deref() {
        Some(order) => (None, order == "from-bit"),
        None if sheet.sections.len() == 1 => (None, false),
        None => {
            let kinds: Vec<ToolKind> = sheet.rows.iter().map(|row| row.kind).collect();
            let Some(is_from_bit) = is_from_bit(&kinds) else {
                let message = format!(
                    "{}: its rows do not say whether they are from the surface down or from the bit \
                     up: give `order = \"from-surface\"` or `order = \"from-bit\"`",
                    path.display()
                );
                return Err(source.error("string.file", message));
            };
            (Some(is_from_bit), is_from_bit)
        }
    };
    if is_from_bit {
        sheet.sections.reverse();
        sheet.rows.reverse();
    }
    source.put_next_to("string", "file", "sections", Value::Array(sheet.sections));
    Ok(Some(SheetNotes {
        file,
        rows: sheet.rows,
        ignored: sheet.ignored,
        comments: sheet.comments,
        totals: sheet.totals,
        order_inferred,
    }))
}

impl SheetNotes {
    /// How weights of rows that differ from those of their dimensions were treated.
    pub fn lines(&self, units: Units) -> impl Iterator<Item = String> {
        let words = move |row: &WeightCheck| Some(format!("{}: {}", row.name, row.words(units)?));
        self.rows.iter().filter_map(words)
    }

    /// What is doubtful, each with its place, of a file that says what its mud motor does or has none.
    pub fn doubts(&self, units: Units, has_motor: bool) -> Vec<String> {
        let place = |row: &WeightCheck, words: &str| {
            format!("{}:{}: {}: {words}", self.file, row.line, row.name)
        };
        let mut doubts = Vec::new();
        if !self.ignored.is_empty() {
            let names = self.ignored.join("`, `");
            doubts.push(format!("{}: ignored columns: `{names}`", self.file));
        }
        for row in &self.rows {
            if row.is_doubtful() {
                doubts.extend(row.words(units).map(|words| place(row, &words)));
            }
            let tool = not_modelled(&row.name);
            if let Some(tool) = tool.filter(|tool| !(has_motor && *tool == MUD_MOTOR)) {
                let remedy = match tool == MUD_MOTOR {
                    true => "; give its chart as [motor]",
                    false => "",
                };
                let words = format!(
                    "{tool} is a tube of its dimensions here, and what it does is not modelled: labels \
                     of such a string are to be doubted{remedy}"
                );
                doubts.push(place(row, &words));
            }
        }
        doubts
    }

    /// What was inferred from the sheet.
    pub fn notes(&self) -> Vec<String> {
        let order = self.order_inferred.map(|is_from_bit| {
            let (order, key) = match is_from_bit {
                true => ("from the bit up", "from-bit"),
                false => ("from the surface down", "from-surface"),
            };
            format!(
                "{}: its rows are {order}, by what they are called (`order = \"{key}\"`)",
                self.file
            )
        });
        let comments =
            (!self.comments.is_empty()).then(|| comments_words(&self.file, &self.comments));
        let totals = self.totals.iter();
        let totals = totals.map(|line| format!("{}:{line}: a total, ignored", self.file));
        order.into_iter().chain(comments).chain(totals).collect()
    }
}

/// How many lines of a table were ignored as comments.
pub fn comments_words(file: &str, lines: &[usize]) -> String {
    let first = lines.first().copied().unwrap_or_default();
    let count = counted(lines.len(), "line");
    format!("{file}:{first}: {count} below the headings ignored as comments, which begin with `#`")
}

/// A sheet, in its order.
struct Sheet {
    sections: Vec<Value>,
    rows: Vec<WeightCheck>,
    ignored: Vec<String>,
    comments: Vec<usize>,
    totals: Vec<usize>,
}

fn read(path: &Path, density: f64, text_of: TextOf) -> Result<Sheet, String> {
    let name = path.display();
    let is_header = |headings: &[_]| SheetColumns::are_in(headings, &WANTED);
    let table =
        Table::read(path, text_of, &is_header).map_err(|reason| format!("{name}{reason}"))?;
    let refused = |message: String| {
        let (line, names) = (table.header_line, table.names());
        format!("{name}:{line}: {message}; {names}")
    };
    let is_numeric = |place| table.is_numeric(place);
    let columns = SheetColumns::find(&table.headings, &WANTED, &is_numeric).map_err(refused)?;
    let has = |quantity| columns.get(quantity).is_some();
    if !has(Quantity::Length) && !has(Quantity::JointLength) {
        return Err(refused(NO_LENGTH.to_owned()));
    }
    let (rows, totals): (Vec<SheetRow>, _) =
        rows_of(&table, &columns).map_err(|reason| format!("{name}:{reason}"))?;
    if rows.is_empty() {
        return Err(format!("{name} has no row"));
    }
    let (sections, rows) = (rows.iter())
        .map(|row| joints::section(row, density).map_err(|reason| format!("{name}:{reason}")))
        .collect::<Result<(Vec<Value>, Vec<WeightCheck>), String>>()?;
    Ok(Sheet {
        sections,
        rows,
        ignored: columns.ignored,
        comments: table.comments,
        totals,
    })
}

fn number(value: &Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|number| number as f64))
}
