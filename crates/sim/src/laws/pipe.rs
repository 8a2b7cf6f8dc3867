//! Friction of a piece of pipe that lies against the borehole: stuck up to F_s; turning at ω
//! against F_d + (F_s − F_d) e^(−(ω/ω_s)²) (`friction_curve.rs`), met by the load line as at
//! the bit (Eq. 16). What turns much more slowly than ω_s rubs as what is stuck, so that a string
//! breaks loose as a whole.
//!
//! ```
//! use sim::laws::pipe::PipeMotion;
//! use sim::{LoadLine, PipeFriction, TorqueLaw};
//!
//! let rubbing = PipeFriction { torque_static: 80.0, torque_dynamic: 50.0, stribeck_speed: 0.1 };
//! let line = |free_speed: f64| LoadLine { time: 0.0, free_speed, compliance: 0.001 };
//! let held = rubbing.meet(&PipeMotion::default(), line(0.079));
//! assert_eq!(held.speed, 0.0);
//! // What turns much faster than ω_s does so against F_d.
//! let turning = rubbing.meet(&PipeMotion::default(), line(4.0));
//! assert!((turning.torque + 50.0).abs() < 1e-9 && (turning.speed - 3.95).abs() < 1e-9);
//! ```

use super::friction_curve::{FrictionCurve, Shape};
use super::torque::{BitMotion, LoadLine, TorqueLaw, TorqueStep};
use crate::ranges::{SceneError, not_negative};

/// The friction of a piece, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PipeFriction {
    /// F_s: the most that a stuck piece holds.
    pub torque_static: f64,
    /// F_d: what it turns against when it is fast; at most F_s.
    pub torque_dynamic: f64,
    /// ω_s, rad/s: the Stribeck speed, at which e⁻¹ of what F_s is more than F_d is left; zero
    /// where friction falls with the first slip.
    pub stribeck_speed: f64,
}

/// What a piece was doing in the last step.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PipeMotion {
    /// Whether it turned.
    pub motion: BitMotion,
    /// How fast, rad/s, whichever way.
    pub speed: f64,
}

/// The friction of a piece and load lines of one slope.
#[derive(Debug, Clone, Copy)]
pub struct OnLines {
    curve: FrictionCurve,
    compliance: f64,
    /// Where they may meet more than once, the speeds at which the curve is as steep as the
    /// line: between them no motion lasts.
    folds: Option<(f64, f64)>,
}

impl OnLines {
    /// Where load line and curve meet more than once the piece keeps doing what it did
    /// (Friedlander's rule): stuck or slow while it can, and fast while it can.
    ///
    /// A `guess` of its speed (rad/s, whichever way) saves time, and changes nothing.
    #[inline]
    pub fn meet(&self, before: &PipeMotion, free_speed: f64, guess: f64) -> TorqueStep<PipeMotion> {
        let direction = free_speed.signum();
        let driven = direction * free_speed;
        let was_forward = match before.motion {
            BitMotion::Stuck => None,
            motion => Some(motion == BitMotion::Forward),
        };
        let continues = was_forward == Some(direction > 0.0);
        let fast = (self.folds)
            .filter(|_| continues && self.curve.is_fast(before.speed))
            .and_then(|(_, fold)| self.fast(driven, fold, guess));
        let is_held = driven <= self.compliance * self.curve.at_rest;
        let Some(speed) = fast.or_else(|| (!is_held).then(|| self.slow(driven, guess))) else {
            return TorqueStep {
                torque: -free_speed / self.compliance,
                speed: 0.0,
                state: PipeMotion::default(),
            };
        };
        TorqueStep {
            torque: -direction * self.curve.at(speed),
            speed: direction * speed,
            state: PipeMotion {
                motion: BitMotion::of(direction),
                speed,
            },
        }
    }

    fn excess(&self, speed: f64, driven: f64) -> f64 {
        self.curve.excess(speed, driven, self.compliance).0
    }

    /// How far the torque falls at most where it slips, N m.
    pub fn largest_drop(&self) -> f64 {
        self.curve.drop()
    }

    /// By how much the torque against it falls with its speed, N m per rad/s.
    pub fn fall(&self, speed: f64) -> f64 {
        self.curve.fall(speed)
    }

    fn between(&self, ends: (f64, f64), guess: f64, driven: f64) -> f64 {
        (self.curve).between(ends, guess, driven, self.compliance)
    }

    /// The speed of a piece that is stuck or slow and no longer held.
    fn slow(&self, driven: f64, guess: f64) -> f64 {
        let most = driven - self.compliance * self.curve.when_fast;
        let Some((first, second)) = self.folds else {
            return self.between((0.0, most), guess, driven);
        };
        if self.excess(first, driven) >= 0.0 {
            return self.between((0.0, first), guess, driven);
        }
        self.between((second.min(most), most), guess, driven)
    }

    /// The speed of a piece that is fast, if it can be, beyond the upper fold.
    fn fast(&self, driven: f64, fold: f64, guess: f64) -> Option<f64> {
        let most = driven - self.compliance * self.curve.when_fast;
        if fold >= most || self.excess(fold, driven) > 0.0 {
            return None;
        }
        Some(self.between((fold, most), guess, driven))
    }
}

impl TorqueLaw for PipeFriction {
    type State = PipeMotion;

