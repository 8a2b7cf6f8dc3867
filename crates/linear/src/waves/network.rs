//! The string reduced to the surface and the sites (Eqs. 41–48): surface
//! rotation speed and external torques in, rotation speeds at the sites out.

use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

use super::chain;
use super::matrix::ResponseMatrix;
use super::torsion::{DynamicStiffness, uniform};
use crate::drillstring::Drillstring;
use crate::error::DrillstringError;
use crate::sites::Sites;
use crate::spans::Span;

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
    pub fn admittance(&self, s: Complex64) -> TorsionAdmittance {
        let tube = |tube: &_| uniform(self.string, tube, s);
        let pieces = self.spans.iter().map(|span| chain::span(span, tube));
        reduce(pieces, self.sites, s)
    }
}

/// The response of nodes, from the surface down, of which the first `sites` are sites:
/// each hangs from the one above by a piece, `None` where there is nothing. Stiffnesses
/// are torques per motion, and a speed is `rate` times that motion.
pub(super) fn reduce(
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
