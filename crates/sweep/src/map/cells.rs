//! Regimes over two axes, cell by cell: what is drawn of a sweep with too many cases for symbols.

use super::extent::Extent;
use super::mesh::Mesh;
use plot::{CellFill, MapCell, Symbol};

/// Symbols counted in cells.
pub struct Cells {
    mesh: Mesh,
    /// By cell.
    counts: Vec<[usize; Symbol::ALL.len()]>,
}

impl Cells {
    /// At most `most` cells to the right and upwards, around the values of a grid; of other
    /// cases, cells of one size.
    pub fn new(extent: &Extent, most: [usize; 2]) -> Self {
        let mesh = if extent.is_grid() {
            Mesh::around(&extent.values, extent.spacing, most)
        } else {
            Mesh::even(extent, most)
        };
        Self::of(mesh)
    }

    /// Those of a mesh.
    pub fn of(mesh: Mesh) -> Self {
        let [columns, rows] = mesh.size();
        Self {
            mesh,
            counts: vec![[0; Symbol::ALL.len()]; columns * rows],
        }
    }

    /// Counts the symbol of a case.
    pub fn add(&mut self, place: [f64; 2], symbol: Symbol) {
        self.counts[self.mesh.cell_of(place)][symbol as usize] += 1;
    }

    /// Cells to the right and upwards.
    pub fn size(&self) -> [usize; 2] {
        self.mesh.size()
    }

    /// Whether any cell has more than one case.
    pub fn are_shared(&self) -> bool {
        let mut counts = self.counts.iter();
        counts.any(|counts| counts.iter().sum::<usize>() > 1)
    }

    /// The symbol that most cases of a cell have; none where it has no case.
    pub fn symbol(&self, column: usize, row: usize) -> Option<Symbol> {
        self.symbol_in(self.mesh.number(column, row))
    }

    fn symbol_in(&self, cell: usize) -> Option<Symbol> {
        let counts = self.counts[cell];
        let most = [
            Symbol::Disc,
            Symbol::HeavyCross,
            Symbol::FilledDiamond,
            Symbol::Circle,
            Symbol::Triangle,
            Symbol::Cross,
            Symbol::Diamond,
            Symbol::Square,
        ]
        .into_iter()
        .max_by_key(|&symbol| counts[symbol as usize]);
        most.filter(|&most| counts[most as usize] > 0)
    }

    /// Neighbours to the right that are alike as one.
    pub fn joined(&self) -> Vec<MapCell> {
        let fill = |cell| self.symbol_in(cell).map(CellFill::Symbol);
        self.mesh.joined(fill)
    }

    /// The middle of a cell.
    pub fn centre(&self, column: usize, row: usize) -> (f64, f64) {
        self.mesh.centre(column, row)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cases enough for a grid would have cells around its values.
    #[test]
    fn a_cell_shows_what_most_of_its_cases_are() {
        let mut cells = Cells::new(&Extent::example([&[0.0, 4.0], &[1.0, 2.0]], 3), [2, 2]);
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
        assert_eq!(cells.centre(1, 0), (3.0, 1.25));
        let cell = |x, symbol| MapCell {
            ends: [x, [1.0, 1.5]],
            fill: CellFill::Symbol(symbol),
        };
        let expected = [
            cell([0.0, 2.0], Symbol::Circle),
            cell([2.0, 4.0], Symbol::Square),
        ];
        assert_eq!(cells.joined(), expected);
    }

    #[test]
    fn a_grid_gets_a_cell_for_each_of_its_values_however_uneven() {
        let values: Vec<f64> = (0..100).map(|step| 1.07f64.powi(step)).collect();
        let mut cells = Cells::new(&Extent::example([&values, &[1.5]], 100), [104, 78]);
        assert_eq!(cells.size(), [100, 1]);
        for (index, &x) in values.iter().enumerate() {
            let symbol = [Symbol::Cross, Symbol::Circle][index % 2];
            cells.add([x, 1.5], symbol);
        }
        assert!(!cells.are_shared());
        // Without a gap, and with some height.
        let joined = cells.joined();
        assert_eq!(joined.len(), 100);
        let touch = |pair: &[MapCell]| pair[0].ends[0][1] == pair[1].ends[0][0];
        assert!(joined.windows(2).all(touch));
        assert_eq!(joined[0].ends[1], [1.425, 1.575]);
        cells.add([1.0, 1.5], Symbol::Cross);
        assert!(cells.are_shared());
    }
}
