//! What one case contains.

use thiserror::Error;

use crate::duration::Timing;
use crate::excitation::{EccentricMass, Impulse};
use crate::laws::bit::BitTorque;
use crate::laws::wall::Wall;

/// One case, from rest: the surface starts to turn at t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Surface rotation speed Ω from t = 0 on, rad/s.
    pub surface_speed: f64,
    /// Torque at the bit; `None` leaves it free.
    pub bit: Option<BitTorque>,
    /// Lateral motion, where it is modelled.
    pub lateral: Option<Lateral>,
    /// Time simulated and closing window.
    pub timing: Timing,
}

/// The lateral part of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Lateral {
    /// The borehole wall at each site, from the surface down.
    pub walls: Vec<Wall>,
    /// Disturbances.
    pub impulses: Vec<Impulse>,
    /// Eccentric masses.
    pub eccentric_masses: Vec<EccentricMass>,
}

/// A scene that cannot be.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum SceneError {
    /// A number is out of its range.
    #[error("the {quantity} is {value}, but must be {expected}")]
    OutOfRange {
        /// What the number says, with its unit.
        quantity: &'static str,
        /// The value found.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// The bit holds less torque than turns it.
    #[error(
        "the bit holds {torque_static} N m at most, less than the {torque_dynamic} N m \
         against it when it turns"
    )]
    Torques {
        /// T_s, N m.
        torque_static: f64,
        /// T_d, N m.
        torque_dynamic: f64,
    },
    /// Something acts at a site that there is not.
    #[error("{what} acts at site {site}, but the {sites} sites are counted from 0")]
    NoSuchSite {
        /// What acts there.
        what: &'static str,
        /// The site named.
        site: usize,
        /// How many sites there are.
        sites: usize,
    },
}

const FINITE: &str = "a finite number";
const POSITIVE: &str = "a positive finite number";
const NOT_NEGATIVE: &str = "zero or a positive finite number";

impl Scene {
    /// Checks that it can be simulated: every number in its range, everything at
    /// one of the `sites`.
    pub(crate) fn check(&self, sites: usize) -> Result<(), SceneError> {
        finite("surface speed in rad/s", self.surface_speed)?;
        not_negative("time simulated in s", self.timing.duration)?;
        not_negative("closing window in s", self.timing.closing_window)?;
        self.bit.iter().try_for_each(BitTorque::check)?;
        let Some(lateral) = &self.lateral else {
            return Ok(());
        };
        lateral.walls.iter().try_for_each(Wall::check)?;
        for impulse in &lateral.impulses {
            known_site("an impulse", impulse.site, sites)?;
            finite("amount of an impulse in N s", impulse.amount)?;
            finite("start of an impulse in s", impulse.start)?;
            finite("direction of an impulse in rad", impulse.direction)?;
            positive("duration of an impulse in s", impulse.duration)?;
        }
        for mass in &lateral.eccentric_masses {
            known_site("an eccentric mass", mass.site, sites)?;
            not_negative("eccentric mass in kg", mass.mass)?;
            finite("offset of an eccentric mass in m", mass.offset)?;
        }
        Ok(())
    }
}

impl BitTorque {
    fn check(&self) -> Result<(), SceneError> {
        not_negative("static torque of the bit in N m", self.torque_static)?;
        not_negative("dynamic torque of the bit in N m", self.torque_dynamic)?;
        if self.torque_static < self.torque_dynamic {
            return Err(SceneError::Torques {
                torque_static: self.torque_static,
                torque_dynamic: self.torque_dynamic,
            });
        }
        Ok(())
    }
}

impl Wall {
    fn check(&self) -> Result<(), SceneError> {
        positive("clearance of a wall in m", self.clearance)?;
        not_negative("friction of a wall", self.friction)?;
        not_negative("radius of the string at a wall in m", self.radius)?;
        if self.stiffness > 0.0 {
            return Ok(());
        }
        Err(SceneError::OutOfRange {
            quantity: "stiffness of a wall in N/m^1.5",
            value: self.stiffness,
            expected: "positive, or infinite for a rigid wall",
        })
    }
}

fn known_site(what: &'static str, site: usize, sites: usize) -> Result<(), SceneError> {
    if site < sites {
        Ok(())
    } else {
        Err(SceneError::NoSuchSite { what, site, sites })
    }
}

pub(crate) fn finite(quantity: &'static str, value: f64) -> Result<(), SceneError> {
    in_range(quantity, value, f64::MIN..=f64::MAX, FINITE)
}

pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<(), SceneError> {
    in_range(quantity, value, f64::from_bits(1)..=f64::MAX, POSITIVE)
}

pub(crate) fn not_negative(quantity: &'static str, value: f64) -> Result<(), SceneError> {
    in_range(quantity, value, 0.0..=f64::MAX, NOT_NEGATIVE)
}

fn in_range(
    quantity: &'static str,
    value: f64,
    range: std::ops::RangeInclusive<f64>,
    expected: &'static str,
) -> Result<(), SceneError> {
    if range.contains(&value) {
        Ok(())
    } else {
        Err(SceneError::OutOfRange {
            quantity,
            value,
            expected,
        })
    }
}
