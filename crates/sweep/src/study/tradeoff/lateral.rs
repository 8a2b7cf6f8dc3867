//! Measures of the string in bending: Figs. 7(b), 12 and 14.

use std::f64::consts::TAU;
use std::time::Instant;

use anyhow::{Context, Result};
use linear::filters::radau;
use linear::method::FiniteElement;
use linear::waves::lateral::BendingNetwork;
use linear::{Method, RaisedCosine};
use sim::{LateralMeasures, LateralRegime, Stopping};

use super::configuration::{Configuration, Scheme};
use super::history::{Exact, greatest_difference, short_response};
use super::limit::{extrapolated, limit_between};
use super::measure::{Found, Measure, Reference};
use super::measured::{Measured, References, build, seconds_per_second};
use crate::engine::{Case, MethodSystem};
use crate::output::rolling_whirls;
use crate::plan::{LateralSettings, Sweep};
use crate::quantities::Axis;
use crate::study::scenes::shipped;
use crate::sweep_file::AutoOr;

/// Where the limit of whirl is looked for, coefficient of friction.
const LIMIT_BRACKET: [f64; 2] = [0.8, 3.0];

/// Sampling frequencies of the references, Hz.
const QUADRATURE_FREQUENCY: f64 = 10_240.0;
const ELEMENT_FREQUENCY: f64 = 5120.0;

/// Elements in a cell of the drillpipe, for the reference.
const REFERENCE_ELEMENTS: usize = 40;

/// A whole impulse needs this many samples.
const LEAST_SAMPLES: f64 = 3.0;

/// The string in bending, with what its measures should be.
pub struct Lateral {
    sweep: Sweep,
    settings: LateralSettings,
    pulse: RaisedCosine,
    time: f64,
    impulse_response: Exact,
    /// What each measure should be.
    pub references: References,
}

impl Lateral {
    /// Prepares the references of the measures wanted; `highest` is the highest
    /// sampling frequency, Hz.
    ///
    /// # Errors
    /// Where a reference cannot be computed.
    pub fn new(wanted: &[Measure], highest: f64) -> Result<Self> {
        let sweep = shipped("fig12.toml")?;
        let settings = sweep.setting.lateral.clone().context("fig12 has a wall")?;
        let impulse = settings.impulses.first().context("fig12 has an impulse")?;
        let AutoOr::Given(time) = sweep.time else {
            anyhow::bail!("fig12 has a time");
        };
        let mut lateral = Self {
            pulse: RaisedCosine {
                duration: impulse.impulse.duration,
            },
            time,
            impulse_response: Exact::none(),
            references: References::new(),
            sweep,
            settings,
        };
        lateral.add_closed_forms(wanted, highest)?;
        if wanted.contains(&Measure::WhirlLimit) {
            let reference = lateral.whirl_limit_reference()?;
            lateral.references.insert(Measure::WhirlLimit, reference);
        }
        Ok(lateral)
    }

    /// Whether a configuration samples the impulse.
    pub fn has(&self, configuration: &Configuration) -> bool {
        configuration.sampling_frequency * self.pulse.duration >= LEAST_SAMPLES
    }

