//! The string reduced to the surface and the sites (Eqs. 41–48): surface
//! rotation speed and external torques in, rotation speeds at the sites out.
//!
//! A uniform string that nothing damps answers a torque at the bit with i tan(ωL/c)/Z, with Z its
//! impedance:
//!
//! ```
//! use linear::estimates::{torsional_impedance, torsional_travel_time};
//! use linear::waves::network::TorsionNetwork;
//! use linear::{Complex64, Drillstring, Material, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let frequency = 1.3;
//! let found = TorsionNetwork::new(&string, &Sites::bit())?.at_frequency(frequency);
//! let phase = std::f64::consts::TAU * frequency * torsional_travel_time(&string);
//! let expected = Complex64::new(0.0, phase.tan() / torsional_impedance(&string, &pipe));
//! assert!((found.from_torque[(0, 0)] - expected).norm() < 1e-9 * expected.norm());
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use num_complex::Complex64;

use super::torsion::uniform;
use crate::assembly::chain::{self, Ends};
use crate::assembly::number::Number;
use crate::assembly::torsion::{
    AtSurface, Drive, DynamicStiffness, TorsionAdmittance, at_surface, late, reduce,
    torque_at_surface,
};
use crate::distributed_loss::{Interpolated, LossAlong};
use crate::drillstring::{Drillstring, Tube};
use crate::error::DrillstringError;
use crate::estimates::torsional_resistance;
use crate::sites::Sites;
use crate::spans::SurroundedSpan;
use crate::surroundings::Surroundings;

/// A string cut at its sites once, to be evaluated at many frequencies.
#[derive(Debug, Clone)]
pub struct TorsionNetwork<'a> {
    string: &'a Drillstring,
    spans: Vec<SurroundedSpan>,
    sites: usize,
    loss: LossAlong<Interpolated>,
}

impl<'a> TorsionNetwork<'a> {
    /// Cuts the string at the sites.
    ///
    /// # Errors
    /// Where these are not places of this string.
    pub fn new(string: &'a Drillstring, sites: &Sites) -> Result<Self, DrillstringError> {
        let spans = string.surrounded_spans(string.channel(), sites)?;
        Ok(Self {
            string,
            loss: LossAlong::exact(string, string.channel(), &spans),
            spans,
            sites: sites.len(),
        })
    }

    /// The frequency response at `frequency` (Hz).
    pub fn at_frequency(&self, frequency: f64) -> TorsionAdmittance {
        self.admittance(Complex64::new(0.0, std::f64::consts::TAU * frequency))
    }

    /// The pieces between nodes, torques per rotation.
    pub(crate) fn pieces<T: Number>(
        &self,
        s: T,
    ) -> impl Iterator<Item = Option<DynamicStiffness<T>>> {
        let loss = self.loss.at(|| s);
        let tube = move |around: Surroundings, tube: &Tube| {
            uniform(self.string, (tube, around.hole_radius), s, &loss)
        };
        (self.spans.iter()).map(move |span| chain::surrounded(span, Ends::Both, &tube))
    }

    pub(crate) fn drive<T: Number>(&self, s: T) -> Option<Drive<T>> {
        let drive = self.string.top_drive();
        drive.map(|drive| Drive::of(&drive, [s * s, s, T::real(1.0)], late(&drive, s)))
    }

    /// Torque per speed at the surface where all turns alike for ever.
    fn torque_at_rest(&self) -> f64 {
        let resistance = torsional_resistance(self.string);
        match self.string.top_drive() {
            // It gives way, and nothing brings it back.
            Some(drive) if drive.integral_gain == 0.0 => {
                let gain = drive.proportional_gain;
                gain * resistance / (gain + resistance)
            }
            _ => resistance,
        }
    }
}

impl TorsionNetwork<'_> {
    /// The response at the Laplace variable `s` (rad/s, Re s ≥ 0).
    pub fn admittance<T: Number>(&self, s: T) -> TorsionAdmittance<T> {
        reduce(self.pieces(s), self.sites, s, self.drive(s))
    }

    /// Zero at the free oscillations of the string with a free bit: the torque that the bit opposes
    /// where the surface feels one of 1 (N m), or, with a drive, turns by 1 rad. Unlike the
    /// response of the bit it has no poles, not even near the zeros of modes that the bit hardly
    /// feels.
    pub(crate) fn characteristic(&self, s: Complex64) -> Complex64 {
        let whole = chain::hung(self.pieces(s).flatten());
        let Some(DynamicStiffness { top, cross, bottom }) = whole else {
            return Complex64::ONE;
        };
        match self.drive(s) {
            None => bottom / cross,
            Some(drive) => (top + drive.opposes) * bottom / cross - cross,
        }
    }

    /// How the surface moves below its drive; `None` without one.
    pub(crate) fn at_surface<T: Number>(&self, s: T) -> Option<AtSurface<T>> {
        let drive = self.drive(s)?;
        Some(at_surface(self.pieces(s), self.sites, s, drive))
    }

    /// Torque with which the surface has to be turned per unit of the speed that it is set to,
    /// no torque acting below, N m s/rad.
    pub fn surface_torque<T: Number>(&self, s: T) -> T {
        let torque = torque_at_surface(self.pieces(s), self.drive(s));
        T::of_lanes(|lane| match s.lane(lane) {
            Complex64::ZERO => self.torque_at_rest().into(),
            s => torque.lane(lane) / s,
        })
    }
}
