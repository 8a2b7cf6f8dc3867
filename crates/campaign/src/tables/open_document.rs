//! The first sheet of an `.ods` workbook. Rows and cells that it repeats are counted before they
//! are made.

use std::io::{Cursor, Read};

use quick_xml::Reader;
use quick_xml::escape::unescape;
use quick_xml::events::{BytesStart, Event};
use quick_xml::name::QName;
use zip::ZipArchive;

use super::grid::{Cell, Line, MOST_COLUMNS};
use super::workbook::{Growing, unpacked_size};

/// Its lines, without those that are empty.
///
/// # Errors
/// Where it is no workbook, is damaged, or is too large.
pub fn lines(bytes: Vec<u8>) -> Result<Vec<Line>, String> {
    unpacked_size(&bytes)?;
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|error| error.to_string())?;
    let mut content = String::new();
    let mut file = (archive.by_name("content.xml")).map_err(|error| error.to_string())?;
    file.read_to_string(&mut content)
        .map_err(|error| error.to_string())?;
    Sheet::read(&content)
}

/// The sheet, as far as it is read.
#[derive(Default)]
struct Sheet {
    grid: Growing,
    /// The row and the column that come next.
    row: u64,
    column: u64,
    /// Cells of the row, with their columns.
    cells: Vec<(u64, Cell)>,
    repeats_row: u64,
}

/// A cell that is open.
struct Open {
    value: Option<f64>,
    text: String,
    repeats: u64,
}

impl Sheet {
    fn read(content: &str) -> Result<Vec<Line>, String> {
        let mut reader = Reader::from_str(content);
        let mut sheet = Self::default();
        let (mut is_in_table, mut cell, mut in_note) = (false, None::<Open>, 0_usize);
        loop {
            let event = reader.read_event().map_err(|error| error.to_string())?;
            match &event {
                Event::Start(start) if is_named(start.name(), "table:table") => is_in_table = true,
                Event::End(end) if is_named(end.name(), "table:table") && is_in_table => {
                    return Ok(sheet.grid.lines);
                }
                Event::Eof => return Err("it has no whole sheet".to_owned()),
                _ if !is_in_table => {}
                Event::Start(start) if is_named(start.name(), "office:annotation") => in_note += 1,
                Event::End(end) if is_named(end.name(), "office:annotation") => in_note -= 1,
                _ if in_note > 0 => {}
                Event::Start(start) if is_named(start.name(), "table:table-row") => {
                    sheet.repeats_row = repeats(start, "table:number-rows-repeated")?;
                }
                Event::Empty(start) if is_named(start.name(), "table:table-row") => {
                    sheet.row += repeats(start, "table:number-rows-repeated")?;
                }
                Event::End(end) if is_named(end.name(), "table:table-row") => sheet.end_row()?,
                Event::Start(start) if is_cell(start) => cell = Some(Open::new(start)?),
                Event::Empty(start) if is_cell(start) => sheet.end_cell(Open::new(start)?),
                Event::End(end) if is_cell_name(end.name()) => {
                    cell.take()
                        .into_iter()
                        .for_each(|cell| sheet.end_cell(cell));
                }
                Event::Text(text) => {
                    let text = text_of(&**text)?;
                    cell.iter_mut().for_each(|cell| cell.text.push_str(text));
                }
                Event::GeneralRef(entity) => {
                    let letter = match text_of(&**entity)? {
                        "amp" => Some('&'),
                        "lt" => Some('<'),
                        "gt" => Some('>'),
                        "quot" => Some('"'),
                        "apos" => Some('\''),
                        _ => entity.resolve_char_ref().ok().flatten(),
                    };
                    cell.iter_mut().for_each(|cell| cell.text.extend(letter));
                }
                Event::Empty(start) if is_named(start.name(), "text:s") => {
                    cell.iter_mut().for_each(|cell| cell.text.push(' '));
                }
                _ => {}
            }
        }
    }

    fn end_cell(&mut self, cell: Open) {
        let content = match cell.value {
            Some(number) => Cell::Number(number),
            None => Cell::Text(cell.text.trim().to_owned()),
        };
        if !content.is_empty() {
            // One beyond those that are read is refused with its place.
            let copies = cell.repeats.min(MOST_COLUMNS as u64 + 1);
            let column = |copy: u64| self.column.saturating_add(copy);
            (self.cells).extend((0..copies).map(|copy| (column(copy), content.clone())));
        }
        self.column = self.column.saturating_add(cell.repeats);
    }

    fn end_row(&mut self) -> Result<(), String> {
        let place = |number: u64| u32::try_from(number).unwrap_or(u32::MAX);
        let repeats = if self.cells.is_empty() {
            0
        } else {
            self.repeats_row
        };
        for copy in 0..repeats {
            for (column, content) in &self.cells {
                let row = place(self.row.saturating_add(copy));
                self.grid.put((row, place(*column)), content.clone())?;
            }
        }
        self.row = self.row.saturating_add(self.repeats_row);
        self.column = 0;
        self.cells.clear();
        Ok(())
    }
}

impl Open {
    fn new(start: &BytesStart) -> Result<Self, String> {
        let value = match attribute(start, "office:value")? {
            Some(text) => text.parse().ok(),
            None => None,
        };
        Ok(Self {
            value,
            text: String::new(),
            repeats: repeats(start, "table:number-columns-repeated")?,
        })
    }
}

fn is_cell(start: &BytesStart) -> bool {
    is_cell_name(start.name())
}

fn is_cell_name(name: QName) -> bool {
    is_named(name, "table:table-cell") || is_named(name, "table:covered-table-cell")
}

fn is_named<T: AsRef<[u8]> + ?Sized>(name: impl AsRef<T>, wanted: &str) -> bool {
    name.as_ref().as_ref() == wanted.as_bytes()
}

/// Text of what `quick_xml` gives as bytes until 0.41 and as text since 0.42.
fn text_of<T: AsRef<[u8]> + ?Sized>(content: &T) -> Result<&str, String> {
    std::str::from_utf8(content.as_ref()).map_err(|error| error.to_string())
}

fn repeats(start: &BytesStart, name: &str) -> Result<u64, String> {
    let Some(text) = attribute(start, name)? else {
        return Ok(1);
    };
    (text.parse()).map_err(|_| format!("`{name}` is `{text}`, not a number"))
}

fn attribute(start: &BytesStart, name: &str) -> Result<Option<String>, String> {
    let attribute = (start.try_get_attribute(name)).map_err(|error| error.to_string())?;
    let Some(attribute) = attribute else {
        return Ok(None);
    };
    let value = unescape(text_of(&*attribute.value)?).map_err(|error| error.to_string())?;
    Ok(Some(value.into_owned()))
}