    fn network(&self) -> Result<BendingNetwork<'_>> {
        let setting = &self.sweep.setting;
        let LateralSettings {
            bending, support, ..
        } = self.settings;
        let sites = &setting.sites;
        Ok(BendingNetwork::new(
            &setting.string,
            bending,
            support,
            sites,
        )?)
    }

    /// The exact waves give the impulse response and, by the balance of forces in
    /// steady whirl, all that Fig. 12 shows.
    fn add_closed_forms(&mut self, wanted: &[Measure], highest: f64) -> Result<()> {
        let network = self.network()?;
        let exact = wanted.contains(&Measure::LateralImpulse).then(|| {
            Exact::new(highest, self.time, |s| {
                network.receptance(s)[(0, 0)] * self.pulse.transform(s)
            })
        });
        let surface_speed = self.sweep.conditions.surface_speed();
        let surface_speed = surface_speed.context("fig12 has a surface speed")?;
        let whirls = rolling_whirls(&self.sweep.setting, &self.settings, 0, surface_speed)?;
        let whirl = whirls.first().context("there is no steady whirl")?;
        let values = [
            (Measure::LateralImpulse, 1.0),
            (Measure::WhirlRadius, whirl.radius),
            (Measure::WhirlRate, whirl.rate / TAU),
            (Measure::WhirlForce, whirl.normal_force),
        ];
        for (measure, value) in values {
            let reference = Reference {
                value,
                uncertainty: 0.0,
            };
            self.references.insert(measure, reference);
        }
        if let Some(exact) = exact {
            self.impulse_response = exact;
        }
        Ok(())
    }

    /// What quadrature and finite elements agree on, both extrapolated.
    fn whirl_limit_reference(&self) -> Result<Reference> {
        let limit = |method, sampling_frequency| {
            let configuration = Configuration {
                scheme: Scheme::Method(method),
                sampling_frequency,
            };
            let system = build(&self.sweep, &configuration, self.time)?;
            self.whirl_limit(&system)
                .context("there is no reference for the limit of whirl")
        };
        let elements = Method::FiniteElement(FiniteElement {
            elements_per_cell: REFERENCE_ELEMENTS,
            ..FiniteElement::default()
        });
        let one = extrapolated(
            limit(Method::Quadrature, QUADRATURE_FREQUENCY / 2.0)?,
            limit(Method::Quadrature, QUADRATURE_FREQUENCY)?,
            2,
        );
        // Numerical damping makes Newmark's scheme one of first order.
        let other = extrapolated(
            limit(elements, ELEMENT_FREQUENCY / 2.0)?,
            limit(elements, ELEMENT_FREQUENCY)?,
            1,
        );
        Ok(Reference {
            value: 0.5 * (one + other),
            uncertainty: 0.5 * (one / other - 1.0).abs(),
        })
    }

    /// Builds, times and measures one configuration.
    ///
    /// # Errors
    /// Where its responses cannot be built.
    pub fn measure(&self, configuration: &Configuration, wanted: &[Measure]) -> Result<Measured> {
        if configuration.scheme == Scheme::Radau {
            return self.measure_radau(configuration.sampling_frequency, wanted);
        }
        let system = build(&self.sweep, configuration, self.time)?;
        let case = self.case(&system, None)?;
        let whirl = whirl_of(&system, &case, Stopping::Full);
        let number = |measure, value| Found::number(measure, value, &self.references[&measure]);
        let of = |measure: &Measure| {
            let measure = *measure;
            Some(match measure {
                Measure::LateralImpulse => {
                    let taps = system.responses.bending()?.taps_between(0, 0)?;
                    self.impulse_error(taps, configuration.sampling_frequency)
                }
                Measure::WhirlRadius => number(measure, whirl.map(|whirl| whirl.mean_radius)),
                Measure::WhirlRate => {
                    number(measure, whirl.map(|whirl| -whirl.precession_rate / TAU))
                }
                Measure::WhirlForce => number(measure, whirl.map(|whirl| whirl.mean_normal_force)),
                Measure::WhirlLimit => number(measure, self.whirl_limit(&system)),
                _ => return None,
            })
        };
        Ok(Measured {
            build_seconds: system.build_seconds,
            step_seconds: Some(seconds_per_second(&system, &case)),
            found: wanted.iter().filter_map(of).collect(),
        })
    }

    fn impulse_error(&self, taps: &[f64], frequency: f64) -> Found {
        let samples = (self.pulse.duration * frequency).ceil() as usize;
        let pulse: Vec<f64> = (0..=samples)
            .map(|step| self.pulse.at(step as f64 / frequency))
            .collect();
        let steps = 0..self.impulse_response.count(frequency);
        let response: Vec<f64> = steps
            .map(|step| short_response(taps, &pulse, step))
            .collect();
        let exact = self.impulse_response.at(frequency, 0);
        let error = greatest_difference(&response, exact) / self.impulse_response.peak();
        Found::history(Measure::LateralImpulse, error)
    }

    /// The friction above which whirl starts, the impulse being that of Fig. 12.
    fn whirl_limit(&self, system: &MethodSystem) -> Option<f64> {
        let [low, high] = LIMIT_BRACKET;
        limit_between(low, high, |friction| {
            let case = self.case(system, Some(friction)).ok()?;
            let outcome = system.simulate(&case, Stopping::Early, None).ok()?;
            Some(outcome.lateral?.regime == LateralRegime::BackwardWhirl)
        })
    }

    fn case(&self, system: &MethodSystem, friction: Option<f64>) -> Result<Case> {
        let conditions = match friction {
            Some(friction) => self.sweep.conditions.with(Axis::Friction, friction),
            None => self.sweep.conditions,
        };
        Case::under(&self.sweep, &system.setting, 0, Vec::new(), &conditions)
            .map_err(anyhow::Error::msg)
    }

    fn measure_radau(&self, frequency: f64, wanted: &[Measure]) -> Result<Measured> {
        let network = self.network()?;
        let count = self.impulse_response.count(frequency);
        let start = Instant::now();
        let taps = radau::taps(frequency, count, &|s| network.receptance(s)[(0, 0)]);
        let build_seconds = start.elapsed().as_secs_f64();
        let mut response = vec![0.0; count];
        for (stage, place) in radau::STAGES.into_iter().enumerate() {
            let samples = (self.pulse.duration * frequency).ceil() as usize;
            let pulse: Vec<f64> = (0..=samples)
                .map(|step| self.pulse.at((step as f64 + place) / frequency))
                .collect();
            for (step, value) in response.iter_mut().enumerate() {
                *value += short_response(&taps[2 + stage], &pulse, step);
            }
        }
        let exact = self.impulse_response.at(frequency, 1);
        let error = greatest_difference(&response, exact) / self.impulse_response.peak();
        let found = Found::history(Measure::LateralImpulse, error);
        Ok(Measured::by_radau(build_seconds, wanted, found))
    }
}

/// Measures of whirl; none where the case gives no answer or another regime.
fn whirl_of(system: &MethodSystem, case: &Case, stopping: Stopping) -> Option<LateralMeasures> {
    let outcome = system.simulate(case, stopping, None).ok()?;
    (outcome.lateral).filter(|lateral| lateral.regime == LateralRegime::BackwardWhirl)
}
