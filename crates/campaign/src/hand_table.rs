//! Tables that people write by hand or export from a spreadsheet: CSV with
//! comments, empty lines and a byte-order mark, separated by commas, semicolons or
//! tabs, with a decimal point or comma. What is ambiguous is refused.

use csv::{Position, StringRecord};
use thiserror::Error;

use crate::words::counted;

/// Lines that begin with it are passed over.
const COMMENT: char = '#';

/// A table whose rows know on which line they stand.
pub struct HandTable {
    text: String,
    separator: u8,
    header: StringRecord,
    header_line: usize,
}

/// A row of a table.
pub struct HandRow {
    /// Its line, from 1.
    pub line: usize,
    /// A cell for each column.
    pub cells: StringRecord,
}

/// What is wrong with a table, and on which line. It follows the file's name and a
/// colon.
#[derive(Debug, Error)]
#[error("{line}: {message}")]
pub struct Mistake {
    /// The line, from 1.
    pub line: usize,
    /// A sentence.
    pub message: String,
}

impl HandTable {
    /// Reads the header. Columns at its end without a name are left out.
    ///
    /// # Errors
    /// Where the text is not a table.
    pub fn new(text: &str) -> Result<Self, Mistake> {
        // Spreadsheets of one system begin with a mark, of another end lines by CR.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let mut table = Self {
            separator: separator(&text),
            header: StringRecord::new(),
            header_line: 1,
            text,
        };
        if let Some(header) = Rows::new(&table).next().transpose()? {
            (table.header, table.header_line) = (header.cells, header.line);
            table.header.truncate(filled(&table.header));
        }
        Ok(table)
    }

    /// Names of the columns; none where the table is empty.
    pub fn header(&self) -> &StringRecord {
        &self.header
    }

    /// Line of the header, from 1.
    pub fn header_line(&self) -> usize {
        self.header_line
    }

    /// What is wrong with the header.
    pub fn header_mistake(&self, message: impl Into<String>) -> Mistake {
        Mistake {
            line: self.header_line,
            message: message.into(),
        }
    }

    /// The rows below the header; rows without any content are passed over.
    pub fn rows(&self) -> impl Iterator<Item = Result<HandRow, Mistake>> {
        Rows::new(self).skip(1).map(|row| {
            let mut row = row?;
            let (values, columns) = (filled(&row.cells), self.header.len());
            if values > columns || row.cells.len() < columns {
                let values = values.max(row.cells.len().min(columns));
                return Err(Mistake {
                    line: row.line,
                    message: self.uneven(values, columns),
                });
            }
            row.cells.truncate(columns);
            Ok(row)
        })
    }

    fn uneven(&self, values: usize, columns: usize) -> String {
        let hint = if values > columns && self.separator == b',' {
            "; numbers with decimal commas need semicolons between them"
        } else {
            ""
        };
        let (values, columns) = (counted(values, "value"), counted(columns, "column"));
        format!("{values}, but {columns}{hint}")
    }
}

/// What separates the columns: the comma, unless the header has none but
/// semicolons or tabs.
fn separator(text: &str) -> u8 {
    let is_header = |line: &&str| {
        !line.trim_start_matches('"').starts_with(COMMENT) && line.contains(char::is_alphabetic)
    };
    let header = text.lines().find(is_header).unwrap_or_default();
    let found = [',', ';', '\t']
        .into_iter()
        .find(|&separator| header.contains(separator));
    found.unwrap_or(',') as u8
}

/// Cells up to the last that is not empty.
fn filled(cells: &StringRecord) -> usize {
    let filled = (0..cells.len()).rev().find(|&cell| !cells[cell].is_empty());
    filled.map_or(0, |last| last + 1)
}

/// All rows with any content, the header first. The reader's own positions begin on
/// empty lines and comments before a row.
struct Rows<'a> {
    text: &'a str,
    reader: csv::Reader<&'a [u8]>,
    /// Up to where lines are counted, and how many there are.
    counted: usize,
    lines: usize,
}

impl<'a> Rows<'a> {
    fn new(table: &'a HandTable) -> Self {
        Self {
            text: &table.text,
            reader: csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .trim(csv::Trim::All)
                .comment(Some(COMMENT as u8))
                .delimiter(table.separator)
                .from_reader(table.text.as_bytes()),
            counted: 0,
            lines: 0,
        }
    }

