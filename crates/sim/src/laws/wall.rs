//! Contact with the borehole wall (Section 4.1, Eqs. 33–38 and 70–71): Hertzian
//! or rigid, with Coulomb friction that slides or rolls.
//!
//! With p_h the displacement a site would have without contact, and h₀ = A(0),
//! the position r e_r satisfies p_h = (r + h₀F_N) e_r − h₀αF_N e_θ, where αF_N is
//! the friction on the string along e_θ. For given α that is one equation for
//! the depth of penetration; α itself is ±μ in sliding, or the root of the
//! sliding speed in rolling.

use thiserror::Error;

use super::bit::{BitMotion, BitTorque};
use super::press::Press;

/// A place on the wall and what the string does there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wall {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ.
    pub friction: f64,
    /// Radius R₀ of the string, which friction turns, m.
    pub radius: f64,
}

/// What one step brings to a site, before contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Approach {
    /// Displacement p_h without contact, m.
    pub free_position: [f64; 2],
    /// Position in the step before, m.
    pub previous_position: [f64; 2],
    /// Rotation speed without contact, rad/s.
    pub free_speed: f64,
    /// h₀: displacement per force within the step, m/N.
    pub compliance: f64,
    /// g₀: rotation speed per torque within the step, rad/s per N m.
    pub torsional_compliance: f64,
    /// Torque law and last motion of the bit, where the site is the bit and
    /// cuts: both laws then hold in one step (Eq. 36).
    pub bit: Option<(BitTorque, BitMotion)>,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
}

/// How the surfaces meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// Not at all.
    Free,
    /// Sliding.
    Sliding,
    /// Rolling without sliding.
    Rolling,
}

/// The answer of the wall in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// How the surfaces meet.
    pub touch: Touch,
    /// Position of the string's centre, m.
    pub position: [f64; 2],
    /// Force of the wall on the string, N.
    pub force: [f64; 2],
    /// Normal force F_N ≥ 0, N.
    pub normal_force: f64,
    /// Friction over normal force, α, positive along e_θ.
    pub friction_ratio: f64,
    /// Torque of friction on the string, N m.
    pub torque: f64,
    /// Whether other friction ratios would have solved the step too.
    pub ambiguous: bool,
}

impl Contact {
    /// At rest in the middle.
    pub const NONE: Contact = Contact {
        touch: Touch::Free,
        position: [0.0; 2],
        force: [0.0; 2],
        normal_force: 0.0,
        friction_ratio: 0.0,
        torque: 0.0,
        ambiguous: false,
    };
}

/// A step in contact without an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum ContactError {
    /// Where the string would be, or how fast it would turn, is no number, or one
    /// whose square is none.
    #[error("the motion is not finite")]
    NotFinite,
    /// What was found does not obey the laws of contact to rounding: the wall or
    /// the responses are not what those of a string can be.
    #[error("no force of the wall solves the step")]
    Unsolved,
}

/// A step that carries the free position further than this many clearances may
/// turn the centre so far that several friction ratios solve it.
const FAR: f64 = 1.1;

impl Wall {
    /// Solves one step at one site, whatever its numbers are: position, load line
    /// and law of the wall then agree to 1e-9 of the distance |p_h|, and what
    /// rolls slides by no more than 1e-9 of the speeds that meet there, or of what
    /// the bit's speed jumps by where its torque falls from T_s to T_d. Lengths
    /// below 1e-150 m count as none.
    ///
    /// # Errors
    /// Where there is no such answer in finite numbers.
    pub fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.free_position;
        let distance = (x * x + y * y).sqrt();
        if distance <= self.clearance {
            return free(approach.free_position, distance);
        }
        let press = Press {
            wall: self,
            approach,
            distance,
        };
        if distance > FAR * self.clearance {
            press.search()
        } else {
            press.solve()
        }
    }
}

/// A site that does not reach the wall, however far that is.
fn free(position: [f64; 2], distance: f64) -> Result<Contact, ContactError> {
    if distance == f64::INFINITY {
        return Err(ContactError::NotFinite);
    }
    Ok(Contact {
        position,
        ..Contact::NONE
    })
}
