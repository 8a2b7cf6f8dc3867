//! One case from rest to its regimes: the stepper, what is skipped, and who watches.

use linear::{Cascade, Responses, SteppedString};

use crate::error::SimulationError;
use crate::label::Label;
use crate::motion::{Motion, PerMotion};
use crate::outcome::{Ended, Measures, Outcome, Stopping};
use crate::scene::{Lateral, Scene};
use crate::shortcuts::{BitAlone, pass_free_block};
use crate::start::Start;
use crate::stepper::Stepper;
use crate::surface::SurfaceProfile;
use crate::system::System;
use crate::trajectory::Trajectory;
use crate::watch::along::StringTorqueWatch;
use crate::watch::lateral::WallWatch;
use crate::watch::rubbing::RubbingWatch;
use crate::watch::rules::Rules;
use crate::watch::settling::Settling;
use crate::watch::surface::SurfaceMeasures;
use crate::watch::torsion::{BitWatch, TorsionMeasures, TorsionRegime};

/// A linear system with what is known of all its cases.
#[derive(Debug, Clone)]
pub struct Simulator {
    system: System,
    bit_alone: Option<BitAlone>,
    follows_torque: bool,
}

impl Simulator {
    /// Prepares responses for cases as long as they were built for.
    ///
    /// # Errors
    /// As [`System::new`].
    pub fn new(responses: &Responses) -> Result<Self, SimulationError> {
        Self::started(responses, &SurfaceProfile::default())
    }

    /// The same for cases whose surface comes to its speed in another way.
    ///
    /// # Errors
    /// As [`System::started`].
    pub fn started(
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        let system = System::started(responses, profile)?;
        Ok(Self {
            bit_alone: BitAlone::of(&system, responses),
            ..Self::of(system)
        })
    }

    /// Of a string whose elements are stepped, with its responses to the surface: for many
    /// sites.
    ///
    /// # Errors
    /// As [`System::stepped`].
    pub fn stepped(
        string: &SteppedString,
        responses: &Responses,
        profile: &SurfaceProfile,
    ) -> Result<Self, SimulationError> {
        System::stepped(string, responses, profile).map(Self::of)
    }

    /// Of a string in pieces, whose nodes torques may act on: for friction all along it.
    ///
    /// # Errors
    /// As [`System::in_pieces`].
    pub fn in_pieces(
        cascade: &Cascade,
        profile: &SurfaceProfile,
        rotor_inertia: f64,
    ) -> Result<Self, SimulationError> {
        System::in_pieces(cascade, profile, rotor_inertia).map(Self::of)
    }

    /// Of any system.
    pub fn of(system: System) -> Self {
        Self {
            system,
            bit_alone: None,
            follows_torque: false,
        }
    }

    /// The same, which follows the torque all along a string in pieces, or does not: that takes a
    /// little more of each step.
    #[must_use]
    pub fn following_torque(self, follows_torque: bool) -> Self {
        Self {
            follows_torque,
            ..self
        }
    }

    /// What its cases are stepped against.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The torque that holds the bit fast from the first step on, for as long as
    /// any case lasts, N m per rad/s of surface speed; `None` where something else than
    /// the bit may act, or nothing.
    pub fn stuck_torque(&self) -> Option<&[f64]> {
        self.bit_alone.as_ref().map(BitAlone::stuck_torque)
    }

    /// Simulates one case, writing its time history into `record` where asked; nothing
    /// is left out of that.
    ///
    /// # Errors
    /// Where the scene is refused or does not fit the system, the motion is
    /// not finite or coupled sites do not settle.
    pub fn simulate(
        &self,
        scene: &Scene,
        stopping: Stopping,
        record: Option<&mut Trajectory>,
    ) -> Result<Outcome, SimulationError> {
        let alone = self.bit_alone.as_ref().zip(scene.bit.as_ref());
        let stepper = match alone {
            Some((alone, law)) => alone.stepper(&self.system, scene, law)?,
            None => Stepper::new(&self.system, scene)?,
        };
        let rules = Rules::USUAL;
        let mut case = Case {
            system: &self.system,
            scene,
            rules,
            stopping: match record {
                Some(_) => Stopping::Full,
                None => stopping,
            },
            alone: alone.map(|(alone, _)| alone),
            watch: Watch::new(&self.system, scene, (rules, self.follows_torque), &stepper),
            stepper,
        };
        let ended = match record {
            None => case.step_through(|_| {})?,
            Some(record) => case.record(record)?,
        };
        case.outcome(ended)
    }
}

/// A case under way.
struct Case<'a> {
    system: &'a System,
    scene: &'a Scene,
    rules: Rules,
    stopping: Stopping,
    /// Where nothing acts but the bit.
    alone: Option<&'a BitAlone>,
    stepper: Stepper<'a>,
    watch: Watch,
}

