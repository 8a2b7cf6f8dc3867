//! Lines over a lattice, between points that have something and points that have not.

use std::collections::BTreeMap;

/// A line, by twice its places on a lattice: half-way between two neighbours of which one
/// has what the other has not. A closed one ends where it begins.
pub type LimitLine = Vec<[usize; 2]>;

/// The neighbours of places along lines, one or two of each.
type Joints = BTreeMap<[usize; 2], Vec<[usize; 2]>>;

/// The pieces of lines through the cell above and to the right of a point, from the middle of a
/// side to that of another, by which of its corners have it, counterclockwise from that point.
pub fn pieces(corner: [usize; 2], has: [bool; 4]) -> Vec<[[usize; 2]; 2]> {
    let [x, y] = corner.map(|place| 2 * place);
    let middles = [[x + 1, y], [x + 2, y + 1], [x + 1, y + 2], [x, y + 1]];
    let is_crossed = |side: &usize| has[*side] != has[(side + 1) % 4];
    let crossed: Vec<usize> = (0..4).filter(is_crossed).collect();
    match crossed[..] {
        [one, other] => vec![[middles[one], middles[other]]],
        // Two corners that are opposite have it: each is cut off.
        [..] if crossed.len() == 4 => {
            let first = usize::from(!has[0]);
            [first, first + 2]
                .map(|corner| [middles[(corner + 3) % 4], middles[corner]])
                .to_vec()
        }
        _ => Vec::new(),
    }
}

/// Pieces joined to lines: those with ends first, closed ones then.
pub fn join(pieces: impl Iterator<Item = [[usize; 2]; 2]>) -> Vec<LimitLine> {
    let mut next: Joints = BTreeMap::new();
    for [from, to] in pieces {
        next.entry(from).or_default().push(to);
        next.entry(to).or_default().push(from);
    }
    let places: Vec<_> = next.keys().copied().collect();
    let mut lines = Vec::new();
    for most_neighbours in [1, 2] {
        for &start in &places {
            let neighbours = next.get(&start).map_or(0, Vec::len);
            if (1..=most_neighbours).contains(&neighbours) {
                lines.push(follow(&mut next, start));
            }
        }
    }
    lines
}

/// A line from a place on, taken out of what is left of them.
fn follow(next: &mut Joints, start: [usize; 2]) -> LimitLine {
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
