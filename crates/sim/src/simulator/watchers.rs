//! Who watches a case: regimes, measures, and whether the motion has settled.

use crate::laws::contact::WallLaw;
use crate::laws::torque::TorqueLaw;
use crate::scene::Scene;
use crate::stepper::Stepper;
use crate::system::System;
use crate::watch::along::StringTorqueWatch;
use crate::watch::axial::CutWatch;
use crate::watch::lateral::WallWatch;
use crate::watch::motor::MotorWatch;
use crate::watch::rubbing::RubbingWatch;
use crate::watch::rules::Rules;
use crate::watch::settling::Settling;
use crate::watch::torsion::BitWatch;

/// Who watches a case.
pub(super) struct Watchers {
    pub(super) bit: Option<BitWatch>,
    /// The lowest port that a law acts on, where that is not the bit.
    rubs_at: Option<usize>,
    pub(super) walls: Option<(WallWatch, Settling)>,
    pub(super) cut: Option<CutWatch>,
    pub(super) rubbing: Option<RubbingWatch>,
    /// What turned the surface in each step, N m.
    pub(super) surface: Option<Vec<f64>>,
    pub(super) along: Option<StringTorqueWatch>,
    /// The mud motor, where a bit turns below one.
    pub(super) motor: Option<MotorWatch>,
}

impl Watchers {
    /// Those that a scene needs.
    pub(super) fn new<B: TorqueLaw, W: WallLaw>(
        system: &System,
        scene: &Scene<B, W>,
        rules: Rules,
        stepper: &Stepper<B, W>,
    ) -> Self {
        let (sampling, steps) = (system.sampling, stepper.steps());
        let window = scene.timing.closing_window;
        let lowest = stepper.lowest_law();
        let bit = lowest.map(|_| {
            let mut watch = BitWatch::new(rules, sampling, steps, window)
                .that_may_stall(system.drive.is_some());
            if scene.axial.is_some() {
                watch = watch.creeping(scene.surface_speed);
            }
            watch.skip_stuck(stepper.next_step().min(steps));
            watch
        });
        let walls = scene.lateral.as_ref().map(|lateral| {
            let sites = system.walls.len();
            let speed = scene.surface_speed;
            let walls = WallWatch::new(rules, sites, speed, sampling, (steps, window));
            (
                walls.of_lying(lateral.lying.as_ref()).of_shocks(lateral),
                Settling::new(rules, sites, sampling.frequency, steps),
            )
        });
        Self {
            bit,
            rubs_at: lowest.filter(|_| !scene.turns_against_rock()),
            walls,
            cut: (scene.axial.as_ref()).map(|_| CutWatch::new(rules, sampling, steps, window)),
            rubbing: (!scene.friction.is_empty() && scene.lateral.is_none()).then(|| {
                let steady_from = system.torsion.steady_from(rules.settling_tolerance);
                let window = (window * sampling.frequency).round() as usize;
                RubbingWatch::new(rules, scene.surface_speed, steady_from, window)
            }),
            surface: (system.knows_surface()).then(|| Vec::with_capacity(steps)),
            along: None,
            motor: system.motor.map(|motor| {
                let window = (window * sampling.frequency).round() as usize;
                MotorWatch::new(motor, steps.saturating_sub(window.max(1)))
            }),
        }
    }

    /// What was done in the last step.
    #[inline]
    pub(super) fn see<B: TorqueLaw, W: WallLaw>(&mut self, stepper: &Stepper<B, W>) {
        let now = stepper.now();
        if let (Some((motion, speed)), Some(watch)) = (stepper.bit_alone(), &mut self.bit) {
            return watch.see(motion, speed);
        }
        match (&mut self.bit, stepper.bit_motion(), self.rubs_at) {
            (Some(watch), Some((motion, speed)), _) => watch.see(motion, speed),
            // What is stuck lowest holds a free bit but for its swinging.
            (Some(watch), None, Some(port)) => {
                let speed = now.speeds.last().copied().unwrap_or_default();
                watch.see(now.rubbing[port].motion, speed);
            }
            _ => {}
        }
        if let Some((watch, _)) = &mut self.walls {
            watch.see(&now.contacts, stepper.speeds_at_walls());
        }
        if let (Some(watch), Some(cut)) = (&mut self.cut, &now.cut) {
            watch.see(cut);
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
        if let (Some(watch), Some((port, speed, passed))) = (&mut self.motor, stepper.below_motor())
        {
            watch.see(stepper.next_step() - 1, passed, speed - now.speeds[port]);
        }
    }

    /// Whether nothing is watched.
    pub(super) fn is_empty(&self) -> bool {
        self.bit.is_none() && self.walls.is_none() && self.surface.is_none()
    }

    /// Follows the torque along the string, too, where it is in pieces.
    pub(super) fn follow_torque(&mut self) {
        self.along = self.surface.is_some().then(StringTorqueWatch::default);
    }
}
