//! Sheets of regime maps: symbols or cells over two parameters, with boundary lines
//! and marks; a map for each motion and each value of a further parameter.

mod panel;
mod sheet;
#[cfg(test)]
mod tests;

use super::geometry::Rect;
use super::grounds::Ground;
use super::legend::distinct;
use super::scale::Axis;
use super::symbols::Symbol;

pub use sheet::map_sheet;

/// A symbol at a place of a map.
#[derive(Clone)]
pub struct MapPoint {
    /// Place along the horizontal axis.
    pub x: f64,
    /// Place along the vertical axis.
    pub y: f64,
    /// What to draw there.
    pub symbol: Symbol,
}

/// A part of a map whose cases share a colour.
pub struct MapCell {
    /// Its ends along the horizontal axis.
    pub x: [f64; 2],
    /// Its ends along the vertical axis.
    pub y: [f64; 2],
    /// What its cases are.
    pub ground: Ground,
}

/// A named line, such as the boundary of a regime.
pub struct Line {
    /// Name in the legend; lines of the same name look the same.
    pub name: String,
    /// Its corners; the line has a gap where one is not finite.
    pub points: Vec<(f64, f64)>,
}

/// A hatched range across a map, such as that of a boundary which differs from case to
/// case.
pub struct Band {
    /// Name in the legend.
    pub name: String,
    /// Its ends along the horizontal axis.
    pub x: [f64; 2],
    /// Its ends along the vertical axis.
    pub y: [f64; 2],
}

/// A named place: a filled triangle with its name beside it.
pub struct Mark {
    /// Name beside the triangle.
    pub name: String,
    /// Place along the horizontal axis.
    pub x: f64,
    /// Place along the vertical axis.
    pub y: f64,
}

/// One map.
#[derive(Default)]
pub struct MapPanel {
    /// Title above it; empty where the sheet's says all.
    pub title: String,
    /// Filled cells.
    pub cells: Vec<MapCell>,
    /// Symbols; those that are not finite are skipped.
    pub points: Vec<MapPoint>,
    /// Lines, cut off where they leave the range of points, cells and marks.
    pub lines: Vec<Line>,
    /// Hatched ranges, cut off there too.
    pub bands: Vec<Band>,
    /// Marked places.
    pub marks: Vec<Mark>,
}

/// Maps of one motion, with the legend that they share.
pub struct MapGroup {
    /// Heading above them; empty where there is one group alone.
    pub heading: String,
    /// What the grounds of cells tell, above their keys in the legend.
    pub scale: Option<String>,
    /// Keys of the legend and what they mean; a symbol has its ground where cells are
    /// drawn.
    pub keys: Vec<(Ground, String)>,
    /// What a reader has to know besides.
    pub notes: Vec<String>,
    /// The maps.
    pub panels: Vec<MapPanel>,
}

/// Regime maps over the same two parameters.
pub struct MapSheet {
    /// Title above all.
    pub title: String,
    /// Horizontal axis of every map.
    pub x: Axis,
    /// Vertical axis of every map.
    pub y: Axis,
    /// Maps, motion by motion.
    pub groups: Vec<MapGroup>,
}

/// Whether a part of a line lies within two ranges.
pub fn is_within(points: &[(f64, f64)], x: [f64; 2], y: [f64; 2]) -> bool {
    let range = Rect {
        left: x[0],
        top: y[0],
        right: x[1],
        bottom: y[1],
    };
    !range.clip(points).is_empty()
}

impl MapGroup {
    /// The distinct names of all lines.
    fn line_names(&self) -> Vec<&str> {
        let lines = self.panels.iter().flat_map(|panel| &panel.lines);
        distinct(lines.map(|line| &line.name))
    }
}
