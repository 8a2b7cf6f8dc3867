//! Amplitudes over time and frequency, from short stretches of a history.
//!
//! Each stretch, less its mean, is weighted by a Hann window $w$ and transformed:
//! $A_k = 2 |X_k| / \sum w$, so that a sine of any frequency between the second line and the last
//! has its own amplitude at its line, to 4 % between two lines (each stretch is transformed with as
//! many zeros). Bands, even in the logarithm of the frequency, show the largest line within.

use linear::fft;

/// Stretches at most: a picture shows no more.
const MOST_STRETCHES: usize = 80;

/// The least number of stretches, and of steps in each.
const FEWEST_STRETCHES: usize = 8;
const LEAST_STEPS: usize = 32;

/// Bands of frequencies.
const BANDS: usize = 48;

/// Turns in a stretch of the lowest frequency that is shown.
const LEAST_TURNS: f64 = 1.5;

/// Amplitudes over time and frequency.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrogram {
    /// How long a stretch is, s.
    pub stretch: f64,
    /// The lines between the middles of stretches, s from the first value.
    pub times: Vec<f64>,
    /// The lines between bands, Hz.
    pub frequencies: Vec<f64>,
    /// Amplitudes, stretch by stretch, each band by band from the lowest.
    pub amplitudes: Vec<f64>,
}

/// Of values at even steps with a sampling frequency in Hz, in stretches of about a time in s;
/// none where there are too few.
pub fn spectrogram(values: &[f64], sampling: f64, stretch: f64) -> Option<Spectrogram> {
    // Lengths without large prime factors are transformed fast.
    let steps = (stretch * sampling / LEAST_STEPS as f64).round() as usize * LEAST_STEPS;
    let others = values.len().checked_sub(steps)?;
    if steps < LEAST_STEPS || others < FEWEST_STRETCHES || values.iter().any(|it| !it.is_finite()) {
        return None;
    }
    let hop = others.div_ceil(MOST_STRETCHES).max(1);
    let stretches = others / hop + 1;
    let stretch = steps as f64 / sampling;
    let [lowest, highest] = [LEAST_TURNS / stretch, 0.5 * sampling];
    let ratio = highest / lowest;
    let edge = |band: usize| lowest * ratio.powf(band as f64 / BANDS as f64);
    let frequencies: Vec<f64> = (0..=BANDS).map(edge).collect();
    let length = 2 * steps;
    let bands: Vec<[usize; 2]> = (frequencies.windows(2))
        .map(|ends| lines_within([ends[0], ends[1]], sampling / length as f64, length / 2))
        .collect();
    let window: Vec<f64> = (0..steps)
        .map(|step| 0.5 - 0.5 * (std::f64::consts::TAU * step as f64 / steps as f64).cos())
        .collect();
    let weight: f64 = window.iter().sum();
    let transform = fft::forward(length);
    let mut input = transform.make_input_vec();
    let mut lines = transform.make_output_vec();
    let mut scratch = transform.make_scratch_vec();
    let mut amplitudes = Vec::with_capacity(stretches * BANDS);
    for place in 0..stretches {
        let values = &values[place * hop..place * hop + steps];
        let products = values.iter().zip(&window).map(|(value, part)| value * part);
        let mean = products.sum::<f64>() / weight;
        input.fill(0.0);
        for ((input, value), part) in input.iter_mut().zip(values).zip(&window) {
            *input = (value - mean) * part;
        }
        // Lengths are those of the plan.
        transform
            .process_with_scratch(&mut input, &mut lines, &mut scratch)
            .ok()?;
        amplitudes.extend(bands.iter().map(|&[first, last]| {
            let largest = lines[first..=last].iter().map(|line| line.norm());
            2.0 * largest.fold(0.0, f64::max) / weight
        }));
    }
    let half = 0.5 * hop as f64;
    let middle = |place: usize| (0.5 * steps as f64 + (place * hop) as f64 - half) / sampling;
    Some(Spectrogram {
        stretch,
        times: (0..=stretches).map(middle).collect(),
        frequencies,
        amplitudes,
    })
}

/// The first and the last line of a transform in a band, by their distance; where it has none, the
/// nearest.
fn lines_within([from, to]: [f64; 2], distance: f64, last: usize) -> [usize; 2] {
    let first = (from / distance).ceil() as usize;
    let beyond = (to / distance).ceil() as usize;
    if first < beyond {
        return [first.min(last), (beyond - 1).min(last)];
    }
    let nearest = ((from * to).sqrt() / distance).round() as usize;
    [nearest.min(last); 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SAMPLING: f64 = 200.0;

    #[test]
    fn a_history_that_is_too_short_or_not_finite_has_no_spectrogram() {
        assert_eq!(spectrogram(&[1.0; 100], SAMPLING, 10.0), None);
        assert_eq!(spectrogram(&[1.0; 300], SAMPLING, 0.05), None);
        let mut values = vec![1.0; 3000];
        assert!(spectrogram(&values, SAMPLING, 5.0).is_some());
        values[7] = f64::NAN;
        assert_eq!(spectrogram(&values, SAMPLING, 5.0), None);
    }
}
