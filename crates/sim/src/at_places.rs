//! Bending moments and displacements along a string after it was stepped, from the forces that acted on
//! its sites.
//!
//! u(k) = Σ A(k − n) F(n) over all forces so far, but only for the steps of the closing window, and all
//! forces are known: one product of spectra for each place and site. What a transform of N samples wraps
//! round reaches none of the last N − n steps, n the number of taps.

use std::sync::Arc;

use linear::budget::{Budget, COMPLEX, Need, OutOfBudget, REAL, What};
use linear::fft::{self, ComplexToReal, RealToComplex};
use linear::{Complex64, PlaceResponses};

use crate::error::SimulationError;

/// The part of the taps by which a transform is longer, at least: steps that are found at a time.
const FOUND_AT_ONCE: f64 = 0.2;

/// Lengths of transforms are these times a power of two.
const FACTORS: [usize; 3] = [8, 10, 12];

/// A quantity in bending at some places, ready to be found for any motion of a string.
#[derive(Clone)]
pub struct AtPlaces {
    /// Distances of the places from the bit, m, from the surface down.
    places: Vec<f64>,
    sites: usize,
    taps: usize,
    /// Of each place and site.
    spectra: Vec<Complex64>,
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

impl std::fmt::Debug for AtPlaces {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("AtPlaces")
            .field("places", &self.places)
            .field("sites", &self.sites)
            .field("taps", &self.taps)
            .finish_non_exhaustive()
    }
}

/// Samples of a transform for a number of taps.
fn samples(taps: usize) -> usize {
    let least = (taps as f64 * (1.0 + FOUND_AT_ONCE)).ceil().max(4.0) as usize;
    let next = |factor: &usize| factor * least.div_ceil(*factor).next_power_of_two();
    FACTORS.iter().map(next).min().unwrap_or(least)
}

impl AtPlaces {
    /// What it takes of a budget for a number of places and forces at a number of sites, of
    /// responses of a number of taps.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(
        (places, sites): (usize, usize),
        taps: usize,
        budget: &Budget,
    ) -> Result<(), OutOfBudget> {
        let bytes = COMPLEX * ((places * sites) as f64) * frequencies(taps);
        budget.pass(Need::lasting(bytes), What::Simulator)
    }

    /// Bytes that finding it takes of a motion of a number of steps, without the motion.
    pub fn bytes_of_motion((places, sites): (usize, usize), taps: usize, steps: f64) -> f64 {
        let spectra = 2.0 * sites as f64 + 4.0;
        2.0 * REAL * places as f64 * steps + COMPLEX * spectra * frequencies(taps)
    }

    /// Of responses by the method by which the forces are found.
    ///
    /// # Errors
    /// Where these are no responses of every place from every site.
    pub fn new(responses: PlaceResponses) -> Result<Self, SimulationError> {
        let PlaceResponses {
            places,
            from_forces,
        } = responses;
        let sites = from_forces.first().map_or(0, Vec::len);
        let taps = from_forces
            .iter()
            .flatten()
            .map(Vec::len)
            .max()
            .unwrap_or(0);
        let is_whole = |forces: &Vec<Vec<f64>>| {
            forces.len() == sites && forces.iter().all(|it| it.len() == taps)
        };
        if taps == 0 || places.len() != from_forces.len() || !from_forces.iter().all(is_whole) {
            return Err(linear::ResponseError::Shape.into());
        }
        let samples = samples(taps);
        let (forward, inverse) = (fft::forward(samples), fft::inverse(samples));
        let mut spectra = Vec::with_capacity(places.len() * sites * (samples / 2 + 1));
        let mut window = forward.make_input_vec();
        let mut spectrum = forward.make_output_vec();
        // Taps of a place go before those of the next are transformed.
        for taps in from_forces.into_iter().flatten() {
            window.fill(0.0);
            for (sample, tap) in window.iter_mut().zip(&taps) {
                *sample = tap / samples as f64;
            }
            transform(&*forward, &mut window, &mut spectrum);
            spectra.extend_from_slice(&spectrum);
        }
        Ok(Self {
            places,
            sites,
            taps,
            spectra,
            forward,
            inverse,
        })
    }

    /// Distances of the places from the bit, m, from the surface down.
    pub fn places(&self) -> &[f64] {
        &self.places
    }

    /// The quantity along x and along y at every place in all steps from one on, by
    /// `forces[axis][site][step]`, N: of a string that lies, by what they differ by from those that hold
    /// it at rest.
    ///
    /// # Errors
    /// Where these are not forces at its sites, or last longer than its responses.
    pub fn of(
        &self,
        forces: &[Vec<Vec<f64>>; 2],
        from: usize,
    ) -> Result<Vec<[Vec<f64>; 2]>, SimulationError> {
        let steps = forces[0].first().map_or(0, Vec::len);
        let fits = |forces: &Vec<Vec<f64>>| {
            forces.len() == self.sites && forces.iter().all(|it| it.len() == steps)
        };
        if steps > self.taps || !forces.iter().all(fits) {
            return Err(linear::ResponseError::Shape.into());
        }
        let mut found = vec![[(); 2].map(|()| Vec::with_capacity(steps)); self.places.len()];
        let at_once = self.forward.len() - self.taps;
        for begin in (from..steps).step_by(at_once) {
            let end = steps.min(begin + at_once);
            self.add(forces, begin..end, &mut found);
        }
        Ok(found)
    }

    /// Adds what it is in some steps, which later forces do not change.
    fn add(
        &self,
        forces: &[Vec<Vec<f64>>; 2],
        steps: std::ops::Range<usize>,
        found: &mut [[Vec<f64>; 2]],
    ) {
        let stride = self.forward.len() / 2 + 1;
        let mut window = self.forward.make_input_vec();
        let mut spectrum = self.forward.make_output_vec();
        for (axis, forces) in forces.iter().enumerate() {
            let mut inputs = Vec::with_capacity(forces.len() * stride);
            for forces in forces {
                window.fill(0.0);
                window[..steps.end].copy_from_slice(&forces[..steps.end]);
                transform(&*self.forward, &mut window, &mut spectrum);
                inputs.extend_from_slice(&spectrum);
            }
            let of_places = self.spectra.chunks_exact(self.sites * stride);
            for (found, kernels) in found.iter_mut().zip(of_places) {
                spectrum.fill(Complex64::ZERO);
                let pairs = kernels
                    .chunks_exact(stride)
                    .zip(inputs.chunks_exact(stride));
                for (kernel, input) in pairs {
                    for ((sum, kernel), input) in spectrum.iter_mut().zip(kernel).zip(input) {
                        *sum += kernel * input;
                    }
                }
                self.inverse
                    .process(&mut spectrum, &mut window)
                    .expect("both ends of the products of real sequences' spectra are real");
                found[axis].extend_from_slice(&window[steps.clone()]);
            }
        }
    }
}

