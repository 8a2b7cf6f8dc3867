//! The window in words.

use std::path::Path;

use crate::map::WindowSheet;
use campaign::words::wrapped;

/// The limits, the safe regions and the best point, and where the files are.
pub fn describe(sheet: &WindowSheet, folder: &Path) -> String {
    let mut text = wrapped(&sheet.title, 0, 2);
    for (heading, lines) in [
        ("limits", sheet.limits()),
        ("safe", sheet.regions()),
        ("best point", sheet.best()),
        ("not looked at", sheet.not_looked_at.clone()),
    ] {
        if lines.is_empty() {
            continue;
        }
        text += &format!("\n{heading}\n");
        text.extend(lines.iter().map(|line| wrapped(line, 2, 4)));
    }
    text.push('\n');
    for name in ["window.png", "window.svg", "window.csv"] {
        text += &format!("{}\n", folder.join(name).display());
    }
    text
}
