//! What is drawn of a results folder: its maps with their legends and notes.

use sim::Motion;
use std::path::PathBuf;

use anyhow::Result;

use super::content::Content;
use super::extent::Extent;
use super::limits::Limits;
use super::shown::{plot_axis, show_in};
use super::traced::TracedMap;
use super::words;
use super::{measures, misfits};
use campaign::plan::MapMark;
use campaign::quantities::Axis;
use limits::Curve;
use plot::{MapChart, MapGroup, MapPanel, Mark};
use results::folder::{Manifest, ResultTables};
use results::traced::TracedLimits;

/// What is drawn of a results folder, and which cases each of its maps has.
pub struct MapDrawing {
    /// The maps: those of each motion, then others.
    pub chart: MapChart,
    /// What the horizontal and the vertical axis are.
    pub axes: [Axis; 2],
    /// The motions with separate maps, one for each of the `combinations`.
    pub motions: Vec<Motion>,
    /// Further axes.
    pub others: Vec<Axis>,
    /// The values of those that each map of a motion is of; of one that is of all, none.
    pub combinations: Vec<Vec<f64>>,
}

/// What a map shows; none where the design has no two axes.
///
/// # Errors
/// Where a file cannot be read.
pub fn drawing(tables: &ResultTables) -> Result<Option<MapDrawing>> {
    let manifest = &tables.manifest;
    let Some(settings) = &manifest.map else {
        return Ok(None);
    };
    let (axes, units) = ([settings.x, settings.y], manifest.sweep.units);
    let others = manifest.axes.iter().copied();
    // Starts by chance lie on top of one another: how many of them, is how sure a label is.
    let others = others.filter(|axis| !axes.contains(axis) && *axis != Axis::StartNumber);
    let others = others.collect();
    let labels = tables.folder.join("labels.csv");
    let design = manifest.traced_design();
    let traced = match &design {
        Some(design) => TracedLimits::read(&labels, design, &manifest.method_names())?,
        None => None,
    };
    let map = Map {
        manifest,
        extent: Extent::of(&labels, axes, others, &manifest.sweep)?
            .with_starts(manifest.axes.contains(&Axis::StartNumber)),
        labels,
        traced,
        curves: curves(tables)?,
    };
    let (marks, left_out) = map.marks(&settings.marks);
    let motions = map.extent.motions.iter();
    let coloured = settings.colour.map(|measure| {
        let Map { labels, extent, .. } = &map;
        measures::group(labels, extent, manifest, measure)
    });
    let mut chart = MapChart {
        title: match tables.so_far {
            None => manifest.title.clone(),
            Some(so_far) => format!("{} ({so_far})", manifest.title),
        },
        axes: [0, 1].map(|axis| plot_axis(axes[axis], map.extent.spacing[axis], units)),
        marks,
        groups: motions
            .map(|&motion| map.group(motion, left_out.as_ref()))
            .chain(coloured)
            .chain(misfits::group(&map.labels, &map.extent).transpose())
            .collect::<Result<_>>()?,
    };
    show_in(&mut chart, axes.map(|axis| axis.unit(units)));
    let extent = map.extent;
    Ok(Some(MapDrawing {
        chart,
        axes,
        combinations: (extent.combinations())
            .map_or_else(|| vec![Vec::new()], <[Vec<f64>]>::to_vec),
        motions: extent.motions,
        others: extent.others,
    }))
}

/// The limits of a folder: those of `boundary.csv`, and that of forward motion.
fn curves(tables: &ResultTables) -> Result<Vec<Curve>> {
    let manifest = &tables.manifest;
    let units = manifest.sweep.units;
    let mut curves = tables.boundary()?.curves(&manifest.axes, units);
    let forward = manifest.forward_contact.as_ref();
    curves.extend(forward.and_then(|forward| forward.curve(units)));
    Ok(curves)
}

/// What a map is made from.
struct Map<'a> {
    manifest: &'a Manifest,
    /// Its `labels.csv`.
    labels: PathBuf,
    extent: Extent,
    /// What a traced design has found, where it is finished.
    traced: Option<TracedLimits<'a>>,
    curves: Vec<Curve>,
}

