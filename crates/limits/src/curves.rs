//! The limit of `boundary.csv` as curves over the two quantities it relates, regardless of what a
//! map shows of them.

use crate::boundary::Boundary;
use crate::lying_limit::{LyingLimit, LyingPoint};
use crate::torsion_limit::{MOTOR_STALLS, StickSlipPoint, TorsionLimit};
use crate::whirl_limit::{WhirlMotion, WhirlPoint, branches, inside, rolling_envelope};
use campaign::quantities::{Axis, LENGTH, Units};
use campaign::words::short;
use sim::Motion;

/// What the curves of whirl are. Several sites together may whirl below those of one.
const ROLLING: &str = "steady rolling whirl at one site";
const LEAST: &str =
    "least friction of steady whirl at one site, rolling or sliding (necessary, not sufficient)";
const OF_ANY_SITES: &str =
    "least friction of steady whirl of any sites together (necessary, not sufficient)";

const SMOOTH_ROTATION: &str = "smooth rotation is lost below";
const STEADY_DRILLING: &str = "limit of steady drilling (linear)";

/// More branches than this hide the cases of a map.
const MOST_BRANCHES: usize = 6;

/// Longer lists of sites are written by their ends.
const MOST_SITES: usize = 3;

/// Frictions that differ by a smaller part of them are one line on a map.
const SAME: f64 = 1e-6;

/// One limit.
///
/// ```
/// use campaign::quantities::{Axis, Units};
/// use limits::{Boundary, StickSlipPoint, TorsionLimit};
///
/// let point = |(weight, speed): (f64, f64)| StickSlipPoint {
///     weight_on_bit_kn: Some(weight),
///     torque_dynamic_nm: 30.0 * weight,
///     surface_speed_rpm: speed,
///     method: "quadrature".to_owned(),
///     limit: TorsionLimit::StickSlip,
/// };
/// let boundary = Boundary::StickSlip([(20.0, 0.4), (80.0, 1.6)].map(point).to_vec());
/// let curves = boundary.curves(&[Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm], Units::Si);
/// assert_eq!(curves.len(), 1);
/// assert_eq!((curves[0].along, curves[0].limited), (Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm));
/// assert_eq!(curves[0].pieces, [[[20.0, 0.4], [80.0, 1.6]]]);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in a legend.
    pub name: String,
    /// The method whose limit it is, where methods differ in it.
    pub method: Option<String>,
    /// The motion that is limited.
    pub motion: Motion,
    /// The quantity that the limit depends on.
    pub along: Axis,
    /// The quantity that is limited.
    pub limited: Axis,
    /// Values of both, in the order in which they are joined; there is no limit
    /// between the pieces.
    pub pieces: Vec<Vec<[f64; 2]>>,
    /// Whether no other curve of as many sites is below it.
    pub is_least: bool,
}

impl Boundary {
    /// The curves of the limit, for cases that differ along `axes`; their names have the sites
    /// that they are of in these units, where there are several.
    pub fn curves(&self, axes: &[Axis], units: Units) -> Vec<Curve> {
        match self {
            Boundary::StickSlip(points) => stick_slip_curves(points, axes),
            Boundary::Whirl(points) => whirl_curves(points, units),
            Boundary::Lying(points) => lying_curves(points, axes),
        }
    }
}

/// Limits of a string that lies: of speeds over friction where the cases differ in it, else over
/// the weight on bit; of the weight over the other axis.
fn lying_curves(points: &[LyingPoint], axes: &[Axis]) -> Vec<Curve> {
    let on_weight = axes.contains(&Axis::WeightOnBitKn) && !axes.contains(&Axis::FRICTION);
    let curve = |points: &[LyingPoint]| {
        let limit = points[0].limit;
        let [along, limited] = match limit {
            LyingLimit::Buckling => {
                let is_other = |axis: &&Axis| **axis != Axis::WeightOnBitKn;
                let other = axes.iter().find(is_other).copied();
                [other.unwrap_or(Axis::FRICTION), Axis::WeightOnBitKn]
            }
            LyingLimit::MotorStall => [Axis::SurfaceSpeedRpm, Axis::WeightOnBitKn],
            _ if on_weight => [Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm],
            _ => [Axis::FRICTION, Axis::SurfaceSpeedRpm],
        };
        let place = |point: &LyingPoint| Some([point.of(along)?, point.of(limited)?]);
        // Of each swing one.
        let pieces = points.chunk_by(|one, next| one.swing == next.swing);
        let pieces = pieces.map(|piece| piece.iter().filter_map(place).collect());
        Curve {
            name: limit.words().to_owned(),
            method: None,
            motion: match limit {
                LyingLimit::MotorStall => Motion::Torsion,
                _ => Motion::Lateral,
            },
            along,
            limited,
            pieces: pieces.collect(),
            is_least: true,
        }
    };
    let curves = points.chunk_by(|one, next| one.limit == next.limit);
    curves.map(curve).collect()
}

