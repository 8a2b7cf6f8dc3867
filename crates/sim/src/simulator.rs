//! One case from rest to its regimes: the stepper, what is skipped, and who watches.

use linear::{Responses, SteppedString};

use crate::error::SimulationError;
use crate::laws::bit::BitMotion;
use crate::outcome::{Ended, Label, Outcome, Stopping};
use crate::scene::{Lateral, Scene};
use crate::shortcuts::{BitAlone, pass_free_block};
use crate::start::Start;
use crate::stepper::{Step, Stepper};
use crate::surface::SurfaceProfile;
use crate::system::System;
use crate::trajectory::Trajectory;
use crate::watch::lateral::WallWatch;
use crate::watch::rules::Rules;
use crate::watch::settling::Settling;
use crate::watch::torsion::{BitWatch, TorsionMeasures, TorsionRegime};

/// A linear system with what is known of all its cases.
#[derive(Debug, Clone)]
pub struct Simulator {
    system: System,
    bit_alone: Option<BitAlone>,
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
            system,
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
        Ok(Self {
            system: System::stepped(string, responses, profile)?,
            bit_alone: None,
        })
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
            watch: Watch::new(&self.system, scene, rules, &stepper),
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
    walls: Option<(WallWatch, Settling)>,
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
    fn new(system: &System, scene: &Scene, rules: Rules, stepper: &Stepper) -> Self {
        let (sampling, steps) = (system.sampling, stepper.steps());
        let window = scene.timing.closing_window;
        let bit = scene.bit.map(|_| {
            let mut watch = BitWatch::new(rules, sampling, steps, window);
            watch.skip_stuck(stepper.next_step().min(steps));
            watch
        });
        let walls = scene.lateral.as_ref().map(|_| {
            let walls = WallWatch::new(rules, system.sites, sampling, steps, window);
            (
                walls,
                Settling::new(rules, system.sites, sampling.frequency, steps),
            )
        });
        Self { bit, walls }
    }

    fn see(&mut self, now: &Step<BitMotion>) {
        if let (Some(watch), Some(bit)) = (&mut self.bit, &now.bit) {
            watch.see(bit.state, bit.speed);
        }
        if let Some((watch, _)) = &mut self.walls {
            watch.see(&now.contacts);
        }
    }
}

impl Case<'_> {
    /// Steps to the end, or until the rest is certain or settled; `each` sees every step
    /// that is stepped.
    fn step_through(
        &mut self,
        mut each: impl FnMut(&Step<BitMotion>),
    ) -> Result<End, SimulationError> {
        let mut end = End {
            ended: Ended::End,
            last: self.stepper.steps() - 1,
            predicted: None,
            settled: false,
        };
        if self.watch.bit.is_none() && self.watch.walls.is_none() {
            // Nothing acts, and nobody watches.
            return Ok(end);
        }
        let mut last = self.stepper.next_step().min(self.stepper.steps());
        loop {
            if self.stopping != Stopping::Full && self.pass_free_block() {
                continue;
            }
            let Some(now) = self.stepper.step()? else {
                break;
            };
            self.watch.see(now);
            each(now);
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
                    self.take_as_settled();
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
        let end = self.step_through(|now| record.push(now))?;
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
        let (lateral, step) = (self.scene.lateral.as_ref()?, self.stepper.next_step());
        if self.scene.bit.is_some() || !is_left_alone(lateral, self.system.sampling.start_of(step))
        {
            return None;
        }
        let (watch, settling) = self.watch.walls.as_mut()?;
        let has_settled = settling.see(self.stepper.contacts(), &lateral.walls);
        has_settled.then(|| Label::Lateral(settling.measures(watch).regime))
    }

    /// The rest of the time as what has settled goes on.
    fn take_as_settled(&mut self) {
        if let (Some(_), Some(watch)) = (self.alone, &mut self.watch.bit) {
            watch.repeat_last_cycle();
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
            torsion: self.torsion(),
            surface: None,
            string_torque: None,
            lateral,
        }
        .finite()
    }
}

/// Whether all impulses are over at a time, s.
fn is_left_alone(lateral: &Lateral, time: f64) -> bool {
    let mut impulses = lateral.impulses.iter();
    impulses.all(|impulse| impulse.is_quiet(time, f64::MAX))
}
