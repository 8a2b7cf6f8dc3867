//! What can go wrong between a drillstring and its impulse responses.

use numerics::NumericsError;
use thiserror::Error;

use crate::budget::OutOfBudget;
use crate::channel::Channel;

/// Why a drillstring or a set of sites is refused.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
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
    /// A tube is as wide as the hole, or wider.
    #[error(
        "part {part} of section {section} has an external radius of {outer} m, \
         and the hole only {hole} m"
    )]
    WiderThanHole {
        /// Which section, from the surface, from 0.
        section: usize,
        /// Which part of the section's cell, from the top, from 0.
        part: usize,
        /// External radius, m.
        outer: f64,
        /// Radius of the hole, m.
        hole: f64,
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
    #[error("the torsional damping {value} is not zero or a positive number")]
    NegativeDamping {
        /// The value found, N m s/rad per metre.
        value: f64,
    },
    /// Viscosity below zero would feed energy in.
    #[error("the viscosity {value} Pa s of the mud is not zero or a positive number")]
    Viscosity {
        /// The value found, Pa s.
        value: f64,
    },
    /// A loss factor that no material has.
    #[error("the loss factor {value} is not at least 0 and less than 1")]
    LossFactor {
        /// The value found.
        value: f64,
    },
    /// Lateral damping below zero would feed energy in.
    #[error("the lateral damping {value} is not zero or a positive number")]
    NegativeLateralDamping {
        /// The value found, N s/m per metre.
        value: f64,
    },
    /// Axial damping below zero would feed energy in.
    #[error("the axial damping {value} is not zero or a positive number")]
    NegativeAxialDamping {
        /// The value found, N s/m per metre.
        value: f64,
    },
    /// A number of a hoist is below zero, which would feed energy in.
    #[error("the {quantity} {value} of the hoist is not zero or a positive number")]
    Hoist {
        /// Which number.
        quantity: &'static str,
        /// The value found, SI.
        value: f64,
    },
    /// A hoist that neither a damper nor a spring holds.
    #[error("the hoist has neither a damping nor a stiffness")]
    NothingHolds,
    /// The hole does not reach the end of the string.
    #[error("the hole ends at {depth} m, and the string at {length} m")]
    HoleTooShort {
        /// Length of the string, m.
        length: f64,
        /// Depth of the hole, m.
        depth: f64,
    },
    /// The axial force is not a force.
    #[error("the tension {value} N is not a finite number")]
    Tension {
        /// As given, N.
        value: f64,
    },
    /// The axial force is not that of a string of this length.
    #[error("an axial force along {under} m does not fit a string of {length} m")]
    AxialForceOfAnother {
        /// Length of the string, m.
        length: f64,
        /// Length along which the force is given, m.
        under: f64,
    },
    /// The pre-compression is not a force.
    #[error("the compression {value} N is not a finite number")]
    Compression {
        /// The value found, N.
        value: f64,
    },
    /// A number of a top drive is below zero, which would feed energy in, or none.
    #[error("the {quantity} {value} of the top drive is not zero or a positive number")]
    TopDrive {
        /// Which number.
        quantity: &'static str,
        /// The value found, SI.
        value: f64,
    },
    /// A top drive that nothing holds at its speed.
    #[error("the top drive has neither a proportional nor an integral gain")]
    NoControl,
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
    /// A string is to be held where it is not.
    #[error("a string {length} m long is not held {distance} m from its bit")]
    HeldOffString {
        /// Distance from the bit, m.
        distance: f64,
        /// Length of the string, m.
        length: f64,
    },
    /// A site is where the string is held sideways.
    #[error(
        "a site {distance} m from the bit is not below {bends} m, where the string is held sideways"
    )]
    SiteHeld {
        /// Distance from the bit, m.
        distance: f64,
        /// Length of what bends, m.
        bends: f64,
    },
    /// Springs are not those of the sites.
    #[error("there are {found} springs, but {sites} sites")]
    NotASpringForEachSite {
        /// How many there are.
        found: usize,
        /// How many sites there are.
        sites: usize,
    },
    /// A spring is no spring.
    #[error("the stiffness of a spring is {value} N/m, but must be zero or a positive number")]
    Spring {
        /// N/m.
        value: f64,
    },
    /// Masses are not those of the sites.
    #[error("there are {found} masses, but {sites} sites")]
    NotAMassForEachSite {
        /// How many there are.
        found: usize,
        /// How many sites there are.
        sites: usize,
    },
    /// A mass is no mass.
    #[error("a mass at a site is {value} kg, but must be zero or a positive number")]
    Mass {
        /// kg.
        value: f64,
    },
    /// Two sites are at one place.
    #[error("two sites are {distance} m from the bit")]
    SitesCoincide {
        /// Distance from the bit, m.
        distance: f64,
    },
}

