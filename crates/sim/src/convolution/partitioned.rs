//! The sum over the past by blocks, each as a product of spectra, without
//! delay: convolution in nested partitions.
//!
//! Time is cut into blocks of B₀ steps, eight of which (four for many sites) make a block of the
//! next level, and so on. Where a block of some level ends (of the highest, where
//! several do), its inputs are transformed once, and what they and the earlier
//! ones of the same larger block add to the *next* block of that level is
//! computed at once. What is left at each step is the sum over the inputs of the
//! present block of B₀. With a kernel of n taps and n steps the work grows as
//! n log n.
//!
//! A transform of 2B samples of zero-padded input, times that of the taps
//! (q − 1)B … (q + 1)B − 1, holds in its second half what the block q blocks ago
//! adds to the present one. Transforms are not normalised; the kernels carry the
//! factor 1/2B. Blocks without any input, which is most of the life of a site that
//! does not touch, are neither transformed nor multiplied.

use linear::ResponseError;
use pulp::{Simd, WithSimd};

use super::kernels::{Kernels, join, split, transform};
use super::partition::{FIRST_BLOCK, LANES, RECENT};
use super::past::Past;

/// The inputs of one case so far, in one plane or in two that share their
/// kernels, and what they are going to add.
#[derive(Debug)]
pub struct Convolution<'a> {
    kernels: &'a Kernels,
    planes: usize,
    steps: usize,
    past: Past,
}

impl Drop for Convolution<'_> {
    fn drop(&mut self) {
        std::mem::take(&mut self.past).keep(self.planes);
    }
}

impl<'a> Convolution<'a> {
    /// Bytes of a case of a number of steps at a number of sites, in one plane or two, with
    /// responses of a number of taps.
    pub(crate) fn bytes(sites: usize, planes: usize, taps: usize, steps: f64) -> f64 {
        Past::bytes(sites, planes, taps, steps)
    }

    /// The empty past of a case of at most `steps` steps.
    pub fn new(kernels: &'a Kernels, planes: usize, steps: usize) -> Self {
        Self {
            kernels,
            planes,
            steps: 0,
            past: Past::empty(kernels, planes, steps),
        }
    }

    /// Writes Σ A(k − n) E(n) over the past, n < k, of every plane and site, in
    /// this order, for the present step k.
    ///
    /// # Errors
    /// Where there are not as many sums as planes and sites.
    pub fn past(&self, sums: &mut [f64]) -> Result<(), ResponseError> {
        self.check(sums)?;
        self.write_past(sums);
        Ok(())
    }

    /// The same, for several sums.
    pub(crate) fn write_past(&self, sums: &mut [f64]) {
        let within = self.steps % FIRST_BLOCK;
        let channels = self.past.known.chunks_exact(FIRST_BLOCK);
        for (sum, known) in sums.iter_mut().zip(channels) {
            *sum = known[within];
        }
    }

    /// Ends the present step with the inputs of every plane and site.
    ///
    /// # Errors
    /// Where there are not as many inputs as planes and sites.
    pub fn push(&mut self, inputs: &[f64]) -> Result<(), ResponseError> {
        self.check(inputs)?;
        self.add(inputs);
        Ok(())
    }

    fn check(&self, channels: &[f64]) -> Result<(), ResponseError> {
        if channels.len() == self.past.inputs.len() {
            Ok(())
        } else {
            Err(ResponseError::Shape)
        }
    }

    /// The same, for several inputs.
    pub(crate) fn add(&mut self, inputs: &[f64]) {
        let mut is_active = false;
        for (channel, &input) in inputs.iter().enumerate() {
            self.past.inputs[channel].push(input);
            if input != 0.0 {
                self.past.active_steps[channel] = self.steps + 1;
                is_active = true;
            }
        }
        if is_active {
            let kernels = self.kernels;
            kernels.arch.dispatch(AddPresent { past: self, inputs });
        }
        self.steps += 1;
        if self.steps % FIRST_BLOCK == 0 {
            self.end_block();
        }
    }

    /// What the inputs of the present step add to the later ones of its block.
    #[inline(always)]
    fn add_present<S: Simd>(&mut self, simd: S, inputs: &[f64]) {
        let kernels = self.kernels;
        let sites = kernels.sites;
        let next = self.steps % FIRST_BLOCK + 1;
        // Whole lanes from where the next step is: those before it are over.
        let first = next - next % LANES;
        let from = LANES - next % LANES;
        for (channel, &value) in inputs.iter().enumerate() {
            if value == 0.0 {
                continue;
            }
            // Of two planes at most: divisions would take as long as the sum of a step.
            let plane = if channel < sites { 0 } else { sites };
            let input = channel - plane;
            let known = &mut self.past.known[plane * FIRST_BLOCK..(plane + sites) * FIRST_BLOCK];
            for (output, known) in known.chunks_exact_mut(FIRST_BLOCK).enumerate() {
                let kernel = kernels.kernel_of[output * sites + input];
                let taps = &kernels.recent[kernel * RECENT + from..];
                add_scaled(simd, &mut known[first..], value, taps);
            }
        }
    }

