//! Measures of the string in torsion: Figs. 7(a), 8(b) and 9.

use std::time::Instant;

use anyhow::{Context, Result};
use linear::Complex64;
use linear::estimates::{largest_undershoot, torsional_stiffness, torsional_travel_time};
use linear::filters::radau;
use linear::method::Transform;
use linear::waves::inversion::time_response;
use linear::waves::network::TorsionNetwork;
use linear::{Method, RaisedCosine};
use sim::{Stopping, TorsionMeasures, TorsionRegime};

use super::configuration::{Configuration, Scheme};
use super::history::{Exact, greatest_difference, smooth_step_response};
use super::limit::{extrapolated, limit_between};
use super::measure::{Found, Measure, Reference};
use super::measured::{Measured, References, build, seconds_per_second};
use crate::engine::{Case, MethodSystem};
use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::study::scenes::shipped;
use crate::sweep_file::AutoOr;

/// A step is looked at through a window of this length, s: a jump is in no
/// method's band, and its largest error would never fall.
const STEP_WINDOW: f64 = 0.1;

/// Time compared after a step, s: eight round trips of a wave.
const STEP_TIME: f64 = 5.0;

/// The narrowest window through which the undershoot is looked at, s. The string
/// has details down to the half metre of a joint, which a wave passes in 0.16 ms.
const UNDERSHOOT_WINDOW: f64 = 1e-4;

/// Samples in a window of the exact response.
const SAMPLES_PER_WINDOW: f64 = 8.0;

/// Where the limit of stick-slip is looked for, rpm per kN m.
const LIMIT_BRACKET: [f64; 2] = [0.03, 0.12];

/// Sampling frequency of the references, Hz: a wave moves by 2 cm in a sample.
const REFERENCE_FREQUENCY: f64 = 163_840.0;

/// Transform behind the reference filter, s.
const REFERENCE_TRANSFORM: f64 = 20.0;

/// The string in torsion, with what its measures should be.
pub struct Torsion {
    sweep: Sweep,
    longest: f64,
    surface_step: Exact,
    /// What each measure should be.
    pub references: References,
}

impl Torsion {
    /// Prepares the references of the measures wanted; `highest` is the highest
    /// sampling frequency, Hz.
    ///
    /// # Errors
    /// Where a reference cannot be computed.
    pub fn new(wanted: &[Measure], highest: f64) -> Result<Self> {
        let sweep = shipped("fig08b.toml")?;
        let mut torsion = Self {
            longest: longest_time(&sweep)?,
            surface_step: Exact::none(),
            references: References::new(),
            sweep,
        };
        torsion.add_linear_references(wanted, highest)?;
        let nonlinear = [Measure::FirstSlip, Measure::Period, Measure::StickSlipLimit];
        if nonlinear.iter().any(|measure| wanted.contains(measure)) {
            torsion.add_nonlinear_references(wanted, &nonlinear)?;
        }
        Ok(torsion)
    }

    fn add_linear_references(&mut self, wanted: &[Measure], highest: f64) -> Result<()> {
        let string = &self.sweep.setting.string;
        let closed_form = |value| Reference {
            value,
            uncertainty: 0.0,
        };
        for measure in wanted {
            let reference = match measure {
                Measure::SurfaceStep => {
                    let network = TorsionNetwork::new(string, &self.sweep.setting.sites)?;
                    let window = RaisedCosine {
                        duration: STEP_WINDOW,
                    };
                    self.surface_step = Exact::new(highest, STEP_TIME, |s| {
                        network.admittance(s).from_surface[0] * window.transform(s) / s
                    });
                    closed_form(1.0)
                }
                Measure::SteadySpeed => closed_form(1.0),
                Measure::StaticStiffness => closed_form(torsional_stiffness(string)),
                Measure::Undershoot => self.exact_undershoot()?,
                _ => continue,
            };
            self.references.insert(*measure, reference);
        }
        Ok(())
    }