/// Eq. 74 for each method, over the weight on bit where the cases differ in it, else
/// over the torque.
fn stick_slip_curves(points: &[StickSlipPoint], axes: &[Axis]) -> Vec<Curve> {
    let along = if axes.contains(&Axis::WeightOnBitKn) {
        Axis::WeightOnBitKn
    } else {
        Axis::TorqueDynamicNm
    };
    let methods =
        points.chunk_by(|one, next| (one.limit, &one.method) == (next.limit, &next.method));
    methods
        .map(|points| match points[0].limit {
            TorsionLimit::StickSlip => {
                let name = format!("one-slip estimate (Eq. 74), {}", points[0].method);
                let method = Some(points[0].method.clone());
                speed_limit_curve(name, method, (points, along))
            }
            TorsionLimit::SmoothRotation => {
                speed_limit_curve(SMOOTH_ROTATION.to_owned(), None, (points, along))
            }
            TorsionLimit::SteadyDrilling => steady_drilling_curve(points),
            TorsionLimit::MotorStall => motor_stall_curve(points, along),
        })
        .collect()
}

/// A limit of the surface speed along the weight on bit or the torque.
fn speed_limit_curve(
    name: String,
    method: Option<String>,
    (points, along): (&[StickSlipPoint], Axis),
) -> Curve {
    let place = |point: &StickSlipPoint| Some([point.along(along)?, point.surface_speed_rpm]);
    Curve {
        name,
        method,
        motion: Motion::Torsion,
        along,
        limited: Axis::SurfaceSpeedRpm,
        pieces: vec![points.iter().filter_map(place).collect()],
        is_least: true,
    }
}

/// Where a mud motor stalls: a limit of the weight on bit or the torque, over the surface speed.
fn motor_stall_curve(points: &[StickSlipPoint], limited: Axis) -> Curve {
    let place = |point: &StickSlipPoint| Some([point.surface_speed_rpm, point.along(limited)?]);
    Curve {
        name: MOTOR_STALLS.to_owned(),
        method: None,
        motion: Motion::Torsion,
        along: Axis::SurfaceSpeedRpm,
        limited,
        pieces: vec![points.iter().filter_map(place).collect()],
        is_least: true,
    }
}

/// Where steady drilling is about to grow: a piece as long as the weight grows.
fn steady_drilling_curve(points: &[StickSlipPoint]) -> Curve {
    let along = Axis::WeightOnBitKn;
    let pieces = points.chunk_by(|one, next| one.along(along) < next.along(along));
    let place = |point: &StickSlipPoint| Some([point.along(along)?, point.surface_speed_rpm]);
    Curve {
        name: STEADY_DRILLING.to_owned(),
        method: None,
        motion: Motion::Axial,
        along,
        limited: Axis::SurfaceSpeedRpm,
        pieces: pieces
            .map(|piece| piece.iter().filter_map(place).collect())
            .collect(),
        is_least: true,
    }
}

/// Rolling whirl, a piece for each of its branches, any whirl at one site where that needs less
/// friction, and what whirl of any sites needs.
fn whirl_curves(points: &[WhirlPoint], units: Units) -> Vec<Curve> {
    let of_motion = |motion| {
        let of_motion = branches(points).filter(|branch| branch[0].motion == motion);
        of_motion.collect::<Vec<_>>()
    };
    let rolling = rolling_envelope(points);
    let is_lower = |point: &WhirlPoint| {
        let least = rolling.at(point.surface_speed_rpm);
        least.is_none_or(|least| point.friction < (1.0 - SAME) * least)
    };
    let any = of_motion(WhirlMotion::RollingOrSliding);
    let needs_less = any.iter().copied().flatten().any(is_lower);
    let (rolling_name, rolling) = rolling_curve(&of_motion(WhirlMotion::Rolling));
    let all = sites_of(points.iter());
    let named = |name: String, motion: WhirlMotion| {
        let sites = sites_of(points.iter().filter(|point| point.motion == motion));
        match all.len() {
            0 | 1 => name,
            _ => format!("{name}, {}", places(&sites, units)),
        }
    };
    let any = any.into_iter().filter(|_| needs_less).map(piece).collect();
    // One line, whichever sites do most of the work.
    let together = of_motion(WhirlMotion::AnySites).concat();
    let together = [together].iter().map(|points| piece(points)).collect();
    [
        (rolling_name, WhirlMotion::Rolling, rolling, !needs_less),
        (LEAST.to_owned(), WhirlMotion::RollingOrSliding, any, true),
        (
            OF_ANY_SITES.to_owned(),
            WhirlMotion::AnySites,
            together,
            true,
        ),
    ]
    .into_iter()
    .filter(|(_, _, pieces, _)| pieces.iter().any(|piece| !piece.is_empty()))
    .map(|(name, motion, pieces, is_least)| Curve {
        name: named(name, motion),
        method: None,
        motion: Motion::Lateral,
        along: Axis::SurfaceSpeedRpm,
        limited: Axis::FRICTION,
        pieces,
        is_least,
    })
    .collect()
}

