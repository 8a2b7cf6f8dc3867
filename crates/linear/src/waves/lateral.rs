//! The string in bending reduced to its sites (Eqs. 50–58): forces in,
//! displacements out, no external moments.

use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

use super::bending::{BeamStiffness, uniform};
use super::block::Block;
use super::chain;
use super::matrix::ResponseMatrix;
use crate::drillstring::{Bending, Drillstring, SurfaceSupport};
use crate::error::DrillstringError;
use crate::sites::Sites;
use crate::spans::Span;

/// A string cut at its sites once, to be evaluated at many frequencies.
#[derive(Debug, Clone)]
pub struct BendingNetwork<'a> {
    string: &'a Drillstring,
    bending: Bending,
    support: SurfaceSupport,
    spans: Vec<Span>,
    sites: usize,
}

impl<'a> BendingNetwork<'a> {
    /// Cuts the string at the sites.
    ///
    /// # Errors
    /// Where these are not places of this string, or it cannot bend as `bending`
    /// says.
    pub fn new(
        string: &'a Drillstring,
        bending: Bending,
        support: SurfaceSupport,
        sites: &Sites,
    ) -> Result<Self, DrillstringError> {
        bending.check()?;
        Ok(Self {
            string,
            bending,
            support,
            spans: string.spans(sites)?,
            sites: sites.len(),
        })
    }

    /// The receptance at an angular frequency (rad/s, not zero).
    pub fn at_rate(&self, rate: f64) -> ResponseMatrix {
        self.receptance(Complex64::new(0.0, rate))
    }

    /// Dynamic stiffness at one site, the others free, at an angular frequency (rad/s,
    /// not zero): real and imaginary part of the force per displacement there, N/m.
    pub fn dynamic_stiffness(&self, site: usize, rate: f64) -> [f64; 2] {
        let stiffness = self.at_rate(rate)[(site, site)].inv();
        [stiffness.re, stiffness.im]
    }

    /// Displacement at each site (row) per unit force at each site (column) at
    /// the Laplace variable `s` (rad/s, not zero): D⁽ᵇ⁾ of Eq. 57, m/N.
    pub fn receptance(&self, s: Complex64) -> ResponseMatrix {
        // Node 0 is the surface; each has a displacement and a slope.
        let held = self.support.held();
        let size = 2 * (self.spans.len() + 1) - held;
        let mut stiffness = Mat::<Complex64>::zeros(size, size);
        for (upper, span) in self.spans.iter().enumerate() {
            let tube = |tube: &_| uniform(self.string, &self.bending, tube, s);
            if let Some(piece) = chain::span(span, tube) {
                add_piece(&mut stiffness, upper, held, piece);
            }
        }
        let displacement = |site: usize| 2 * (site + 1) - held;
        let mut forces = Mat::<Complex64>::zeros(size, self.sites);
        for site in 0..self.sites {
            forces[(displacement(site), site)] = Complex64::new(1.0, 0.0);
        }
        stiffness.partial_piv_lu().solve_in_place(&mut forces);
        ResponseMatrix(Mat::from_fn(self.sites, self.sites, |row, column| {
            forces[(displacement(row), column)]
        }))
    }
}

/// Adds the piece between nodes `upper` and `upper + 1`; the first `held`
/// degrees of freedom are left out.
fn add_piece(stiffness: &mut Mat<Complex64>, upper: usize, held: usize, piece: BeamStiffness) {
    let blocks = [
        (0, 0, piece.top),
        (0, 1, piece.cross),
        (1, 0, piece.cross.transpose()),
        (1, 1, piece.bottom),
    ];
    for (row, column, Block(entries)) in blocks {
        for (i, line) in entries.iter().enumerate() {
            for (j, entry) in line.iter().enumerate() {
                let place = (2 * (upper + row) + i, 2 * (upper + column) + j);
                if place.0 >= held && place.1 >= held {
                    stiffness[(place.0 - held, place.1 - held)] += *entry;
                }
            }
        }
    }
}
