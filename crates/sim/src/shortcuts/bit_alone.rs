//! A string on which nothing acts but the torque on its bit: the motion until the first
//! slip, and that of a bit that never stops, need no stepping.

use linear::budget::Need;
use linear::{Responses, SteadyMotion};

use super::look_ahead::LookAhead;
use super::stuck_torque::StuckTorque;
use crate::convolution::Convolution;
use crate::error::SimulationError;
use crate::laws::contact::WallLaw;
use crate::laws::torque::TorqueLaw;
use crate::scene::Scene;
use crate::start::Start;
use crate::stepper::Stepper;
use crate::system::System;
use crate::watch::rules::Rules;
use crate::watch::torsion::BitWatch;

/// A wave has arrived when it has made this part of the speed that stays.
const ARRIVED: f64 = 1e-2;

/// What is known of such a string once for all cases.
#[derive(Debug, Clone)]
pub(crate) struct BitAlone {
    stuck_torque: StuckTorque,
    look_ahead: LookAhead,
    site: usize,
    /// The step from which the surface no longer changes what the bit does by more than
    /// settled motion may.
    steady_from: usize,
    /// Steps in which a wave goes from the bit to the surface and back.
    round_trip: usize,
}

impl BitAlone {
    /// Memory of a response of a number of taps, for cases of a number of steps.
    pub(crate) fn need(taps: usize, steps: f64) -> Need {
        let kept = StuckTorque::bytes(steps) + LookAhead::bytes(taps);
        Need {
            peak: kept + Convolution::bytes(1, 1, taps, steps),
            kept,
        }
    }

    /// Bytes of a case, without its past.
    pub(crate) fn case_bytes(taps: usize) -> f64 {
        LookAhead::look_bytes(taps)
    }

    /// Of responses that let nothing act but a torque on the bit.
    pub(crate) fn of(system: &System, responses: &Responses) -> Option<Self> {
        system.bit_port()?;
        let whole = system.torsion.whole()?;
        let &[site] = whole.loaded.as_slice() else {
            return None;
        };
        let kernels = whole.from_torques.kernels()?;
        if system.from_forces.is_some() {
            return None;
        }
        let surface = &whole.surface[site];
        let steps = system.steps_of(responses.longest_time);
        Some(Self {
            stuck_torque: StuckTorque::new(kernels, |step| surface.at(step), steps),
            look_ahead: LookAhead::new(responses.at_bit()?),
            site,
            round_trip: 2 * surface.arrives(ARRIVED),
            steady_from: surface.is_steady_from(Rules::USUAL.settling_tolerance),
        })
    }

    /// Whether cycles that agree up to a step are going to repeat themselves: not before the
    /// start of the surface is over, and not if they are so short that the surface has not
    /// answered them yet, as where a creeping bit sticks repeatedly through its collars.
    pub(crate) fn repeats(&self, start: &Start, step: usize, watch: &BitWatch) -> bool {
        let steady_from = match start {
            Start::Rest => self.steady_from,
            Start::Steady(_) => 0,
        };
        step >= steady_from && watch.agreeing_steps() >= self.round_trip && watch.is_settled()
    }

    /// The torque that holds the bit fast, N m per rad/s of surface speed.
    pub(crate) fn stuck_torque(&self) -> &[f64] {
        self.stuck_torque.torques()
    }

    /// A scene that begins at rest, from its first slip on where the law says when that is;
    /// another from its start on.
    pub(crate) fn stepper<'a, B: TorqueLaw, W: WallLaw>(
        &'a self,
        system: &'a System,
        scene: &'a Scene<B, W>,
        law: &B,
    ) -> Result<Stepper<'a, B, W>, SimulationError> {
        let begins_at_rest = scene.start == Start::Rest;
        let Some(torque_static) = law.holds().filter(|_| begins_at_rest) else {
            return Stepper::new(system, scene);
        };
        let slip = (self.stuck_torque).first_slip(scene.surface_speed, torque_static);
        Stepper::at_first_slip(system, scene, self.stuck_torque(), slip)
    }

    /// The speeds that the bit is going to have, if it never stops again; they are looked
    /// for once after each slip, when it has been turning for as long as `rules` say.
    pub(crate) fn cannot_stick_again<B: TorqueLaw, W: WallLaw>(
        &self,
        system: &System,
        stepper: &Stepper<B, W>,
        watch: &BitWatch,
        rules: &Rules,
    ) -> Option<Vec<f64>> {
        let (step, memory) = (stepper.next_step(), self.look_ahead.memory());
        // A look ahead costs about as much as stepping half of what it sees.
        let is_time = watch.turning_for() == rules.turning_for * memory / 100
            && stepper.steps() - (step - 1) > memory / 2;
        if !is_time {
            return None;
        }
        let speeds = match stepper.start().steady() {
            None => self.speeds_after_rest(system, stepper)?,
            Some(motion) => self.speeds_after(motion, system, stepper)?,
        };
        let now = stepper.bit_step()?;
        let keeps_on = |next: &f64| next.is_finite() && next * now.speed > 0.0;
        speeds.iter().all(keeps_on).then_some(speeds)
    }

    /// The speeds of a bit that turns on, in a case that began with a steady motion: what its
    /// torque differs by from that of this motion grows as evenly as that does.
    fn speeds_after<B: TorqueLaw, W: WallLaw>(
        &self,
        motion: &SteadyMotion,
        system: &System,
        stepper: &Stepper<B, W>,
    ) -> Option<Vec<f64>> {
        let (step, memory) = (stepper.next_step(), self.look_ahead.memory());
        let torque = stepper.bit_step()?.torque - motion.at_bit.at(system.sampling.time_of(step));
        let growth = -motion.at_bit.rate / system.sampling.frequency;
        let past = &stepper.torques(0)[step.saturating_sub(memory)..];
        let mut speeds = (self.look_ahead).speeds(past.iter().copied(), torque, growth);
        for speed in &mut speeds {
            *speed += motion.speeds[self.site];
        }
        Some(speeds)
    }

    /// The same in a case that began at rest, as soon as the surface will have settled by then.
    fn speeds_after_rest<B: TorqueLaw, W: WallLaw>(
        &self,
        system: &System,
        stepper: &Stepper<B, W>,
    ) -> Option<Vec<f64>> {
        let (step, memory) = (stepper.next_step(), self.look_ahead.memory());
        let surface = &system.torsion.whole()?.surface[self.site];
        if step + memory <= surface.settles() {
            return None;
        }
        let (now, speed) = (stepper.bit_step()?, stepper.surface_speed());
        // Torques on a bit that was free at first are known as they are.
        let held = |step: usize| match stepper.is_held_at_first() {
            true => speed * self.stuck_torque()[step],
            false => 0.0,
        };
        let slip = step - stepper.torques(0).len();
        let first = step.saturating_sub(memory);
        let before = (first..slip.max(first)).map(held);
        let since = slip.max(first)..step;
        let torques = since.map(|n| stepper.torques(0)[n - slip] + held(n));
        let mut speeds = (self.look_ahead).speeds(before.chain(torques), now.torque, 0.0);
        for (ahead, value) in speeds.iter_mut().enumerate() {
            *value += speed * surface.at(step + ahead);
        }
        Some(speeds)
    }
}
