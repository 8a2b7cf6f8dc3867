//! Memory for the past of a case, kept from case to case.

use std::cell::RefCell;

use linear::Complex64;
use linear::budget::REAL;

use super::kernels::{Kernels, Level};
use super::partition::{FIRST_BLOCK, Partition};

/// Numbers of the buffers for transforms and sums, for each step of a block of the highest level.
const BUFFERS: f64 = 16.0;

/// The most planes.
const PLANES: usize = 2;

thread_local! {
    /// Of the last case of a thread, by the number of planes.
    static LAST: RefCell<[Option<Past>; PLANES]> = const { RefCell::new([None, None]) };
}

/// All that grows with the length of a case. What is written before it is read is not
/// cleared for the next one.
#[derive(Debug, Default)]
pub(super) struct Past {
    /// Of each plane and site, all steps.
    pub(super) inputs: Vec<Vec<f64>>,
    /// Of each plane and site, the steps up to the last whose input is not zero.
    pub(super) active_steps: Vec<usize>,
    /// Of each plane and site, the B₀ steps of the present block: what all inputs so far
    /// add to those that are still to come.
    pub(super) known: Vec<f64>,
    pub(super) levels: Vec<PastLevel>,
    pub(super) window: Vec<f64>,
    pub(super) spectrum: Vec<Complex64>,
    pub(super) scratch: Vec<Complex64>,
    pub(super) sums: Vec<f64>,
}

/// The past at one level, within the present block of the next.
#[derive(Debug, Default)]
pub(super) struct PastLevel {
    /// Of each block, plane and site, its spectrum.
    pub(super) spectra: Vec<f64>,
    /// Which of these are not zero.
    pub(super) is_active: Vec<bool>,
    /// Blocks so far.
    pub(super) blocks: usize,
    /// Of each plane and site, one block: what they add.
    pub(super) ready: Vec<f64>,
}

impl Past {
    /// Bytes of a number of steps at a number of sites, in one plane or two, with responses of a
    /// number of taps.
    pub(super) fn bytes(sites: usize, planes: usize, taps: usize, steps: f64) -> f64 {
        let mut of_channel = steps + FIRST_BLOCK as f64;
        let mut largest = 0.0;
        let partition = Partition::of(sites);
        for (block, _) in partition.levels(taps) {
            largest = block as f64;
            of_channel += largest + partition.ratio as f64 * 2.0 * largest;
        }
        // The blocks of the highest level are all kept.
        of_channel += (steps / largest).ceil() * 2.0 * largest;
        REAL * ((planes * sites) as f64 * of_channel + BUFFERS * largest)
    }

    /// An empty one for a case of at most `steps` steps.
    pub(super) fn empty(kernels: &Kernels, planes: usize, steps: usize) -> Self {
        let last = LAST.with_borrow_mut(|last| last.get_mut(planes.wrapping_sub(1))?.take());
        let mut past: Self = last.unwrap_or_default();
        past.begin(kernels, planes, steps);
        past
    }

    /// Keeps it for the next case.
    pub(super) fn keep(self, planes: usize) {
        // A thread that is about to end keeps nothing.
        let _ = LAST.try_with(|last| {
            let place = planes.wrapping_sub(1);
            if let Some(last) = last.borrow_mut().get_mut(place) {
                *last = Some(self);
            }
        });
    }

    fn begin(&mut self, kernels: &Kernels, planes: usize, steps: usize) {
        let channels = planes * kernels.sites;
        self.inputs.resize_with(channels, Vec::new);
        for inputs in &mut self.inputs {
            inputs.clear();
            inputs.reserve(steps);
        }
        cleared(&mut self.active_steps, channels, 0);
        let of_block = channels * FIRST_BLOCK;
        cleared(&mut self.known, of_block, 0.0);
        self.levels
            .resize_with(kernels.levels.len(), PastLevel::default);
        let last = kernels.levels.len() - 1;
        let ratio = Partition::of(kernels.sites).ratio;
        for (index, (past, level)) in self.levels.iter_mut().zip(&kernels.levels).enumerate() {
            let blocks = if index == last {
                steps.div_ceil(level.block)
            } else {
                ratio
            };
            past.begin(level, channels, blocks);
        }
        let largest = kernels.levels.iter().map(|level| level.block).max();
        let largest = largest.unwrap_or(FIRST_BLOCK);
        let scratch = kernels.levels.iter().map(|level| {
            let forward = level.forward.get_scratch_len();
            forward.max(level.inverse.get_scratch_len())
        });
        at_least(&mut self.window, 2 * largest);
        at_least(&mut self.spectrum, largest + 1);
        at_least(&mut self.scratch, scratch.max().unwrap_or(0));
        at_least(&mut self.sums, 2 * largest * planes);
    }
}

impl PastLevel {
    fn begin(&mut self, level: &Level, channels: usize, blocks: usize) {
        at_least(&mut self.spectra, blocks * channels * level.stride());
        cleared(&mut self.is_active, blocks * channels, false);
        self.blocks = 0;
        cleared(&mut self.ready, channels * level.block, 0.0);
    }
}

/// `count` of one value.
fn cleared<T: Copy>(values: &mut Vec<T>, count: usize, value: T) {
    values.clear();
    values.resize(count, value);
}

/// At least `count`, of any values.
fn at_least<T: Clone + Default>(values: &mut Vec<T>, count: usize) {
    if values.len() < count {
        values.resize(count, T::default());
    }
}
