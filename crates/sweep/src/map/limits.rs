//! The limit on a map: its line where both of its quantities are axes of the map, a
//! line or a range across the map where one is, and in words where it is out of view.

use super::extent::Extent;
use super::mesh::around;
use super::words::{ends, quantity};
use campaign::quantities::{Axis, Units};
use campaign::sweep_file::Spacing;
use limits::Curve;
use plot::{Band, LineStyle, Series, is_within, method_style};
use sim::Motion;

/// The limit on a map.
#[derive(Default)]
pub struct Limits {
    /// What is drawn as a line.
    pub lines: Vec<Series>,
    /// What is drawn as a range.
    pub bands: Vec<Band>,
    /// What is out of view.
    pub notes: Vec<String>,
}

/// Ranges narrower than this part of their value are lines.
const NARROW: f64 = 1e-6;

/// How far the line through a single point reaches to either side, as a part of its axis.
const REACH: f64 = 0.01;

impl Limits {
    /// The limits that `curves` are on a map, while quantities off the map are `held`
    /// within the ranges of its cases.
    pub fn of(curves: &[&Curve], extent: &Extent, held: impl Fn(Axis) -> [f64; 2]) -> Limits {
        let mut limits = Limits::default();
        let shown =
            (curves.iter()).filter(|curve| curve.is_least || !Self::is_range(curve, extent, &held));
        for curve in shown {
            let note = limits.add(curve, extent, &held);
            limits.notes.extend(note);
        }
        // By the names that they begin with.
        limits.notes.sort();
        limits
    }

    /// Whether a map puts cases together that differ in what a limit of whirl depends on: then
    /// the range of the least limit counts, not that of each branch.
    fn is_range(curve: &Curve, extent: &Extent, held: impl Fn(Axis) -> [f64; 2]) -> bool {
        let [low, high] = held(curve.along);
        curve.motion == Motion::Lateral
            && extent.axes.contains(&curve.limited)
            && !extent.axes.contains(&curve.along)
            && low < high
    }

    /// Adds a curve to what is drawn, or gives a note on where it is.
    fn add(
        &mut self,
        curve: &Curve,
        extent: &Extent,
        held: impl Fn(Axis) -> [f64; 2],
    ) -> Option<String> {
        let place = |axis| extent.axes.iter().position(|&other| other == axis);
        match (place(curve.along), place(curve.limited)) {
            (Some(_), Some(limited)) => self.add_line(curve, extent, limited),
            (None, Some(on_map)) => self.add_across(curve, extent, on_map, 1, held(curve.along)),
            (Some(on_map), None) => self.add_across(curve, extent, on_map, 0, held(curve.limited)),
            (None, None) => {
                let values = span(&curve.ranges(1, held(curve.along)))?;
                let values = ends(curve.limited, values, extent.units);
                let name = &curve.name;
                Some(format!("{name}: {values}, on neither axis of this map"))
            }
        }
    }

    /// Both quantities are axes of the map, the limited one at the given place.
    fn add_line(&mut self, curve: &Curve, extent: &Extent, limited: usize) -> Option<String> {
        let on_map = |&[along, value]: &[f64; 2]| match limited {
            0 => (value, along),
            _ => (along, value),
        };
        let places = |piece: &[[f64; 2]]| piece.iter().map(on_map).collect::<Vec<_>>();
        let (ranges, pieces) = (extent.ranges, &curve.pieces);
        if pieces.iter().any(|piece| is_within(&places(piece), ranges)) {
            let (range, spacing) = (ranges[1 - limited], extent.spacing[1 - limited]);
            let lines = pieces
                .iter()
                .map(|piece| places(&with_length(piece, range, spacing)));
            self.lines.push(Series {
                name: curve.name.clone(),
                style: style(curve),
                points: lines.collect::<Vec<_>>().join(&(f64::NAN, f64::NAN)),
            });
            return None;
        }
        // The place on the map of what the limit depends on, and of what is limited.
        let places = [1 - limited, limited];
        let shown = places.map(|place| ranges[place]);
        out_of_view(curve, shown, extent.units, |of, value| {
            side(places[of], value, ranges[places[of]]).to_owned()
        })
    }

