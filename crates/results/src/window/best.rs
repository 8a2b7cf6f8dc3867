//! The best point of a chart, by a rule.

use serde::Serialize;

use super::by_axis::by_axis;
use super::chart::Chart;
use super::standing::Standing;

/// Halvings that find how far away the nearest limit is.
const HALVINGS: usize = 20;

/// A point is next to what is no farther away than this, times the distance that it keeps.
const NEXT_TO: f64 = 1.2;

/// A point of a safe region.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Best {
    /// Weight on bit, kN, and surface speed, rpm.
    #[serde(flatten, serialize_with = "by_axis")]
    pub at: [f64; 2],
    /// The part of either axis by which it may be off without meeting a limit.
    pub clearance: f64,
    /// Whether it and what is around it are clear of all limits, or safe unless something is begun.
    pub standing: Standing,
    /// Whether that is as much as was asked for; else it is the safe point that has most.
    pub is_as_asked: bool,
    /// Rate of penetration there, m/h, of a bit that cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_of_penetration_m_h: Option<f64>,
    /// How far it is to a limit, by axis, downwards and upwards.
    #[serde(serialize_with = "by_axis")]
    pub room: [[Room; 2]; 2],
}

/// How far it is from a point in one direction.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Room {
    /// How far, in the unit of the axis.
    pub distance: f64,
    /// The limits that are met there; none at the end of the map.
    pub limits: Vec<String>,
}

impl Best {
    /// Whether the end of the map is all that keeps more weight or speed away: a larger map may have
    /// a better point.
    pub fn is_at_end(&self, clearance: f64, chart: &Chart) -> bool {
        [0, 1].iter().any(|&axis: &usize| {
            let [least, most] = chart.range(axis);
            let upwards = &self.room[axis][1];
            let reach = NEXT_TO * clearance.max(self.clearance) * (most - least);
            upwards.limits.is_empty() && upwards.distance <= reach
        })
    }
}

impl Chart {
    /// Of the points that stay safe when weight and speed are off by a part `clearance` of their
    /// axes, together, the one with the greatest rate of penetration, where that is known; else with
    /// the greatest weight times speed: the power that a bit spends on the rock grows with both. Those that are clear of every limit go before those that are
    /// safe unless something is begun. Where no point stays so, the safe one that may be off by
    /// most; none where nothing is safe. Beyond the ends of the map nothing is known: a point keeps
    /// its distance from them as from a limit.
    pub fn best(&self, clearance: f64) -> Option<Best> {
        let levels = [Standing::Clear, Standing::Possible];
        let as_asked = levels.into_iter().find_map(|standing| {
            let points = self.clearances(standing);
            let kept = points.iter().filter(|(_, own)| *own >= clearance);
            let best = kept.max_by(|one, other| self.merit(one.0).total_cmp(&self.merit(other.0)));
            best.map(|&(cell, own)| (standing, cell, own))
        });
        // Of equals the last, which is clear.
        let widest = || {
            let points = levels.into_iter().rev().flat_map(|standing| {
                let points = self.clearances(standing).into_iter();
                points.map(move |(cell, own)| (standing, cell, own))
            });
            points.max_by(|one, other| one.2.total_cmp(&other.2))
        };
        let is_as_asked = as_asked.is_some();
        let (standing, cell, own) = as_asked.or_else(widest)?;
        let room = |axis| [false, true].map(|upwards| self.room(standing, cell, axis, upwards));
        Some(Best {
            at: self.middle(cell),
            clearance: own,
            standing,
            is_as_asked,
            rate_of_penetration_m_h: self.rate(cell),
            room: [0, 1].map(room),
        })
    }

    /// What a cell is good for: a rate that is not known for nothing.
    fn merit(&self, cell: usize) -> f64 {
        match self.rates.is_empty() {
            true => self.middle(cell).into_iter().product(),
            false => self.rate(cell).unwrap_or(0.0),
        }
    }

