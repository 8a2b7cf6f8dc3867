//! Charts of maps: symbols or cells over two parameters, with lines and marks, in groups that
//! share a legend.

mod chart;
mod panel;
#[cfg(test)]
mod tests;
mod view;

use super::fills::CellFill;
use super::geometry::Rect;
use super::line_styles::{LineStyle, Series};
use super::scale::Axis;
use super::symbols::Symbol;

pub use chart::map_chart;
pub use view::{MapAxis, map_axes};

/// A symbol at a place of a map.
#[derive(Clone, Copy)]
pub struct MapPoint {
    /// Its place.
    pub at: (f64, f64),
    /// What to draw there.
    pub symbol: Symbol,
}

/// A part of a map that has one colour.
#[derive(Debug, PartialEq)]
pub struct MapCell {
    /// Its ends along the horizontal and along the vertical axis.
    pub ends: [[f64; 2]; 2],
    /// What it shows.
    pub fill: CellFill,
}

/// A hatched range across a map, such as that of a line whose place is not known.
pub struct Band {
    /// Name in the legend.
    pub name: String,
    /// Its ends along the horizontal and along the vertical axis.
    pub ends: [[f64; 2]; 2],
}

/// A named place; one that is marked is a filled triangle with its name next to it.
pub struct Mark {
    /// Its name.
    pub name: String,
    /// Its place.
    pub at: (f64, f64),
}

/// One map.
#[derive(Default)]
pub struct MapPanel {
    /// Title above it; empty where the chart's says all.
    pub title: String,
    /// Filled cells.
    pub cells: Vec<MapCell>,
    /// Symbols; those that are not finite are skipped.
    pub points: Vec<MapPoint>,
    /// Places that the map reaches, though there is nothing at them.
    pub reached: Vec<(f64, f64)>,
    /// Lines such as the boundary of a region, cut off where they leave the range of points,
    /// cells, marks and places that are reached.
    pub lines: Vec<Series>,
    /// Hatched ranges, cut off there too.
    pub bands: Vec<Band>,
    /// Names of regions, each where it stands.
    pub names: Vec<Mark>,
}

/// Maps with the legend that they share.
#[derive(Default)]
pub struct MapGroup {
    /// Heading above them; empty where there is one group alone.
    pub heading: String,
    /// What the fills of cells mean, above their keys in the legend.
    pub scale: Option<String>,
    /// Keys of the legend and what they mean; a symbol has its fill where cells are
    /// drawn.
    pub keys: Vec<(CellFill, String)>,
    /// Other remarks.
    pub notes: Vec<String>,
    /// Paragraphs below the map, where the group is one map alone.
    pub below: Vec<String>,
    /// The maps.
    pub panels: Vec<MapPanel>,
}

/// Maps over the same two parameters.
pub struct MapChart {
    /// Title above all.
    pub title: String,
    /// Horizontal and vertical axis of every map.
    pub axes: [Axis; 2],
    /// Places that are marked on every map.
    pub marks: Vec<Mark>,
    /// Maps, group by group.
    pub groups: Vec<MapGroup>,
}

/// Whether a part of a line, which may be a single point, lies within the ranges of both
/// axes.
pub fn is_within(points: &[(f64, f64)], [[left, right], [top, bottom]]: [[f64; 2]; 2]) -> bool {
    let range = Rect {
        left,
        top,
        right,
        bottom,
    };
    match points {
        [point] => !range.clip(&[*point; 2]).is_empty(),
        points => !range.clip(points).is_empty(),
    }
}

impl MapGroup {
    /// The distinct names of all lines, and what they are drawn in.
    fn lines(&self) -> Vec<(&str, LineStyle)> {
        let mut found: Vec<(&str, LineStyle)> = Vec::new();
        for line in self.panels.iter().flat_map(|panel| &panel.lines) {
            if !found.iter().any(|(name, _)| *name == line.name) {
                found.push((&line.name, line.style));
            }
        }
        found
    }
}
