//! The string reduced to the surface and the sites (Eqs. 41–48): surface
//! rotation speed and external torques in, rotation speeds at the sites out.

use num_complex::Complex64;

use super::torsion::uniform;
use crate::assembly::chain;
use crate::assembly::number::Number;
use crate::assembly::torsion::{Drive, TorsionAdmittance, reduce};
use crate::drillstring::Drillstring;
use crate::error::DrillstringError;
use crate::sites::Sites;
use crate::spans::Span;

/// A string cut at its sites once, to be evaluated at many frequencies.
#[derive(Debug, Clone)]
pub struct TorsionNetwork<'a> {
    string: &'a Drillstring,
    spans: Vec<Span>,
    sites: usize,
}

impl<'a> TorsionNetwork<'a> {
    /// Cuts the string at the sites.
    ///
    /// # Errors
    /// Where these are not places of this string.
    pub fn new(string: &'a Drillstring, sites: &Sites) -> Result<Self, DrillstringError> {
        Ok(Self {
            string,
            spans: string.spans(sites)?,
            sites: sites.len(),
        })
    }

    /// The frequency response at `frequency` (Hz).
    pub fn at_frequency(&self, frequency: f64) -> TorsionAdmittance {
        self.admittance(Complex64::new(0.0, std::f64::consts::TAU * frequency))
    }

    /// The response at the Laplace variable `s` (rad/s, Re s ≥ 0).
    pub fn admittance<T: Number>(&self, s: T) -> TorsionAdmittance<T> {
        let tube = |tube: &_| uniform(self.string, tube, s);
        let pieces = self.spans.iter().map(|span| chain::span(span, tube));
        // Stiffnesses of waves are torques per rotation.
        let drive = self.string.top_drive();
        let drive = drive.map(|drive| Drive::of(&drive, s * s, s, T::real(1.0)));
        reduce(pieces, self.sites, s, drive)
    }
}
