//! A regime map that a page draws itself: an SVG in the page's colours with words around it
//! that do not shrink with it, and what its cases are, for who points at one.
//!
//! `panel` draws one map, `keys` its legend, `by_method` are the maps of each method; `look` names what a style sheet colours. `data`
//! has the cases, and `opening` the sweep that they are of.

mod by_method;
mod data;
mod keys;
mod look;
mod opening;
mod panel;

use anyhow::Result;
use serde_json::Value;

use super::escaping::{escaped, with_index};
use crate::map::{MapDrawing, drawing};
use plot::{MapGroup, map_axes};
use results::folder::ResultTables;

pub use data::shown;
pub use look::DEFINITIONS;
pub use panel::panel;

/// The looks of maps.
pub const STYLE: &str = concat!(include_str!("../../page/plot.css"), include_str!("map.css"));

/// What makes maps answer: the engine's client, charts, pictures in large, a case's motion, and the
/// maps.
pub const SCRIPT: &str = concat!(
    include_str!("../../page/engine.js"),
    include_str!("../../page/plot.js"),
    include_str!("../../page/zoom.js"),
    include_str!("history.js"),
    include_str!("map.js")
);

/// The engine, as `scripts/renew-page-engine.sh` makes it.
pub const ENGINE: &[u8] = include_bytes!("../../page/engine.wasm.gz");

/// Numbers along an axis: as many as a phone has room for.
const MOST_TICKS: usize = 6;

/// A map in a page.
pub struct LiveMap {
    /// The maps and their legends, as HTML.
    pub html: String,
    /// Their cases, where the page has room for them.
    pub data: Option<Value>,
}

/// Bytes that the cases of a page take at most: with the engine it stays below 3 MB.
const MOST_BYTES: usize = 1_450_000;

/// Draws what a folder's map shows, one of a number on the page; `None` where its design does not
/// have two axes.
///
/// # Errors
/// Where a table cannot be read.
pub fn live_map(tables: &ResultTables, folders: usize) -> Result<Option<LiveMap>> {
    let Some(mut drawing) = drawing(tables)? else {
        return Ok(None);
    };
    let each = by_method::groups(tables, &drawing)?;
    drawing.chart.groups.extend(each);
    let data = data::data(tables, &drawing, MOST_BYTES / folders.max(1))?;
    let mut html = html(&drawing);
    if data.is_none() {
        let rows = tables.manifest.tally.rows;
        html += &format!(
            "<p class=\"note\">{rows} simulations are more than this page has room for: it holds \
             none of their values, and the map does not answer.</p>\n"
        );
    }
    Ok(Some(LiveMap { html, data }))
}

fn html(drawing: &MapDrawing) -> String {
    let axes = map_axes(&drawing.chart, MOST_TICKS);
    let groups = drawing.chart.groups.iter().map(|group| {
        let panels = group.panels.iter().map(|panel| {
            let names = line_names(group);
            panel::panel(&axes, &drawing.chart.marks, panel, &names)
        });
        let heading = match group.heading.as_str() {
            "" => String::new(),
            heading => format!("<h3>{}</h3>\n", with_index(&escaped(heading))),
        };
        let notes = group.notes.iter().chain(&group.below);
        let notes =
            notes.map(|note| format!("<p class=\"note\">{}</p>\n", with_index(&escaped(note))));
        format!(
            "<div class=\"group\">\n{heading}<div class=\"panels\">\n{}</div>\n{}{}</div>\n",
            panels.collect::<String>(),
            keys::keys(group, &line_names(group)),
            notes.collect::<String>()
        )
    });
    groups.collect()
}

/// The distinct names of the lines of a group: what has the same name looks the same.
fn line_names(group: &MapGroup) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for line in group.panels.iter().flat_map(|panel| &panel.lines) {
        if !names.contains(&line.name.as_str()) {
            names.push(&line.name);
        }
    }
    names
}
