//! What is around a string that lies in its hole, and how its ends are held.

use linear::{Mud, SurfaceSupport};

use crate::course::Course;

/// What is around the string.
///
/// ```
/// use statics::{Bit, Conditions, Course, Top};
///
/// let conditions = Conditions {
///     weight_on_bit: 100e3,
///     ..Conditions::new(210e9, Course::Straight { inclination: 1.0 })
/// };
/// assert_eq!((conditions.bit, conditions.top), (Bit::Contact, Top::AboveContacts));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Conditions {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// The course of the hole.
    pub course: Course,
    /// The mud, which buoys the string; the same inside and outside.
    pub mud: Option<Mud>,
    /// Weight on bit W, N; where negative, the bit is pulled.
    pub weight_on_bit: f64,
    /// Torque along the string, N m, for stress alone: its effect on bending is left out.
    pub torque: f64,
    /// What holds the bit sideways.
    pub bit: Bit,
    /// Where the modelled part of the string ends.
    pub top: Top,
    /// What holds the surface, where the string is modelled up to it; a cut at a given distance is held
    /// in the middle of the hole, without a moment.
    pub surface: SurfaceSupport,
    /// The longest element, m; left out, one with which forces are converged to 1e-6 of the largest.
    pub longest_element: Option<f64>,
}

/// What holds the bit sideways; none holds its slope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Bit {
    /// The wall, as at the other contacts: one of them is 0 m from the bit.
    #[default]
    Contact,
    /// What it cuts, in the middle of the hole.
    Pinned,
    /// Nothing.
    Free,
}

/// Where the modelled part of the string ends.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Top {
    /// Beyond the highest contact by half of the greatest of the three distances between the highest four,
    /// as an end close to a contact would lift it off; and there on the wall, as a string does that lies on
    /// its hole above, too.
    #[default]
    AboveContacts,
    /// At a distance from the bit, m; contacts above are left out.
    At(f64),
    /// At a distance from the bit, m, on the wall there; contacts above are left out.
    OnWall(f64),
    /// At the surface.
    Surface,
}

/// Of this number of distances between the highest contacts half of the greatest is left above them: ends
/// of a tool joint are close to each other.
const HIGHEST_GAPS: usize = 3;

impl Top {
    /// The distance from the bit, m, at which a string with fewer than two contacts is cut: no
    /// force of the seven lowest contacts of a field string changes by more than 1e-6 of itself if
    /// it is cut higher up.
    const OF_ONE_CONTACT: f64 = 150.0;

    /// How far from the bit a string of a length is modelled that has contacts at these distances, from
    /// the highest down, m. Where the surface is closer than the next contact would be it ends there.
    pub fn distance(self, contacts: &[f64], length: f64) -> f64 {
        let highest = contacts.first().copied().unwrap_or(0.0);
        let gaps = contacts.windows(2).take(HIGHEST_GAPS);
        let widest = gaps.map(|pair| pair[0] - pair[1]).fold(0.0, f64::max);
        let above = highest + 0.5 * widest;
        let distance = match self {
            Self::Surface => length,
            Self::At(distance) | Self::OnWall(distance) => distance,
            Self::AboveContacts if above + widest > length => length,
            Self::AboveContacts if widest > 0.0 => above,
            Self::AboveContacts => above.max(Self::OF_ONE_CONTACT),
        };
        distance.min(length)
    }
}

impl Conditions {
    /// Those of a string of a Young's modulus (Pa) in a hole, off bottom, without mud or torque, its
    /// bit in contact and its surface pinned.
    pub fn new(youngs_modulus: f64, course: Course) -> Self {
        Self {
            youngs_modulus,
            course,
            mud: None,
            weight_on_bit: 0.0,
            torque: 0.0,
            bit: Bit::Contact,
            top: Top::AboveContacts,
            surface: SurfaceSupport::Pinned,
            longest_element: None,
        }
    }
}
