//! Discrete impulse responses from frequency responses (Section 2.4).
//!
//! A filter turns the frequency responses of any number of channels, given at
//! complex s, into taps: `output(k) = Σ taps(k − n) input(n)`, so that a tap
//! carries the paper's factor 1/f_s.

mod buffers;
pub(crate) mod direct;
pub(crate) mod held;
pub(crate) mod hilbert;
pub(crate) mod quadrature;
pub mod radau;

use num_complex::Complex64;

use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::fft::ComplexToReal;
use crate::parallel;

pub(crate) use buffers::Buffers;

/// Puts down what every channel answers at s, several of them at a time.
pub(crate) type ResponseAt<'a, T = Lanes> = dyn Fn(T, &mut [T]) + Sync + 'a;

/// Channels whose spectra are gathered at once: side by side they are in the same lines of memory.
const GATHERED: usize = 4;

/// From this many channels on it is worth its memory to gather some at once, on every thread.
const MANY_CHANNELS: usize = 8;

/// How many of a number of channels are gathered at once, and on how many threads.
fn gathering(channels: usize) -> (usize, usize) {
    match channels < MANY_CHANNELS {
        true => (1, 1),
        false => (
            GATHERED,
            parallel::threads().min(channels.div_ceil(GATHERED)),
        ),
    }
}

/// Evaluates every channel at `variable(0)`, …, one for each frequency of the buffers, several of
/// them at a time; then makes of the spectrum of each channel what is wanted.
fn sample<T: Number + Send, Made: Send>(
    buffers: Buffers,
    variable: &(dyn Fn(usize) -> Complex64 + Sync),
    response: &ResponseAt<'_, T>,
    make: &(dyn Fn(Vec<Complex64>) -> Made + Sync),
) -> Vec<Made> {
    let (channels, count) = (buffers.channels, buffers.frequencies());
    // Of several frequencies at a time, one channel after the other: what a channel answers is gathered from few
    // places. Real and imaginary parts of nothing ask the system for memory only where they are written.
    let size = T::LANES * channels;
    let mut rows = vec![[0.0; 2]; count.div_ceil(T::LANES) * size];
    let no_values = || vec![T::real(0.0); channels];
    parallel::chunks_mut(&mut rows, (size, 64), no_values, |values, (chunk, rows)| {
        let first = T::LANES * chunk;
        // Beyond the end the last one serves, and is left out.
        let point = |lane: usize| variable((first + lane).min(count - 1));
        response(T::of_lanes(point), values);
        for (row, value) in rows.chunks_mut(T::LANES).zip(values.iter()) {
            for (lane, entry) in row.iter_mut().enumerate() {
                let Complex64 { re, im } = value.lane(lane);
                *entry = [re, im];
            }
        }
    });
    let (at_once, threads) = gathering(channels);
    let groups = channels.div_ceil(at_once);
    let in_one_go = if threads == 1 { groups } else { 1 };
    let made = parallel::map(groups, in_one_go, |group| {
        let first = at_once * group;
        let some = at_once.min(channels - first);
        let mut spectra: Vec<_> = (0..some).map(|_| Vec::with_capacity(count)).collect();
        for rows in rows.chunks_exact(size) {
            let rows = rows[first * T::LANES..].chunks_exact(T::LANES);
            for (spectrum, row) in spectra.iter_mut().zip(rows) {
                let left = count - spectrum.len();
                let row = row.iter().take(left);
                spectrum.extend(row.map(|[re, im]| Complex64::new(*re, *im)));
            }
        }
        spectra.into_iter().map(make).collect::<Vec<Made>>()
    });
    made.into_iter().flatten().collect()
}

/// The first `count` taps, without the memory of the others.
fn keep(mut taps: Vec<f64>, count: usize) -> Vec<f64> {
    taps.truncate(count);
    taps.shrink_to_fit();
    taps
}

/// The real sequence of the (even) length of a plan whose discrete Fourier transform starts with
/// `half_spectrum`, half as many values and one.
pub(crate) fn inverse_transform(
    plan: &dyn ComplexToReal<f64>,
    half_spectrum: &mut [Complex64],
) -> Vec<f64> {
    // A real sequence has real values at zero frequency and at Nyquist.
    if let [first, .., last] = half_spectrum {
        first.im = 0.0;
        last.im = 0.0;
    }
    let mut sequence = plan.make_output_vec();
    plan.process(half_spectrum, &mut sequence)
        .expect("lengths and the two real ends are set above");
    let scale = 1.0 / plan.len() as f64;
    sequence.iter_mut().for_each(|x| *x *= scale);
    sequence
}

/// s = iω on the grid of a transform of `length` samples.
fn frequency_grid(length: usize, sampling_frequency: f64) -> impl Fn(usize) -> Complex64 + Sync {
    let step = std::f64::consts::TAU * sampling_frequency / length as f64;
    move |index| Complex64::new(0.0, step * index as f64)
}
