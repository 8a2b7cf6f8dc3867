//! Torque between bit and rock: stuck up to T_s, sliding against T_d
//! (Sections 2.2.2 and 4.2), met by the load line of Eq. 16.

use super::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, not_negative};

/// The two torque limits of the bit, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BitTorque {
    /// T_s: the most torque a stuck bit holds.
    pub torque_static: f64,
    /// T_d: the torque against a turning bit; at most T_s.
    pub torque_dynamic: f64,
}

/// What the bit was doing in the last step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum BitMotion {
    /// Held by the rock, as at the first instant.
    #[default]
    Stuck,
    /// Turning with the surface (positive) speed.
    Forward,
    /// Turning against it.
    Backward,
}

impl TorqueLaw for BitTorque {
    type State = BitMotion;

    /// Meets the load line `speed = free_speed + compliance · torque` with the
    /// torque law (Eqs. 16 and 18).
    ///
    /// Where load line and law cross more than once, Friedlander's rule keeps
    /// the bit doing what it did: a turning bit turns on while −T_d leaves it
    /// a speed in that direction, a stuck one stays while |T| ≤ T_s.
    #[inline]
    fn meet(&self, before: &BitMotion, line: LoadLine) -> TorqueStep<BitMotion> {
        let turns_on = match before {
            BitMotion::Stuck => None,
            BitMotion::Forward => self.slide(1.0, line),
            BitMotion::Backward => self.slide(-1.0, line),
        };
        turns_on.unwrap_or_else(|| self.hold_or_slip(line))
    }

    fn largest_drop(&self) -> f64 {
        self.torque_static - self.torque_dynamic
    }

    fn check(&self) -> Result<(), SceneError> {
        not_negative("static torque of the bit in N m", self.torque_static)?;
        not_negative("dynamic torque of the bit in N m", self.torque_dynamic)?;
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
    fn slide(&self, direction: f64, line: LoadLine) -> Option<TorqueStep<BitMotion>> {
        let torque = -direction * self.torque_dynamic;
        let speed = line.free_speed + line.compliance * torque;
        (direction * speed > 0.0).then_some(TorqueStep {
            state: if direction > 0.0 {
                BitMotion::Forward
            } else {
                BitMotion::Backward
            },
            torque,
            speed,
        })
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

    #[test]
    fn between_the_limits_the_bit_goes_on_as_it_was() {
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
        };
        let step = free.meet(&BitMotion::Stuck, line(0.3, 1.0));
        assert_eq!((step.state, step.speed), (BitMotion::Forward, 0.3));
    }
}
