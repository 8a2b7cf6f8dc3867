//! Limits by simulated cases: at the points of a lattice, or in ranges of random cases.

use anyhow::{Result, bail};
use sim::{AxialRegime, Label, Motion};

use super::asked::WindowAsked;
use super::standing::Standing;
use crate::analysis::{Bins, Counts, count_cases, wilson};
use crate::folder::{Manifest, ResultTables, read_cases};
use crate::traced::TracedLimits;
use campaign::quantities::Axis;
use campaign::sweep_file::DesignKind;
use campaign::trace::Class;

/// The axes of a chart.
pub const AXES: [Axis; 2] = [Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm];

/// Which labels are vibration.
#[derive(Debug, Clone, Copy, Default)]
pub struct Vibrates {
    /// Whether chatter of a bit that stays in its rock does not count.
    pub chatter_is_safe: bool,
    /// Whether snaking counts as whirl does.
    pub snaking_counts: bool,
}

impl Vibrates {
    /// `None` of a case too short to tell.
    fn of(self, label: Label) -> Option<bool> {
        match label {
            Label::Axial(AxialRegime::AxialChatter) if self.chatter_is_safe => Some(false),
            label if self.snaking_counts && label.is_snaking() => Some(true),
            label => label.is_sustained(),
        }
    }
}

/// What simulated cases say of a motion, by all methods together.
#[derive(Debug, Clone, PartialEq)]
pub enum Simulated {
    /// At the points of a lattice.
    At(Points),
    /// In ranges of both axes.
    In(Cells),
}

/// Cases at the points of a lattice.
#[derive(Debug, Clone, PartialEq)]
pub struct Points {
    /// The values along both axes.
    values: [Vec<f64>; 2],
    /// What is at each point, of all speeds of one weight after one another.
    found: Vec<Found>,
    /// Stretches in which chance decides.
    ragged: Vec<[[f64; 2]; 2]>,
}

/// What the cases of a point are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Found {
    with: bool,
    without: bool,
    undetermined: bool,
    /// Of labels that are certified, one that is not certain.
    uncertain: bool,
}

impl Found {
    /// No case.
    const MISSING: Self = Self {
        with: false,
        without: false,
        undetermined: true,
        uncertain: false,
    };

    /// What the cases of both are.
    fn and(self, other: Self) -> Self {
        Self {
            with: self.with || other.with,
            without: self.without || other.without,
            undetermined: self.undetermined || other.undetermined,
            uncertain: self.uncertain || other.uncertain,
        }
    }
}

/// Random cases in ranges.
#[derive(Debug, Clone, PartialEq)]
pub struct Cells {
    bins: [Bins; 2],
    standings: Vec<Standing>,
}

/// What the cases of a results folder say of a motion: each is with sustained vibration or
/// without. Random cases are counted in the ranges of either axis that are asked for, and a cell is clear
/// where no more than a fraction, the risk, of its cases has the vibration: the upper end of Wilson's
/// interval, by every method; against it where the lower end is more.
///
/// # Errors
/// Where the cases do not say that over both axes, or the tables cannot be read.
pub fn simulated(
    tables: &ResultTables,
    motion: Motion,
    vibrates: Vibrates,
    asked: &WindowAsked,
) -> Result<Simulated> {
    let manifest = &tables.manifest;
    if let Some(design) = manifest.traced_design() {
        let found = TracedLimits::read(&labels(tables), &design, &manifest.method_names())?;
        if asked.accept_chatter && motion == Motion::Axial {
            bail!(
                "is a trace of where axial vibration begins: accepting chatter needs a grid or \
                   random cases"
            );
        }
        if let Some(limits) = found {
            return Ok(Simulated::At(match vibrates.snaking_counts {
                true => between_traced(&limits, tables, motion, vibrates)?,
                false => traced(&limits, manifest, motion),
            }));
        }
    }
    if manifest.is_trace() {
        bail!("holds a trace that is not finished: its limits are not known yet");
    }
    if kind_of(tables).is_some_and(DesignKind::is_random) {
        let counts = count_cases(std::slice::from_ref(tables), &[AXES.to_vec()], asked.bins)?;
        let cells = cells(&counts[0], motion, (asked.risk, vibrates));
        return Ok(Simulated::In(cells));
    }
    points(tables, motion, vibrates).map(Simulated::At)
}

pub fn kind_of(tables: &ResultTables) -> Option<DesignKind> {
    let design = tables.manifest.sweep.design.as_ref();
    design.map(|design| design.kind)
}

pub fn labels(tables: &ResultTables) -> std::path::PathBuf {
    tables.folder.join("labels.csv")
}

