//! How far discrete driving-point responses are from being positive-real.
//!
//! A site in contact closes a feedback loop whose gain may be infinite (a
//! sticking bit). It is stable for every gain only if the response of the taps
//! has a positive real part at every frequency, not only at those the taps
//! were made from (Section 2.4, Fig. 3).
//! Taps that end with the simulation, while the response continues, are another
//! matter: the spectrum of what was cut off at once ripples about the true one and
//! dips below zero even where that does not. In the lower half of the band, where the
//! string itself may ring for ever, they are weighted by 1 − n/N, which averages the
//! spectrum with Fejér's kernel over a band of 1/T. The kernel is nowhere negative, so
//! that a passive response stays passive: what is left is the mean power that a
//! sinusoidal force or torque puts in from rest in N steps. In the upper half they
//! count as they are, without the continuing motion of the lower: no string rings there in a
//! scheme that damps its highest frequencies, and in one that does not a stuck site
//! chatters. Held responses alone have a string's own highest frequencies: where these ring on,
//! the whole band is weighted.
//!
//! The plain inverse transform lets a sticking bit chatter, convolution quadrature does not:
//!
//! ```
//! use linear::method::Transform;
//! use linear::passivity::STABLE_MARGIN;
//! use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: 200.0,
//!     longest_time: 20.0,
//! };
//! let margin = |method: Method| linear::responses(&string, &method, &request)?.torsion_margin();
//! assert!(margin(Method::Quadrature)? > Some(STABLE_MARGIN));
//! assert!(margin(Method::DirectIdft(Transform::default()))? < Some(STABLE_MARGIN));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::cmp::Ordering;
use std::sync::Arc;

use num_complex::Complex64;
use numerics::{Mat, eigenvalues};

use crate::budget::{COMPLEX, REAL};
use crate::error::{BuildError, ResponseError};
use crate::fft::{self, RealToComplex};
use crate::parallel;

/// Below this margin a response is counted as unstable in sticking. Rounding
/// and the cut tail of a response stay well within it.
pub const STABLE_MARGIN: f64 = -1e-4;

/// The transform is this many times longer than the taps, so that their
/// spectrum is seen between its own samples too.
const REFINEMENT: usize = 8;

/// Bytes that the plan of a transform holds for each of its samples. Measured, and rounded up.
const PLAN: f64 = 16.0;

/// The same of its input and its output, and of what another one left.
const BUFFERS: f64 = 24.0;

/// Differences of the taps that rid the upper half of the band of the lower: a
/// vibration at a twentieth of f_s is reduced 3 million times.
const DIFFERENCES: u32 = 8;

/// The last one in this number of taps shows whether a response continues.
const END_PART: usize = 4;

/// Where a response is furthest from being positive-real.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct WorstPoint {
    /// The positive-real margin (see [`positive_real_margin`]).
    pub margin: f64,
    /// The frequency at which it is found, rad per step, from 0 to π.
    pub angle: f64,
    /// In what proportion the inputs act there, a unit vector.
    pub direction: Vec<f64>,
}

/// Where a response ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// With its last tap: it has decayed, or it is what is simulated with.
    Whole,
    /// It continues, ever more smoothly, beyond the simulation.
    Cut,
    /// It continues, with fronts or its highest frequencies as at the beginning, beyond the simulation.
    Ringing,
}

impl Ending {
    /// How responses end whose instantaneous ones are no larger than `instant`:
    /// whole, where the last quarter of each sums to so little that cutting it off
    /// would not change the verdict on their margin.
    pub fn of<'a>(responses: impl Iterator<Item = &'a [f64]>, instant: f64) -> Self {
        let end_sum = |taps: &[f64]| -> f64 {
            let end = &taps[taps.len() - taps.len() / END_PART..];
            end.iter().map(|tap| tap.abs()).sum()
        };
        let largest = responses.map(end_sum).fold(0.0, f64::max);
        if largest <= -STABLE_MARGIN * instant {
            Ending::Whole
        } else {
            Ending::Cut
        }
    }
}

