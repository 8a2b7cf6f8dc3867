//! The linear system of each method, built once for all cases.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;

use anyhow::Result;
use linear::deviation::exact_undershoot_within;
use linear::estimates::{
    largest_response, largest_undershoot, stick_slip_speed_limit, taps_to_undershoot,
    undershoot_time,
};
use linear::{BendingPoles, ChannelResponses, Method, PlaceQuantity, Responses};
use sim::{
    Label, LateralMeasures, Measures, Motion, Outcome, RatesAtPlaces, Scene, SimulationError,
    Simulator, Stopping, SurfaceTorque, TorsionRegime, Trajectory,
};

use super::along::{Along, closing_from};
use super::case::Case;
use super::case_error::CaseError;
use super::front::{Front, WrongFront};
use super::instability::{Instability, is_unstable};
use super::run_options::RunOptions;
use super::stress;
use super::system_plan::SystemPlan;
use super::timing::TIMES;
use super::tools;
use crate::plan::{Setting, Sweep};
use crate::records::{ByStart, Failure, Record, Verdict, WallPush, strength, verdict};

mod building;

pub use building::{Basis, Recipe, add_finer};

/// One method's responses, ready to simulate with, and what is known of them.
#[derive(Debug)]
pub struct MethodSystem {
    /// The method.
    pub method: Method,
    /// Its impulse responses.
    pub responses: Responses,
    /// I₀ of each impulse with the wall as the file says it, N s.
    pub least_impulses: Vec<f64>,
    /// How far each impulse moves its site, m per N s.
    reaches: Vec<f64>,
    /// Positive-real margin in torsion; `None` where no torque acts.
    pub torsion_margin: Option<f64>,
    /// Positive-real margin in bending; `None` where that is not modelled.
    pub bending_margin: Option<f64>,
    /// Positive-real margin of axial motion; `None` where that is not modelled.
    pub axial_margin: Option<f64>,
    /// Its fronts, where they have been compared with the exact ones.
    pub front: Option<Front>,
    /// Time to build, s.
    pub build_seconds: f64,
    /// What it was built from.
    pub setting: Setting,
    /// How far the bit swings back after a step of torque (Eq. 75), rad/s per N m, where one acts
    /// there.
    undershoot: Option<f64>,
    simulator: Simulator,
    /// What bends it, where poles do.
    poles: Option<BendingPoles>,
    /// What turns the surface, where that is to be known of a string that is not in pieces.
    surface_torque: Option<SurfaceTorque>,
    /// What bends the string along its length, where that is to be known.
    moments: Option<Along>,
    /// The same of what shakes its tools sideways, and along the axis.
    displacements: Option<Along>,
    rates: Option<RatesAtPlaces>,
    /// The same by steps that are shorter, where labels are certified.
    finer: Option<Box<MethodSystem>>,
    /// Systems for longer times, where a case has asked for them.
    pub(super) longer: [OnceLock<Option<Box<MethodSystem>>>; TIMES.len()],
}

impl MethodSystem {
    /// The impulses that are given in multiples of I₀, each with its I₀, N s.
    fn relative_impulses(&self) -> impl Iterator<Item = (usize, f64)> {
        let lateral = self.setting.lateral.iter();
        let impulses = lateral.flat_map(|lateral| &lateral.impulses).enumerate();
        (impulses.zip(&self.least_impulses))
            .filter(|((_, impulse), _)| impulse.is_relative())
            .map(|((index, _), least)| (index, *least))
    }

    /// Why labels by this method mean little, where its margin says so.
    pub fn instability(&self) -> Option<Instability> {
        let margins = [
            (self.torsion_margin, "torsion"),
            (self.bending_margin, "bending"),
            (self.axial_margin, "axial motion"),
        ];
        let (margin, motion) = (margins.into_iter())
            .find_map(|(margin, motion)| Some((margin.filter(|m| is_unstable(*m))?, motion)))?;
        Some(Instability {
            method: self.method.name(),
            motion,
            margin,
        })
    }

    /// Why it certifies no label: the same of the shorter steps by which it would, and their
    /// sampling frequency, Hz.
    pub fn instability_of_finer(&self) -> Option<(Instability, f64)> {
        let finer = self.finer.as_ref()?;
        Some((finer.instability()?, finer.setting.sampling_frequency))
    }

    /// What is to be said of its fronts, where they were compared and are not what they should
    /// be.
    pub fn wrong_front(&self) -> Option<WrongFront> {
        // Against a wall alone a front does not decide when what turns sticks.
        let decides = |front: &Front| self.setting.lateral.is_none() || front.overshoot() > 0.0;
        // A bit that cuts is not held by a torque that a front may overcome.
        let is_held = self.setting.cutting.is_none();
        let front = self
            .front
            .filter(|front| is_held && front.is_off())
            .filter(decides)?;
        let method = self.method.name();
        Some(WrongFront { method, front })
    }

