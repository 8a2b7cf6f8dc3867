//! The cases of any design, by their numbers and by their strings.

use std::ops::Range;

use super::axes::{MOST_CASES, count_string_axes};
use super::grid::Grid;
use super::list::List;
use super::monte_carlo::MonteCarlo;
use crate::quantities::Axis;
use crate::sweep_file::{DesignKind, DesignTable, Source, SweepFileError, TextOf};

/// Cases over named axes, numbered from 0.
#[derive(Debug, Clone, PartialEq)]
pub enum Design {
    /// One case, as the file says.
    Single,
    /// Every combination.
    Grid(Grid),
    /// Independent random values.
    MonteCarlo(MonteCarlo),
    /// As listed in a file.
    List(List),
}

impl Design {
    /// Checks and reads what `[design]` says.
    ///
    /// # Errors
    /// Where an axis has no values or impossible ones, or a list cannot be
    /// read.
    pub(crate) fn resolve(
        source: &Source,
        table: Option<&DesignTable>,
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let Some(table) = table else {
            return Ok(Design::Single);
        };
        refuse_foreign_keys(source, table)?;
        let design = match table.kind {
            DesignKind::Grid => Design::Grid(Grid::resolve(source, table)?),
            DesignKind::MonteCarlo => Design::MonteCarlo(MonteCarlo::resolve(source, table)?),
            DesignKind::List => Design::List(List::resolve(source, table, text_of)?),
        };
        if design.cases() > MOST_CASES {
            let message = format!("{} cases are more than {MOST_CASES}", design.cases());
            let key = if table.cases.is_some() {
                "design.cases"
            } else {
                "design"
            };
            return Err(source.error(key, message));
        }
        Ok(design)
    }

    /// The axes, in the order of their columns.
    pub fn axes(&self) -> &[Axis] {
        match self {
            Design::Single => &[],
            Design::Grid(grid) => grid.axes(),
            Design::MonteCarlo(monte_carlo) => monte_carlo.axes(),
            Design::List(list) => list.axes(),
        }
    }

    /// Seed of random cases.
    pub fn seed(&self) -> Option<u64> {
        match self {
            Design::MonteCarlo(monte_carlo) => Some(monte_carlo.seed()),
            _ => None,
        }
    }

    /// Number of cases.
    pub fn cases(&self) -> usize {
        match self {
            Design::Single => 1,
            Design::Grid(grid) => grid.cases(),
            Design::MonteCarlo(monte_carlo) => monte_carlo.cases(),
            Design::List(list) => list.cases(),
        }
    }

    /// The values of case `index` along the axes.
    pub fn values(&self, index: usize) -> Vec<f64> {
        match self {
            Design::Single => Vec::new(),
            Design::Grid(grid) => grid.values(index),
            Design::MonteCarlo(monte_carlo) => monte_carlo.values(index),
            Design::List(list) => list.values(index).to_vec(),
        }
    }
}

/// The cases of one string.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CasesOfString<'a> {
    /// Neighbours.
    Range(Range<usize>),
    /// As they are listed.
    Listed(&'a [usize]),
}

impl CasesOfString<'_> {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            CasesOfString::Range(range) => range.len(),
            CasesOfString::Listed(cases) => cases.len(),
        }
    }

    /// The number of the case at a position.
    pub fn get(&self, position: usize) -> usize {
        match self {
            CasesOfString::Range(range) => range.start + position,
            CasesOfString::Listed(cases) => cases[position],
        }
    }
}

impl Design {
    /// Whether an axis changes the string.
    pub fn varies_string(&self) -> bool {
        count_string_axes(self.axes()) > 0
    }

    /// How many distinct strings the cases have. Random cases have one each.
    pub fn strings(&self) -> usize {
        if !self.varies_string() {
            return 1;
        }
        match self {
            Design::Single => 1,
            Design::Grid(grid) => grid.cases() / grid.cases_per_string(),
            Design::MonteCarlo(monte_carlo) => monte_carlo.cases(),
            Design::List(list) => list.strings(),
        }
    }

    /// The cases of one of the strings.
    pub fn cases_of_string(&self, string: usize) -> CasesOfString<'_> {
        if !self.varies_string() {
            return CasesOfString::Range(0..self.cases());
        }
        match self {
            Design::Single => CasesOfString::Range(0..1),
            Design::Grid(grid) => {
                let cases = grid.cases_per_string();
                CasesOfString::Range(string * cases..(string + 1) * cases)
            }
            Design::MonteCarlo(_) => CasesOfString::Range(string..string + 1),
            Design::List(list) => CasesOfString::Listed(list.cases_of_string(string)),
        }
    }

    /// Which of the strings case `index` has.
    pub fn string_of(&self, index: usize) -> usize {
        if !self.varies_string() {
            return 0;
        }
        match self {
            Design::Single => 0,
            Design::Grid(grid) => index / grid.cases_per_string(),
            Design::MonteCarlo(_) => index,
            Design::List(list) => list.string_of(index),
        }
    }
}

/// A key that belongs to another kind of design would be ignored: refuse it.
fn refuse_foreign_keys(source: &Source, table: &DesignTable) -> Result<(), SweepFileError> {
    let given = [
        (
            "axes",
            !table.axes.is_empty(),
            table.kind != DesignKind::List,
        ),
        (
            "cases",
            table.cases.is_some(),
            table.kind == DesignKind::MonteCarlo,
        ),
        (
            "seed",
            table.seed.is_some(),
            table.kind == DesignKind::MonteCarlo,
        ),
        ("file", table.file.is_some(), table.kind == DesignKind::List),
    ];
    for (key, is_given, belongs) in given {
        if is_given && !belongs {
            let message = "does not belong to this kind of design";
            return Err(source.error(&format!("design.{key}"), message));
        }
    }
    if table.axes.is_empty() && table.kind != DesignKind::List {
        return Err(source.error("design.axes", "names no axis, so there is nothing to vary"));
    }
    Ok(())
}