    /// The cells that stand no worse than that, each with the part by which it may be off.
    fn clearances(&self, standing: Standing) -> Vec<(usize, f64)> {
        let worse = Worse::than(standing, self);
        let cells = self.cells().filter(|&cell| self.standing(cell) <= standing);
        cells
            .map(|cell| (cell, worse.clearance(self, self.middle(cell))))
            .collect()
    }

    /// How far it is from the middle of a cell along an axis.
    fn room(&self, standing: Standing, cell: usize, axis: usize, upwards: bool) -> Room {
        let (mut place, middle) = (self.place(cell), self.middle(cell)[axis]);
        loop {
            let end = self.edges[axis][place[axis] + usize::from(upwards)];
            let distance = (end - middle).abs();
            let next = if upwards {
                Some(place[axis] + 1).filter(|&it| it < self.size()[axis])
            } else {
                place[axis].checked_sub(1)
            };
            let Some(next) = next else {
                return Room {
                    distance,
                    limits: Vec::new(),
                };
            };
            place[axis] = next;
            let met = self.worse_than(standing, self.number(place));
            if !met.is_empty() {
                let limits = met.into_iter().map(str::to_owned).collect();
                return Room { distance, limits };
            }
        }
    }
}

/// How many cells before each stand worse than some way.
struct Worse {
    /// By column and row, of all to the left and below.
    before: Vec<usize>,
    rows: usize,
}

impl Worse {
    fn than(standing: Standing, chart: &Chart) -> Self {
        let [columns, rows] = chart.size().map(|cells| cells + 1);
        let mut before = vec![0; columns * rows];
        for column in 1..columns {
            for row in 1..rows {
                let cell = chart.number([column - 1, row - 1]);
                let at = |column: usize, row: usize| before[column * rows + row];
                before[column * rows + row] = at(column - 1, row) + at(column, row - 1)
                    - at(column - 1, row - 1)
                    + usize::from(chart.standing(cell) > standing);
            }
        }
        Self { before, rows }
    }

    /// The largest part of the axes by which a point may be off.
    fn clearance(&self, chart: &Chart, at: [f64; 2]) -> f64 {
        let [mut kept, mut broken] = [0.0, 1.0];
        if self.is_clear(chart, at, broken) {
            return broken;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (kept + broken);
            match self.is_clear(chart, at, middle) {
                true => kept = middle,
                false => broken = middle,
            }
        }
        kept
    }

    /// Whether no cell around a point is worse, nor beyond the map.
    fn is_clear(&self, chart: &Chart, at: [f64; 2], clearance: f64) -> bool {
        let is_inside = [0, 1].iter().all(|&axis: &usize| {
            let [least, most] = chart.range(axis);
            let reach = clearance * (most - least);
            at[axis] - reach >= least && at[axis] + reach <= most
        });
        if !is_inside {
            return false;
        }
        let [columns, rows] = [0, 1].map(|axis| {
            let [least, most] = chart.range(axis);
            let reach = clearance * (most - least);
            let edges = &chart.edges[axis];
            let first = edges.partition_point(|edge| *edge <= at[axis] - reach);
            let last = edges.partition_point(|edge| *edge < at[axis] + reach);
            [first.saturating_sub(1), last.min(edges.len() - 1)]
        });
        let before = |column: usize, row: usize| self.before[column * self.rows + row];
        before(columns[1], rows[1]) + before(columns[0], rows[0])
            == before(columns[0], rows[1]) + before(columns[1], rows[0])
    }
}

#[cfg(test)]
mod tests {
    use super::super::analytic::above_speed;
    use super::super::chart::tests::chart;
    use super::*;

    /// Against below a line from (0, 0) to (128 kN, 256 rpm), and above 192 rpm.
    fn wedge() -> Chart {
        chart(vec![
            Box::new(|[[_, weight], [speed, _]]| match speed >= 2.0 * weight {
                true => Standing::Clear,
                false => Standing::Against,
            }),
            Box::new(|[_, [_, high]]| match high <= 192.0 {
                true => Standing::Clear,
                false => Standing::Near,
            }),
        ])
    }

