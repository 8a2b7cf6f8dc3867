//! How likely a regime is over ranges of one axis or of two: curves with their intervals, or cells
//! with the lines of a few probabilities.

use sim::{Label, Motion};

use super::contour::contour;
use super::mesh::Mesh;
use super::shown::{plot_axis, show_in};
use results::analysis::{Bins, Counts, Interval, wilson};

use campaign::plan::{MapMark, MapSettings};
use campaign::quantities::Units;
use campaign::words::counted;
use plot::{
    self, CellFill, Fraction, LineStyle, Look, MapChart, MapGroup, MapPanel, Mark, Panel, Picture,
    Series, map_chart, panels,
};

/// Cells whose 95 % interval is wider have too few cases: of half and half, those of fewer than 21.
const WIDEST_INTERVAL: f64 = 0.4;

/// Probabilities that have a line, with their names.
const LEVELS: [(f64, &str); 3] = [(0.1, "10 %"), (0.5, "50 %"), (0.9, "90 %")];

/// What is drawn.
pub struct Probabilities<'a> {
    /// Title above all.
    pub title: String,
    /// Counts over one axis or two.
    pub counts: &'a Counts,
    /// Of which regime; without one, of sustained vibration in each motion.
    pub regime: Option<Label>,
    /// What its numbers are shown in.
    pub units: Units,
    /// How the map of its sweep is drawn: places that it points out are pointed out here, too.
    pub map: Option<&'a MapSettings>,
}

/// Draws probabilities: over two axes as maps, over one as curves.
pub fn probability_picture(of: &Probabilities) -> Picture {
    match &of.counts.bins[..] {
        [x, y] => of.chart([x, y]),
        [x] => of.curves(x),
        _ => panels(&Look::default(), &of.title, &[]),
    }
}

/// A method's counts in each cell: with the regime, and of how many.
type OfMethod<'a> = (&'a str, Vec<[usize; 2]>);

impl Probabilities<'_> {
    /// The motions that have the regime, with its counts by each method.
    fn motions(&self) -> Vec<(Motion, Vec<OfMethod<'_>>)> {
        let is_asked = |motion: &Motion| self.regime.is_none_or(|it| it.motion() == *motion);
        let of_motion = |motion: Motion| {
            let groups = self.counts.groups.iter();
            let own = groups.filter(move |(_, other, _)| *other == motion);
            let methods = own.map(|(method, _, group)| (method.as_str(), group.with(self.regime)));
            (motion, methods.collect::<Vec<_>>())
        };
        let all = Motion::ALL.into_iter().filter(is_asked).map(of_motion);
        all.filter(|(_, methods)| !methods.is_empty()).collect()
    }

    /// The regime in words.
    fn regime(&self, motion: Motion) -> String {
        match self.regime {
            Some(regime) => regime.name().replace('_', " "),
            None => motion.regimes()[0].to_owned(),
        }
    }

    fn chart(&self, bins: [&Bins; 2]) -> Picture {
        let motions = self.motions();
        let is_alone = motions.len() == 1;
        let groups = motions.iter().map(|(motion, methods)| {
            let heading = if is_alone { "" } else { motion.title() };
            MapGroup {
                heading: heading.to_owned(),
                ..self.group(bins, &self.regime(*motion), methods)
            }
        });
        let mut chart = MapChart {
            title: self.title.clone(),
            axes: bins.map(|bins| plot_axis(bins.axis, bins.spacing, self.units)),
            marks: self.marks(bins),
            groups: groups.collect(),
        };
        show_in(&mut chart, bins.map(|bins| bins.axis.unit(self.units)));
        map_chart(&Look::default(), &chart)
    }

    /// The marks of the sweep's map that are within the ranges of the same two axes.
    fn marks(&self, bins: [&Bins; 2]) -> Vec<Mark> {
        let Some(map) = self.map else {
            return Vec::new();
        };
        let axes = bins.map(|bins| bins.axis);
        let is_turned = axes == [map.y, map.x];
        if !is_turned && axes != [map.x, map.y] {
            return Vec::new();
        }
        let at = |mark: &MapMark| {
            if is_turned {
                [mark.y, mark.x]
            } else {
                [mark.x, mark.y]
            }
        };
        let is_inside = |at: [f64; 2]| {
            let within = |(bins, value): (&Bins, f64)| {
                let ends = (bins.ranges.first()).zip(bins.ranges.last());
                ends.is_some_and(|(first, last)| (first[0]..=last[1]).contains(&value))
            };
            bins.into_iter().zip(at).all(within)
        };
        let inside = map.marks.iter().filter(|mark| is_inside(at(mark)));
        inside
            .map(|mark| Mark {
                name: mark.name.clone(),
                at: at(mark).into(),
            })
            .collect()
    }

    /// The maps of a motion, one for each method.
    fn group(&self, bins: [&Bins; 2], regime: &str, methods: &[OfMethod]) -> MapGroup {
        let mesh = Mesh::of_bins(bins);
        let cells: Vec<Vec<Option<f64>>> = (methods.iter())
            .map(|(_, counts)| counts.iter().copied().map(probability).collect())
            .collect();
        let lines: Vec<Vec<Vec<(f64, f64)>>> = (cells.iter())
            .map(|cells| LEVELS.map(|(level, _)| line(bins, cells, level)).to_vec())
            .collect();
        let name = |level: usize| {
            let is_drawn = lines.iter().any(|of_method| !of_method[level].is_empty());
            let nowhere = if is_drawn { "" } else { " (nowhere)" };
            format!("{} of the cases{nowhere}", LEVELS[level].1)
        };
        let panels = methods.iter().zip(&cells).zip(&lines);
        let panels = panels.map(|(((method, _), cells), lines)| MapPanel {
            title: (*method).to_owned(),
            cells: mesh.joined(|cell| Some(fill(cells[cell]))),
            lines: (lines.iter().enumerate())
                .map(|(level, points)| Series {
                    name: name(level),
                    style: LineStyle::default(),
                    points: points.clone(),
                })
                .collect(),
            ..MapPanel::default()
        });
        let names: Vec<&str> = methods.iter().map(|(method, _)| *method).collect();
        MapGroup {
            heading: String::new(),
            scale: Some(format!(
                "Fraction of the cases of a cell: {regime} ({})",
                names.join(", ")
            )),
            keys: keys(&cells),
            notes: self.notes(),
            panels: panels.collect(),
            ..MapGroup::default()
        }
    }

    fn notes(&self) -> Vec<String> {
        let counted_here = match self.counts.unanswered {
            0 => counted(self.counts.rows, "simulation"),
            none => format!(
                "{}, {none} without an answer",
                counted(self.counts.rows, "simulation")
            ),
        };
        let lines = "lines are linear between the middles of cells";
        vec![counted_here, lines.to_owned()]
    }

    /// Curves over one axis, below each other, with the ends of the 95 % intervals.
    fn curves(&self, bins: &Bins) -> Picture {
        let unit = bins.axis.unit(self.units);
        let place = |cell: usize| unit.number(bins.middle(cell));
        let mut all = Vec::new();
        for (motion, methods) in self.motions() {
            for (method, counts) in methods {
                let intervals = counts.iter().enumerate();
                let intervals =
                    intervals.filter_map(|(cell, &[with, of])| Some((cell, wilson(with, of)?)));
                let intervals: Vec<_> = intervals.collect();
                let curve = |name: &str, end: fn(&Interval) -> f64| {
                    let of_cell = |(cell, interval): &(usize, Interval)| {
                        (place(*cell), 100.0 * end(interval))
                    };
                    Series::new(name, intervals.iter().map(of_cell).collect())
                };
                let label = format!("{} by {method} (%)", self.regime(motion));
                all.push(Panel {
                    axes: [
                        plot_axis(bins.axis, bins.spacing, self.units),
                        plot::Axis::linear(label),
                    ],
                    series: vec![
                        curve("part of the cases", |it| it.value),
                        curve("95 % interval, from", |it| it.low),
                        curve("95 % interval, to", |it| it.high),
                    ],
                    references: Vec::new(),
                    walls: Vec::new(),
                    is_difference: false,
                });
            }
        }
        panels(&Look::default(), &self.title, &all)
    }
}

