//! The fraction of the cases with a regime, over two axes: what is drawn where
//! cases that differ along further axes lie on top of one another.

use super::extent::Extent;
use super::mesh::Mesh;
use plot::{CellFill, Fraction, MapCell};

/// Cells to the right and upwards at most.
const MOST_CELLS: [usize; 2] = [60, 45];

/// Cells of few cases, where these lie anywhere.
const FEWEST_CELLS: [usize; 2] = [8, 6];

/// Random cases in a cell, on average: fewer would say little of a part.
const CASES_PER_CELL: f64 = 10.0;

/// Counts in cells.
pub struct Fractions {
    mesh: Mesh,
    /// Simulations with the regime, and all with a determined label, by cell.
    counts: Vec<[usize; 2]>,
}

impl Fractions {
    /// Cells around the values of a grid; of other cases, cells of one size with some
    /// cases each.
    pub fn new(extent: &Extent) -> Self {
        let mesh = if extent.is_grid() {
            Mesh::around(&extent.values, extent.spacing, MOST_CELLS)
        } else {
            let most = MOST_CELLS.map(|cells| cells as f64);
            let wanted = extent.cases as f64 / CASES_PER_CELL;
            let scale = (wanted / (most[0] * most[1])).sqrt().min(1.0);
            let cells = |axis: usize| ((scale * most[axis]) as usize).max(FEWEST_CELLS[axis]);
            Mesh::even(extent, [0, 1].map(cells))
        };
        let [columns, rows] = mesh.size();
        Self {
            mesh,
            counts: vec![[0; 2]; columns * rows],
        }
    }

    /// Counts a case: how many of its simulations have the regime, of those whose label is
    /// determined.
    pub fn add(&mut self, place: [f64; 2], [sustained, classified]: [usize; 2]) {
        let count = &mut self.counts[self.mesh.cell_of(place)];
        *count = [count[0] + sustained, count[1] + classified];
    }

    /// The part of each cell's simulations that has the regime, neighbours to the right in
    /// the same class as one.
    pub fn joined(&self) -> Vec<MapCell> {
        self.mesh.joined(|cell| {
            let [sustained, classified] = self.counts[cell];
            Some(match classified {
                0 => CellFill::NoCase,
                _ => CellFill::Fraction(Fraction::of(sustained as f64 / classified as f64)),
            })
        })
    }
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
            fill: CellFill::Fraction(Fraction::of(part)),
        };
        let expected = [
            cell([0.5, 1.5], 0.5),
            cell([1.5, 6.0], 0.0),
            cell([6.0, 14.0], 1.0),
        ];
        assert_eq!(fractions.joined(), expected);
    }

    #[test]
    fn neighbours_of_a_class_are_one_and_empty_cells_are_marked() {
        let values: Vec<f64> = (0..100).map(f64::from).collect();
        let mut fractions = Fractions::new(&Extent::example([&values, &[0.0, 1.0]], 100));
        fractions.add([99.0, 1.0], [1, 2]);
        let cells = fractions.joined();
        assert_eq!(cells.len(), 3, "{cells:?}");
        assert_eq!(cells[0].ends[0], [0.0, 99.0]);
        let fills = [&cells[1], &cells[2]].map(|cell| cell.fill);
        assert_eq!(
            fills,
            [CellFill::NoCase, CellFill::Fraction(Fraction::of(0.5))]
        );
    }
}
