//! What a traced design delivers: `limits.csv`, the lines of its limits, and `bands.csv`,
//! which fraction of a tile has the regime where a limit is no line.

use sim::Motion;
use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result};

use crate::analysis::wilson;
use crate::files::write_with_checksum;
use crate::folder::{LimitSummary, Manifest, TraceSummary, read_cases};
use campaign::design::TraceDesign;
use campaign::rounds::{layer, note_labels, nothing_known};
use campaign::trace::{Band, Class, Known, LimitLine, Next, Tile, Traced, contours, next};

/// What a traced design has found.
pub struct TracedLimits<'a> {
    design: &'a TraceDesign,
    methods: Vec<String>,
    traced: Traced,
    /// What was simulated, before the points in between are inferred from it.
    known: Known,
    simulated: usize,
}

impl<'a> TracedLimits<'a> {
    /// By a `labels.csv`; none where it does not hold all that was wanted.
    ///
    /// # Errors
    /// Where it cannot be read.
    pub fn read(labels: &Path, design: &'a TraceDesign, methods: &[&str]) -> Result<Option<Self>> {
        let mut known = nothing_known(design.lattice, methods.len());
        let mut simulated = 0;
        for case in read_cases(labels, &[])? {
            let case = case?;
            simulated += 1;
            for row in &case.rows {
                let method = methods.iter().position(|method| *method == row.method);
                if let (Some(method), true) = (method, case.case < design.lattice.points()) {
                    note_labels(&mut known, case.case, method, row.labels);
                }
            }
        }
        Ok(match next(&known, design.seed) {
            Next::Wanted(_) => None,
            Next::Done(traced) => Some(Self {
                design,
                methods: methods.iter().map(|&name| name.to_owned()).collect(),
                traced: *traced,
                known,
                simulated,
            }),
        })
    }

    /// The class of the point at a place by a method.
    pub fn class(&self, method: usize, motion: Motion, place: [usize; 2]) -> Class {
        self.traced.classes.at(layer(method, motion), place)
    }

    /// Whether the point at a place was simulated.
    pub fn was_simulated(&self, place: [usize; 2]) -> bool {
        self.known.has(place)
    }

    /// Where the limit of a motion by a method is no line.
    pub fn bands(&self, method: usize, motion: Motion) -> &[Band] {
        &self.traced.bands[layer(method, motion)]
    }

    /// A tile by a method, whether its own limit is ragged there or another's.
    pub fn band_of(&self, method: usize, motion: Motion, tile: Tile) -> Band {
        let mut bands = self.bands(method, motion).iter();
        let own = bands.find(|band| band.tile == tile).copied();
        let classes = &self.traced.classes;
        own.unwrap_or_else(|| Band::of_points(classes, layer(method, motion), tile, tile.own()))
    }

    /// The values of both axes, in the order of the columns.
    pub fn values(&self) -> [&[f64]; 2] {
        self.design.values()
    }

    /// The lines of the limits of a motion by a method.
    fn lines(&self, method: usize, motion: Motion) -> Vec<LimitLine> {
        contours(&self.traced, layer(method, motion))
    }

    fn each(&self) -> impl Iterator<Item = (usize, &str, Motion)> {
        let methods = self.methods.iter().enumerate();
        methods.flat_map(|(method, name)| Motion::ALL.map(|motion| (method, name.as_str(), motion)))
    }

    /// `limits.csv`: points of each line in turn, in the order of the design's axes; the
    /// limit crosses within the distance given along either axis.
    fn limits_csv(&self, axes: &[String]) -> Result<String> {
        let [x, y] = self.design.values();
        let mut text = format!(
            "method,motion,line,{0},{1},{0}_within,{1}_within\n",
            axes[0], axes[1]
        );
        for (method, name, motion) in self.each() {
            for (line, points) in self.lines(method, motion).iter().enumerate() {
                for &[column, row] in points {
                    let (x, x_within) = between(x, column);
                    let (y, y_within) = between(y, row);
                    let key = motion.name();
                    writeln!(text, "{name},{key},{line},{x},{y},{x_within},{y_within}")?;
                }
            }
        }
        Ok(text)
    }

    /// `bands.csv`: a row for each tile, with its classified cases and the fraction of them that
    /// has the regime, with Wilson's interval at 95 %.
    fn bands_csv(&self, axes: &[String]) -> Result<String> {
        let [x, y] = self.design.values();
        let mut text = format!(
            "method,motion,{0}_from,{0}_to,{1}_from,{1}_to,regime,cases,with_regime,part,low,high\n",
            axes[0], axes[1]
        );
        for (method, name, motion) in self.each() {
            for band in self.bands(method, motion) {
                let Some(part) = wilson(band.with, band.classified) else {
                    continue;
                };
                let [[left, right], [bottom, top]] = band.tile.ends();
                let ends = [x[left], x[right], y[bottom], y[top]];
                let [left, right, bottom, top] = ends;
                write!(
                    text,
                    "{name},{},{left},{right},{bottom},{top},",
                    motion.name()
                )?;
                write!(
                    text,
                    "{},{},{},",
                    motion.regimes()[0],
                    band.classified,
                    band.with
                )?;
                writeln!(text, "{},{},{}", part.value, part.low, part.high)?;
            }
        }
        Ok(text)
    }

    fn summary(&self, motions: &[Motion]) -> TraceSummary {
        let lattice = self.design.lattice;
        let steps = lattice.size().map(|points| 1.0 / (points - 1) as f64);
        let of_limit = |(method, name, motion): (usize, &str, Motion)| {
            let bands = self.bands(method, motion);
            let area: usize = bands.iter().map(|band| band.tile.side.pow(2)).sum();
            LimitSummary {
                method: name.to_owned(),
                motion: motion.name().to_owned(),
                lines: self.lines(method, motion).len(),
                tiles: bands.len(),
                ragged_part: area as f64 * steps[0] * steps[1],
            }
        };
        TraceSummary {
            simulated: self.simulated,
            cases_of_grid: lattice.points(),
            steps,
            limits: (self.each())
                .filter(|(_, _, motion)| motions.contains(motion))
                .map(of_limit)
                .collect(),
        }
    }
}

/// The value at twice a place among values, and half the distance of the two that it is
/// between; none where it is one of them.
fn between(values: &[f64], place: usize) -> (f64, f64) {
    let [low, high] = [values[place / 2], values[place.div_ceil(2)]];
    (0.5 * (low + high), 0.5 * (high - low))
}

/// Writes `limits.csv` and `bands.csv` next to the `labels.csv` of a folder, and notes them in
/// its manifest.
///
/// # Errors
/// Where a file cannot be read or written, or the labels are not all that was wanted.
pub fn write_traced(folder: &Path, design: &TraceDesign, manifest: &mut Manifest) -> Result<()> {
    let labels = folder.join("labels.csv");
    let limits = TracedLimits::read(&labels, design, &manifest.method_names())?;
    let limits =
        limits.with_context(|| format!("{} lacks cases of the trace", labels.display()))?;
    let axes: Vec<String> = manifest.axes.iter().map(|axis| axis.name()).collect();
    let texts = [
        ("limits.csv", limits.limits_csv(&axes)?),
        ("bands.csv", limits.bands_csv(&axes)?),
    ];
    for (name, text) in texts {
        let checksum = write_with_checksum(&folder.join(name), text.as_bytes())?;
        manifest.files.insert(name.to_owned(), checksum);
    }
    manifest.trace = Some(limits.summary(&manifest.tally.motions()));
    Ok(())
}
