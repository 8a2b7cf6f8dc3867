//! What people read in pictures and in a terminal.

use crate::printable::steers;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// Refuses titles and names that would steer a terminal.
///
/// # Errors
/// Names the first.
pub fn check(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let sections = content
        .string
        .sections
        .iter()
        .enumerate()
        .map(|(index, section)| {
            (
                format!("string.sections[{index}].name"),
                section.name.as_deref(),
            )
        });
    let marks = content.map.marks.iter().enumerate();
    let marks =
        marks.map(|(index, mark)| (format!("map.marks[{index}].name"), Some(mark.name.as_str())));
    let title = ("title".to_owned(), content.title.as_deref());
    for (key, text) in std::iter::once(title).chain(sections).chain(marks) {
        if let Some(letter) = text.and_then(|text| text.chars().find(|&letter| steers(letter))) {
            let code = u32::from(letter);
            let message = format!("has the control character U+{code:04X}: leave it out");
            return Err(source.error(&key, message));
        }
    }
    Ok(())
}