/// The smallest real part over a fine frequency grid, relative to the largest
/// instantaneous response A(0): for several inputs the smallest eigenvalue of
/// the Hermitian part. `taps(output, input)` gives the response between two of
/// `inputs` driving points.
///
/// # Errors
/// Where there are no taps, not equally many, or some that are not finite.
pub fn positive_real_margin<'a>(
    inputs: usize,
    ending: Ending,
    taps: impl Fn(usize, usize) -> &'a [f64],
) -> Result<f64, BuildError> {
    worst_point(inputs, ending, taps).map(|worst| worst.margin)
}

/// The margin with the place where it is found: what a load must be tuned to
/// that draws energy from the string.
///
/// # Errors
/// Where there are no taps, not equally many, or some that are not finite.
pub fn worst_point<'a>(
    inputs: usize,
    ending: Ending,
    taps: impl Fn(usize, usize) -> &'a [f64],
) -> Result<WorstPoint, BuildError> {
    let count = if inputs > 0 { taps(0, 0).len() } else { 0 };
    let mut pairs = (0..inputs * inputs).map(|pair| taps(pair / inputs, pair % inputs));
    if count == 0 || pairs.any(|taps| taps.len() != count) {
        return Err(ResponseError::Shape.into());
    }
    let mut pairs = (0..inputs * inputs).map(|pair| taps(pair / inputs, pair % inputs));
    if pairs.any(|taps| !taps.iter().all(|tap| tap.is_finite())) {
        return Err(ResponseError::NotFinite.into());
    }
    let instant = (0..inputs).map(|input| taps(input, input)[0]);
    let scale = instant.fold(0.0, f64::max);
    let length = transform_length(count);
    let hermitian = HermitianPart::of(inputs, &Spectrometer::new(length, ending), taps);
    let (smallest, place) = hermitian.smallest_eigenvalue()?;
    Ok(WorstPoint {
        margin: smallest / scale,
        angle: std::f64::consts::TAU * place as f64 / length as f64,
        direction: worst_direction(&hermitian.at(place))?,
    })
}

/// Samples of the transform of a number of taps.
fn transform_length(taps: usize) -> usize {
    REFINEMENT * taps.next_power_of_two()
}

/// Memory, bytes, that the margin of a number of inputs takes, of responses of a number of taps,
/// the same in both directions or not.
pub(crate) fn bytes(inputs: usize, taps: usize, reciprocity: Reciprocity) -> f64 {
    if inputs == 0 {
        return 0.0;
    }
    let length = transform_length(taps) as f64;
    let entries = (inputs * (inputs + 1) / 2) as f64;
    let entry = match reciprocity {
        Reciprocity::None if inputs > 1 => COMPLEX,
        _ => REAL,
    };
    let works = (entries / PAIRS_AT_ONCE as f64).ceil();
    let works = works.min(parallel::threads() as f64);
    (entries * 0.5 * entry + PLAN + BUFFERS * works) * length
}

/// Whether responses are the same in both directions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reciprocity {
    /// To the last digit.
    Exact,
    /// Not so, or not known to be.
    None,
}

impl Reciprocity {
    /// That of responses between driving points, by output and input.
    pub(crate) fn of<'a>(inputs: usize, taps: impl Fn(usize, usize) -> &'a [f64]) -> Self {
        let mut below = (0..inputs).flat_map(|row| (0..row).map(move |column| (row, column)));
        match below.all(|(row, column)| taps(row, column) == taps(column, row)) {
            true => Self::Exact,
            false => Self::None,
        }
    }
}

/// The Hermitian part of a square of responses, at frequencies up to Nyquist.
struct HermitianPart {
    inputs: usize,
    /// Real parts on and below the diagonal, row by row.
    real: Vec<Vec<f64>>,
    /// The imaginary ones; none where responses are the same in both directions.
    /// On the diagonal there are none.
    imaginary: Option<Vec<Vec<f64>>>,
}

/// One in this number of frequencies is computed first, for a bound that spares most others.
const STRIDE: usize = 64;

/// Pairs of inputs, and frequencies, that a thread takes at a time.
const PAIRS_AT_ONCE: usize = 4;
const FREQUENCIES_AT_ONCE: usize = 4096;

