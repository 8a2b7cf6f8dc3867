//! The friction ratio at which a step rolls, in a bracket of two that slide either way; or
//! at which something else of it is zero.

/// Rolling is solved to this fraction of the friction coefficient.
pub(super) const RATIO_TOLERANCE: f64 = 1e-15;

/// Most halvings of a bracket of friction ratios: fifty-one take −μ … μ down to
/// [`RATIO_TOLERANCE`].
const MOST_HALVINGS: usize = 64;

/// The state of a step for one friction ratio.
#[derive(Clone, Copy)]
pub(super) struct Trial {
    pub(super) ratio: f64,
    pub(super) normal_force: f64,
    /// The ratio times the normal force, N; of what rolls it is known before both.
    pub(super) friction: f64,
    pub(super) radius: f64,
    pub(super) direction: [f64; 2],
    pub(super) sliding_speed: f64,
}

/// The contact that rolls between two of opposite sliding speeds, to within
/// `tolerance` of the friction ratio.
pub(super) fn rolling_between(
    low: Trial,
    high: Trial,
    tolerance: f64,
    trial: impl FnMut(f64) -> Trial,
) -> Trial {
    zero_between(low, high, tolerance, |trial| trial.sliding_speed, trial)
}

/// The contact at which a value is zero between two at which it has opposite signs, to within
/// `tolerance` of the friction ratio: false position, and a bisection after each.
pub(super) fn zero_between(
    mut low: Trial,
    mut high: Trial,
    tolerance: f64,
    value: impl Fn(&Trial) -> f64,
    mut trial: impl FnMut(f64) -> Trial,
) -> Trial {
    // Keeps the root between the two.
    let replace = |low: &mut Trial, high: &mut Trial, trial: Trial| {
        if (value(&trial) < 0.0) == (value(low) < 0.0) {
            *low = trial;
        } else {
            *high = trial;
        }
    };
    let mut width = (high.ratio - low.ratio).abs();
    for _ in 0..MOST_HALVINGS {
        let slope = value(&high) - value(&low);
        let secant = high.ratio - value(&high) * (high.ratio - low.ratio) / slope;
        let found = trial(secant);
        if value(&found) == 0.0 {
            return found;
        }
        replace(&mut low, &mut high, found);
        let middle = trial(0.5 * (low.ratio + high.ratio));
        replace(&mut low, &mut high, middle);
        let next = (high.ratio - low.ratio).abs();
        // As close as numbers get, or not numbers.
        if !(next > tolerance && next < width) {
            break;
        }
        width = next;
    }
    let closer = value(&low).abs() < value(&high).abs();
    if closer { low } else { high }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Any of the 2⁶⁴ patterns of bits: subnormal, infinite and no numbers too.
    fn any_number() -> impl Strategy<Value = f64> {
        any::<u64>().prop_map(f64::from_bits)
    }

    fn place(ratio: f64, sliding_speed: f64) -> Trial {
        Trial {
            ratio,
            normal_force: 1.0,
            friction: ratio,
            radius: 1.0,
            direction: [1.0, 0.0],
            sliding_speed,
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 5000, failure_persistence: None, ..Default::default() })]

        /// Answers without sense, one after the other and round again.
        #[test]
        fn a_bracket_is_tried_a_bounded_number_of_times(
            ends in [any_number(), any_number(), any_number(), any_number()],
            tolerance in any_number(),
            answers in prop::collection::vec((any_number(), any_number()), 1..40),
        ) {
            let [a, b, c, d] = ends;
            let mut tried = 0;
            rolling_between(place(a, b), place(c, d), tolerance, |ratio| {
                tried += 1;
                assert!(tried <= 2 * MOST_HALVINGS);
                let (elsewhere, sliding_speed) = answers[tried % answers.len()];
                // As often as not, what was asked for.
                place(if tried % 2 == 0 { ratio } else { elsewhere }, sliding_speed)
            });
        }

        #[test]
        fn the_ratio_that_rolls_is_found_in_its_bracket(root in -1.0..1.0f64, power in 0i32..4) {
            let trial = |ratio: f64| place(ratio, (ratio - root).powi(2 * power + 1));
            let found = rolling_between(trial(-1.0), trial(1.0), RATIO_TOLERANCE, trial);
            prop_assert!((found.ratio - root).abs() <= 1e-14);
        }
    }
}
