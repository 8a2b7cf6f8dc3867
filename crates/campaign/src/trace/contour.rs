//! The lines between points with and without a regime.

use std::collections::BTreeSet;

use super::known::Class;
use super::lattice::Tile;
use super::line::{LimitLine, join, pieces};
use super::refine::Traced;

/// The limits of a layer, in the cells of the finest level where all corners tell, but for
/// those within bands. Neighbouring points with and without the regime are on either side
/// of a line.
pub fn contours(traced: &Traced, layer: usize) -> Vec<LimitLine> {
    let (classes, bands) = (&traced.classes, traced.bands[layer].iter());
    let lattice = classes.lattice;
    let tiles: BTreeSet<Tile> = bands.map(|band| band.tile).collect();
    let is_out = |cell: &Tile| !tiles.contains(&lattice.reported_tile(*cell));
    let tells = |class: &Class| matches!(class, Class::With | Class::Without);
    let of_cell = |cell: Tile| {
        let corners = cell.corners().map(|at| classes.at(layer, at));
        let all_tell = corners.iter().all(tells);
        let pieces = pieces(cell.corner, corners.map(|class| class == Class::With));
        pieces.into_iter().filter(move |_| all_tell)
    };
    let cells = lattice.tiles(lattice.levels).filter(is_out);
    join(cells.flat_map(of_cell))
        .into_iter()
        .map(straight)
        .collect()
}

/// Without the points that lie on the way between their neighbours.
fn straight(line: LimitLine) -> LimitLine {
    // Neighbours are at most two apart.
    let step = |from: [usize; 2], to: [usize; 2]| [0, 1].map(|axis| to[axis] + 2 - from[axis]);
    let turns = |at: usize| step(line[at - 1], line[at]) != step(line[at], line[at + 1]);
    let last = line.len() - 1;
    let kept = (0..=last).filter(|&at| at == 0 || at == last || turns(at));
    kept.map(|at| line[at]).collect()
}