    /// At the beginning of a block, what all earlier ones add to its steps, B₀ of
    /// them for every plane and site: the whole sums, as long as nothing is added
    /// within.
    pub(crate) fn next_block(&self) -> Option<&[f64]> {
        let begins = self.steps % FIRST_BLOCK == 0;
        begins.then_some(self.past.known.as_slice())
    }

    /// Ends a whole block without inputs.
    pub(crate) fn push_quiet_block(&mut self) {
        let steps = self.steps + FIRST_BLOCK;
        for inputs in &mut self.past.inputs {
            inputs.resize(steps, 0.0);
        }
        self.steps = steps;
        self.end_block();
    }

    /// All inputs of a plane and site so far.
    pub(crate) fn inputs(&self, plane: usize, site: usize) -> &[f64] {
        &self.past.inputs[plane * self.kernels.sites + site]
    }

    /// Computes what is known of the next block.
    fn end_block(&mut self) {
        let level = (self.kernels.levels.iter())
            .rposition(|level| self.steps % level.block == 0)
            .unwrap_or(0);
        for lower in &mut self.past.levels[..level] {
            lower.blocks = 0;
            lower.ready.fill(0.0);
        }
        self.transform_newest(level);
        let kernels = self.kernels;
        kernels.arch.dispatch(Multiply { past: self, level });
        for (channel, known) in self.past.known.chunks_exact_mut(FIRST_BLOCK).enumerate() {
            known.fill(0.0);
            for (level, past) in kernels.levels.iter().zip(&self.past.levels) {
                let from = channel * level.block + self.steps % level.block;
                let ready = &past.ready[from..from + FIRST_BLOCK];
                for (known, ready) in known.iter_mut().zip(ready) {
                    *known += ready;
                }
            }
        }
    }

    /// The spectra of the block that has just ended.
    fn transform_newest(&mut self, level: usize) {
        let (plan, past) = (&self.kernels.levels[level], &mut self.past.levels[level]);
        let (block, stride) = (plan.block, plan.stride());
        for (channel, inputs) in self.past.inputs.iter().enumerate() {
            let place = past.blocks * self.past.inputs.len() + channel;
            let begin = self.steps - block;
            past.is_active[place] = self.past.active_steps[channel] > begin;
            if past.is_active[place] {
                let window = &mut self.past.window[..2 * block];
                window[..block].copy_from_slice(&inputs[begin..]);
                window[block..].fill(0.0);
                let spectrum = &mut self.past.spectrum[..=block];
                let scratch = &mut self.past.scratch[..plan.forward.get_scratch_len()];
                transform(&*plan.forward, window, spectrum, scratch);
                split(
                    spectrum,
                    &mut past.spectra[place * stride..(place + 1) * stride],
                );
            }
        }
        past.blocks += 1;
    }

    /// What all blocks of a level add to the next one.
    #[inline(always)]
    fn multiply<S: Simd>(&mut self, simd: S, level: usize) {
        let (plan, past) = (&self.kernels.levels[level], &mut self.past.levels[level]);
        let (block, stride, sites) = (plan.block, plan.stride(), self.kernels.sites);
        let channels = self.planes * sites;
        let reach = past.blocks.min(plan.partitions);
        for output in 0..sites {
            let sums = &mut self.past.sums[..self.planes * stride];
            sums.fill(0.0);
            let mut is_zero = [true; 2];
            for partition in 0..reach {
                let newest = past.blocks - 1 - partition;
                for input in 0..sites {
                    let kernel = self.kernels.kernel_of[output * sites + input];
                    let place = kernel * plan.partitions + partition;
                    let kernel = &plan.spectra[place * stride..(place + 1) * stride];
                    for plane in 0..self.planes {
                        let place = newest * channels + plane * sites + input;
                        if !past.is_active[place] {
                            continue;
                        }
                        is_zero[plane] = false;
                        let sums = &mut sums[plane * stride..(plane + 1) * stride];
                        let spectrum = &past.spectra[place * stride..(place + 1) * stride];
                        add_product(simd, sums, kernel, spectrum);
                    }
                }
            }
            for plane in 0..self.planes {
                let from = (plane * sites + output) * block;
                let ready = &mut past.ready[from..from + block];
                if is_zero[plane] {
                    ready.fill(0.0);
                    continue;
                }
                let spectrum = &mut self.past.spectrum[..=block];
                join(&sums[plane * stride..(plane + 1) * stride], spectrum);
                let window = &mut self.past.window[..2 * block];
                let scratch = &mut self.past.scratch[..plan.inverse.get_scratch_len()];
                plan.inverse
                    .process_with_scratch(spectrum, window, scratch)
                    .expect("all buffers were made by the plan");
                ready.copy_from_slice(&window[block..]);
            }
        }
    }
}

/// [`Convolution::add_present`] with the instructions that the processor has. A closure in
/// its place is compiled apart, without them.
struct AddPresent<'a, 'b> {
    past: &'a mut Convolution<'b>,
    inputs: &'a [f64],
}

impl WithSimd for AddPresent<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        self.past.add_present(simd, self.inputs);
    }
}

