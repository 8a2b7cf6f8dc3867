//! How far a centre has gone round the middle of the hole, without an angle in each step.

use std::f64::consts::TAU;

use super::rules::THROUGH_THE_MIDDLE;

/// A centre on its way.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Turning {
    /// Where counting began, and by how much it had turned by then, rad.
    from: [f64; 2],
    before: f64,
    to: [f64; 2],
    /// Times it has crossed the negative x axis since, against the clock less with it.
    crossings: i32,
}

impl Turning {
    /// At a place, m, not having turned yet.
    pub(crate) fn at(place: [f64; 2]) -> Self {
        Self {
            from: place,
            to: place,
            ..Self::default()
        }
    }

    /// Goes straight on to another place; the square of the largest radius so far is given,
    /// m². On a line through the middle, as in motion in a plane, it goes round neither way,
    /// though its direction turns by half a turn in the middle.
    #[inline]
    pub(crate) fn go(&mut self, to: [f64; 2], largest_square: f64) {
        let ([px, py], [x, y]) = (self.to, to);
        let across = px * y - py * x;
        let step_square = (x - px) * (x - px) + (y - py) * (y - py);
        let least = THROUGH_THE_MIDDLE * THROUGH_THE_MIDDLE * largest_square * step_square;
        if across * across <= least {
            *self = Self {
                before: self.angle(),
                ..Self::at(to)
            };
            return;
        }
        let downwards = y.is_sign_negative();
        if downwards != py.is_sign_negative() && downwards == (across > 0.0) {
            self.crossings += if downwards { 1 } else { -1 };
        }
        self.to = to;
    }

    /// By how much it has turned in all, rad, positive against the clock.
    pub(crate) fn angle(&self) -> f64 {
        if self.from == self.to && self.crossings == 0 {
            return self.before;
        }
        let direction = |[x, y]: [f64; 2]| y.atan2(x);
        let turned = direction(self.to) - direction(self.from);
        self.before + turned + TAU * f64::from(self.crossings)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 500, failure_persistence: None, ..Default::default() })]

        /// As the sum of the angles of all steps.
        #[test]
        fn crossings_count_what_angles_add_up_to(
            steps in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 2..200),
            on_the_axis in 0..4usize,
        ) {
            let mut places: Vec<[f64; 2]> = steps.iter().map(|&(x, y)| [x, y]).collect();
            // Signed zeros too.
            for (place, zero) in places.iter_mut().step_by(5).zip([0.0, -0.0].into_iter().cycle()) {
                place[on_the_axis % 2] = zero;
            }
            let mut turning = Turning::at(places[0]);
            let mut sum = 0.0;
            for pair in places.windows(2) {
                let ([px, py], [x, y]) = (pair[0], pair[1]);
                turning.go(pair[1], 2.0);
                let across = px * y - py * x;
                let step = (x - px).hypot(y - py);
                if across.abs() > THROUGH_THE_MIDDLE * 2f64.sqrt() * step {
                    sum += across.atan2(px * x + py * y);
                }
                prop_assert!((turning.angle() - sum).abs() < 1e-9, "{} {sum}", turning.angle());
            }
        }
    }
}
