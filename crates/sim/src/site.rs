//! The laws that act at one site, coupled: friction at the wall turns the bit that the
//! rock holds (Eq. 36).

use crate::laws::contact::{Approach, Contact, ContactError, Resistance, Spin, WallLaw};
use crate::laws::torque::{LoadLine, TorqueLaw, TorqueStep};

/// What a step leaves open in bending, the loads of other sites given: the position is
/// `free_position + compliance × force`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LateralLine {
    pub(crate) free_position: [f64; 2],
    pub(crate) previous_position: [f64; 2],
    pub(crate) compliance: f64,
    pub(crate) sampling_frequency: f64,
}

/// The laws at a site, of which there may be either or both.
#[derive(Debug)]
pub(crate) struct SiteLaws<'a, B: TorqueLaw, W> {
    /// The law of the bit, with its state.
    pub(crate) bit: Option<(&'a B, &'a B::State)>,
    /// The wall, with the load line in bending.
    pub(crate) wall: Option<(&'a W, LateralLine)>,
}

/// One step of one site.
#[derive(Debug, Clone)]
pub(crate) struct SiteStep<S> {
    pub(crate) contact: Contact,
    /// Rotation speed, rad/s.
    pub(crate) speed: f64,
    pub(crate) bit: Option<TorqueStep<S>>,
}

impl<S> SiteStep<S> {
    /// Torque on the string of both laws, N m.
    pub(crate) fn torque(&self) -> f64 {
        self.contact.torque + self.bit.as_ref().map_or(0.0, |bit| bit.torque)
    }
}

impl<B: TorqueLaw, W: WallLaw> SiteLaws<'_, B, W> {
    /// Meets the load line in torsion, and that in bending where there is a wall.
    #[inline]
    pub(crate) fn meet(&self, line: LoadLine) -> Result<SiteStep<B::State>, ContactError> {
        let turned = |free_speed: f64| {
            let line = LoadLine { free_speed, ..line };
            self.bit.map(|(law, before)| law.meet(before, line))
        };
        let contact = match &self.wall {
            None => Contact::NONE,
            Some((wall, lateral)) => {
                let speed = |free: f64| turned(free).map_or(free, |bit| bit.speed);
                let resistance = self.bit.map(|(law, _)| Resistance {
                    speed: &speed,
                    jump: line.compliance * law.largest_drop(),
                });
                wall.meet(&Approach {
                    free_position: lateral.free_position,
                    previous_position: lateral.previous_position,
                    compliance: lateral.compliance,
                    spin: Spin {
                        free_speed: line.free_speed,
                        compliance: line.compliance,
                        resistance,
                    },
                    sampling_frequency: lateral.sampling_frequency,
                })?
            }
        };
        let free_speed = line.free_speed + line.compliance * contact.torque;
        let bit = turned(free_speed);
        Ok(SiteStep {
            contact,
            speed: bit.as_ref().map_or(free_speed, |bit| bit.speed),
            bit,
        })
    }
}
