//! What can go wrong between a drillstring and its impulse responses.

use thiserror::Error;

/// A drillstring or a set of sites that cannot be.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum DrillstringError {
    /// The string has no section.
    #[error("the string has no section")]
    NoSections,
    /// A section is repeated zero times.
    #[error("section {section} is repeated zero times")]
    NoRepeat {
        /// Which section, from the surface, from 0.
        section: usize,
    },
    /// A section has no tube.
    #[error("section {section} has no part")]
    NoParts {
        /// Which section, from the surface, from 0.
        section: usize,
    },
    /// A tube has no positive length.
    #[error("the length {value} m of part {part} of section {section} is not positive")]
    Length {
        /// Which section, from the surface, from 0.
        section: usize,
        /// Which part of the section's cell, from the top, from 0.
        part: usize,
        /// The length found, m.
        value: f64,
    },
    /// A tube's radii do not make a tube.
    #[error(
        "part {part} of section {section} needs 0 ≤ internal radius < external radius, \
         but has {inner} m and {outer} m"
    )]
    Radii {
        /// Which section, from the surface, from 0.
        section: usize,
        /// Which part of the section's cell, from the top, from 0.
        part: usize,
        /// Internal radius, m.
        inner: f64,
        /// External radius, m.
        outer: f64,
    },
    /// A material constant is not positive.
    #[error("the {quantity} {value} is not positive")]
    NotPositive {
        /// Which constant.
        quantity: &'static str,
        /// The value found, SI.
        value: f64,
    },
    /// Damping below zero would feed energy in.
    #[error("the torsional damping {value} is below zero")]
    NegativeDamping {
        /// The value found, N m s/rad per metre.
        value: f64,
    },
    /// There is no site.
    #[error("there is no site")]
    NoSites,
    /// A site is above the surface, at it, or below the bit.
    #[error("a site {distance} m from the bit is off the string, which is {length} m long")]
    SiteOffString {
        /// Distance from the bit, m.
        distance: f64,
        /// Length of the string, m.
        length: f64,
    },
    /// Two sites are at one place.
    #[error("two sites are {distance} m from the bit")]
    SitesCoincide {
        /// Distance from the bit, m.
        distance: f64,
    },
}

/// Impulse responses that cannot be built.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BuildError {
    /// A method's parameter is out of its range.
    #[error("{name} = {value} is out of range: {expected}")]
    Parameter {
        /// The parameter.
        name: &'static str,
        /// The value found.
        value: f64,
        /// What it may be.
        expected: &'static str,
    },
    /// The responses would need more memory than is reasonable.
    #[error(
        "{taps} taps are more than the {most} that are kept: \
         lower the sampling frequency or the time simulated"
    )]
    TooManyTaps {
        /// Taps needed per response.
        taps: f64,
        /// The most that are kept.
        most: usize,
    },
    /// The real part of a response without damping is zero between its
    /// resonances and infinite at them: it cannot be sampled.
    #[error(
        "{method} needs a string with torsional damping; without it use quadrature or finite-element"
    )]
    NeedsDamping {
        /// Name of the method.
        method: &'static str,
    },
    /// A response is not a number, because the string's constants are extreme.
    #[error("the response by {method} is not finite")]
    NotFinite {
        /// Name of the method.
        method: &'static str,
    },
    /// The effective stiffness of the finite elements could not be factorised.
    #[error("the finite-element matrix could not be factorised: {reason}")]
    Factorisation {
        /// What the solver said.
        reason: String,
    },
}
