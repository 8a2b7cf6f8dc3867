//! Friction that falls with the speed of sliding, from a static value F_s to a dynamic one F_d: of
//! the bit, of the string along its well, and of the wall.
//!
//! F(v) = F_d + (F_s − F_d) e^(−v/v_s), or e^(−(v/v_s)²), the Stribeck curve in its exponential and
//! in its Gaussian form (B. Armstrong-Hélouvry, P. Dupont and C. Canudas de Wit, "A survey of
//! models, analysis tools and compensation methods for the control of machines with friction",
//! *Automatica* 30, 1994, 1083–1138). A load line v + A F(v) = v_free meets it up to three times:
//! where the curve is steeper than the line, |F′| > 1/A, no motion lasts.

use std::f64::consts::FRAC_1_SQRT_2;

/// Load line and curve meet to this part of the speed that they leave between them: a hundred
/// times rounding.
const SAME_SPEED: f64 = 1e-14;

/// Beyond this exponent e^(−x) is no double; asking for it takes ten times as long as any other.
const NOTHING_LEFT: f64 = 746.0;

/// Steps to a speed. Halving alone takes half of them; of Newton's, close to where two roots are
/// one, each halves what is left.
const MOST_STEPS: usize = 100;

/// √(2/e): the steepest fall of the Gaussian form, at v_s/√2, in parts of (F_s − F_d)/v_s.
const STEEPEST: f64 = 0.857_763_884_960_706_8;

/// How friction falls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// Most steeply at rest.
    Exponential,
    /// Hardly at first: what turns much more slowly than v_s rubs as what is stuck.
    Gaussian,
}

/// Friction over the speed of sliding, in any unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FrictionCurve {
    /// F_s.
    pub(super) at_rest: f64,
    /// F_d, at most F_s.
    pub(super) when_fast: f64,
    /// v_s: the speed at which e⁻¹ of what F_s is more than F_d is left; zero where friction
    /// falls with the first slip.
    pub(super) decay_speed: f64,
    pub(super) shape: Shape,
}

impl FrictionCurve {
    /// Friction at a speed, zero or more.
    pub(super) fn at(&self, speed: f64) -> f64 {
        self.when_fast + self.left(speed)
    }

    /// How far friction falls in all.
    pub(super) fn drop(&self) -> f64 {
        self.at_rest - self.when_fast
    }

    /// −F′: how fast friction falls with the speed.
    pub(super) fn fall(&self, speed: f64) -> f64 {
        self.fall_times(1.0, self.left(speed), speed)
    }

    /// Whether a speed is beyond that at which the Gaussian form falls most.
    pub(super) fn is_fast(&self, speed: f64) -> bool {
        speed > FRAC_1_SQRT_2 * self.decay_speed
    }

    /// What is left at a speed of that by which F_s is more than F_d.
    fn left(&self, speed: f64) -> f64 {
        let more = self.drop();
        if self.decay_speed == 0.0 || more == 0.0 {
            return 0.0;
        }
        let scaled = speed / self.decay_speed;
        let exponent = match self.shape {
            Shape::Exponential => scaled,
            Shape::Gaussian => scaled.powi(2),
        };
        if exponent > NOTHING_LEFT {
            return 0.0;
        }
        more * (-exponent).exp()
    }

    /// A factor times −F′, what is left of friction given. (The order of the products is that of
    /// earlier versions, whose results stay the same to the last digit.)
    fn fall_times(&self, factor: f64, left: f64, speed: f64) -> f64 {
        let scale = self.decay_speed;
        match self.shape {
            _ if scale == 0.0 => 0.0,
            Shape::Exponential => factor * left / scale,
            Shape::Gaussian => factor * (2.0 * left * speed / (scale * scale)),
        }
    }

    /// What the load line leaves of a speed too much, v + A F(v) − `driven`, and how that changes
    /// with v.
    pub(super) fn excess(&self, speed: f64, driven: f64, compliance: f64) -> (f64, f64) {
        let left = self.left(speed);
        let excess = speed + compliance * (self.when_fast + left) - driven;
        (excess, 1.0 - self.fall_times(compliance, left, speed))
    }

    /// The speed above which friction falls less steeply with it than by `slope`; none where it
    /// does at every speed.
    pub(super) fn speed_of_fall(&self, slope: f64) -> Option<f64> {
        match self.shape {
            Shape::Exponential => {
                let steepest = self.drop() / self.decay_speed;
                let speed = self.decay_speed * (steepest / slope).ln();
                (self.decay_speed > 0.0 && speed > 0.0).then_some(speed)
            }
            Shape::Gaussian => {
                let (_, speed) = self.folds(1.0 / slope)?;
                (speed > 0.0).then_some(speed)
            }
        }
    }