/// Who watches a case.
struct Watch {
    bit: Option<BitWatch>,
    /// The lowest port that a law acts on, where that is not the bit.
    rubs_at: Option<usize>,
    walls: Option<(WallWatch, Settling)>,
    rubbing: Option<RubbingWatch>,
    /// What turned the surface in each step, N m.
    surface: Option<Vec<f64>>,
    along: Option<StringTorqueWatch>,
}

/// How a case came to its end.
struct End {
    ended: Ended,
    /// The last step that was stepped.
    last: usize,
    predicted: Option<Label>,
    /// Measures of settled whirl, which take the place of those of the closing window.
    settled: bool,
}

impl Watch {
    fn new(
        system: &System,
        scene: &Scene,
        (rules, follows_torque): (Rules, bool),
        stepper: &Stepper,
    ) -> Self {
        let (sampling, steps) = (system.sampling, stepper.steps());
        let window = scene.timing.closing_window;
        let lowest = stepper.lowest_law();
        let bit = lowest.map(|_| {
            let mut watch = BitWatch::new(rules, sampling, steps, window);
            watch.skip_stuck(stepper.next_step().min(steps));
            watch
        });
        let walls = scene.lateral.as_ref().map(|_| {
            let sites = system.walls.len();
            let walls = WallWatch::new(rules, sites, sampling, steps, window);
            (
                walls,
                Settling::new(rules, sites, sampling.frequency, steps),
            )
        });
        let is_in_pieces = system.torsion.whole().is_none();
        Self {
            bit,
            rubs_at: lowest.filter(|_| scene.bit.is_none()),
            walls,
            rubbing: (!scene.friction.is_empty() && scene.lateral.is_none()).then(|| {
                let steady_from = system.torsion.steady_from(rules.settling_tolerance);
                let window = (window * sampling.frequency).round() as usize;
                RubbingWatch::new(rules, scene.surface_speed, steady_from, window)
            }),
            surface: is_in_pieces.then(|| Vec::with_capacity(steps)),
            along: (is_in_pieces && follows_torque).then(StringTorqueWatch::default),
        }
    }

    fn see(&mut self, stepper: &Stepper) {
        let now = stepper.now();
        match (&mut self.bit, &now.bit, self.rubs_at) {
            (Some(watch), Some(bit), _) => watch.see(bit.state, bit.speed),
            // What is stuck lowest holds a free bit but for its swinging.
            (Some(watch), None, Some(port)) => {
                let speed = now.speeds.last().copied().unwrap_or_default();
                watch.see(now.rubbing[port].motion, speed);
            }
            _ => {}
        }
        if let Some((watch, _)) = &mut self.walls {
            watch.see(&now.contacts);
        }
        if let (Some(watch), Some(surface)) = (&mut self.surface, now.surface) {
            watch.push(surface.torque);
        }
        if let (Some(watch), Some(bit)) = (&mut self.rubbing, &self.bit) {
            watch.see(&now.speeds, stepper.is_any_stuck(), bit);
        }
        if let Some(watch) = &mut self.along {
            watch.see(stepper.string_torques());
        }
    }

    /// Whether nothing is watched.
    fn is_empty(&self) -> bool {
        self.bit.is_none() && self.walls.is_none() && self.surface.is_none()
    }
}

