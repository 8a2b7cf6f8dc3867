//! The cells of a file: of CSV, or of the first sheet of a workbook.

use std::path::Path;

#[cfg(feature = "workbooks")]
use super::grid::Line;
use super::grid::TextGrid;
use super::hand_table;
use crate::text_file::{LARGEST_SWEEP_FILE, TextOf};

/// The cells of a file.
///
/// # Errors
/// Why it cannot be read; follows the file's name.
pub fn read(path: &Path, text_of: TextOf) -> Result<TextGrid, String> {
    let unreadable = |reason: String| format!(" cannot be read: {reason}");
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    match ending.to_ascii_lowercase().as_str() {
        ending @ ("xlsx" | "xlsm" | "ods") => {
            let lines = workbook_lines(path, ending).map_err(unreadable)?;
            Ok(TextGrid {
                lines,
                separator: None,
            })
        }
        "xls" | "xlsb" => Err(unreadable(
            "workbooks are read as .xlsx, .xlsm or .ods, not in this binary format: save it as one \
             of these, or as CSV"
                .to_owned(),
        )),
        _ => {
            let text = text_of(path, LARGEST_SWEEP_FILE)
                .map_err(|error| unreadable(error.to_string()))?;
            hand_table::grid(&text).map_err(|mistake| format!(":{mistake}"))
        }
    }
}

#[cfg(not(feature = "workbooks"))]
fn workbook_lines(_: &Path, _: &str) -> Result<Vec<super::grid::Line>, String> {
    Err("this build reads no workbooks: save it as CSV".to_owned())
}

#[cfg(feature = "workbooks")]
fn workbook_lines(path: &Path, ending: &str) -> Result<Vec<Line>, String> {
    use super::{open_document, workbook};
    let metadata = std::fs::metadata(path).map_err(|error| error.to_string())?;
    if !metadata.is_file() || metadata.len() > LARGEST_SWEEP_FILE {
        let most = LARGEST_SWEEP_FILE >> 20;
        return Err(format!("it is no file of at most {most} MiB"));
    }
    let bytes = std::fs::read(path).map_err(|error| error.to_string())?;
    match ending {
        "ods" => open_document::lines(bytes),
        _ => workbook::lines(bytes),
    }
}
