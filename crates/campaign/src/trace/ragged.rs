//! Whether a limit is simple on a given scale.
//!
//! Near a line, the points of either side are connected. Where they fall apart into more
//! pieces, there is structure that the points are too far apart to show, or none: chance.

use super::known::Known;
use super::lattice::Tile;

/// Cells around one that are examined with it, to every side.
const AROUND: usize = 2;

/// A tongue between two lines has one piece more than there are classes.
const PIECES_OF_A_TONGUE: usize = 1;

/// A limit with this number of single points, surrounded by others, is not simple.
const FEWEST_SPECKS: usize = 1;

/// Whether the points around a cell are in more pieces than a limit that is a line, or two
/// lines, would leave.
pub fn is_ragged(known: &Known, layer: usize, tile: Tile) -> bool {
    let size = known.lattice.size();
    let ends = [0, 1].map(|axis| {
        let before = (tile.corner[axis] / tile.side).min(AROUND) * tile.side;
        let after = (size[axis] - 1 - tile.corner[axis]) / tile.side;
        let last = tile.corner[axis] + after.min(AROUND + 1) * tile.side;
        [tile.corner[axis] - before, last]
    });
    let along = |[from, to]: [usize; 2]| (from..=to).step_by(tile.side).collect::<Vec<_>>();
    let [columns, rows] = ends.map(along);
    let classes: Vec<_> = (columns.iter())
        .flat_map(|&x| rows.iter().map(move |&y| known.at(layer, [x, y])))
        .collect();
    let mut seen = Vec::new();
    for class in &classes {
        if !seen.contains(class) {
            seen.push(*class);
        }
    }
    let (pieces, specks) = pieces(&classes, rows.len());
    specks >= FEWEST_SPECKS || pieces > seen.len() + PIECES_OF_A_TONGUE
}

/// In how many pieces the points of a rectangle are: neighbours along either axis that are
/// alike hang together. How many of the pieces are single points within it, too.
fn pieces<T: PartialEq>(points: &[T], rows: usize) -> (usize, usize) {
    let mut is_counted = vec![false; points.len()];
    let mut open = Vec::new();
    let (mut count, mut specks) = (0, 0);
    for first in 0..points.len() {
        if is_counted[first] {
            continue;
        }
        count += 1;
        is_counted[first] = true;
        open.push(first);
        let mut size = 0;
        while let Some(point) = open.pop() {
            size += 1;
            let row = point % rows;
            let neighbours = [
                point.checked_sub(rows),
                Some(point + rows).filter(|next| *next < points.len()),
                point.checked_sub(1).filter(|_| row > 0),
                Some(point + 1).filter(|_| row + 1 < rows),
            ];
            for next in neighbours.into_iter().flatten() {
                if !is_counted[next] && points[next] == points[point] {
                    is_counted[next] = true;
                    open.push(next);
                }
            }
        }
        let [column, row] = [first / rows, first % rows];
        let is_inner = column > 0 && first + rows < points.len() && row > 0 && row + 1 < rows;
        specks += usize::from(size == 1 && is_inner);
    }
    (count, specks)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_are_counted() {
        assert_eq!(pieces(&[1, 1, 1, 1], 2), (1, 0));
        // A checkerboard, and a tongue.
        assert_eq!(pieces(&[1, 2, 2, 1], 2), (4, 0));
        assert_eq!(pieces(&[1, 2, 1, 1, 2, 1, 1, 2, 1], 3), (3, 0));
        // A ring holds what is in it.
        assert_eq!(pieces(&[1, 1, 1, 1, 2, 1, 1, 1, 1], 3), (2, 1));
        assert_eq!(pieces::<u8>(&[], 1), (0, 0));
    }
}
