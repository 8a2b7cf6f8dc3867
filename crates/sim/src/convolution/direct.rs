//! The sum as it is written, term by term.

/// Taps prepared for summing, shared by every case.
#[derive(Debug, Clone)]
pub struct Kernel {
    instant: f64,
    /// Taps 1, 2, … with the latest first, so that both factors of the sum run
    /// through memory in the same direction.
    reversed: Vec<f64>,
}

impl Kernel {
    /// Prepares the taps A(0), A(1), … of one response.
    pub fn new(taps: &[f64]) -> Self {
        Self {
            instant: taps.first().copied().unwrap_or(0.0),
            reversed: taps.iter().skip(1).rev().copied().collect(),
        }
    }

    /// A(0): the response within the step of the input.
    pub fn instant(&self) -> f64 {
        self.instant
    }

    /// How many inputs before the present one it looks at.
    pub fn memory(&self) -> usize {
        self.reversed.len()
    }

    /// Σ A(k − n) E(n) over the past, n < k, for the inputs E(0) … E(k − 1).
    pub fn past_sum(&self, inputs: &[f64]) -> f64 {
        let reach = inputs.len().min(self.reversed.len());
        let taps = &self.reversed[self.reversed.len() - reach..];
        dot(taps, &inputs[inputs.len() - reach..])
    }
}

/// Terms that are added up side by side.
const LANES: usize = 16;

/// Scalar product in a fixed order, so that results are the same everywhere,
/// with enough independent sums for the processor to work in parallel.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (a_blocks, b_blocks) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest = std::iter::zip(a_blocks.remainder(), b_blocks.remainder());
    for (sum, (x, y)) in sums.iter_mut().zip(rest) {
        *sum = x * y;
    }
    for (x, y) in a_blocks.zip(b_blocks) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    let mut left = LANES;
    while left > 1 {
        left /= 2;
        for lane in 0..left {
            sums[lane] += sums[left + lane];
        }
    }
    sums[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_past_sum_is_the_convolution_without_its_newest_term() {
        let taps: Vec<f64> = (0..37).map(|n| 1.0 / (n as f64 + 1.0)).collect();
        let inputs: Vec<f64> = (0..100).map(|n| ((n * n) % 17) as f64 - 8.0).collect();
        let kernel = Kernel::new(&taps);
        for step in 0..inputs.len() {
            let expected: f64 = (1..taps.len())
                .filter(|&lag| lag <= step)
                .map(|lag| taps[lag] * inputs[step - lag])
                .sum();
            assert!((kernel.past_sum(&inputs[..step]) - expected).abs() < 1e-12);
        }
    }
}
