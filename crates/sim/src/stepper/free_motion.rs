//! What ports and walls do in a step before any law answers: the motion that the scene refers its
//! loads to, and what the past adds.

use linear::SteadyMotion;

use super::Stepper;
use crate::laws::contact::WallLaw;
use crate::laws::torque::TorqueLaw;
use crate::line::Within;

/// The motion that all loads are added to: until it leaves that motion, nothing has to
/// be stepped.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reference<'a> {
    /// The surface turns a string that is free.
    Free,
    /// The surface turns a string whose bit is held fast, by these torques per unit of
    /// its speed. Loads are what the torques on the bit, the only ones, differ by.
    Stuck(&'a [f64]),
    /// No speed changes. The load of the bit is what its torque differs by.
    Steady(&'a SteadyMotion),
}

impl<B: TorqueLaw, W: WallLaw> Stepper<'_, B, W> {
    /// What ports and walls do in this step if no law answered.
    #[inline]
    pub(super) fn find_free_motion(&mut self) {
        let (scene, step) = (self.scene, self.next);
        let surface_speed = match self.reference {
            Reference::Free => Some(scene.surface_speed),
            Reference::Stuck(_) | Reference::Steady(_) => None,
        };
        self.torsion.write_free(step, surface_speed, &mut self.free);
        match self.reference {
            Reference::Free => {}
            Reference::Stuck(stuck) => {
                self.held = scene.surface_speed * stuck[step];
                self.free[0] -= self.within.compliance(0) * self.held;
            }
            Reference::Steady(motion) => self.add_steady_motion(motion),
        }
        if let Some(lateral) = &mut self.lateral {
            lateral.find_free_motion(self.now.time, &self.now.speeds);
        }
        self.find_axial_motion();
    }

    /// The same along the axis; a disturbance turns the bit, too.
    #[inline]
    fn find_axial_motion(&mut self) {
        let Some((axial, port)) = &mut self.axial else {
            return;
        };
        axial.find_free_motion(self.next, self.now.time);
        let kick = axial.kick();
        if kick == 0.0 {
            return;
        }
        match self.within {
            Within::All(torsion) => {
                for (index, free) in self.free.iter_mut().enumerate() {
                    *free += torsion.instant(index, *port) * kick;
                }
            }
            Within::Chain(_) => self.free[*port] += kick,
        }
    }

    /// The motion that the scene began with, without the torque that holds or brakes the bit in it.
    #[inline]
    fn add_steady_motion(&mut self, motion: &SteadyMotion) {
        let loaded = self.system.torsion.loaded();
        let at_bit = self.bit_port();
        if at_bit.is_some() {
            self.held = motion.at_bit.at(self.now.time);
        }
        match self.within {
            Within::All(torsion) => {
                for (speed, site) in self.free.iter_mut().zip(loaded) {
                    *speed += motion.speeds[*site];
                }
                if let Some(port) = at_bit {
                    for (index, speed) in self.free.iter_mut().enumerate() {
                        *speed -= torsion.instant(index, port) * self.held;
                    }
                }
            }
            Within::Chain(chain) => {
                for (port, driving) in self.free.iter_mut().enumerate() {
                    *driving += chain.taken(port, &motion.speeds);
                }
                if let Some(port) = at_bit {
                    self.free[port] -= self.held;
                }
            }
        }
    }
}
