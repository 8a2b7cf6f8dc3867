//! How often each label occurs in each cell.

use std::collections::BTreeMap;

use anyhow::Result;
use sim::{Label, Motion};

use super::bins::Bins;
use crate::folder::{ResultTables, read_cases};

/// Rows by method and motion, and cells of some axes; without axes there is one cell.
#[derive(Debug, Clone, PartialEq)]
pub struct Counts {
    /// The axes of the cells.
    pub bins: Vec<Bins>,
    /// Of each method, in the order of the table, and each motion that has a label.
    pub groups: Vec<(String, Motion, Group)>,
    /// Rows that are to be counted.
    pub rows: usize,
    /// Of these, those without an answer.
    pub unanswered: usize,
}

/// Counts of one method and motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Rows with a label, by cell.
    pub all: Vec<usize>,
    /// Of these, those with each label that occurs.
    pub labels: BTreeMap<Label, Vec<usize>>,
    /// Of torsion, rows without sustained vibration in which a mud motor stalls.
    pub stalled: Vec<usize>,
}

impl Group {
    /// How many of the rows in each cell have a regime, of those with a label; without one asked
    /// for, sustained vibration.
    pub fn with(&self, regime: Option<Label>) -> Vec<[usize; 2]> {
        let Some(regime) = regime else {
            return self.sustained();
        };
        let counts = self.labels.get(&regime);
        let of_cell = |(cell, &all)| [counts.map_or(0, |counts| counts[cell]), all];
        self.all.iter().enumerate().map(of_cell).collect()
    }

    /// How many of the rows in each cell have sustained vibration, of those long enough to tell.
    pub fn sustained(&self) -> Vec<[usize; 2]> {
        self.counted(Label::is_sustained)
    }

    /// The same of what some labels tell.
    pub fn counted(&self, tells: impl Fn(Label) -> Option<bool>) -> Vec<[usize; 2]> {
        let mut cells = vec![[0; 2]; self.all.len()];
        for (label, counts) in &self.labels {
            let Some(is_sustained) = tells(*label) else {
                continue;
            };
            for ([sustained, classified], count) in cells.iter_mut().zip(counts) {
                *classified += count;
                *sustained += if is_sustained { *count } else { 0 };
            }
        }
        cells
    }
}

impl Counts {
    /// Counts the cases of any tables that are to be counted, in the cells of each of some sets of
    /// axes.
    ///
    /// # Errors
    /// Where the tables cannot be read.
    pub fn of_each(
        tables: &[ResultTables],
        methods: &[&str],
        sets: Vec<Vec<Bins>>,
        is_counted: impl Fn(usize) -> bool,
    ) -> Result<Vec<Self>> {
        let axes: Vec<Vec<_>> = (sets.iter())
            .map(|bins| bins.iter().map(|bins| bins.axis).collect())
            .collect();
        let known: Vec<_> = axes.iter().flatten().copied().collect();
        let mut all: Vec<Self> = (sets.into_iter())
            .map(|bins| Self::empty(bins, methods))
            .collect();
        for tables in tables {
            for case in read_cases(&tables.folder.join("labels.csv"), &known)? {
                let case = case?;
                if !is_counted(case.case) {
                    continue;
                }
                let mut values = &case.values[..];
                for counts in &mut all {
                    let (own, others) = values.split_at(counts.bins.len());
                    values = others;
                    let cell = counts.cell(own);
                    counts.rows += case.rows.len();
                    for row in &case.rows {
                        let method = methods.iter().position(|method| *method == row.method);
                        let Some(method) = method.filter(|_| row.labels.is_answer()) else {
                            counts.unanswered += 1;
                            continue;
                        };
                        for label in row.labels.each() {
                            let stalled = row.motor_stalled == Some(true);
                            counts.add(method, (label, stalled), cell);
                        }
                    }
                }
            }
        }
        for counts in &mut all {
            (counts.groups).retain(|(_, _, group)| group.all.iter().any(|count| *count > 0));
        }
        Ok(all)
    }

    fn empty(bins: Vec<Bins>, methods: &[&str]) -> Self {
        let cells = bins.iter().map(|bins| bins.ranges.len()).product();
        let group = Group {
            all: vec![0; cells],
            labels: BTreeMap::new(),
            stalled: vec![0; cells],
        };
        let of_method = |method: &&str| {
            let method = (*method).to_owned();
            Motion::ALL.map(|motion| (method.clone(), motion, group.clone()))
        };
        Self {
            bins,
            groups: methods.iter().flat_map(of_method).collect(),
            rows: 0,
            unanswered: 0,
        }
    }

    /// The cell of values along the axes; that of the last axis changes fastest.
    fn cell(&self, values: &[f64]) -> usize {
        let places = self.bins.iter().zip(values);
        places.fold(0, |cell, (bins, &value)| {
            cell * bins.ranges.len() + bins.place(value)
        })
    }

    /// The ranges of a cell, one along each axis.
    pub fn ranges(&self, cell: usize) -> Vec<[f64; 2]> {
        let mut left = cell;
        let mut ranges: Vec<[f64; 2]> = (self.bins.iter().rev())
            .map(|bins| {
                let place = left % bins.ranges.len();
                left /= bins.ranges.len();
                bins.ranges[place]
            })
            .collect();
        ranges.reverse();
        ranges
    }

    fn add(&mut self, method: usize, (label, stalled): (Label, bool), cell: usize) {
        let (_, _, group) = &mut self.groups[Motion::ALL.len() * method + label.motion() as usize];
        group.all[cell] += 1;
        let stalls = stalled && label.motion() == Motion::Torsion;
        group.stalled[cell] += usize::from(stalls && label.is_sustained() == Some(false));
        let cells = group.all.len();
        group.labels.entry(label).or_insert_with(|| vec![0; cells])[cell] += 1;
    }
}
