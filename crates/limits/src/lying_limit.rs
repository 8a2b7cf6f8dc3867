//! Limits of a string that lies in its hole: the weight on bit from which on it does not stay as it
//! lies, the speeds at which rotation meets its swing, and those from which it goes round the hole.
//! Of one that hangs in the middle of its hole, the weight from which on it buckles.

use linear::BuildError;
use linear::bending_modes::BendingModes;
use serde::{Deserialize, Serialize};
use statics::closed_forms::climb;
use statics::{ContactState, LyingString, StaticState};

use crate::axes::{position, range_of_axis};
use crate::torsion_limit::MOTOR_STALLS;
use campaign::plan::{Conditions, LateralSettings, Setting, Sweep};
use campaign::quantities::Axis;
use campaign::records::to_rpm;

/// Points of a line between the ends of an axis.
const POINTS: usize = 40;

/// Swings of a string whose speeds are limits, from the slowest on.
const SWINGS: usize = 3;

/// A weight on bit, N, up to which one is looked for under which the string does not stay as it lies.
const MOST_WEIGHT: f64 = 5e6;

/// What is limited, and whether that is necessary or sufficient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum LyingLimit {
    /// From this weight on bit on the string snakes or buckles, at rest and without friction:
    /// necessary and sufficient; in a hole that turns its moment runs away or it jumps. One that hangs buckles wherever its hole is.
    Buckling,
    /// Once a turn meets a small swing about the steady climb: necessary for unbalance to make a
    /// string that slides snake much.
    Swing,
    /// From this speed on every part of the string, by itself, goes all round once it rolls at the
    /// low side, slipping on its way up: necessary for all of it to go round so.
    GoesRound,
    /// From this speed on every part, by itself, rolls all round without slip: sufficient for all
    /// of it to roll on once it does.
    RollsAllRound,
    /// From this weight on bit on the mud motor above the bit stalls.
    MotorStall,
}

impl LyingLimit {
    /// As it is called in tables.
    pub fn name(self) -> &'static str {
        match self {
            LyingLimit::Buckling => "buckling",
            LyingLimit::Swing => "swing",
            LyingLimit::GoesRound => "goes_round",
            LyingLimit::RollsAllRound => "rolls_all_round",
            LyingLimit::MotorStall => "motor_stall",
        }
    }

    /// As it is called in legends.
    pub(crate) fn words(self) -> &'static str {
        match self {
            LyingLimit::Buckling => "snakes or buckles from this weight on (without friction)",
            LyingLimit::Swing => "once a turn meets a swing of the string that slides",
            LyingLimit::GoesRound => "once it rolls, every part by itself gets round (necessary)",
            LyingLimit::RollsAllRound => {
                "once it rolls, every part by itself does so all round (sufficient)"
            }
            LyingLimit::MotorStall => MOTOR_STALLS,
        }
    }
}

/// A point of a limit of a string that lies in its hole.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LyingPoint {
    /// Whose point it is.
    pub limit: LyingLimit,
    /// The number of the swing, from 0 for the slowest; of others nothing.
    pub swing: Option<usize>,
    /// The coefficient of friction at all sites; where it plays no part, or differs, nothing.
    pub friction: Option<f64>,
    /// kN; where it is not known, nothing.
    pub weight_on_bit_kn: Option<f64>,
    /// rpm; where it plays no part, nothing.
    pub surface_speed_rpm: Option<f64>,
}

impl LyingPoint {
    /// Its value of an axis, where it has one.
    pub(crate) fn of(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm,
            Axis::FRICTION => self.friction,
            _ => None,
        }
    }
}

/// The limits over the axes of a design: of speeds along friction, or else along the weight on bit;
/// without points where other axes give each case its own, or the string has none.
pub(crate) fn lying_points(sweep: &Sweep) -> Vec<LyingPoint> {
    let axes = sweep.design.axes();
    let has_one = |axis: &Axis| {
        let decides = [Axis::FRICTION, Axis::WeightOnBitKn, Axis::SurfaceSpeedRpm].contains(axis);
        decides || !(axis.changes_whirl_limit() || sweep.changes_string(*axis))
    };
    if !axes.iter().all(has_one) {
        return Vec::new();
    }
    let place = |wanted: Axis| position(sweep, |axis| axis == wanted);
    let mut points = match place(Axis::WeightOnBitKn) {
        Some(_) => buckling_points(sweep),
        None => Vec::new(),
    };
    let along = place(Axis::FRICTION).or(place(Axis::WeightOnBitKn));
    if place(Axis::SurfaceSpeedRpm).is_some() {
        let values = along.map_or(vec![f64::NAN], |place| {
            let [from, to] = range_of_axis(sweep, place);
            let value = |step: usize| from + (to - from) * step as f64 / POINTS as f64;
            (0..=POINTS).map(value).collect()
        });
        let axis = along.map(|place| axes[place]);
        let mut rounds = Rounds::default();
        for value in values {
            points.extend(speeds_at(sweep, axis, value, &mut rounds));
        }
    }
    points.sort_by_key(|point| (point.limit, point.swing));
    points
}

