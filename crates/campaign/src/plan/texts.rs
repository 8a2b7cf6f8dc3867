//! What people read in pictures and in a terminal, and the name of a sweep.

use crate::printable::{is_noncharacter, steers};
use crate::sweep_file::{FileContent, Source, SweepFileError};
use crate::text_file::is_standard_input;

/// The name of a sweep from standard input that gives none.
const NAMELESS: &str = "sweep";

/// Bytes of a name, which is that of a folder.
const LONGEST_NAME: usize = 200;

/// The name of a sweep: its own, or that of its file without the ending.
///
/// # Errors
/// Where its own is no name of a folder.
pub fn name(source: &Source, content: &FileContent) -> Result<String, SweepFileError> {
    if let Some(name) = &content.name {
        let is_no_folder = name.trim() != name
            || ["", ".", ".."].contains(&name.as_str())
            || name.contains(['/', '\\', ':'])
            || name.len() > LONGEST_NAME;
        let message = "names a folder: no path, no space around it, at most 200 bytes";
        source.refuse_if(is_no_folder, "name", message)?;
        return Ok(name.clone());
    }
    let file = source.file();
    let stem = file.file_stem().filter(|_| !is_standard_input(file));
    Ok(stem.map_or_else(
        || NAMELESS.to_owned(),
        |stem| stem.to_string_lossy().into_owned(),
    ))
}

/// Refuses titles and names that would steer a terminal, or that no picture can hold.
///
/// # Errors
/// Names the first.
pub fn check(source: &Source, content: &FileContent) -> Result<(), SweepFileError> {
    let own = [("name", &content.name), ("title", &content.title)];
    let own = (own.into_iter()).filter_map(|(key, text)| Some((key.to_owned(), text.as_ref()?)));
    let sections = content.string.sections.iter().enumerate();
    let sections = sections.flat_map(|(index, section)| {
        let key = format!("string.sections[{index}].name");
        section.name.as_ref().map(|name| (key, name))
    });
    let marks = content.map.marks.iter().enumerate();
    let marks = marks.map(|(index, mark)| (format!("map.marks[{index}].name"), &mark.name));
    for (key, text) in own.chain(sections).chain(marks) {
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
