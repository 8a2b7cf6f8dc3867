//! Regimes over two axes, cell by cell: what is drawn of a sweep with more cases
//! than can be told apart.

use super::extent::Extent;
use crate::plot::{Ground, MapCell, Symbol};

/// Symbols counted in cells.
pub struct Cells {
    ranges: [[f64; 2]; 2],
    size: [usize; 2],
    counts: Vec<[usize; 3]>,
}

impl Cells {
    /// At most `most` cells to the right and upwards; fewer where an axis has fewer
    /// values, so that none is empty between them.
    pub fn new(extent: &Extent, most: [usize; 2]) -> Self {
        let size = [0, 1].map(|axis| most[axis].min(extent.values[axis].len()).max(1));
        Self {
            ranges: extent.ranges,
            size,
            counts: vec![[0; 3]; size[0] * size[1]],
        }
    }

    /// Counts the symbol of a case.
    pub fn add(&mut self, [x, y]: [f64; 2], symbol: Symbol) {
        let place = |[from, to]: [f64; 2], value: f64, cells: usize| {
            let fraction = (value - from) / (to - from).max(f64::MIN_POSITIVE);
            ((fraction * cells as f64) as usize).min(cells - 1)
        };
        let column = place(self.ranges[0], x, self.size[0]);
        let row = place(self.ranges[1], y, self.size[1]);
        self.counts[column * self.size[1] + row][symbol as usize] += 1;
    }

    /// Cells to the right and upwards.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The symbol that most cases of a cell have; none where it has no case.
    pub fn symbol(&self, column: usize, row: usize) -> Option<Symbol> {
        let counts = self.counts[column * self.size[1] + row];
        let symbols = [Symbol::Circle, Symbol::Cross, Symbol::Square];
        let most = symbols
            .into_iter()
            .max_by_key(|&symbol| counts[symbol as usize]);
        most.filter(|&most| counts[most as usize] > 0)
    }

    /// Neighbours to the right that are alike as one.
    pub fn joined(&self) -> Vec<MapCell> {
        let corner = |column, row| self.place(column as f64, row as f64);
        joined(self.size, corner, |column, row| {
            self.symbol(column, row).map(Ground::Symbol)
        })
    }

    /// A place to the right and upwards, counted in cells.
    pub fn place(&self, column: f64, row: f64) -> [f64; 2] {
        let index = [column, row];
        [0, 1].map(|axis| {
            let [from, to] = self.ranges[axis];
            from + (to - from) * index[axis] / self.size[axis] as f64
        })
    }
}

/// Cells of a `ground`, neighbours to the right that are alike as one, by the lower left
/// `corner` of each. A cell without a ground is left out.
pub fn joined(
    [columns, rows]: [usize; 2],
    corner: impl Fn(usize, usize) -> [f64; 2],
    ground: impl Fn(usize, usize) -> Option<Ground>,
) -> Vec<MapCell> {
    let columns: Vec<usize> = (0..columns).collect();
    let mut cells = Vec::new();
    for row in 0..rows {
        for run in columns.chunk_by(|&one, &next| ground(one, row) == ground(next, row)) {
            let [left, bottom] = corner(run[0], row);
            let [right, top] = corner(run[run.len() - 1] + 1, row + 1);
            let ends = [[left, right], [bottom, top]];
            cells.extend(ground(run[0], row).map(|ground| MapCell { ends, ground }));
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_shows_what_most_of_its_cases_are() {
        let mut cells = Cells::new(&Extent::example([&[0.0, 4.0], &[1.0, 2.0]], 4), [2, 2]);
        for (x, symbol) in [
            (0.0, Symbol::Circle),
            (1.0, Symbol::Circle),
            (1.9, Symbol::Cross),
            (4.0, Symbol::Square),
        ] {
            cells.add([x, 1.0], symbol);
        }
        let bottom = [cells.symbol(0, 0), cells.symbol(1, 0)];
        assert_eq!(bottom, [Some(Symbol::Circle), Some(Symbol::Square)]);
        assert_eq!(cells.symbol(0, 1), None);
        assert_eq!(cells.place(1.5, 0.5), [3.0, 1.25]);
        let cell = |x, symbol| MapCell {
            ends: [x, [1.0, 1.5]],
            ground: Ground::Symbol(symbol),
        };
        let expected = [
            cell([0.0, 2.0], Symbol::Circle),
            cell([2.0, 4.0], Symbol::Square),
        ];
        assert_eq!(cells.joined(), expected);
    }

    #[test]
    fn a_grid_gets_a_cell_for_each_of_its_values() {
        let values = [0.0, 1.0, 2.0, 3.0, 4.0];
        let mut cells = Cells::new(&Extent::example([&values, &[1.5]], 5), [72, 54]);
        assert_eq!(cells.size(), [5, 1]);
        for x in values {
            cells.add([x, 1.5], Symbol::Cross);
        }
        let [cell] = &cells.joined()[..] else {
            panic!("{:?}", cells.joined());
        };
        assert_eq!(cell.ends[0], [0.0, 4.0]);
    }
}
