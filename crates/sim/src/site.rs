//! The laws that act at one site with a wall, coupled: friction there turns the bit that
//! the rock holds (Eq. 36).

use crate::laws::contact::{Approach, Contact, ContactError, Resistance, Spin, WallLaw};
use crate::laws::torque::{LoadLine, TorqueLaw, TorqueStep};
use crate::sampling::Sampling;

/// What a step leaves open in bending, the loads of other sites given: the position is
/// `free_position + compliance × force`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LateralLine {
    pub(crate) free_position: [f64; 2],
    pub(crate) previous_position: [f64; 2],
    pub(crate) previous_sliding_speed: Option<f64>,
    pub(crate) compliance: f64,
    pub(crate) sampling: Sampling,
}

impl LateralLine {
    /// The force, N, that a site without a load may be pushed by before it reaches its wall.
    pub(crate) fn slack(&self, clearance: f64) -> f64 {
        let [x, y] = self.free_position;
        ((clearance - x.hypot(y)) / self.compliance).max(0.0)
    }
}

/// The laws at a site.
#[derive(Debug)]
pub(crate) struct SiteLaws<'a, B: TorqueLaw, W> {
    /// The law of the bit, with its state, where the site is the bit and cuts.
    pub(crate) bit: Option<(&'a B, &'a B::State)>,
    /// The wall.
    pub(crate) wall: &'a W,
}

/// One step of one site.
#[derive(Debug, Clone)]
pub(crate) struct SiteStep<S> {
    pub(crate) contact: Contact,
    /// Rotation speed, rad/s.
    pub(crate) speed: f64,
    pub(crate) bit: Option<TorqueStep<S>>,
}

/// What acts on a site in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Load {
    /// Force, N.
    pub(crate) force: [f64; 2],
    /// Torque, N m.
    pub(crate) torque: f64,
}

impl<S> SiteStep<S> {
    /// What both laws do to the string.
    pub(crate) fn load(&self) -> Load {
        Load {
            force: self.contact.force,
            torque: self.contact.torque + self.bit.as_ref().map_or(0.0, |bit| bit.torque),
        }
    }
}

impl<B: TorqueLaw, W: WallLaw> SiteLaws<'_, B, W> {
    /// Meets both load lines.
    #[inline]
    pub(crate) fn meet(
        &self,
        line: LoadLine,
        lateral: LateralLine,
    ) -> Result<SiteStep<B::State>, ContactError> {
        let turned = |free_speed: f64| {
            let line = LoadLine { free_speed, ..line };
            self.bit.map(|(law, before)| law.meet(before, line))
        };
        let speed = |free: f64| turned(free).map_or(free, |bit| bit.speed);
        let resistance = self.bit.map(|(law, _)| Resistance {
            speed: &speed,
            jump: line.compliance * law.largest_drop(),
        });
        let contact = self.wall.meet(&Approach {
            free_position: lateral.free_position,
            previous_position: lateral.previous_position,
            previous_sliding_speed: lateral.previous_sliding_speed,
            compliance: lateral.compliance,
            spin: Spin {
                free_speed: line.free_speed,
                compliance: line.compliance,
                resistance,
            },
            sampling: lateral.sampling,
        })?;
        let free_speed = line.free_speed + line.compliance * contact.torque;
        let bit = turned(free_speed);
        Ok(SiteStep {
            contact,
            speed: bit.as_ref().map_or(free_speed, |bit| bit.speed),
            bit,
        })
    }
}
