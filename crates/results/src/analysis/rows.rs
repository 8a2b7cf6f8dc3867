//! Counts and indices as rows, as tables have them.

use sim::{Label, Motion, TorsionRegime};

use super::blocks::MethodBlocks;
use super::counts::Counts;
use super::interval::{Interval, wilson};
use campaign::quantities::Axis;
use campaign::records::{Field, Kind};

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

/// The columns of [`CountRow`]s.
pub const COUNT_COLUMNS: [(&str, Kind); 14] = [
    ("method", Kind::Text),
    ("motion", Kind::Text),
    ("regime", Kind::Text),
    ("x", Kind::Text),
    ("x_from", Kind::Number),
    ("x_to", Kind::Number),
    ("y", Kind::Text),
    ("y_from", Kind::Number),
    ("y_to", Kind::Number),
    ("cases", Kind::Count),
    ("of", Kind::Count),
    ("fraction", Kind::Number),
    ("low", Kind::Number),
    ("high", Kind::Number),
];

impl CountRow<'_> {
    /// Its fields by column; of axes that it is not counted over, nothing.
    pub fn fields(&self) -> [Field<'_>; COUNT_COLUMNS.len()] {
        let place = |axis: usize| -> [Field<'_>; 3] {
            let Some((axis, [from, to])) = self.cell.get(axis) else {
                return [Field::Nothing, Field::Nothing, Field::Nothing];
            };
            [axis.name().into(), (*from).into(), (*to).into()]
        };
        let ([x, x_from, x_to], [y, y_from, y_to]) = (place(0), place(1));
        [
            self.method.into(),
            self.motion.adjective().into(),
            self.regime.name().into(),
            x,
            x_from,
            x_to,
            y,
            y_from,
            y_to,
            self.cases.into(),
            self.of.into(),
            self.fraction.value.into(),
            self.fraction.low.into(),
            self.fraction.high.into(),
        ]
    }
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

/// The columns of [`IndexRow`]s.
pub const INDEX_COLUMNS: [(&str, Kind); 10] = [
    ("method", Kind::Text),
    ("quantity", Kind::Text),
    ("axis", Kind::Text),
    ("blocks", Kind::Count),
    ("first", Kind::Number),
    ("first_low", Kind::Number),
    ("first_high", Kind::Number),
    ("total", Kind::Number),
    ("total_low", Kind::Number),
    ("total_high", Kind::Number),
];

impl IndexRow<'_> {
    /// Its fields by column.
    pub fn fields(&self) -> [Field<'_>; INDEX_COLUMNS.len()] {
        [
            self.method.into(),
            self.quantity.into(),
            self.axis.name().into(),
            self.blocks.into(),
            self.first.value.into(),
            self.first.low.into(),
            self.first.high.into(),
            self.total.value.into(),
            self.total.low.into(),
            self.total.high.into(),
        ]
    }
}

/// The indices that are determined: a row for each method, quantity and axis.
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
