//! Pieces of string in bending, joined and reduced to the sites (Eqs. 50–58).

use num_complex::Complex64;

use super::beam_stiffness::BeamStiffness;
use super::block::Block;
use super::chain::Stiffness;
use super::matrix::ResponseMatrix;
use super::nodes::{Nodes, Relation, StiffnessBetween};
use super::number::Number;
use super::stiff_beam::StiffBeam;
use crate::bending::SurfaceSupport;
use crate::sites::{AtSite, SitesAndPlaces};

/// A piece of beam: seen from its top where it is short, between its ends where its waves
/// hardly get through.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Beam<T = Complex64> {
    /// Its waves turn by no more than [`SHORT`].
    Short(StiffBeam<T>),
    /// Any other.
    Long(BeamStiffness<T>),
}

/// The most by which waves turn along a short piece, rad.
const SHORT: f64 = 2.0;

impl<T: Number> Beam<T> {
    /// A piece of a beam.
    pub fn of(beam: StiffBeam<T>) -> Self {
        if beam.turns <= SHORT {
            Beam::Short(beam)
        } else {
            Beam::Long(beam.between_ends())
        }
    }

    /// Its stiffness between its ends.
    pub fn between_ends(&self) -> BeamStiffness<T> {
        match self {
            Beam::Short(beam) => beam.between_ends(),
            Beam::Long(beam) => *beam,
        }
    }
}

impl<T: Number> Stiffness for Beam<T> {
    fn is_endless(&self) -> bool {
        match self {
            Beam::Short(_) => false,
            Beam::Long(beam) => beam.is_endless(),
        }
    }

    fn join(&self, lower: &Self) -> Self {
        match (self, lower) {
            (Beam::Short(upper), Beam::Short(lower)) => {
                if upper.turns + lower.turns <= SHORT {
                    Beam::Short(upper.join(lower))
                } else if upper.turns > lower.turns {
                    Beam::Long(lower.below(&upper.between_ends()))
                } else {
                    Beam::Long(upper.above(&lower.between_ends()))
                }
            }
            (Beam::Long(upper), Beam::Short(lower)) => Beam::Long(lower.below(upper)),
            (Beam::Short(upper), Beam::Long(lower)) => Beam::Long(upper.above(lower)),
            (Beam::Long(upper), Beam::Long(lower)) => Beam::Long(upper.join(lower)),
        }
    }
}

impl<T: Number> StiffnessBetween<Block<T>> for Beam<T> {
    fn below(&self, above: Block<T>) -> Block<T> {
        match self {
            Beam::Short(beam) => beam.below(&alone(above)).bottom,
            Beam::Long(beam) => beam.below(above),
        }
    }

    fn above(&self, below: Block<T>) -> Block<T> {
        match self {
            Beam::Short(beam) => beam.above(&alone(below)).top,
            Beam::Long(beam) => beam.above(below),
        }
    }

    fn carried(&self, below: Block<T>) -> Block<T> {
        match self {
            Beam::Short(beam) => beam.carried(below),
            Beam::Long(beam) => beam.carried(below),
        }
    }
}

/// What has this stiffness at either end, without the other.
fn alone<T: Number>(stiffness: Block<T>) -> BeamStiffness<T> {
    BeamStiffness {
        top: stiffness,
        cross: Block::zero(),
        bottom: stiffness,
    }
}

/// Stiffness (N/m) of what is at each site besides the string, where this is the acceleration per
/// displacement, 1/s².
pub fn at_sites<T: Number>(loads: &[AtSite], acceleration: T) -> Vec<T> {
    let stiffness = |load: &AtSite| acceleration * load.mass + load.spring;
    loads.iter().map(stiffness).collect()
}

/// Displacement at each of a number of sites (row) per unit force at each (column), m/N: D⁽ᵇ⁾
/// of Eq. 57. From the surface down, each piece ends at a node, of which the first are the
/// sites, each with the stiffness (N/m) of what is there besides the string; `None` where there is
/// no piece.
pub fn reduce<T: Number>(
    pieces: impl Iterator<Item = Option<Beam<T>>>,
    at_sites: &[T],
    support: SurfaceSupport,
) -> ResponseMatrix<T> {
    let nodes = nodes(pieces, at_sites, support);
    ResponseMatrix::reciprocal(at_sites.len(), |site| {
        nodes
            .moved_by_load(site)
            .map(|Block([[displacement, _], _])| displacement)
    })
}

