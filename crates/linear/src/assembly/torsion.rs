//! Pieces of string in torsion, joined and reduced to the surface and the sites
//! (Eqs. 12–13, 41–48).
//!
//! All stiffnesses relate *rotations* to external torques, both positive in the positive
//! direction of rotation. Dividing by s gives the paper's relation between rotation speeds
//! and torques; the rotation form is finite at s = 0, where the static limit lives.

use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

use super::chain::Stiffness;
use super::matrix::ResponseMatrix;

/// Dynamic stiffness of a piece of string between its two ends:
/// `[T_top; T_bottom] = [[top, cross], [cross, bottom]] [θ_top; θ_bottom]`,
/// N m/rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicStiffness {
    /// Driving-point stiffness at the top.
    pub top: Complex64,
    /// Transfer stiffness, the same in both directions (reciprocity).
    pub cross: Complex64,
    /// Driving-point stiffness at the bottom.
    pub bottom: Complex64,
}

impl DynamicStiffness {
    /// So many equal pieces in a row, torques per speed, from the torque on either end of one
    /// where both turn alike, and where they turn against one another: numbers with positive
    /// real parts. With p and m their roots, a row has the characteristic impedance pm, and
    /// a wave that goes down it is multiplied by (m − p)/(m + p) from node to node. What turns
    /// a short piece as a rigid body is so far less than what twists it that joining pieces
    /// one by one would lose it to rounding.
    pub fn row(alike: Complex64, opposite: Complex64, pieces: usize) -> Self {
        let (alike, opposite) = (root(alike), root(opposite));
        let both = opposite + alike;
        let step = (opposite - alike) / both;
        let passed = step.powu(pieces as u32);
        // 1 − passed² = 4pm (1 + step² + … )/(m + p)²: a difference would lose digits.
        let scale = both * both / (4.0 * sum_of_powers(step * step, pieces));
        let driving = scale * (1.0 + passed * passed);
        Self {
            top: driving,
            cross: -scale * passed * 2.0,
            bottom: driving,
        }
    }
}

/// 1 + z + … of so many terms, by doubling.
fn sum_of_powers(z: Complex64, terms: usize) -> Complex64 {
    let (mut sum, mut power) = (Complex64::new(0.0, 0.0), Complex64::new(1.0, 0.0));
    for bit in (0..usize::BITS - terms.leading_zeros()).rev() {
        sum *= 1.0 + power;
        power *= power;
        if terms >> bit & 1 == 1 {
            sum += power;
            power *= z;
        }
    }
    sum
}

/// The square root of a number with a positive real part, without its angle.
fn root(z: Complex64) -> Complex64 {
    let real = (0.5 * (z.norm_sqr().sqrt() + z.re)).sqrt();
    Complex64::new(real, 0.5 * z.im / real)
}

impl Stiffness for DynamicStiffness {
    fn join(self, lower: Self) -> Self {
        let shared = (self.bottom + lower.top).inv();
        Self {
            top: self.top - self.cross * self.cross * shared,
            cross: -self.cross * lower.cross * shared,
            bottom: lower.bottom - lower.cross * lower.cross * shared,
        }
    }
}

/// The frequency response D of Eq. 48 between surface and sites, without its
/// top row (the torque at the surface).
#[derive(Debug, Clone)]
pub struct TorsionAdmittance {
    /// Speed at each site per unit surface speed (dimensionless).
    pub from_surface: Vec<Complex64>,
    /// Speed at each site (row) per unit external torque at each site
    /// (column), rad/s per N m.
    pub from_torque: ResponseMatrix,
}

/// The response of nodes, from the surface down, of which the first `sites` are sites:
/// each hangs from the one above by a piece, `None` where there is nothing. Stiffnesses
/// are torques per motion, and a speed is `rate` times that motion.
pub fn reduce(
    pieces: impl ExactSizeIterator<Item = Option<DynamicStiffness>>,
    sites: usize,
    rate: Complex64,
) -> TorsionAdmittance {
    let nodes = pieces.len();
    let mut pieces = pieces.peekable();
    if nodes == 1
        && let Some(piece) = pieces.next_if(Option::is_some).flatten()
    {
        // The bit alone, by far the most frequent case, needs no matrices.
        let compliance = piece.bottom.inv();
        return TorsionAdmittance {
            from_surface: vec![-piece.cross * compliance],
            from_torque: ResponseMatrix(Mat::from_fn(1, 1, |_, _| rate * compliance)),
        };
    }
    let mut stiffness = Mat::<Complex64>::zeros(nodes, nodes);
    let mut inputs = Mat::<Complex64>::zeros(nodes, sites + 1);
    for (node, piece) in pieces.enumerate() {
        let Some(piece) = piece else {
            continue;
        };
        stiffness[(node, node)] += piece.bottom;
        if node == 0 {
            // The surface turns as prescribed: its torque on the first node.
            inputs[(0, 0)] = -piece.cross;
        } else {
            stiffness[(node - 1, node - 1)] += piece.top;
            stiffness[(node - 1, node)] = piece.cross;
            stiffness[(node, node - 1)] = piece.cross;
        }
    }
    for site in 0..sites {
        inputs[(site, site + 1)] = rate;
    }
    stiffness.partial_piv_lu().solve_in_place(&mut inputs);
    let response = inputs;
    TorsionAdmittance {
        from_surface: (0..sites).map(|site| response[(site, 0)]).collect(),
        from_torque: ResponseMatrix(response.submatrix(0, 1, sites, sites).to_owned()),
    }
}
