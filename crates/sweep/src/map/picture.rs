//! The picture of a results folder: its maps with their legends and notes.

use anyhow::Result;

use super::cases::MapCases;
use super::content::Content;
use super::limits::{Limits, View};
use super::words;
use crate::output::{Curve, Manifest, Motion, ResultTables};
use crate::plan::{MapMark, MapSettings};
use crate::plot::{self, MapGroup, MapPanel, MapSheet, Mark, Picture, map_sheet};
use crate::quantities::Axis;

/// Draws the map of a results folder's tables; none where its design has no two axes.
///
/// # Errors
/// Where a file cannot be read.
pub fn picture(tables: &ResultTables) -> Result<Option<Picture>> {
    let manifest = &tables.manifest;
    let Some(settings) = &manifest.map else {
        return Ok(None);
    };
    let map = Map::read(tables, settings)?;
    let motions = map.cases.extent.motions.iter();
    let sheet = MapSheet {
        title: match tables.so_far {
            None => manifest.title.clone(),
            Some(so_far) => format!("{} ({so_far})", manifest.title),
        },
        x: plot::Axis::linear(settings.x.title()),
        y: plot::Axis::linear(settings.y.title()),
        groups: motions
            .map(|&motion| map.group(motion))
            .collect::<Result<_>>()?,
    };
    map_sheet(&sheet).map(Some)
}

/// What a map is made from.
struct Map<'a> {
    manifest: &'a Manifest,
    settings: &'a MapSettings,
    cases: MapCases,
    curves: Vec<Curve>,
}

impl<'a> Map<'a> {
    fn read(tables: &'a ResultTables, settings: &'a MapSettings) -> Result<Self> {
        let manifest = &tables.manifest;
        Ok(Self {
            cases: MapCases::read(tables, settings)?,
            curves: tables.boundary()?.curves(&manifest.axes),
            manifest,
            settings,
        })
    }

    /// The maps of a motion.
    fn group(&self, motion: Motion) -> Result<MapGroup> {
        let contents = Content::read(&self.cases, motion)?;
        let curves = self.curves.iter().filter(|curve| curve.motion == motion);
        let curves: Vec<&Curve> = curves.collect();
        let mut notes = Vec::new();
        let mut panels = Vec::with_capacity(contents.len());
        let (marks, left_out) = self.marks();
        let keys = words::keys(&contents, self.manifest, motion);
        let scale = self.scale(motion, &contents);
        let untold = words::untold(&contents, motion);
        for (index, content) in contents.into_iter().enumerate() {
            let title = self.panel_title(index);
            let held = |axis| self.held(index, axis);
            let limits = Limits::of(&curves, &self.view(), held);
            notes.extend(limits.notes.into_iter().map(|note| (title.clone(), note)));
            let marks = marks.iter().map(|mark| Mark {
                name: mark.name.clone(),
                x: mark.x,
                y: mark.y,
            });
            panels.push(MapPanel {
                title,
                cells: content.cells,
                points: content.points,
                lines: limits.lines,
                bands: limits.bands,
                marks: marks.collect(),
            });
        }
        let mut notes = words::once_if_the_same(notes, panels.len());
        if curves.is_empty() && self.cases.extent.motions.len() > 1 {
            notes.push("boundary.csv has no limit of this motion".to_owned());
        }
        notes.extend(untold);
        notes.extend(left_out);
        Ok(MapGroup {
            heading: match self.cases.extent.motions.len() {
                1 => String::new(),
                _ => motion.title().to_owned(),
            },
            scale,
            keys,
            notes,
            panels,
        })
    }

    /// What the maps show along their axes.
    fn view(&self) -> View {
        View {
            axes: self.cases.on_map,
            ranges: self.cases.extent.ranges,
        }
    }

    /// The values of the other axes that a map is of.
    fn panel_title(&self, index: usize) -> String {
        let values = match self.cases.combinations() {
            Some(combinations) if combinations.len() > 1 => &combinations[index],
            _ => return String::new(),
        };
        let axes = self.cases.others.iter().zip(values);
        let titles: Vec<String> = axes
            .map(|(&axis, &value)| words::equation(axis, value))
            .collect();
        titles.join(", ")
    }

    /// The range of a quantity that is not on a map: of the cases that are.
    fn held(&self, index: usize, axis: Axis) -> [f64; 2] {
        let of_sweep = self.manifest.sweep.surface_speed_rpm;
        let fixed = of_sweep.filter(|_| axis == Axis::SurfaceSpeedRpm);
        let Some(place) = self.cases.others.iter().position(|&other| other == axis) else {
            return fixed.map_or([f64::NEG_INFINITY, f64::INFINITY], |speed| [speed; 2]);
        };
        let combination = self.cases.combinations().and_then(|all| all.get(index));
        match combination {
            Some(values) => [values[place]; 2],
            None => self.cases.extent.other_ranges[place],
        }
    }

    /// What the grounds of cells tell, where they tell of parts.
    fn scale(&self, motion: Motion, contents: &[Content]) -> Option<String> {
        let is_of_parts = contents.iter().any(Content::is_of_parts);
        let others = self.cases.others.iter();
        let ranges = others.zip(&self.cases.extent.other_ranges);
        let over = ranges.map(|(&axis, &range)| words::range(axis, range));
        is_of_parts.then(|| words::scale(motion, self.manifest, self.cases.extent.cases, over))
    }

    /// The marks within the range of the design, and a note on those that are not,
    /// such as a base's that were meant for other ranges.
    fn marks(&self) -> (Vec<&MapMark>, Option<String>) {
        let View { axes, ranges } = self.view();
        let table = self.manifest.sweep.design.as_ref();
        let is_inside = |axis: usize, value: f64| {
            let of_design = table.and_then(|table| table.axes.get(&axes[axis])?.ends());
            let [low, high] = of_design.unwrap_or(ranges[axis]);
            // A weight that was found from a torque is rounded.
            let room = 1e-9 * low.abs().max(high.abs());
            (low - room..=high + room).contains(&value)
        };
        let (inside, outside): (Vec<_>, Vec<_>) = (self.settings.marks.iter())
            .partition(|mark| is_inside(0, mark.x) && is_inside(1, mark.y));
        (inside, words::left_out(&outside, axes))
    }
}
