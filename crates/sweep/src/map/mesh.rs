//! The cells of a map: around the values of a grid, or of one size.

use super::extent::Extent;
use campaign::sweep_file::Spacing;
use plot::{CellFill, MapCell};
use results::analysis::Bins;

/// Cells over two axes, column by column.
pub struct Mesh {
    /// The lines between cells, to the right and upwards.
    edges: [Vec<f64>; 2],
}

impl Mesh {
    /// Between lines to the right and upwards.
    pub fn between(edges: [Vec<f64>; 2]) -> Self {
        Self { edges }
    }

    /// Between ranges along two axes; around values that are ranges of no width.
    pub fn of_bins(bins: [&Bins; 2]) -> Self {
        let edges = bins.map(|bins| {
            let begins = bins.ranges.iter().map(|range| range[0]);
            if bins.are_values() {
                return around(&begins.collect::<Vec<f64>>(), bins.spacing);
            }
            let last = bins.ranges.last().map(|range| range[1]);
            begins.chain(last).collect()
        });
        Self { edges }
    }

    /// Around the values of a grid: at most `most` cells to the right and upwards, of
    /// neighbouring values together where there are more.
    pub fn around(values: &[Vec<f64>; 2], spacing: [Spacing; 2], most: [usize; 2]) -> Self {
        let edges = [0, 1].map(|axis| {
            let lines = around(&values[axis], spacing[axis]);
            let values = values[axis].len().max(1);
            let cells = most[axis].clamp(1, values);
            let line = |cell: usize| lines[cell * values / cells];
            (0..=cells).map(line).collect()
        });
        Self { edges }
    }

    /// Around the values of a grid; of other cases, cells of one size with a number of cases each
    /// on average.
    pub fn of_cases(extent: &Extent, most: [usize; 2], cases_per_cell: f64) -> Self {
        if extent.is_grid() {
            return Self::around(&extent.values, extent.spacing, most);
        }
        let [x, y] = most.map(|cells| cells as f64);
        let scale = (extent.cases as f64 / (cases_per_cell * x * y)).sqrt();
        let cells = |most: usize| ((scale.min(1.0) * most as f64) as usize).max(1);
        Self::even(extent, most.map(cells))
    }

    /// Cells of one size over the ranges of cases that lie anywhere; fewer where an axis
    /// has fewer values.
    pub fn even(extent: &Extent, most: [usize; 2]) -> Self {
        let edges = [0, 1].map(|axis| {
            let cells = most[axis].min(extent.values[axis].len()).max(1);
            even(extent.ranges[axis], extent.spacing[axis], cells)
        });
        Self { edges }
    }

    /// Cells to the right and upwards.
    pub fn size(&self) -> [usize; 2] {
        [0, 1].map(|axis| self.edges[axis].len() - 1)
    }

    /// The number of a cell.
    pub fn number(&self, column: usize, row: usize) -> usize {
        column * self.size()[1] + row
    }

    /// The number of the cell that has a place; of one outside, the nearest.
    pub fn cell_of(&self, place: [f64; 2]) -> usize {
        let [column, row] = [0, 1].map(|axis| {
            let edges = &self.edges[axis];
            let after = edges.partition_point(|&edge| edge <= place[axis]);
            after.saturating_sub(1).min(edges.len() - 2)
        });
        self.number(column, row)
    }

    /// The ends of the cells at a place along an axis.
    pub fn ends(&self, axis: usize, place: usize) -> [f64; 2] {
        [self.edges[axis][place], self.edges[axis][place + 1]]
    }

    /// The middle of the cells at a place along an axis.
    fn middle(&self, axis: usize, place: usize) -> f64 {
        let [from, to] = self.ends(axis, place);
        0.5 * (from + to)
    }

    /// The middle of a cell.
    pub fn centre(&self, column: usize, row: usize) -> (f64, f64) {
        (self.middle(0, column), self.middle(1, row))
    }

    /// Cells of a `fill`, by their numbers, neighbours to the right that are alike as one.
    /// A cell without a fill is left out.
    pub fn joined(&self, fill: impl Fn(usize) -> Option<CellFill>) -> Vec<MapCell> {
        let [x, y] = &self.edges;
        let [columns, rows] = self.size();
        let columns: Vec<usize> = (0..columns).collect();
        let mut cells = Vec::new();
        for row in 0..rows {
            let fill = |column: usize| fill(self.number(column, row));
            for run in columns.chunk_by(|&one, &next| fill(one) == fill(next)) {
                let [first, last] = [run[0], run[run.len() - 1]];
                let ends = [[x[first], x[last + 1]], [y[row], y[row + 1]]];
                cells.extend(fill(first).map(|fill| MapCell { ends, fill }));
            }
        }
        cells
    }
}