    fn meet(&self, before: &PipeMotion, line: LoadLine) -> TorqueStep<PipeMotion> {
        self.on_lines(line.compliance)
            .meet(before, line.free_speed, before.speed)
    }

    fn largest_drop(&self) -> f64 {
        self.torque_static - self.torque_dynamic
    }

    fn holds(&self) -> Option<f64> {
        Some(self.torque_static)
    }

    fn is_constant_in_slip(&self) -> bool {
        self.torque_static == self.torque_dynamic || self.stribeck_speed == 0.0
    }

    fn is_autonomous(&self) -> bool {
        true
    }

    fn check(&self) -> Result<(), SceneError> {
        not_negative("static friction of a piece in N m", self.torque_static)?;
        not_negative("dynamic friction of a piece in N m", self.torque_dynamic)?;
        not_negative("Stribeck speed of a piece in rad/s", self.stribeck_speed)?;
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
    /// With load lines of this compliance, rad/s per N m.
    pub fn on_lines(self, compliance: f64) -> OnLines {
        let curve = self.curve();
        OnLines {
            curve,
            compliance,
            folds: curve.folds(compliance),
        }
    }

    fn curve(&self) -> FrictionCurve {
        FrictionCurve {
            at_rest: self.torque_static,
            when_fast: self.torque_dynamic,
            decay_speed: self.stribeck_speed,
            shape: Shape::Gaussian,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LAW: PipeFriction = PipeFriction {
        torque_static: 2.0,
        torque_dynamic: 1.0,
        stribeck_speed: 0.5,
    };

    fn line(free_speed: f64, compliance: f64) -> LoadLine {
        LoadLine {
            time: 0.0,
            free_speed,
            compliance,
        }
    }

    fn moving(speed: f64) -> PipeMotion {
        PipeMotion {
            motion: if speed > 0.0 {
                BitMotion::Forward
            } else {
                BitMotion::Backward
            },
            speed: speed.abs(),
        }
    }

    proptest! {
        /// Both hold together, at a place where the motion lasts: the line is steeper than the
        /// curve.
        #[test]
        fn load_line_and_curve_are_met_where_motion_lasts(
            free_speed in -10.0..10.0f64,
            compliance in 1e-3..1e2f64,
            stribeck_speed in prop_oneof![Just(0.0), 1e-3..5.0f64],
            before in prop_oneof![Just(0.0), -5.0..5.0f64],
        ) {
            let law = PipeFriction { stribeck_speed, ..LAW };
            let state = if before == 0.0 { PipeMotion::default() } else { moving(before) };
            let step = law.meet(&state, line(free_speed, compliance));
            let on_line = free_speed + compliance * step.torque;
            let rounding = 1e-11 * (free_speed.abs() + compliance);
            prop_assert!((step.speed - on_line).abs() <= rounding, "{step:?} {on_line}");
            if step.state.motion == BitMotion::Stuck {
                prop_assert_eq!(step.speed, 0.0);
                prop_assert!(step.torque.abs() <= LAW.torque_static);
            } else {
                prop_assert!(step.speed * free_speed >= 0.0);
                let (speed, driven) = (step.speed.abs(), free_speed.abs());
                let (_, slope) = law.curve().excess(speed, driven, compliance);
                prop_assert!(slope > -1e-6, "{step:?} {slope}");
            }
        }
    }

    /// The load line of a compliance of 4 meets the curve of 0.5 at three speeds: a piece that is
    /// pulled along and let go again jumps at other places on its way up and down.
    #[test]
    fn a_piece_keeps_doing_what_it_did() {
        let compliance = 4.0;
        let (first, second) = LAW.curve().folds(compliance).unwrap();
        let line_of = |speed: f64| speed + compliance * LAW.curve().at(speed);
        let (up, down) = (line_of(first), line_of(second));
        assert!(down < up);
        let mut state = PipeMotion::default();
        let mut follow = |driven: f64| {
            let step = LAW.meet(&state, line(driven, compliance));
            state = step.state;
            step.speed
        };
        assert!(follow(up - 1e-6) <= first);
        assert!(follow(up + 1e-6) > second);
        assert!(follow(down + 1e-6) >= second);
        assert!(follow(down - 1e-6) < first);
        // And backwards.
        assert!(follow(-up - 1e-6) < -second);
    }

    #[test]
    fn what_is_no_number_stays_none() {
        for stribeck_speed in [0.0, 0.5] {
            let law = PipeFriction {
                stribeck_speed,
                ..LAW
            };
            let step = law.meet(&moving(1.0), line(f64::NAN, 4.0));
            assert!(step.speed.is_nan());
        }
    }

    #[test]
    fn without_a_stribeck_speed_friction_falls_with_the_first_slip() {
        let law = PipeFriction {
            stribeck_speed: 0.0,
            ..LAW
        };
        assert_eq!(law.meet(&PipeMotion::default(), line(2.0, 1.0)).speed, 0.0);
        let slips = law.meet(&PipeMotion::default(), line(2.5, 1.0));
        assert!((slips.speed - 1.5).abs() < 1e-12);
        // And holds it no more while it turns.
        let turns = law.meet(&slips.state, line(1.5, 1.0));
        assert!((turns.speed - 0.5).abs() < 1e-12);
        assert_eq!(law.meet(&turns.state, line(0.9, 1.0)).speed, 0.0);
    }
}
