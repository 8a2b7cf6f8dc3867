//! The legend of maps: a list of the page.

use super::look::{LINES, class_of_fill, class_of_symbol, symbol_path};
use crate::report::escaping::{escaped, with_index};
use plot::{CellFill, MapGroup, Symbol};

/// The middle of a key, and the radius of its symbol.
const MIDDLE: (f64, f64) = (20.0, 8.0);
const RADIUS: f64 = 5.0;

/// What the symbols, fills, lines and ranges of a group mean.
pub fn keys(group: &MapGroup, names: &[&str]) -> String {
    let has_cells = group.panels.iter().any(|panel| !panel.cells.is_empty());
    let fills = group.keys.iter();
    let mut items: Vec<(String, &str)> = fills
        .map(|(fill, text)| (of_fill(*fill, has_cells), text.as_str()))
        .collect();
    let lines = names.iter().enumerate();
    items.extend(lines.map(|(place, name)| {
        let look = place % LINES;
        let line = format!("<path class=\"line l{look}\" d=\"M0 8H40\"></path>");
        (line, *name)
    }));
    let mut ranges: Vec<&str> = Vec::new();
    for band in group.panels.iter().flat_map(|panel| &panel.bands) {
        if !ranges.contains(&band.name.as_str()) {
            ranges.push(&band.name);
        }
    }
    let hatched = || "<path class=\"range\" d=\"M4 1H36V15H4z\"></path>".to_owned();
    items.extend(ranges.into_iter().map(|name| (hatched(), name)));
    let scale = group.scale.as_ref().map_or_else(String::new, |scale| {
        format!("<p class=\"note\">{}</p>\n", with_index(&escaped(scale)))
    });
    let items = items.into_iter().map(|(key, text)| {
        format!(
            "<li><svg class=\"key\" viewBox=\"0 0 40 16\" aria-hidden=\"true\">{key}</svg> <span>{}</span></li>\n",
            with_index(&escaped(text))
        )
    });
    format!(
        "{scale}<ul class=\"keys\">\n{}</ul>\n",
        items.collect::<String>()
    )
}

/// A fill with the symbol that it stands for; a symbol alone where maps have no cells.
fn of_fill(fill: CellFill, has_cells: bool) -> String {
    let cell = |frame: &str| {
        let class = class_of_fill(fill);
        format!("<path class=\"cell {class}{frame}\" d=\"M4 1H36V15H4z\"></path>")
    };
    match fill {
        CellFill::Symbol(symbol) if has_cells => cell("") + &of_symbol(symbol),
        CellFill::Symbol(symbol) => of_symbol(symbol),
        // A fill may be as light as the page.
        CellFill::Fraction(_) | CellFill::Safety(_) | CellFill::NoCase => cell(" framed"),
    }
}

fn of_symbol(symbol: Symbol) -> String {
    let (class, path) = (class_of_symbol(symbol), symbol_path(symbol, MIDDLE, RADIUS));
    format!("<path class=\"symbol {class}\" d=\"{path}\"></path>")
}
