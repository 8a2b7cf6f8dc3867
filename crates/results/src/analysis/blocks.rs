//! The blocks of cases of a sensitivity design as a run has answered them, read one by one.

use anyhow::Result;
use serde::Serialize;
use sim::{Label, Motion};

use super::indices::{Block, Blocks};
use crate::folder::{CaseRows, LabelRow, ResultTables, read_measured_cases};
use campaign::design::{Member, cases_of_block};
use campaign::records::{Measure, Needs};
use campaign::sweep_file::FileContent;

/// What varies from case to case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// Whether a case has a regime: 1 or 0.
    Regime(Label),
    /// How severe its motion is.
    Severity(Measure),
}

impl Quantity {
    fn all() -> Vec<Self> {
        let labels = Motion::ALL.into_iter().flat_map(Label::all);
        let regimes = labels.map(Quantity::Regime);
        regimes
            .chain(Measure::severities().map(Quantity::Severity))
            .collect()
    }

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Regime(label) => label.name(),
            Quantity::Severity(measure) => measure.column(),
        }
    }

    /// Whether it is 0 or 1.
    pub fn is_either(self) -> bool {
        matches!(self, Quantity::Regime(_))
    }

    fn of(self, row: &LabelRow) -> Option<f64> {
        match self {
            Quantity::Regime(label) => {
                let found = row.labels[label.motion()]?;
                Some(f64::from(u8::from(found == label)))
            }
            Quantity::Severity(measure) => {
                let place = Measure::severities().position(|read| read == measure)?;
                row.measures.get(place).copied().flatten()
            }
        }
    }
}

/// The blocks of one method.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodBlocks {
    /// Its name.
    pub method: String,
    /// Blocks of which every case has an answer.
    pub whole: usize,
    /// Blocks left out because a case has no answer.
    pub failed: usize,
    /// Blocks that the run has begun and not finished.
    pub unfinished: usize,
    /// Of each quantity, those of the whole blocks that have it in every case.
    #[serde(skip)]
    pub quantities: Vec<(Quantity, Blocks)>,
}

/// The blocks of any tables over a number of axes, of each method. Shards of one sweep may share a
/// block.
///
/// # Errors
/// Where the tables cannot be read.
pub fn blocks_of(
    tables: &[ResultTables],
    methods: &[&str],
    axes: usize,
) -> Result<Vec<MethodBlocks>> {
    let mut all: Vec<MethodBlocks> = (methods.iter())
        .map(|method| MethodBlocks::none(method, axes))
        .collect();
    let size = cases_of_block(axes);
    let mut cases = in_order(tables)?.peekable();
    while let Some(first) = cases.next().transpose()? {
        let number = first.case / size;
        let is_in_block = |case: &Result<CaseRows>| {
            case.as_ref()
                .map_or(true, |case| case.case / size == number)
        };
        let mut block = vec![first];
        while let Some(case) = cases.next_if(is_in_block) {
            block.push(case?);
        }
        let is_whole = block.len() == size;
        (all.iter_mut()).for_each(|of_method| of_method.add(number, &block, is_whole));
    }
    Ok(all)
}

/// The severities that all tables have columns of.
fn severities_in(tables: &[ResultTables]) -> Vec<Measure> {
    let is_in = |measure: &Measure, content: &FileContent| match measure.needs() {
        Some(Needs::Cutting) => content.has_cutting(),
        Some(Needs::Lying) => content.lies_on_low_side(),
        Some(Needs::Shocks) => content.measures_shocks(),
        Some(Needs::Stress) => content.measures_stress(),
        _ => true,
    };
    let is_there = |measure: &Measure| (tables.iter()).all(|it| is_in(measure, &it.manifest.sweep));
    Measure::severities().filter(is_there).collect()
}

/// A case with a place for every severity, of which only these were read.
fn with_all_severities(mut case: CaseRows, read: &[Measure]) -> CaseRows {
    for row in &mut case.rows {
        let of = |measure: Measure| {
            let place = read.iter().position(|it| *it == measure)?;
            row.measures.get(place).copied().flatten()
        };
        row.measures = Measure::severities().map(of).collect();
    }
    case
}

/// The cases of all tables in the order of their numbers.
fn in_order(tables: &[ResultTables]) -> Result<impl Iterator<Item = Result<CaseRows>>> {
    let severities = severities_in(tables);
    let mut sources = (tables.iter())
        .map(|tables| {
            let labels = tables.folder.join("labels.csv");
            Ok(read_measured_cases(&labels, &[], &severities)?.peekable())
        })
        .collect::<Result<Vec<_>>>()?;
    Ok(std::iter::from_fn(move || {
        let heads = sources
            .iter_mut()
            .enumerate()
            .filter_map(|(place, source)| {
                // An error comes first.
                let number = source.peek()?.as_ref().map_or(0, |case| case.case);
                Some((number, place))
            });
        let (_, place) = heads.min()?;
        let case = sources[place].next()?;
        Some(case.map(|case| with_all_severities(case, &severities)))
    }))
}

impl MethodBlocks {
    fn none(method: &str, axes: usize) -> Self {
        Self {
            method: method.to_owned(),
            whole: 0,
            failed: 0,
            unfinished: 0,
            quantities: (Quantity::all().into_iter())
                .map(|quantity| (quantity, Blocks::none(axes)))
                .collect(),
        }
    }

    /// The quantities without redundant ones: of a motion with two regimes, the first is the
    /// complement of the second.
    pub fn different(&self) -> impl Iterator<Item = &(Quantity, Blocks)> {
        self.quantities.iter().filter(|(quantity, _)| {
            let Quantity::Regime(label) = quantity else {
                return true;
            };
            let occurring = self.occurring(label.motion());
            occurring.len() != 2 || occurring[0] != *label
        })
    }

    /// The regimes of a motion that some cases have and others do not.
    fn occurring(&self, motion: Motion) -> Vec<Label> {
        let labels = self.quantities.iter().filter_map(|(quantity, blocks)| {
            let Quantity::Regime(label) = quantity else {
                return None;
            };
            (label.motion() == motion && blocks.vary()).then_some(*label)
        });
        labels.collect()
    }

    /// Adds what cases of a block are there, in their order.
    fn add(&mut self, number: usize, cases: &[CaseRows], is_whole: bool) {
        let rows: Vec<&LabelRow> = (cases.iter())
            .filter_map(|case| case.rows.iter().find(|row| row.method == self.method))
            .collect();
        if rows.iter().any(|row| !row.labels.is_answer()) {
            self.failed += 1;
        } else if !is_whole || rows.len() < cases.len() {
            self.unfinished += 1;
        } else {
            self.whole += 1;
            for (quantity, blocks) in &mut self.quantities {
                let values: Option<Vec<f64>> = rows.iter().map(|row| quantity.of(row)).collect();
                if let Some(values) = values {
                    add_values(blocks, number, &values);
                }
            }
        }
    }
}

/// Adds what a quantity is in each case of a block.
fn add_values(blocks: &mut Blocks, number: usize, values: &[f64]) {
    let (mut a, mut b, mut mixed) = (0.0, 0.0, vec![0.0; values.len() - 2]);
    for (place, &value) in values.iter().enumerate() {
        match Member::at(place) {
            Member::A => a = value,
            Member::B => b = value,
            Member::Mixed(axis) => mixed[axis] = value,
        }
    }
    blocks.add(
        number,
        Block {
            a,
            b,
            mixed: &mixed,
        },
    );
}
