//! Torque between bit and rock: stuck up to T_s, sliding against T_d
//! (Sections 2.2.2 and 4.2), met by the load line of Eq. 16. Between the two the torque may
//! fall with the speed, T_d + (T_s − T_d) e^(−ω/ω_c) (`friction_curve.rs`), instead of at once.
//!
//! ```
//! use sim::laws::torque::BitMotion;
//! use sim::{BitTorque, LoadLine, TorqueLaw};
//!
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.5 };
//! assert_eq!(bit.torque_at(0.0), 1200.0);
//! assert!((bit.torque_at(0.5) - (1000.0 + 200.0 / std::f64::consts::E)).abs() < 1e-9);
//! // The rock holds a stuck bit with just what keeps it where it is, up to T_s.
//! let line = |free_speed: f64| LoadLine { time: 0.0, free_speed, compliance: 0.01 };
//! let held = bit.meet(&BitMotion::Stuck, line(11.9));
//! assert_eq!((held.speed, held.torque.round()), (0.0, -1190.0));
//! let slips = bit.meet(&BitMotion::Stuck, line(12.1));
//! assert_eq!(slips.state, BitMotion::Forward);
//! assert!((slips.torque + bit.torque_at(slips.speed)).abs() < 1e-6);
//! ```

use super::friction_curve::{FrictionCurve, Shape};
pub use super::torque::BitMotion;
use super::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, not_negative};

/// The two torque limits of the bit, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitTorque {
    /// T_s: the most torque a stuck bit holds.
    pub torque_static: f64,
    /// T_d: the torque against a turning bit; at most T_s.
    pub torque_dynamic: f64,
    /// ω_c, rad/s: the speed at which e⁻¹ of what T_s is more than T_d is left; zero where the
    /// torque falls at once.
    pub decay_speed: f64,
}

impl TorqueLaw for BitTorque {
    type State = BitMotion;

    /// Meets the load line `speed = free_speed + compliance · torque` with the
    /// torque law (Eqs. 16 and 18).
    ///
    /// Where load line and law cross more than once, Friedlander's rule keeps
    /// the bit on its branch: a turning bit continues, at the largest common speed in that
    /// direction, while there is one; a stuck one stays while |T| ≤ T_s.
    // Put together where it is kept: what is stored as two numbers and then read as one pair waits.
    #[inline(always)]
    fn meet(&self, before: &BitMotion, line: LoadLine) -> TorqueStep<BitMotion> {
        let still_turning = match before {
            BitMotion::Stuck => None,
            BitMotion::Forward => self.slide(1.0, line),
            BitMotion::Backward => self.slide(-1.0, line),
        };
        still_turning.unwrap_or_else(|| self.hold_or_slip(line))
    }

    fn turning_at(&self, speed: f64) -> BitMotion {
        BitMotion::of(speed)
    }

    fn largest_drop(&self) -> f64 {
        self.torque_static - self.torque_dynamic
    }

    fn holds(&self) -> Option<f64> {
        Some(self.torque_static)
    }

    fn is_constant_in_slip(&self) -> bool {
        self.decay_speed == 0.0
    }

    fn is_autonomous(&self) -> bool {
        true
    }

    fn check(&self) -> Result<(), SceneError> {
        not_negative("static torque of the bit in N m", self.torque_static)?;
        not_negative("dynamic torque of the bit in N m", self.torque_dynamic)?;
        not_negative("decay speed of the bit's torque in rad/s", self.decay_speed)?;
        if self.torque_static < self.torque_dynamic {
            return Err(SceneError::Torques {
                torque_static: self.torque_static,
                torque_dynamic: self.torque_dynamic,
            });
        }
        Ok(())
    }
}

impl BitTorque {
    #[inline]
    fn slide(&self, direction: f64, line: LoadLine) -> Option<TorqueStep<BitMotion>> {
        let against = match self.decay_speed {
            0.0 => self.torque_dynamic,
            _ => {
                let curve = self.curve();
                curve.at(curve.fastest(direction * line.free_speed, line.compliance)?)
            }
        };
        let torque = -direction * against;
        let speed = line.free_speed + line.compliance * torque;
        (direction * speed > 0.0).then_some(TorqueStep {
            state: BitMotion::of(direction),
            torque,
            speed,
        })
    }

    /// Torque against a bit that turns at a speed (rad/s), N m.
    pub fn torque_at(&self, speed: f64) -> f64 {
        self.curve().at(speed)
    }

    /// By how much the torque falls with speed where a bit turns at one (rad/s), N m s/rad.
    pub fn fall_at(&self, speed: f64) -> f64 {
        self.curve().fall(speed)
    }

    /// The speed (rad/s) above which the torque falls less steeply with it than by `slope`,
    /// N m s/rad; none where it does at every speed.
    pub fn speed_of_fall(&self, slope: f64) -> Option<f64> {
        self.curve().speed_of_fall(slope)
    }

