//! The linear system of each method, built once for all cases.

use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

use anyhow::{Context, Result, bail};
use linear::passivity::STABLE_MARGIN;
use linear::{
    BendingRequest, BendingResponses, Method, TorsionRequest, TorsionResponses, bending_responses,
    torsion_responses,
};
use rayon::prelude::*;
use sim::excitation::least_impulse;
use sim::{LateralSystem, Outcome, Scene, SimulationError, Stopping, System, Trajectory};

use super::case::{Case, Row, RowOutcome};
use super::terms::Terms;
use crate::spec::{ImpulseSettings, LARGEST_IMPULSE, LateralSettings, Setting, Sweep};

/// One method's responses, ready to simulate with, and what is known of them.
#[derive(Debug)]
pub struct MethodSystem {
    /// The method.
    pub method: Method,
    /// Its torsional impulse responses.
    pub responses: TorsionResponses,
    /// Its lateral impulse responses, where lateral motion is modelled.
    pub bending: Option<BendingResponses>,
    /// I₀ of each impulse, N s.
    pub least_impulses: Vec<f64>,
    /// Positive-real margin in torsion; `None` where no torque acts.
    pub torsion_margin: Option<f64>,
    /// Positive-real margin in bending; `None` where that is not modelled.
    pub bending_margin: Option<f64>,
    /// Time to build, s.
    pub build_seconds: f64,
    /// What it was built from.
    pub setting: Setting,
    stepped: Stepped,
    /// Which impulses are given in multiples of I₀.
    relative: Vec<bool>,
}

/// What a case is stepped against.
#[derive(Debug)]
enum Stepped {
    Torsion(System),
    Lateral(LateralSystem),
}

impl MethodSystem {
    /// Builds the system of every method of a sweep for one string.
    ///
    /// # Errors
    /// Where a method cannot treat the string, or an impulse is given in
    /// multiples of an I₀ that does not exist.
    pub fn build_all(sweep: &Sweep, setting: &Setting, longest_time: f64) -> Result<Vec<Self>> {
        // The first method's error, whichever was found first.
        Self::build_each(sweep, setting, longest_time)
            .into_iter()
            .collect()
    }

    /// As [`MethodSystem::build_all`], with an answer for each method: what one cannot
    /// treat, another may.
    pub fn build_each(sweep: &Sweep, setting: &Setting, longest_time: f64) -> Vec<Result<Self>> {
        let build = |method: &Method| {
            let system = Self::build(setting, *method, sweep.bit.is_some(), longest_time)
                .with_context(|| format!("the responses by {} cannot be built", method.name()))?;
            if let Some(index) = system.unreachable_impulse() {
                let message = "there is no I₀, for no impulse brings this site to the wall; \
                               give `amount_ns`";
                let key = format!("impulses[{index}].ratio");
                bail!(sweep.source.error(&key, message));
            }
            Ok(system)
        };
        sweep.methods.par_iter().map(build).collect()
    }

    /// Builds the system of one method; `cuts` says whether a torque acts on the
    /// bit.
    ///
    /// # Errors
    /// Where the method cannot treat the string.
    pub fn build(setting: &Setting, method: Method, cuts: bool, longest_time: f64) -> Result<Self> {
        let start = Instant::now();
        let request = torsion_request(setting, cuts, longest_time);
        // Neither alone keeps all cores busy.
        let (responses, bending) = rayon::join(
            || torsion_responses(&setting.string, &method, &request),
            || {
                let lateral = setting.lateral.as_ref();
                lateral
                    .map(|lateral| build_bending(setting, lateral, &method, longest_time))
                    .transpose()
            },
        );
        let (responses, bending) = (responses?, bending?);
        let stepped = match &bending {
            None => Stepped::Torsion(System::new(&responses, longest_time)?),
            Some(bending) => Stepped::Lateral(LateralSystem::new(&responses, bending)?),
        };
        let build_seconds = start.elapsed().as_secs_f64();
        let impulses = setting.lateral.iter().flat_map(|lateral| &lateral.impulses);
        Ok(Self {
            method,
            torsion_margin: responses.margin()?,
            bending_margin: (bending.as_ref())
                .map(|bending| bending.margin(&method))
                .transpose()?,
            least_impulses: least_impulses(setting, bending.as_ref()),
            relative: impulses.map(|impulse| impulse.relative).collect(),
            build_seconds,
            setting: setting.clone(),
            stepped,
            responses,
            bending,
        })
    }

