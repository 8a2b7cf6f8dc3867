//! The drag of mud over frequency by interpolation: the exact flow takes a hundred times as long
//! as the waves along a tube, and responses need it at millions of frequencies.
//!
//! Drag is analytic off the negative real axis of s, and so in log s where |arg s| < π. That plane is
//! divided into squares, in each of which its Taylor series about the middle is found from its
//! values on a circle, by Cauchy's integral with the trapezoidal rule. For |arg s| ≤ π/2 the nearest
//! singularity is at least π/2 − 1/4 away, and 16 terms leave a few parts in 10¹³.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::OnceLock;

use num_complex::Complex64;

use super::drag::Drag;
use crate::channel::Channel;
use crate::loss::mud::Annulus;

/// Side of a square.
const SIDE: f64 = 0.25;

/// Radius of the circle on which drag is evaluated, beyond the corners of the square.
const RADIUS: f64 = 0.25;

/// Values on it, and terms.
const TERMS: usize = 16;

/// Squares along log |s|, between rates of 1e-5 and 1e8 rad/s; what is outside is evaluated.
const ALONG: usize = 120;
const SLOWEST: f64 = -11.5;

/// Squares from the real to the imaginary axis, and one beyond it for rounding.
const ACROSS: usize = (FRAC_PI_2 / SIDE) as usize + 1;

/// The drag on a tube.
#[derive(Debug, Clone)]
pub(crate) struct Interpolated {
    annulus: Annulus,
    channel: Channel,
    squares: Vec<OnceLock<Box<[Complex64; TERMS]>>>,
}

/// Where a frequency is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    s: Complex64,
    /// A square, and the place in it over the radius of the circle.
    inside: Option<(usize, Complex64)>,
    /// Whether it is the mirror image that is there.
    mirrored: bool,
}

impl Interpolated {
    /// Of a tube that moves as in a channel.
    pub fn new(annulus: Annulus, channel: Channel) -> Self {
        Self {
            annulus,
            channel,
            squares: vec![OnceLock::new(); ALONG * ACROSS],
        }
    }

    /// Terms of the series in a square, over the radius of the circle.
    fn terms(&self, square: usize) -> &[Complex64; TERMS] {
        self.squares[square].get_or_init(|| {
            let turn = |index: usize| {
                let angle = TAU * (index % TERMS) as f64 / TERMS as f64;
                Complex64::from_polar(1.0, angle)
            };
            let values: [Complex64; TERMS] = std::array::from_fn(|index| {
                let place = middle(square) + turn(index) * RADIUS;
                self.annulus.drag(self.channel, place.exp())
            });
            Box::new(std::array::from_fn(|term| {
                let sum = values.iter().enumerate().map(|(index, value)| {
                    let turned = turn(index * term).conj();
                    value * turned
                });
                sum.sum::<Complex64>() / TERMS as f64
            }))
        })
    }
}

/// The middle of a square.
fn middle(square: usize) -> Complex64 {
    let (along, across) = (square / ACROSS, square % ACROSS);
    let at = |index: usize| (index as f64 + 0.5) * SIDE;
    Complex64::new(SLOWEST + at(along), at(across))
}

impl Drag for Interpolated {
    type Place = Place;

    fn place(s: Complex64) -> Place {
        let mirrored = s.im < 0.0;
        let logarithm = if mirrored { s.conj() } else { s }.ln();
        let along = ((logarithm.re - SLOWEST) / SIDE).floor();
        let is_inside = s.re >= 0.0 && (0.0..ALONG as f64).contains(&along);
        let inside = is_inside.then(|| {
            let across = ((logarithm.im / SIDE) as usize).min(ACROSS - 1);
            let square = along as usize * ACROSS + across;
            (square, (logarithm - middle(square)) / RADIUS)
        });
        Place {
            s,
            inside,
            mirrored,
        }
    }

    fn at(&self, place: &Place) -> Complex64 {
        let Some((square, place_in_it)) = place.inside else {
            return self.annulus.drag(self.channel, place.s);
        };
        let terms = self.terms(square).iter().rev();
        let sum = terms.fold(Complex64::ZERO, |sum, term| sum * place_in_it + term);
        if place.mirrored { sum.conj() } else { sum }
    }
}

/// What is known of it follows from these.
impl PartialEq for Interpolated {
    fn eq(&self, other: &Self) -> bool {
        self.annulus == other.annulus && self.channel == other.channel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest error, in water to gel, in narrow and wide holes, from minutes to a hundred
    /// kilohertz.
    fn worst_of(channel: Channel) -> f64 {
        let mut worst: f64 = 0.0;
        for (viscosity, hole) in [(1e-3, 0.065), (0.03, 0.108), (1.0, 0.2)] {
            let annulus = Annulus {
                viscosity,
                density: 1300.0,
                inner: 0.054,
                outer: 0.0635,
                hole,
            };
            let interpolated = Interpolated::new(annulus, channel);
            for index in 0..3000 {
                let size = 1e-3 * 1e9f64.powf(f64::from(index) / 3000.0);
                let angle = FRAC_PI_2 * (f64::from(index) * 0.618).fract();
                let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
                let s = Complex64::from_polar(size, sign * angle);
                let expected = annulus.drag(channel, s);
                let found = interpolated.at(&Interpolated::place(s));
                worst = worst.max((found - expected).norm() / expected.norm());
            }
        }
        worst
    }

    /// Drag across loses digits itself, to differences of Bessel functions.
    #[test]
    fn it_is_the_exact_drag_to_rounding() {
        for (channel, most) in [
            (Channel::Torsion, 1e-12),
            (Channel::Axial, 1e-12),
            (Channel::Bending, 1e-9),
        ] {
            let worst = worst_of(channel);
            assert!(worst < most, "{channel}: {worst}");
        }
    }

    #[test]
    fn what_is_outside_is_evaluated() {
        let annulus = Annulus {
            viscosity: 0.03,
            density: 1300.0,
            inner: 0.054,
            outer: 0.0635,
            hole: 0.108,
        };
        let interpolated = Interpolated::new(annulus, Channel::Torsion);
        for s in [
            Complex64::ZERO,
            Complex64::new(1e9, 0.0),
            Complex64::new(-0.1, 30.0),
        ] {
            let found = interpolated.at(&Interpolated::place(s));
            assert_eq!(found, annulus.against_turning(s));
        }
    }
}