/// The nodes between pieces, the first of them with a stiffness besides that of the pieces.
fn nodes<T: Number>(
    mut pieces: impl Iterator<Item = Option<Beam<T>>>,
    at_nodes: &[T],
    support: SurfaceSupport,
) -> Nodes<Block<T>> {
    let uppermost = pieces.next().flatten();
    let above = uppermost.map_or(Block::zero(), |piece| {
        hanging_from(support, &piece.between_ends())
    });
    let pieces: Vec<_> = pieces.collect();
    let zero = T::zero();
    Nodes::held(above, &pieces, |node| {
        let own = at_nodes.get(node).copied().unwrap_or(zero);
        Block([[own, zero], [zero, zero]])
    })
}

/// Bending moment at each of some places (row) per unit force at each site (column), N m/N; of pieces as
/// in [`reduce`] between the nodes of both, each with a stiffness besides that of the pieces (N/m).
/// It is M = EI x″: with what the piece above opposes to the motion of its lower end, or that below,
/// the other way round, to the motion of its upper end.
pub fn moments<T: Number>(
    pieces: impl Iterator<Item = Option<Beam<T>>>,
    at_nodes: &[T],
    support: SurfaceSupport,
    SitesAndPlaces { places, sites, .. }: &SitesAndPlaces,
) -> Vec<T> {
    let nodes = nodes(pieces, at_nodes, support);
    let loads = sites;
    let mut moments = vec![T::zero(); places.len() * loads.len()];
    // Forces at a place or above it.
    for (column, &load) in loads.iter().enumerate() {
        let Block([[shift, _], [slope, _]]) = nodes.own(load);
        let (mut moved, mut reached) = ([shift, slope], load);
        let not_above = places.partition_point(|place| *place < load);
        for (row, &place) in places.iter().enumerate().skip(not_above) {
            while reached < place {
                reached += 1;
                moved = times(nodes.carried(reached), moved);
            }
            let Block([_, [by_shift, by_slope]]) = nodes.below(place);
            moments[row * loads.len() + column] = -(by_shift * moved[0] + by_slope * moved[1]);
        }
    }
    // Forces below it: what they move there, loads there would move here (reciprocity).
    for (row, &place) in places.iter().enumerate() {
        let Block([_, opposed]) = nodes.above(place);
        let (mut moved, mut reached) = (times(nodes.own(place), opposed), place);
        let not_below = loads.partition_point(|load| *load <= place);
        for (column, &load) in loads.iter().enumerate().skip(not_below) {
            while reached < load {
                reached += 1;
                moved = times(nodes.carried(reached), moved);
            }
            moments[row * loads.len() + column] = moved[0];
        }
    }
    moments
}

fn times<T: Number>(Block([[a, b], [c, d]]): Block<T>, [x, y]: [T; 2]) -> [T; 2] {
    [a * x + b * y, c * x + d * y]
}

/// The stiffness at the bottom of a piece whose top the surface holds.
fn hanging_from<T: Number>(support: SurfaceSupport, piece: &BeamStiffness<T>) -> Block<T> {
    let zero = T::zero();
    let Block([[_, _], [_, turning]]) = piece.top;
    // Motions of the top by loads on it.
    let yielding = match support {
        SurfaceSupport::Free => piece.top.inverse(),
        SurfaceSupport::Pinned => Block([[zero, zero], [zero, turning.inverse()]]),
        SurfaceSupport::Clamped => return piece.bottom,
    };
    piece.bottom - piece.cross.transpose() * (yielding * piece.cross)
}

#[cfg(test)]
mod tests {
    use numerics::{Mat, equations};

    use super::*;
    use crate::bending::Bending;
    use crate::drillstring::{Drillstring, Material, Section, Tube};
    use crate::waves::bending::{Resistance, uniform};

    fn string() -> Drillstring {
        let material = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let parts = vec![Tube {
            length: 9.5,
            inner_radius: 0.05,
            outer_radius: 0.07,
        }];
        let section = Section { repeat: 1, parts };
        Drillstring::new(material, vec![section], 1.0).unwrap()
    }

