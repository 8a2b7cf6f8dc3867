//! What is seen of a scene under way: by who watches it, by its history, and by what leaves steps out.

use super::{Acting, Reference, Step, Stepper};
use crate::coupling::Load;
use crate::lateral_motion::LateralMotion;
use crate::laws::contact::{Contact, WallLaw};
use crate::laws::torque::{BitMotion, TorqueLaw, TorqueStep};
use crate::line::TorsionPast;
use crate::start::Start;

impl<B: TorqueLaw, W: WallLaw> Stepper<'_, B, W> {
    /// The motion that the scene begins with.
    pub(crate) fn start(&self) -> &Start {
        &self.scene.start
    }

    /// Surface rotation speed of the scene, rad/s.
    pub(crate) fn surface_speed(&self) -> f64 {
        self.scene.surface_speed
    }

    /// Whether torques are what the bit's differ by from those that hold it fast.
    pub(crate) fn is_held_at_first(&self) -> bool {
        matches!(self.reference, Reference::Stuck(_))
    }

    /// How the bit turned in the last step, and its speed, rad/s, where a law acts there.
    #[inline]
    pub(crate) fn bit_motion(&self) -> Option<(BitMotion, f64)> {
        if let Some(cut) = &self.now.cut {
            return Some((BitMotion::of(cut.speed), cut.speed));
        }
        let ((law, _), step) = self.bit.zip(self.now.bit.as_ref())?;
        Some((law.motion(step), step.speed))
    }

    /// The same where nothing else acts.
    #[inline]
    pub(crate) fn bit_alone(&self) -> Option<(BitMotion, f64)> {
        let ((law, _), step) =
            (self.bit.filter(|_| self.acting == Acting::Bit)).zip(self.now.bit.as_ref())?;
        Some((law.motion(step), step.speed))
    }

    /// What the bit did in the last step.
    pub(crate) fn bit_step(&self) -> Option<&TorqueStep<B::State>> {
        self.now.bit.as_ref()
    }

    /// The port of a bit below a motor, its speed (rad/s) and what the motor passes on, N m.
    pub(crate) fn below_motor(&self) -> Option<(usize, f64, f64)> {
        self.motor.as_ref()?;
        let (port, (_, speed)) = (self.bit_port()?, self.bit_motion()?);
        Some((port, speed, -self.coupling.loads()[port].torque))
    }

    /// Torque of the rock on the bit in the last step, where a law acts there, N m.
    pub(crate) fn bit_torque(&self) -> Option<f64> {
        let by_law = self.now.bit.as_ref().map(|bit| bit.torque);
        by_law.or(self.now.cut.map(|cut| -cut.torque))
    }

    /// Weight on a bit that cuts of the steady drilling that the scene begins with, N; zero where there is none.
    pub(crate) fn weight_at_start(&self) -> f64 {
        (self.axial.as_ref()).map_or(0.0, |(axial, _)| axial.weight_at_start())
    }

    /// What the walls did in the last step.
    pub(crate) fn contacts(&self) -> &[Contact] {
        &self.now.contacts
    }

    /// How fast what is at each wall turned in the last step, rad/s.
    pub(crate) fn speeds_at_walls(&self) -> impl Iterator<Item = f64> {
        let turned = self.turned.as_ref().unwrap_or(&self.now.speeds);
        let ports = self.system.walls.ports().iter();
        ports.map(|&port| turned[port])
    }

    /// All torques on a port so far, as the reference motion is left by them, N m.
    pub(crate) fn torques(&self, port: usize) -> &[f64] {
        self.torsion.torques(port)
    }

    /// Torques in the string in the last step just above and just below each port, N m, positive
    /// where what is above turns what is below; nothing unless it is in pieces.
    pub(crate) fn string_torques(&self) -> impl Iterator<Item = [f64; 2]> {
        let pieces = match &self.torsion {
            TorsionPast::Whole(..) => None,
            TorsionPast::Pieces(pieces) => Some(pieces),
        };
        let loads = || self.coupling.loads().iter().map(|load| load.torque);
        let torques = pieces.map(|pieces| pieces.string_torques(&self.now.speeds, loads()));
        torques.into_iter().flatten()
    }

    /// Whether a law of torsion holds a port in the last step.
    pub(crate) fn is_any_stuck(&self) -> bool {
        let at_bit = self.bit_port();
        let rubs = self.friction.iter().enumerate();
        let mut ports = rubs
            .filter_map(|(port, law)| law.map(|_| port))
            .chain(at_bit);
        ports.any(|port| self.now.speeds[port] == 0.0)
    }

    /// What acted on each port in the last step.
    pub(crate) fn loads(&self) -> &[Load] {
        self.coupling.loads()
    }

    /// What the last step was.
    pub(crate) fn now(&self) -> &Step<B::State> {
        &self.now
    }

    /// The lowest port that a law of torsion acts on.
    pub(crate) fn lowest_law(&self) -> Option<usize> {
        let rubs = self.friction.iter().rposition(Option::is_some);
        self.bit_port().max(rubs)
    }

    /// All forces on a site so far along an axis, disturbances included, N.
    pub(crate) fn forces(&self, axis: usize, site: usize) -> &[f64] {
        (self.lateral.as_ref()).map_or(&[], |lateral| lateral.forces(axis, site))
    }

    /// At the beginning of a block, displacements of all sites through it, x of all sites
    /// and then y, as long as nothing acts.
    pub(crate) fn free_block(&self) -> Option<&[f64]> {
        self.lateral.as_ref()?.free_block()
    }

    /// Where the sites are at the end of a block in which they are at `x` and `y`, a block
    /// each.
    pub(crate) fn end_of_block(&self, x: &[f64], y: &[f64], block: usize) -> Vec<[f64; 2]> {
        let beginnings = self.lateral.iter().flat_map(LateralMotion::positions);
        let sites = x.chunks_exact(block).zip(y.chunks_exact(block));
        let end = |(beginning, (x, y)): (&[f64; 2], (&[f64], &[f64]))| {
            let positions = x.iter().zip(y).map(|(x, y)| [*x, *y]);
            positions.fold(*beginning, |beginning, position| {
                self.system.sampling.end_of_step(position, beginning)
            })
        };
        beginnings.zip(sites).map(end).collect()
    }
}
