//! The linear system of each method, built once for all cases.

use std::time::Instant;

use anyhow::{Context, Result};
use linear::passivity::STABLE_MARGIN;
use linear::{BuildError, Method, TorsionRequest, TorsionResponses, torsion_responses};
use sim::{System, simulate};

use super::case::{Case, Row, RowOutcome};
use crate::spec::Sweep;

/// One method's responses, ready to simulate with, and what is known of them.
#[derive(Debug)]
pub struct MethodSystem {
    /// The method.
    pub method: Method,
    /// Its impulse responses.
    pub responses: TorsionResponses,
    /// Positive-real margin; `None` where no torque acts.
    pub margin: Option<f64>,
    /// Time to build, s.
    pub build_seconds: f64,
    system: System,
}

impl MethodSystem {
    /// Builds the system of every method of a sweep, long enough for all
    /// cases.
    ///
    /// # Errors
    /// Where a method cannot treat the string.
    pub fn build_all(sweep: &Sweep, cases: &[Case]) -> Result<Vec<Self>> {
        let longest_time = cases
            .iter()
            .map(|case| case.scene.timing.duration)
            .fold(0.0, f64::max);
        let bit = sweep.sites.len() - 1;
        let request = TorsionRequest {
            sites: sweep.sites.clone(),
            torque_inputs: sweep.bit.iter().map(|_| bit).collect(),
            sampling_frequency: sweep.sampling_frequency,
            longest_time,
        };
        sweep
            .methods
            .iter()
            .map(|method| {
                Self::build(sweep, *method, &request)
                    .with_context(|| format!("the responses by {} cannot be built", method.name()))
            })
            .collect()
    }

    fn build(sweep: &Sweep, method: Method, request: &TorsionRequest) -> Result<Self, BuildError> {
        let start = Instant::now();
        let responses = torsion_responses(&sweep.string, &method, request)?;
        let build_seconds = start.elapsed().as_secs_f64();
        Ok(Self {
            method,
            margin: responses.margin()?,
            build_seconds,
            system: System::new(&responses),
            responses,
        })
    }

    /// Whether the margin says that a sticking bit chatters.
    pub fn is_unstable(&self) -> bool {
        self.margin.is_some_and(|margin| margin < STABLE_MARGIN)
    }

    /// The system that simulations step.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// Taps of the bit's driving point, where a torque acts there.
    pub fn driving_point(&self) -> Option<&[f64]> {
        let site = *self.responses.torque_inputs.first()?;
        Some(&self.responses.from_torque[site][0])
    }

    /// Simulates one case.
    pub fn run(&self, case: &Case) -> Row {
        let outcome = match simulate(&self.system, &case.scene, None) {
            Ok(outcome) => RowOutcome::Done(outcome),
            Err(error) => RowOutcome::Failed(error.to_string()),
        };
        Row {
            case: case.index,
            method: self.method.name(),
            values: case.values.clone(),
            torque_dynamic_nm: case.torque_dynamic_nm,
            outcome,
        }
    }
}