/// Why impulse responses are refused: put together by hand or cut up, they are not what
/// a string gives.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum ResponseError {
    /// There is no such sampling frequency.
    #[error("the responses are sampled at {value} Hz, which is not a positive frequency")]
    SamplingFrequency {
        /// The value found, Hz.
        value: f64,
    },
    /// Some response is missing, without taps, or shorter than the others.
    #[error("the responses do not have one length from every input to every site")]
    Shape,
    /// They are of another string than the one they are held against.
    #[error("the responses are those of another string")]
    OtherString,
    /// They are of other sites, or in other steps, than what they are held against.
    #[error("the responses are those of other sites, or in other steps")]
    OtherSites,
    /// There are none of the channel that is asked of.
    #[error("there are no responses in {channel}")]
    NoChannel {
        /// The channel.
        channel: Channel,
    },
    /// The taps end before the time that they are said to last for.
    #[error("responses of {taps} steps end before the {longest_time} s that they are for")]
    TooShort {
        /// Number of taps.
        taps: usize,
        /// The time, s.
        longest_time: f64,
    },
    /// A load acts at a site that does not exist.
    #[error("the responses name site {site}, but the {sites} sites are counted from 0")]
    NoSuchSite {
        /// The site named, from 0.
        site: usize,
        /// How many sites there are.
        sites: usize,
    },
    /// A tap is not a number.
    #[error("a value of the responses is not finite")]
    NotFinite,
    /// A site does not give way to its own load: no contact law has an answer.
    #[error("site {site} answers its own load by {value} within the step, which is not positive")]
    Instant {
        /// The site, from the surface, from 0.
        site: usize,
        /// A(0) of its driving point.
        value: f64,
    },
}

/// Why impulse responses are not built.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum BuildError {
    /// The sites are not places of this string.
    #[error(transparent)]
    Sites(#[from] DrillstringError),
    /// A torque is to act at a site that does not exist.
    #[error("a torque is to act at site {site}, but the {sites} sites are counted from 0")]
    NoSuchSite {
        /// The site named, from 0.
        site: usize,
        /// How many sites there are.
        sites: usize,
    },
    /// A channel is asked for twice.
    #[error("{channel} is asked for twice")]
    ChannelTwice {
        /// The channel.
        channel: Channel,
    },
    /// Moments are asked for without bending.
    #[error("bending moments need a request of bending")]
    NoBending,
    /// The rod of axial motion is not that of the string.
    #[error("the rod of axial motion is not that of the string")]
    RodOfAnother,
    /// The responses given are not what a string gives.
    #[error(transparent)]
    Responses(#[from] ResponseError),
    /// Recorded forces do not fit the sites.
    #[error("the forces are not equally many steps at every site, along x and along y")]
    Forces,
    /// The string would have more elements than is reasonable.
    #[error(
        "{elements:.0} elements are more than the {most} that are made: \
         take fewer in a cell, or a shorter string"
    )]
    TooManyElements {
        /// Elements needed.
        elements: f64,
        /// The most that are made.
        most: usize,
    },
    /// The string would have more elements than those whose poles are found.
    #[error(
        "{elements:.0} elements are more than the {most} whose poles are found: take `held`, or a \
         shorter string"
    )]
    TooLongForPoles {
        /// Elements needed.
        elements: f64,
        /// The most whose poles are found.
        most: usize,
    },
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
        "responses of {taps} steps are longer than the {most} that are kept: \
         lower the sampling frequency or the time simulated"
    )]
    TooManyTaps {
        /// Taps needed per response.
        taps: f64,
        /// The most that are kept.
        most: usize,
    },
    /// The waves of a string take more steps of its lattice than are kept.
    #[error(
        "waves take {impulses:.1e} steps of the lattice of this string in the time simulated, and \
         {most} are kept: give a shorter `time_s`, or another method, as \
         `methods = [\"quadrature\"]`"
    )]
    TooManyImpulses {
        /// Steps needed.
        impulses: f64,
        /// The most that are kept.
        most: usize,
    },
    /// A loss that depends on frequency is no part of [`crate::elements::reduction`].
    #[error(
        "condensed elements take no viscosity of the mud and no loss factor: step them as they \
         are, or take responses"
    )]
    LossNotStepped,
    /// They would need more memory than is left.
    #[error(transparent)]
    OutOfBudget(#[from] OutOfBudget),
    /// The real part of a response without damping is zero between its
    /// resonances and infinite at them: no samples describe it.
    #[error(
        "{method} needs damping in {channel}; without it use held, quadrature or finite-element"
    )]
    NeedsDamping {
        /// Name of the method.
        method: &'static str,
        /// Where there is none.
        channel: Channel,
    },
    /// A drive answers late, and elements that are stepped keep no past of it.
    #[error(
        "elements that are stepped have no drive with a delay: fewer sites, or another method than \
         finite-element"
    )]
    LateDrive,
    /// There is no drive whose torque could be limited, or it answers late.
    #[error("a torque at the surface needs a string below a top drive that answers without delay")]
    NoPromptDrive,
    /// A method that makes its taps from frequencies does not say how a drive integrates.
    #[error("{method} has no drive of limited torque: take held, quadrature or finite-element")]
    NotStepByStep {
        /// Name of the method.
        method: &'static str,
    },
    /// What a piece does between two nodes does not lead to what the string does.
    #[error("{method} cannot step a string in pieces: take quadrature or finite-element")]
    NotInPieces {
        /// Name of the method.
        method: &'static str,
    },
    /// Poles would give back more than forces put in.
    #[error("the poles of this string are not passive ({margin:.1e} of its response): take held")]
    PolesNotPassive {
        /// The least part of the response.
        margin: f64,
    },
    /// A string buckles without what holds its sites: its poles would grow.
    #[error(
        "poles are those of a string that does not buckle by itself: take finite-element, or hold its sites"
    )]
    Buckles,
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

impl From<NumericsError> for BuildError {
    fn from(error: NumericsError) -> Self {
        Self::Factorisation {
            reason: error.to_string(),
        }
    }
}
