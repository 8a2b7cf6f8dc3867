//! Bending by plain products of transfer matrices, kept to show that it fails.
//!
//! A transfer matrix carries displacement and slope, force and moment from the
//! top of a tube to its bottom, and that of a chain is the product. In bending
//! one wave grows along the tube by e^(βL) and another decays as much. Soon the
//! products hold nothing but the growing wave, and the difference that would be
//! the answer is rounding; in the end they overflow. The stiffnesses of
//! `assembly/chain.rs` give the same response and do neither.
//!
//! A short string has the same receptance either way, a long one is lost in rounding:
//!
//! ```
//! use linear::waves::lateral::BendingNetwork;
//! use linear::waves::transfer::tip_receptance;
//! use linear::{Bending, Drillstring, Material, Section, Sites, SurfaceSupport, Tube};
//!
//! let bending = Bending { youngs_modulus: 210e9, damping: 100.0, compression: 0.0 };
//! let off_by = |cells: usize| -> Result<f64, linear::DrillstringError> {
//!     let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//!     let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//!     let section = Section { repeat: cells, parts: vec![pipe] };
//!     let string = Drillstring::new(steel, vec![section], 0.0)?;
//!     let network = BendingNetwork::new(&string, bending, SurfaceSupport::Free, &Sites::bit())?;
//!     let exact = network.at_rate(60.0)[(0, 0)];
//!     Ok((tip_receptance(&string, &bending, 60.0) / exact - 1.0).norm())
//! };
//! assert!(off_by(2)? < 1e-6);
//! assert!(!(off_by(100)? < 0.1));
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use std::ops::Mul;

use num_complex::Complex64;

use super::bending::{Resistance, uniform};
use crate::assembly::beam_stiffness::BeamStiffness;
use crate::assembly::bending::Beam;
use crate::assembly::block::Block;
use crate::assembly::nodes::Relation;
use crate::bending::Bending;
use crate::drillstring::Drillstring;

/// From (x, x′) and (force, moment) on the top of a piece to those on the top of
/// the next: `[u; f] ← [[a, b], [c, d]] [u; f]`.
#[derive(Debug, Clone, Copy)]
struct Transfer {
    a: Block,
    b: Block,
    c: Block,
    d: Block,
}

impl Transfer {
    fn of(piece: &Beam) -> Self {
        let BeamStiffness { top, cross, bottom } = piece.between_ends();
        let b = cross.inverse();
        let a = -(b * top);
        Self {
            a,
            b,
            c: -(cross.transpose() + bottom * a),
            d: -(bottom * b),
        }
    }
}

/// First the right one, then the left one.
impl Mul for Transfer {
    type Output = Self;
    fn mul(self, upper: Self) -> Self {
        Self {
            a: self.a * upper.a + self.b * upper.c,
            b: self.a * upper.b + self.b * upper.d,
            c: self.c * upper.a + self.d * upper.c,
            d: self.c * upper.b + self.d * upper.d,
        }
    }
}

/// Displacement at the bit per unit force there, m/N, of a string that nothing
/// holds at the surface, at an angular frequency (rad/s, not zero). Not a number, or
/// infinite, where the products overflow.
pub fn tip_receptance(string: &Drillstring, bending: &Bending, rate: f64) -> Complex64 {
    let s = Complex64::new(0.0, rate);
    let mut chain: Option<Transfer> = None;
    for section in string.sections() {
        for part in (0..section.repeat).flat_map(|_| &section.parts) {
            let mass = string.mass_sideways(part, None);
            let part = uniform(bending, part, Resistance::constant(bending, mass, s));
            let part = Transfer::of(&part);
            chain = Some(chain.map_or(part, |upper| part * upper));
        }
    }
    chain.map_or(Complex64::new(f64::NAN, f64::NAN), |chain| {
        // Nothing acts on the top; what acts on the bottom is carried on, negated.
        let Block([[receptance, _], _]) = -(chain.a * chain.c.inverse());
        receptance
    })
}
