//! Newton's method for a convex, increasing function, in a bounded number of steps for any values.

/// A step as small as this part of the root ends within rounding of it: the next
/// would be as small as the square of this.
const CLOSE: f64 = 1e-8;

/// Most steps. One or two are usual; a sixth power, the steepest function of a contact,
/// is reduced by a factor of 10⁷ in this number.
const MOST_STEPS: usize = 100;

/// The root: a step from a guess on either side ends above it, and from there none
/// overshoots, until rounding stops them, or at once where the guess was that close. `above` gives
/// a place to continue from instead of one too far above, or not finite: a guess of zero has no
/// slope. Whether what was found is the root is for the caller to see.
#[inline(always)]
pub(super) fn newton(
    guess: f64,
    above: impl Fn(f64) -> f64,
    mut value_and_slope: impl FnMut(f64) -> (f64, f64),
) -> f64 {
    let (value, slope) = value_and_slope(guess);
    let first = guess - value / slope;
    if (first - guess).abs() <= CLOSE * guess {
        return first;
    }
    let mut root = above(first);
    for _ in 0..MOST_STEPS {
        let (value, slope) = value_and_slope(root);
        let next = root - value / slope;
        // Not a number ends it too.
        if !(next < root && next > 0.0) {
            return root;
        }
        if root - next <= CLOSE * root {
            return next;
        }
        root = next;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Any of the 2⁶⁴ patterns of bits: subnormal, infinite and no numbers too.
    fn any_number() -> impl Strategy<Value = f64> {
        any::<u64>().prop_map(f64::from_bits)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 5000, failure_persistence: None, ..Default::default() })]

        /// Answers without sense, one after the other and round again.
        #[test]
        fn a_function_is_asked_a_bounded_number_of_times(
            guess in any_number(),
            highest in any_number(),
            answers in prop::collection::vec((any_number(), any_number()), 1..40),
        ) {
            let mut asked = 0;
            newton(guess, |first| first.min(highest), |_| {
                asked += 1;
                assert!(asked <= MOST_STEPS + 1);
                answers[asked % answers.len()]
            });
        }

        #[test]
        fn the_root_of_a_cubic_is_found_from_either_side(
            root in 1e-9..1e3f64,
            guess in 0.0..1e3f64,
        ) {
            let cubic = |x: f64| (x * x * (1.0 + x) - root * root * (1.0 + root), x * (2.0 + 3.0 * x));
            prop_assert!((newton(guess, |first| first.min(1e4), cubic) / root - 1.0).abs() < 1e-12);
        }
    }

    /// Steps of a relative millionth are not close, and would take ten million.
    #[test]
    fn a_function_that_is_hardly_convex_does_not_creep() {
        let mut asked = 0;
        newton(
            0.0,
            |_| 1.0,
            |root| {
                asked += 1;
                assert!(asked <= MOST_STEPS + 1);
                (1e-6 * root, 1.0)
            },
        );
    }
}