    const BENDING: Bending = Bending {
        youngs_modulus: 210e9,
        damping: 200.0,
        compression: 1e4,
    };

    fn cell(s: Complex64) -> Beam {
        let string = string();
        let tube = &string.sections()[0].parts[0];
        let mass = string.mass_sideways(tube, None);
        uniform(&BENDING, tube, Resistance::constant(&BENDING, mass, s))
    }

    fn difference(Block(one): Block, Block(other): Block) -> f64 {
        let entries = one.as_flattened().iter().zip(other.as_flattened());
        let relative = entries.map(|(a, b)| (a - b).norm() / (a.norm() + b.norm()));
        relative.fold(0.0, f64::max)
    }

    /// At low frequencies every cell matters, at high ones waves do not come back.
    #[test]
    fn a_row_is_what_joining_one_by_one_gives() {
        for s in [
            Complex64::new(0.1, 40.0),
            Complex64::new(30.0, 300.0),
            Complex64::new(700.0, 900.0),
        ] {
            let cell = cell(s);
            let row = cell.repeated(60).between_ends();
            let joined = (1..60).fold(cell, |row, _| row.join(&cell)).between_ends();
            assert!(difference(row.top, joined.top) < 1e-10, "{s}");
            assert!(difference(row.bottom, joined.bottom) < 1e-10, "{s}");
            if joined.is_endless() {
                assert!(row.is_endless(), "{s}");
            } else {
                assert!(difference(row.cross, joined.cross) < 1e-10, "{s}");
            }
        }
        assert!(cell(Complex64::new(700.0, 900.0)).repeated(60).is_endless());
        assert!(!cell(Complex64::new(0.1, 40.0)).repeated(60).is_endless());
    }

    /// The same with one matrix of all nodes, the surface among them.
    fn by_elimination(
        pieces: &[Beam],
        sites: usize,
        support: SurfaceSupport,
    ) -> Vec<Vec<Complex64>> {
        let size = 2 * (pieces.len() + 1);
        let mut stiffness = Mat::<Complex64>::zeros(size, size);
        for (upper, piece) in pieces.iter().enumerate() {
            let BeamStiffness { top, cross, bottom } = piece.between_ends();
            let blocks = [
                (0, 0, top),
                (0, 2, cross),
                (2, 0, cross.transpose()),
                (2, 2, bottom),
            ];
            for (row, column, Block(entries)) in blocks {
                for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    stiffness[(2 * upper + row + i, 2 * upper + column + j)] += entries[i][j];
                }
            }
        }
        // What is held takes any load.
        for held in 0..support.held() {
            stiffness[(held, held)] += Complex64::from(1e30);
        }
        let mut forces = Mat::<Complex64>::zeros(size, sites);
        for site in 0..sites {
            forces[(2 * (site + 1), site)] = 1.0.into();
        }
        let forces = equations::solve_complex(&stiffness, &forces);
        let of = |row: usize| {
            (0..sites)
                .map(|column| forces[(2 * (row + 1), column)])
                .collect()
        };
        (0..sites).map(of).collect()
    }

    #[test]
    fn sites_move_as_elimination_says() {
        let s = Complex64::new(0.5, 17.0);
        let piece = |cells: usize| cell(s).repeated(cells);
        for support in [
            SurfaceSupport::Free,
            SurfaceSupport::Pinned,
            SurfaceSupport::Clamped,
        ] {
            for (sites, cells) in [
                (1, vec![30]),
                (1, vec![30, 7]),
                (2, vec![9, 1]),
                (3, vec![5, 20, 1, 3]),
            ] {
                let pieces: Vec<Beam> = cells.iter().map(|&cells| piece(cells)).collect();
                let found = reduce(
                    pieces.iter().copied().map(Some),
                    &vec![0.0.into(); sites],
                    support,
                );
                let expected = by_elimination(&pieces, sites, support);
                for row in 0..sites {
                    for column in 0..sites {
                        let (a, b) = (found[(row, column)], expected[row][column]);
                        let error = (a - b).norm() / expected[row][row].norm();
                        assert!(error < 1e-9, "{support:?} {cells:?}: {a} {b}");
                    }
                }
            }
        }
    }
}
