//! The parts of a summary or a report: paragraphs, facts, tables, pictures and maps, without any
//! layout.

use super::results::Results;

/// A heading, and what is below it.
pub type Section = (&'static str, Vec<Block>);

/// A part of a section.
pub enum Block {
    /// A paragraph.
    Text(String),
    /// A heading within a section.
    Heading(String),
    /// Names with what is to be said of each.
    Facts(Vec<(String, String)>),
    /// A table.
    Table(Table),
    /// Numbers that a page draws, with their table folded below; a terminal has the table.
    Picture {
        /// The drawing.
        html: String,
        /// Its numbers.
        table: Table,
    },
    /// The regime map of a results folder.
    Map(Map),
    /// A long text: a page folds it, a terminal leaves it out.
    Folded {
        /// What it is.
        title: String,
        /// Line by line.
        text: String,
    },
    /// Details: a page folds them, a terminal shows them as they are.
    Details {
        /// What they are of.
        title: String,
        /// The details.
        blocks: Vec<Block>,
    },
}

/// Rows and columns.
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// Names of the columns.
    pub header: Vec<String>,
    /// Rows, as long as the header.
    pub rows: Vec<Vec<String>>,
}

/// A regime map in both forms.
pub struct Map {
    /// What it shows.
    pub caption: String,
    /// The same as a page draws it, where it does.
    pub html: Option<String>,
    /// The folder with its cases, where the page holds them.
    pub cases: Option<usize>,
    /// The same in characters.
    pub characters: String,
}

impl Table {
    /// A table with a header and no rows.
    pub fn new<Name: Into<String>>(
        caption: impl Into<String>,
        header: impl IntoIterator<Item = Name>,
    ) -> Self {
        Self {
            caption: caption.into(),
            header: header.into_iter().map(Into::into).collect(),
            rows: Vec::new(),
        }
    }

    /// Whether a column holds numbers only, which are aligned at their end.
    pub fn is_numeric(&self, column: usize) -> bool {
        let is_number = |text: &str| {
            let mut words = text.split(' ');
            words.next().is_some_and(|word| word.parse::<f64>().is_ok())
                && words.next().is_none_or(|unit| unit == "%" || unit == "s")
                && words.next().is_none()
        };
        let cells = self.rows.iter().map(|row| row[column].as_str());
        let mut filled = cells.filter(|cell| *cell != NOTHING).peekable();
        filled.peek().is_some() && filled.all(is_number)
    }

    /// Whether a column holds sentences, commands or the like.
    pub fn is_long(&self, column: usize) -> bool {
        let mut rows = self.rows.iter();
        rows.any(|row| row[column].chars().count() > LONG)
    }
}

/// Cells longer than this are broken into lines, where there are lines to break.
const LONG: usize = 40;

/// What an empty cell shows.
pub const NOTHING: &str = "–";

/// A table that says in its first column which folder a row is of, where there are
/// several.
pub fn table_of(all: &[Results], caption: &str, header: &[&str]) -> Table {
    let folder = (all.len() > 1).then_some("folder");
    Table::new(caption, folder.into_iter().chain(header.iter().copied()))
}

/// A row of such a table.
pub fn row_of(all: &[Results], results: &Results, cells: Vec<String>) -> Vec<String> {
    let folder = (all.len() > 1).then(|| results.name.clone());
    folder.into_iter().chain(cells).collect()
}

/// A paragraph about a folder.
pub fn note(all: &[Results], results: &Results, text: impl std::fmt::Display) -> Block {
    Block::Text(named(all, results, text))
}

/// `text`, with its folder before it where there are several.
pub fn named(all: &[Results], results: &Results, text: impl std::fmt::Display) -> String {
    if all.len() > 1 {
        format!("{}: {text}", results.name)
    } else {
        text.to_string()
    }
}

/// What is said of a name.
pub fn fact(name: &str, text: String) -> (String, String) {
    (name.to_owned(), text)
}