    /// One quantity, 0 for what the limit depends on and 1 for what is limited, is the
    /// axis at place `on_map`; the other one is held.
    fn add_across(
        &mut self,
        curve: &Curve,
        extent: &Extent,
        on_map: usize,
        shown: usize,
        held: [f64; 2],
    ) -> Option<String> {
        let stretches = curve.ranges(shown, held);
        let Some(whole) = span(&stretches) else {
            return Some(beyond(curve, shown, held, extent.units));
        };
        let range = extent.ranges[on_map];
        let is_seen = |[low, high]: &[f64; 2]| *low <= range[1] && *high >= range[0];
        let seen: Vec<_> = stretches.into_iter().filter(is_seen).collect();
        for [low, high] in &seen {
            let across = extent.ranges[1 - on_map];
            if high - low <= NARROW * high.abs() {
                let at = 0.5 * (low + high);
                let points = across.map(|across| match on_map {
                    0 => (at, across),
                    _ => (across, at),
                });
                self.lines.push(Series {
                    name: curve.name.clone(),
                    style: style(curve),
                    points: points.to_vec(),
                });
            } else {
                let mut ends = [across; 2];
                ends[on_map] = [*low, *high];
                self.bands.push(Band {
                    name: format!("{}: its range over these cases", curve.name),
                    ends,
                });
            }
        }
        if !seen.is_empty() {
            return None;
        }
        let [axis, other] = match shown {
            0 => [curve.along, curve.limited],
            _ => [curve.limited, curve.along],
        };
        let at = if held[0].is_finite() && held[1].is_finite() {
            format!(" at {}", ends(other, held, extent.units))
        } else {
            String::new()
        };
        let [low, high] = whole.map(|end| (margin(end, range), end));
        let (margin, end) = if low.0 <= high.0 { low } else { high };
        let limit = ends(axis, whole, extent.units) + &at;
        let margin = quantity(axis, margin, extent.units);
        Some(unseen(curve, &limit, side(on_map, end, range), &margin))
    }
}

/// A limit by a method has its colour.
fn style(curve: &Curve) -> LineStyle {
    let method = curve.method.as_deref();
    method.map_or_else(LineStyle::default, method_style)
}

/// A curve that never reaches what is held: `shown` is the quantity on the map.
fn beyond(curve: &Curve, shown: usize, held: [f64; 2], units: Units) -> String {
    let held_words = ends([curve.limited, curve.along][shown], held, units);
    let nearest = || {
        let anywhere = [f64::NEG_INFINITY, f64::INFINITY];
        out_of_view(curve, [anywhere, held], units, |_, limited| {
            let side = if limited < held[0] { "below" } else { "above" };
            format!("{side} the {held_words} of")
        })
    };
    let nearest = (shown == 0).then(nearest).flatten();
    nearest.unwrap_or_else(|| format!("{}: none at {held_words}", curve.name))
}

/// A note on the point of a curve nearest to a map: in the limited quantity, or in the other one
/// where the curve ends outside the map. `ranges` are of both quantities; `side` gives, for one of
/// them (0 or 1) and its value, on which side the point is.
fn out_of_view(
    curve: &Curve,
    ranges: [[f64; 2]; 2],
    units: Units,
    side: impl Fn(usize, f64) -> String,
) -> Option<String> {
    let margins = |point: &[f64; 2]| [0, 1].map(|of| margin(point[of], ranges[of]));
    let points = curve.pieces.iter().flatten();
    let nearest = points.min_by(|one, other| {
        let [one, other] = [one, other].map(|point| margins(point));
        (one[1].total_cmp(&other[1])).then(one[0].total_cmp(&other[0]))
    })?;
    let of = usize::from(margins(nearest)[1] > 0.0);
    let axes = [curve.along, curve.limited];
    let [along, at] = [0, 1].map(|of| quantity(axes[of], nearest[of], units));
    let margin = quantity(axes[of], margins(nearest)[of], units);
    let limit = format!("{at} at {along}");
    Some(unseen(curve, &limit, &side(of, nearest[of]), &margin))
}

