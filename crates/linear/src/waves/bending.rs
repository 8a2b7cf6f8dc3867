//! Bending waves in a uniform tube with pre-compression (Eqs. 19–26).
//!
//! The degrees of freedom at a node are the displacement x and the slope x′;
//! with them go the external force and moment, positive in the same
//! directions. A piece so short that waves hardly turn within it has a rapidly
//! converging power series; longer tubes are joined from equal pieces by
//! doubling, so that no exponential occurs and nothing overflows.

use num_complex::Complex64;

use super::block::Block;
use super::chain::Stiffness;
use crate::drillstring::{Bending, Drillstring, Tube};

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

/// The series is used where |k| times the length is below this, and the length
/// halved until it is.
const SHORT: f64 = 1.0;

/// The series has converged to rounding after so many powers of the length.
const POWERS: usize = 26;

/// Dynamic stiffness of one uniform tube at the Laplace variable `s` (rad/s).
pub fn uniform(
    string: &Drillstring,
    bending: &Bending,
    tube: &Tube,
    s: Complex64,
) -> BeamStiffness {
    let rigidity = bending.youngs_modulus * tube.second_moment();
    let inertia = string.material().density * tube.area();
    // E I x⁗ + C x″ + q x = 0 (Eq. 20).
    let q = s * (bending.damping + s * inertia);
    let mut length = tube.length;
    let mut halvings = 0;
    let turns = |length: f64| {
        let by_inertia = (q.norm() / rigidity).sqrt().sqrt() * length;
        let by_compression = (bending.compression.abs() / rigidity).sqrt() * length;
        by_inertia.max(by_compression)
    };
    while turns(length) > SHORT {
        length *= 0.5;
        halvings += 1;
    }
    let compression = bending.compression * length * length / rigidity;
    let foundation = q * length.powi(4) / rigidity;
    let mut stiffness = short_beam(compression, foundation).scaled(rigidity, length);
    for _ in 0..halvings {
        stiffness = stiffness.join(stiffness);
    }
    stiffness
}

/// End values (x, x′, x″, x‴) at 1 of x⁗ + p x″ + Q x = 0 with x^(j)(0)/j! = 1
/// and the other derivatives up to the third zero at 0.
fn power_series(p: f64, q: Complex64, j: usize) -> [Complex64; 4] {
    let zero = Complex64::new(0.0, 0.0);
    let mut coefficients = [zero; POWERS];
    coefficients[j] = Complex64::new(1.0, 0.0);
    for n in 0..POWERS - 4 {
        let m = n as f64;
        let second = coefficients[n + 2] * p * ((m + 2.0) * (m + 1.0));
        let divisor = (m + 4.0) * (m + 3.0) * (m + 2.0) * (m + 1.0);
        coefficients[n + 4] -= (second + coefficients[n] * q) / divisor;
    }
    let mut ends = [zero; 4];
    for (n, &coefficient) in coefficients.iter().enumerate().rev() {
        let n = n as f64;
        let falling = [1.0, n, n * (n - 1.0), n * (n - 1.0) * (n - 2.0)];
        for (end, factor) in ends.iter_mut().zip(falling) {
            *end += coefficient * factor;
        }
    }
    ends
}

/// Stiffness of a beam of unit length and rigidity.
fn short_beam(p: f64, q: Complex64) -> BeamStiffness {
    let [u0, u1, u2, u3] = [0, 1, 2, 3].map(|j| power_series(p, q, j));
    let (zero, one) = (Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0));
    // (x, x′)(1) = near · (x, x′)(0) + far · (a₂, a₃), solved for (a₂, a₃).
    let near = Block([[u0[0], u1[0]], [u0[1], u1[1]]]);
    let far = Block([[u2[0], u3[0]], [u2[1], u3[1]]]).inverse();
    let from_top = -(far * near);
    // External forces (force, moment): at the top (x‴ + p x′, −x″) with
    // x″ = 2 a₂ and x‴ = 6 a₃, at the bottom (−x‴ − p x′, x″).
    let top_forces = Block([[zero, one * 6.0], [-one * 2.0, zero]]);
    let direct_top = Block([[zero, one * p], [zero, zero]]);
    let force = |u: [Complex64; 4]| -u[3] - u[1] * p;
    let bottom_from_top = Block([[force(u0), force(u1)], [u0[2], u1[2]]]);
    let bottom_from_far = Block([[force(u2), force(u3)], [u2[2], u3[2]]]);
    let top = direct_top + top_forces * from_top;
    let cross = top_forces * far;
    let bottom = bottom_from_far * far;
    debug_assert!({
        let other = bottom_from_top + bottom_from_far * from_top;
        let difference = other - cross.transpose();
        difference.0.iter().flatten().all(|x| x.norm() < 1e-10)
    });
    BeamStiffness { top, cross, bottom }
}

impl BeamStiffness {
    /// From unit length and rigidity to the real ones.
    fn scaled(self, rigidity: f64, length: f64) -> Self {
        let scale = |Block([[a, b], [c, d]]): Block| {
            let force = rigidity / length.powi(3);
            Block([
                [a * force, b * (force * length)],
                [c * (force * length), d * (force * length * length)],
            ])
        };
        Self {
            top: scale(self.top),
            cross: scale(self.cross),
            bottom: scale(self.bottom),
        }
    }
}