/// The values of a trace along both axes, and which axis of its design is that of the weight.
fn traced_values(limits: &TracedLimits, manifest: &Manifest) -> ([Vec<f64>; 2], usize) {
    let weight = usize::from(manifest.axes[0] != AXES[0]);
    let of_design = limits.values();
    (
        [weight, 1 - weight].map(|axis| of_design[axis].to_vec()),
        weight,
    )
}

/// The points of a trace by a vibration that it does not follow: one that was not simulated is as the
/// nearest ones that were, before and after it along the speed, and then along the weight.
fn between_traced(
    limits: &TracedLimits,
    tables: &ResultTables,
    motion: Motion,
    vibrates: Vibrates,
) -> Result<Points> {
    let (values, _) = traced_values(limits, &tables.manifest);
    let [columns, rows] = values.each_ref().map(Vec::len);
    let mut simulated: Vec<Option<Found>> = vec![None; columns * rows];
    for (at, own) in found_by_cases(tables, motion, vibrates)? {
        let [column, row] = place_in(&values, at);
        if column < columns && row < rows && [values[0][column], values[1][row]] == at {
            let all = &mut simulated[column * rows + row];
            *all = Some(all.unwrap_or_default().and(own));
        }
    }
    for column in simulated.chunks_mut(rows) {
        fill(column);
    }
    for row in 0..rows {
        let mut along: Vec<_> = simulated.iter().skip(row).step_by(rows).copied().collect();
        fill(&mut along);
        for (found, filled) in simulated.iter_mut().skip(row).step_by(rows).zip(along) {
            *found = filled;
        }
    }
    Ok(Points {
        found: (simulated.into_iter())
            .map(|found| found.unwrap_or(Found::MISSING))
            .collect(),
        values,
        ragged: Vec::new(),
    })
}

/// What is not known along a line is as what is known next before and after it.
fn fill(line: &mut [Option<Found>]) {
    let known = line.to_vec();
    for (place, found) in line
        .iter_mut()
        .enumerate()
        .filter(|(_, found)| found.is_none())
    {
        let before = known[..place].iter().rev().flatten().next();
        let after = known[place..].iter().flatten().next();
        *found = before.into_iter().chain(after).copied().reduce(Found::and);
    }
}

/// The points of a trace, those that were not simulated as those around them.
fn traced(limits: &TracedLimits, manifest: &Manifest, motion: Motion) -> Points {
    let methods = manifest.methods.len();
    let (values, weight) = traced_values(limits, manifest);
    let mut found = Vec::new();
    for column in 0..values[0].len() {
        for row in 0..values[1].len() {
            let mut place = [0; 2];
            (place[weight], place[1 - weight]) = (column, row);
            let mut at = Found::default();
            for method in 0..methods {
                match limits.class(method, motion, place) {
                    Class::With => at.with = true,
                    Class::Without => at.without = true,
                    Class::Undetermined | Class::Unknown => at.undetermined = true,
                }
            }
            found.push(at);
        }
    }
    let bands = (0..methods).flat_map(|method| limits.bands(method, motion));
    let ragged = bands.map(|band| {
        let ends = band.tile.ends();
        let along = |axis: usize, of: &[f64]| ends[axis].map(|end| of[end]);
        [along(weight, &values[0]), along(1 - weight, &values[1])]
    });
    Points {
        ragged: ragged.collect(),
        values,
        found,
    }
}

/// What each case is, by all methods, with its weight and speed.
fn found_by_cases(
    tables: &ResultTables,
    motion: Motion,
    vibrates: Vibrates,
) -> Result<Vec<([f64; 2], Found)>> {
    let mut cases = Vec::new();
    for case in read_cases(&labels(tables), &AXES)? {
        let case = case?;
        let mut at = Found::default();
        for row in &case.rows {
            at.uncertain |= row.certainty[motion] == Some(false);
            // A stalled motor is no more to be drilled with than a bit that sticks.
            let stalls = motion == Motion::Torsion && row.motor_stalled == Some(true);
            let found = row.labels[motion].and_then(|label| vibrates.of(label));
            match found.map(|vibrates| vibrates || stalls) {
                Some(true) => at.with = true,
                Some(false) => at.without = true,
                None => at.undetermined = true,
            }
        }
        cases.push(([case.values[0], case.values[1]], at));
    }
    Ok(cases)
}

/// Where a weight and a speed are among values of both.
fn place_in(values: &[Vec<f64>; 2], at: [f64; 2]) -> [usize; 2] {
    [0, 1].map(|axis| values[axis].partition_point(|value| *value < at[axis]))
}

