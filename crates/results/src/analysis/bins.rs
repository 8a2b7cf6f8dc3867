//! Ranges of an axis that cases are counted in.

use std::collections::BTreeSet;

use anyhow::Result;

use crate::folder::{ResultTables, read_cases};
use campaign::quantities::Axis;
use campaign::sweep_file::{FileContent, Spacing};

/// Values of an axis up to this number have a range each.
const MOST_VALUES: usize = 24;

/// Ranges along an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Bins {
    /// The axis.
    pub axis: Axis,
    /// Where they begin and end; few values are ranges of no width.
    pub ranges: Vec<[f64; 2]>,
    /// In what they are even.
    pub spacing: Spacing,
}

/// What is known of an axis from its values.
struct Seen {
    distinct: BTreeSet<u64>,
    least: f64,
    most: f64,
}

impl Bins {
    /// Ranges along each of some axes, of cases of any tables: a given number of equal width in the
    /// value or, where the design spreads it so, in its logarithm; of few values, each of them.
    ///
    /// # Errors
    /// Where the tables cannot be read.
    pub fn along(
        tables: &[ResultTables],
        content: &FileContent,
        axes: &[Axis],
        count: usize,
    ) -> Result<Vec<Self>> {
        let none = || Seen {
            distinct: BTreeSet::new(),
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
        };
        let mut all: Vec<Seen> = axes.iter().map(|_| none()).collect();
        for tables in tables {
            for case in read_cases(&tables.folder.join("labels.csv"), axes)? {
                for (seen, value) in all.iter_mut().zip(case?.values) {
                    seen.add(value);
                }
            }
        }
        let ranges = axes.iter().zip(all);
        Ok(ranges
            .map(|(&axis, seen)| seen.bins(axis, content.spread(axis), count))
            .collect())
    }

    /// The range that a value is in.
    pub fn place(&self, value: f64) -> usize {
        let below = self.ranges.partition_point(|range| range[1] < value);
        below.min(self.ranges.len() - 1)
    }

    /// Whether each is one value.
    pub fn are_values(&self) -> bool {
        self.ranges.iter().all(|[from, to]| from == to)
    }

    /// The middle of a range.
    pub fn middle(&self, place: usize) -> f64 {
        let [from, to] = self.ranges[place];
        self.spacing.between(from, to, 0.5)
    }

    /// The value between the middles of ranges, at a place that need not be whole.
    pub fn at(&self, place: f64) -> f64 {
        let last = self.ranges.len() - 1;
        let below = (place as usize).min(last);
        let above = (below + 1).min(last);
        let [from, to] = [below, above].map(|range| self.middle(range));
        self.spacing.between(from, to, place - below as f64)
    }
}

impl Seen {
    fn add(&mut self, value: f64) {
        self.least = self.least.min(value);
        self.most = self.most.max(value);
        if self.distinct.len() <= MOST_VALUES {
            self.distinct.insert(value.to_bits());
        }
    }

    fn bins(&self, axis: Axis, spread: Spacing, count: usize) -> Bins {
        let spacing = spread.from_least(self.least);
        if self.distinct.len() <= MOST_VALUES {
            let mut values: Vec<f64> = self.distinct.iter().copied().map(f64::from_bits).collect();
            values.sort_by(f64::total_cmp);
            return Bins {
                axis,
                ranges: values.into_iter().map(|value| [value; 2]).collect(),
                spacing,
            };
        }
        let end =
            |index: usize| spacing.between(self.least, self.most, index as f64 / count as f64);
        Bins {
            axis,
            ranges: (0..count).map(|bin| [end(bin), end(bin + 1)]).collect(),
            spacing,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bins(values: impl Iterator<Item = f64>, spread: Spacing) -> Bins {
        let mut seen = Seen {
            distinct: BTreeSet::new(),
            least: f64::INFINITY,
            most: f64::NEG_INFINITY,
        };
        values.for_each(|value| seen.add(value));
        seen.bins(Axis::FRICTION, spread, 4)
    }

    #[test]
    fn few_values_have_a_range_each_and_many_share_even_ones() {
        let few = bins([3.0, 1.0, 3.0, -2.0].into_iter(), Spacing::Log);
        assert_eq!(few.ranges, [[-2.0; 2], [1.0; 2], [3.0; 2]]);
        assert_eq!([-2.0, 1.0, 3.0].map(|value| few.place(value)), [0, 1, 2]);
        let many = bins((0..=100).map(f64::from), Spacing::Linear);
        let expected = [[0.0, 25.0], [25.0, 50.0], [50.0, 75.0], [75.0, 100.0]];
        assert_eq!(many.ranges, expected);
        let places = [0.0, 25.0, 25.1, 100.0].map(|value| many.place(value));
        assert_eq!(places, [0, 0, 1, 3]);
        let logarithmic = bins(
            (0..=40).map(|step| 10f64.powf(0.1 * f64::from(step))),
            Spacing::Log,
        );
        for (range, low) in logarithmic.ranges.iter().zip([1.0, 10.0, 100.0, 1000.0]) {
            assert!((range[0] / low - 1.0).abs() < 1e-12, "{range:?}");
        }
        assert!(few.are_values() && !many.are_values());
        assert_eq!(
            [0.0, 0.5, 2.0].map(|place| few.at(place)),
            [-2.0, -0.5, 3.0]
        );
        assert_eq!([0.0, 1.5].map(|place| many.at(place)), [12.5, 50.0]);
        assert!((logarithmic.at(0.5) / 10.0 - 1.0).abs() < 1e-12);
    }
}
