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

/// Dynamic stiffness of a piece of string between its two ends, N m/rad:
/// `T_top = top θ_top + link (θ_top − θ_bottom)`, and at the bottom alike.
///
/// What turns a short piece as a rigid body is far less than what twists it, and lost to
/// rounding where it is the difference of driving-point stiffness and link: the elements of
/// a long string have a millionth of it. So it is kept by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DynamicStiffness {
    /// The torque on the top for each unit by which all of it turns alike.
    pub top: Complex64,
    /// The torque for each unit by which its ends turn differently, the same from either
    /// end (reciprocity).
    pub link: Complex64,
    /// The torque on the bottom for each unit by which all of it turns alike.
    pub bottom: Complex64,
}

impl DynamicStiffness {
    /// Torque on the bottom per rotation there, the top held fast.
    pub fn at_bottom(&self) -> Complex64 {
        self.link + self.bottom
    }

    /// Torque on the top per rotation there, the bottom held fast.
    pub fn at_top(&self) -> Complex64 {
        self.link + self.top
    }
}

impl Stiffness for DynamicStiffness {
    fn join(self, lower: Self) -> Self {
        // What acts on the node they share is taken by their links as these are stiff.
        let node = self.bottom + lower.top;
        let shared = (self.link + lower.link + node).inv();
        let (above, below) = (self.link * shared, lower.link * shared);
        Self {
            top: self.top + above * node,
            link: above * lower.link,
            bottom: lower.bottom + below * node,
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
        let compliance = piece.at_bottom().inv();
        return TorsionAdmittance {
            from_surface: vec![piece.link * compliance],
            from_torque: ResponseMatrix(Mat::from_fn(1, 1, |_, _| rate * compliance)),
        };
    }
    let mut stiffness = Mat::<Complex64>::zeros(nodes, nodes);
    let mut inputs = Mat::<Complex64>::zeros(nodes, sites + 1);
    for (node, piece) in pieces.enumerate() {
        let Some(piece) = piece else {
            continue;
        };
        stiffness[(node, node)] += piece.at_bottom();
        if node == 0 {
            // The surface turns as prescribed: its torque on the first node.
            inputs[(0, 0)] = piece.link;
        } else {
            stiffness[(node - 1, node - 1)] += piece.at_top();
            stiffness[(node - 1, node)] = -piece.link;
            stiffness[(node, node - 1)] = -piece.link;
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