    /// The torque that holds the bit fast, where only torsion is modelled and a
    /// torque acts there (see [`Simulator::stuck_torque`]).
    pub fn stuck_torque(&self) -> Option<&[f64]> {
        self.simulator.stuck_torque()
    }

    /// Taps of each response in torsion.
    pub fn torsion_taps(&self) -> usize {
        self.responses.torsion().map_or(0, ChannelResponses::taps)
    }

    /// Taps of the bit's speed from a torque on it, where one acts there.
    pub fn driving_point(&self) -> Option<&[f64]> {
        self.responses.at_bit()
    }

    /// Simulates one scene, its relative impulses in N s, writing its time history into
    /// `record` where asked; nothing is left out of that.
    ///
    /// # Errors
    /// Where the case gives no answer.
    pub fn simulate(
        &self,
        case: &Case,
        stopping: Stopping,
        mut record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        let mut scene = case.scene.clone();
        // A case may be of a setting with more sites, which are only observed.
        scene.start = case.start_of(&self.setting);
        if let Some(lateral) = &mut scene.lateral {
            // The clearance is the case's own.
            for (index, _) in self.relative_impulses() {
                let impulse = &mut lateral.impulses[index];
                let clearance = lateral.walls[impulse.site].clearance;
                impulse.amount *= clearance / self.reaches[index];
            }
        }
        let outcome = (self.simulator).simulate(&scene, stopping, record.as_deref_mut())?;
        // Of the nodes of a string that rubs only the sites are recorded.
        if let (Some(record), Some(friction)) = (record, &self.setting.friction) {
            let mut speeds = std::mem::take(&mut record.speeds);
            let sites = friction.observed.iter();
            record.speeds = sites
                .map(|&node| std::mem::take(&mut speeds[node]))
                .collect();
        }
        Ok(outcome)
    }

    /// Speeds of all sites, rad/s, in a motion of which the torque on the bit is known;
    /// where lateral motion is modelled, every site has been simulated, and `None`.
    pub fn driven_speeds(&self, case: &Case, motion: &Trajectory) -> Option<Vec<Vec<f64>>> {
        if self.responses.bending().is_some() || self.setting.friction.is_some() {
            return None;
        }
        let steps = motion.speeds.first().map_or(0, Vec::len);
        let (system, speed) = (self.simulator.system(), case.scene.surface_speed);
        let start = case.start_of(&self.setting);
        system.driven_speeds(speed, &start, &motion.torque_on_string(), steps)
    }

    /// Whether what is measured of a case follows from its motion: the torque that turns a string
    /// which rubs along its well, where it is not in pieces.
    pub(super) fn needs_motion(&self) -> bool {
        self.setting.friction.is_some() && self.surface_torque.is_some()
    }

    /// Makes the torque known that turns the surface, so that motions have it.
    ///
    /// # Errors
    /// Where the method does not treat the string.
    pub fn follow_surface(&mut self) -> Result<()> {
        let setting = &self.setting;
        let request = self.plan().request();
        let taps = linear::surface_torque(&setting.string, &self.method, &request)?;
        let (profile, inertia) = (&setting.profile, setting.rotor_inertia);
        let torque = SurfaceTorque::new(&self.responses, &taps, profile, inertia)?
            .answering_late(self.setting.drive_delay());
        self.surface_torque = Some(torque);
        Ok(())
    }

    /// Adds the torque that turns the surface, N m, to a motion where it is to be known; of a
    /// string in pieces the motion has it.
    pub fn add_surface_torque(&self, case: &Case, motion: &mut Trajectory) {
        if let Some(torque) = &self.surface_torque {
            motion.surface_torque = torque.of(
                case.scene.surface_speed,
                &case.start_of(&self.setting),
                motion,
            );
        }
    }

    /// Makes it known how the string is bent, stressed and shaken along its length, where its setting asks
    /// for that.
    ///
    /// # Errors
    /// Where the method does not treat the string.
    pub fn follow_places(&mut self) -> Result<()> {
        if let Some(lateral) = &self.setting.lateral {
            let [moments, displacements] = [
                (PlaceQuantity::Moment, lateral.stressed.as_slice()),
                (PlaceQuantity::Displacement, self.setting.tools.as_slice()),
            ]
            .map(|wanted| Along::build(&self.plan(), wanted, self.poles.as_ref()));
            (self.moments, self.displacements) = (moments?, displacements?);
        }
        self.rates = tools::build_along_axis(&self.plan())?;
        Ok(())
    }

