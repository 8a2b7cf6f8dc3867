//! The hole around a string: the clearance at its sites, between them as if it changed evenly,
//! and beyond the outermost as there. The wall acts at the sites alone; what the string does
//! between them shows where one is missing.

use linear::elements::reconstruction::Reconstruction;
use sim::Trajectory;

use crate::engine::Case;
use crate::plan::Sweep;

/// Nodes nearer to a site than this part of the string are at it.
const SAME_PLACE: f64 = 1e-6;

/// The clearance along a string.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// Length of the string, m.
    length: f64,
    /// Depth of each site below the surface and clearance there, m; from the surface down.
    sites: Vec<(f64, f64)>,
}

/// Where a string goes farthest beyond the wall away from its sites, and how far.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beyond {
    /// Depth below the surface, m.
    pub depth: f64,
    /// Peak radius less clearance, m: negative where the string stays clear of the wall.
    pub by: f64,
    /// Clearance there, m.
    pub clearance: f64,
}

impl Hole {
    /// That of a case; none without a wall.
    pub fn of(sweep: &Sweep, case: &Case) -> Option<Self> {
        let lateral = case.scene.lateral.as_ref()?;
        let length = sweep.setting.string.length();
        let distances = sweep.setting.sites.distances_from_bit().iter();
        let depths = distances.map(|distance| length - distance);
        let clearances = lateral.walls.iter().map(|wall| wall.clearance);
        Some(Self {
            length,
            sites: depths.zip(clearances).collect(),
        })
    }

    /// Depth and clearance of each site, m.
    pub fn sites(&self) -> &[(f64, f64)] {
        &self.sites
    }

    /// The wall from the surface to the bottom: corners by depth and clearance, m.
    pub fn line(&self) -> Vec<(f64, f64)> {
        let ends = self.sites.first().zip(self.sites.last());
        let above = ends.map(|((_, first), _)| (0.0, *first));
        let below = ends.map(|(_, (_, last))| (self.length, *last));
        let sites = self.sites.iter().copied();
        above.into_iter().chain(sites).chain(below).collect()
    }

    /// The clearance at a depth, m.
    fn clearance(&self, depth: f64) -> Option<f64> {
        let next = self.sites.partition_point(|site| site.0 < depth);
        match (
            next.checked_sub(1).map(|last| self.sites[last]),
            self.sites.get(next),
        ) {
            (Some((above, one)), Some((below, other))) => {
                Some(one + (other - one) * (depth - above) / (below - above))
            }
            (Some((_, one)), None) | (None, Some(&(_, one))) => Some(one),
            (None, None) => None,
        }
    }

    /// Where a string goes farthest beyond the wall, its sites left out; none where it has no
    /// other node.
    pub fn farthest_beyond(&self, whole: &Reconstruction) -> Option<Beyond> {
        let same_place = SAME_PLACE * self.length;
        let is_site = |depth: f64| {
            let mut sites = self.sites.iter();
            sites.any(|site| (site.0 - depth).abs() <= same_place)
        };
        let nodes = whole.depths.iter().zip(&whole.peaks);
        let away = nodes.filter(|(depth, _)| !is_site(**depth));
        let beyond = away.filter_map(|(&depth, peak)| {
            let clearance = self.clearance(depth)?;
            Some(Beyond {
                depth,
                by: peak - clearance,
                clearance,
            })
        });
        beyond.max_by(|one, other| one.by.total_cmp(&other.by))
    }

    /// The farthest that a site goes into the wall, m; negative where none reaches it.
    pub fn farthest_at_sites(&self, motion: &Trajectory) -> f64 {
        let sites = self.sites.iter().zip(&motion.positions);
        let into = sites.flat_map(|((_, clearance), positions)| {
            positions.iter().map(move |[x, y]| x.hypot(*y) - clearance)
        });
        into.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Length of the string, m.
    pub fn length(&self) -> f64 {
        self.length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hole() -> Hole {
        Hole {
            length: 100.0,
            sites: vec![(60.0, 0.01), (90.0, 0.04)],
        }
    }

    #[test]
    fn the_clearance_is_even_between_sites_and_stays_beyond_the_last() {
        let depths = [0.0, 60.0, 70.0, 90.0, 100.0];
        let found = depths.map(|depth| hole().clearance(depth).unwrap());
        let expected = [0.01, 0.01, 0.02, 0.04, 0.04];
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-15, "{found} {expected}");
        }
        assert_eq!(hole().line().len(), 4);
    }

    #[test]
    fn the_string_is_held_against_the_wall_away_from_its_sites() {
        let whole = |peaks: [f64; 5]| Reconstruction {
            depths: vec![0.0, 60.0 + 1e-9, 70.0, 75.0, 90.0],
            peaks: peaks.to_vec(),
            shapes: Vec::new(),
        };
        let found = hole()
            .farthest_beyond(&whole([0.0, 9.0, 0.023, 0.026, 9.0]))
            .unwrap();
        // Not where it is farthest from the middle.
        assert_eq!(found.depth, 70.0);
        assert!((found.by - 0.003).abs() < 1e-12 && (found.clearance - 0.02).abs() < 1e-12);
        let clear = hole().farthest_beyond(&whole([0.0; 5])).unwrap();
        assert_eq!((clear.depth, clear.by), (0.0, -0.01));
    }
}
