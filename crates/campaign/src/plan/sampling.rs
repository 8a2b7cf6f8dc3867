//! The sampling frequency of a sweep: as its file gives it, or by a rule that looks at waves.
//!
//! The rule counts steps per travel time of a wave from the surface to the bit. They are counted
//! once, on the string of the file, and hold for every string that axes make of it: each has that
//! number of steps in its own travel time.

use linear::Drillstring;
use linear::estimates::torsional_travel_time;
use linear::sampling::{self, FEWEST_STEPS, Steps, frequency_for_growth};

use sim::MudMotor;

use super::bit::Cut;
use super::impulses::ImpulseSettings;
use super::lateral::LateralSettings;
use super::string_friction::StringFriction;
use crate::sweep_file::{AutoOr, FileContent, Source, SweepFileError};

/// The samples of a raised cosine have its area from two on.
const LEAST_SAMPLES_OF_IMPULSE: f64 = 2.0;

/// By the rule an impulse has this number: it is as smooth as the string makes of it.
const SAMPLES_OF_IMPULSE: f64 = 12.0;

/// With a wall, Hz, at least: the limit of whirl on the paper's string is exact to 0.1 % then, and
/// a turn of backward whirl has dozens of samples.
const WITH_WALL: f64 = 640.0;

/// Steps per travel time with friction all along the string, and per piece of it. That takes from
/// a wave what a front needs to decide: labels do not change at several times as many.
const STEPS_WITH_FRICTION: f64 = 128.0;
const STEPS_OF_PIECE: f64 = 2.0;

/// With blades that cut what they leave, Hz, at least: limits of steady drilling are then right to a
/// few parts in a thousand, and chatter at some tens of hertz has dozens of samples. And steps from one
/// blade to the next, at the speed of the surface.
const WITH_BLADES: f64 = 640.0;
const STEPS_OF_BLADE: f64 = 16.0;

/// A wave that takes fewer steps from the surface to the bit is not followed: at one step in three
/// travel times all methods call the paper's string smooth where it sticks and slips. From here on
/// fronts that are smeared are warned of.
const LEAST_STEPS: f64 = 2.0;

/// What a scene has that needs samples.
pub(super) struct Needs<'a> {
    /// The bit, where a torque acts on it.
    pub cut: Option<Cut<'a>>,
    pub lateral: Option<&'a LateralSettings>,
    pub friction: Option<&'a StringFriction>,
    /// The number of blades of a bit that cuts what they leave.
    pub blades: Option<usize>,
    pub motor: Option<MudMotor>,
}

/// The fastest that a bit turns in any case, but for vibration, rad/s.
pub(super) fn fastest_bit(cut: &Cut, motor: Option<MudMotor>) -> f64 {
    cut.fastest_surface() + motor.map_or(0.0, |motor| motor.speed)
}

/// The sampling frequency of a string, Hz; and its steps per travel time where it follows from
/// them, which may have been `counted`.
///
/// # Errors
/// Where that of the file is out of range.
pub(super) fn resolve(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
    needs: &Needs,
    counted: Option<f64>,
) -> Result<(f64, Option<f64>), SweepFileError> {
    if let AutoOr::Given(value) = content.sampling_frequency_hz {
        let key = "sampling_frequency_hz";
        return Ok((source.within(key, value, 1.0, 1e6, "Hz")?, None));
    }
    let steps = counted.unwrap_or_else(|| steps(string, needs));
    Ok((sampling::frequency(string, steps), Some(steps)))
}

/// The sampling frequency that a string would have by the rule, Hz.
pub(super) fn by_rule(string: &Drillstring, needs: &Needs) -> f64 {
    sampling::frequency(string, steps(string, needs))
}

/// Steps per travel time by the rule.
fn steps(string: &Drillstring, needs: &Needs) -> f64 {
    let of_wall = needs.lateral.map(|lateral| {
        let shortest = lateral.impulses.iter().map(|impulse| impulse.duration);
        let of_impulse = SAMPLES_OF_IMPULSE / shortest.fold(f64::INFINITY, f64::min);
        sampling::steps_at(string, WITH_WALL.max(of_impulse))
    });
    let of_growth = needs.cut.map(|cut| {
        // A string that cannot be cut up is refused where it is built.
        let frequency = frequency_for_growth(string, cut.steepest_fall()).unwrap_or_default();
        sampling::steps_at(string, frequency)
    });
    let of_fronts = match (needs.friction, needs.cut) {
        (Some(friction), _) => {
            Some(STEPS_WITH_FRICTION.max(STEPS_OF_PIECE * friction.pieces() as f64))
        }
        // A string whose lattice does not fit in memory damps its fronts away.
        (None, Some(_)) => {
            Some(Steps::for_fronts(string).map_or(FEWEST_STEPS, |steps| steps.per_travel))
        }
        (None, None) => None,
    };
    let of_blades = needs.blades.zip(needs.cut.as_ref()).map(|(blades, cut)| {
        let passing = blades as f64 * fastest_bit(cut, needs.motor) / std::f64::consts::TAU;
        sampling::steps_at(string, WITH_BLADES.max(STEPS_OF_BLADE * passing))
    });
    let all = [of_wall, of_growth, of_fronts, of_blades]
        .into_iter()
        .flatten();
    all.reduce(f64::max).unwrap_or(FEWEST_STEPS)
}

/// Refuses a frequency at which nothing is felt of an impulse, or of a wave on its way where
/// something `twists` the string.
///
/// # Errors
/// With the key that is to blame.
pub(super) fn check(
    source: &Source,
    (string, lateral): (&Drillstring, Option<&LateralSettings>),
    twists: bool,
    frequency: f64,
) -> Result<(), SweepFileError> {
    let impulses = lateral.iter().flat_map(|lateral| &lateral.impulses);
    for (index, ImpulseSettings { duration, .. }) in impulses.enumerate() {
        let message = format!("{duration} s is shorter than two samples at {frequency} Hz");
        let is_short = duration * frequency < LEAST_SAMPLES_OF_IMPULSE;
        source.refuse_if(is_short, &format!("impulses[{index}].duration_s"), message)?;
    }
    if !twists {
        return Ok(());
    }
    let travel = torsional_travel_time(string);
    let least = LEAST_STEPS / travel;
    let message = format!(
        "{frequency} Hz is too low for this string: a wave takes {travel:.3} s from the surface to \
         the bit, {:.1} steps at this frequency. Write at least {:.0} Hz, or leave the key out: \
         the frequency then follows from the string",
        travel * frequency,
        least.ceil(),
    );
    let is_slow = travel * frequency < LEAST_STEPS * (1.0 - 1e-9);
    source.refuse_if(is_slow, "sampling_frequency_hz", message)
}
