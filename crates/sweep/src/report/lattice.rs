//! How the cases of a map lie, in counts over its two axes: where a regime begins and ends.
//!
//! Memory does not grow with the cases: those of a grid are counted by its values, others in
//! cells of one size, and of a traced design the points of its grid.

use sim::Motion;

use crate::map::{Extent, Mesh};
use campaign::quantities::Axis;
use campaign::trace::Class;
use results::folder::CaseRows;
use results::traced::TracedLimits;

/// The most cells along either axis of a grid.
const MOST_VALUES: [usize; 2] = [400, 400];

/// Cells along the axis that is not limited and along the limited one, of cases that lie
/// anywhere, and their cases on average.
const MOST_CELLS: [usize; 2] = [5, 24];
const CASES_PER_CELL: f64 = 5.0;

/// Counts over the axes of a map.
pub struct Lattice {
    /// What is limited, and what its limit depends on.
    pub axes: [Axis; 2],
    /// Where the limited one is among the axes of the map.
    limited: usize,
    mesh: Mesh,
    /// The value of each column along the axis that is not limited, where it has one.
    values: Option<Vec<f64>>,
    /// Whether its cells are the points of a traced design.
    is_traced: bool,
    /// Of each motion, by cell: answers with sustained vibration, and all that decide.
    counts: Vec<(Motion, Vec<[usize; 2]>)>,
}

/// What is found along the limited quantity, from its least to its greatest value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Found {
    /// Sustained vibration everywhere.
    Always,
    /// None anywhere.
    Never,
    /// Everywhere in part only: in this fraction of the answers.
    Scattered(f64),
    /// On one side of a limit.
    Limit(Limit),
}

/// Where sustained vibration ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// Whether it is below the limit.
    pub is_below: bool,
    /// Up to here every answer has it; none where it is in part only.
    pub whole: Option<f64>,
    /// Beyond this no answer has it; none where some have it up to the end.
    pub none: Option<f64>,
    /// How far cases are apart there.
    pub step: f64,
}

/// What is found at a value, or over a range of values, of the other quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Column {
    /// The value, or the middle of the range.
    pub at: f64,
    /// How wide the range is.
    pub width: f64,
    /// What is found.
    pub found: Found,
}

impl Lattice {
    /// Of the cases of a map, without any.
    pub fn new(extent: &Extent) -> Self {
        let limits = [Axis::SurfaceSpeedRpm, Axis::FRICTION];
        let is_limited = |axis: &Axis| extent.axes.iter().position(|other| other == axis);
        let limited = limits.iter().find_map(is_limited).unwrap_or(1);
        let is_grid = extent.is_grid();
        let mesh = if is_grid {
            Mesh::around(&extent.values, extent.spacing, MOST_VALUES)
        } else {
            let mut most = [MOST_CELLS[0]; 2];
            most[limited] = MOST_CELLS[1];
            Mesh::of_cases(extent, most, CASES_PER_CELL)
        };
        let cells = mesh.size().iter().product();
        Self {
            axes: [extent.axes[limited], extent.axes[1 - limited]],
            limited,
            is_traced: false,
            values: is_grid
                .then(|| extent.values[1 - limited].clone())
                .filter(|values| values.len() == mesh.size()[1 - limited]),
            mesh,
            counts: (extent.motions.iter())
                .map(|&motion| (motion, vec![[0; 2]; cells]))
                .collect(),
        }
    }

    /// Adds a case at a place of the map.
    pub fn add(&mut self, place: [f64; 2], case: &CaseRows) {
        let cell = self.mesh.cell_of(place);
        for (motion, counts) in &mut self.counts {
            let answers = case.rows.iter();
            let decided = answers.filter_map(|row| row.labels.is_sustained(*motion));
            for is_sustained in decided {
                counts[cell][0] += usize::from(is_sustained);
                counts[cell][1] += 1;
            }
        }
    }

    /// The points of the grid of a traced design, by a number of methods, in place of its cases;
    /// `swapped` where the first of the design's axes is upwards on the map.
    pub fn fill(&mut self, traced: &TracedLimits, methods: usize, swapped: bool, extent: &Extent) {
        let values = traced.values();
        let own = if swapped {
            [values[1].to_vec(), values[0].to_vec()]
        } else {
            [values[0].to_vec(), values[1].to_vec()]
        };
        self.mesh = Mesh::around(&own, extent.spacing, MOST_VALUES);
        let across = 1 - self.limited;
        let values = Some(own[across].clone());
        self.values = values.filter(|values| values.len() == self.mesh.size()[across]);
        self.is_traced = true;
        let cells: usize = self.mesh.size().iter().product();
        for (motion, counts) in &mut self.counts {
            *counts = vec![[0; 2]; cells];
            for (right, &x) in own[0].iter().enumerate() {
                for (up, &y) in own[1].iter().enumerate() {
                    let place = if swapped { [up, right] } else { [right, up] };
                    let cell = self.mesh.cell_of([x, y]);
                    for method in 0..methods {
                        let is_sustained = match traced.class(method, *motion, place) {
                            Class::With => true,
                            Class::Without => false,
                            Class::Undetermined | Class::Unknown => continue,
                        };
                        counts[cell][0] += usize::from(is_sustained);
                        counts[cell][1] += 1;
                    }
                }
            }
        }
    }

