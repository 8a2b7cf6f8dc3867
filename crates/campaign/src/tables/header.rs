//! The row of a table's headings.

use super::grid::{Cell, Line};
use super::heading::Heading;

/// Headings are among the first lines, this many.
pub const LINES_SEARCHED: usize = 60;

/// Where the headings are, and what they are.
pub struct Header {
    /// The place of their line.
    pub place: usize,
    /// The headings, with units from a separate row.
    pub headings: Vec<Heading>,
    /// Lines that they take.
    pub height: usize,
    /// Whether they have what is looked for; else they are what looks most like headings.
    pub is_found: bool,
}

/// The headings among the first lines, comments included: the first row that can be, by `is_header`;
/// else the first of those with the most cells, for a title has fewer.
pub fn find(lines: &[Line], is_header: &dyn Fn(&[Heading]) -> bool) -> Option<Header> {
    let first = lines.iter().take(LINES_SEARCHED).enumerate();
    let mut found = first.filter_map(|(place, line)| {
        let header = header(lines, place, line);
        is_header(&header.headings).then_some(header)
    });
    if let Some(header) = found.next() {
        return Some(header);
    }
    let rows = lines
        .iter()
        .enumerate()
        .filter(|(_, line)| !line.is_comment);
    // The last of equals is the greatest.
    let likely = rows
        .take(LINES_SEARCHED)
        .collect::<Vec<_>>()
        .into_iter()
        .rev();
    let (place, line) = likely.max_by_key(|(_, line)| line.filled())?;
    Some(Header {
        is_found: false,
        ..header(lines, place, line)
    })
}

/// The headings of a line, with units from the next where that has nothing else.
fn header(lines: &[Line], place: usize, line: &Line) -> Header {
    let columns = line.filled();
    let headings = line.cells[..columns]
        .iter()
        .map(|cell| Heading::new(&cell.text()));
    let mut headings: Vec<Heading> = headings.collect();
    let next = (lines.get(place + 1)).filter(|next| next.filled() <= columns && is_of_units(next));
    for (heading, unit) in headings
        .iter_mut()
        .zip(next.iter().flat_map(|next| &next.cells))
    {
        *heading = heading.in_unit(&unit.text());
    }
    Header {
        place,
        headings,
        height: 1 + usize::from(next.is_some()),
        is_found: true,
    }
}

/// Whether a line has units, and nothing but those and what stands for none.
fn is_of_units(line: &Line) -> bool {
    let mut cells = line.cells.iter().filter(|cell| !cell.is_empty());
    let is_none = |cell: &Cell| matches!(&*cell.text(), "-" | "–" | "—" | "(-)" | "[-]" | "()");
    let has_unit = line.cells.iter().any(|cell| Heading::is_unit(&cell.text()));
    has_unit && cells.all(|cell| is_none(cell) || Heading::is_unit(&cell.text()))
}