    /// Adds to the outcome of a case how its motion bent, stressed and shook the string, where that is to be
    /// known.
    fn add_at_places(
        &self,
        case: &Case,
        motion: &Trajectory,
        outcome: &mut Outcome,
    ) -> Result<(), CaseError> {
        let plan = self.plan();
        if let (Some(rates), Some(axial), Some(Measures::Axial(measures))) = (
            &self.rates,
            &case.scene.axial,
            &mut outcome.measures[Motion::Axial],
        ) {
            let window = case.scene.timing.closing_window;
            let from = closing_from(motion, window, self.setting.sampling_frequency);
            measures.acceleration =
                rates.acceleration(axial, motion, (&self.setting.tool_bands, from));
        }
        let Some(lateral) = &self.setting.lateral else {
            return Ok(());
        };
        let of = (&plan, lateral);
        if let Some(moments) = &self.moments {
            outcome.stress = Some(stress::measures(moments, of, case, motion)?);
        }
        if let (Some(displacements), Some(Measures::Lateral(measures))) =
            (&self.displacements, &mut outcome.measures[Motion::Lateral])
        {
            measures.shocks = tools::measures(displacements, of, case, motion)?;
        }
        Ok(())
    }

    /// What it was built from, as far as the string's bending and the surface's torque go.
    fn plan(&self) -> SystemPlan<'_> {
        SystemPlan {
            setting: &self.setting,
            method: &self.method,
            cuts: false,
            longest_time: self.responses.longest_time,
        }
    }

    /// How far above the one-slip estimate of stick-slip (Eq. 74) the surface turns, rad/s: that
    /// knows of no friction but the bit's, and of no motor.
    fn above_limit(&self, scene: &Scene) -> Option<f64> {
        let knows = self.setting.friction.is_none() && self.setting.has_stick_slip_limit();
        let bit = scene.bit.filter(|_| knows)?;
        let (torque_static, torque_dynamic) = (bit.torque_static, bit.torque_dynamic);
        let limit = stick_slip_speed_limit(self.undershoot?, torque_static, torque_dynamic);
        Some(scene.surface_speed - limit)
    }

    /// What it says of a case, where it has an answer that means something.
    pub(super) fn verdict(&self, case: &Case, stopping: Stopping) -> Option<Verdict> {
        if self.instability().is_some() {
            return None;
        }
        let simulate = AssertUnwindSafe(|| {
            let mut outcome = self.simulate(case, stopping, None)?;
            self.begin_otherwise(case, stopping, &mut outcome)?;
            Ok::<_, SimulationError>(outcome)
        });
        let outcome = catch_unwind(simulate).ok()?.ok()?;
        Some(verdict(&outcome, self.above_limit(&case.scene)))
    }

    /// Simulates a case that begins both ways from its other start, too: the label of what came
    /// out of the first becomes that of both.
    ///
    /// # Errors
    /// Where the case, begun otherwise, gives no answer.
    fn begin_otherwise(
        &self,
        case: &Case,
        stopping: Stopping,
        outcome: &mut Outcome,
    ) -> Result<Option<ByStart>, SimulationError> {
        let Some(other) = case.begun_otherwise() else {
            return Ok(None);
        };
        let other = self.simulate(&other, stopping, None)?;
        let of_bit = &mut outcome.measures[Motion::Torsion];
        let (Some(Measures::Torsion(torsion)), Some(other)) = (of_bit, other.torsion()) else {
            return Ok(None);
        };
        let (stuck, smooth) = (torsion.regime, other.regime);
        // Below a drive of limited torque what is stuck has stalled.
        torsion.regime = match self.setting.drive_limit {
            Some(_) if stuck != smooth && !other.fades && !torsion.fades => TorsionRegime::Bistable,
            _ => TorsionRegime::from_two_starts(stuck, smooth),
        };
        torsion.fades |= other.fades;
        torsion.is_irregular |= other.is_irregular;
        // What was predicted is of the first start.
        if outcome.predicted == Some(Label::Torsion(stuck)) {
            outcome.predicted = Some(Label::Torsion(torsion.regime));
        }
        Ok(Some(ByStart { stuck, smooth }))
    }

    /// The hardest push of a case into its walls, and what the rock of its bit would make of it.
    fn wall_push(&self, case: &Case, sweep: &Sweep, lateral: &LateralMeasures) -> Option<WallPush> {
        let hardest = lateral.hardest?;
        let from_bit = self.setting.sites.distances_from_bit()[hardest.site];
        let wall = case.scene.lateral.as_ref()?.walls.get(hardest.site)?;
        let law = (sweep.bit.as_ref()).and_then(|bit| bit.cutting_law(&case.conditions).ok()?);
        let strength = strength(law.map(|law| law.specific_energy));
        Some(WallPush::new(&hardest, from_bit, wall, strength))
    }

    /// The same by its shorter steps, where it has any.
    pub(super) fn finer_verdict(&self, case: &Case, stopping: Stopping) -> Option<Verdict> {
        self.finer.as_ref()?.verdict(case, stopping)
    }

    /// The record of a case, as a run has it, at the sites that it was built for; `method`
    /// is its place in the sweep's list. The motion is followed to its end where there is one to
    /// be written, and held against what the sweep compares with.
    pub(super) fn follow(
        &self,
        case: &Case,
        method: usize,
        options: RunOptions,
        sweep: &Sweep,
        mut motion: Option<&mut Trajectory>,
    ) -> Record {
        let failed = |reason: CaseError| {
            let values = case.values.clone();
            Record::failed(case.index, method, values, Failure::new(reason))
        };
        if let (Some(instability), false) = (self.instability(), options.allow_unstable) {
            return failed(CaseError::Unstable(instability));
        }
        let stopping = options.stopping(case.index);
        let mut by_start = None;
        let simulated = catch_unwind(AssertUnwindSafe(|| {
            let mut outcome = self.simulate(case, stopping, motion.as_deref_mut())?;
            by_start = self.begin_otherwise(case, stopping, &mut outcome)?;
            Ok::<_, SimulationError>(outcome)
        }));
        let friction = self.setting.friction.as_ref();
        let walls = self.setting.sites.distances_from_bit();
        let ports = friction.map_or(walls, |friction| friction.nodes.distances_from_bit());
        let mut record = failed(CaseError::Panicked);
        record.torque_dynamic_nm = case.torque_dynamic_nm;
        record.by_start = by_start;
        if let Ok(simulated) = simulated {
            let lateral = simulated.as_ref().ok().and_then(Outcome::lateral);
            record.site_from_bit_m = lateral.map(|lateral| walls[lateral.site]);
            record.outcome = simulated.map_err(|error| {
                let site = error.site();
                let site = site.and_then(|site| Some((site, *ports.get(site)?)));
                Failure::new(CaseError::Simulation { error, site })
            });
            if record.outcome.is_ok() {
                record.above_limit = self.above_limit(&case.scene);
            }
            if let (Ok(outcome), Some(motion)) = (&mut record.outcome, motion) {
                self.add_surface_torque(case, motion);
                let is_measured = sweep.measures_surface_torque() || self.needs_motion();
                if let Some(torque) = self.surface_torque.as_ref().filter(|_| is_measured) {
                    let window = case.scene.timing.closing_window;
                    outcome.surface = Some(torque.measures(&motion.surface_torque, window));
                }
                if let Err(reason) = self.add_at_places(case, motion, outcome) {
                    record.outcome = Err(Failure::new(reason));
                    return record;
                }
                record.misfits = (sweep.data.comparisons.iter())
                    .map(|comparison| comparison.misfit(motion))
                    .collect();
            }
        }
        let lateral = (record.outcome.as_ref().ok()).and_then(Outcome::lateral);
        record.wall_push = lateral.and_then(|lateral| self.wall_push(case, sweep, &lateral));
        let shocks = lateral.and_then(|lateral| lateral.shocks);
        let tools = self.setting.tools.as_slice();
        let shaken = if tools.is_empty() { walls } else { tools };
        record.shock_from_bit_m = shocks.map(|shocks| shaken[shocks.site]);
        record
    }
}

/// Steps by which a method may be late with an undershoot.
const LATER: usize = 10;

/// Holds the fronts of systems of one string against the exact ones; where no torque cuts
/// there are none, and where a string does not undershoot nothing is said.
pub fn compare_fronts(systems: &mut [MethodSystem]) {
    let Some(string) = systems.first().map(|system| &system.setting.string) else {
        return;
    };
    if systems
        .iter()
        .all(|system| system.driving_point().is_none())
    {
        return;
    }
    // Where damping is little a bit may swing back furthest after many periods.
    let latest = (systems.iter())
        .filter_map(|system| {
            let step = 1.0 / system.setting.sampling_frequency;
            let taps = taps_to_undershoot(system.driving_point()?)?;
            Some((taps + LATER) as f64 * step)
        })
        .fold(undershoot_time(string), f64::max);
    // A string whose lattice does not fit in memory stays without a comparison.
    let exact = exact_undershoot_within(string, latest).ok();
    let Some(exact) = exact.filter(|exact| *exact > 0.0) else {
        return;
    };
    for system in systems {
        let front = system.driving_point().map(|taps| Front {
            undershoot: largest_undershoot(taps),
            exact,
            largest: largest_response(taps),
        });
        system.front = front;
    }
}
