//! Tables that people write by hand or export from a spreadsheet: CSV with
//! comments, empty lines and a byte-order mark, separated by commas, semicolons or
//! tabs, with a decimal point or comma. What is ambiguous is refused.

use csv::{Position, StringRecord};
use thiserror::Error;

use super::grid::{Cell, Line, MOST_COLUMNS, TextGrid};
use super::header::{LINES_SEARCHED, find};
use super::heading::Heading;
use crate::words::counted;

pub use super::decimal::{NumberError, number};

/// Lines that begin with it are ignored.
const COMMENT: char = '#';

/// A table whose rows know on which line they stand.
pub struct HandTable {
    text: String,
    separator: u8,
    header: StringRecord,
    header_line: usize,
    /// Below which rows are.
    last_line: usize,
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
        let mut table = Self::of(text);
        // A spreadsheet puts a comment with commas into quotes.
        let is_title = |row: &Result<HandRow, Mistake>| {
            row.as_ref()
                .is_ok_and(|row| row.cells[0].starts_with(COMMENT))
        };
        let header = Rows::new(&table).find(|row| !is_title(row));
        if let Some(header) = header.transpose()? {
            (table.header, table.header_line) = (header.cells, header.line);
            table.last_line = header.line;
            table.header.truncate(filled(&table.header));
        }
        Ok(table)
    }

    /// Reads the headings, which are the first row of those that can be, by `is_header`.
    ///
    /// # Errors
    /// Where the text is not a table.
    pub fn with_headings(
        text: &str,
        is_header: &dyn Fn(&[Heading]) -> bool,
    ) -> Result<(Self, Vec<Heading>), Mistake> {
        let mut table = Self::new(text)?;
        let head: String = table
            .text
            .split_inclusive('\n')
            .take(LINES_SEARCHED)
            .collect();
        let lines = grid(&head)?.lines;
        let Some(header) = find(&lines, is_header) else {
            return Ok((table, Vec::new()));
        };
        let names = header.headings.iter().map(|heading| heading.text.as_str());
        table.header = names.collect();
        table.header_line = lines[header.place].number;
        table.last_line = lines[header.place + header.height - 1].number;
        Ok((table, header.headings))
    }

    /// Without its header.
    fn of(text: &str) -> Self {
        // Spreadsheets of one system begin with a mark, of another end lines by CR.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        Self {
            separator: separator(&text),
            header: StringRecord::new(),
            header_line: 1,
            last_line: 0,
            text,
        }
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

    /// The rows below the header; rows without any content are ignored.
    pub fn rows(&self) -> impl Iterator<Item = Result<HandRow, Mistake>> {
        let is_above = |row: &Result<HandRow, Mistake>| {
            row.as_ref().is_ok_and(|row| row.line <= self.last_line)
        };
        Rows::new(self).skip_while(is_above).map(|row| {
            let mut row = row?;
            let (values, columns) = (filled(&row.cells), self.header.len());
            if values > columns || row.cells.len() < columns {
                let values = values.max(row.cells.len().min(columns));
                return Err(Mistake {
                    line: row.line,
                    message: uneven(self.separator, values, columns),
                });
            }
            row.cells.truncate(columns);
            Ok(row)
        })
    }
}

/// Why a row of a number of values is refused below a number of columns.
pub fn uneven(separator: u8, values: usize, columns: usize) -> String {
    let hint = if values > columns && separator == b',' {
        "; numbers with decimal commas need semicolons between them"
    } else {
        ""
    };
    let (values, columns) = (counted(values, "value"), counted(columns, "column"));
    format!("{values}, but {columns}{hint}")
}

/// All lines of a text that have any content, comments among them.
///
/// # Errors
/// Where the text is not a table.
pub fn grid(text: &str) -> Result<TextGrid, Mistake> {
    let table = HandTable::of(text);
    let mut rows = Rows::new(&table);
    let mut lines = Vec::new();
    let line = |number, cells: &StringRecord, is_comment| Line {
        number,
        cells: cells
            .iter()
            .map(|cell| Cell::Text(cell.to_owned()))
            .collect(),
        is_comment,
    };
    loop {
        let row = rows.next();
        for (number, comment) in rows.comments.drain(..) {
            let mut cells = cells_of_comment(&comment, table.separator);
            cells.truncate(MOST_COLUMNS);
            lines.push(line(number, &cells, true));
        }
        match row {
            Some(row) => {
                let row = row?;
                lines.push(line(row.line, &row.cells, false));
            }
            None => {
                return Ok(TextGrid {
                    lines,
                    separator: Some(table.separator),
                });
            }
        }
    }
}

