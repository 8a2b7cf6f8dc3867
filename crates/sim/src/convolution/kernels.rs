//! Responses cut into blocks and transformed, once for all cases.

use std::sync::Arc;

use linear::budget::REAL;
use linear::fft::{self, ComplexToReal, RealToComplex};
use linear::{Complex64, ResponseError};
use pulp::Arch;

use super::partition::{FIRST_BLOCK, LANES, Partition, RECENT};

/// Numbers that the plans of a level's transforms hold for each step of a block.
const PLANS: f64 = 16.0;

/// Responses between the sites prepared for summing, shared by all cases.
#[derive(Debug, Clone)]
pub struct Kernels {
    pub(super) sites: usize,
    /// A(0), `[output × sites + input]`.
    instants: Vec<f64>,
    /// Which kernel each pair has, `[output × sites + input]`: where responses are the same in both
    /// directions, so are kernels, and there are half as many.
    pub(super) kernel_of: Vec<usize>,
    /// Of each kernel a lane of zeros, taps 1 … B₀ − 1 and another zero.
    pub(super) recent: Vec<f64>,
    pub(super) levels: Vec<Level>,
    /// Which instructions the processor has.
    pub(super) arch: Arch,
}

/// The kernels cut into blocks of one length.
#[derive(Clone)]
pub(super) struct Level {
    pub(super) block: usize,
    pub(super) partitions: usize,
    /// Of each kernel and partition, its spectrum as [`split`] leaves it.
    pub(super) spectra: Vec<f64>,
    pub(super) forward: Arc<dyn RealToComplex<f64>>,
    pub(super) inverse: Arc<dyn ComplexToReal<f64>>,
}

impl std::fmt::Debug for Level {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Level")
            .field("block", &self.block)
            .field("partitions", &self.partitions)
            .finish_non_exhaustive()
    }
}

impl Level {
    /// Length of one spectrum, real and imaginary parts.
    pub(super) fn stride(&self) -> usize {
        2 * self.block
    }

    fn new(taps: &[&[f64]], block: usize, partitions: usize) -> Self {
        let forward = fft::forward(2 * block);
        let inverse = fft::inverse(2 * block);
        let mut level = Self {
            block,
            partitions,
            spectra: Vec::new(),
            forward,
            inverse,
        };
        let mut window = level.forward.make_input_vec();
        let mut spectrum = level.forward.make_output_vec();
        let mut scratch = level.forward.make_scratch_vec();
        level.spectra = vec![0.0; taps.len() * partitions * level.stride()];
        let parts = level.spectra.chunks_exact_mut(2 * block);
        for (index, part) in parts.enumerate() {
            let (pair, partition) = (taps[index / partitions], index % partitions);
            for (lag, value) in window.iter_mut().enumerate() {
                *value = tap(pair, partition * block + lag) / (2 * block) as f64;
            }
            transform(&*level.forward, &mut window, &mut spectrum, &mut scratch);
            split(&spectrum, part);
        }
        level
    }
}

/// A tap; there are none beyond the last.
fn tap(taps: &[f64], lag: usize) -> f64 {
    taps.get(lag).copied().unwrap_or(0.0)
}

pub(super) fn transform(
    plan: &dyn RealToComplex<f64>,
    signal: &mut [f64],
    spectrum: &mut [Complex64],
    scratch: &mut [Complex64],
) {
    plan.process_with_scratch(signal, spectrum, scratch)
        .expect("all buffers were made by the plan");
}

/// The spectrum of a real signal as real parts and then imaginary ones, for products without
/// shuffling; in the place of the first of these, which is zero, the last real part.
pub(super) fn split(spectrum: &[Complex64], parts: &mut [f64]) {
    let (real, imaginary) = parts.split_at_mut(parts.len() / 2);
    for ((value, real), imaginary) in spectrum.iter().zip(real).zip(&mut *imaginary) {
        (*real, *imaginary) = (value.re, value.im);
    }
    imaginary[0] = spectrum[imaginary.len()].re;
}

/// The other way.
pub(super) fn join(parts: &[f64], spectrum: &mut [Complex64]) {
    let (real, imaginary) = parts.split_at(parts.len() / 2);
    for ((value, &re), &im) in spectrum.iter_mut().zip(real).zip(imaginary) {
        *value = Complex64::new(re, im);
    }
    spectrum[0].im = 0.0;
    spectrum[imaginary.len()] = Complex64::new(imaginary[0], 0.0);
}

impl Kernels {
    /// Bytes of the square of responses of a number of taps between a number of sites, the same in
    /// both directions or not.
    pub(crate) fn bytes(sites: usize, taps: usize, is_reciprocal: bool) -> f64 {
        let pairs = match is_reciprocal {
            true => sites * (sites + 1) / 2,
            false => sites * sites,
        } as f64;
        let of_level = |(block, partitions): (usize, usize)| {
            let spectra = pairs * (partitions * 2 * block) as f64;
            spectra + PLANS * block as f64
        };
        let levels: f64 = Partition::of(sites).levels(taps).map(of_level).sum();
        let instant_and_recent = (1 + RECENT) as f64;
        REAL * (levels + pairs * instant_and_recent)
    }

    /// Prepares `taps[output][input]`, a square of responses.
    ///
    /// # Errors
    /// Where there are none, or not equally many to each site as from it.
    pub fn new(taps: &[Vec<impl AsRef<[f64]>>]) -> Result<Self, ResponseError> {
        if taps.is_empty() || taps.iter().any(|inputs| inputs.len() != taps.len()) {
            return Err(ResponseError::Shape);
        }
        Ok(Self::of(taps))
    }

    /// The same of responses that are known to be a square, or nothing.
    pub(crate) fn of(taps: &[Vec<impl AsRef<[f64]>>]) -> Self {
        let sites = taps.len();
        let pairs: Vec<&[f64]> = taps.iter().flatten().map(AsRef::as_ref).collect();
        let longest = pairs.iter().map(|taps| taps.len()).max().unwrap_or(0);
        let mirrored = |pair: usize| (pair % sites) * sites + pair / sites;
        let is_reciprocal = (0..pairs.len()).all(|pair| pairs[pair] == pairs[mirrored(pair)]);
        let (mut kernel_of, mut kernels) = (vec![0; pairs.len()], Vec::new());
        for (pair, taps) in pairs.iter().enumerate() {
            kernel_of[pair] = if is_reciprocal && mirrored(pair) < pair {
                kernel_of[mirrored(pair)]
            } else {
                kernels.push(*taps);
                kernels.len() - 1
            };
        }
        let levels = Partition::of(sites)
            .levels(longest)
            .map(|(block, partitions)| Level::new(&kernels, block, partitions))
            .collect();
        let mut recent = vec![0.0; kernels.len() * RECENT];
        for (recent, taps) in recent.chunks_exact_mut(RECENT).zip(&kernels) {
            let recent = recent[LANES..].iter_mut().take(FIRST_BLOCK - 1);
            for (lag, recent) in recent.enumerate() {
                *recent = tap(taps, 1 + lag);
            }
        }
        Self {
            sites,
            kernel_of,
            instants: pairs.iter().map(|taps| tap(taps, 0)).collect(),
            recent,
            levels,
            arch: Arch::new(),
        }
    }

    /// A(0): the response of a site within the step of an input at another.
    #[inline]
    pub(crate) fn instant(&self, output: usize, input: usize) -> f64 {
        self.instants[output * self.sites + input]
    }
}