impl HermitianPart {
    fn of<'a>(
        inputs: usize,
        spectrometer: &Spectrometer,
        taps: impl Fn(usize, usize) -> &'a [f64],
    ) -> Self {
        let taps: Vec<Vec<&[f64]>> = (0..inputs)
            .map(|row| (0..inputs).map(|column| taps(row, column)).collect())
            .collect();
        let is_reciprocal =
            Reciprocity::of(inputs, |row, column| taps[row][column]) == Reciprocity::Exact;
        let row = |row: usize| (0..=row).map(move |column| (row, column));
        let pairs: Vec<(usize, usize)> = (0..inputs).flat_map(row).collect();
        let entry = |work: &mut Work, (row, column): (usize, usize)| {
            spectrometer.spectrum(taps[row][column], work);
            if is_reciprocal || row == column {
                return (parts(&work.spectrum, |it| it.re), Vec::new());
            }
            let mut mean = work.spectrum.clone();
            spectrometer.spectrum(taps[column][row], work);
            for (mean, other) in mean.iter_mut().zip(&work.spectrum) {
                *mean = 0.5 * (*mean + other.conj());
            }
            (parts(&mean, |it| it.re), parts(&mean, |it| it.im))
        };
        // Some of them by what one thread works in.
        let entries = parallel::map(pairs.len().div_ceil(PAIRS_AT_ONCE), 1, |some| {
            let mut work = spectrometer.work();
            let some = pairs.chunks(PAIRS_AT_ONCE).nth(some).unwrap_or_default();
            let entries = some.iter().map(|pair| entry(&mut work, *pair));
            entries.collect::<Vec<_>>()
        });
        let (real, imaginary) = entries.into_iter().flatten().unzip();
        Self {
            inputs,
            real,
            imaginary: (!is_reciprocal).then_some(imaginary),
        }
    }

    /// Number of frequencies.
    fn len(&self) -> usize {
        self.real[0].len()
    }

    /// Place of an entry on or below the diagonal.
    fn place(row: usize, column: usize) -> usize {
        row * (row + 1) / 2 + column
    }

    fn at(&self, frequency: usize) -> Mat<Complex64> {
        let entry = |row: usize, column: usize| {
            let place = Self::place(row, column);
            let imaginary = self.imaginary.as_ref().map(|it| it[place][frequency]);
            Complex64::new(self.real[place][frequency], imaginary.unwrap_or(0.0))
        };
        Mat::from_fn(self.inputs, self.inputs, |row, column| {
            match row.cmp(&column) {
                Ordering::Less => entry(column, row).conj(),
                Ordering::Equal => self.real[Self::place(row, row)][frequency].into(),
                Ordering::Greater => entry(row, column),
            }
        })
    }

    /// Whether all eigenvalues at a frequency are greater than a bound: a Cholesky factorisation, in a
    /// buffer that is kept, tells for a fraction of the work of finding them.
    fn are_above(&self, bound: f64, frequency: usize, lower: &mut Vec<f64>) -> bool {
        if self.imaginary.is_some() {
            let mut matrix = self.at(frequency);
            for input in 0..self.inputs {
                matrix[(input, input)] -= bound;
            }
            return eigenvalues::are_positive(&matrix);
        }
        lower.clear();
        lower.extend(self.real.iter().map(|entry| entry[frequency]));
        for input in 0..self.inputs {
            lower[Self::place(input, input)] -= bound;
        }
        eigenvalues::are_positive_of_symmetric(lower)
    }

    /// The smallest eigenvalue at any frequency, and the frequency.
    fn smallest_eigenvalue(&self) -> Result<(f64, usize), BuildError> {
        let mut smallest = (f64::INFINITY, 0);
        if self.inputs == 1 {
            for (frequency, entry) in self.real[0].iter().enumerate() {
                if *entry < smallest.0 {
                    smallest = (*entry, frequency);
                }
            }
            return Ok(smallest);
        }
        smallest = self.smallest_below(smallest, (0..self.len()).step_by(STRIDE))?;
        let parts = parallel::map(self.len().div_ceil(FREQUENCIES_AT_ONCE), 1, |part| {
            let first = part * FREQUENCIES_AT_ONCE;
            let end = self.len().min(first + FREQUENCIES_AT_ONCE);
            self.smallest_below(smallest, first..end)
        });
        for part in parts {
            let part = part?;
            if part.0 < smallest.0 {
                smallest = part;
            }
        }
        Ok(smallest)
    }

    /// The smallest eigenvalue at some frequencies that is below one at another, and the frequency; that other
    /// where there is none.
    fn smallest_below(
        &self,
        mut smallest: (f64, usize),
        frequencies: impl Iterator<Item = usize>,
    ) -> Result<(f64, usize), BuildError> {
        let mut lower = Vec::with_capacity(self.real.len());
        for frequency in frequencies {
            if smallest.0.is_finite() && self.are_above(smallest.0, frequency, &mut lower) {
                continue;
            }
            let found = smallest_eigenvalue(&self.at(frequency))?;
            if found < smallest.0 {
                smallest = (found, frequency);
            }
        }
        Ok(smallest)
    }
}

