//! What numbers a scene may have.

use thiserror::Error;

/// Why a scene is refused.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
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
    /// The motion at the start is that of other sites.
    #[error("the motion at the start is that of {found} sites, but there are {sites}")]
    StartOfOtherSites {
        /// How many it has.
        found: usize,
        /// How many there are.
        sites: usize,
    },
    /// The string at rest is that of other walls.
    #[error("the string at rest has {found} places, but there are {walls} walls")]
    LyingAtOtherWalls {
        /// How many it has.
        found: usize,
        /// How many there are.
        walls: usize,
    },
    /// A string that begins at rest is held back by friction.
    #[error("a string that begins at rest slides on no wall: its torques there must be zero")]
    SlidesAtRest,
    /// A law gives the torque on a bit that cuts.
    #[error("a bit that cuts has no other law of its torque")]
    TwoLawsOfTheBit,
    /// A bit without blades cuts nothing.
    #[error("the bit has no blades")]
    NoBlades,
    /// The angles between blades are not those of a whole turn, or there are too many.
    #[error("the angles from blade to blade must be positive, 20 at most, and 360° together")]
    BladeAngles,
    /// Something acts at a site that does not exist.
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
const PART: &str = "a number between 0 and 1";

pub(crate) fn known_site(what: &'static str, site: usize, sites: usize) -> Result<(), SceneError> {
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

/// Numbers each of which is larger than the one before.
pub(crate) fn in_order(
    quantity: &'static str,
    values: impl Iterator<Item = f64>,
) -> Result<(), SceneError> {
    let mut before = f64::NEG_INFINITY;
    for value in values {
        if !(value > before && value.is_finite()) {
            return Err(SceneError::OutOfRange {
                quantity,
                value,
                expected: "finite and larger than the one before",
            });
        }
        before = value;
    }
    Ok(())
}

pub(crate) fn part(quantity: &'static str, value: f64) -> Result<(), SceneError> {
    in_range(quantity, value, 0.0..=1.0, PART)
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