/// The sites that points are of, m from the bit, each once.
fn sites_of<'a>(points: impl Iterator<Item = &'a WhirlPoint>) -> Vec<f64> {
    each_once(points.flat_map(|point| point.sites_from_bit_m.iter().copied()))
}

/// Sites in order, each once.
pub(super) fn each_once(sites: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sites: Vec<f64> = sites.collect();
    sites.sort_by(f64::total_cmp);
    sites.dedup();
    sites
}

/// Where sites are (m from the bit), in words.
pub(super) fn places(sites: &[f64], units: Units) -> String {
    let unit = units.of(&LENGTH);
    let number = |site: &f64| short(unit.number(*site));
    let places = match sites {
        [first, .., last] if sites.len() > MOST_SITES => {
            format!(
                "{} sites {} to {}",
                sites.len(),
                number(first),
                number(last)
            )
        }
        _ => sites.iter().map(number).collect::<Vec<_>>().join(", "),
    };
    format!("{places} {} from the bit", unit.name)
}

/// Name and pieces of rolling whirl. Of many branches, where they need the least.
fn rolling_curve(branches: &[&[WhirlPoint]]) -> (String, Vec<Vec<[f64; 2]>>) {
    if branches.len() <= MOST_BRANCHES {
        let pieces = branches.iter().copied().map(piece);
        return (ROLLING.to_owned(), pieces.collect());
    }
    let name = format!("{ROLLING}, the least of {} branches", branches.len());
    let runs = branches.iter().flat_map(|branch| {
        let runs = branch.chunk_by(|one, next| one.least == next.least);
        runs.filter(|run| run[0].least).map(piece)
    });
    (name, runs.collect())
}

fn piece(branch: &[WhirlPoint]) -> Vec<[f64; 2]> {
    let points = branch.iter();
    points
        .map(|point| [point.surface_speed_rpm, point.friction])
        .collect()
}

impl Curve {
    /// The ranges of one of its two quantities, `shown`, while the other one is
    /// within `held`: one for each stretch of the curve. The quantities are 0 for the
    /// one that the limit depends on, 1 for the limited one.
    pub fn ranges(&self, shown: usize, held: [f64; 2]) -> Vec<[f64; 2]> {
        const ROUNDING: f64 = 1e-9;
        let room = |end: f64| ROUNDING * if end.is_finite() { end.abs() } else { 0.0 };
        let held = [held[0] - room(held[0]), held[1] + room(held[1])];
        let pieces = self.pieces.iter();
        pieces
            .flat_map(|piece| piece_ranges(piece, shown, held))
            .collect()
    }
}

