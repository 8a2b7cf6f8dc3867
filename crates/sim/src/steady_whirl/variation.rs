//! How fast the dynamic stiffness of a damped string can vary with the rate.
//!
//! Let M, C and S be the mass, damping and stiffness of a string, with C ≥ 2σM,
//! and x its shape when the site is displaced by one at the Laplace variable s.
//! Then K(s) = x*(s²M + sC + S)x, and
//!
//! Im K(s) = Im s · x*(2 Re s M + C)x > 0 where Re s > −σ and Im s > 0.
//!
//! So K maps this quarter of the plane into the upper half plane. By the lemma of
//! Schwarz and Pick such a map lengthens no hyperbolic distance: two stiffnesses
//! are never further apart than their rates. This holds for every string, with any tubes, support
//! and compression, and bounds all that is asked of K between two rates by its values there.
//!
//! In viscous mud a quarter plane with a larger σ begins at a rate ω₀ instead of zero
//! ([`linear::bending_decay`]): between two rates the one that begins a little below both serves.

use linear::bending_decay::{BendingDecay, Corner};

/// The corner of the quarter plane is at this part of a rate, at most.
const FROM_CORNER: f64 = 0.75;

/// Rounding hides a smaller part of a stiffness than this.
const LEAST_LOSS: f64 = 1e-9;

/// A positive harmonic function is bent by this part of itself at most, along the rates.
const MOST_BENDING: f64 = 1.125;

/// The dynamic stiffness at a rate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// rad/s.
    pub rate: f64,
    /// N/m; negative where the string presses outwards.
    pub real: f64,
    /// N/m, positive.
    pub imaginary: f64,
}

impl Sample {
    /// asinh(−Re K / Im K): positive where the string presses, and then the smaller
    /// the more friction that needs. As the distance of K from the imaginary axis
    /// it varies no faster than K does.
    pub fn pressing(&self) -> f64 {
        let imaginary = self.imaginary.max(LEAST_LOSS * self.real.abs());
        (-self.real / imaginary).asinh()
    }
}

/// The bound on the variation of a stiffness.
#[derive(Debug, Clone, Copy)]
pub(super) struct Variation {
    /// The quarter plane.
    pub corner: Corner,
}

impl Variation {
    /// Between a rate (rad/s) and faster ones.
    pub fn above(decay: &BendingDecay, rate: f64) -> Self {
        Self {
            corner: *decay.corner_below(FROM_CORNER * rate),
        }
    }

    /// A rate as it is above the corner.
    fn moved(&self, rate: f64) -> f64 {
        rate - self.corner.above
    }

    /// The hyperbolic distance of two rates. The quarter plane becomes the upper half
    /// plane by (σ + s − iω₀)².
    pub fn distance(&self, one: f64, other: f64) -> f64 {
        let [one, other] = [one, other].map(|rate| self.moved(rate));
        let (width, sum) = ((one - other).abs(), one + other);
        let decay_rate = self.corner.decay_rate;
        let moved = width * (2.0 * decay_rate).hypot(sum);
        2.0 * (moved / (4.0 * decay_rate * (one * other).sqrt())).asinh()
    }

    /// The least that a positive harmonic function on the quarter plane, or the least of several,
    /// can be between two rates, each with its value there.
    ///
    /// Such a function is a sum of Poisson kernels P. Along a path of unit speed and of the curvature
    /// κ, in the hyperbolic metric, P″ = (1 − 2 sin²β − κ sin β) P at the angle β to a kernel's
    /// gradient, which is no more than (1 + κ²/8) P. The path of the rates has
    /// κ = (1 + σ²/ω²)^(−3/2) < 1. So the function is no less than what solves y″ = 9/8 y with the
    /// same ends; and as y depends on each end by a positive factor, neither is the least of
    /// several.
    pub fn least_harmonic(&self, [a, b]: [(f64, f64); 2]) -> f64 {
        let length = MOST_BENDING.sqrt() * self.length(a.0, b.0);
        let [a, b] = [a.1, b.1];
        if a.max(b) >= a.min(b) * length.cosh() {
            return a.min(b);
        }
        // y falls from both ends.
        let [even, odd] = [
            0.5 * (a + b) / (0.5 * length).cosh(),
            0.5 * (a - b) / (0.5 * length).sinh(),
        ];
        ((even - odd) * (even + odd)).sqrt()
    }

    /// How long the path of the rates is from one to the other.
    fn length(&self, one: f64, other: f64) -> f64 {
        let place = |rate: f64| {
            let ratio = self.moved(rate) / self.corner.decay_rate;
            ratio.hypot(1.0) - ratio.recip().asinh()
        };
        (place(one) - place(other)).abs()
    }

    /// The least and the greatest that [`Sample::pressing`] can be between two rates, each with
    /// its own. The imaginary axis is no shortest path, so that distances along it do not add
    /// up: each half is as near to its own rate as the middle is.
    pub fn pressing_range(&self, [a, b]: [(f64, f64); 2]) -> [f64; 2] {
        let middle = 0.5 * (a.0 + b.0);
        let halves = [a, b].map(|(rate, pressing)| (pressing, self.distance(rate, middle)));
        let whole = self.distance(a.0, b.0);
        let [(p, reach_p), (q, reach_q)] = halves;
        [
            (p - reach_p).min(q - reach_q).max(p.max(q) - whole),
            (p + reach_p).max(q + reach_q).min(p.min(q) + whole),
        ]
    }

    /// The least and the greatest that Re K can be between two samples: within the
    /// hyperbolic discs around both.
    pub fn real_range(&self, [a, b]: [&Sample; 2]) -> [f64; 2] {
        let reach = self.distance(a.rate, b.rate).sinh();
        let [about_a, about_b] = [a, b].map(|sample| {
            let radius = sample.imaginary.abs() * reach;
            [sample.real - radius, sample.real + radius]
        });
        [about_a[0].max(about_b[0]), about_a[1].min(about_b[1])]
    }

    /// The greatest that |d² Re K / dω²| can be between two samples; infinite where
    /// they are too far apart to tell. In a disc of radius ρ around a sample the nth
    /// coefficient of the power series of K is at most 2 Im K / ρⁿ.
    pub fn curvature(&self, samples: [&Sample; 2]) -> f64 {
        let width = (samples[0].rate - samples[1].rate).abs();
        let bounds = samples.map(|sample| {
            let radius = self.corner.decay_rate.min(self.moved(sample.rate));
            let left = 1.0 - width / radius;
            if left > 0.0 {
                4.0 * sample.imaginary.abs() / (radius * radius * left.powi(3))
            } else {
                f64::INFINITY
            }
        });
        bounds[0].min(bounds[1])
    }
}
