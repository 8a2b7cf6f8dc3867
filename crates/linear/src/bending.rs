//! What bending needs to know of a string, beyond what torsion does.

use crate::drillstring::positive;
use crate::error::DrillstringError;

/// The constants of a string that bends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bending {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Distributed lateral damping c_b, N s/m per metre of string (Eq. 19).
    pub damping: f64,
    /// Pre-compression C, N; tension where negative.
    pub compression: f64,
}

impl Bending {
    /// With an additional tension (N).
    pub(crate) fn under(self, tension: f64) -> Self {
        Self {
            compression: self.compression - tension,
            ..self
        }
    }

    /// Without any, of its material alone.
    pub(crate) fn straight(self) -> Self {
        Self {
            compression: 0.0,
            ..self
        }
    }

    /// Checks that a string can bend so.
    pub(crate) fn check(&self) -> Result<(), DrillstringError> {
        positive("Young's modulus", self.youngs_modulus)?;
        if !(self.damping.is_finite() && self.damping >= 0.0) {
            return Err(DrillstringError::NegativeLateralDamping {
                value: self.damping,
            });
        }
        if !self.compression.is_finite() {
            return Err(DrillstringError::Compression {
                value: self.compression,
            });
        }
        Ok(())
    }
}

/// How the surface holds the string laterally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SurfaceSupport {
    /// Not at all.
    #[default]
    Free,
    /// No displacement.
    Pinned,
    /// No displacement and no slope.
    Clamped,
}

impl SurfaceSupport {
    /// How many of the surface's two degrees of freedom, displacement and
    /// slope, are held.
    pub(crate) fn held(self) -> usize {
        match self {
            SurfaceSupport::Free => 0,
            SurfaceSupport::Pinned => 1,
            SurfaceSupport::Clamped => 2,
        }
    }
}
