//! The lines between points with and without a regime.

use std::collections::{BTreeMap, BTreeSet};

use super::known::Class;
use super::lattice::Tile;
use super::refine::Traced;

/// A line, by twice its places on a lattice: half-way between two neighbours of which one
/// has the regime. A closed one ends where it begins.
pub type Line = Vec<[usize; 2]>;

/// The limits of a layer, in the cells of the finest level where all corners tell, but for
/// those within bands. Neighbouring points with and without the regime are on either side
/// of a line.
pub fn contours(traced: &Traced, layer: usize) -> Vec<Line> {
    let (classes, bands) = (&traced.classes, traced.bands[layer].iter());
    let lattice = classes.lattice;
    let tiles: BTreeSet<Tile> = bands.map(|band| band.tile).collect();
    let is_out = |cell: &Tile| !tiles.contains(&lattice.told_of_in(*cell));
    let mut next: Joints = BTreeMap::new();
    for cell in lattice.tiles(lattice.levels).filter(is_out) {
        for [from, to] in pieces(cell, cell.corners().map(|at| classes.at(layer, at))) {
            next.entry(from).or_default().push(to);
            next.entry(to).or_default().push(from);
        }
    }
    lines(next)
}

/// The neighbours of places along lines, one or two of each.
type Joints = BTreeMap<[usize; 2], Vec<[usize; 2]>>;

/// Pieces joined to lines: those with ends first, closed ones then.
fn lines(mut next: Joints) -> Vec<Line> {
    let places: Vec<_> = next.keys().copied().collect();
    let mut lines = Vec::new();
    for most_neighbours in [1, 2] {
        for &start in &places {
            let neighbours = next.get(&start).map_or(0, Vec::len);
            if (1..=most_neighbours).contains(&neighbours) {
                lines.push(straight(follow(&mut next, start)));
            }
        }
    }
    lines
}

/// The pieces of lines through a cell, from the middle of a side to that of another.
fn pieces(cell: Tile, corners: [Class; 4]) -> Vec<[[usize; 2]; 2]> {
    let tells = |class: &Class| matches!(class, Class::With | Class::Without);
    if !corners.iter().all(tells) {
        return Vec::new();
    }
    let [x, y] = cell.corner.map(|place| 2 * place);
    let middles = [[x + 1, y], [x + 2, y + 1], [x + 1, y + 2], [x, y + 1]];
    let is_crossed = |side: &usize| corners[*side] != corners[(side + 1) % 4];
    let crossed: Vec<usize> = (0..4).filter(is_crossed).collect();
    match crossed[..] {
        [one, other] => vec![[middles[one], middles[other]]],
        // Two corners that are opposite have the regime: each is cut off.
        [..] if crossed.len() == 4 => {
            let first = usize::from(corners[0] != Class::With);
            [first, first + 2]
                .map(|corner| [middles[(corner + 3) % 4], middles[corner]])
                .to_vec()
        }
        _ => Vec::new(),
    }
}

/// A line from a place on, taken out of what is left of them.
fn follow(next: &mut Joints, start: [usize; 2]) -> Line {
    let mut line = vec![start];
    let mut at = start;
    while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
        if let Some(back) = next.get_mut(&to) {
            back.retain(|place| *place != at);
        }
        line.push(to);
        at = to;
    }
    line
}

/// Without the points that lie on the way between their neighbours.
fn straight(line: Line) -> Line {
    // Neighbours are at most two apart.
    let step = |from: [usize; 2], to: [usize; 2]| [0, 1].map(|axis| to[axis] + 2 - from[axis]);
    let turns = |at: usize| step(line[at - 1], line[at]) != step(line[at], line[at + 1]);
    let last = line.len() - 1;
    let kept = (0..=last).filter(|&at| at == 0 || at == last || turns(at));
    kept.map(|at| line[at]).collect()
}