    /// Whether each column is of one value.
    pub fn has_values(&self) -> bool {
        self.values.is_some()
    }

    /// Whether a value of the limited quantity is within the cases, or no further outside than
    /// these are apart.
    pub fn holds(&self, value: f64) -> bool {
        let last = self.mesh.size()[self.limited] - 1;
        let [[first, next], [before, end]] = [0, last].map(|row| self.ends(row));
        (first - 0.5 * (next - first)..=end + 0.5 * (end - before)).contains(&value)
    }

    /// Of a traced design, points with sustained vibration by every method, without by every
    /// method, and where they differ; none of others.
    pub fn traced(&self, motion: Motion) -> Option<[usize; 3]> {
        let counts = self.counts.iter().filter(|_| self.is_traced);
        let (_, counts) = counts.into_iter().find(|(other, _)| *other == motion)?;
        let mut found = [0; 3];
        for &[sustained, decided] in counts.iter().filter(|[_, decided]| *decided > 0) {
            let kind = match sustained {
                all if all == decided => 0,
                0 => 1,
                _ => 2,
            };
            found[kind] += 1;
        }
        Some(found)
    }

    /// The motions of which there are counts.
    pub fn motions(&self) -> impl Iterator<Item = Motion> {
        self.counts.iter().map(|(motion, _)| *motion)
    }

    /// What is found of a motion column by column, along what is not limited; columns without an
    /// answer are left out.
    pub fn columns(&self, motion: Motion) -> Vec<Column> {
        let counts = self.counts.iter().find(|(other, _)| *other == motion);
        let Some((_, counts)) = counts else {
            return Vec::new();
        };
        let is_below = self.is_below(counts);
        let across = 1 - self.limited;
        let columns = 0..self.mesh.size()[across];
        let column = |column: usize| {
            let [from, to] = self.mesh.ends(across, column);
            let value = self.values.as_ref().map(|values| values[column]);
            Some(Column {
                at: value.unwrap_or(0.5 * (from + to)),
                width: to - from,
                found: self.found(counts, column, is_below)?,
            })
        };
        columns.filter_map(column).collect()
    }

    /// The column of a value.
    pub fn column_at(&self, motion: Motion, value: f64) -> Option<Column> {
        let columns = self.columns(motion);
        let distance = |column: &Column| (column.at - value).abs();
        let nearest = columns
            .into_iter()
            .min_by(|one, other| distance(one).total_cmp(&distance(other)))?;
        (distance(&nearest) <= 1.5 * nearest.width).then_some(nearest)
    }

    /// The number of a cell.
    fn cell(&self, column: usize, row: usize) -> usize {
        match self.limited {
            1 => self.mesh.number(column, row),
            _ => self.mesh.number(row, column),
        }
    }

    /// Whether sustained vibration is at low values of what is limited: on average, over all.
    fn is_below(&self, counts: &[[usize; 2]]) -> bool {
        let size = self.mesh.size();
        let (rows, columns) = (size[self.limited], size[1 - self.limited]);
        let (mut with, mut all) = ([0.0; 2], [0.0; 2]);
        for row in 0..rows {
            for column in 0..columns {
                let [sustained, decided] = counts[self.cell(column, row)];
                let add = |sum: &mut [f64; 2], count: usize| {
                    sum[0] += row as f64 * count as f64;
                    sum[1] += count as f64;
                };
                add(&mut with, sustained);
                add(&mut all, decided);
            }
        }
        // Products, as either may be without any.
        with[0] * all[1] <= all[0] * with[1]
    }

