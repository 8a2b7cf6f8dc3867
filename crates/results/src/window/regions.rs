//! Where no limit is near, region by region.

use serde::Serialize;

use super::by_axis::by_axis;
use super::chart::Chart;
use super::standing::Standing;

/// A cell within the map, and those that it touches along a side or at a corner.
const WITH_NEIGHBOURS: usize = 9;

/// Cells that touch along a side.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Region {
    /// Their numbers, in ascending order.
    #[serde(skip)]
    pub cells: Vec<usize>,
    /// From the least to the greatest weight (kN), and the same of the speed (rpm).
    #[serde(flatten, serialize_with = "by_axis")]
    pub ends: [[f64; 2]; 2],
    /// The part of the map that they are.
    pub share: f64,
    /// The part of the map in which they are safe even of what something else may begin.
    pub clear: f64,
}

impl Chart {
    /// The safe regions, the largest first: nothing that is limited begins there by itself.
    pub fn safe_regions(&self) -> Vec<Region> {
        let mut is_left: Vec<bool> = (self.cells())
            .map(|cell| self.standing(cell) <= Standing::Possible)
            .collect();
        let mut regions = Vec::new();
        for first in self.cells() {
            if !is_left[first] {
                continue;
            }
            is_left[first] = false;
            let (mut found, mut open) = (Vec::new(), vec![first]);
            while let Some(cell) = open.pop() {
                found.push(cell);
                for next in self.neighbours(cell) {
                    if std::mem::take(&mut is_left[next]) {
                        open.push(next);
                    }
                }
            }
            found.sort_unstable();
            regions.push(self.region(found));
        }
        regions.sort_by(|one, other| other.share.total_cmp(&one.share));
        regions
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        let [column, row] = self.place(cell);
        let [columns, rows] = self.size();
        let columns = [
            column.checked_sub(1),
            Some(column + 1).filter(|&it| it < columns),
        ];
        let rows = [row.checked_sub(1), Some(row + 1).filter(|&it| it < rows)];
        let sideways = columns.into_iter().flatten().map(move |it| [it, row]);
        let above = rows.into_iter().flatten().map(move |it| [column, it]);
        sideways.chain(above).map(|place| self.number(place))
    }

    /// A cell and those that it touches, at corners too.
    fn around(&self, cell: usize) -> impl Iterator<Item = usize> {
        let [column, row] = self.place(cell);
        let [columns, rows] = self.size();
        let near = |place: usize, count: usize| place.saturating_sub(1)..(place + 2).min(count);
        let columns = near(column, columns);
        columns.flat_map(move |column| near(row, rows).map(move |row| self.number([column, row])))
    }

    fn region(&self, cells: Vec<usize>) -> Region {
        let nothing = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        let ends = cells.iter().fold(nothing, |ends, &cell| {
            let own = self.ends(cell);
            [0, 1].map(|axis| {
                let ([from, to], [least, most]) = (own[axis], ends[axis]);
                [least.min(from), most.max(to)]
            })
        });
        let is_clear = |cell: &&usize| self.standing(**cell) == Standing::Clear;
        Region {
            share: cells.iter().map(|&cell| self.share(cell)).sum(),
            clear: (cells.iter().filter(is_clear))
                .map(|&cell| self.share(cell))
                .sum(),
            cells,
            ends,
        }
    }

    /// The cell of a region that is farthest from its edge, corners too, in steps of cells, and of
    /// several in the middle of them: where its name stands.
    pub fn heart(&self, region: &Region) -> usize {
        let is_inside = |cell: usize| region.cells.binary_search(&cell).is_ok();
        // Ring by ring of what is at its edge is taken away.
        let mut inmost = region.cells.clone();
        loop {
            let is_left = |cell: usize| inmost.binary_search(&cell).is_ok();
            let has_all_round = |&cell: &usize| {
                let around = self.around(cell).filter(|&other| is_left(other));
                around.count() == WITH_NEIGHBOURS
            };
            let inner: Vec<usize> = inmost.iter().copied().filter(has_all_round).collect();
            if inner.is_empty() {
                break;
            }
            inmost = inner;
        }
        let [columns, rows] = self.size();
        // Steps to the edge along each axis; the edge of the map is one too.
        let depth = |&cell: &usize| {
            let [column, row] = self.place(cell);
            let steps = |places: &mut dyn Iterator<Item = [usize; 2]>| {
                places
                    .take_while(|place| is_inside(self.number(*place)))
                    .count()
            };
            let left = steps(&mut (0..column).rev().map(|it| [it, row]));
            let right = steps(&mut (column + 1..columns).map(|it| [it, row]));
            let below = steps(&mut (0..row).rev().map(|it| [column, it]));
            let above = steps(&mut (row + 1..rows).map(|it| [column, it]));
            let (sideways, upright) = (left.min(right), below.min(above));
            (sideways.min(upright), sideways.max(upright))
        };
        let best = inmost.iter().max_by_key(|cell| depth(cell));
        best.copied().unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::chart::tests::chart;
    use super::*;

    #[test]
    fn regions_are_parted_by_limits_and_the_largest_comes_first() {
        // A band of speeds splits the map in a third and two thirds of what is left.
        let chart = chart(vec![Box::new(|[_, [low, high]]| {
            match high <= 64.0 || low >= 128.0 {
                true => Standing::Clear,
                false => Standing::Near,
            }
        })]);
        let regions = chart.safe_regions();
        let shares: Vec<f64> = regions.iter().map(|it| (4.0 * it.share).round()).collect();
        assert_eq!(shares, [2.0, 1.0]);
        assert_eq!(regions[0].ends, [[0.0, 128.0], [128.0, 256.0]]);
        assert_eq!(regions[1].ends, [[0.0, 128.0], [0.0, 64.0]]);
        let [weight, speed] = chart.middle(chart.heart(&regions[1]));
        assert!((24.0..104.0).contains(&weight) && (24.0..40.0).contains(&speed));
    }

    /// Its inner corner is far from the edge along both axes, and next to what is outside.
    #[test]
    fn the_name_of_a_bent_region_does_not_stand_at_its_inner_corner() {
        let is_inside =
            |weights: [f64; 2], speeds: [f64; 2]| weights[1] <= 64.0 || speeds[0] >= 128.0;
        let chart = chart(vec![Box::new(move |[weights, speeds]| {
            match is_inside(weights, speeds) {
                true => Standing::Clear,
                false => Standing::Near,
            }
        })]);
        let regions = chart.safe_regions();
        assert_eq!(regions.len(), 1);
        let [weight, speed] = chart.middle(chart.heart(&regions[0]));
        assert!(
            weight < 64.0 - 16.0 || speed > 128.0 + 32.0,
            "{weight}, {speed}"
        );
    }

    #[test]
    fn corners_do_not_join_regions() {
        let chart = chart(vec![Box::new(|[weights, speeds]| {
            match (weights[1] <= 64.0) == (speeds[1] <= 128.0) {
                true => Standing::Clear,
                false => Standing::Against,
            }
        })]);
        assert_eq!(chart.safe_regions().len(), 2);
    }
}
