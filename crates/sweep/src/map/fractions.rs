//! How large a part of the cases has a regime, over two axes: what is drawn where
//! cases that differ along further axes lie on top of one another.

use super::cells::joined;
use super::extent::Extent;
use crate::plot::{Ground, MapCell, Part};

/// Cells to the right and upwards at most.
const MOST_CELLS: [usize; 2] = [60, 45];

/// Cells of few cases, where these lie anywhere.
const FEWEST_CELLS: [usize; 2] = [8, 6];

/// Random cases in a cell, on average: fewer would say little of a part.
const CASES_PER_CELL: f64 = 10.0;

/// Counts in cells.
pub struct Fractions {
    /// The lines between cells, to the right and upwards.
    edges: [Vec<f64>; 2],
    /// Simulations with the regime, and all with a determined label, column by column.
    counts: Vec<[usize; 2]>,
}

impl Fractions {
    /// Cells around the values of a grid; of other cases, cells of one size with some
    /// cases each.
    pub fn new(extent: &Extent) -> Self {
        let sizes = [0, 1].map(|axis| extent.values[axis].len());
        let is_grid = extent.is_grid() && sizes[0] <= MOST_CELLS[0] && sizes[1] <= MOST_CELLS[1];
        let edges = if is_grid {
            [0, 1].map(|axis| around(&extent.values[axis]))
        } else {
            let most = MOST_CELLS.map(|cells| cells as f64);
            let wanted = extent.cases as f64 / CASES_PER_CELL;
            let scale = (wanted / (most[0] * most[1])).sqrt().min(1.0);
            [0, 1].map(|axis| {
                let cells = ((scale * most[axis]) as usize).max(FEWEST_CELLS[axis]);
                even(extent.ranges[axis], cells.min(sizes[axis]).max(1))
            })
        };
        let cells = (edges[0].len() - 1) * (edges[1].len() - 1);
        Self {
            edges,
            counts: vec![[0; 2]; cells],
        }
    }

    /// Counts a case: how many of its simulations have the regime, of those whose label is
    /// determined.
    pub fn add(&mut self, place: [f64; 2], [sustained, told]: [usize; 2]) {
        let [column, row] = [0, 1].map(|axis| {
            let edges = &self.edges[axis];
            let after = edges.partition_point(|&edge| edge <= place[axis]);
            after.saturating_sub(1).min(edges.len() - 2)
        });
        let rows = self.rows();
        let count = &mut self.counts[column * rows + row];
        *count = [count[0] + sustained, count[1] + told];
    }

    /// The part of each cell's simulations that has the regime, neighbours to the right in
    /// the same class as one.
    pub fn joined(&self) -> Vec<MapCell> {
        let [x, y] = &self.edges;
        let corner = |column, row| [x[column], y[row]];
        joined([x.len() - 1, self.rows()], corner, |column, row| {
            let [sustained, told] = self.counts[column * self.rows() + row];
            Some(match told {
                0 => Ground::NoCase,
                _ => Ground::Part(Part::of(sustained as f64 / told as f64)),
            })
        })
    }

    fn rows(&self) -> usize {
        self.edges[1].len() - 1
    }
}

/// Lines half-way between neighbours, and as far beyond the first and the last.
fn around(values: &[f64]) -> Vec<f64> {
    let ([first, .., last], Some(count)) = (values, values.len().checked_sub(2)) else {
        let value = values.first().copied().unwrap_or_default();
        let half = if value == 0.0 {
            0.5
        } else {
            0.05 * value.abs()
        };
        return vec![value - half, value + half];
    };
    let between = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let before = first - 0.5 * (values[1] - first);
    let after = last + 0.5 * (last - values[count]);
    [before].into_iter().chain(between).chain([after]).collect()
}

/// Lines at even distances.
fn even([from, to]: [f64; 2], cells: usize) -> Vec<f64> {
    if from >= to {
        return around(&[from]);
    }
    (0..=cells)
        .map(|index| from + (to - from) * index as f64 / cells as f64)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_of_an_uneven_grid_has_its_cell() {
        let mut fractions = Fractions::new(&Extent::example([&[1.0, 2.0, 10.0], &[5.0]], 9));
        for (x, sustained) in [(1.0, 1), (1.0, 0), (2.0, 0), (10.0, 1)] {
            fractions.add([x, 5.0], [sustained, 1]);
        }
        let cell = |x, part| MapCell {
            ends: [x, [4.75, 5.25]],
            ground: Ground::Part(Part::of(part)),
        };
        let expected = [
            cell([0.5, 1.5], 0.5),
            cell([1.5, 6.0], 0.0),
            cell([6.0, 14.0], 1.0),
        ];
        assert_eq!(fractions.joined(), expected);
    }

    #[test]
    fn neighbours_of_a_class_are_one_and_empty_cells_are_told() {
        let values: Vec<f64> = (0..100).map(f64::from).collect();
        let mut fractions = Fractions::new(&Extent::example([&values, &[0.0, 1.0]], 100));
        fractions.add([99.0, 1.0], [1, 2]);
        let cells = fractions.joined();
        assert_eq!(cells.len(), 3, "{cells:?}");
        assert_eq!(cells[0].ends[0], [0.0, 99.0]);
        let grounds = [&cells[1], &cells[2]].map(|cell| cell.ground);
        assert_eq!(grounds, [Ground::NoCase, Ground::Part(Part::of(0.5))]);
    }
}
