//! The ways in which a string moves, and where.

use std::fmt;

/// A way in which the string moves. The channels do not feel one another but at
/// contacts: the matrix of Eqs. 59–60 has a block for each, and zeros between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Channel {
    /// From torques (N m) and the surface's speed to rotation speeds (rad/s).
    Torsion,
    /// From lateral forces (N) to displacements (m) in their plane, alike in both.
    Bending,
    /// From forces along the string (N) and the surface's speed to speeds along it (m/s).
    Axial,
}

/// A site, by number, in a channel: where a load acts or a motion is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Port {
    /// The site, counted from the surface down, from 0.
    pub site: usize,
    /// The channel.
    pub channel: Channel,
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Channel::Torsion => "torsion",
            Channel::Bending => "bending",
            Channel::Axial => "axial motion",
        })
    }
}
