//! A table in a file: the row of its headings, and those below.

use std::path::Path;

use super::decimal::{Decimals, NumberError, decimals};
use super::grid::{Cell, Line, TextGrid};
use super::hand_table::uneven;
use super::header::find;
use super::heading::Heading;
use super::read::read;
use crate::text_file::TextOf;

/// A row below the headings.
#[derive(Debug, Clone)]
pub struct Row {
    /// Its line in the file, from 1.
    pub line: usize,
    /// A cell for each column.
    cells: Vec<Cell>,
    decimals: Decimals,
}

impl Row {
    /// The text of a column.
    pub fn text(&self, place: usize) -> String {
        let cell = self.cells.get(place);
        cell.map_or_else(String::new, |cell| cell.text().into_owned())
    }

    /// Whether there is nothing in a column.
    pub fn is_empty_at(&self, place: usize) -> bool {
        self.cells.get(place).is_none_or(Cell::is_empty)
    }

    /// The number of a column.
    ///
    /// # Errors
    /// Where it is not a number, or ambiguous.
    pub fn number(&self, place: usize) -> Result<f64, NumberError> {
        let empty = Cell::Text(String::new());
        self.cells
            .get(place)
            .unwrap_or(&empty)
            .number(self.decimals)
    }
}

/// A table.
#[derive(Debug, Clone, Default)]
pub struct Table {
    /// What its columns are called.
    pub headings: Vec<Heading>,
    /// Line of the headings, from 1.
    pub header_line: usize,
    /// What is below.
    pub rows: Vec<Row>,
    /// Lines of comments below the headings.
    pub comments: Vec<usize>,
}

impl Table {
    /// Reads a file, whose headings are the first row of those that can be, by `is_header`; else
    /// the first row of those with the most cells.
    ///
    /// # Errors
    /// Why it cannot be read; follows the file's name.
    pub fn read(
        path: &Path,
        read_text: TextOf,
        is_header: &dyn Fn(&[Heading]) -> bool,
    ) -> Result<Self, String> {
        Self::of_grid(read(path, read_text)?, is_header)
    }

    fn of_grid(grid: TextGrid, is_header: &dyn Fn(&[Heading]) -> bool) -> Result<Self, String> {
        let TextGrid { lines, separator } = grid;
        let Some(header) = find(&lines, is_header) else {
            return Ok(Self {
                header_line: 1,
                ..Self::default()
            });
        };
        let header_line = lines[header.place].number;
        let below = lines.into_iter().skip(header.place + header.height);
        let (comments, content): (Vec<Line>, Vec<Line>) = below.partition(|line| line.is_comment);
        let decimals = decimals(
            content
                .iter()
                .flat_map(|line| &line.cells)
                .filter_map(text_of),
        );
        let columns = header.headings.len();
        let rows = content.into_iter().map(|line| {
            // Where the headings are not those of this table its rows are not what is wrong.
            if header.is_found {
                check_width(&line, columns, separator)?;
            }
            let (line, mut cells) = (line.number, line.cells);
            cells.truncate(columns);
            Ok(Row {
                line,
                cells,
                decimals,
            })
        });
        Ok(Self {
            header_line,
            headings: header.headings,
            rows: rows.collect::<Result<_, String>>()?,
            comments: comments.iter().map(|line| line.number).collect(),
        })
    }

    /// What the file has, for a person who looks for a column.
    pub fn names(&self) -> String {
        let names = self.headings.iter().filter(|heading| !heading.is_empty());
        let names: Vec<String> = names.map(|heading| format!("`{}`", heading.text)).collect();
        match names.is_empty() {
            true => "it has no columns".to_owned(),
            false => format!("it has {}", names.join(", ")),
        }
    }

    /// Whether a column has numbers alone, and at least one.
    pub fn is_numeric(&self, place: usize) -> bool {
        let mut filled = self
            .rows
            .iter()
            .filter(|row| !row.is_empty_at(place))
            .peekable();
        filled.peek().is_some() && filled.all(|row| row.number(place).is_ok())
    }
}

/// A cell that is a text, which may be that of a number.
fn text_of(cell: &Cell) -> Option<&str> {
    match cell {
        Cell::Text(text) => Some(text),
        Cell::Number(_) => None,
    }
}

/// Refuses a row that has more values than there are columns or, in a text with separators, fewer
/// cells.
fn check_width(line: &Line, columns: usize, separator: Option<u8>) -> Result<(), String> {
    let (values, has) = (line.filled(), line.cells.len());
    match separator {
        Some(separator) if values > columns || has < columns => {
            let message = uneven(separator, values.max(has.min(columns)), columns);
            Err(format!(":{}: {message}", line.number))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::Dimension;
    use crate::tables::heading::Meaning;

    /// A depth and an angle.
    fn table(text: &str) -> Table {
        let is_header = |headings: &[Heading]| {
            let has = |names: &[&str], dimension| {
                (headings.iter()).any(|it| it.meaning(names, Some(dimension)) != Meaning::Other)
            };
            has(&["md"], Dimension::Length) && has(&["inc"], Dimension::Angle)
        };
        Table::of_grid(super::super::hand_table::grid(text).unwrap(), &is_header).unwrap()
    }

    #[test]
    fn headings_are_found_below_titles_and_behind_marks_of_comments() {
        for (text, header_line, first_row) in [
            ("md_m,inc_deg\n0,1", 1, 2),
            ("Survey of well 7\n\nMD (m),Inc (deg)\n0,1", 3, 4),
            ("\"Survey, well 7\",\nMD,Inc\nm,deg\n0,1", 2, 4),
            ("MD;Inc\n(m);(\u{b0})\n0;1", 1, 3),
            ("# by hand\n#MD [m]\tInc [deg]\n0\t1", 2, 3),
            ("# MD [m], Inc [deg]\n# none\n0,1\n# more\n5,1", 1, 3),
        ] {
            let table = table(text);
            assert_eq!(table.header_line, header_line, "{text}");
            assert_eq!(table.rows[0].line, first_row, "{text}");
            assert_eq!(
                table.headings[0].factor(Dimension::Length),
                Some(1.0),
                "{text}"
            );
            assert_eq!(table.rows[0].number(1), Ok(1.0), "{text}");
        }
    }

    #[test]
    fn the_numbers_of_a_file_decide_what_a_comma_is() {
        let table = table("md_m;inc_deg\n4,276;1\n9,45;2\n");
        assert_eq!(table.rows[0].number(0), Ok(4.276));
        let table = self::table("md_m;inc_deg\n1.200;1,5\n9;2\n");
        assert!(table.rows[0].number(0).is_err());
    }

    /// Rows below titles of two cells are not refused for their width: it is the headings that are
    /// not known, and those are the widest row.
    #[test]
    fn unknown_headings_are_what_is_reported_of_a_table_below_titles() {
        let table = table("Company;A\nSurvey\nlength (m);angle (deg);azi (deg)\n0;1;2\n30;1\n");
        assert_eq!(table.header_line, 3);
        assert_eq!(table.headings.len(), 3);
        assert_eq!(table.rows.len(), 2);
    }
}