/// The weight from which on the string does not stay as it lies, at both ends of the axes of friction
/// and speed.
fn buckling_points(sweep: &Sweep) -> Vec<LyingPoint> {
    let Some(weight) = buckling_weight(sweep) else {
        return Vec::new();
    };
    let range = |wanted: Axis| {
        let place = position(sweep, |axis| axis == wanted)?;
        Some(range_of_axis(sweep, place))
    };
    let [friction, speed] = [Axis::FRICTION, Axis::SurfaceSpeedRpm].map(range);
    let point = |end: usize| LyingPoint {
        limit: LyingLimit::Buckling,
        swing: None,
        friction: friction.map(|range| range[end]),
        weight_on_bit_kn: Some(1e-3 * weight),
        surface_speed_rpm: speed.map(|range| range[end]),
    };
    vec![point(0), point(1)]
}

/// N; none where there is no such weight, or none is found.
fn buckling_weight(sweep: &Sweep) -> Option<f64> {
    let setting = &sweep.setting;
    if let Some(lying) = setting.resting_string(&sweep.conditions, None) {
        return lying.ok()?.snaking_weight(MOST_WEIGHT).ok().flatten();
    }
    let (hanging, lateral) = (setting.hanging.as_ref()?, setting.lateral.as_ref()?);
    hanging.buckling_weight(&setting.string, lateral).ok()?
}

/// The speeds that are limits at a value of an axis; none where no steady state is found there.
fn speeds_at(
    sweep: &Sweep,
    axis: Option<Axis>,
    value: f64,
    rounds: &mut Rounds,
) -> Vec<LyingPoint> {
    let conditions = match axis {
        Some(axis) => sweep.conditions.with(axis, value),
        None => sweep.conditions.clone(),
    };
    let setting = sweep.setting_with(axis.map(|axis| (axis, value)).into_iter());
    let speeds = setting.ok().and_then(|it| speeds(&it, &conditions, rounds));
    let speeds = speeds.unwrap_or_default().into_iter();
    let friction = sweep.setting.sliding_frictions(&conditions);
    let friction = friction.and_then(|it| same(&it));
    let point = |(limit, swing, speed)| LyingPoint {
        limit,
        swing,
        friction,
        weight_on_bit_kn: conditions.weight_on_bit_kn,
        surface_speed_rpm: Some(to_rpm(speed)),
    };
    speeds.map(point).collect()
}

/// The ratios λ of the limits of rolling at the last friction that was asked for: along the weight on bit
/// it is always the same.
#[derive(Default)]
struct Rounds(Option<(f64, [(LyingLimit, f64); 2])>);

impl Rounds {
    fn at(&mut self, friction: f64) -> [(LyingLimit, f64); 2] {
        match self.0 {
            Some((last, ratios)) if last == friction => ratios,
            _ => {
                let goes_round = climb::goes_round_once_rolling(friction);
                let ratios = [
                    (LyingLimit::GoesRound, goes_round),
                    (LyingLimit::RollsAllRound, climb::rolls_all_round(friction)),
                ];
                self.0 = Some((friction, ratios));
                ratios
            }
        }
    }
}

/// A limit, the number of its swing, and its speed, rad/s.
type Speed = (LyingLimit, Option<usize>, f64);

/// Frequencies of the small swings about its steady climb of a string that lies, up to a highest (rad/s),
/// from the slowest on, where some quantities have other values than those of the file; none where it does
/// not lie, or no steady state is found.
pub fn swing_frequencies(sweep: &Sweep, values: &[(Axis, f64)], highest: f64) -> Option<Vec<f64>> {
    let setting = sweep.setting_with(values.iter().copied()).ok()?;
    let conditions = values
        .iter()
        .fold(sweep.conditions.clone(), |conditions, (axis, value)| {
            conditions.with(*axis, *value)
        });
    let climb = SteadyClimb::new(&setting, &conditions)?;
    let frequencies = (0..climb.modes.below(highest * highest))
        .filter_map(|number| climb.modes.frequency(number))
        // The first modes of a string that buckles do not swing.
        .filter(|frequency| *frequency > 0.0);
    Some(frequencies.collect())
}

/// A string that slides steadily on the low side of its hole.
struct SteadyClimb {
    lying: LyingString,
    frictions: Vec<f64>,
    modes: BendingModes,
}

