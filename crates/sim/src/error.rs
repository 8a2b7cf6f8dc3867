//! What keeps a case from having an answer.

use linear::ResponseError;
use thiserror::Error;

use crate::laws::contact::ContactError;
use crate::ranges::SceneError;

/// A case that gives no answer. Sites are counted from the surface down, from 0.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SimulationError {
    /// The motion stopped being a number.
    #[error("the motion of site {site} is not finite from {time:.6} s on")]
    NotFinite {
        /// The site.
        site: usize,
        /// Time of the first such step, s.
        time: f64,
    },
    /// The law of the wall has no solution in finite numbers.
    #[error("no force of the wall on site {site} solves the step at {time:.6} s")]
    NoContactForce {
        /// The site.
        site: usize,
        /// Time of the step, s.
        time: f64,
    },
    /// What was measured over the case is no number, though every step was.
    #[error("the {measure} of the motion is not finite")]
    NotMeasured {
        /// Which measure.
        measure: &'static str,
    },
    /// Sites that touch one another within a step did not settle.
    #[error("coupled sites do not settle at {time:.6} s; a higher sampling frequency parts them")]
    NotSettled {
        /// Time of the step, s.
        time: f64,
    },
    /// A torque acts on the bit, but the responses have no such input.
    #[error("the responses were built without a torque at the bit")]
    NoTorqueInput,
    /// The scene has axial motion, but the system none.
    #[error("the scene has axial motion, but the system was built without a force at the bit")]
    NoAxialInput,
    /// A bit turns past a blade within half a step.
    #[error(
        "the bit turns past a blade within half a step at {time:.6} s; a higher sampling \
         frequency lets it cut"
    )]
    PastABlade {
        /// Time of the step, s.
        time: f64,
    },
    /// A spring that holds a site of the linear string is too stiff to be taken back within a step.
    #[error(
        "the spring at site {site} is too stiff to be taken back within a step; a higher sampling \
         frequency lets it"
    )]
    SpringTooStiff {
        /// The site.
        site: usize,
    },
    /// A drive of limited torque is not that of the string.
    #[error(
        "a drive of limited torque turns a string as a whole with torques at {found} sites, not one in pieces or \
         with {ports}"
    )]
    NotOfItsDrive {
        /// Sites of the string that torques may act on.
        ports: usize,
        /// Of the drive.
        found: usize,
    },
    /// Within a step a drive opposes more than all that there is.
    #[error(
        "the drive's controller is too stiff for these steps; a higher sampling frequency lets its \
         torque be limited"
    )]
    DriveTooStiff,
    /// The scene has walls, but the responses no bending.
    #[error("the scene has walls, but the responses were built without bending")]
    NoForceInput,
    /// There are more walls than sites, or fewer.
    #[error("the scene has {walls} walls for {sites} sites")]
    NotAWallForEachSite {
        /// Number of walls.
        walls: usize,
        /// Number of sites.
        sites: usize,
    },
    /// There is friction along the string for more sites than may bear a torque, or fewer.
    #[error("the scene has friction at {friction} sites for {sites} that a torque may act on")]
    NotFrictionForEachSite {
        /// Number of sites with or without friction.
        friction: usize,
        /// Number of sites that a torque may act on.
        sites: usize,
    },
    /// How far friction has wound up a string depends on all that it did before.
    #[error("a case with friction along the string begins at rest")]
    SteadyWithFriction,
    /// A string turns and bends by other steps.
    #[error("the responses in bending have another sampling frequency than the string in torsion")]
    UnlikeSteps,
    /// Forces act at sites where no torque may act: friction would turn nothing.
    #[error("the responses in bending need a torque at each of their sites")]
    UnlikeChannels,
    /// The responses were built for shorter cases.
    #[error("the case lasts {duration} s, but its responses were built for {prepared} s")]
    LongerThanPrepared {
        /// Time of the case, s.
        duration: f64,
        /// Time that the responses are good for, s.
        prepared: f64,
    },
    /// The scene is refused.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The responses are not those of a string.
    #[error(transparent)]
    Responses(#[from] ResponseError),
}

impl SimulationError {
    /// The site that it is about, where it is about one.
    pub fn site(&self) -> Option<usize> {
        match self {
            Self::NotFinite { site, .. } | Self::NoContactForce { site, .. } => Some(*site),
            _ => None,
        }
    }

    /// A step of one site that has no answer.
    pub(crate) fn of_contact(error: ContactError, site: usize, time: f64) -> Self {
        match error {
            ContactError::NotFinite => Self::NotFinite { site, time },
            ContactError::Unsolved => Self::NoContactForce { site, time },
        }
    }
}
