//! The points over two axes: those of a coarse scan, and half-way between them, level by
//! level.

/// More values of a coarse scan along an axis are a grid.
pub const MOST_COARSE: usize = 1000;

/// Finest steps along the side of the smallest tile that is reported as a whole.
pub const SMALLEST_SIDE: usize = 4;

/// Points over two axes. Places are counted in steps of the finest level; points are
/// numbered as the cases of a grid, the second axis changing fastest.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Lattice {
    /// Cells of the coarse scan along either axis.
    pub coarse: [usize; 2],
    /// How often they are halved.
    pub levels: u32,
}

/// A square of the lattice, of a cell of one of its levels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tile {
    /// Its corner nearest to the origin.
    pub corner: [usize; 2],
    /// Its side, in steps of the finest level.
    pub side: usize,
}

impl Lattice {
    /// Cells of `coarse` each way, halved until a step is at most a part `tolerance` of
    /// either axis.
    pub fn new(coarse: [usize; 2], tolerance: f64) -> Self {
        let fewest = coarse[0].min(coarse[1]) as f64;
        let levels = (0..=52).find(|&level| fewest * f64::from(level).exp2() * tolerance >= 1.0);
        Self {
            coarse,
            levels: levels.unwrap_or(52),
        }
    }

    /// Points along either axis.
    pub fn size(&self) -> [usize; 2] {
        self.cells(self.levels).map(|cells| cells.saturating_add(1))
    }

    /// Points in all; of more than can be counted, as many as can be.
    pub fn points(&self) -> usize {
        let [x, y] = self.size();
        x.saturating_mul(y)
    }

    /// Cells along either axis at a level.
    pub fn cells(&self, level: u32) -> [usize; 2] {
        (self.coarse).map(|cells| cells.saturating_mul(1_usize.checked_shl(level).unwrap_or(0)))
    }

    /// Steps of the finest level between neighbours of a level.
    pub fn step(&self, level: u32) -> usize {
        1 << (self.levels - level)
    }

    /// The number of a point.
    pub fn number(&self, [x, y]: [usize; 2]) -> usize {
        x * self.size()[1] + y
    }

    /// The places of the points of a level, in the order of their numbers.
    pub fn places(&self, level: u32) -> impl Iterator<Item = [usize; 2]> + use<> {
        let ([columns, rows], step) = (self.cells(level), self.step(level));
        (0..=columns).flat_map(move |x| (0..=rows).map(move |y| [x * step, y * step]))
    }

    /// The cells of a level, column by column.
    pub fn tiles(&self, level: u32) -> impl Iterator<Item = Tile> + use<> {
        let ([columns, rows], side) = (self.cells(level), self.step(level));
        let tile = move |x, y| Tile {
            corner: [x * side, y * side],
            side,
        };
        (0..columns).flat_map(move |x| (0..rows).map(move |y| tile(x, y)))
    }

    /// The smallest tile that is reported as a whole and holds a cell of the finest level.
    pub fn reported_tile(&self, cell: Tile) -> Tile {
        let side = SMALLEST_SIDE.min(self.step(0));
        Tile {
            corner: cell.corner.map(|place| place / side * side),
            side,
        }
    }
}

impl Tile {
    /// Where it begins and ends along either axis.
    pub fn ends(&self) -> [[usize; 2]; 2] {
        self.corner.map(|from| [from, from + self.side])
    }

    /// Whether another tile lies within this one.
    pub fn holds(&self, other: &Tile) -> bool {
        let (ends, others) = (self.ends(), other.ends());
        ends.iter()
            .zip(others)
            .all(|([from, to], [start, end])| *from <= start && end <= *to)
    }

    /// The places of its corners, around it.
    pub fn corners(&self) -> [[usize; 2]; 4] {
        let Self {
            corner: [x, y],
            side,
        } = *self;
        [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
    }

    /// The places half-way between its corners, in their order, and in its middle.
    pub fn between(&self) -> [[usize; 2]; 5] {
        let Self {
            corner: [x, y],
            side,
        } = *self;
        let half = side / 2;
        [
            [x + half, y],
            [x + side, y + half],
            [x + half, y + side],
            [x, y + half],
            [x + half, y + half],
        ]
    }

    /// Its own points, those at two of its sides included: every point but the last of
    /// either axis is in one tile.
    pub fn own(&self) -> impl Iterator<Item = [usize; 2]> + use<> {
        let Self { corner, side } = *self;
        (0..side * side).map(move |point| [corner[0] + point / side, corner[1] + point % side])
    }
}
