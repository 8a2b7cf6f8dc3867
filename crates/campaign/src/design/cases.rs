//! The cases of any design, by their numbers and by their strings.

use super::axes::MOST_CASES;
use super::grid::Grid;
use super::list::List;
use super::monte_carlo::MonteCarlo;
use super::points::Points;
use super::random_axes::RandomAxes;
use super::sensitivity::Sensitivity;
use super::trace::TraceDesign;
use crate::quantities::Axis;
use crate::sweep_file::{DesignKind, DesignTable, PointsName, Source, SweepFileError, TextOf};

/// Cases over named axes, numbered from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Design {
    /// Every combination; without axes the one case that the file says.
    Grid(Grid),
    /// Independent random values.
    MonteCarlo(MonteCarlo),
    /// As listed in a file.
    List(List),
    /// Those of a grid that tell where its limits are.
    Trace(TraceDesign),
    /// Random values in blocks that tell the axes apart.
    Sensitivity(Sensitivity),
}

impl Design {
    /// The one case that the file says.
    pub fn one_case() -> Self {
        Design::Grid(Grid::default())
    }

    /// Checks and reads what `[design]` says; the weight on bit may push the string, so that
    /// each has its own.
    ///
    /// # Errors
    /// Where an axis has no values or impossible ones, or a list cannot be
    /// read.
    pub(crate) fn resolve(
        source: &Source,
        table: Option<&DesignTable>,
        weight_pushes: bool,
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let Some(table) = table else {
            return Ok(Self::one_case());
        };
        refuse_foreign_keys(source, table)?;
        let design = match table.kind {
            DesignKind::Grid => Design::Grid(Grid::resolve(source, table, weight_pushes)?),
            DesignKind::MonteCarlo => {
                Design::MonteCarlo(MonteCarlo::resolve(source, table, weight_pushes)?)
            }
            DesignKind::List => Design::List(List::resolve(source, table, weight_pushes, text_of)?),
            DesignKind::Trace => Design::Trace(TraceDesign::resolve(source, table, weight_pushes)?),
            DesignKind::Sensitivity => {
                Design::Sensitivity(Sensitivity::resolve(source, table, weight_pushes)?)
            }
        };
        let cases = design.cases();
        let message = format!("{cases} cases are more than {MOST_CASES}");
        let key = table.cases.map_or("design", |_| "design.cases");
        source.refuse_if(cases > MOST_CASES, key, message)?;
        Ok(design)
    }

    /// The axes, in the order of their columns.
    pub fn axes(&self) -> &[Axis] {
        match self {
            Design::Grid(grid) => &grid.axes,
            Design::MonteCarlo(drawn) => &drawn.random.axes,
            Design::List(list) => &list.axes,
            Design::Trace(trace) => &trace.grid.axes,
            Design::Sensitivity(blocks) => &blocks.random.axes,
        }
    }

    /// The least and the greatest value along an axis, where it is one.
    pub fn ends(&self, axis: Axis) -> Option<[f64; 2]> {
        let place = self.axes().iter().position(|known| *known == axis)?;
        Some(match self {
            Design::Grid(grid) => ends_of(grid.along(place).iter().copied()),
            Design::MonteCarlo(drawn) => drawn.random.ends(place),
            Design::List(list) => ends_of(list.cases.iter().map(|values| values[place])),
            Design::Trace(trace) => ends_of(trace.grid.along(place).iter().copied()),
            Design::Sensitivity(blocks) => blocks.random.ends(place),
        })
    }

    /// Seed of random cases.
    pub fn seed(&self) -> Option<u64> {
        match self {
            Design::MonteCarlo(drawn) => Some(drawn.points.seed),
            Design::Sensitivity(blocks) => Some(blocks.points.seed),
            Design::Trace(trace) => Some(trace.seed),
            Design::Grid(_) | Design::List(_) => None,
        }
    }

    /// Points with every axis at an end of what it is drawn from: a quantity that rises or falls
    /// along each axis is largest at one of them. None where nothing is drawn.
    pub fn corners(&self) -> Vec<Vec<f64>> {
        self.random_axes()
            .map_or_else(Vec::new, RandomAxes::corners)
    }

    fn random_axes(&self) -> Option<&RandomAxes> {
        match self {
            Design::MonteCarlo(drawn) => Some(&drawn.random),
            Design::Sensitivity(blocks) => Some(&blocks.random),
            Design::Grid(_) | Design::List(_) | Design::Trace(_) => None,
        }
    }

    /// Number of cases; of a trace, of the grid that it chooses from.
    pub fn cases(&self) -> usize {
        match self {
            Design::Grid(grid) => grid.cases(),
            Design::MonteCarlo(drawn) => drawn.cases,
            Design::List(list) => list.cases.len(),
            Design::Sensitivity(blocks) => blocks.cases(),
            Design::Trace(trace) => trace.grid.cases(),
        }
    }

    /// About how many of them are simulated: all, or those that a trace may choose.
    pub fn likely_cases(&self) -> usize {
        match self {
            Design::Trace(trace) => trace.likely_cases(),
            _ => self.cases(),
        }
    }

