//! Which points are wanted next.

use std::collections::BTreeSet;

use super::band::{Band, drawn};
use super::known::{Class, Known};
use super::lattice::{Lattice, SMALLEST_SIDE, Tile};
use super::ragged::is_ragged;

/// How a trace continues.
#[derive(Debug)]
pub enum Next {
    /// These points are to be simulated: their numbers, in ascending order.
    Wanted(Vec<usize>),
    /// Nothing more: the limits are known.
    Done(Box<Traced>),
}

/// What a trace has found.
#[derive(Debug)]
pub struct Traced {
    /// The classes of all points: as simulated, or as the points around them; unknown
    /// within tiles in which the limit of a layer was not followed.
    pub classes: Known,
    /// Of each layer, where its limit is no line: tiles in which it was not followed, and
    /// smaller ones in which it is ragged on the finest scale.
    pub bands: Vec<Vec<Band>>,
}

/// What is wanted next, by what is `known`; `seed` draws points from tiles. Each layer is
/// traced for itself; what is wanted for one is wanted for all.
pub fn next(known: &Known, seed: u64) -> Next {
    let lattice = known.lattice;
    let mut walk = Walk {
        known,
        seed,
        classes: Known::nothing(lattice, known.layers()),
        layers: vec![Layer::default(); known.layers()],
    };
    let coarse: Vec<_> = lattice.places(0).collect();
    if let Some(wanted) = walk.wanted(&coarse) {
        return wanted;
    }
    for layer in 0..known.layers() {
        (coarse.iter()).for_each(|place| walk.classes.take(layer, *place, known));
    }
    for level in 0..lattice.levels {
        if let Some(wanted) = walk.halve(level) {
            return wanted;
        }
    }
    Next::Done(Box::new(walk.done()))
}

/// A trace on its way from level to level.
struct Walk<'a> {
    known: &'a Known,
    seed: u64,
    /// Of the levels so far.
    classes: Known,
    layers: Vec<Layer>,
}

/// What was seen of the limit of a layer.
#[derive(Clone, Default)]
struct Layer {
    /// Cells of the level before in which it is ragged.
    ragged: BTreeSet<Tile>,
    /// Tiles in which it was not followed.
    left: Vec<Tile>,
    /// Cells of this level within these.
    is_left: BTreeSet<Tile>,
}

