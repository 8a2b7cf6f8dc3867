//! Friction of a piece of pipe that lies against the borehole: stuck up to F_s; turning at ω
//! against F_d + (F_s − F_d) e^(−(ω/ω_s)²), the Stribeck curve in its Gaussian form (B.
//! Armstrong-Hélouvry, P. Dupont and C. Canudas de Wit, "A survey of models, analysis tools and
//! compensation methods for the control of machines with friction", *Automatica* 30, 1994,
//! 1083–1138), met by the load line as at the bit (Eq. 16). What turns much more slowly than ω_s
//! rubs as what is stuck, so that a string breaks loose as a whole.

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

/// Load line and curve meet to this part of the speed that they leave between them: a hundred
/// times rounding.
const SAME_SPEED: f64 = 1e-14;

/// Steps to a speed: halving alone takes half of them.
const MOST_STEPS: usize = 100;

/// Speeds in parts of ω_s at which the curve falls most, and how steeply, in parts of
/// (F_s − F_d)/ω_s: 1/√2 and √(2/e).
const STEEPEST: (f64, f64) = (std::f64::consts::FRAC_1_SQRT_2, 0.857_763_884_960_706_8);

/// The friction of a piece and load lines of one slope.
#[derive(Debug, Clone, Copy)]
pub struct OnLines {
    law: PipeFriction,
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
        let goes_on = was_forward == Some(direction > 0.0);
        let fast = (self.folds)
            .filter(|_| goes_on && self.law.is_fast(before.speed))
            .and_then(|(_, fold)| self.fast(driven, fold, guess));
        let is_held = driven <= self.compliance * self.law.torque_static;
        let Some(speed) = fast.or_else(|| (!is_held).then(|| self.slow(driven, guess))) else {
            return TorqueStep {
                torque: -free_speed / self.compliance,
                speed: 0.0,
                state: PipeMotion::default(),
            };
        };
        TorqueStep {
            torque: -direction * self.law.torque_at(speed),
            speed: direction * speed,
            state: PipeMotion {
                motion: if direction > 0.0 {
                    BitMotion::Forward
                } else {
                    BitMotion::Backward
                },
                speed,
            },
        }
    }

    /// What the load line leaves of a speed too much, v + A F(v) − `driven`, and how that changes
    /// with v.
    fn excess(&self, speed: f64, driven: f64) -> (f64, f64) {
        let left = self.law.left(speed);
        let excess = speed + self.compliance * (self.law.torque_dynamic + left) - driven;
        (excess, 1.0 - self.compliance * self.law.fall(speed, left))
    }

    /// How far the torque falls at most where it slips, N m.
    pub fn largest_drop(&self) -> f64 {
        self.law.largest_drop()
    }

    /// By how much the torque against it falls with its speed, N m per rad/s.
    pub fn fall(&self, speed: f64) -> f64 {
        self.law.fall(speed, self.law.left(speed))
    }

    /// A speed at which load line and curve meet, between one that is too slow and one that is
    /// too fast, from a guess.
    fn between(&self, mut ends: (f64, f64), guess: f64, driven: f64) -> f64 {
        // What is no number goes through, to be told as such; `clamp` would panic.
        let mut speed = guess.max(ends.0).min(ends.1);
        for _ in 0..MOST_STEPS {
            let (excess, slope) = self.excess(speed, driven);
            if excess > 0.0 {
                ends.1 = speed;
            } else {
                ends.0 = speed;
            }
            if excess.abs() <= SAME_SPEED * driven {
                break;
            }
            let next = speed - excess / slope;
            let is_within = ends.0 < next && next < ends.1;
            speed = if is_within {
                next
            } else {
                0.5 * (ends.0 + ends.1)
            };
        }
        speed
    }

    /// The speed of a piece that is stuck or slow and no longer held.
    fn slow(&self, driven: f64, guess: f64) -> f64 {
        let most = driven - self.compliance * self.law.torque_dynamic;
        let Some((first, second)) = self.folds else {
            return self.between((0.0, most), guess, driven);
        };
        if self.excess(first, driven).0 >= 0.0 {
            return self.between((0.0, first), guess, driven);
        }
        self.between((second.min(most), most), guess, driven)
    }

    /// The speed of a piece that is fast, if it can be, beyond the upper fold.
    fn fast(&self, driven: f64, fold: f64, guess: f64) -> Option<f64> {
        let most = driven - self.compliance * self.law.torque_dynamic;
        if fold >= most || self.excess(fold, driven).0 > 0.0 {
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
        OnLines {
            law: self,
            compliance,
            folds: self.folds(compliance),
        }
    }

    /// Beyond where the curve is steepest.
    fn is_fast(&self, speed: f64) -> bool {
        speed > STEEPEST.0 * self.stribeck_speed
    }

    /// What F_s is more than F_d, and what of it is left at a speed, N m.
    fn left(&self, speed: f64) -> f64 {
        let more = self.torque_static - self.torque_dynamic;
        if self.stribeck_speed == 0.0 || more == 0.0 {
            return 0.0;
        }
        more * (-(speed / self.stribeck_speed).powi(2)).exp()
    }

    /// How fast that falls with the speed, what is left of it given, N m per rad/s.
    fn fall(&self, speed: f64, left: f64) -> f64 {
        match self.stribeck_speed {
            0.0 => 0.0,
            scale => 2.0 * left * speed / (scale * scale),
        }
    }

    /// Torque against a piece that turns at a speed.
    fn torque_at(&self, speed: f64) -> f64 {
        self.torque_dynamic + self.left(speed)
    }

    /// Speeds at which the curve is as steep as lines of a compliance, if it ever is.
    fn folds(&self, compliance: f64) -> Option<(f64, f64)> {
        let (steepest, slope) = STEEPEST;
        let scale = self.stribeck_speed;
        let falls = compliance * self.largest_drop();
        if slope * falls <= scale {
            return None;
        }
        // x e^(−x²) grows up to 1/√2 and falls beyond: halving finds either place.
        let level = 0.5 * scale / falls;
        let is_below = |x: f64| x * (-x * x).exp() < level;
        let halved = |mut below: f64, mut above: f64| {
            for _ in 0..MOST_STEPS / 2 {
                let middle = 0.5 * (below + above);
                if is_below(middle) {
                    below = middle;
                } else {
                    above = middle;
                }
            }
            below
        };
        // Beyond six, e^(−36) is left.
        let (first, second) = (halved(0.0, steepest), halved(6.0, steepest));
        Some((scale * first, scale * second))
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
                let (_, slope) = law.on_lines(compliance).excess(step.speed.abs(), free_speed.abs());
                prop_assert!(slope > -1e-6, "{step:?} {slope}");
            }
        }
    }

    /// The load line of a compliance of 4 meets the curve of 0.5 at three speeds: a piece that is
    /// pulled along and let go again jumps at other places on its way up and down.
    #[test]
    fn a_piece_keeps_doing_what_it_did() {
        let compliance = 4.0;
        let (first, second) = LAW.folds(compliance).unwrap();
        let line_of = |speed: f64| speed + compliance * LAW.torque_at(speed);
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
