//! The spectrum of two sines.

use crate::histories::spectrum::{Spectrogram, spectrogram};

const SAMPLING: f64 = 200.0;

/// Two sines, the second of which begins half-way.
fn two_sines(frequencies: [f64; 2], amplitudes: [f64; 2], seconds: f64) -> Vec<f64> {
    let steps = (seconds * SAMPLING) as usize;
    let value = |step: usize| {
        let time = step as f64 / SAMPLING;
        let sine = |of: usize| {
            amplitudes[of] * (std::f64::consts::TAU * frequencies[of] * time + 0.3).sin()
        };
        let second = if time < 0.5 * seconds { 0.0 } else { sine(1) };
        120.0 + sine(0) + second
    };
    (0..steps).map(value).collect()
}

/// The band of a frequency.
fn band_of(found: &Spectrogram, frequency: f64) -> usize {
    found.frequencies.partition_point(|edge| *edge <= frequency) - 1
}

/// Sines of 0.7 and 23 Hz with amplitudes 60 and 5 on a mean of 120, at frequencies between
/// lines: each has its amplitude at its frequency, to the 4 % of the window, in the time in
/// which it is there, and nothing else is seen at a frequency that neither has.
#[test]
fn val_two_sines_have_their_amplitudes_at_their_frequencies() {
    for (low, high) in [(0.7, 23.0), (0.7123, 22.87), (0.8, 80.3)] {
        let values = two_sines([low, high], [60.0, 5.0], 60.0);
        let found = spectrogram(&values, SAMPLING, 10.0).expect("long enough");
        let stretches = found.times.len() - 1;
        let bands = found.frequencies.len() - 1;
        let half = 0.5 * found.stretch;
        let at = |stretch: usize, frequency: f64| {
            found.amplitudes[stretch * bands + band_of(&found, frequency)]
        };
        for stretch in 0..stretches {
            let near = (at(stretch, low) / 60.0 - 1.0).abs();
            assert!(near < 0.04, "{low} Hz: {near} at stretch {stretch}");
            assert!(at(stretch, 5.0) < 0.05, "{}", at(stretch, 5.0));
            let middle = 0.5 * (found.times[stretch] + found.times[stretch + 1]);
            if middle + half < 30.0 {
                assert!(at(stretch, high) < 0.02, "{}", at(stretch, high));
            } else if middle - half > 30.0 {
                let near = (at(stretch, high) / 5.0 - 1.0).abs();
                assert!(near < 0.04, "{high} Hz: {near} at stretch {stretch}");
            }
        }
        let first = 0.5 * (found.times[0] + found.times[1]);
        assert!((first - half).abs() < 0.01, "{first}");
        assert!(found.frequencies[0] * found.stretch < 2.0);
        assert!((found.frequencies[bands] - 100.0).abs() < 1e-9);
        assert!(stretches > 50, "{stretches}");
    }
}