/// A limit that is on a `side` of the map, by a margin.
fn unseen(curve: &Curve, limit: &str, side: &str, margin: &str) -> String {
    let name = &curve.name;
    // Eq. 74, the one line that methods differ in, is an estimate.
    let what = if curve.method.is_some() { "" } else { "limit " };
    format!("{name}: {what}{limit}, {side} this map; margin {margin}")
}

/// The points of a piece. A single one, of a map over one value or of a branch that is the
/// least only there, becomes a line that can be seen: along all of an axis without other
/// values, whose `range` has no length.
fn with_length(piece: &[[f64; 2]], [low, high]: [f64; 2], spacing: Spacing) -> Vec<[f64; 2]> {
    let Some(&[along, limited]) = piece.first() else {
        return Vec::new();
    };
    if piece.iter().any(|point| *point != piece[0]) {
        return piece.to_vec();
    }
    let ends = match spacing {
        _ if low >= high => around(&[along], spacing),
        Spacing::Linear => [-REACH, REACH]
            .map(|reach| along + reach * (high - low))
            .to_vec(),
        Spacing::Log => [-REACH, REACH]
            .map(|reach| along * (high / low).powf(reach))
            .to_vec(),
    };
    ends.into_iter().map(|along| [along, limited]).collect()
}

/// From the least to the greatest of several ranges.
fn span(ranges: &[[f64; 2]]) -> Option<[f64; 2]> {
    let ranges = ranges.iter().copied();
    ranges.reduce(|one, other| [one[0].min(other[0]), one[1].max(other[1])])
}

/// How far a value is from a range.
fn margin(value: f64, [low, high]: [f64; 2]) -> f64 {
    (low - value).max(value - high).max(0.0)
}