impl Map<'_> {
    /// The maps of a motion, with a note on marks that are on none.
    fn group(&self, motion: Motion, left_out: Option<&String>) -> Result<MapGroup> {
        let contents = match &self.traced {
            Some(limits) => vec![self.traced(limits).content(motion)],
            None => Content::read(&self.labels, &self.extent, motion)?,
        };
        let curves = self.curves.iter().filter(|curve| curve.motion == motion);
        let curves: Vec<&Curve> = curves.collect();
        let keys = words::keys(&contents, self.manifest, motion);
        let scale = self.scale(motion, &contents);
        let undetermined = words::undetermined(&contents, motion);
        let mut notes = Vec::new();
        let panels = contents.into_iter().enumerate().map(|(index, content)| {
            let title = self.panel_title(index);
            let limits = Limits::of(&curves, &self.extent, |axis| self.held(index, axis));
            notes.extend(limits.notes.into_iter().map(|note| (title.clone(), note)));
            MapPanel {
                title,
                cells: content.cells,
                points: content.points,
                reached: self.extent.corners(),
                lines: limits.lines,
                bands: limits.bands,
                ..MapPanel::default()
            }
        });
        let panels: Vec<MapPanel> = panels.collect();
        let mut notes = words::once_if_the_same(notes, panels.len());
        let is_alone = self.extent.motions.len() == 1;
        if curves.is_empty() && !is_alone {
            notes.push("no limit of this motion is drawn".to_owned());
        }
        notes.extend(undetermined);
        notes.extend(left_out.cloned());
        let heading = if is_alone { "" } else { motion.title() };
        Ok(MapGroup {
            heading: heading.to_owned(),
            scale,
            keys,
            notes,
            panels,
            ..MapGroup::default()
        })
    }

    /// A traced design with the axes of the map.
    fn traced<'a>(&self, limits: &'a TracedLimits) -> TracedMap<'a> {
        let is_upright = self.manifest.axes.first() == Some(&self.extent.axes[0]);
        TracedMap {
            limits,
            methods: self.manifest.methods.len(),
            places: if is_upright { [0, 1] } else { [1, 0] },
            spacing: self.extent.spacing,
            simulated: self.extent.cases,
        }
    }

    /// The values of the other axes that a map is of.
    fn panel_title(&self, index: usize) -> String {
        let values = match self.extent.combinations() {
            Some(combinations) if combinations.len() > 1 => &combinations[index],
            _ => return String::new(),
        };
        let axes = self.extent.others.iter().zip(values);
        let titles: Vec<String> = axes
            .map(|(&axis, &value)| words::equation(axis, value, self.extent.units))
            .collect();
        titles.join(", ")
    }

    /// The range of a quantity that is not on a map: of the cases that are.
    fn held(&self, index: usize, axis: Axis) -> [f64; 2] {
        let of_sweep = self.manifest.sweep.surface_speed_rpm;
        let fixed = of_sweep.filter(|_| axis == Axis::SurfaceSpeedRpm);
        let Some(place) = self.extent.others.iter().position(|&other| other == axis) else {
            return fixed.map_or([f64::NEG_INFINITY, f64::INFINITY], |speed| [speed; 2]);
        };
        let combination = self.extent.combinations().and_then(|all| all.get(index));
        match combination {
            Some(values) => [values[place]; 2],
            None => self.extent.other_ranges[place],
        }
    }

    /// What the fills of cells show, where they are classes of fractions.
    fn scale(&self, motion: Motion, contents: &[Content]) -> Option<String> {
        let is_of_parts = contents.iter().any(Content::is_of_parts);
        if let Some(trace) = &self.manifest.trace {
            return is_of_parts.then(|| words::ragged(motion, self.manifest, trace));
        }
        let others = self.extent.others.iter();
        let ranges = others.zip(&self.extent.other_ranges);
        let over = ranges.map(|(&axis, &range)| words::range(axis, range, self.extent.units));
        let starts = self
            .extent
            .has_starts
            .then(|| "starts by chance".to_owned());
        let over = over.chain(starts);
        is_of_parts.then(|| words::scale(motion, self.manifest, self.extent.cases, over))
    }

    /// The marks within the range of the design, and a note on those that are not,
    /// such as a base's that were meant for other ranges.
    fn marks(&self, marks: &[MapMark]) -> (Vec<Mark>, Option<String>) {
        let Extent { axes, ranges, .. } = &self.extent;
        let table = self.manifest.sweep.design.as_ref();
        let is_inside = |axis: usize, value: f64| {
            let of_design = table.and_then(|table| table.axes.get(&axes[axis])?.ends());
            let [low, high] = of_design.unwrap_or(ranges[axis]);
            // A weight that was found from a torque is rounded.
            let room = 1e-9 * low.abs().max(high.abs());
            (low - room..=high + room).contains(&value)
        };
        let (inside, outside): (Vec<_>, Vec<_>) =
            (marks.iter()).partition(|mark| is_inside(0, mark.x) && is_inside(1, mark.y));
        let inside = inside.into_iter().map(|mark| Mark {
            name: mark.name.clone(),
            at: (mark.x, mark.y),
        });
        let note = words::left_out(&outside, *axes, self.extent.units);
        (inside.collect(), note)
    }
}
