//! Stiffnesses of beams between their ends, joined (Eqs. 50–54).
//!
//! The degrees of freedom at a node are the displacement x and the slope x′; with them go
//! the external force and moment, positive in the same directions.

use super::block::Block;
use super::chain::Stiffness;

/// Dynamic stiffness of a beam between its two ends:
/// `[f_top; f_bottom] = [[top, cross], [crossᵀ, bottom]] [u_top; u_bottom]`
/// with u = (x, x′) and f = (force, moment); N/m, N, N m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeamStiffness {
    /// Driving-point stiffness at the top.
    pub top: Block,
    /// Transfer stiffness from the bottom's displacements to the top's forces;
    /// its transpose is the other direction's (reciprocity).
    pub cross: Block,
    /// Driving-point stiffness at the bottom.
    pub bottom: Block,
}

impl Stiffness for BeamStiffness {
    fn join(self, lower: Self) -> Self {
        let shared = (self.bottom + lower.top).inverse();
        let upward = self.cross * shared;
        Self {
            top: self.top - upward * self.cross.transpose(),
            cross: -(upward * lower.cross),
            bottom: lower.bottom - lower.cross.transpose() * shared * lower.cross,
        }
    }
}