fn piece_ranges(piece: &[[f64; 2]], shown: usize, held: [f64; 2]) -> Vec<[f64; 2]> {
    let other = 1 - shown;
    if let [point] = piece {
        let is_inside = (held[0]..=held[1]).contains(&point[other]);
        return is_inside.then_some([point[shown]; 2]).into_iter().collect();
    }
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    let mut is_open = false;
    for side in piece.windows(2) {
        let [from, to] = [side[0], side[1]];
        let Some([enters, leaves]) = inside(from[other], to[other], held) else {
            is_open = false;
            continue;
        };
        let at = |part: f64| from[shown] + part * (to[shown] - from[shown]);
        let (one, two) = (at(enters), at(leaves));
        match ranges.last_mut() {
            Some([low, high]) if is_open => {
                (*low, *high) = (low.min(one).min(two), high.max(one).max(two));
            }
            _ => ranges.push([one.min(two), one.max(two)]),
        }
        is_open = leaves >= 1.0;
    }
    ranges
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(pieces: &[&[[f64; 2]]]) -> Curve {
        Curve {
            name: "a".to_owned(),
            method: None,
            motion: Motion::Lateral,
            along: Axis::SurfaceSpeedRpm,
            limited: Axis::FRICTION,
            pieces: pieces.iter().map(|piece| piece.to_vec()).collect(),
            is_least: true,
        }
    }

    #[test]
    fn a_held_quantity_gives_the_other_one_stretch_by_stretch() {
        let hill = curve(&[&[[0.0, 0.0], [2.0, 2.0], [4.0, 0.0]], &[[6.0, 1.0]]]);
        assert_eq!(hill.ranges(1, [1.0, 1.0])[0].map(f64::round), [1.0, 1.0]);
        assert_eq!(hill.ranges(1, [1.0, 3.0])[0].map(f64::round), [1.0, 2.0]);
        let crossings: Vec<f64> = (hill.ranges(0, [1.0, 1.0]).iter())
            .map(|range| (0.5 * (range[0] + range[1])).round())
            .collect();
        assert_eq!(crossings, [1.0, 3.0, 6.0]);
        assert_eq!(hill.ranges(0, [5.0, 9.0]), Vec::<[f64; 2]>::new());
        assert_eq!(hill.ranges(1, [4.5, 5.5]), Vec::<[f64; 2]>::new());
        // All of it, and its very end.
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        assert_eq!(hill.ranges(1, free), [[0.0, 2.0], [1.0, 1.0]]);
        assert!(hill.ranges(1, [4.0; 2])[0][1].abs() < 1e-6);
    }

    fn point(speed: f64, friction: f64, branch: Option<usize>) -> WhirlPoint {
        WhirlPoint {
            surface_speed_rpm: speed,
            friction,
            site_from_bit_m: 0.0,
            radius_mm: Some(16.0),
            precession_turns_per_s: 9.0,
            normal_force_kn: Some(34.0),
            branch,
            motion: match branch {
                Some(_) => WhirlMotion::Rolling,
                None => WhirlMotion::RollingOrSliding,
            },
            least: true,
            sites_from_bit_m: vec![0.0],
        }
    }

    #[test]
    fn branches_of_whirl_are_pieces_and_whirl_that_slides_is_drawn_where_it_needs_less() {
        let mut points = vec![
            point(60.0, 1.5, Some(0)),
            point(70.0, 1.4, Some(0)),
            point(60.0, 1.6, Some(1)),
            point(60.0, 1.2, None),
        ];
        let curves = Boundary::Whirl(points.clone()).curves(&[], Units::default());
        let pieces: Vec<_> = curves.iter().map(|curve| &curve.pieces[..]).collect();
        let rolling = [vec![[60.0, 1.5], [70.0, 1.4]], vec![[60.0, 1.6]]];
        assert_eq!(pieces, [&rolling[..], &[vec![[60.0, 1.2]]]]);
        assert!(!curves[0].is_least && curves[1].is_least);
        points[3].friction = 1.5;
        assert_eq!(
            Boundary::Whirl(points.clone())
                .curves(&[], Units::default())
                .len(),
            1
        );
        // Of many branches, the stretches that need the least.
        let others = (2..10).map(|branch| WhirlPoint {
            least: false,
            ..point(60.0, 2.0, Some(branch))
        });
        points.truncate(3);
        points[2].least = false;
        points.extend(others);
        let curves = Boundary::Whirl(points).curves(&[], Units::default());
        assert_eq!(curves[0].pieces, [[[60.0, 1.5], [70.0, 1.4]]]);
        assert_eq!(
            Boundary::Whirl(Vec::new()).curves(&[], Units::default()),
            []
        );
    }

    #[test]
    fn whirl_of_any_sites_is_one_line_whichever_do_most() {
        let any = [(60.0, 0.3, 0.0), (70.0, 0.3, 0.0), (70.0, 0.2, 50.0)];
        let any = any.map(|(speed, friction, site_from_bit_m)| WhirlPoint {
            site_from_bit_m,
            sites_from_bit_m: vec![site_from_bit_m],
            motion: WhirlMotion::AnySites,
            ..point(speed, friction, None)
        });
        let mut points = vec![point(60.0, 1.5, Some(0)), point(60.0, 1.5, None)];
        points.extend(any);
        let curves = Boundary::Whirl(points).curves(&[], Units::default());
        assert_eq!(curves.len(), 2);
        assert!(
            curves[1].name.ends_with("0, 50 m from the bit"),
            "{curves:?}"
        );
        assert_eq!(curves[1].pieces, [[[60.0, 0.3], [70.0, 0.3], [70.0, 0.2]]]);
        assert!(curves.iter().all(|curve| curve.is_least));
    }
}