    /// The first impulse given in multiples of an I₀ that is larger than any
    /// impulse, for its site cannot reach the wall.
    fn unreachable_impulse(&self) -> Option<usize> {
        let mut impulses = self.least_impulses.iter().zip(&self.relative);
        impulses
            .position(|(least, relative)| *relative && (least.is_nan() || *least > LARGEST_IMPULSE))
    }

    /// Why labels by this method mean little, where its margin says so.
    pub fn instability(&self) -> Option<Instability> {
        let margins = [
            (self.torsion_margin, "torsion"),
            (self.bending_margin, "bending"),
        ];
        let (margin, motion) = (margins.into_iter())
            .find_map(|(margin, motion)| Some((margin.filter(|m| is_unstable(*m))?, motion)))?;
        Some(Instability {
            method: self.method.name(),
            motion,
            margin,
        })
    }

    /// The torque that holds the bit fast, where only torsion is modelled and a
    /// torque acts there (see [`System::held_torque`]).
    pub fn held_torque(&self) -> Option<&[f64]> {
        match &self.stepped {
            Stepped::Torsion(system) => system.held_torque(),
            Stepped::Lateral(_) => None,
        }
    }

    /// Taps of the bit's speed from a torque on it, where one acts there.
    pub fn driving_point(&self) -> Option<&[f64]> {
        self.responses.at_bit()
    }

    /// Simulates one scene, writing its time history into `record` where asked;
    /// nothing is left out of that.
    ///
    /// # Errors
    /// Where the case gives no answer.
    pub fn simulate(
        &self,
        case: &Case,
        stopping: Stopping,
        record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        match &self.stepped {
            Stepped::Torsion(system) => sim::simulate(system, &case.scene, stopping, record),
            Stepped::Lateral(system) => {
                sim::simulate_lateral(system, &self.with_amounts(&case.scene), stopping, record)
            }
        }
    }

    /// Speeds of all sites, rad/s, in a motion of which the torque on the bit is known;
    /// where lateral motion is modelled, every site has been simulated, and `None`.
    pub fn driven_speeds(&self, case: &Case, motion: &Trajectory) -> Option<Vec<Vec<f64>>> {
        match &self.stepped {
            Stepped::Torsion(system) => {
                let steps = motion.speeds.first().map_or(0, Vec::len);
                let surface_speed = case.scene.surface_speed;
                Some(system.driven_speeds(surface_speed, &motion.bit_torque, steps))
            }
            Stepped::Lateral(_) => None,
        }
    }

    /// The scene with its relative impulses in N s.
    fn with_amounts(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        let impulses = scene
            .lateral
            .iter_mut()
            .flat_map(|lateral| &mut lateral.impulses);
        for (index, impulse) in impulses.enumerate() {
            if self.relative[index] {
                impulse.amount *= self.least_impulses[index];
            }
        }
        scene
    }

