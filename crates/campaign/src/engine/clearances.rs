//! The clearance of a string in its hole: at its sites, and between them, where no wall acts. What
//! the string does there shows where a site is missing.

use linear::elements::reconstruction::Reconstruction;
use sim::Trajectory;

use super::case::Case;
use crate::plan::{Conditions, Setting};
use crate::quantities::WallQuantity;

/// Nodes nearer to a site than this part of the string are at it.
const SAME_PLACE: f64 = 1e-6;

/// The clearance along a string.
#[derive(Debug, Clone, PartialEq)]
pub struct Clearances {
    /// Length of the string, m.
    length: f64,
    /// Depth of each site below the surface and clearance there, m; from the surface down.
    sites: Vec<(f64, f64)>,
    /// Corners of the wall, by depth and clearance, m; from the surface down.
    corners: Vec<(f64, f64)>,
}

/// How far a node of the string goes beyond the wall, where no site is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beyond {
    /// Depth below the surface, m.
    pub depth: f64,
    /// Peak radius less clearance, m: negative where the string stays clear of the wall.
    pub by: f64,
    /// Clearance there, m.
    pub clearance: f64,
}

impl Clearances {
    /// Those of a case; none without a wall. Where only sites have one, it changes evenly between
    /// them, and stays beyond the outermost.
    pub fn of(setting: &Setting, case: &Case) -> Option<Self> {
        let lateral = case.scene.lateral.as_ref()?;
        let distances = setting.sites.distances_from_bit().iter();
        let clearances = lateral.walls.iter().map(|wall| wall.clearance);
        let sites = distances.copied().zip(clearances);
        Self::around(setting, &case.conditions, sites)
    }

    /// Those around sites, from the surface down, by distance from the bit and clearance, m.
    pub fn around(
        setting: &Setting,
        conditions: &Conditions,
        sites: impl Iterator<Item = (f64, f64)>,
    ) -> Option<Self> {
        let settings = setting.lateral.as_ref()?;
        let length = setting.string.length();
        let sites: Vec<(f64, f64)> = sites
            .map(|(from_bit, clearance)| (length - from_bit, clearance))
            .collect();
        let by_axis = conditions.of_wall(None, WallQuantity::Clearance);
        let corners = match by_axis {
            Some(clearance_mm) => vec![(0.0, 1e-3 * clearance_mm)],
            None if settings.clearances.is_empty() => sites.clone(),
            None => settings.clearances.to_vec(),
        };
        Some(Self {
            length,
            sites,
            corners,
        })
    }

    /// Depth and clearance of each site, m.
    pub fn sites(&self) -> &[(f64, f64)] {
        &self.sites
    }

    /// The wall from the surface to the bit: corners by depth and clearance, m.
    pub fn line(&self) -> Vec<(f64, f64)> {
        let ends = self.corners.first().zip(self.corners.last());
        let above = ends.map(|((_, first), _)| (0.0, *first));
        let below = ends.map(|(_, (_, last))| (self.length, *last));
        let corners = self.corners.iter().copied();
        let within = corners.filter(|(depth, _)| *depth <= self.length);
        above.into_iter().chain(within).chain(below).collect()
    }

    /// The clearance at a depth, m; where it changes at once, the lesser.
    pub fn at(&self, depth: f64) -> Option<f64> {
        let same_place = SAME_PLACE * self.length;
        let above = self.corners.partition_point(|it| it.0 < depth - same_place);
        let below = self
            .corners
            .partition_point(|it| it.0 <= depth + same_place);
        let here = self.corners[above..below].iter().map(|corner| corner.1);
        here.reduce(f64::min).or_else(|| {
            let last = above.checked_sub(1).map(|last| self.corners[last]);
            match (last, self.corners.get(below)) {
                (Some((above, one)), Some((below, other))) => {
                    Some(one + (other - one) * (depth - above) / (below - above))
                }
                (Some((_, one)), None) | (None, Some(&(_, one))) => Some(one),
                (None, None) => None,
            }
        })
    }

    /// The depths (m) between which a depth is and the corners around it are.
    pub fn stretch_around(&self, depth: f64) -> [f64; 2] {
        let below = self.corners.partition_point(|corner| corner.0 <= depth);
        let above = below.checked_sub(1).map(|above| self.corners[above].0);
        let below = self.corners.get(below).map(|corner| corner.0);
        [above.unwrap_or(0.0), below.unwrap_or(self.length)]
    }

    /// Every node of a string, from the surface down; none in place of those at its sites.
    fn nodes(&self, whole: &Reconstruction) -> impl Iterator<Item = Option<Beyond>> {
        let same_place = SAME_PLACE * self.length;
        let nodes = whole.depths.iter().zip(&whole.peaks);
        nodes.map(move |(&depth, peak)| {
            let next = (self.sites).partition_point(|site| site.0 < depth - same_place);
            let is_site = (self.sites.get(next)).is_some_and(|site| site.0 <= depth + same_place);
            let clearance = self.at(depth).filter(|_| !is_site)?;
            Some(Beyond {
                depth,
                by: peak - clearance,
                clearance,
            })
        })
    }

    /// Where a string goes farthest beyond the wall, its sites left out; none where it has no
    /// other node.
    pub fn farthest_beyond(&self, whole: &Reconstruction) -> Option<Beyond> {
        let nodes = self.nodes(whole).flatten();
        nodes.max_by(|one, other| one.by.total_cmp(&other.by))
    }