/// The part of the cases of a cell; none of too few.
fn probability([with, of]: [usize; 2]) -> Option<f64> {
    let found = wilson(with, of)?;
    (found.high - found.low <= WIDEST_INTERVAL).then_some(found.value)
}

fn fill(probability: Option<f64>) -> CellFill {
    probability.map_or(CellFill::NoCase, |part| {
        CellFill::Fraction(Fraction::of(part))
    })
}

/// The line of a probability, in pieces.
fn line(bins: [&Bins; 2], cells: &[Option<f64>], level: f64) -> Vec<(f64, f64)> {
    let size = bins.map(|bins| bins.ranges.len());
    let at = |[x, y]: [f64; 2]| (bins[0].at(x), bins[1].at(y));
    let pieces = contour(size, cells, level).into_iter();
    let gap = std::iter::once((f64::NAN, f64::NAN));
    pieces
        .flat_map(|piece| piece.into_iter().map(at).chain(gap.clone()))
        .collect()
}

/// The fills that are on any of the maps, from all to none.
fn keys(cells: &[Vec<Option<f64>>]) -> Vec<(CellFill, String)> {
    let too_few = format!(
        "too few cases (95 % interval over {:.0} %)",
        100.0 * WIDEST_INTERVAL
    );
    let classes = Fraction::EVERY.into_iter().rev();
    let classes = classes.map(|part| (CellFill::Fraction(part), part.text().to_owned()));
    let all = classes.chain([(CellFill::NoCase, too_few)]);
    let is_there = |key: &(CellFill, String)| {
        let mut fills = cells.iter().flatten().map(|cell| fill(*cell));
        fills.any(|fill| fill == key.0)
    };
    all.filter(is_there).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_has_too_few_cases_where_its_interval_is_wide() {
        let [few, enough] = [20, 22].map(|of| probability([of / 2, of]));
        assert_eq!((few, enough), (None, Some(0.5)));
        assert_eq!(probability([0, 0]), None);
        // Of none or all, fewer are enough.
        assert_eq!([5, 6].map(|of| probability([0, of])), [None, Some(0.0)]);
    }
}