    /// The row that a run on these terms writes of a case. A case that panics is one
    /// without an answer, and not the end of the sweep.
    pub fn answer(&self, case: &Case, terms: Terms) -> Row {
        if let (Some(instability), false) = (self.instability(), terms.allow_unstable) {
            let reason = format!("{instability} (--allow-unstable simulates it)");
            let method = self.method.name();
            return Row::failed(case.index, method, case.values.clone(), reason);
        }
        let stopping = terms.stopping(case.index);
        let simulated = catch_unwind(AssertUnwindSafe(|| self.simulate(case, stopping, None)));
        let outcome = match simulated {
            Ok(Ok(outcome)) => RowOutcome::Done(outcome),
            Ok(Err(error)) => RowOutcome::Failed(self.in_words(&error)),
            Err(_) => RowOutcome::Failed("the simulation panicked".to_owned()),
        };
        let site_from_bit_m = match &outcome {
            RowOutcome::Done(outcome) => (outcome.lateral)
                .map(|lateral| self.setting.sites.distances_from_bit()[lateral.site]),
            RowOutcome::Failed(_) => None,
        };
        Row {
            case: case.index,
            method: self.method.name(),
            values: case.values.clone(),
            torque_dynamic_nm: case.torque_dynamic_nm,
            site_from_bit_m,
            outcome,
        }
    }
}

impl MethodSystem {
    /// Why a case has no answer, its site by its place on the string.
    fn in_words(&self, error: &SimulationError) -> String {
        let distances = self.setting.sites.distances_from_bit();
        let site = error.site();
        match site.and_then(|site| Some((site, *distances.get(site)?))) {
            None => error.to_string(),
            Some((site, 0.0)) => format!("{error} (site {site} is the bit)"),
            Some((site, distance)) => {
                format!("{error} (site {site} is {distance} m from the bit)")
            }
        }
    }
}

/// A method's responses that are not positive-real.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instability {
    /// Name of the method.
    pub method: &'static str,
    /// `torsion` or `bending`.
    pub motion: &'static str,
    /// Positive-real margin.
    pub margin: f64,
}

impl fmt::Display for Instability {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the responses in {} by {} are not positive-real (margin {:.2e}): \
             a stuck site chatters and labels mean little",
            self.motion, self.method, self.margin
        )
    }
}

/// Whether a positive-real margin says that a stuck site chatters.
pub fn is_unstable(margin: f64) -> bool {
    margin < STABLE_MARGIN
}

/// What a system needs in torsion; `cuts` says whether a torque acts on the bit.
pub(super) fn torsion_request(setting: &Setting, cuts: bool, longest_time: f64) -> TorsionRequest {
    let sites = setting.sites.len();
    let torque_inputs = match &setting.lateral {
        // Friction turns the string wherever it touches the wall.
        Some(_) => (0..sites).collect(),
        None if cuts => vec![sites - 1],
        None => Vec::new(),
    };
    TorsionRequest {
        sites: setting.sites.clone(),
        torque_inputs,
        sampling_frequency: setting.sampling_frequency,
        longest_time,
    }
}

/// What a system needs in bending.
pub(super) fn bending_request(
    setting: &Setting,
    lateral: &LateralSettings,
    longest_time: f64,
) -> BendingRequest {
    BendingRequest {
        sites: setting.sites.clone(),
        support: lateral.support,
        sampling_frequency: setting.sampling_frequency,
        longest_time,
    }
}

fn build_bending(
    setting: &Setting,
    lateral: &LateralSettings,
    method: &Method,
    longest_time: f64,
) -> Result<BendingResponses> {
    let request = bending_request(setting, lateral, longest_time);
    let responses = bending_responses(&setting.string, &lateral.bending, method, &request)?;
    Ok(responses)
}

/// I₀ of every impulse: by this method, at its own site.
fn least_impulses(setting: &Setting, bending: Option<&BendingResponses>) -> Vec<f64> {
    let Some((lateral, bending)) = setting.lateral.as_ref().zip(bending) else {
        return Vec::new();
    };
    let of = |settings: &ImpulseSettings| {
        let impulse = &settings.impulse;
        least_impulse(
            &bending.from_force[impulse.site][impulse.site],
            setting.sampling_frequency,
            impulse.duration,
            lateral.walls[impulse.site].clearance,
        )
    };
    lateral.impulses.iter().map(of).collect()
}
