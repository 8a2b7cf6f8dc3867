//! The string along its axis above a bit that cuts: where the past and its surface bring the bit,
//! and where the rock leaves it.

use crate::error::SimulationError;
use crate::laws::cutting::{AxialLine, BitPlace, CutStep, CuttingForces, Face};
use crate::laws::torque::LoadLine;
use crate::line::{AxialLines, Past};
use crate::scene::{Axial, Kick};
use crate::system::System;

/// The motion of the bit along the axis, with the rock before it.
#[derive(Debug)]
pub(crate) struct AxialMotion<'a> {
    lines: &'a AxialLines,
    scene: &'a Axial,
    forces: CuttingForces,
    /// Forces on the bit, or what they differ by from those of a steady start.
    past: Past<'a, 1, 1>,
    /// Rate of penetration and weight of a steady start, m/s and N.
    steady: Option<[f64; 2]>,
    place: BitPlace,
    face: Face,
    line: AxialLine,
    /// The least angle from one blade to the next, rad.
    apart: f64,
    /// Disturbance of this step, N m and N.
    kick: [f64; 2],
}

impl<'a> AxialMotion<'a> {
    /// At its start: at rest on flat rock, or, where the bit turns steadily at a `speed` (rad/s),
    /// penetrating steadily.
    ///
    /// # Errors
    /// Where the system has no axial motion.
    pub(crate) fn new(
        system: &'a System,
        scene: &'a Axial,
        speed: Option<f64>,
        steps: usize,
    ) -> Result<Self, SimulationError> {
        let lines = system.axial.as_ref().ok_or(SimulationError::NoAxialInput)?;
        let advance = speed.map_or(0.0, |speed| scene.start_rate / speed);
        let apart = scene.cutting.blade_angles();
        let mean = std::f64::consts::TAU / scene.cutting.blades() as f64;
        let steady = speed.map(|_| [scene.start_rate, scene.cutting.steady(advance * mean)[1]]);
        let step = system.sampling.frequency.recip();
        // Responses answer means over two neighbouring samples as they answer the samples. So the law
        // is met in the middle of a step by all: at its end, rock that is as stiff as k would damp the
        // bit by kΔt/2.
        let within = 0.5 * step;
        Ok(Self {
            lines,
            scene,
            forces: scene.cutting.forces(),
            past: lines.from_forces.past(steps),
            steady,
            place: BitPlace {
                speed: speed.unwrap_or(0.0),
                ..BitPlace::default()
            },
            face: scene.cutting.face(advance),
            line: AxialLine {
                free_speed: 0.0,
                compliance: lines.from_forces.instant(0, 0),
                within,
                step,
            },
            apart: apart.into_iter().fold(f64::INFINITY, f64::min),
            kick: [0.0; 2],
        })
    }

    /// The weight of a steady start, N; zero from rest.
    pub(crate) fn weight_at_start(&self) -> f64 {
        self.steady.map_or(0.0, |[_, weight]| weight)
    }

    /// What a step does without weight on the bit.
    pub(crate) fn find_free_motion(&mut self, step: usize, time: f64) {
        let mut past = [0.0];
        self.past.write_past(&mut past);
        self.kick = self.scene.kick.map_or([0.0; 2], |kick| kick.at(time));
        let compliance = self.line.compliance;
        let driven = match self.steady {
            Some([rate, weight]) => rate + compliance * weight,
            None if self.scene.feed == 0.0 => 0.0,
            None => self.scene.feed * self.lines.surface.at(step),
        };
        self.line.free_speed = past[0] + driven + compliance * self.kick[1];
    }

    /// The torque of a disturbance in this step, N m.
    pub(crate) fn kick(&self) -> f64 {
        self.kick[0]
    }

    /// What the bit does in this step on the load line of its rotation.
    #[inline]
    pub(crate) fn meet(&self, line: LoadLine) -> CutStep {
        self.forces.meet(&self.place, &self.face, line, &self.line)
    }

    /// Whether the bit turns past a blade before the law is met: then it cuts what is not there.
    pub(crate) fn passes_a_blade(&self, speed: f64) -> bool {
        self.line.within * speed.abs() >= self.apart
    }

    /// Ends a step with what the bit did.
    pub(crate) fn end_step(&mut self, cut: &CutStep) {
        let weight = self.weight_at_start();
        self.past.add(&[weight - cut.weight + self.kick[1]]);
        let place = &mut self.place;
        place.angle += self.line.step * cut.speed;
        place.depth += self.line.step * cut.rate;
        place.speed = cut.speed;
        self.face.leave(place.angle, place.depth);
        if cut.speed > 0.0 || place.depth > place.deepest {
            place.deepest = place.depth;
        }
    }
}

impl Kick {
    /// Torque and force on the bit at a time (s), N m and N.
    pub(crate) fn at(&self, time: f64) -> [f64; 2] {
        match time < self.duration {
            true => [self.torque, self.force],
            false => [0.0; 2],
        }
    }
}