    /// The line of the first row at or after a byte, where the row before it ended.
    fn line_from(&mut self, byte: usize) -> usize {
        self.lines += self.text[self.counted..byte].matches('\n').count();
        self.counted = byte;
        let passed_over = self.text[byte..]
            .lines()
            .take_while(|line| line.is_empty() || line.starts_with(COMMENT))
            .count();
        self.lines + passed_over + 1
    }
}

impl Iterator for Rows<'_> {
    type Item = Result<HandRow, Mistake>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let mut cells = StringRecord::new();
            let read = self.reader.read_record(&mut cells);
            let byte = cells.position().map_or(self.counted as u64, Position::byte);
            let line = self.line_from(byte as usize);
            match read {
                Err(error) => {
                    let message = error.to_string();
                    return Some(Err(Mistake { line, message }));
                }
                Ok(false) => return None,
                // A spreadsheet puts a comment with commas into quotes.
                Ok(true) if filled(&cells) == 0 || cells[0].starts_with(COMMENT) => {}
                Ok(true) => return Some(Ok(HandRow { line, cells })),
            }
        }
    }
}

/// Why a text is refused as a number.
#[derive(Debug, PartialEq, Error)]
pub enum NumberError {
    /// It is none.
    #[error("`{0}` is not a number")]
    NotANumber(String),
    /// Its comma may as well group thousands.
    #[error("`{text}` may be {decimal} or {grouped}: write it without a comma")]
    Ambiguous {
        /// The text.
        text: String,
        /// The number with a decimal comma.
        decimal: f64,
        /// The number without a comma that groups.
        grouped: String,
    },
}

/// A number with a decimal point or comma.
///
/// # Errors
/// Where it is none, or ambiguous.
pub fn number(text: &str) -> Result<f64, NumberError> {
    if let Ok(value) = text.parse() {
        return Ok(value);
    }
    let not_a_number = || NumberError::NotANumber(text.to_owned());
    let (whole, fraction) = text.split_once(',').ok_or_else(not_a_number)?;
    let decimal: f64 = format!("{whole}.{fraction}")
        .parse()
        .map_err(|_| not_a_number())?;
    let digits = whole.trim_start_matches(['+', '-']);
    let may_group = fraction.len() == 3
        && fraction.bytes().all(|letter| letter.is_ascii_digit())
        && (1..=3).contains(&digits.len())
        && !digits.starts_with('0');
    if may_group {
        return Err(NumberError::Ambiguous {
            text: text.to_owned(),
            decimal,
            grouped: format!("{whole}{fraction}"),
        });
    }
    Ok(decimal)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> Vec<(usize, Vec<String>)> {
        let table = HandTable::new(text).expect("a table");
        let rows = table.rows().map(|row| row.expect("a row"));
        rows.map(|row| (row.line, row.cells.iter().map(str::to_owned).collect()))
            .collect()
    }

    #[test]
    fn rows_stand_on_the_lines_of_the_file() {
        let text = "# cases\r\n\r\na,b\r\n\n# more\n1,\"2\n3\"\n\"# x, y\",\n4,5";
        let expected = [(6, ["1", "2\n3"]), (9, ["4", "5"])];
        let expected = expected.map(|(line, cells)| (line, cells.map(str::to_owned).to_vec()));
        assert_eq!(rows(text), expected);
        let table = HandTable::new(text).expect("a table");
        assert_eq!(table.header_mistake("").line, 3);
        assert_eq!(rows("a,b\r1,2\r3,4\r").len(), 2);
        assert!(rows("").is_empty());
    }

    #[test]
    fn a_comma_is_a_decimal_one_only_where_it_groups_no_thousands() {
        for (text, value) in [
            ("0,1", 0.1),
            ("-12,5", -12.5),
            ("0,125", 0.125),
            ("1,5e3", 1500.0),
            ("1234,567", 1234.567),
            ("1.500", 1.5),
        ] {
            assert_eq!(number(text), Ok(value), "{text}");
        }
        let refused = number("1,500").expect_err("ambiguous").to_string();
        assert!(refused.contains("may be 1.5 or 1500"), "{refused}");
        for text in ["1,500,000", "1.500,5", "1,500.5", ",", "", "1;5", "x,5"] {
            assert!(number(text).is_err(), "{text}");
        }
    }
}
