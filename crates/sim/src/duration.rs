//! How long a case must be simulated for its label to be certain to show.

use linear::Drillstring;
use linear::estimates::{stick_slip_times, torsional_stiffness, torsional_travel_time};

use crate::laws::bit::BitTorque;
use crate::regime::REPEATED;

/// Slips last one round trip where the first reflection recaptures the bit;
/// twice that leaves room for recapture by the second.
const SLIP_ALLOWANCE: f64 = 2.0;

/// A recaptured bit is left with at least T_d − (T_s − T_d), where the string
/// swings to without loss, so that sticking lasts at most twice τ₃.
const STICK_ALLOWANCE: f64 = 2.0;

/// Time (s) after which a case from rest has slipped, and has been recaptured
/// [`REPEATED`] times if it ever is that often (Eqs. 72–73).
///
/// The string winds up for τ₁, behind the surface by the travel time of a wave
/// and by what distributed damping takes of the torque on the way, which is
/// below c_t L / 4 per unit of surface speed.
pub fn time_to_label(string: &Drillstring, surface_speed: f64, bit: &BitTorque) -> f64 {
    let times = stick_slip_times(string, surface_speed, bit.torque_static, bit.torque_dynamic);
    let damping_lag =
        string.torsional_damping() * string.length() / (4.0 * torsional_stiffness(string));
    let cycle = SLIP_ALLOWANCE * times.slip + STICK_ALLOWANCE * times.stick;
    torsional_travel_time(string) + damping_lag + times.first_slip + REPEATED as f64 * cycle
}