    /// Of every stretch of the string, between its sites, that goes beyond the wall by more than is
    /// `allowed` (m) at its depths (m), the node that goes farthest, from the surface down.
    pub fn bulges_beyond(
        &self,
        whole: &Reconstruction,
        allowed: impl Fn(f64) -> f64,
    ) -> Vec<Beyond> {
        let nodes: Vec<Option<Beyond>> = self.nodes(whole).collect();
        let is_beyond =
            |node: &Option<Beyond>| node.is_some_and(|node| node.by > allowed(node.depth));
        let stretches = nodes.chunk_by(|one, other| is_beyond(one) == is_beyond(other));
        let beyond = stretches.filter(|stretch| is_beyond(&stretch[0]));
        beyond
            .filter_map(|stretch| {
                let nodes = stretch.iter().copied().flatten();
                nodes.max_by(|one, other| one.by.total_cmp(&other.by))
            })
            .collect()
    }

    /// How far each site goes into the wall, m, negative where it does not reach it, with its
    /// depth.
    pub fn at_sites(&self, motion: &Trajectory) -> Vec<(f64, f64)> {
        let sites = self.sites.iter().zip(&motion.positions);
        let into = sites.map(|((depth, clearance), positions)| {
            let radii = positions.iter().map(|[x, y]| x.hypot(*y));
            (*depth, radii.fold(0.0, f64::max) - clearance)
        });
        into.collect()
    }

    /// The farthest that a site goes into the wall, m; negative where none reaches it.
    pub fn farthest_at_sites(&self, motion: &Trajectory) -> f64 {
        let sites = self.at_sites(motion).into_iter();
        sites.map(|site| site.1).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Length of the string, m.
    pub fn length(&self) -> f64 {
        self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Only sites have a clearance.
    fn at_sites() -> Clearances {
        let sites = vec![(60.0, 0.01), (90.0, 0.04)];
        Clearances {
            length: 100.0,
            corners: sites.clone(),
            sites,
        }
    }

    /// Narrow from 70 m to 80 m.
    fn in_hole() -> Clearances {
        let [wide, narrow] = [0.04, 0.01];
        let stretches = [(0.0, 70.0, wide), (70.0, 80.0, narrow), (80.0, 100.0, wide)];
        Clearances {
            corners: (stretches.iter())
                .flat_map(|(from, to, clearance)| [(*from, *clearance), (*to, *clearance)])
                .collect(),
            ..at_sites()
        }
    }

    fn whole(nodes: &[(f64, f64)]) -> Reconstruction {
        Reconstruction {
            depths: nodes.iter().map(|node| node.0).collect(),
            peaks: nodes.iter().map(|node| node.1).collect(),
            shapes: Vec::new(),
        }
    }

    #[test]
    fn the_clearance_is_even_between_sites_and_stays_beyond_the_last() {
        let depths = [0.0, 60.0, 70.0, 90.0, 100.0];
        let found = depths.map(|depth| at_sites().at(depth).unwrap());
        let expected = [0.01, 0.01, 0.02, 0.04, 0.04];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
        assert_eq!(at_sites().line().len(), 4);
    }

    #[test]
    fn where_the_clearance_changes_at_once_the_lesser_counts() {
        let depths = [0.0, 69.9, 70.0, 75.0, 80.0, 80.1, 100.0];
        let found = depths.map(|depth| in_hole().at(depth).unwrap());
        assert_eq!(found, [0.04, 0.04, 0.01, 0.01, 0.01, 0.04, 0.04]);
        assert_eq!(in_hole().stretch_around(72.0), [70.0, 80.0]);
        assert_eq!(at_sites().stretch_around(95.0), [90.0, 100.0]);
    }

    #[test]
    fn the_string_is_held_against_the_wall_away_from_its_sites() {
        let peaks = |[top, one, other, bottom]: [f64; 4]| {
            whole(&[
                (0.0, top),
                (60.0 + 1e-9, 9.0),
                (70.0, one),
                (75.0, other),
                (90.0, bottom),
            ])
        };
        let found = at_sites()
            .farthest_beyond(&peaks([0.0, 0.023, 0.026, 9.0]))
            .unwrap();
        // Not where it is farthest from the middle.
        assert_eq!(found.depth, 70.0);
        assert!((found.by - 0.003).abs() < 1e-12 && (found.clearance - 0.02).abs() < 1e-12);
        let clear = at_sites().farthest_beyond(&peaks([0.0; 4])).unwrap();
        assert_eq!((clear.depth, clear.by), (0.0, -0.01));
    }

    /// A site between two nodes that go beyond the wall divides them.
    #[test]
    fn every_bulge_between_sites_is_found_once() {
        let nodes = [
            (10.0, 0.01),
            (55.0, 0.043),
            (60.0, 9.0),
            (65.0, 0.045),
            (68.0, 0.046),
            (72.0, 0.0105),
            (75.0, 0.02),
            (79.0, 0.013),
            (85.0, 0.03),
            (95.0, 0.05),
        ];
        let found = |by| -> Vec<f64> {
            let bulges = in_hole().bulges_beyond(&whole(&nodes), |_| by);
            bulges.iter().map(|bulge| bulge.depth).collect()
        };
        assert_eq!(found(0.002), [55.0, 68.0, 75.0, 95.0]);
        assert_eq!(found(0.0), [55.0, 75.0, 95.0]);
        assert_eq!(found(0.02), [0.0; 0]);
        let allowed = |depth: f64| if depth < 70.0 { 1.0 } else { 0.0 };
        let bulges = in_hole().bulges_beyond(&whole(&nodes), allowed);
        assert_eq!(bulges.len(), 2);
    }
}
