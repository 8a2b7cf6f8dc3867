//! Which fraction of a tile has a regime, where its limit is no line.

use super::known::{Class, Known};
use super::lattice::{Lattice, Tile};
use crate::random::Stream;

/// Points drawn from a tile in which a limit is not followed.
const DRAWN: usize = 16;

/// A tile of a ragged limit, in a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Band {
    /// The tile.
    pub tile: Tile,
    /// Points of it with the regime.
    pub with: usize,
    /// Points of it whose class is determined.
    pub classified: usize,
}

impl Band {
    /// By the classes of some points of a tile.
    pub fn of_points(
        classes: &Known,
        layer: usize,
        tile: Tile,
        points: impl IntoIterator<Item = [usize; 2]>,
    ) -> Self {
        let mut band = Self {
            tile,
            with: 0,
            classified: 0,
        };
        for place in points {
            let class = classes.at(layer, place);
            band.with += usize::from(class == Class::With);
            band.classified += usize::from(matches!(class, Class::With | Class::Without));
        }
        band
    }
}

/// A few points of a tile, each as likely as any other.
pub fn drawn(lattice: Lattice, seed: u64, tile: Tile) -> Vec<[usize; 2]> {
    let mut points: Vec<_> = tile.own().collect();
    let mut stream = Stream::new(seed, lattice.number(tile.corner) as u64);
    for place in 0..DRAWN.min(points.len()) {
        let others = (points.len() - place) as f64;
        points.swap(place, place + (stream.part() * others) as usize);
    }
    points.truncate(DRAWN);
    points
}