    /// Δ of the exact response, through ever narrower windows.
    fn exact_undershoot(&self) -> Result<Reference> {
        let string = &self.sweep.setting.string;
        let network = TorsionNetwork::new(string, &self.sweep.setting.sites)?;
        let round_trips = 6.0 * torsional_travel_time(string);
        let through = |duration: f64| {
            let (window, step) = (RaisedCosine { duration }, duration / SAMPLES_PER_WINDOW);
            let response = |s: Complex64| {
                let admittance = network.admittance(s).from_torque[(0, 0)];
                admittance * window.transform(s) / s
            };
            let count = (round_trips / step).ceil() as usize;
            let speeds = time_response(response, step, count, 2);
            -speeds.into_iter().fold(f64::INFINITY, f64::min)
        };
        let (wide, narrow) = (through(2.0 * UNDERSHOOT_WINDOW), through(UNDERSHOOT_WINDOW));
        Ok(Reference {
            value: narrow,
            uncertainty: (narrow / wide - 1.0).abs(),
        })
    }

    /// What two methods that share no discretisation agree on at a frequency far
    /// above the ladder: quadrature, extrapolated, and the digital filter.
    fn add_nonlinear_references(
        &mut self,
        wanted: &[Measure],
        nonlinear: &[Measure],
    ) -> Result<()> {
        let numbers = |method, sampling_frequency| {
            let scheme = Scheme::Method(method);
            let configuration = Configuration {
                scheme,
                sampling_frequency,
            };
            let system = build(&self.sweep, &configuration, self.longest)?;
            let answers = self.nonlinear(&system, wanted)?;
            anyhow::Ok(answers)
        };
        let coarse = numbers(Method::Quadrature, REFERENCE_FREQUENCY / 2.0)?;
        let fine = numbers(Method::Quadrature, REFERENCE_FREQUENCY)?;
        let filter = numbers(
            Method::Hilbert(Transform {
                seconds: Some(REFERENCE_TRANSFORM),
            }),
            REFERENCE_FREQUENCY,
        )?;
        for measure in nonlinear.iter().filter(|measure| wanted.contains(measure)) {
            let of = |answers: &[(Measure, Option<f64>)]| {
                let found = answers.iter().find(|(known, _)| known == measure);
                found
                    .and_then(|(_, value)| *value)
                    .with_context(|| format!("there is no reference for {}", measure.name()))
            };
            // Where the torque jumps, the order is the first.
            let (one, other) = (extrapolated(of(&coarse)?, of(&fine)?, 1), of(&filter)?);
            let reference = Reference {
                value: 0.5 * (one + other),
                uncertainty: 0.5 * (one / other - 1.0).abs() + 1.0 / REFERENCE_FREQUENCY,
            };
            self.references.insert(*measure, reference);
        }
        Ok(())
    }

    /// Builds, times and measures one configuration.
    ///
    /// # Errors
    /// Where its responses cannot be built.
    pub fn measure(&self, configuration: &Configuration, wanted: &[Measure]) -> Result<Measured> {
        if configuration.scheme == Scheme::Radau {
            return self.measure_radau(configuration.sampling_frequency, wanted);
        }
        let system = build(&self.sweep, configuration, self.longest)?;
        let case = self.case(&system, None)?;
        let mut found = self.linear(&system, wanted);
        for (measure, value) in self.nonlinear(&system, wanted)? {
            found.push(Found::number(measure, value, &self.references[&measure]));
        }
        Ok(Measured {
            build_seconds: system.build_seconds,
            step_seconds: Some(seconds_per_second(&system, &case)),
            found,
        })
    }

    fn linear(&self, system: &MethodSystem, wanted: &[Measure]) -> Vec<Found> {
        let frequency = system.setting.sampling_frequency;
        let torsion = system.responses.torsion();
        let from_surface = torsion.map_or(&[][..], |torsion| &torsion.from_surface[0]);
        let from_torque = system.driving_point().unwrap_or_default();
        let window = RaisedCosine {
            duration: STEP_WINDOW,
        };
        let number =
            |measure, value| Found::number(measure, Some(value), &self.references[&measure]);
        let of = |measure: &Measure| {
            Some(match measure {
                Measure::SurfaceStep => {
                    let speeds = smooth_step_response(
                        from_surface,
                        |step| window.integral(step as f64 / frequency),
                        self.surface_step.count(frequency),
                    );
                    let exact = self.surface_step.at(frequency, 0);
                    Found::history(*measure, greatest_difference(&speeds, exact))
                }
                Measure::SteadySpeed => number(*measure, from_surface.iter().sum()),
                Measure::StaticStiffness => {
                    let turned = from_torque.iter().scan(0.0, |speed, tap| {
                        *speed += tap;
                        Some(*speed / frequency)
                    });
                    number(*measure, 1.0 / turned.sum::<f64>())
                }
                Measure::Undershoot => number(*measure, largest_undershoot(from_torque)),
                _ => return None,
            })
        };
        wanted.iter().filter_map(of).collect()
    }

