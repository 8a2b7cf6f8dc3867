//! How long a case must be simulated for its label to be certain to show.
//!
//! ```
//! use linear::estimates::stick_slip_times;
//! use linear::{Drillstring, Material, Section, Tube};
//! use sim::{BitTorque, Start, torsion_timing};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.02)?;
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.0 };
//! let timing = torsion_timing(&string, 6.0, &bit, &Start::Rest);
//! // A slip of two round trips, and the longest time in sticking.
//! let times = stick_slip_times(&string, 6.0, 1200.0, 1000.0);
//! assert_eq!(timing.closing_window, 2.0 * times.slip + 2.0 * times.stick);
//! assert!(timing.duration > times.first_slip + 3.0 * timing.closing_window);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use linear::Drillstring;
use linear::estimates::{
    drive_settling_time, stick_slip_times, torsional_decay_rate, torsional_inertia,
    torsional_period, torsional_resistance, torsional_stiffness, torsional_travel_time,
};

use crate::laws::bit::BitTorque;
use crate::scene::Timing;
use crate::start::Start;
use crate::watch::rules::Rules;

/// Slips last one round trip where the first reflection recaptures the bit;
/// twice that leaves room for recapture by the second.
const SLIP_ALLOWANCE: f64 = 2.0;

/// A recaptured bit is left with at least T_d − (T_s − T_d), where the string
/// swings to without loss, so that sticking lasts at most twice τ₃.
const STICK_ALLOWANCE: f64 = 2.0;

/// The ringing of the start counts as gone after this number of time constants of the string's
/// vibration: a hundredth of it is left. Until then it may recapture a bit that afterwards keeps
/// turning.
const START_DECAYS: f64 = 5.0;

/// The most round trips of a wave to wait for that.
const MOST_ROUND_TRIPS: f64 = 40.0;

/// The timing by which a case has slipped, has been recaptured
/// [`Rules::repeated`] times if it ever is that often, and has left the transient of
/// its start behind (Eqs. 72–73).
///
/// The string winds up for τ₁, behind the surface by the travel time of a wave
/// and by what distributed damping takes of the torque on the way, which is
/// below a quarter of the torque that turns the whole string, c_t L / 4 per unit of surface speed. A top drive has to reach its speed first, and
/// a slip below one lasts up to half a period of string and drive together. A surface at rest winds up nothing: the
/// time is infinite, and no scene that lasts so long is simulated. A case that begins with a
/// steady motion does not wait for its first slip.
pub fn torsion_timing(
    string: &Drillstring,
    surface_speed: f64,
    bit: &BitTorque,
    start: &Start,
) -> Timing {
    let times = stick_slip_times(string, surface_speed, bit.torque_static, bit.torque_dynamic);
    let damping_lag = torsional_resistance(string) / (4.0 * torsional_stiffness(string));
    let lag = damping_lag + drive_settling_time(string);
    let first_slip = match start {
        Start::Rest => torsional_travel_time(string) + lag + times.first_slip,
        Start::Steady(_) => 0.0,
    };
    let swing = (string.top_drive()).map_or(0.0, |_| 0.5 * torsional_period(string));
    let slip = (SLIP_ALLOWANCE * times.slip).max(swing);
    let cycle = slip + STICK_ALLOWANCE * times.stick;
    let cycles = Rules::USUAL.repeated as f64 * cycle;
    // What nothing damps never leaves its start behind.
    let decays = START_DECAYS / torsional_decay_rate(string);
    let start = decays.min(MOST_ROUND_TRIPS * times.slip);
    Timing {
        duration: first_slip + cycles.max(start + cycle),
        closing_window: cycle,
    }
}

/// A drive that has hardly more torque than it takes to turn the bit, or hardly less, is waited for
/// as if this part of its greatest were left.
const LEAST_LEFT: f64 = 0.05;

impl Timing {
    /// The same below a drive whose torque is limited (N m). With what it has left it brings string
    /// and drive up to their speed, or fails to keep them there; after each time that the bit stuck
    /// it may have to again.
    #[must_use]
    pub fn below_limited(
        self,
        string: &Drillstring,
        surface_speed: f64,
        bit: Option<&BitTorque>,
        limit: f64,
    ) -> Self {
        let drive = string.top_drive().map_or(0.0, |drive| drive.inertia);
        let momentum = (drive + torsional_inertia(string)) * surface_speed.abs();
        let against = bit.map_or(0.0, |bit| bit.torque_dynamic)
            + torsional_resistance(string) * surface_speed.abs();
        let left = (limit - against).abs().max(LEAST_LEFT * limit);
        let accelerates = momentum / left;
        Self {
            duration: self.duration + Rules::USUAL.repeated as f64 * accelerates,
            closing_window: self.closing_window + accelerates,
        }
    }
}