    /// The values of case `index` along the axes.
    pub fn values(&self, index: usize) -> Vec<f64> {
        match self {
            Design::Grid(grid) => grid.values(index),
            Design::MonteCarlo(drawn) => drawn.values(index),
            Design::List(list) => list.cases[index].clone(),
            Design::Trace(trace) => trace.grid.values(index),
            Design::Sensitivity(blocks) => blocks.values(index),
        }
    }
}

impl Design {
    /// How many of the axes, the first ones, change the string.
    fn string_axes(&self) -> usize {
        match self {
            Design::Grid(grid) => grid.of_string,
            Design::MonteCarlo(drawn) => drawn.random.of_string,
            Design::List(list) => list.of_string,
            Design::Trace(trace) => trace.grid.of_string,
            Design::Sensitivity(blocks) => blocks.random.of_string,
        }
    }

    /// Whether an axis changes the string.
    pub fn varies_string(&self) -> bool {
        self.string_axes() > 0
    }

    /// How many distinct strings the cases have. Random cases have one each.
    pub fn strings(&self) -> usize {
        match self {
            Design::List(list) => list.strings.len(),
            Design::Sensitivity(blocks) if self.varies_string() => blocks.strings(),
            Design::Sensitivity(_) => 1,
            Design::Grid(_) | Design::MonteCarlo(_) | Design::Trace(_) => {
                self.cases() / self.neighbours()
            }
        }
    }

    /// How many cases one of the strings has.
    pub fn cases_of_string(&self, string: usize) -> usize {
        match self {
            Design::List(list) => list.strings[string].len(),
            Design::Sensitivity(blocks) if self.varies_string() => blocks.cases_of_string(string),
            Design::Sensitivity(blocks) => blocks.cases(),
            Design::Grid(_) | Design::MonteCarlo(_) | Design::Trace(_) => self.neighbours(),
        }
    }

    /// The number of the case at a position among those of a string.
    pub fn case_of_string(&self, string: usize, position: usize) -> usize {
        match self {
            Design::List(list) => list.strings[string][position],
            Design::Sensitivity(blocks) if self.varies_string() => {
                blocks.case_of_string(string, position)
            }
            Design::Sensitivity(_) => position,
            Design::Grid(_) | Design::MonteCarlo(_) | Design::Trace(_) => {
                string * self.neighbours() + position
            }
        }
    }

    /// Which of the strings case `index` has.
    pub fn string_of(&self, index: usize) -> usize {
        match self {
            Design::List(list) => {
                let has_case = |cases: &Vec<usize>| cases.binary_search(&index).is_ok();
                list.strings.iter().position(has_case).unwrap_or(0)
            }
            Design::Sensitivity(blocks) if self.varies_string() => blocks.string_of(index),
            Design::Sensitivity(_) => 0,
            Design::Grid(_) | Design::MonteCarlo(_) | Design::Trace(_) => index / self.neighbours(),
        }
    }

    /// How many cases of one string follow one another; in a list they may be anywhere.
    fn neighbours(&self) -> usize {
        match self {
            Design::Grid(grid) => grid.cases_per_string(),
            Design::Trace(trace) => trace.grid.cases_per_string(),
            Design::MonteCarlo(_) if self.varies_string() => 1,
            _ => self.cases(),
        }
    }
}

impl Design {
    /// Blocks that separate axes, each even between its ends, for any axes: for tests against
    /// functions of known indices. `None` for more axes than there are points.
    #[doc(hidden)]
    pub fn even_blocks(
        points: PointsName,
        seed: u64,
        ends: &[[f64; 2]],
        blocks: usize,
    ) -> Option<Self> {
        let axes = vec![Axis::SurfaceSpeedRpm; ends.len()];
        Some(Design::Sensitivity(Sensitivity {
            random: RandomAxes::uniform(axes, ends),
            points: Points::new(points, seed, 2 * ends.len())?,
            blocks,
        }))
    }
}

/// The least and the greatest.
fn ends_of(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold(
        [f64::INFINITY, f64::NEG_INFINITY],
        |[least, most], value| [least.min(value), most.max(value)],
    )
}

/// A key that belongs to another kind of design would be ignored: refuse it.
fn refuse_foreign_keys(source: &Source, table: &DesignTable) -> Result<(), SweepFileError> {
    let is_list = table.kind == DesignKind::List;
    let is_random = table.kind.is_random();
    let is_trace = table.kind == DesignKind::Trace;
    let given = [
        ("axes", !table.axes.is_empty(), !is_list),
        ("cases", table.cases.is_some(), is_random),
        ("correlations", !table.correlations.is_empty(), is_random),
        ("points", table.points.is_some(), is_random),
        ("seed", table.seed.is_some(), is_random || is_trace),
        ("file", table.file.is_some(), is_list),
        ("tolerance", table.tolerance.is_some(), is_trace),
    ];
    for (key, is_given, belongs) in given {
        let message = "does not belong to this kind of design";
        source.refuse_if(is_given && !belongs, &format!("design.{key}"), message)?;
    }
    let message = "names no axis, so there is nothing to vary";
    source.refuse_if(table.axes.is_empty() && !is_list, "design.axes", message)
}
