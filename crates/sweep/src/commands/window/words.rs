//! The window in words.

use std::path::Path;

use crate::map::WindowView;
use campaign::words::wrapped;

/// The files of a window in a folder.
pub fn files(folder: &Path) -> Vec<String> {
    let names = ["window.png", "window.svg", "window.csv"];
    let path = |name: &str| folder.join(name).display().to_string();
    names.map(path).to_vec()
}

/// The limits, the safe regions and the best point, and where the files are.
pub fn describe(view: &WindowView, files: &[String]) -> String {
    let mut text = wrapped(&view.title, 0, 2);
    for (heading, lines) in [
        ("limits", view.limits()),
        ("safe", view.regions()),
        ("best point", view.best()),
        ("not examined", view.not_examined.clone()),
        (
            "how often words of safety were wrong",
            view.how_often_wrong.clone(),
        ),
    ] {
        if lines.is_empty() {
            continue;
        }
        text += &format!("\n{heading}\n");
        text.extend(lines.iter().map(|line| wrapped(line, 2, 4)));
    }
    text.push('\n');
    text.extend(files.iter().map(|file| format!("{file}\n")));
    text
}
