//! What people read in pictures and in a terminal.

use crate::printable::steers;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// Refuses titles and names that would steer a terminal.
///
/// # Errors
/// Names the first.
pub fn check(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let check = |key: &str, text: Option<&String>| {
        let Some(letter) = text.and_then(|text| text.chars().find(|&letter| steers(letter))) else {
            return Ok(());
        };
        let code = u32::from(letter);
        let message = format!("has the control character U+{code:04X}: leave it out");
        Err(source.error(key, message))
    };
    check("title", content.title.as_ref())?;
    for (index, section) in content.string.sections.iter().enumerate() {
        check(
            &format!("string.sections[{index}].name"),
            section.name.as_ref(),
        )?;
    }
    for (index, mark) in content.map.marks.iter().enumerate() {
        check(&format!("map.marks[{index}].name"), Some(&mark.name))?;
    }
    Ok(())
}