impl SteadyClimb {
    fn new(setting: &Setting, conditions: &Conditions) -> Option<Self> {
        let lateral = setting.lateral.as_ref()?;
        let lying = setting.lying_string(conditions, None)?.ok()?;
        let frictions = setting.sliding_frictions(conditions)?;
        let sliding = lying.sliding_with(&frictions).ok()?;
        let modes = swinging(setting, lateral, &sliding, &frictions).ok()?;
        Some(Self {
            lying,
            frictions,
            modes,
        })
    }
}

/// Limits of speed of a string under the conditions of a case.
fn speeds(setting: &Setting, conditions: &Conditions, rounds: &mut Rounds) -> Option<Vec<Speed>> {
    let SteadyClimb {
        lying,
        frictions,
        modes,
    } = SteadyClimb::new(setting, conditions)?;
    let mut speeds: Vec<Speed> = (0..SWINGS)
        .filter_map(|number| Some((LyingLimit::Swing, Some(number), modes.frequency(number)?)))
        .collect();
    let Some(friction) = same(&frictions).filter(|friction| *friction > 0.0) else {
        return Some(speeds);
    };
    let at_rest = lying.at_rest().ok()?;
    // What presses the string as a whole to its wall, by its mass.
    let up = |it: &ContactState| {
        let ([x, y], (sin, cos)) = (it.force, it.high_side.sin_cos());
        x * cos + y * sin
    };
    let pressed: f64 = at_rest.contacts().iter().map(up).sum();
    let acceleration = pressed / modes.mass();
    for (limit, ratio) in rounds.at(friction) {
        let touching = at_rest.contacts().iter().filter(|it| it.touches);
        let of_part = touching.map(|it| {
            let [x, y] = it.displacement;
            climb::rotation_speed(ratio, x.hypot(y), it.contact.radius, acceleration)
        });
        speeds.push((limit, None, of_part.fold(0.0, f64::max)));
    }
    Some(speeds)
}

/// What swings about where a string slides: at each site that touches, a spring N (1 + μ²)/r along
/// the wall, N being what it presses with there and r how far out it is.
fn swinging(
    setting: &Setting,
    lateral: &LateralSettings,
    sliding: &StaticState,
    frictions: &[f64],
) -> Result<BendingModes, BuildError> {
    let springs = sliding.contacts().iter().zip(frictions);
    let spring = springs.map(|(it, friction)| {
        let [x, y] = it.displacement;
        match it.touches {
            true => it.normal() * (1.0 + friction * friction) / x.hypot(y),
            false => 0.0,
        }
    });
    let sites = setting.sites.clone().held_by(spring.collect())?;
    let (string, bending) = (&setting.string, &lateral.bending);
    if sliding.top() < string.length() {
        return BendingModes::of_lower_part(string, bending, sliding.top(), &sites);
    }
    BendingModes::held(string, bending, lateral.support, &sites)
}