    fn nonlinear(
        &self,
        system: &MethodSystem,
        wanted: &[Measure],
    ) -> Result<Vec<(Measure, Option<f64>)>> {
        let mut answers = Vec::new();
        let wants = |measure| wanted.contains(&measure);
        if wants(Measure::FirstSlip) || wants(Measure::Period) {
            let case = self.case(system, None)?;
            let bit = bit_of(system, &case, Stopping::Full);
            let first_slip = bit.and_then(|bit| bit.first_slip);
            let period = bit.and_then(|bit| bit.period);
            let both = [(Measure::FirstSlip, first_slip), (Measure::Period, period)];
            answers.extend(both.into_iter().filter(|(measure, _)| wants(*measure)));
        }
        if wants(Measure::StickSlipLimit) {
            let [low, high] = LIMIT_BRACKET;
            let limit = limit_between(low, high, |ratio| {
                let case = self.case(system, Some(ratio)).ok()?;
                let bit = bit_of(system, &case, Stopping::Early)?;
                Some(bit.regime == TorsionRegime::Smooth)
            });
            answers.push((Measure::StickSlipLimit, limit));
        }
        Ok(answers)
    }

    /// Fig. 8(b), or the same torque with another ratio of speed to torque (rpm
    /// per kN m) for as long as its regime needs.
    fn case(&self, system: &MethodSystem, ratio: Option<f64>) -> Result<Case> {
        case(&self.sweep, &system.setting, ratio)
    }

    fn measure_radau(&self, frequency: f64, wanted: &[Measure]) -> Result<Measured> {
        let network = TorsionNetwork::new(&self.sweep.setting.string, &self.sweep.setting.sites)?;
        let count = self.surface_step.count(frequency);
        let start = Instant::now();
        let taps = radau::taps(frequency, count, &|s| network.admittance(s).from_surface[0]);
        let build_seconds = start.elapsed().as_secs_f64();
        let window = RaisedCosine {
            duration: STEP_WINDOW,
        };
        let mut speeds = vec![0.0; count];
        for (stage, place) in radau::STAGES.into_iter().enumerate() {
            let input = |step: usize| window.integral((step as f64 + place) / frequency);
            let from_stage = smooth_step_response(&taps[2 + stage], input, count);
            for (speed, more) in speeds.iter_mut().zip(from_stage) {
                *speed += more;
            }
        }
        let error = greatest_difference(&speeds, self.surface_step.at(frequency, 1));
        let found = Found::history(Measure::SurfaceStep, error);
        Ok(Measured::by_radau(build_seconds, wanted, found))
    }
}

/// Regime and measures of the bit; none where the case gives no answer.
fn bit_of(system: &MethodSystem, case: &Case, stopping: Stopping) -> Option<TorsionMeasures> {
    system.simulate(case, stopping, None).ok()?.torsion
}

fn case(sweep: &Sweep, setting: &crate::plan::Setting, ratio: Option<f64>) -> Result<Case> {
    let conditions = sweep.conditions;
    let case = match ratio {
        None => Case::under(sweep, setting, 0, Vec::new(), &conditions),
        Some(ratio) => {
            let torque = conditions.torque_dynamic_nm;
            let torque = torque.context("the bit has no torque")?;
            let conditions = conditions.with(Axis::SurfaceSpeedRpm, ratio * torque / 1e3);
            let sweep = Sweep {
                time: AutoOr::Auto,
                ..sweep.clone()
            };
            Case::under(&sweep, setting, 0, Vec::new(), &conditions)
        }
    };
    case.map_err(anyhow::Error::msg)
}

/// The longest time that any case lasts, s.
fn longest_time(sweep: &Sweep) -> Result<f64> {
    let mut longest: f64 = 0.0;
    for ratio in [None, Some(LIMIT_BRACKET[0]), Some(LIMIT_BRACKET[1])] {
        let case = case(sweep, &sweep.setting, ratio)?;
        longest = longest.max(case.scene.timing.duration);
    }
    Ok(longest)
}
