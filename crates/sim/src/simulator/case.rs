//! A case from its first step to its last, and what is left out of it.

use super::watchers::Watchers;
use crate::error::SimulationError;
use crate::label::Label;
use crate::laws::contact::WallLaw;
use crate::laws::torque::TorqueLaw;
use crate::limited_drive::LimitedDrive;
use crate::motion::{Motion, PerMotion};
use crate::outcome::{Ended, Measures, Outcome, Stopping};
use crate::scene::{Lateral, Scene};
use crate::shortcuts::{BitAlone, pass_free_block};
use crate::start::Start;
use crate::stepper::Stepper;
use crate::system::System;
use crate::trajectory::Trajectory;
use crate::watch::axial::AxialMeasures;
use crate::watch::motor::MotorWatch;
use crate::watch::rules::Rules;
use crate::watch::surface::SurfaceMeasures;
use crate::watch::torsion::{TorsionMeasures, TorsionRegime};

/// A case under way.
pub(super) struct Case<'a, B: TorqueLaw, W: WallLaw> {
    system: &'a System,
    scene: &'a Scene<B, W>,
    rules: Rules,
    stopping: Stopping,
    /// Where nothing acts but the bit.
    alone: Option<&'a BitAlone>,
    stepper: Stepper<'a, B, W>,
    watch: Watchers,
}

/// How a case ended.
pub(super) struct End {
    ended: Ended,
    /// The last step that was stepped.
    last: usize,
    predicted: Option<Label>,
    /// Measures of settled whirl, which take the place of those of the closing window.
    settled: bool,
}