    #[test]
    fn the_best_point_keeps_its_distance_from_every_limit() {
        let chart = wedge();
        // With a reach of 6.4 kN and 12.8 rpm: the corner (96, 192) less both.
        let best = chart.best(0.05).expect("a point");
        let [weight, speed] = best.at;
        assert!(best.is_as_asked && best.clearance >= 0.05, "{best:?}");
        assert!((speed - (192.0 - 12.8)).abs() < 3.0, "{best:?}");
        assert!(
            (weight - 0.5 * (speed - 12.8 - 12.8)).abs() < 3.0,
            "{best:?}"
        );
        let [[less, more], [slower, faster]] = best.room;
        assert_eq!(
            (less.limits, &more.limits[..]),
            (vec![], &["limit 0".to_owned()][..])
        );
        assert_eq!(
            (slower.limits[0].as_str(), faster.limits[0].as_str()),
            ("limit 0", "limit 1")
        );
        assert!((faster.distance - (192.0 - speed)).abs() < 1e-9);
        assert!((less.distance - weight).abs() < 1e-9);
        // Every corner of its box is safe, and none with a tenth more of both.
        for sides in [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]] {
            let [w, s] = [weight + 6.4 * sides[0], speed + 12.8 * sides[1]];
            assert!(s >= 2.0 * w && s <= 192.0, "{w} {s}");
        }
    }

    /// Faster drilling with less weight, as where a bit founders.
    #[test]
    fn the_best_point_drills_fastest_where_the_rate_is_known() {
        let chart = wedge().with_rates(|[weight, speed]| Some(speed * (100.0 - weight)));
        let best = chart.best(0.05).expect("a point");
        // As light and as fast as the distance to the ends allows.
        assert!((best.at[0] - 6.4).abs() < 1.0, "{best:?}");
        assert!((best.at[1] - (192.0 - 12.8)).abs() < 3.0, "{best:?}");
        let rate = best.rate_of_penetration_m_h.expect("a rate");
        assert!((rate - best.at[1] * (100.0 - best.at[0])).abs() < 1e-9);
        let unknown = wedge().with_rates(|[weight, _]| (weight > 40.0).then_some(1.0));
        assert!(unknown.best(0.05).expect("a point").at[0] > 40.0);
        assert_eq!(
            wedge().best(0.05).expect("a point").rate_of_penetration_m_h,
            None
        );
    }

    #[test]
    fn what_is_clear_goes_before_what_only_does_not_begin() {
        let with_whirl = |from: f64| {
            let mut sides = wedge();
            let whirl = chart(vec![Box::new(move |ends| above_speed(from, ends))]);
            sides.limits.extend(whirl.limits);
            sides.best(0.05).expect("a point")
        };
        let below = with_whirl(128.0);
        assert_eq!(below.standing, Standing::Clear);
        assert!((below.at[1] - (128.0 - 12.8)).abs() < 3.0, "{below:?}");
        let all = with_whirl(20.0);
        assert_eq!(all.standing, Standing::Possible);
        assert!((all.at[1] - (192.0 - 12.8)).abs() < 3.0, "{all:?}");
        assert_eq!(all.room[1][1].limits, ["limit 1"]);
    }

    #[test]
    fn without_a_point_as_far_the_widest_is_given() {
        let best = wedge().best(0.4).expect("a point");
        assert!(!best.is_as_asked);
        // At a weight of 128 c, 192 − 256 c is 768 c: three sixteenths.
        assert!((0.17..0.19).contains(&best.clearance), "{best:?}");
        assert_eq!(best.standing, Standing::Clear);
        let nowhere = chart(vec![Box::new(|_| Standing::Undetermined)]);
        assert_eq!(nowhere.best(0.05), None);
        let everywhere = chart(vec![Box::new(|_| Standing::Clear)]);
        let best = everywhere.best(0.6).expect("a point");
        assert!((0.49..=0.5).contains(&best.clearance), "{best:?}");
        assert!((best.at[0] - 64.0).abs() < 1.0, "{best:?}");
        let best = everywhere.best(0.05).expect("a point");
        assert!((best.at[0] - 0.95 * 128.0).abs() < 1.0, "{best:?}");
        assert!(best.is_at_end(0.05, &everywhere));
    }
}