    /// Speeds between which the Gaussian form is steeper than lines of a compliance, if it ever is.
    pub(super) fn folds(&self, compliance: f64) -> Option<(f64, f64)> {
        let scale = self.decay_speed;
        let falls = compliance * self.drop();
        if STEEPEST * falls <= scale {
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
        let (first, second) = (halved(0.0, FRAC_1_SQRT_2), halved(6.0, FRAC_1_SQRT_2));
        Some((scale * first, scale * second))
    }

    /// The largest speed v > 0 at which a load line meets the exponential form, where there is one.
    /// Above it v + A F(v) is the larger, and it is convex: Newton's steps from what F_d alone
    /// would leave come down to it, and past the least of it only where there is none.
    pub(super) fn fastest(&self, driven: f64, compliance: f64) -> Option<f64> {
        let mut speed = driven - compliance * self.when_fast;
        for _ in 0..MOST_STEPS {
            let (excess, slope) = self.excess(speed, driven, compliance);
            if speed <= 0.0 || slope <= 0.0 {
                return None;
            }
            let step = excess / slope;
            speed -= step;
            if step <= SAME_SPEED * speed {
                break;
            }
        }
        (speed > 0.0).then_some(speed)
    }

    /// A speed at which a load line meets the curve, between one that is too slow and one that is
    /// too fast, from a guess: Newton's steps, and halving where they lead out.
    pub(super) fn between(
        &self,
        mut ends: (f64, f64),
        guess: f64,
        driven: f64,
        compliance: f64,
    ) -> f64 {
        // What is no number goes through, to be reported as such; `clamp` would panic.
        let mut speed = guess.max(ends.0).min(ends.1);
        for _ in 0..MOST_STEPS {
            let (excess, slope) = self.excess(speed, driven, compliance);
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_curve() -> impl Strategy<Value = FrictionCurve> {
        let shape = prop_oneof![Just(Shape::Exponential), Just(Shape::Gaussian)];
        (shape, 0.0..1.0f64, 1e-2..1e1f64).prop_map(|(shape, when_fast, decay_speed)| {
            FrictionCurve {
                at_rest: 1.0,
                when_fast,
                decay_speed,
                shape,
            }
        })
    }

    proptest! {
        /// F(0) = F_s, F(v_s) by definition, and −F′ is the slope of F.
        #[test]
        fn a_curve_falls_from_its_static_to_its_dynamic_value(
            curve in any_curve(),
            part in 0.01..3.0f64,
        ) {
            prop_assert!((curve.at(0.0) - 1.0).abs() < 1e-15);
            let left = (curve.at(curve.decay_speed) - curve.when_fast) / curve.drop();
            prop_assert!((left - (-1.0f64).exp()).abs() < 1e-12);
            prop_assert!((curve.at(1e3 * curve.decay_speed) - curve.when_fast).abs() < 1e-15);
            let (speed, step) = (part * curve.decay_speed, 1e-5 * curve.decay_speed);
            let slope = (curve.at(speed - step) - curve.at(speed + step)) / (2.0 * step);
            prop_assert!((slope - curve.fall(speed)).abs() < 1e-8 * curve.drop() / curve.decay_speed);
        }

        /// It falls by a slope at the speed that is said, and less beyond.
        #[test]
        fn the_speed_of_a_slope_is_where_the_curve_has_it(
            curve in any_curve(),
            part in 0.05..0.8f64,
        ) {
            let slope = part * curve.drop() / curve.decay_speed;
            let speed = curve.speed_of_fall(slope).unwrap();
            prop_assert!((curve.fall(speed) / slope - 1.0).abs() < 1e-9);
            prop_assert!(curve.fall(1.01 * speed) < slope);
            prop_assert!(curve.speed_of_fall(1.01 * curve.drop() / curve.decay_speed).is_none());
        }
    }

    #[test]
    fn without_a_decay_speed_all_falls_with_the_first_slip() {
        for shape in [Shape::Exponential, Shape::Gaussian] {
            let curve = FrictionCurve {
                at_rest: 2.0,
                when_fast: 1.0,
                decay_speed: 0.0,
                shape,
            };
            assert_eq!((curve.at(1e-9), curve.fall(1e-9)), (1.0, 0.0));
            assert_eq!(curve.speed_of_fall(1.0), None);
        }
    }
}