/// [`Convolution::multiply`] in the same way.
struct Multiply<'a, 'b> {
    past: &'a mut Convolution<'b>,
    level: usize,
}

impl WithSimd for Multiply<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        self.past.multiply(simd, self.level);
    }
}

/// Adds a multiple of the values to whole lanes of sums.
#[inline(always)]
fn add_scaled<S: Simd>(simd: S, sums: &mut [f64], factor: f64, values: &[f64]) {
    let factor = simd.splat_f64s(factor);
    let (sums, _) = S::as_mut_simd_f64s(sums);
    let (values, _) = S::as_simd_f64s(values);
    for (sum, &value) in sums.iter_mut().zip(values) {
        *sum = simd.add_f64s(*sum, simd.mul_f64s(factor, value));
    }
}

/// Adds the product of two spectra, each as [`split`] leaves it.
#[inline(always)]
fn add_product<S: Simd>(simd: S, sums: &mut [f64], kernel: &[f64], input: &[f64]) {
    let block = sums.len() / 2;
    // What stands first in both parts is real, of the lowest and of the highest frequency.
    let ends = [0, block].map(|end| sums[end] + kernel[end] * input[end]);
    let (real, imaginary) = sums.split_at_mut(block);
    let (real, imaginary) = (
        S::as_mut_simd_f64s(real).0,
        S::as_mut_simd_f64s(imaginary).0,
    );
    let [kernel, input] = [kernel, input].map(|spectrum| {
        let (real, imaginary) = spectrum.split_at(block);
        std::iter::zip(S::as_simd_f64s(real).0, S::as_simd_f64s(imaginary).0)
    });
    let sums_of_lanes = real.iter_mut().zip(imaginary);
    for (((re, im), (&a, &b)), (&c, &d)) in sums_of_lanes.zip(kernel).zip(input) {
        let (real, imaginary) = (simd.mul_f64s(a, c), simd.mul_f64s(a, d));
        *re = simd.add_f64s(*re, simd.sub_f64s(real, simd.mul_f64s(b, d)));
        *im = simd.add_f64s(*im, simd.add_f64s(imaginary, simd.mul_f64s(b, c)));
    }
    (sums[0], sums[block]) = (ends[0], ends[1]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::convolution::Kernel;

    /// A cheap sequence without pattern, in (−1, 1).
    fn noise(seed: usize, count: usize) -> Vec<f64> {
        let mut state = seed as u64 * 2 + 1;
        let mut next = || {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
        };
        (0..count).map(|_| next()).collect()
    }

    /// The sum by blocks is the sum term by term, for kernels shorter and longer
    /// than the case, for quiet times, for one site and for several.
    #[test]
    fn the_sum_by_blocks_is_the_direct_sum() {
        for (sites, planes, taps, steps) in [
            (1, 1, 1, 100),
            (1, 1, 40, 400),
            (1, 2, 3000, 3000),
            (3, 2, 5000, 2500),
            (2, 1, 700, 9000),
            (9, 2, 1300, 1500),
            (1, 1, 20_000, 20_000),
        ] {
            let responses: Vec<Vec<Vec<f64>>> = (0..sites)
                .map(|output| {
                    (0..sites)
                        .map(|input| noise(7 + output * sites + input, taps))
                        .collect()
                })
                .collect();
            let kernels = Kernels::of(&responses);
            let direct: Vec<Vec<Kernel>> = (responses.iter())
                .map(|row| row.iter().map(|taps| Kernel::new(taps)).collect())
                .collect();
            let channels = planes * sites;
            let mut inputs: Vec<Vec<f64>> = (0..channels)
                .map(|channel| noise(100 + channel, steps))
                .collect();
            for channel in &mut inputs {
                // Quiet at first, and for a while between.
                let (from, to) = (steps / 3, steps / 2);
                channel[..steps / 5].fill(0.0);
                channel[from..to].fill(0.0);
            }
            let mut convolution = Convolution::new(&kernels, planes, steps);
            let mut sums = vec![0.0; channels];
            for step in 0..steps {
                convolution.write_past(&mut sums);
                // Each step costs the reference all of them: some are enough.
                if step % 17 == 0 || step + 50 > steps {
                    for (channel, sum) in sums.iter().enumerate() {
                        let (plane, output) = (channel / sites, channel % sites);
                        let expected: f64 = (0..sites)
                            .map(|input| {
                                let past = &inputs[plane * sites + input][..step];
                                direct[output][input].past_sum(past)
                            })
                            .sum();
                        let scale = (sites * step.min(taps)) as f64;
                        assert!(
                            (sum - expected).abs() <= 1e-13 * scale.max(1.0).sqrt() * 10.0,
                            "{sites} sites, {taps} taps, step {step}: {sum} {expected}"
                        );
                    }
                }
                let now: Vec<f64> = inputs.iter().map(|channel| channel[step]).collect();
                convolution.add(&now);
            }
            assert_eq!(
                convolution.inputs(planes - 1, sites - 1),
                inputs[channels - 1]
            );
        }
    }
}
