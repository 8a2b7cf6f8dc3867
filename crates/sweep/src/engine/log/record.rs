//! A line of a log after its first: a case done by one method.

use super::line::{checked, parse_line};

/// A case done by one method.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Record {
    /// Number of the case.
    pub case: usize,
    /// The method's place in the sweep's list.
    pub method: usize,
    /// Why there is no answer.
    pub reason: Option<String>,
    /// The row of `labels.csv`.
    pub row: String,
}

impl Record {
    /// Its line of a log.
    pub fn line(&self) -> String {
        checked(&format!(
            "{}\t{}\t{}\t{}",
            self.case,
            self.method,
            one_line(self.reason.as_deref().unwrap_or_default()),
            self.row
        ))
    }

    /// What a line says, if it is a whole record.
    pub(super) fn parse(line: &[u8]) -> Option<Self> {
        let mut fields = parse_line(line)?.splitn(4, '\t');
        Some(Self {
            case: fields.next()?.parse().ok()?,
            method: fields.next()?.parse().ok()?,
            reason: fields
                .next()
                .map(str::to_owned)
                .filter(|reason| !reason.is_empty()),
            row: fields.next()?.to_owned(),
        })
    }
}

/// Tabs and line breaks have a meaning here.
fn one_line(text: &str) -> String {
    text.replace(|letter: char| letter.is_control(), " ")
}