/// On which side of a map a value is, along the axis at a place.
fn side(place: usize, value: f64, [low, _]: [f64; 2]) -> &'static str {
    match (place, value < low) {
        (0, true) => "left of",
        (0, false) => "right of",
        (_, true) => "below",
        (_, false) => "above",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whirl(pieces: &[&[[f64; 2]]]) -> Curve {
        Curve {
            name: "bound".to_owned(),
            method: None,
            motion: Motion::Lateral,
            along: Axis::SurfaceSpeedRpm,
            limited: Axis::FRICTION,
            pieces: pieces.iter().map(|piece| piece.to_vec()).collect(),
            is_least: true,
        }
    }

    fn view(x: (Axis, [f64; 2]), y: (Axis, [f64; 2])) -> Extent {
        let mut extent = Extent::example([&x.1, &y.1], 1);
        extent.axes = [x.0, y.0];
        extent
    }

    const IMPULSE: (Axis, [f64; 2]) = (Axis::ImpulseRatio, [1.0, 5.0]);
    const FRICTION: (Axis, [f64; 2]) = (Axis::FRICTION, [0.5, 3.0]);
    const SPEED: (Axis, [f64; 2]) = (Axis::SurfaceSpeedRpm, [0.0, 100.0]);

    fn slope() -> Curve {
        whirl(&[&[[0.0, 1.0], [100.0, 2.0]]])
    }

    #[test]
    fn what_differs_from_case_to_case_makes_a_range_and_one_value_a_line() {
        let map = view(IMPULSE, FRICTION);
        let curve = slope();
        let all = Limits::of(&[&curve], &map, |_| [20.0, 60.0]);
        assert_eq!((all.lines.len(), all.bands.len()), (0, 1));
        let [x, [low, high]] = all.bands[0].ends;
        assert!((low - 1.2).abs() < 1e-6 && (high - 1.6).abs() < 1e-6);
        assert_eq!(x, [1.0, 5.0]);
        let one = Limits::of(&[&curve], &map, |_| [50.0; 2]);
        assert_eq!((one.lines.len(), one.bands.len()), (1, 0));
        assert!((one.lines[0].points[0].1 - 1.5).abs() < 1e-6);
        assert!(all.notes.is_empty() && one.notes.is_empty());
    }

    #[test]
    fn a_limit_is_a_line_over_its_own_axes_with_its_gaps() {
        let curve = whirl(&[&[[0.0, 1.0], [40.0, 1.5]], &[[60.0, 1.0], [100.0, 1.5]]]);
        let limits = Limits::of(&[&curve], &view(FRICTION, SPEED), |_| [0.0; 2]);
        let points = &limits.lines[0].points;
        assert_eq!((points[0], points[4]), ((1.0, 0.0), (1.5, 100.0)));
        assert!(points[2].0.is_nan() && points.len() == 5);
    }

    #[test]
    fn a_limit_out_of_view_is_noted_with_its_margin() {
        let friction = |range| (Axis::FRICTION, range);
        for (map, held, note) in [
            (
                view(SPEED, friction([2.5, 3.0])),
                [0.0; 2],
                "bound: limit 2 at 100 rpm, below this map; margin 0.5",
            ),
            (
                view(friction([0.1, 0.5]), IMPULSE),
                [50.0; 2],
                "bound: limit 1.5 at 50 rpm, right of this map; margin 1",
            ),
            (
                view(SPEED, IMPULSE),
                [0.4, 0.7],
                "bound: limit 1 at 0 rpm, above the 0.4 to 0.7 of this map; margin 0.3",
            ),
            (
                view(
                    (Axis::SurfaceSpeedRpm, [120.0, 130.0]),
                    friction([0.5, 3.0]),
                ),
                [0.0; 2],
                "bound: limit 2 at 100 rpm, left of this map; margin 20 rpm",
            ),
        ] {
            let limits = Limits::of(&[&slope()], &map, |_| held);
            assert!(limits.lines.is_empty());
            assert_eq!(limits.notes, [note]);
        }
    }

    #[test]
    fn a_limit_out_of_view_is_noted_in_field_units() {
        let curve = Curve {
            name: "Eq. 74".to_owned(),
            method: Some("held".to_owned()),
            motion: Motion::Torsion,
            along: Axis::WeightOnBitKn,
            limited: Axis::SurfaceSpeedRpm,
            pieces: vec![vec![[50.0, 30.0], [200.0, 120.0]]],
            is_least: true,
        };
        let weight = (Axis::WeightOnBitKn, [50.0, 200.0]);
        let mut map = view(weight, (Axis::SurfaceSpeedRpm, [150.0, 180.0]));
        map.units = Units::Field;
        let limits = Limits::of(&[&curve], &map, |_| [0.0; 2]);
        let note = "Eq. 74: 120 rpm at 45 klbf, below this map; margin 30 rpm";
        assert_eq!(limits.notes, [note]);
    }

    #[test]
    fn a_limit_at_the_one_speed_of_a_map_is_drawn_across_its_room() {
        let speed = (Axis::SurfaceSpeedRpm, [60.0; 2]);
        let points = [[60.0, 1.5]; 3];
        for piece in [&points[..1], &points] {
            let curve = whirl(&[&[[60.0, 9.0]], piece]);
            let limits = Limits::of(&[&curve], &view(FRICTION, speed), |_| [0.0; 2]);
            assert_eq!(limits.notes, [""; 0]);
            assert_eq!(limits.lines[0].points[3..], [(1.5, 57.0), (1.5, 63.0)]);
        }
        // Among others, a short one; and none where it is outside.
        let curve = whirl(&[&[[60.0, 1.5]]]);
        let limits = Limits::of(&[&curve], &view(FRICTION, SPEED), |_| [0.0; 2]);
        assert_eq!(limits.lines[0].points, [(1.5, 59.0), (1.5, 61.0)]);
        let slower = (Axis::SurfaceSpeedRpm, [10.0, 59.5]);
        let limits = Limits::of(&[&curve], &view(FRICTION, slower), |_| [0.0; 2]);
        let note = "bound: limit 1.5 at 60 rpm, above this map; margin 0.5 rpm";
        assert!(limits.lines.is_empty());
        assert_eq!(limits.notes, [note]);
    }
}
