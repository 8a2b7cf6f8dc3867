//! A table in a file that a key of the sweep file names, and errors with the place in both.

use std::path::Path;

use super::error::SweepFileError;
use super::source::{Source, TextOf};
use crate::tables::{Columns, Heading, Table, Wanted};

/// A table, and where it comes from.
pub struct NamedTable<'source> {
    source: &'source Source,
    key: &'source str,
    /// Its file, as messages name it.
    file: String,
    /// What is in it.
    pub table: Table,
}

impl<'source> NamedTable<'source> {
    /// Reads the file that a `key` names, whose headings are the first row that can be, by
    /// `is_header`.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn read(
        source: &'source Source,
        key: &'source str,
        file: &str,
        text_of: TextOf,
        is_header: &dyn Fn(&[Heading]) -> bool,
    ) -> Result<Self, SweepFileError> {
        let path = source.folder_of(key).join(file);
        let file = path.display().to_string();
        let table = Table::read(Path::new(&path), text_of, is_header)
            .map_err(|message| source.error(key, format!("{file}{message}")))?;
        Ok(Self {
            source,
            key,
            file,
            table,
        })
    }

    /// The columns of what is wanted.
    ///
    /// # Errors
    /// Where one is missing, is there twice, or has no unit that is known.
    pub fn columns<Q: Copy + PartialEq>(
        &self,
        wanted: &[Wanted<Q>],
    ) -> Result<Columns<Q>, SweepFileError> {
        let is_numeric = |place| self.table.is_numeric(place);
        let found = Columns::find(&self.table.headings, wanted, &is_numeric);
        found.map_err(|message| self.header_error(&message))
    }

    /// An error of the headings, with those that are there.
    pub fn header_error(&self, message: &str) -> SweepFileError {
        let names = self.table.names();
        self.error(Some(self.table.header_line), &format!("{message}; {names}"))
    }

    /// An error of a line, where it is of one.
    pub fn error(&self, line: Option<usize>, message: &str) -> SweepFileError {
        let line = line.map_or(String::new(), |line| format!(":{line}"));
        let file = &self.file;
        self.source
            .error_verbatim(self.key, format!("{file}{line}: {message}"))
    }
}
