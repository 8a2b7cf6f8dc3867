//! The window in words.

use std::path::Path;

use crate::map::WindowView;
use campaign::words::wrapped;

/// The limits, the safe regions and the best point, and where the files are.
pub fn describe(view: &WindowView, folder: &Path) -> String {
    let mut text = wrapped(&view.title, 0, 2);
    for (heading, lines) in [
        ("limits", view.limits()),
        ("safe", view.regions()),
        ("best point", view.best()),
        ("not examined", view.not_examined.clone()),
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