impl Case<'_> {
    /// Steps to the end, or until the rest is certain or settled; `each` sees every step
    /// that is stepped.
    fn step_through(&mut self, mut each: impl FnMut(&Stepper)) -> Result<End, SimulationError> {
        let mut end = End {
            ended: Ended::End,
            last: self.stepper.steps() - 1,
            predicted: None,
            settled: false,
        };
        if self.watch.is_empty() {
            // Nothing acts, and nobody watches.
            return Ok(end);
        }
        let mut last = self.stepper.next_step().min(self.stepper.steps());
        loop {
            if self.stopping != Stopping::Full && self.pass_free_block() {
                continue;
            }
            if self.stepper.step()?.is_none() {
                break;
            }
            self.watch.see(&self.stepper);
            each(&self.stepper);
            last = self.stepper.next_step();
            if self.stopping == Stopping::Full {
                continue;
            }
            if self.turns_on() {
                (end.ended, end.last) = (Ended::Certain, last - 1);
                return Ok(end);
            }
            if end.predicted.is_none()
                && let Some(label) = self.settles()
            {
                if self.stopping == Stopping::Early {
                    self.take_as_settled(label);
                    (end.ended, end.last, end.settled) = (Ended::Settled, last - 1, true);
                    return Ok(end);
                }
                end.predicted = Some(label);
            }
        }
        if last < self.stepper.steps() {
            (end.ended, end.last) = (Ended::Certain, last.saturating_sub(1));
        }
        Ok(end)
    }

    /// The same with its time history, which leaves nothing out.
    fn record(&mut self, record: &mut Trajectory) -> Result<End, SimulationError> {
        let slip = self.stepper.next_step().min(self.stepper.steps());
        // Cases that begin with a steady motion leave none out.
        let held = (self.alone).map(|alone| &alone.stuck_torque()[..slip]);
        record.begin(self.system, self.scene, held.unwrap_or_default());
        let end = self.step_through(|stepper| record.push(stepper))?;
        record.finish(self.system, self.scene, &self.stepper);
        Ok(end)
    }

    fn pass_free_block(&mut self) -> bool {
        let Some((watch, settling)) = &mut self.watch.walls else {
            return false;
        };
        let passed = pass_free_block(self.system, self.scene, &mut self.stepper, watch);
        if passed > 0 {
            settling.skip(passed);
        }
        passed > 0
    }

    /// Whether a bit that nothing else acts on is never going to stop again.
    fn turns_on(&mut self) -> bool {
        let (Some(alone), Some(watch)) = (self.alone, &mut self.watch.bit) else {
            return false;
        };
        // What is to come follows from a torque that stays.
        if self.scene.bit.is_some_and(|bit| bit.decay_speed > 0.0) {
            return false;
        }
        let Some(speeds) = alone.turns_on(self.system, &self.stepper, watch, &self.rules) else {
            return false;
        };
        watch.turn_on(&speeds);
        true
    }

    /// The label that motion has settled to, if it has. A bit that cuts beside a wall has
    /// a regime of its own to wait for.
    fn settles(&mut self) -> Option<Label> {
        if let Some(alone) = self.alone {
            let watch = self.watch.bit.as_ref()?;
            return alone
                .repeats(&self.scene.start, self.stepper.next_step(), watch)
                .then_some(Label::Torsion(TorsionRegime::StickSlip));
        }
        if let (Some(rubbing), Some(bit)) = (&self.watch.rubbing, &self.watch.bit) {
            return rubbing.settled(bit).map(Label::Torsion);
        }
        let (lateral, step) = (self.scene.lateral.as_ref()?, self.stepper.next_step());
        let turns = self.scene.bit.is_some() || !self.scene.friction.is_empty();
        if turns || !is_left_alone(lateral, self.system.sampling.start_of(step)) {
            return None;
        }
        let (watch, settling) = self.watch.walls.as_mut()?;
        let has_settled = settling.see(self.stepper.contacts(), &lateral.walls);
        has_settled.then(|| Label::Lateral(settling.measures(watch).regime))
    }

    /// The rest of the time as what has settled goes on.
    fn take_as_settled(&mut self, label: Label) {
        let Some(watch) = &mut self.watch.bit else {
            return;
        };
        match label {
            Label::Torsion(TorsionRegime::StickSlip) => watch.repeat_last_cycle(),
            Label::Torsion(_) => watch.turn_on(&[self.scene.surface_speed]),
            Label::Lateral(_) => {}
        }
    }

    /// A case that begins with a steady motion has no first slip to wait for.
    fn torsion(&self) -> Option<TorsionMeasures> {
        let watch = self.watch.bit.as_ref()?;
        let measures = watch.measures(self.scene.surface_speed);
        Some(TorsionMeasures {
            first_slip: (measures.first_slip).filter(|_| self.scene.start == Start::Rest),
            ..measures
        })
    }

    fn outcome(&self, end: End) -> Result<Outcome, SimulationError> {
        let lateral = self.watch.walls.as_ref().map(|(watch, settling)| {
            if end.settled {
                settling.measures(watch)
            } else {
                watch.measures()
            }
        });
        Outcome {
            simulated: self.system.sampling.start_of(end.last),
            ended: end.ended,
            predicted: end.predicted,
            measures: PerMotion::from_fn(|motion| match motion {
                Motion::Torsion => self.torsion().map(Measures::Torsion),
                Motion::Lateral => lateral.map(Measures::Lateral),
            }),
            surface: (self.watch.surface.as_ref()).map(|torques| {
                let window = self.scene.timing.closing_window;
                SurfaceMeasures::of(torques, self.system.sampling, window)
            }),
            string_torque: (self.watch.along.as_ref())
                .map(|along| along.measures(self.system.sites.distances_from_bit())),
        }
        .finite()
    }
}

/// Whether all impulses are over at a time, s.
fn is_left_alone(lateral: &Lateral, time: f64) -> bool {
    let mut impulses = lateral.impulses.iter();
    impulses.all(|impulse| impulse.is_quiet(time, f64::MAX))
}
