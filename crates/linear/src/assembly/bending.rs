//! Pieces of string in bending, joined and reduced to the sites (Eqs. 50–58).

use faer::Mat;
use faer::linalg::solvers::Solve;
use num_complex::Complex64;

use super::beam_stiffness::BeamStiffness;
use super::block::Block;
use super::chain::Stiffness;
use super::matrix::ResponseMatrix;
use super::stiff_beam::StiffBeam;
use crate::drillstring::SurfaceSupport;

/// A piece of beam: seen from its top where it is short, between its ends where its waves
/// hardly get through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Beam {
    /// Its waves turn by no more than [`SHORT`].
    Short(StiffBeam),
    /// Any other.
    Long(BeamStiffness),
}

/// The most by which waves turn along a short piece, rad.
const SHORT: f64 = 2.0;

impl Beam {
    /// A piece of a beam.
    pub fn of(beam: StiffBeam) -> Self {
        if beam.turns <= SHORT {
            Beam::Short(beam)
        } else {
            Beam::Long(beam.between_ends())
        }
    }

    /// Its stiffness between its ends.
    pub fn between_ends(&self) -> BeamStiffness {
        match self {
            Beam::Short(beam) => beam.between_ends(),
            Beam::Long(beam) => *beam,
        }
    }
}

impl Stiffness for Beam {
    fn join(self, lower: Self) -> Self {
        match (self, lower) {
            (Beam::Short(upper), Beam::Short(lower)) => {
                if upper.turns + lower.turns <= SHORT {
                    Beam::Short(upper.join(lower))
                } else if upper.turns > lower.turns {
                    Beam::Long(lower.below(upper.between_ends()))
                } else {
                    Beam::Long(upper.above(lower.between_ends()))
                }
            }
            (Beam::Long(upper), Beam::Short(lower)) => Beam::Long(lower.below(upper)),
            (Beam::Short(upper), Beam::Long(lower)) => Beam::Long(upper.above(lower)),
            (Beam::Long(upper), Beam::Long(lower)) => Beam::Long(upper.join(lower)),
        }
    }
}

/// Displacement at each of so many sites (row) per unit force at each (column), m/N: D⁽ᵇ⁾
/// of Eq. 57. From the surface down, each piece ends at a node, of which the first `sites`
/// are sites; `None` where there is nothing.
pub fn reduce(
    pieces: impl ExactSizeIterator<Item = Option<Beam>>,
    sites: usize,
    support: SurfaceSupport,
) -> ResponseMatrix {
    // Node 0 is the surface; each has a displacement and a slope.
    let held = support.held();
    let size = 2 * (pieces.len() + 1) - held;
    let mut stiffness = Mat::<Complex64>::zeros(size, size);
    for (upper, piece) in pieces.enumerate() {
        if let Some(piece) = piece {
            add_piece(&mut stiffness, upper, held, &piece.between_ends());
        }
    }
    let displacement = |site: usize| 2 * (site + 1) - held;
    let mut forces = Mat::<Complex64>::zeros(size, sites);
    for site in 0..sites {
        forces[(displacement(site), site)] = Complex64::new(1.0, 0.0);
    }
    stiffness.partial_piv_lu().solve_in_place(&mut forces);
    ResponseMatrix(Mat::from_fn(sites, sites, |row, column| {
        forces[(displacement(row), column)]
    }))
}

/// Adds the piece between nodes `upper` and `upper + 1`; the first `held`
/// degrees of freedom are left out.
fn add_piece(stiffness: &mut Mat<Complex64>, upper: usize, held: usize, piece: &BeamStiffness) {
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
