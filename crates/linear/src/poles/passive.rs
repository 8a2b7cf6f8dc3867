//! Whether what is stepped gives back more than it was given, over the whole unit circle.

use num_complex::Complex64;
use numerics::{Mat, eigenvalues, products};

use crate::error::BuildError;

/// Angles at equal distances that are examined besides those of the poles that turn, and between all.
const ANGLES: usize = 64;

/// Mean speeds of sites over a step by forces that are held over it.
pub(super) struct Speeds<'a> {
    pub(super) turns: &'a [Complex64],
    /// In the step of the force, m/s per N, row by row.
    pub(super) own: Vec<f64>,
    /// Of each site (the first rows) by each pole,
    pub(super) moves: &'a Mat<Complex64>,
    /// and what a force at each site (column) makes of it for the next step.
    pub(super) excited: Mat<Complex64>,
}

impl Speeds<'_> {
    /// The Hermitian part of what forces that vary with an angle a step make of speeds.
    fn hermitian(&self, angle: f64) -> Mat<Complex64> {
        let sites = self.excited.ncols();
        let back = Complex64::from_polar(1.0, -angle);
        // Each pole stands for its conjugate, too.
        let by = |turn: Complex64| 0.5 * back / (1.0 - turn * back);
        let [one, other] = [false, true].map(|is_conjugate| {
            let conjugated = |it: Complex64| if is_conjugate { it.conj() } else { it };
            let weighted = Mat::from_fn(self.turns.len(), sites, |pole, site| {
                conjugated(self.excited[(pole, site)]) * by(conjugated(self.turns[pole]))
            });
            let moves = Mat::from_fn(sites, self.turns.len(), |site, pole| {
                conjugated(self.moves[(site, pole)])
            });
            products::product_complex(moves.as_ref(), weighted.as_ref())
        });
        let speed = |output: usize, input: usize| {
            self.own[output * sites + input] + one[(output, input)] + other[(output, input)]
        };
        Mat::from_fn(sites, sites, |row, column| {
            0.5 * (speed(row, column) + speed(column, row).conj())
        })
    }
}

/// The least eigenvalue of the Hermitian part of speeds at any angle, as a part of the greatest speed of a
/// site within the step of its own force.
///
/// # Errors
/// Where one is not finite.
pub(super) fn least_margin(speeds: &Speeds) -> Result<f64, BuildError> {
    let sites = speeds.excited.ncols();
    let own = (0..sites).map(|site| speeds.own[site * (sites + 1)]);
    let scale = own.fold(0.0, f64::max);
    let turning = speeds.turns.iter().filter(|turn| turn.im != 0.0);
    let mut angles: Vec<f64> = (turning.map(|turn| turn.arg().abs()))
        .chain((0..=ANGLES).map(|place| place as f64 * std::f64::consts::PI / ANGLES as f64))
        .collect();
    angles.sort_unstable_by(f64::total_cmp);
    angles.dedup();
    let between = angles.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let all: Vec<f64> = between.chain(angles.iter().copied()).collect();
    let mut least = f64::INFINITY;
    for angle in all {
        // A speed of a string that nothing holds has a pole at rest.
        if angle == 0.0 {
            continue;
        }
        let hermitian = speeds.hermitian(angle);
        if least.is_finite() {
            let mut above = hermitian.clone();
            (0..sites).for_each(|site| above[(site, site)] -= least);
            if eigenvalues::are_positive(&above) {
                continue;
            }
        }
        let values = eigenvalues::of_hermitian(&hermitian);
        let found = values.map_err(|_| BuildError::NotFinite { method: "poles" })?[0];
        if !found.is_finite() {
            return Err(BuildError::NotFinite { method: "poles" });
        }
        least = least.min(found);
    }
    Ok(least / scale)
}
