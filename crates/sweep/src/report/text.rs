//! Sections for a terminal, a pipe or a file.

use super::document::{Block, Section, Table};
use campaign::words::{WIDTH, wrapped};

/// Space between columns.
const GAP: usize = 2;

/// The sections as text.
pub fn text(title: &str, sections: &[Section]) -> String {
    let mut text = wrapped(title, 0, 0);
    for (title, blocks) in sections {
        let rule = "─".repeat(title.chars().count());
        text += &format!("\n{title}\n{rule}\n");
        text += &blocks_text(blocks);
    }
    text
}

fn blocks_text(blocks: &[Block]) -> String {
    let of_block = |block: &Block| match block {
        Block::Text(paragraph) => wrapped(paragraph, 0, 0),
        Block::Heading(heading) => wrapped(&format!("{heading}:"), 0, 0),
        Block::Facts(facts) => facts
            .iter()
            .map(|(name, text)| line_of(&format!("{name}: "), text))
            .collect(),
        Block::Table(table) | Block::Picture { table, .. } => table_text(table),
        Block::Map(map) => format!("{}\n{}", wrapped(&map.caption, 0, 0), map.characters),
        Block::Details { blocks, .. } => blocks_text(blocks),
        Block::Folded { .. } => String::new(),
    };
    blocks.iter().map(of_block).collect()
}

/// A table in columns, or, where they do not fit, row by row.
fn table_text(table: &Table) -> String {
    let width = |column: usize| {
        let cells = table.rows.iter().map(|row| &row[column]);
        let all = cells.chain([&table.header[column]]);
        all.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..table.header.len()).map(width).collect();
    let mut text = wrapped(&format!("{}:", table.caption), 0, 0);
    if widths.iter().map(|width| width + GAP).sum::<usize>() > WIDTH {
        for row in &table.rows {
            text += &record(&table.header, row);
        }
        return text;
    }
    let line = |cells: &[String]| {
        let mut line = String::new();
        for (column, (cell, width)) in cells.iter().zip(&widths).enumerate() {
            let space = " ".repeat(width - cell.chars().count());
            let gap = " ".repeat(GAP);
            line += &if table.is_numeric(column) {
                format!("{gap}{space}{cell}")
            } else {
                format!("{gap}{cell}{space}")
            };
        }
        format!("{}\n", line.trim_end())
    };
    text += &line(&table.header);
    for row in &table.rows {
        text += &line(row);
    }
    text
}

/// A row of a table that is too wide: a line for each of its cells, or one line where
/// there are but a name and what it is.
fn record(header: &[String], row: &[String]) -> String {
    if let [name, value] = row {
        return line_of(&format!("  {name}: "), value);
    }
    let mut text = String::new();
    for (index, (name, cell)) in header.iter().zip(row).enumerate() {
        let bullet = if index == 0 { "- " } else { "  " };
        text += &line_of(&format!("{bullet}{name}: "), cell);
    }
    text
}

/// A name and a value, broken into lines; but a command is to be copied whole.
fn line_of(name: &str, value: &str) -> String {
    if value.starts_with("sweep ") {
        return format!("{name}{value}\n");
    }
    let indent = name.len() - name.trim_start().len();
    wrapped(&format!("{name}{value}"), indent, 4)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(cells: [[&str; 2]; 2]) -> Table {
        let mut table = Table::new("Of things", ["name", "number"]);
        table.rows = cells.map(|row| row.map(str::to_owned).to_vec()).to_vec();
        table
    }

    #[test]
    fn numbers_are_aligned_at_their_end_and_words_at_their_start() {
        let text = table_text(&table([["a", "10"], ["long", "5"]]));
        assert_eq!(
            text,
            "Of things:\n  name  number\n  a         10\n  long       5\n"
        );
    }

    #[test]
    fn a_table_too_wide_becomes_a_list_and_keeps_its_commands_whole() {
        let command = "sweep simulate ".repeat(8);
        let text = table_text(&table([["a", &command], ["b", "2"]]));
        assert!(
            text.contains(&format!("  a: {command}\n  b: 2\n")),
            "{text}"
        );
        let header = ["case", "why", "repeat_with"].map(str::to_owned);
        let row = ["1".to_owned(), "for a reason ".repeat(8), command.clone()];
        let text = record(&header, &row);
        assert!(
            text.starts_with("- case: 1\n  why: for a reason for"),
            "{text}"
        );
        assert!(
            text.ends_with(&format!("\n  repeat_with: {command}\n")),
            "{text}"
        );
        assert_eq!(text.lines().count(), 4, "{text}");
    }
}
