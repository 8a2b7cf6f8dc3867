//! The first sheet of an `.xlsx` workbook, cell by cell: what a file says of its size is not
//! believed, and nothing is made as large as that.

use std::io::{Cursor, Read};
use std::panic::{AssertUnwindSafe, catch_unwind};

use calamine::{DataRef, Reader, Xlsx};
use quick_xml::events::Event;
use zip::ZipArchive;

use super::grid::{Cell, Line, MOST_COLUMNS};

/// Most bytes that the texts of a workbook have once they are unpacked: those of a hundred
/// thousand rows have a third of it.
const MOST_BYTES: u64 = 48 << 20;

/// Most rows and cells that are read.
const MOST_ROWS: u32 = 1 << 20;
const MOST_CELLS: usize = 2_000_000;

/// Most attributes of a tag that are read. The first tag of a workbook has the most, some forty.
const MOST_ATTRIBUTES: usize = 256;

/// Its lines, without those that are empty.
///
/// # Errors
/// Where it is no workbook, is damaged, or is too large.
pub fn lines(bytes: Vec<u8>) -> Result<Vec<Line>, String> {
    unpacked_size(&bytes)?;
    // What is damaged is found by the reader's own checks, or by those of the language.
    let read = catch_unwind(AssertUnwindSafe(|| read(bytes)));
    read.unwrap_or_else(|_| Err("it is damaged".to_owned()))
}

fn read(bytes: Vec<u8>) -> Result<Vec<Line>, String> {
    let mut workbook = Xlsx::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let first = workbook.sheet_names().into_iter().next();
    let first = first.ok_or("it has no sheet")?;
    let mut reader =
        (workbook.worksheet_cells_reader(&first)).map_err(|error| error.to_string())?;
    let mut grid = Growing::default();
    while let Some(cell) = reader.next_cell().map_err(|error| error.to_string())? {
        let content = match cell.get_value() {
            DataRef::Empty => continue,
            DataRef::Int(number) => Cell::Number(*number as f64),
            DataRef::Float(number) => Cell::Number(*number),
            DataRef::String(text) => Cell::Text(text.trim().to_owned()),
            DataRef::SharedString(text) => Cell::Text(text.trim().to_owned()),
            DataRef::Bool(truth) => Cell::Text(truth.to_string()),
            DataRef::DateTime(time) => Cell::Number(time.as_f64()),
            DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => Cell::Text(text.clone()),
            DataRef::Error(error) => Cell::Text(error.to_string()),
        };
        grid.put(cell.get_position(), content)?;
    }
    Ok(grid.lines)
}

/// Lines that grow by one cell after another.
#[derive(Default)]
pub struct Growing {
    /// Those that are there.
    pub lines: Vec<Line>,
    cells: usize,
}

impl Growing {
    /// Puts a cell at a row and a column, from 0, at the end of what is there.
    ///
    /// # Errors
    /// Where it is beyond any table, before what is there, or one too many.
    pub fn put(&mut self, (row, column): (u32, u32), content: Cell) -> Result<(), String> {
        if content.is_empty() {
            return Ok(());
        }
        let place = || {
            format!(
                "the cell in row {} and column {}",
                u64::from(row) + 1,
                u64::from(column) + 1
            )
        };
        if row >= MOST_ROWS || column as usize >= MOST_COLUMNS {
            let most = format!("{MOST_ROWS} rows and {MOST_COLUMNS} columns");
            return Err(format!("{} is beyond the {most} that are read", place()));
        }
        let number = row as usize + 1;
        match self.lines.last() {
            Some(last) if last.number == number => {}
            Some(last) if last.number > number => {
                return Err(format!("{} follows later ones", place()));
            }
            _ => self.lines.push(Line {
                number,
                cells: Vec::new(),
                is_comment: false,
            }),
        }
        if let Some(last) = self.lines.last_mut() {
            let column = column as usize;
            self.cells += (column + 1).saturating_sub(last.cells.len());
            if self.cells > MOST_CELLS {
                return Err(format!(
                    "it has more than the {MOST_CELLS} cells that are read"
                ));
            }
            if last.cells.len() <= column {
                last.cells.resize(column + 1, Cell::Text(String::new()));
            }
            last.cells[column] = content;
        }
        Ok(())
    }
}

/// Unpacks all that a workbook is read from, counts it, and looks at its tags.
///
/// # Errors
/// Where that is more than is read, or the archive is damaged.
pub fn unpacked_size(bytes: &[u8]) -> Result<u64, String> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut size = 0;
    let mut content = Vec::new();
    for index in 0..archive.len() {
        let file = archive.by_index(index).map_err(|error| error.to_string())?;
        let name = file.name_raw().to_ascii_lowercase();
        if !(name.ends_with(b".xml") || name.ends_with(b".rels")) {
            continue;
        }
        content.clear();
        let left = MOST_BYTES + 1 - size;
        (file.take(left).read_to_end(&mut content)).map_err(|error| error.to_string())?;
        size += content.len() as u64;
        if size > MOST_BYTES {
            let most = MOST_BYTES >> 20;
            return Err(format!("it has more than {most} MiB once it is unpacked"));
        }
        check_attributes(&content)?;
    }
    Ok(size)
}

/// Refuses tags with more attributes than any workbook has: until 0.40 `quick_xml` compares each
/// with all before it. Text that is no XML is left to those who read it.
fn check_attributes(content: &[u8]) -> Result<(), String> {
    let mut reader = quick_xml::Reader::from_reader(content);
    // As calamine reads it.
    reader.config_mut().check_end_names = false;
    let mut buffer = Vec::new();
    loop {
        buffer.clear();
        match reader.read_event_into(&mut buffer) {
            Ok(Event::Start(tag) | Event::Empty(tag)) => {
                let mut attributes = tag.attributes();
                if attributes.with_checks(false).nth(MOST_ATTRIBUTES).is_some() {
                    return Err(format!(
                        "a tag of it has more than the {MOST_ATTRIBUTES} attributes that are read"
                    ));
                }
            }
            Ok(Event::Eof) | Err(_) => return Ok(()),
            Ok(_) => {}
        }
    }
}