fn frequencies(taps: usize) -> f64 {
    (samples(taps) / 2 + 1) as f64
}

fn transform(plan: &dyn RealToComplex<f64>, window: &mut [f64], spectrum: &mut [Complex64]) {
    plan.process(window, spectrum)
        .expect("both were made by the plan");
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cheap sequence without pattern, in (−1, 1).
    fn noise(seed: usize, count: usize) -> Vec<f64> {
        (0..count)
            .map(|step| (1e4 * ((seed * 7919 + step) as f64).sin()).fract())
            .collect()
    }

    #[test]
    fn moments_of_any_last_steps_are_the_direct_sum() {
        let (places, sites, taps) = (3, 2, 700);
        let from_forces: Vec<Vec<Vec<f64>>> = (0..places)
            .map(|place| {
                (0..sites)
                    .map(|site| noise(5 + 2 * place + site, taps))
                    .collect()
            })
            .collect();
        let moments = AtPlaces::new(PlaceResponses {
            places: vec![9.0, 5.0, 1.0],
            from_forces: from_forces.clone(),
        });
        let moments = moments.unwrap();
        for (steps, from) in [(700, 690), (700, 0), (500, 123), (1, 0)] {
            let of_axis = |axis: usize| {
                (0..sites)
                    .map(|site| noise(50 + 2 * axis + site, steps))
                    .collect::<Vec<_>>()
            };
            let forces = [of_axis(0), of_axis(1)];
            let found = moments.of(&forces, from).unwrap();
            for (place, found) in found.iter().enumerate() {
                for axis in 0..2 {
                    assert_eq!(found[axis].len(), steps - from);
                    for (step, moment) in (from..steps).zip(&found[axis]) {
                        let sum = |site: usize| -> f64 {
                            let past = forces[axis][site][..=step].iter().rev();
                            past.zip(&from_forces[place][site])
                                .map(|(a, b)| a * b)
                                .sum()
                        };
                        let expected: f64 = (0..sites).map(sum).sum();
                        assert!((moment - expected).abs() < 1e-11, "{steps} {from} {step}");
                    }
                }
            }
        }
        let longer = [vec![noise(1, 701); 2], vec![noise(2, 701); 2]];
        assert!(moments.of(&longer, 0).is_err());
    }
}