/// Cases that are at every combination of some weights and speeds.
fn points(tables: &ResultTables, motion: Motion, vibrates: Vibrates) -> Result<Points> {
    let cases = found_by_cases(tables, motion, vibrates)?;
    let values = [0, 1].map(|axis| {
        let mut values: Vec<f64> = cases.iter().map(|(at, _)| at[axis]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    });
    let places = values[0].len() * values[1].len();
    // A grid may not be finished yet; a list is a lattice or none.
    let is_grid = kind_of(tables) == Some(DesignKind::Grid);
    if values.iter().any(|values| values.len() < 2) || !is_grid && places > cases.len() {
        bail!(
            "does not hold every combination of some weights and speeds: a grid, a trace or \
             random cases tell where limits are"
        );
    }
    let mut found: Vec<Option<Found>> = vec![None; places];
    for (at, own) in cases {
        let [column, row] = place_in(&values, at);
        let all = &mut found[column * values[1].len() + row];
        *all = Some(all.unwrap_or_default().and(own));
    }
    Ok(Points {
        values,
        found: (found.into_iter())
            .map(|it| it.unwrap_or(Found::MISSING))
            .collect(),
        ragged: Vec::new(),
    })
}

/// Random cases; one that does not tell counts as one with the vibration.
fn cells(counts: &Counts, motion: Motion, (risk, vibrates): (f64, Vibrates)) -> Cells {
    let ranges: usize = counts.bins.iter().map(|bins| bins.ranges.len()).product();
    let mut standings = vec![Standing::Undetermined; ranges];
    let groups = counts
        .groups
        .iter()
        .filter(|(_, other, _)| *other == motion);
    for (index, (_, _, group)) in groups.enumerate() {
        let sustained = group.counted(|label| vibrates.of(label));
        for (cell, standing) in standings.iter_mut().enumerate() {
            let [with, classified] = sustained[cell];
            let all = group.all[cell];
            let with = with + group.stalled[cell];
            let own = match wilson(with + all - classified, all) {
                None => Standing::Undetermined,
                Some(part) if part.high <= risk => Standing::Clear,
                Some(part) if part.low > risk => Standing::Against,
                Some(_) => Standing::Near,
            };
            *standing = if index == 0 { own } else { own.max(*standing) };
        }
    }
    Cells {
        bins: [0, 1].map(|axis| counts.bins[axis].clone()),
        standings,
    }
}

impl Simulated {
    /// Values along both axes between which nothing changes.
    pub fn edges(&self) -> [Vec<f64>; 2] {
        match self {
            Simulated::At(points) => points.values.clone(),
            Simulated::In(cells) => cells.bins.each_ref().map(|bins| {
                let last = bins.ranges.last().map(|range| range[1]);
                bins.ranges
                    .iter()
                    .map(|range| range[0])
                    .chain(last)
                    .collect()
            }),
        }
    }

    /// How a stretch between two neighbours along either axis stands to the limit.
    pub fn standing(&self, ends: [[f64; 2]; 2]) -> Standing {
        match self {
            Simulated::At(points) => points.standing(ends),
            Simulated::In(cells) => {
                let [column, row] = [0, 1].map(|axis| {
                    let [from, to] = ends[axis];
                    cells.bins[axis].place(0.5 * (from + to))
                });
                cells.standings[column * cells.bins[1].ranges.len() + row]
            }
        }
    }
}

impl Points {
    /// By the four points around it: a limit passes where they differ.
    fn standing(&self, ends: [[f64; 2]; 2]) -> Standing {
        let is_in = |tile: &[[f64; 2]; 2]| {
            [0, 1].into_iter().all(|axis| {
                let middle = 0.5 * (ends[axis][0] + ends[axis][1]);
                (tile[axis][0]..=tile[axis][1]).contains(&middle)
            })
        };
        if self.ragged.iter().any(is_in) {
            return Standing::Near;
        }
        let [columns, rows] = [0, 1].map(|axis| {
            let middle = 0.5 * (ends[axis][0] + ends[axis][1]);
            let values = &self.values[axis];
            let above = values.partition_point(|value| *value < middle);
            [above.saturating_sub(1), above.min(values.len() - 1)]
        });
        let mut all = Found::default();
        for column in columns {
            for row in rows {
                all = all.and(self.found[column * self.values[1].len() + row]);
            }
        }
        match all {
            Found {
                undetermined: true, ..
            } => Standing::Undetermined,
            Found {
                uncertain: true, ..
            } => Standing::Near,
            Found {
                with: true,
                without: true,
                ..
            } => Standing::Near,
            Found { with: true, .. } => Standing::Against,
            Found { without: true, .. } => Standing::Clear,
            Found { .. } => Standing::Undetermined,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chatter_is_vibration_unless_it_is_accepted() {
        let of = |chatter_is_safe, regime| {
            let vibrates = Vibrates {
                chatter_is_safe,
                ..Vibrates::default()
            };
            vibrates.of(Label::Axial(regime))
        };
        use AxialRegime::{AxialChatter, BitBounce, Steady};
        let all = [Steady, AxialChatter, BitBounce];
        assert_eq!(
            all.map(|it| of(false, it)),
            [Some(false), Some(true), Some(true)]
        );
        assert_eq!(
            all.map(|it| of(true, it)),
            [Some(false), Some(false), Some(true)]
        );
        let stick_slip = Label::Torsion(TorsionRegime::StickSlip);
        assert_eq!(
            Vibrates {
                chatter_is_safe: true,
                ..Vibrates::default()
            }
            .of(stick_slip),
            Some(true)
        );
    }
    use crate::analysis::Group;
    use campaign::sweep_file::Spacing;
    use sim::TorsionRegime;

    #[test]
    fn a_limit_passes_between_points_that_differ() {
        let [with, without, undetermined] = [0, 1, 2].map(|kind| Found {
            with: kind == 0,
            without: kind == 1,
            undetermined: kind == 2,
            uncertain: false,
        });
        // Two weights by three speeds by two methods: at the highest speed of the first weight
        // the methods differ.
        let both = Found {
            with: true,
            without: true,
            ..Found::default()
        };
        let mut points = Points {
            values: [vec![10.0, 20.0], vec![1.0, 2.0, 3.0, 4.0]],
            found: vec![with, with, without, both, with, with, without, without],
            ragged: Vec::new(),
        };
        let at = |points: &Points, speeds| points.standing([[11.0, 12.0], speeds]);
        assert_eq!(at(&points, [1.0, 2.0]), Standing::Against);
        assert_eq!(at(&points, [2.0, 2.5]), Standing::Near);
        assert_eq!(at(&points, [3.2, 3.5]), Standing::Near);
        points.found[3] = without;
        assert_eq!(at(&points, [3.2, 3.5]), Standing::Clear);
        points.found[3].uncertain = true;
        assert_eq!(at(&points, [3.2, 3.5]), Standing::Near);
        points.found[7] = undetermined;
        assert_eq!(at(&points, [3.2, 3.5]), Standing::Undetermined);
        points.ragged = vec![[[10.0, 20.0], [1.0, 2.0]]];
        assert_eq!(at(&points, [1.0, 1.5]), Standing::Near);
    }

    #[test]
    fn random_cases_are_clear_where_an_interval_is_below_the_risk() {
        let bins = |axis, count: usize| Bins {
            axis,
            ranges: (0..count).map(|at| [at as f64, at as f64 + 1.0]).collect(),
            spacing: Spacing::Linear,
        };
        let stick_slip = Label::Torsion(TorsionRegime::StickSlip);
        let smooth = Label::Torsion(TorsionRegime::Smooth);
        let group = Group {
            // None of 40 is at most 8.8 %, none of 30 at most 11.4 %; 4 of 100 at most 9.8 %.
            all: vec![40, 30, 100, 100, 0],
            labels: [
                (stick_slip, vec![0, 0, 4, 60, 0]),
                // Of the rest, the bit is stuck.
                (smooth, vec![40, 30, 96, 40, 0]),
            ]
            .into(),
            stalled: vec![0; 5],
        };
        let mut stuck = group.clone();
        stuck.labels.insert(smooth, vec![40, 30, 90, 40, 0]);
        let of = |groups: Vec<Group>| {
            let groups = groups.into_iter();
            let counts = Counts {
                bins: vec![bins(AXES[0], 1), bins(AXES[1], 5)],
                groups: groups
                    .map(|it| (String::new(), Motion::Torsion, it))
                    .collect(),
                rows: 0,
                unanswered: 0,
            };
            cells(&counts, Motion::Torsion, (0.1, Vibrates::default())).standings
        };
        use Standing::{Against, Clear, Near, Undetermined};
        assert_eq!(
            of(vec![group.clone()]),
            [Clear, Near, Clear, Against, Undetermined]
        );
        // By the worse of two methods.
        assert_eq!(
            of(vec![group.clone(), stuck]),
            [Clear, Near, Near, Against, Undetermined]
        );
        // Below a mud motor that stalls in all of the first cell.
        let mut stalling = group;
        stalling.stalled[0] = 40;
        let below_motor = of(vec![stalling]);
        assert_eq!(below_motor, [Against, Near, Clear, Against, Undetermined]);
    }
}
