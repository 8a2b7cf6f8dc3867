//! Bending waves in a uniform tube with pre-compression (Eqs. 19–26).
//!
//! The degrees of freedom at a node are the displacement x and the slope x′;
//! with them go the external force and moment, positive in the same
//! directions. A piece so short that waves hardly turn within it has a rapidly
//! converging power series; longer tubes are joined from equal pieces by
//! doubling, so that no exponential occurs and nothing overflows.

use num_complex::Complex64;

use crate::assembly::bending::Beam;
use crate::assembly::block::Block;
use crate::assembly::chain::Stiffness;
use crate::assembly::stiff_beam::{StiffBeam, turns};
use crate::drillstring::{Bending, Drillstring, Tube};

/// The series is used where |k| times the length is below this, and the length
/// halved until it is.
const SHORT: f64 = 1.0;

/// The series has converged to rounding after so many powers of the length.
const POWERS: usize = 26;

/// Dynamic stiffness of one uniform tube at the Laplace variable `s` (rad/s).
pub fn uniform(string: &Drillstring, bending: &Bending, tube: &Tube, s: Complex64) -> Beam {
    let rigidity = bending.youngs_modulus * tube.second_moment();
    let inertia = string.material().density * tube.area();
    // E I x⁗ + C x″ + q x = 0 (Eq. 20).
    let q = s * (bending.damping + s * inertia);
    let mut length = tube.length;
    let mut halvings = 0;
    let mut turns = turns(bending, tube, q);
    while turns > SHORT {
        (turns, length) = (0.5 * turns, 0.5 * length);
        halvings += 1;
    }
    let compression = bending.compression * length * length / rigidity;
    let foundation = q * length.powi(4) / rigidity;
    let short = StiffBeam {
        turns,
        ..scaled(&short_beam(compression, foundation), rigidity, length)
    };
    let mut stiffness = Beam::of(short);
    for _ in 0..halvings {
        stiffness = stiffness.join(stiffness);
    }
    stiffness
}

/// What a solution of x⁗ + p x″ + Q x = 0 on (0, 1) with x^(j)(0)/j! = 1, and the other
/// derivatives up to the third zero at 0, has beside the rigid motion of its start.
struct Bent {
    /// x, x′, x″, x‴ at 1.
    ends: [Complex64; 4],
    /// The integrals of x and of ξ x.
    moments: [Complex64; 2],
}

fn power_series(p: f64, q: Complex64, j: usize) -> Bent {
    let zero = Complex64::new(0.0, 0.0);
    let mut coefficients = [zero; POWERS];
    coefficients[j] = Complex64::new(1.0, 0.0);
    for n in 0..POWERS - 4 {
        let m = n as f64;
        let second = coefficients[n + 2] * p * ((m + 2.0) * (m + 1.0));
        let divisor = (m + 4.0) * (m + 3.0) * (m + 2.0) * (m + 1.0);
        coefficients[n + 4] -= (second + coefficients[n] * q) / divisor;
    }
    let mut bent = Bent {
        ends: [zero; 4],
        moments: [zero; 2],
    };
    // The first two are the rigid motion.
    for (n, &coefficient) in coefficients.iter().enumerate().skip(2).rev() {
        let n = n as f64;
        let falling = [1.0, n, n * (n - 1.0), n * (n - 1.0) * (n - 2.0)];
        for (end, factor) in bent.ends.iter_mut().zip(falling) {
            *end += coefficient * factor;
        }
        bent.moments[0] += coefficient / (n + 1.0);
        bent.moments[1] += coefficient / (n + 2.0);
    }
    bent
}

/// Stiffness of a beam of unit length and rigidity.
fn short_beam(p: f64, q: Complex64) -> StiffBeam {
    let [u0, u1, u2, u3] = [0, 1, 2, 3].map(|j| power_series(p, q, j));
    let constant = |rows: [[f64; 2]; 2]| Block(rows.map(|row| row.map(Complex64::from)));
    // What it bends by: near · (x, x′)(0) + far · (a₂, a₃), with x″ = 2 a₂ and x‴ = 6 a₃.
    let motions = |u: &Bent, v: &Bent| Block([0, 1].map(|row| [u.ends[row], v.ends[row]]));
    let (near, far) = (motions(&u0, &u1), motions(&u2, &u3).inverse());
    // (force, moment) on the bottom: (−x‴ − p x′, x″).
    let force = |u: &Bent| -u.ends[3] - u.ends[1] * p;
    let forces = |u: &Bent, v: &Bent| Block([[force(u), force(v)], [u.ends[2], v.ends[2]]]);
    let elastic = forces(&u2, &u3) * far;
    let by_slope = constant([[0.0, -p], [0.0, 0.0]]);
    // All that acts is Q ∫ x dξ and, about the top, Q ∫ ξ x dξ − p (x(1) − x(0)).
    let integrals = |u: &Bent, v: &Bent| Block([0, 1].map(|row| [u.moments[row], v.moments[row]]));
    let Block([[a, b], [c, d]]) = constant([[1.0, 0.5], [0.5, 1.0 / 3.0]]) + integrals(&u0, &u1)
        - integrals(&u2, &u3) * (far * near);
    StiffBeam {
        length: 1.0,
        turns: 0.0,
        elastic,
        mixed: forces(&u0, &u1) + by_slope - elastic * near,
        rigid: Block([[a * q, b * q], [c * q, d * q - p]]),
    }
}

/// From unit length and rigidity to the real ones.
fn scaled(beam: &StiffBeam, rigidity: f64, length: f64) -> StiffBeam {
    let scale = |Block([[a, b], [c, d]]): Block| {
        let force = rigidity / length.powi(3);
        Block([
            [a * force, b * (force * length)],
            [c * (force * length), d * (force * length * length)],
        ])
    };
    StiffBeam {
        length,
        turns: beam.turns,
        elastic: scale(beam.elastic),
        mixed: scale(beam.mixed),
        rigid: scale(beam.rigid),
    }
}
