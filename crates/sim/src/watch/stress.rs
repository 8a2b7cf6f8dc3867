//! How a moving string is bent and stressed over the closing window.
//!
//! The stress of bending is that at the outer surface of the tube, M R/I, M of both planes together; von
//! Mises stress adds the effective tension, as it is at rest, and the mean torque of the closing window
//! ([`linear::Stress`]). At a point of the surface, which turns with the string, bending stress
//! alternates: that is half of what lies between the least and the greatest at the point where this is
//! most.

use std::f64::consts::PI;

use linear::{Stress, Tube};
use serde::{Deserialize, Serialize};

/// Directions across the string, within half a turn, in which points of its surface are followed: at
/// the worst point half-way between two, stress is 3e-4 greater.
const DIRECTIONS: usize = 64;

/// What a person would ask of stress over the closing window, each the greatest along the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct StressMeasures {
    /// Bending moment, N m.
    pub moment: Peak,
    /// Stress of bending at the outer surface, Pa.
    pub bending: Peak,
    /// The amplitude with which that alternates at a point of the surface, Pa.
    pub amplitude: Peak,
    /// Von Mises stress at the outer surface, Pa.
    pub von_mises: Peak,
}

/// The greatest of something along the string.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Peak {
    /// How much.
    pub value: f64,
    /// Where, m from the bit.
    pub from_bit: f64,
}

/// A place along the string, and how it moves in the steps of a closing window.
#[derive(Debug, Clone)]
pub struct StressedPlace<'a> {
    /// Distance from the bit, m.
    pub from_bit: f64,
    /// The tubes that meet there, or twice the same.
    pub tubes: [Tube; 2],
    /// Effective tension, N.
    pub tension: f64,
    /// Torque in the string, N m.
    pub torque: f64,
    /// Bending moment in each step along x and along y, N m.
    pub moments: &'a [Vec<f64>; 2],
    /// By how much the string has turned in each step, rad.
    pub turned: &'a [f64],
}

impl Peak {
    fn see(&mut self, value: f64, from_bit: f64) {
        if value > self.value {
            *self = Self { value, from_bit };
        }
    }
}

impl StressMeasures {
    /// Of places along a string.
    pub fn of<'a>(places: impl IntoIterator<Item = StressedPlace<'a>>) -> Self {
        let mut all = Self {
            moment: Peak::default(),
            bending: Peak::default(),
            amplitude: Peak::default(),
            von_mises: Peak::default(),
        };
        for place in places {
            let [x, y] = place.moments;
            let squares = x.iter().zip(y).map(|(x, y)| x * x + y * y);
            let moment = squares.fold(0.0, f64::max).sqrt();
            let alternating = amplitude(place.moments, place.turned);
            all.moment.see(moment, place.from_bit);
            for tube in &place.tubes {
                let stress = Stress::new(tube, place.tension, moment, place.torque);
                let alternates = Stress::new(tube, 0.0, alternating, 0.0);
                all.bending.see(stress.bending, place.from_bit);
                all.amplitude.see(alternates.bending, place.from_bit);
                all.von_mises.see(stress.von_mises, place.from_bit);
            }
        }
        all
    }
}

/// The greatest amplitude of a moment along a direction that turns with the string, N m.
fn amplitude([x, y]: &[Vec<f64>; 2], turned: &[f64]) -> f64 {
    let directions: [[f64; 2]; DIRECTIONS] = std::array::from_fn(|index| {
        let (sin, cos) = (PI * index as f64 / DIRECTIONS as f64).sin_cos();
        [cos, sin]
    });
    let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; DIRECTIONS];
    for ((x, y), angle) in x.iter().zip(y).zip(turned) {
        let (sin, cos) = angle.sin_cos();
        let own = [cos * x + sin * y, cos * y - sin * x];
        for ([least, greatest], direction) in ranges.iter_mut().zip(&directions) {
            let along = own[0] * direction[0] + own[1] * direction[1];
            *least = least.min(along);
            *greatest = greatest.max(along);
        }
    }
    let widths = ranges.iter().map(|[least, greatest]| greatest - least);
    0.5 * widths.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUBE: Tube = Tube {
        length: 9.0,
        inner_radius: 0.04,
        outer_radius: 0.1,
    };

    /// A string that turns at a rate while its bend goes round at another, for two turns of the slower.
    fn turning(rate: f64, bend: f64) -> StressMeasures {
        let times = || (0..4000).map(|step| 1e-3 * f64::from(step));
        let moments = [
            times().map(|time| 5e3 * (bend * time).cos()).collect(),
            times().map(|time| 5e3 * (bend * time).sin()).collect(),
        ];
        let turned: Vec<f64> = times().map(|time| rate * time).collect();
        StressMeasures::of([StressedPlace {
            from_bit: 12.0,
            tubes: [TUBE; 2],
            tension: -2e4,
            torque: 3e3,
            moments: &moments,
            turned: &turned,
        }])
    }

    /// Bent one way, a point is stretched and pressed once a turn; bent by what turns with it, it stays
    /// stretched, or pressed.
    #[test]
    fn stress_alternates_by_how_the_string_turns_under_its_bend() {
        let stress = 5e3 * 0.1 / TUBE.second_moment();
        for (rate, bend, part) in [
            (6.0, 0.0, 1.0),
            (6.0, -40.0, 1.0),
            (6.0, 6.0, 0.0),
            (0.0, 0.0, 0.0),
        ] {
            let found = turning(rate, bend);
            assert!((found.moment.value / 5e3 - 1.0).abs() < 1e-12);
            assert!((found.bending.value / stress - 1.0).abs() < 1e-12);
            let amplitude = found.amplitude.value / stress;
            assert!(
                (amplitude - part).abs() < 1e-3,
                "{rate} {bend}: {amplitude}"
            );
            // Pushed and bent, and twisted.
            let along = 2e4 / TUBE.area() + stress;
            let shear = 3e3 * 0.1 / TUBE.polar_moment();
            let von_mises = (along.powi(2) + 3.0 * shear.powi(2)).sqrt();
            assert!((found.von_mises.value / von_mises - 1.0).abs() < 1e-12);
            assert_eq!(found.von_mises.from_bit, 12.0);
        }
    }

    /// The moment is greatest in the thick tube, the stress where a thin one meets it.
    #[test]
    fn a_thinner_tube_is_stressed_more_by_less() {
        let turned = [0.0, 1.0];
        let thin = Tube {
            outer_radius: 0.07,
            ..TUBE
        };
        let moments = [6e3, 5e3].map(|moment| [vec![0.0, moment], vec![0.0; 2]]);
        let place = |from_bit: f64, tubes: [Tube; 2], moments| StressedPlace {
            from_bit,
            tubes,
            tension: 0.0,
            torque: 0.0,
            moments,
            turned: &turned,
        };
        let places = [
            place(4.0, [TUBE; 2], &moments[0]),
            place(8.0, [TUBE, thin], &moments[1]),
        ];
        let found = StressMeasures::of(places);
        assert_eq!((found.moment.value, found.moment.from_bit), (6e3, 4.0));
        assert_eq!(found.bending.from_bit, 8.0);
        let stress = 5e3 * 0.07 / thin.second_moment();
        assert!((found.von_mises.value / stress - 1.0).abs() < 1e-12);
    }
}