impl Mesh {
    /// The sides between neighbours that are not alike, each a piece of a line; cells of which
    /// nothing is known have no side.
    pub fn outlines(&self, class: impl Fn(usize) -> Option<bool>) -> Vec<(f64, f64)> {
        let [x, y] = &self.edges;
        let [columns, rows] = self.size();
        let mut points = Vec::new();
        let mut draw =
            |ends: [(f64, f64); 2]| points.extend([ends[0], ends[1], (f64::NAN, f64::NAN)]);
        let differ = |one: usize, other: usize| {
            class(one)
                .zip(class(other))
                .is_some_and(|(one, other)| one != other)
        };
        for column in 0..columns {
            for row in 0..rows {
                let cell = self.number(column, row);
                if column + 1 < columns && differ(cell, self.number(column + 1, row)) {
                    draw([(x[column + 1], y[row]), (x[column + 1], y[row + 1])]);
                }
                if row + 1 < rows && differ(cell, self.number(column, row + 1)) {
                    draw([(x[column], y[row + 1]), (x[column + 1], y[row + 1])]);
                }
            }
        }
        points
    }
}

/// Lines half-way between neighbours, in the value or in its logarithm, and as far beyond the
/// first and the last.
pub fn around(values: &[f64], spacing: Spacing) -> Vec<f64> {
    if spacing == Spacing::Log && values.len() > 1 {
        let logarithms: Vec<f64> = values.iter().map(|value| value.ln()).collect();
        let lines = around(&logarithms, Spacing::Linear).into_iter();
        return lines.map(f64::exp).collect();
    }
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
fn even([from, to]: [f64; 2], spacing: Spacing, cells: usize) -> Vec<f64> {
    if from >= to {
        return around(&[from], spacing);
    }
    (0..=cells)
        .map(|index| spacing.between(from, to, index as f64 / cells as f64))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edges(values: &[f64], most: usize) -> Vec<f64> {
        let linear = [Spacing::Linear; 2];
        let [x, _] = Mesh::around(&[values.to_vec(), vec![0.0]], linear, [most, 1]).edges;
        x
    }

    #[test]
    fn values_of_a_grid_have_their_own_cells_or_share_one_with_neighbours() {
        let values = [1.0, 2.0, 4.0, 8.0, 16.0];
        assert_eq!(edges(&values, 104), [0.5, 1.5, 3.0, 6.0, 12.0, 20.0]);
        assert_eq!(edges(&values, 2), [0.5, 3.0, 20.0]);
        assert_eq!(edges(&values, 0), [0.5, 20.0]);
        assert_eq!(edges(&[60.0], 9), [57.0, 63.0]);
        assert_eq!(edges(&[], 9), [-0.5, 0.5]);
    }

    /// Decades have cells as wide as one another, in which places are found.
    #[test]
    fn values_even_in_the_logarithm_have_cells_even_in_it() {
        let values = vec![1e-3, 1e-2, 0.1];
        let mesh = Mesh::around(
            &[values, vec![0.0]],
            [Spacing::Log, Spacing::Linear],
            [3, 1],
        );
        let expected = [-3.5, -2.5, -1.5, -0.5].map(|power| 10f64.powf(power));
        for (line, expected) in mesh.edges[0].iter().zip(expected) {
            assert!((line / expected - 1.0).abs() < 1e-12, "{line} {expected}");
        }
        assert_eq!(
            [0.003, 0.004, 0.05].map(|x| mesh.cell_of([x, 0.0])),
            [0, 1, 2]
        );
        assert_eq!(even([1.0, 100.0], Spacing::Log, 2), [1.0, 10.0, 100.0]);
    }

    #[test]
    fn outlines_part_cells_that_differ() {
        let values = [vec![0.0, 2.0, 4.0], vec![0.0, 2.0]];
        let mesh = Mesh::around(&values, [Spacing::Linear; 2], [3, 2]);
        // The first column with, the second without, the third unknown but for its bottom.
        let classes = [
            Some(true),
            Some(true),
            Some(false),
            Some(false),
            Some(true),
            None,
        ];
        let points = mesh.outlines(|cell| classes[cell]);
        let sides: Vec<_> = points.chunks(3).map(|side| [side[0], side[1]]).collect();
        let expected = [
            [(1.0, -1.0), (1.0, 1.0)],
            [(1.0, 1.0), (1.0, 3.0)],
            [(3.0, -1.0), (3.0, 1.0)],
        ];
        assert_eq!(sides, expected);
    }

    #[test]
    fn cells_of_cases_that_lie_anywhere_are_of_one_size() {
        let values = [0.0, 1.0, 4.0];
        let mesh = Mesh::even(&Extent::example([&values, &[5.0]], 3), [2, 2]);
        assert_eq!(mesh.edges, [vec![0.0, 2.0, 4.0], vec![4.75, 5.25]]);
        let cells = [-1.0, 1.9, 2.0, 4.0].map(|x| mesh.cell_of([x, 5.0]));
        assert_eq!(cells, [0, 0, 1, 1]);
    }
}