impl<'a, B: TorqueLaw, W: WallLaw> Case<'a, B, W> {
    /// A scene at its beginning, on which nothing may act but its bit where that is `alone`.
    pub(super) fn new(
        system: &'a System,
        scene: &'a Scene<B, W>,
        (stopping, alone): (Stopping, Option<&'a BitAlone>),
        stepper: Stepper<'a, B, W>,
    ) -> Self {
        let rules = Rules::USUAL;
        Self {
            system,
            scene,
            rules,
            stopping,
            alone,
            watch: Watchers::new(system, scene, rules, &stepper),
            stepper,
        }
    }

    /// Follows the torque along the string, too.
    pub(super) fn follow_torque(&mut self) {
        self.watch.follow_torque();
    }

    /// Steps to the end, or until the rest is certain or settled; `each` sees every step
    /// that is stepped.
    pub(super) fn step_through(
        &mut self,
        mut each: impl FnMut(&Stepper<B, W>),
    ) -> Result<End, SimulationError> {
        let mut end = End {
            ended: Ended::End,
            last: self.stepper.steps() - 1,
            predicted: None,
            settled: false,
        };
        if self.watch.is_empty() {
            // Nothing acts, and nothing is watched.
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
            if self.cannot_stick_again() {
                (end.ended, end.last) = (Ended::Certain, last - 1);
                return Ok(end);
            }
            if end.predicted.is_some() {
                continue;
            }
            if let Some(label) = self.settles() {
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
    pub(super) fn record(&mut self, record: &mut Trajectory) -> Result<End, SimulationError> {
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
    fn cannot_stick_again(&mut self) -> bool {
        let (Some(alone), Some(watch)) = (self.alone, &mut self.watch.bit) else {
            return false;
        };
        let law = self.scene.bit.as_ref();
        if !law.is_some_and(TorqueLaw::is_constant_in_slip) {
            return false;
        }
        let Some(speeds) = alone.cannot_stick_again(self.system, &self.stepper, watch, &self.rules)
        else {
            return false;
        };
        watch.turn_on(&speeds);
        true
    }

    /// The label that motion has settled to, if it has. A bit that cuts has the regime of its axis to wait
    /// for; below a motor, or a drive whose torque is limited, nothing tells it early.
    fn settles(&mut self) -> Option<Label> {
        let turns_otherwise = self.system.motor.is_some() || self.system.drive.is_some();
        if turns_otherwise || self.scene.axial.is_some() {
            return None;
        }
        let mut laws = self.scene.bit.iter();
        if !laws.all(TorqueLaw::is_autonomous) {
            return None;
        }
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
        let turns = self.scene.turns_against_rock() || !self.scene.friction.is_empty();
        // A string that lies on its wall swings more slowly than these windows, and accelerations are those
        // of the closing window.
        if turns
            || lateral.lying.is_some()
            || lateral.shocks.is_some()
            || !is_left_alone(lateral, self.system.sampling.start_of(step))
        {
            return None;
        }
        let (watch, settling) = self.watch.walls.as_mut()?;
        let has_settled = settling.see(self.stepper.contacts(), &lateral.walls);
        has_settled.then(|| Label::Lateral(settling.measures(watch).regime))
    }

    /// The rest of the time, in which the settled motion continues.
    fn take_as_settled(&mut self, label: Label) {
        let Some(watch) = &mut self.watch.bit else {
            return;
        };
        match label {
            Label::Torsion(TorsionRegime::StickSlip) => watch.repeat_last_cycle(),
            Label::Torsion(_) => watch.turn_on(&[self.scene.surface_speed]),
            Label::Lateral(_) | Label::Axial(_) => {}
        }
    }

    /// A case that begins with a steady motion has no first slip to wait for.
    fn torsion(&self, end: &End, surface: Option<&SurfaceMeasures>) -> Option<TorsionMeasures> {
        let watch = self.watch.bit.as_ref()?;
        let motor = self.watch.motor.as_ref();
        let faster = motor.map_or(0.0, MotorWatch::mean_relative_speed);
        let measures = watch.measures(self.scene.surface_speed + faster);
        // Settled motion changes by no more than it may.
        let may_change = end.ended == Ended::End && end.predicted.is_none();
        // A drive that lacks the torque for its speed gives all it has.
        let lacks = |(drive, surface): (&LimitedDrive, &SurfaceMeasures)| {
            surface.mean_torque > (1.0 - Rules::USUAL.settling_tolerance) * drive.limit()
        };
        let lacks_torque = self.system.drive.as_ref().zip(surface).is_some_and(lacks);
        let is_smooth = measures.regime == TorsionRegime::Smooth;
        Some(TorsionMeasures {
            first_slip: (measures.first_slip).filter(|_| self.scene.start == Start::Rest),
            motor_stalled_fraction: motor.map(MotorWatch::stalled_fraction),
            fades: measures.fades && may_change && (lacks_torque || !is_smooth),
            is_irregular: measures.is_irregular && may_change,
            ..measures
        })
    }

    fn axial(&self) -> Option<AxialMeasures> {
        let (watch, axial) = (self.watch.cut.as_ref()?, self.scene.axial.as_ref()?);
        Some(watch.measures(|weight, speed| axial.cutting.steady_rate(weight, speed)))
    }

    pub(super) fn outcome(&self, end: End) -> Result<Outcome, SimulationError> {
        let surface = self.watch.surface.as_ref().map(|torques| {
            let window = self.scene.timing.closing_window;
            SurfaceMeasures::of(torques, self.system.sampling, window)
        });
        let torsion = self.torsion(&end, surface.as_ref());
        let mut lateral = self.watch.walls.as_ref().map(|(watch, settling)| {
            if end.settled {
                settling.measures(watch)
            } else {
                watch.measures()
            }
        });
        // A string whose bit sticks and slips is swung by that.
        let is_driven = torsion.is_some_and(|it| it.regime == TorsionRegime::StickSlip);
        if let Some(lying) = lateral.as_mut().and_then(|it| it.lying.as_mut()) {
            lying.fades &= !is_driven;
        }
        Outcome {
            simulated: self.system.sampling.start_of(end.last),
            ended: end.ended,
            predicted: end.predicted,
            measures: PerMotion::from_fn(|motion| match motion {
                Motion::Torsion => torsion.map(Measures::Torsion),
                Motion::Lateral => lateral.map(Measures::Lateral),
                Motion::Axial => self.axial().map(Measures::Axial),
            }),
            surface,
            string_torque: (self.watch.along.as_ref())
                .map(|along| along.measures(self.system.sites.distances_from_bit())),
            stress: None,
        }
        .finite()
    }
}

/// Whether all impulses are over at a time, s.
fn is_left_alone<W>(lateral: &Lateral<W>, time: f64) -> bool {
    let mut impulses = lateral.impulses.iter();
    impulses.all(|impulse| impulse.is_quiet(time, f64::MAX))
}