impl Walk<'_> {
    fn lattice(&self) -> Lattice {
        self.known.lattice
    }

    /// Those of some points that are not known, if there are any.
    fn wanted(&self, places: &[[usize; 2]]) -> Option<Next> {
        let unknown = places.iter().filter(|place| !self.known.has(**place));
        let numbers: BTreeSet<usize> = unknown.map(|place| self.lattice().number(*place)).collect();
        (!numbers.is_empty()).then(|| Next::Wanted(numbers.into_iter().collect()))
    }

    /// From the points of a level to those of the next one, or the points that this takes.
    fn halve(&mut self, level: u32) -> Option<Next> {
        let (mut halved, mut drawn) = (BTreeSet::new(), Vec::new());
        for layer in 0..self.layers.len() {
            drawn.extend(self.leave(layer, level));
            halved.extend(self.with_limit(layer, level));
        }
        loop {
            let between = halved.iter().flat_map(Tile::between);
            let places: Vec<_> = between.chain(drawn.iter().copied()).collect();
            if let Some(wanted) = self.wanted(&places) {
                return Some(wanted);
            }
            let others = self
                .lattice()
                .tiles(level)
                .filter(|tile| !halved.contains(tile));
            let others: Vec<Tile> = others.filter(|tile| self.differs_within(*tile)).collect();
            if others.is_empty() {
                break;
            }
            halved.extend(others);
        }
        for layer in 0..self.layers.len() {
            self.fill(layer, level);
            let is_left = &mut self.layers[layer].is_left;
            *is_left = is_left.iter().flat_map(quarters).collect();
        }
        None
    }

    /// The cells of a level that the limit of a layer passes, and is followed in.
    fn mixed(&self, layer: usize, level: u32) -> impl Iterator<Item = Tile> {
        let is_left = &self.layers[layer].is_left;
        let tiles = self.lattice().tiles(level);
        tiles
            .filter(|tile| !is_left.contains(tile))
            .filter(move |tile| !self.classes.are_alike(layer, &tile.corners()))
    }

    /// These cells and those around them, but for those that are left.
    fn with_limit(&self, layer: usize, level: u32) -> BTreeSet<Tile> {
        let around = self.mixed(layer, level).flat_map(|tile| self.around(tile));
        let is_left = &self.layers[layer].is_left;
        around.filter(|tile| !is_left.contains(tile)).collect()
    }

    /// Leaves the cells in which a limit is as ragged as near by on the scale before, and draws
    /// points from them.
    fn leave(&mut self, layer: usize, level: u32) -> Vec<[usize; 2]> {
        let cells = self.with_limit(layer, level).into_iter();
        let ragged = cells.filter(|tile| is_ragged(&self.classes, layer, *tile));
        let ragged: BTreeSet<Tile> = ragged.collect();
        let before = &self.layers[layer].ragged;
        let was_ragged = |tile: &&Tile| {
            let around = self.around(parent(**tile));
            around.iter().any(|tile| before.contains(tile))
        };
        let is_large = self.lattice().step(level) >= SMALLEST_SIDE;
        let left = ragged.iter().filter(|_| is_large).filter(was_ragged);
        let left: Vec<Tile> = left.copied().collect();
        let seen = &mut self.layers[layer];
        seen.is_left.extend(&left);
        seen.left.extend(&left);
        seen.ragged = ragged;
        let (lattice, seed) = (self.lattice(), self.seed);
        left.into_iter()
            .flat_map(|tile| drawn(lattice, seed, tile))
            .collect()
    }

    /// A cell with those around it.
    fn around(&self, tile: Tile) -> Vec<Tile> {
        let size = self.lattice().size();
        let around_along = |axis: usize| {
            let corner = tile.corner[axis];
            let before = corner.checked_sub(tile.side);
            let all = [before, Some(corner), Some(corner + tile.side)];
            let inside = all.into_iter().flatten();
            inside.filter(move |corner| corner + tile.side < size[axis])
        };
        around_along(0)
            .flat_map(|x| around_along(1).map(move |y| [x, y]))
            .map(|corner| Tile { corner, ..tile })
            .collect()
    }

    /// Whether a cell, with corners that are alike in a layer, has a point between them, known
    /// from elsewhere, that is not: the limit leaves the cells that were halved.
    fn differs_within(&self, tile: Tile) -> bool {
        let corner = tile.corner;
        (0..self.layers.len()).any(|layer| {
            let class = self.classes.at(layer, corner);
            let differs = |place: &[usize; 2]| {
                self.known.has(*place) && self.known.at(layer, *place) != class
            };
            !self.layers[layer].is_left.contains(&tile) && tile.between().iter().any(differs)
        })
    }

    /// Every point of the next level is as it is known, or as the points around it.
    fn fill(&mut self, layer: usize, level: u32) {
        let is_left = &self.layers[layer].is_left;
        let tiles = self.lattice().tiles(level);
        for tile in tiles.filter(|tile| !is_left.contains(tile)) {
            let corners = tile.corners();
            for (side, place) in tile.between().into_iter().enumerate() {
                let around = match corners.get(side) {
                    Some(corner) => &[*corner, corners[(side + 1) % 4]][..],
                    None => &corners,
                };
                if self.known.has(place) {
                    self.classes.take(layer, place, self.known);
                } else if self.classes.are_alike(layer, around) {
                    self.classes.take_from(layer, place, corners[side % 4]);
                }
            }
        }
    }

    fn done(self) -> Traced {
        let bands = (0..self.layers.len())
            .map(|layer| self.bands(layer))
            .collect();
        Traced {
            bands,
            classes: self.classes,
        }
    }

    /// Where the limit of a layer is no line.
    fn bands(&self, layer: usize) -> Vec<Band> {
        let lattice = self.lattice();
        let of_left = |tile: &Tile| {
            let points = drawn(lattice, self.seed, *tile);
            Band::of_points(self.known, layer, *tile, points)
        };
        let ragged = (self.mixed(layer, lattice.levels))
            .filter(|tile| is_known(&self.classes, layer, *tile))
            .filter(|tile| is_ragged(&self.classes, layer, *tile));
        let rough: BTreeSet<Tile> = ragged.map(|tile| lattice.reported_tile(tile)).collect();
        let of_rough = |tile: Tile| Band::of_points(&self.classes, layer, tile, tile.own());
        let left = self.layers[layer].left.iter().map(of_left);
        left.chain(rough.into_iter().map(of_rough)).collect()
    }
}

/// Whether all corners of a cell are known.
fn is_known(classes: &Known, layer: usize, tile: Tile) -> bool {
    let mut corners = tile.corners().into_iter();
    corners.all(|place| classes.at(layer, place) != Class::Unknown)
}

/// The cell of the level before that holds a cell.
fn parent(tile: Tile) -> Tile {
    let side = 2 * tile.side;
    Tile {
        corner: tile.corner.map(|place| place / side * side),
        side,
    }
}

/// The cells of the next level within a cell.
fn quarters(tile: &Tile) -> [Tile; 4] {
    let (side, [x, y]) = (tile.side / 2, tile.corner);
    [[x, y], [x, y + side], [x + side, y], [x + side, y + side]].map(|corner| Tile { corner, side })
}