/// A part of each number.
fn parts(numbers: &[Complex64], part: impl Fn(&Complex64) -> f64) -> Vec<f64> {
    numbers.iter().map(part).collect()
}

fn smallest_eigenvalue(hermitian: &Mat<Complex64>) -> Result<f64, BuildError> {
    let rising = eigenvalues::of_hermitian(hermitian)
        .map_err(|_| BuildError::NotFinite { method: "taps" })?;
    Ok(rising[0])
}

/// The eigenvector of the smallest eigenvalue. Reciprocity makes the Hermitian
/// part real, and so the eigenvector, but for a factor.
fn worst_direction(hermitian: &Mat<Complex64>) -> Result<Vec<f64>, BuildError> {
    let (_, vectors) = eigenvalues::with_vectors(hermitian)
        .map_err(|_| BuildError::NotFinite { method: "taps" })?;
    let vector = vectors.col(0);
    let largest = (vector.iter().copied())
        .max_by(|one, other| one.norm().total_cmp(&other.norm()))
        .unwrap_or(Complex64::new(1.0, 0.0));
    let turned: Vec<f64> = (vector.iter().map(|entry| (entry / largest).re)).collect();
    let length = turned.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok(turned.iter().map(|x| x / length).collect())
}

/// Finds spectra of taps, zeros appended, at `length / 2 + 1` frequencies up to Nyquist.
struct Spectrometer {
    forward: Arc<dyn RealToComplex<f64>>,
    ending: Ending,
    /// In the upper half of the band, what undoes the differences.
    undone: Vec<Complex64>,
}

impl Spectrometer {
    fn new(length: usize, ending: Ending) -> Self {
        let undone = |index: usize| {
            let angle = -std::f64::consts::TAU * index as f64 / length as f64;
            let half_difference = 0.5 * (1.0 - Complex64::from_polar(1.0, angle));
            half_difference.powu(DIFFERENCES).inv()
        };
        Self {
            forward: fft::forward(length),
            ending,
            undone: match ending {
                Ending::Cut => (length / 4..=length / 2).map(undone).collect(),
                Ending::Whole | Ending::Ringing => Vec::new(),
            },
        }
    }

    /// Memory for its transforms.
    fn work(&self) -> Work {
        Work {
            padded: self.forward.make_input_vec(),
            spectrum: self.forward.make_output_vec(),
            rough: match self.ending {
                Ending::Cut => self.forward.make_output_vec(),
                Ending::Whole | Ending::Ringing => Vec::new(),
            },
            scratch: self.forward.make_scratch_vec(),
        }
    }

    /// Leaves the spectrum of taps in `work`.
    fn spectrum(&self, taps: &[f64], work: &mut Work) {
        if self.ending == Ending::Whole {
            return self.transform(taps.iter().copied(), work);
        }
        let count = taps.len() as f64;
        let weighted = taps.iter().enumerate();
        let weighted = weighted.map(|(index, tap)| tap * (1.0 - index as f64 / count));
        if self.ending == Ending::Ringing {
            return self.transform(weighted, work);
        }
        self.transform(half_differences(taps).into_iter(), work);
        std::mem::swap(&mut work.spectrum, &mut work.rough);
        self.transform(weighted, work);
        let from = work.spectrum.len() - self.undone.len();
        let upper = work.spectrum.iter_mut().zip(&work.rough).skip(from);
        for ((value, rough), undone) in upper.zip(&self.undone) {
            *value = rough * undone;
        }
    }

