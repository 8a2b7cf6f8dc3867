//! The motion that a case begins with.

use linear::SteadyMotion;

use crate::ranges::{SceneError, finite};

/// The motion that a case begins with.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum Start {
    /// Rest: the surface then turns as its system says ([`crate::SurfaceProfile`]).
    #[default]
    Rest,
    /// A steady motion at the speed of the scene, which lasts until the torque on the bit, or at
    /// a wall, is another. A bit at rest is held by the rock, one that turns slides.
    Steady(SteadyMotion),
}

impl Start {
    /// The steady motion, where the case begins with one.
    pub fn steady(&self) -> Option<&SteadyMotion> {
        match self {
            Self::Rest => None,
            Self::Steady(motion) => Some(motion),
        }
    }

    /// Checks that it is a motion of this number of sites.
    pub(crate) fn check(&self, sites: usize) -> Result<(), SceneError> {
        let Some(motion) = self.steady() else {
            return Ok(());
        };
        if motion.speeds.len() != sites {
            let found = motion.speeds.len();
            return Err(SceneError::StartOfOtherSites { found, sites });
        }
        for speed in &motion.speeds {
            finite("speed of a site at the start in rad/s", *speed)?;
        }
        finite(
            "torque on the bit at the start in N m",
            motion.at_bit.torque,
        )?;
        finite("rate of the torque on the bit in N m/s", motion.at_bit.rate)
    }
}
