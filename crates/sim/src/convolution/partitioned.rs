//! The sum over the past by blocks, each as a product of spectra, without
//! delay: convolution in nested partitions.
//!
//! Time is cut into blocks of B₀ steps, eight of which make a block of the next
//! level, and so on. Where a block of some level ends (of the highest, where
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
use realfft::num_complex::Complex;

use super::kernels::{Kernels, split, transform};
use super::partition::{FIRST_BLOCK, LANES};
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
    /// The empty past of a case of at most so many steps.
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

    fn check(&self, channels: &[f64]) -> Result<(), ResponseError> {
        if channels.len() == self.past.inputs.len() {
            Ok(())
        } else {
            Err(ResponseError::Shape)
        }
    }

    /// The same, for so many sums.
    pub(crate) fn write_past(&self, sums: &mut [f64]) {
        self.kernels.arch.dispatch(|| self.add_present(sums));
    }

    #[inline(always)]
    fn add_present(&self, sums: &mut [f64]) {
        let sites = self.kernels.sites;
        let within = self.steps % FIRST_BLOCK;
        let newest = FIRST_BLOCK - within;
        // Those yet to come are zero.
        let reach = within.next_multiple_of(LANES);
        // Nested, for a division of each place would cost as much as its sum.
        let known = self.past.known.chunks_exact(FIRST_BLOCK);
        let mut places = sums.iter_mut().zip(known);
        for plane in 0..self.planes {
            for (output, (sum, known)) in (0..sites).zip(&mut places) {
                *sum = known[within];
                for input in 0..sites {
                    let channel = plane * sites + input;
                    if self.past.is_active[channel] {
                        let taps = &self.kernels.recent[output * sites + input];
                        let inputs = &self.past.present[channel * FIRST_BLOCK..];
                        *sum += dot(&taps[newest..newest + reach], &inputs[..reach]);
                    }
                }
            }
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

    /// The same, for so many inputs.
    pub(crate) fn add(&mut self, inputs: &[f64]) {
        let within = self.steps % FIRST_BLOCK;
        for (channel, &input) in inputs.iter().enumerate() {
            self.past.inputs[channel].push(input);
            self.past.present[channel * FIRST_BLOCK + within] = input;
            self.past.is_active[channel] |= input != 0.0;
        }
        self.steps += 1;
        if self.steps.is_multiple_of(FIRST_BLOCK) {
            self.end_block();
        }
    }

    /// At the beginning of a block, what all earlier ones add to its steps, B₀ of
    /// them for every plane and site: the whole sums, as long as nothing is added
    /// within.
    pub(crate) fn next_block(&self) -> Option<&[f64]> {
        let begins = self.steps.is_multiple_of(FIRST_BLOCK);
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

    /// The responses that are summed.
    pub(crate) fn kernels(&self) -> &'a Kernels {
        self.kernels
    }

    /// All inputs of a plane and site so far.
    pub(crate) fn inputs(&self, plane: usize, site: usize) -> &[f64] {
        &self.past.inputs[plane * self.kernels.sites + site]
    }

    /// Computes what is known of the next block.
    fn end_block(&mut self) {
        let level = (self.kernels.levels.iter())
            .rposition(|level| self.steps.is_multiple_of(level.block))
            .unwrap_or(0);
        for lower in &mut self.past.levels[..level] {
            lower.blocks = 0;
            lower.ready.fill(0.0);
        }
        self.transform_newest(level);
        let kernels = self.kernels;
        kernels.arch.dispatch(|| self.multiply(level));
        self.past.is_active.fill(false);
        self.past.present.fill(0.0);
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
            let newest = &inputs[self.steps - block..];
            past.is_active[place] = newest.iter().any(|&input| input != 0.0);
            if past.is_active[place] {
                let window = &mut self.past.window[..2 * block];
                window[..block].copy_from_slice(newest);
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
    fn multiply(&mut self, level: usize) {
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
                    let pair = (output * sites + input) * plan.partitions + partition;
                    let kernel = &plan.spectra[pair * stride..(pair + 1) * stride];
                    for plane in 0..self.planes {
                        let place = newest * channels + plane * sites + input;
                        if past.is_active[place] {
                            is_zero[plane] = false;
                            add_product(
                                &mut sums[plane * stride..(plane + 1) * stride],
                                kernel,
                                &past.spectra[place * stride..(place + 1) * stride],
                            );
                        }
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
                let (real, imaginary) =
                    sums[plane * stride..(plane + 1) * stride].split_at(block + 1);
                let spectrum = &mut self.past.spectrum[..=block];
                for ((value, &re), &im) in spectrum.iter_mut().zip(real).zip(imaginary) {
                    *value = Complex::new(re, im);
                }
                // Of a real signal; rounding may have left something.
                (spectrum[0].im, spectrum[block].im) = (0.0, 0.0);
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

/// Adds the product of two spectra, each with its real parts first.
#[inline(always)]
fn add_product(sums: &mut [f64], kernel: &[f64], input: &[f64]) {
    let count = sums.len() / 2;
    let (sum_re, sum_im) = sums.split_at_mut(count);
    let (kernel_re, kernel_im) = kernel.split_at(count);
    let (input_re, input_im) = input.split_at(count);
    for index in 0..count {
        let (a, b) = (kernel_re[index], kernel_im[index]);
        let (c, d) = (input_re[index], input_im[index]);
        sum_re[index] += a * c - b * d;
        sum_im[index] += a * d + b * c;
    }
}

/// Scalar product of whole lanes in a fixed order, so that results are the same everywhere.
#[inline(always)]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    for (x, y) in a.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    // In pairs, for each of eight additions in a row would wait for the last.
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + e) + (c + g)) + ((b + f) + (d + h))
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
