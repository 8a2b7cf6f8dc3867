//! Friction of a piece of pipe that lies against the borehole: stuck up to F_s; turning against
//! F_s below a speed and against F_d above it (U. J. F. Aarsnes and R. J. Shor, "Torsional
//! vibrations with bit off bottom: modeling, identification and field data validation",
//! *Journal of Petroleum Science and Engineering*, 2018), met by the load line as at
//! the bit (Eq. 16).

use super::bit::BitMotion;
use super::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, not_negative};

/// The friction of a piece, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PipeFriction {
    /// F_s: the most that a stuck piece holds, and what it turns against while it is slow.
    pub torque_static: f64,
    /// F_d: what it turns against while it is fast; at most F_s.
    pub torque_dynamic: f64,
    /// Up to this speed it is slow, rad/s; zero where friction falls with the first slip.
    pub static_up_to: f64,
}

/// What a piece was doing in the last step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct PipeMotion {
    /// Whether it turned.
    pub motion: BitMotion,
    /// Whether it was fast.
    pub is_fast: bool,
}

impl TorqueLaw for PipeFriction {
    type State = PipeMotion;

    /// Where load line and law meet more than once the piece keeps doing what it did
    /// (Friedlander's rule): stuck or slow while it can, and fast while it can.
    #[inline]
    fn meet(&self, before: &PipeMotion, line: LoadLine) -> TorqueStep<PipeMotion> {
        let goes_on = match before.motion {
            BitMotion::Forward if before.is_fast => self.fast(1.0, line),
            BitMotion::Backward if before.is_fast => self.fast(-1.0, line),
            _ => None,
        };
        goes_on.unwrap_or_else(|| self.hold_or_slip(line))
    }

    fn largest_drop(&self) -> f64 {
        self.torque_static - self.torque_dynamic
    }

    fn check(&self) -> Result<(), SceneError> {
        not_negative("static friction of a piece in N m", self.torque_static)?;
        not_negative("dynamic friction of a piece in N m", self.torque_dynamic)?;
        not_negative("speed of static friction in rad/s", self.static_up_to)?;
        if self.torque_static < self.torque_dynamic {
            return Err(SceneError::Torques {
                torque_static: self.torque_static,
                torque_dynamic: self.torque_dynamic,
            });
        }
        Ok(())
    }
}

impl PipeFriction {
    fn fast(&self, direction: f64, line: LoadLine) -> Option<TorqueStep<PipeMotion>> {
        let step = slide(direction, self.torque_dynamic, true, line);
        (direction * step.speed > self.static_up_to).then_some(step)
    }

    fn hold_or_slip(&self, line: LoadLine) -> TorqueStep<PipeMotion> {
        let torque = -line.free_speed / line.compliance;
        if torque.abs() <= self.torque_static {
            return TorqueStep {
                torque,
                speed: 0.0,
                state: PipeMotion::default(),
            };
        }
        let direction = line.free_speed.signum();
        let slow = slide(direction, self.torque_static, false, line);
        if direction * slow.speed <= self.static_up_to {
            return slow;
        }
        // What is fast against F_s is faster against F_d.
        self.fast(direction, line).unwrap_or(slow)
    }
}

fn slide(direction: f64, against: f64, is_fast: bool, line: LoadLine) -> TorqueStep<PipeMotion> {
    let torque = -direction * against;
    TorqueStep {
        torque,
        speed: line.free_speed + line.compliance * torque,
        state: PipeMotion {
            motion: if direction > 0.0 {
                BitMotion::Forward
            } else {
                BitMotion::Backward
            },
            is_fast,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LAW: PipeFriction = PipeFriction {
        torque_static: 2.0,
        torque_dynamic: 1.0,
        static_up_to: 0.5,
    };

    fn line(free_speed: f64, compliance: f64) -> LoadLine {
        LoadLine {
            time: 0.0,
            free_speed,
            compliance,
        }
    }

    fn states() -> impl Strategy<Value = PipeMotion> {
        prop_oneof![
            Just((BitMotion::Stuck, false)),
            Just((BitMotion::Forward, false)),
            Just((BitMotion::Forward, true)),
            Just((BitMotion::Backward, false)),
            Just((BitMotion::Backward, true)),
        ]
        .prop_map(|(motion, is_fast)| PipeMotion { motion, is_fast })
    }

    proptest! {
        #[test]
        fn load_line_and_law_hold_together(
            free_speed in -10.0..10.0f64,
            compliance in 1e-3..1e3f64,
            static_up_to in prop_oneof![Just(0.0), 0.0..5.0f64],
            before in states(),
        ) {
            let law = PipeFriction { static_up_to, ..LAW };
            let step = law.meet(&before, line(free_speed, compliance));
            let on_line = free_speed + compliance * step.torque;
            let rounding = 1e-12 * (free_speed.abs() + compliance);
            prop_assert!((step.speed - on_line).abs() <= rounding);
            let direction = match step.state.motion {
                BitMotion::Stuck => {
                    prop_assert_eq!(step.speed, 0.0);
                    prop_assert!(step.torque.abs() <= LAW.torque_static);
                    return Ok(());
                }
                BitMotion::Forward => 1.0,
                BitMotion::Backward => -1.0,
            };
            prop_assert!(direction * step.speed >= 0.0);
            if step.state.is_fast {
                prop_assert!(direction * step.speed > static_up_to);
                prop_assert_eq!(step.torque, -direction * LAW.torque_dynamic);
            } else {
                prop_assert!(direction * step.speed <= static_up_to);
                prop_assert_eq!(step.torque, -direction * LAW.torque_static);
            }
        }
    }

    #[test]
    fn a_piece_keeps_doing_what_it_did() {
        // Slow at 0.3 against F_s, or fast at 1.3 against F_d.
        let both = line(2.3, 1.0);
        let speed = |motion, is_fast| LAW.meet(&PipeMotion { motion, is_fast }, both).speed;
        assert!((speed(BitMotion::Forward, true) - 1.3).abs() < 1e-15);
        assert!((speed(BitMotion::Forward, false) - 0.3).abs() < 1e-15);
        assert!((speed(BitMotion::Stuck, false) - 0.3).abs() < 1e-15);
        // Faster than slow can be.
        let step = LAW.meet(&PipeMotion::default(), line(2.6, 1.0));
        assert!(step.state.is_fast && (step.speed - 1.6).abs() < 1e-15);
    }
}