    fn found(&self, counts: &[[usize; 2]], column: usize, is_below: bool) -> Option<Found> {
        let rows = 0..self.mesh.size()[self.limited];
        let mut known: Vec<(usize, [usize; 2])> = rows
            .map(|row| (row, counts[self.cell(column, row)]))
            .filter(|(_, [_, decided])| *decided > 0)
            .collect();
        if !is_below {
            known.reverse();
        }
        let end = known.len();
        let sum = |of: usize| known.iter().map(|(_, count)| count[of]).sum::<usize>();
        let is_whole = |[sustained, decided]: [usize; 2]| sustained == decided;
        // From the side that has it: how many have it whole, and how many have any.
        let whole = known.iter().take_while(|(_, count)| is_whole(*count));
        let whole = whole.count();
        let any = known.iter().rposition(|(_, [sustained, _])| *sustained > 0);
        let any = any.map_or(0, |last| last + 1);
        // Between a row and the one before it.
        let line = |place: usize| {
            let [before, after] = [place.checked_sub(1)?, place].map(|place| known.get(place));
            let [before, after] = [before?.0, after?.0].map(|row| self.ends(row));
            let (low, high) = match is_below {
                true => (before, after),
                false => (after, before),
            };
            Some((0.5 * (low[1] + high[0]), 0.5 * (high[1] - low[0])))
        };
        if end == 0 {
            return None;
        }
        let limits = [whole, any].map(line);
        Some(match (whole, any) {
            (_, 0) => Found::Never,
            (whole, _) if whole == end => Found::Always,
            (0, any) if any == end => Found::Scattered(sum(0) as f64 / sum(1) as f64),
            _ => Found::Limit(Limit {
                is_below,
                whole: limits[0].map(|limit| limit.0),
                none: limits[1].map(|limit| limit.0),
                step: limits
                    .into_iter()
                    .flatten()
                    .map(|it| it.1)
                    .fold(0.0, f64::max),
            }),
        })
    }

    fn ends(&self, row: usize) -> [f64; 2] {
        self.mesh.ends(self.limited, row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::folder::LabelRow;

    /// Speeds 1 to 4 to the right, weights 10 and 20 upwards; of two methods the letters: S for
    /// stick-slip, a dot for smooth, by speed.
    fn lattice(rows: [[&str; 2]; 2]) -> Lattice {
        let speeds = [1.0, 2.0, 3.0, 4.0];
        let weights = [10.0, 20.0];
        let mut lattice = Lattice::new(&Extent::example([&speeds, &weights], 8));
        for (weight, methods) in weights.iter().zip(rows) {
            for (place, speed) in speeds.iter().enumerate() {
                let row = |labels: &str| {
                    let is_slipping = labels.as_bytes()[place] == b'S';
                    LabelRow::example("a", ["smooth", "stick_slip"][usize::from(is_slipping)])
                };
                let case = CaseRows {
                    case: 0,
                    values: Vec::new(),
                    rows: methods.map(row).to_vec(),
                };
                lattice.add([*speed, *weight], &case);
            }
        }
        lattice
    }

    fn found(rows: [[&str; 2]; 2]) -> Vec<Found> {
        let columns = lattice(rows).columns(Motion::Torsion);
        columns.iter().map(|column| column.found).collect()
    }

    fn limit(is_below: bool, whole: Option<f64>, none: Option<f64>) -> Found {
        Found::Limit(Limit {
            is_below,
            whole,
            none,
            step: 1.0,
        })
    }

    #[test]
    fn the_limit_is_between_the_last_case_with_it_and_the_first_without() {
        let sharp = found([["SS..", "SS.."], ["SSS.", "SSS."]]);
        let expected = [2.5, 3.5].map(|at| limit(true, Some(at), Some(at)));
        assert_eq!(sharp, expected);
        let above = found([["..SS", "..SS"], ["...S", "...S"]]);
        let expected = [2.5, 3.5].map(|at| limit(false, Some(at), Some(at)));
        assert_eq!(above, expected);
    }

    #[test]
    fn where_methods_differ_the_limit_has_two_ends() {
        let differ = found([["S...", "SSS."], ["....", "...."]]);
        assert_eq!(differ, [limit(true, Some(1.5), Some(3.5)), Found::Never]);
        let scattered = found([["S...", "...S"], ["SSSS", "SSSS"]]);
        assert_eq!(scattered, [Found::Scattered(0.25), Found::Always]);
        // In part from the least value on, and up to the greatest.
        assert_eq!(
            found([["....", "SS.."], ["S...", "S.SS"]])[0],
            limit(true, None, Some(2.5))
        );
        assert_eq!(
            found([["....", "SS.."], ["S...", "S.SS"]])[1],
            limit(true, Some(1.5), None)
        );
    }

    #[test]
    fn a_value_is_judged_by_the_cases_next_to_it() {
        let lattice = lattice([["SS..", "SS.."], ["SSS.", "SSS."]]);
        let at = |weight| lattice.column_at(Motion::Torsion, weight);
        assert_eq!(at(18.0).map(|column| column.at), Some(20.0));
        assert_eq!(at(50.0), None);
        assert_eq!(lattice.axes, [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn]);
    }
}