/// What all are; none where they differ.
fn same(values: &[f64]) -> Option<f64> {
    let [first, others @ ..] = values else {
        return None;
    };
    others.iter().all(|it| it == first).then_some(*first)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::path::Path;

    use linear::well::GRAVITY;
    use statics::closed_forms::LyingPipe;

    use super::*;

    const LENGTH: f64 = 60.0;
    const INNER: f64 = 0.0357;
    const OUTER: f64 = 0.1016;
    const HOLE: f64 = 0.155575;
    const STIFFNESS: f64 = 1e9;
    const SITES: usize = 9;

    /// A pipe in mud at 60°, on nine sites, over axes, with a bit or without.
    fn sweep(axes: &str, bit: &str) -> Sweep {
        let apart = LENGTH / SITES as f64;
        let site = |number: usize| {
            let distance = (number as f64 + 0.5) * apart;
            format!("[[sites]]\ndistance_from_bit_m = {distance}\n")
        };
        let text = format!(
            "methods = [\"finite-element\"]\ntime_s = 1\nsampling_frequency_hz = 400\n\
             [string]\nshear_modulus_gpa = 79.3\ndensity_kg_m3 = 7850\n\
             torsional_damping_nms_rad_m = 0.03\n\
             bending = {{ youngs_modulus_gpa = 206, damping_ns_m2 = 200, surface = \"free\" }}\n\
             sections = [{{ repeat = 1, parts = [{{ length_m = {LENGTH}, inner_radius_m = {INNER}, \
             outer_radius_m = {OUTER} }}] }}]\n\
             [mud]\ndensity_kg_m3 = 1200\n\
             [well]\nhole_radius_m = {HOLE}\ninclination_deg = 60\n\
             [axial_force]\ntolerance = 0.0001\n\
             [wall]\nclearance = \"hole\"\nstiffness_gn_m15 = 1\nfriction = 0.3\n{}{bit}\
             [design]\nkind = \"grid\"\n[design.axes]\n{axes}\n",
            (0..SITES).map(site).collect::<String>()
        );
        Sweep::read_from(Path::new("sweep.toml"), &[], &|_, _| Ok(text.clone())).unwrap()
    }

    /// Each metre of it, without the axial force, which is small here.
    fn pipe() -> LyingPipe {
        let steel = PI * (OUTER * OUTER - INNER * INNER);
        let [inner, outer, hole] = [INNER, OUTER, HOLE].map(|radius| radius * radius);
        let mud = PI * 1200.0 * (inner + outer * (hole + outer) / (hole - outer));
        let load = steel * (7850.0 - 1200.0) * GRAVITY * 60f64.to_radians().sin();
        // A rigid row would press each site with this.
        let each = load * LENGTH / SITES as f64;
        LyingPipe {
            mass: 7850.0 * steel + mud,
            load,
            rigidity: 206e9 * PI / 4.0 * (OUTER.powi(4) - INNER.powi(4)),
            compression: 0.0,
            clearance: HOLE - OUTER + (each / STIFFNESS).powf(2.0 / 3.0),
            radius: OUTER,
            spin_inertia: 0.0,
            torsional_rigidity: 0.0,
        }
    }

    fn speeds_of(points: &[LyingPoint], limit: LyingLimit, swing: Option<usize>) -> Vec<f64> {
        let of_limit = points
            .iter()
            .filter(|it| (it.limit, it.swing) == (limit, swing));
        of_limit.filter_map(|it| it.surface_speed_rpm).collect()
    }

    /// Of a row on many sites, what the closed forms of a pipe on all of its length say.
    #[test]
    fn a_uniform_pipe_has_the_limits_of_the_closed_forms() {
        let axes = "friction = { values = [0.1, 0.6] }\n\
                    surface_speed_rpm = { values = [60, 120] }";
        let points = lying_points(&sweep(axes, ""));
        let pipe = pipe();
        let frictions: Vec<f64> = (points.iter())
            .filter(|it| it.limit == LyingLimit::RollsAllRound)
            .filter_map(|it| it.friction)
            .collect();
        assert_eq!(frictions.len(), POINTS + 1);
        let of_limit = |limit, swing| speeds_of(&points, limit, swing);
        let slowest = of_limit(LyingLimit::Swing, Some(0));
        let next = of_limit(LyingLimit::Swing, Some(1));
        let goes_round = of_limit(LyingLimit::GoesRound, None);
        let rolls = of_limit(LyingLimit::RollsAllRound, None);
        for (place, &friction) in frictions.iter().enumerate() {
            let swing = 60.0 * pipe.sliding(friction);
            assert!((slowest[place] / swing - 1.0).abs() < 0.01, "{friction}");
            assert!(next[place] > slowest[place] && next[place] < 1.1 * swing);
            let speed = |ratio| {
                let acceleration = pipe.load / pipe.mass;
                to_rpm(climb::rotation_speed(
                    ratio,
                    pipe.clearance,
                    pipe.radius,
                    acceleration,
                ))
            };
            let all = [
                (goes_round[place], climb::goes_round_once_rolling(friction)),
                (rolls[place], climb::rolls_all_round(friction)),
            ];
            for (found, ratio) in all {
                assert!((found / speed(ratio) - 1.0).abs() < 1e-3, "{found}");
            }
        }
    }

    /// Just below its limit of weight it stays where it lies, and just above it does not.
    #[test]
    fn a_weight_is_the_limit_of_what_stays_there() {
        let axes = "weight_on_bit_kn = { values = [0, 300] }\n\
                    surface_speed_rpm = { values = [60, 120] }";
        let bit = "[[sites]]\ndistance_from_bit_m = 0\n[bit]\nrock = \"sandstone\"\n";
        let sweep = sweep(axes, bit);
        let points = lying_points(&sweep);
        let of_weight = |limit| points.iter().filter(move |it| it.limit == limit);
        let weights: Vec<f64> = of_weight(LyingLimit::Buckling)
            .filter_map(|it| it.weight_on_bit_kn)
            .collect();
        let speeds = of_weight(LyingLimit::Buckling).filter_map(|it| it.surface_speed_rpm);
        assert_eq!(speeds.collect::<Vec<_>>(), [60.0, 120.0]);
        let lying = sweep
            .setting
            .lying_string(&sweep.conditions, None)
            .unwrap()
            .unwrap();
        for (part, stays) in [(0.999, true), (1.001, false)] {
            let state = lying.under(1e3 * part * weights[0]).at_rest();
            assert_eq!(state.unwrap().is_stable(), stays, "{part}");
        }
        // Weight on bit slows the swing down.
        let swings = of_weight(LyingLimit::Swing).filter(|it| it.swing == Some(0));
        let speeds: Vec<f64> = swings.filter_map(|it| it.surface_speed_rpm).collect();
        assert!(
            speeds.len() > 2 && speeds.is_sorted_by(|one, next| next < one),
            "{speeds:?}"
        );
    }
}
