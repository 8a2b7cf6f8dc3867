//! The cells of a sheet: of a CSV file, or of the first sheet of a workbook.

use std::path::Path;

#[cfg(feature = "workbooks")]
use calamine::{Data, Reader, open_workbook_auto};

use super::source::TextOf;
use crate::hand_table::HandTable;
use crate::text_file::LARGEST_SWEEP_FILE;

/// Endings of workbooks that are read.
const WORKBOOKS: [&str; 5] = ["xlsx", "xlsm", "xlsb", "xls", "ods"];

/// The texts of a sheet, each row with its line.
pub struct Cells {
    /// Names of the columns.
    pub header: Vec<String>,
    /// Line of the header, from 1.
    pub header_line: usize,
    /// The rows below, with their lines.
    pub rows: Vec<(usize, Vec<String>)>,
}

impl Cells {
    /// Reads a sheet.
    ///
    /// # Errors
    /// Why it cannot be read; follows the file's name.
    pub fn read(path: &Path, text_of: TextOf) -> Result<Self, String> {
        let ending = path.extension().unwrap_or_default().to_string_lossy();
        if WORKBOOKS.contains(&ending.to_ascii_lowercase().as_str()) {
            return Self::of_workbook(path);
        }
        let text = text_of(path, LARGEST_SWEEP_FILE)
            .map_err(|error| format!(" cannot be read: {error}"))?;
        Self::of_text(&text)
    }

    fn of_text(text: &str) -> Result<Self, String> {
        let mistake = |mistake| format!(":{mistake}");
        let table = HandTable::new(text).map_err(mistake)?;
        let rows = table.rows().map(|row| {
            let row = row.map_err(mistake)?;
            Ok((row.line, row.cells.iter().map(str::to_owned).collect()))
        });
        Ok(Self {
            header: table.header().iter().map(str::to_owned).collect(),
            header_line: table.header_line(),
            rows: rows.collect::<Result<_, String>>()?,
        })
    }

    #[cfg(not(feature = "workbooks"))]
    fn of_workbook(_: &Path) -> Result<Self, String> {
        Err(" is a workbook, which this build does not read: save it as CSV".to_owned())
    }

    #[cfg(feature = "workbooks")]
    fn of_workbook(path: &Path) -> Result<Self, String> {
        let unreadable = |reason: String| format!(" cannot be read: {reason}");
        let metadata = std::fs::metadata(path).map_err(|error| unreadable(error.to_string()))?;
        if !metadata.is_file() || metadata.len() > LARGEST_SWEEP_FILE {
            let most = LARGEST_SWEEP_FILE >> 20;
            return Err(unreadable(format!("it is no file of at most {most} MiB")));
        }
        let mut workbook =
            open_workbook_auto(path).map_err(|error| unreadable(error.to_string()))?;
        let sheet = workbook
            .worksheet_range_at(0)
            .ok_or_else(|| unreadable("it has no sheet".to_owned()))?
            .map_err(|error| unreadable(error.to_string()))?;
        let first = sheet.start().map_or(0, |(row, _)| row as usize);
        let text = |cell: &Data| cell.to_string().trim().to_owned();
        let rows = sheet.rows().map(|row| row.iter().map(text).collect());
        let mut rows = (rows.enumerate())
            .map(|(index, row): (usize, Vec<String>)| (first + index + 1, row))
            .filter(|(_, row)| row.iter().any(|cell| !cell.is_empty()))
            .filter(|(_, row)| !row[0].starts_with('#'));
        let (header_line, header) = rows.next().unwrap_or_default();
        Ok(Self {
            header,
            header_line,
            rows: rows.collect(),
        })
    }
}
