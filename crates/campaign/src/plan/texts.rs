//! What people read in pictures and in a terminal.

use crate::printable::{is_noncharacter, steers};
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// Refuses titles and names that would steer a terminal, or that no picture can hold.
///
/// # Errors
/// Names the first.
pub fn check(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let title = content
        .title
        .iter()
        .map(|title| ("title".to_owned(), title));
    let sections = content.string.sections.iter().enumerate();
    let sections = sections.flat_map(|(index, section)| {
        let key = format!("string.sections[{index}].name");
        section.name.as_ref().map(|name| (key, name))
    });
    let marks = content.map.marks.iter().enumerate();
    let marks = marks.map(|(index, mark)| (format!("map.marks[{index}].name"), &mark.name));
    for (key, text) in title.chain(sections).chain(marks) {
        let is_refused = |&letter: &char| steers(letter) || is_noncharacter(letter);
        if let Some(letter) = text.chars().find(is_refused) {
            let kind = if steers(letter) {
                "control character"
            } else {
                "noncharacter"
            };
            let code = u32::from(letter);
            let message = format!("has the {kind} U+{code:04X}: leave it out");
            return Err(source.error(&key, message));
        }
    }
    Ok(())
}