    fn curve(&self) -> FrictionCurve {
        FrictionCurve {
            at_rest: self.torque_static,
            when_fast: self.torque_dynamic,
            decay_speed: self.decay_speed,
            shape: Shape::Exponential,
        }
    }

    fn hold_or_slip(&self, line: LoadLine) -> TorqueStep<BitMotion> {
        let torque = -line.free_speed / line.compliance;
        let held = TorqueStep {
            state: BitMotion::Stuck,
            torque,
            speed: 0.0,
        };
        if torque.abs() <= self.torque_static {
            return held;
        }
        // |T| > T_s ≥ T_d: sliding in the direction of the free speed has one.
        self.slide(line.free_speed.signum(), line).unwrap_or(held)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LAW: BitTorque = BitTorque {
        torque_static: 1.2,
        torque_dynamic: 1.0,
        decay_speed: 0.0,
    };

    fn line(free_speed: f64, compliance: f64) -> LoadLine {
        LoadLine {
            time: 0.0,
            free_speed,
            compliance,
        }
    }

    proptest! {
        #[test]
        fn load_line_and_law_hold_together(
            free_speed in -10.0..10.0f64,
            compliance in 1e-3..1e3f64,
            before in prop_oneof![
                Just(BitMotion::Stuck), Just(BitMotion::Forward), Just(BitMotion::Backward)
            ],
        ) {
            let step = LAW.meet(&before, line(free_speed, compliance));
            let speed = free_speed + compliance * step.torque;
            prop_assert!((step.speed - speed).abs() <= 1e-12 * free_speed.abs());
            match step.state {
                BitMotion::Stuck => {
                    prop_assert_eq!(step.speed, 0.0);
                    prop_assert!(step.torque.abs() <= LAW.torque_static);
                }
                BitMotion::Forward => prop_assert!(step.speed > 0.0 && step.torque == -1.0),
                BitMotion::Backward => prop_assert!(step.speed < 0.0 && step.torque == 1.0),
            }
        }
    }

    proptest! {
        /// The law's torque at the speed that is found, on the load line; no faster speed has
        /// both, by a dense scan; and without a speed the scan finds none either.
        #[test]
        fn a_torque_that_falls_with_speed_is_met_where_it_is_fastest(
            free_speed in -10.0..10.0f64,
            compliance in 1e-2..1e2f64,
            decay_speed in 1e-2..1e1f64,
            before in prop_oneof![
                Just(BitMotion::Stuck), Just(BitMotion::Forward), Just(BitMotion::Backward)
            ],
        ) {
            let law = BitTorque { torque_static: 1.8, decay_speed, ..LAW };
            let step = law.meet(&before, line(free_speed, compliance));
            let on_line = free_speed + compliance * step.torque;
            let size = free_speed.abs() + compliance;
            prop_assert!((step.speed - on_line).abs() <= 1e-12 * size);
            let excess = |speed: f64, direction: f64| {
                speed + compliance * law.torque_at(speed) - direction * free_speed
            };
            let from = match step.state {
                BitMotion::Stuck => {
                    prop_assert!(step.torque.abs() <= law.torque_static);
                    0.0
                }
                _ => {
                    prop_assert!((step.torque.abs() - law.torque_at(step.speed.abs())).abs() < 1e-9);
                    step.speed.abs()
                }
            };
            // Who was not turning need not look for a speed.
            let direction = match (step.state, before) {
                (BitMotion::Stuck, BitMotion::Stuck) => return Ok(()),
                (BitMotion::Stuck, BitMotion::Forward) | (BitMotion::Forward, _) => 1.0,
                _ => -1.0,
            };
            for index in 1..2000 {
                let speed = from + 1e-6 * size + 0.01 * f64::from(index) * size;
                prop_assert!(excess(speed, direction) > 0.0, "{speed} beyond {from}");
            }
        }
    }

    #[test]
    fn between_the_limits_the_bit_continues_as_before() {
        // The load line at −1.1 N m meets both branches.
        let free_speed = 1.1;
        assert_eq!(
            LAW.meet(&BitMotion::Stuck, line(free_speed, 1.0)).state,
            BitMotion::Stuck
        );
        assert_eq!(
            LAW.meet(&BitMotion::Forward, line(free_speed, 1.0)).state,
            BitMotion::Forward
        );
    }

    #[test]
    fn a_bit_off_bottom_turns_freely() {
        let free = BitTorque {
            torque_static: 0.0,
            torque_dynamic: 0.0,
            decay_speed: 0.0,
        };
        let step = free.meet(&BitMotion::Stuck, line(0.3, 1.0));
        assert_eq!((step.state, step.speed), (BitMotion::Forward, 0.3));
    }
}
