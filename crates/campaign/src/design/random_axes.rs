//! Axes whose values are drawn, each by its distribution.

use super::axes::{count_string_axes, in_order};
use super::distribution::Distribution;
use crate::quantities::Axis;
use crate::sweep_file::{DesignTable, Source, Spacing, SweepFileError};

/// Axes with their distributions.
#[derive(Debug, Clone, PartialEq)]
pub struct RandomAxes {
    pub axes: Vec<Axis>,
    /// How many of them, the first ones, change the string.
    pub of_string: usize,
    distributions: Vec<Distribution>,
}

impl RandomAxes {
    /// What `[design.axes]` says of them.
    ///
    /// # Errors
    /// Where an axis has no distribution.
    pub fn resolve(
        source: &Source,
        table: &DesignTable,
        weight_pushes: bool,
    ) -> Result<Self, SweepFileError> {
        let given = in_order(table, weight_pushes);
        let axes: Vec<Axis> = given.iter().map(|(axis, _)| *axis).collect();
        let distributions = (given.into_iter())
            .map(|(axis, range)| Distribution::resolve(source, axis, range))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            of_string: count_string_axes(&axes, weight_pushes),
            axes,
            distributions,
        })
    }

    /// Axes of no string that are even between two ends each.
    pub fn uniform(axes: Vec<Axis>, ends: &[[f64; 2]]) -> Self {
        let uniform = |&[from, to]: &[f64; 2]| Distribution::uniform(from, to, Spacing::Linear);
        Self {
            axes,
            of_string: 0,
            distributions: ends.iter().map(uniform).collect(),
        }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.axes.len()
    }

    /// The values below which the given part (0 to 1) of each axis is.
    pub fn at(&self, parts: &[f64]) -> Vec<f64> {
        std::iter::zip(&self.distributions, parts)
            .map(|(distribution, &part)| distribution.at(part))
            .collect()
    }

    /// The ends of the range of the axis at a place.
    pub fn ends(&self, place: usize) -> [f64; 2] {
        let Distribution { from, to, .. } = self.distributions[place];
        [from.min(to), from.max(to)]
    }

    /// Points with every axis at an end of its range: a quantity that rises or falls
    /// along each axis is largest at one of them.
    pub fn corners(&self) -> Vec<Vec<f64>> {
        let mut corners = vec![Vec::new()];
        for range in &self.distributions {
            let ends = [range.from, range.to].into_iter();
            let with = |end: f64| {
                corners
                    .iter()
                    .map(move |corner| [&corner[..], &[end]].concat())
            };
            corners = ends.flat_map(with).collect();
        }
        corners
    }
}