/// The cells that a comment would be without its mark.
fn cells_of_comment(comment: &str, separator: u8) -> StringRecord {
    let text = comment.trim_start_matches([COMMENT, ' ', '\t']);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .delimiter(separator)
        .from_reader(text.as_bytes());
    let first = reader.records().next().and_then(Result::ok);
    first.unwrap_or_else(|| StringRecord::from(vec![text]))
}

/// Lines by which the separator is found.
const LINES_READ: usize = 200;

/// What separates the columns: what divides most lines into as many, of which a semicolon or a tab
/// goes before a comma, which may be that of a fraction.
fn separator(text: &str) -> u8 {
    let content = |line: &&str| !line.trim().is_empty() && !line.starts_with(COMMENT);
    let lines: Vec<&str> = text.lines().filter(content).take(LINES_READ).collect();
    let agreeing = |separator: char| {
        let mut counts: Vec<usize> = lines
            .iter()
            .map(|line| outside_quotes(line, separator))
            .collect();
        counts.sort_unstable();
        let alike = counts.chunk_by(|one, other| one == other);
        let divided = alike.filter(|alike| alike[0] > 0);
        divided.map(<[usize]>::len).max().unwrap_or(0)
    };
    let found = ['\t', ';', ','].map(|separator| (agreeing(separator), separator));
    // The last of equals is the greatest.
    let best = found.into_iter().rev().max_by_key(|(lines, _)| *lines);
    best.filter(|(lines, _)| *lines > 0)
        .map_or(b',', |(_, separator)| separator as u8)
}

fn outside_quotes(line: &str, separator: char) -> usize {
    let mut is_quoted = false;
    let is_there = |letter: &char| {
        is_quoted ^= *letter == '"';
        *letter == separator && !is_quoted
    };
    line.chars().filter(is_there).count()
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
    /// Comments that were ignored, with their lines.
    comments: Vec<(usize, String)>,
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
            comments: Vec::new(),
        }
    }

    /// The line of the first row at or after a byte, where the row before it ended; and whether that
    /// is a comment behind blanks.
    fn line_from(&mut self, byte: usize) -> (usize, bool) {
        self.lines += self.text[self.counted..byte].matches('\n').count();
        self.counted = byte;
        let mut number = self.lines + 1;
        for line in self.text[byte..].lines() {
            let is_indented = line.trim_start().starts_with(COMMENT);
            if is_indented {
                self.comments.push((number, line.trim_start().to_owned()));
            }
            if !line.is_empty() && !line.starts_with(COMMENT) {
                return (number, is_indented);
            }
            number += 1;
        }
        (number, false)
    }
}

impl Iterator for Rows<'_> {
    type Item = Result<HandRow, Mistake>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let mut cells = StringRecord::new();
            let read = self.reader.read_record(&mut cells);
            let byte = cells.position().map_or(self.counted as u64, Position::byte);
            let (line, is_comment) = self.line_from(byte as usize);
            match read {
                Err(error) => {
                    let message = error.to_string();
                    return Some(Err(Mistake { line, message }));
                }
                Ok(false) => return None,
                Ok(true) if is_comment || filled(&cells) == 0 => {}
                Ok(true) if cells.len() > MOST_COLUMNS => {
                    let message = format!(
                        "{} columns, more than the {MOST_COLUMNS} that are read",
                        cells.len()
                    );
                    return Some(Err(Mistake { line, message }));
                }
                Ok(true) => return Some(Ok(HandRow { line, cells })),
            }
        }
    }
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
        let expected = [(6, ["1", "2\n3"]), (8, ["# x, y", ""]), (9, ["4", "5"])];
        let expected = expected.map(|(line, cells)| (line, cells.map(str::to_owned).to_vec()));
        assert_eq!(rows(text), expected);
        let table = HandTable::new(text).expect("a table");
        assert_eq!(table.header_mistake("").line, 3);
        assert_eq!(rows("a,b\r1,2\r3,4\r").len(), 2);
        assert!(rows("").is_empty());
    }

    /// A hundred thousand took eight seconds.
    #[test]
    fn more_columns_than_any_table_has_are_refused_with_their_line() {
        let wide = |columns: usize| vec!["1"; columns].join(",");
        for text in [wide(100_000), format!("a,b\n# {}\n{0}", wide(100_000))] {
            let mistake = grid(&text).unwrap_err().to_string();
            let line = text.lines().count();
            let expected = format!("{line}: 100000 columns, more than the 1000 that are read");
            assert_eq!(mistake, expected);
        }
        assert_eq!(rows(&format!("{0}\n{0}", wide(1000)))[0].1.len(), 1000);
    }
}