    fn transform(&self, taps: impl Iterator<Item = f64>, work: &mut Work) {
        let filled = (work.padded.iter_mut().zip(taps))
            .map(|(padded, tap)| *padded = tap)
            .count();
        work.padded[filled..].fill(0.0);
        self.forward
            .process_with_scratch(&mut work.padded, &mut work.spectrum, &mut work.scratch)
            .expect("all buffers were made by the plan");
    }
}

/// What a [`Spectrometer`] works in.
struct Work {
    padded: Vec<f64>,
    spectrum: Vec<Complex64>,
    rough: Vec<Complex64>,
    scratch: Vec<Complex64>,
}

/// Half the difference from tap to tap, taken [`DIFFERENCES`] times.
fn half_differences(taps: &[f64]) -> Vec<f64> {
    let mut differences = taps.to_vec();
    for _ in 0..DIFFERENCES {
        for index in (1..differences.len()).rev() {
            differences[index] = 0.5 * (differences[index] - differences[index - 1]);
        }
        differences[0] *= 0.5;
    }
    differences
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_passive_first_order_lag_has_a_positive_margin_and_a_delay_has_not() {
        let lag: Vec<f64> = (0..64).map(|n| 0.5f64.powi(n)).collect();
        let margin = positive_real_margin(1, Ending::Whole, |_, _| &lag).unwrap();
        // Re 1/(1 − ζ/2) on the unit circle is smallest at ζ = −1: 2/3.
        assert!((margin - 2.0 / 3.0).abs() < 1e-9);
        let delayed = [1.0, 0.0, 0.0, 2.0];
        let margin = positive_real_margin(1, Ending::Whole, |_, _| &delayed).unwrap();
        assert!((margin + 1.0).abs() < 1e-9);
    }

    /// An integrator never decays: cut off at once it looks unstable, but is not.
    #[test]
    fn a_passive_response_that_continues_is_passive_where_it_is_cut() {
        let integrator: Vec<f64> = (0..64).map(|n| if n == 0 { 0.5 } else { 1.0 }).collect();
        let margin = |ending| positive_real_margin(1, ending, |_, _| &integrator).unwrap();
        assert!(margin(Ending::Whole) < -1.0);
        assert!(margin(Ending::Cut) > -1e-12);
        let late: Vec<f64> = (0..64).map(|n| if n == 0 { 0.1 } else { 1.0 }).collect();
        assert!(positive_real_margin(1, Ending::Cut, |_, _| &late).unwrap() < -1.0);
    }

    #[test]
    fn coupling_stronger_than_the_driving_points_is_not_passive() {
        let (own, cross) = ([1.0], [2.0]);
        let margin =
            positive_real_margin(
                2,
                Ending::Whole,
                |i, j| if i == j { &own[..] } else { &cross[..] },
            )
            .unwrap();
        assert!((margin + 1.0).abs() < 1e-12);
    }

    /// The smallest of all eigenvalues, though very few are computed; of responses that are the same in
    /// both directions, and of others.
    #[test]
    fn nothing_smaller_is_missed() {
        for (inputs, is_reciprocal) in (2..=5).flat_map(|it| [(it, false), (it, true)]) {
            let taps: Vec<Vec<f64>> = (0..inputs * inputs)
                .map(|pair| {
                    (0..100)
                        .map(|n| f64::from((pair as i32 * 31 + n * n * 7) % 101 - 50))
                        .collect()
                })
                .collect();
            let of = |output: usize, input: usize| match is_reciprocal {
                true => &taps[output.max(input) * inputs + output.min(input)][..],
                false => &taps[output * inputs + input][..],
            };
            // More frequencies than a thread takes at a time.
            let spectrometer = Spectrometer::new(REFINEMENT * 1024, Ending::Cut);
            let hermitian = HermitianPart::of(inputs, &spectrometer, of);
            assert_eq!(hermitian.imaginary.is_none(), is_reciprocal);
            let all = (0..hermitian.len()).map(|place| smallest_eigenvalue(&hermitian.at(place)));
            let smallest = all.map(Result::unwrap).fold(f64::INFINITY, f64::min);
            let (found, place) = hermitian.smallest_eigenvalue().unwrap();
            assert_eq!(found, smallest, "{inputs}");
            assert_eq!(found, smallest_eigenvalue(&hermitian.at(place)).unwrap());
        }
    }
}
