//! Counts and indices as rows, as tables have them.

use sim::{Label, Motion, TorsionRegime};

use super::blocks::MethodBlocks;
use super::counts::Counts;
use super::interval::{Interval, wilson};
use campaign::quantities::Axis;

const BISTABLE: Label = Label::Torsion(TorsionRegime::Bistable);

/// How many of the cases of a cell have a regime.
#[derive(Debug, Clone, PartialEq)]
pub struct CountRow<'a> {
    /// By which method.
    pub method: &'a str,
    /// Of which motion.
    pub motion: Motion,
    /// The regime.
    pub regime: Label,
    /// The axes of the cell, with its ends along each.
    pub cell: Vec<(Axis, [f64; 2])>,
    /// Cases with the regime.
    pub cases: usize,
    /// Cases with a label.
    pub of: usize,
    /// The fraction, with its interval.
    pub fraction: Interval,
}

/// All counts, tidy: a row for each set of axes, cell, method and regime.
pub fn count_rows(all: &[Counts]) -> Vec<CountRow<'_>> {
    let mut rows = Vec::new();
    for counts in all {
        for (method, motion, group) in &counts.groups {
            for (cell, &of) in group.all.iter().enumerate() {
                if of == 0 {
                    continue;
                }
                let axes = counts.bins.iter().map(|bins| bins.axis);
                let place: Vec<_> = axes.zip(counts.ranges(cell)).collect();
                // Of a label that only cases with two starts have, where there are any.
                let is_listed =
                    |label: &Label| *label != BISTABLE || group.labels.contains_key(label);
                for regime in Label::all(*motion).into_iter().filter(is_listed) {
                    let cases = group.labels.get(&regime).map_or(0, |cells| cells[cell]);
                    rows.extend(wilson(cases, of).map(|fraction| CountRow {
                        method,
                        motion: *motion,
                        regime,
                        cell: place.clone(),
                        cases,
                        of,
                        fraction,
                    }));
                }
            }
        }
    }
    rows
}

/// Sobol's indices of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct IndexRow<'a> {
    /// By which method.
    pub method: &'a str,
    /// The name of what varies.
    pub quantity: &'static str,
    /// The axis.
    pub axis: Axis,
    /// Blocks of cases that it is found from.
    pub blocks: usize,
    /// The index of first order.
    pub first: Interval,
    /// The total index.
    pub total: Interval,
}

/// The indices of what can be told: a row for each method, quantity and axis.
pub fn index_rows<'a>(axes: &[Axis], methods: &'a [MethodBlocks]) -> Vec<IndexRow<'a>> {
    let mut rows = Vec::new();
    for of_method in methods {
        for (quantity, blocks) in &of_method.quantities {
            let found = blocks.indices(quantity.is_either()).unwrap_or_default();
            rows.extend(axes.iter().zip(found).map(|(axis, indices)| IndexRow {
                method: &of_method.method,
                quantity: quantity.name(),
                axis: *axis,
                blocks: blocks.count,
                first: indices.first,
                total: indices.total,
            }));
        }
    }
    rows
}
