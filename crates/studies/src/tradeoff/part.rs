//! A part of the study: the string in torsion, or in bending.

use std::collections::BTreeMap;
use std::time::Instant;

use anyhow::{Context, Result};
use linear::Method;
use sim::{Outcome, Stopping};

use super::configuration::{Configuration, Scheme};
use super::history::History;
use super::measure::Measure;
use super::row::{Reference, TradeoffRow, extrapolated};
use campaign::accuracy::trial;
use campaign::engine::{Case, MethodSystem, Recipe};
use campaign::plan::Sweep;

/// A timing is the best of this many.
const REPEATS: usize = 5;

/// Timing stops after this long, s.
const LONGEST_TIMING: f64 = 0.5;

/// A step of Radau quadrature sums over the past four times, from both stages to
/// both.
const RADAU_SUMS: f64 = 4.0;

/// A whole impulse needs this many samples.
const LEAST_SAMPLES: f64 = 3.0;

/// A scene whose measures are compared.
pub struct Part {
    /// The scene.
    pub sweep: Sweep,
    /// How long its longest case lasts, s.
    pub longest: f64,
    /// How long its shortest impulse lasts, s; infinite where it has none.
    pub impulse_duration: f64,
    /// The highest sampling frequency that it is measured at, Hz.
    pub highest: f64,
    /// The time that is to be a whole number of steps, s, where one is.
    pub whole_steps_of: Option<f64>,
    /// The measure that is a whole history, if it is wanted.
    pub history: Option<(Measure, History)>,
    /// What the measures wanted should be.
    pub references: BTreeMap<Measure, Reference>,
    /// A measure that is one number, from a method's system and what it makes of the
    /// scene; `None` where there is no answer.
    pub number: fn(&Sweep, &MethodSystem, Option<Outcome>, Measure) -> Option<f64>,
}

impl Part {
    /// Whether a configuration is measured, and samples the impulse.
    pub fn has(&self, configuration: &Configuration) -> bool {
        let frequency = configuration.sampling_frequency;
        frequency <= self.highest && frequency * self.impulse_duration >= LEAST_SAMPLES
    }

    /// A frequency as it is for this scene, Hz: the one next to it of which a time is a
    /// whole number of steps.
    pub fn fitted_frequency(&self, frequency: f64) -> f64 {
        let fitted = |time: f64| (frequency * time).round().max(1.0) / time;
        self.whole_steps_of.map_or(frequency, fitted)
    }

    fn system(&self, method: Method, sampling_frequency: f64) -> Result<MethodSystem> {
        let setting = self.sweep.setting.sampled_at(sampling_frequency);
        Recipe::of(&self.sweep, &setting, method, self.longest).build()
    }

    /// Some measures by a method, for references.
    ///
    /// # Errors
    /// Where the method does not answer one of them.
    pub fn numbers(
        &self,
        method: Method,
        sampling_frequency: f64,
        measures: &[Measure],
    ) -> Result<Vec<f64>> {
        self.numbers_of(&self.system(method, sampling_frequency)?, measures)
    }

    /// Some measures of a system, for references.
    ///
    /// # Errors
    /// Where it does not answer one of them.
    pub fn numbers_of(&self, system: &MethodSystem, measures: &[Measure]) -> Result<Vec<f64>> {
        let sweep = &self.sweep;
        let outcome = trial::outcome(sweep, system, &sweep.conditions, Stopping::Full).ok();
        let number = |measure: &Measure| {
            (self.number)(sweep, system, outcome, *measure)
                .with_context(|| format!("there is no reference for {}", measure.name()))
        };
        measures.iter().map(number).collect()
    }

    /// The same, extrapolated with the order that the method has from half of the
    /// frequency and all of it.
    ///
    /// # Errors
    /// As [`Part::numbers`].
    pub fn extrapolated_numbers(
        &self,
        method: Method,
        sampling_frequency: f64,
        order: i32,
        measures: &[Measure],
    ) -> Result<Vec<f64>> {
        let coarse = self.numbers(method, 0.5 * sampling_frequency, measures)?;
        let fine = self.numbers(method, sampling_frequency, measures)?;
        let pairs = coarse.into_iter().zip(fine);
        Ok(pairs
            .map(|(coarse, fine)| extrapolated(coarse, fine, order))
            .collect())
    }

    /// Builds, times and measures one configuration, after that of quadrature at its
    /// frequency.
    ///
    /// # Errors
    /// Where its responses cannot be built.
    pub fn measure(
        &self,
        configuration: &Configuration,
        rows: &mut Vec<TradeoffRow>,
    ) -> Result<()> {
        match configuration.scheme {
            Scheme::Method(method) => self.by_method(configuration, method, rows),
            Scheme::Radau => self.by_radau(configuration, rows),
        }
    }

    fn by_method(
        &self,
        configuration: &Configuration,
        method: Method,
        rows: &mut Vec<TradeoffRow>,
    ) -> Result<()> {
        let configuration = Configuration {
            sampling_frequency: self.fitted_frequency(configuration.sampling_frequency),
            ..*configuration
        };
        let system = self.system(method, configuration.sampling_frequency)?;
        let case = trial::case(&self.sweep, &system.setting, &self.sweep.conditions)?;
        let (step_seconds, outcome) = timed(&system, &case);
        for (&measure, &reference) in &self.references {
            let (value, error) = match &self.history {
                Some((of, history)) if *of == measure => (None, history.error(&system)),
                _ => {
                    let value = (self.number)(&self.sweep, &system, outcome, measure);
                    let error = value.map(|value| (value / reference.value - 1.0).abs());
                    (value, error)
                }
            };
            rows.push(TradeoffRow {
                measure,
                configuration,
                value,
                reference,
                error,
                build_seconds: system.build_seconds,
                step_seconds,
            });
        }
        Ok(())
    }

    /// Radau quadrature simulates nothing: only a history can be compared.
    fn by_radau(&self, configuration: &Configuration, rows: &mut Vec<TradeoffRow>) -> Result<()> {
        let Some((measure, history)) = &self.history else {
            return Ok(());
        };
        let frequency = configuration.sampling_frequency;
        let quadrature = rows.iter().find(|row| {
            row.measure == *measure
                && row.configuration.scheme == Scheme::Method(Method::Quadrature)
                && row.configuration.sampling_frequency == frequency
        });
        let quadrature = quadrature.context("quadrature is measured first")?;
        let step_seconds = RADAU_SUMS * quadrature.step_seconds;
        let (build_seconds, error) = history.by_radau(frequency)?;
        rows.push(TradeoffRow {
            measure: *measure,
            configuration: *configuration,
            value: None,
            reference: self.references[measure],
            error,
            build_seconds,
            step_seconds,
        });
        Ok(())
    }
}

/// Time to simulate a second of a case, every step of it, s, the best of some; and what
/// comes of the case.
fn timed(system: &MethodSystem, case: &Case) -> (f64, Option<Outcome>) {
    let begun = Instant::now();
    let (mut best, mut outcome) = (f64::INFINITY, None);
    for _ in 0..REPEATS {
        let start = Instant::now();
        // Without an answer too it took its time.
        outcome = system.simulate(case, Stopping::Full, None).ok();
        best = best.min(start.elapsed().as_secs_f64());
        if begun.elapsed().as_secs_f64() > LONGEST_TIMING {
            break;
        }
    }
    (best / case.scene.timing.duration, outcome)
}
