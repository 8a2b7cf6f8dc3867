//! The shapes that a string is projected onto: its modes, and what is left without these of how it is bent by
//! a force at each site.

use num_complex::Complex64;
use numerics::{Mat, eigenvalues};

use super::elements::{Elements, Mode, SLOW};
use super::projection::{Coordinates, Gram, Projected};
use crate::error::BuildError;

/// Squares of the frequencies of modes, as a part of the greatest, that are rounding.
const ROUNDING: f64 = 1e-14;

/// The part of the greatest up to which a negative square is rounding: twenty times as much as was seen of a free
/// string with 800 modes (5e-14; 2e-14 with 600). A string that buckles by less than that, growing by some tenths a
/// second, is taken as free.
const ROUNDING_BELOW_ZERO: f64 = 1e-12;

/// The least part of a pole that turns: one that turns less is one of several that fade.
const LEAST_TURN: f64 = 0.1;

/// Modes, in columns, then a shape for each site.
struct Shapes<'a> {
    elements: &'a Elements,
    /// Squares of the frequencies of the modes, (rad/s)²; those that are rounding are zero.
    squares: Vec<f64>,
    columns: Mat<f64>,
    /// What of each mode a force at each site that grows slowly bends.
    in_modes: Mat<f64>,
}

impl Elements {
    /// Projected onto its modes up to a frequency, rad/s, and what is left of the shapes that forces at the
    /// sites bend it to.
    ///
    /// # Errors
    /// Where it buckles, or its modes are not found.
    pub(super) fn projected(&self, fastest: f64) -> Result<Projected, BuildError> {
        let shapes = Shapes::of(self, fastest)?;
        let (modes, sites) = (shapes.squares.len(), self.places.len());
        let gram = shapes.gram();
        let turning: Vec<Option<Complex64>> =
            (0..modes).map(|mode| shapes.turning(mode, &gram)).collect();
        let of_mode = |mode: usize| match turning[mode] {
            Some(pole) => self.coordinates(mode, pole),
            // What nothing holds keeps no energy where it is.
            None => self.apart(mode, usize::from(shapes.squares[mode] == 0.0)),
        };
        let of_site = |site: usize| {
            let growths = [0.0, SLOW].into_iter();
            growths.flat_map(move |growth| self.coordinates(modes + site, growth.into()))
        };
        let at_rest = |site: usize| self.coordinates(modes + sites + site, 0.0.into());
        let growing = |site: usize| self.coordinates(modes + 2 * sites + site, SLOW.into());
        let coordinates: Vec<Coordinates> = (0..modes)
            .flat_map(of_mode)
            .chain((0..sites).flat_map(of_site))
            .chain((0..sites).flat_map(at_rest))
            .chain((0..sites).flat_map(growing))
            .collect();
        let rates: Vec<f64> = self.drag.iter().map(|(rate, _)| *rate).collect();
        let bent = shapes.bent(&turning);
        let with_bent = |at: Mat<f64>| {
            let of_bent = &at * &bent;
            Mat::from_fn(at.nrows(), modes + 3 * sites, |place, shape| {
                match shape.checked_sub(modes + sites) {
                    Some(bent) => of_bent[(place, bent)],
                    None => at[(place, shape)],
                }
            })
        };
        let at_sites = Mat::from_fn(sites, modes + sites, |site, shape| {
            shapes.at_site(site, shape)
        });
        let seen = Mat::from_fn(self.seen.len(), modes + sites, |place, shape| {
            shapes.seen(place, shape)
        });
        let outputs = [at_sites, seen].map(with_bent);
        let gram = with_more(&gram, &bent);
        Projected::of(&coordinates, &gram, (&rates, &self.material), &outputs)
    }
}

impl<'a> Shapes<'a> {
    fn of(elements: &'a Elements, fastest: f64) -> Result<Self, BuildError> {
        let (squares, vectors) =
            eigenvalues::of_pencil_with_vectors(&elements.stiffness, &elements.mass)?;
        let largest = squares.last().copied().unwrap_or_default();
        let rounding = ROUNDING * largest;
        if (squares.first()).is_some_and(|least| *least < -ROUNDING_BELOW_ZERO * largest) {
            return Err(BuildError::Buckles);
        }
        let modes = squares.partition_point(|square| *square < fastest * fastest);
        let of_modes = vectors.subcols(0, modes).to_owned();
        // Without the modes, which are slow and soft, no small number is the difference of large ones.
        let bent = elements.bent();
        let in_modes = of_modes.transpose() * (&elements.mass * &bent);
        let rest = &bent - &of_modes * &in_modes;
        let (size, sites) = (bent.nrows(), bent.ncols());
        let columns = Mat::from_fn(size, modes + sites, |row, column| {
            match column.checked_sub(modes) {
                None => of_modes[(row, column)],
                Some(site) => rest[(row, site)],
            }
        });
        let known = squares[..modes].iter();
        let or_none = |square: &f64| if *square > rounding { *square } else { 0.0 };
        Ok(Self {
            elements,
            squares: known.map(or_none).collect(),
            columns,
            in_modes,
        })
    }

    /// Displacement of a site by a shape.
    fn at_site(&self, site: usize, shape: usize) -> f64 {
        self.columns[(self.elements.places[site], shape)]
    }

    /// The same of what is seen besides.
    fn seen(&self, place: usize, shape: usize) -> f64 {
        let weighted = self.elements.seen[place].iter();
        weighted
            .map(|(freedom, weight)| weight * self.columns[(*freedom, shape)])
            .sum()
    }

    /// What the matrices are between shapes.
    fn gram(&self) -> Gram {
        let (elements, modes) = (self.elements, self.squares.len());
        let rest = self
            .columns
            .subcols(modes, self.columns.ncols() - modes)
            .to_owned();
        // Modes have nothing in common with one another, nor with what is left without them.
        let apart = |matrix: &Mat<f64>, of_mode: &dyn Fn(usize) -> f64| {
            let of_rest = gram_of(matrix, &rest);
            let all = self.columns.ncols();
            Mat::from_fn(all, all, |row, column| {
                match (row.checked_sub(modes), column.checked_sub(modes)) {
                    (Some(row), Some(column)) => of_rest[(row, column)],
                    (None, None) if row == column => of_mode(row),
                    _ => 0.0,
                }
            })
        };
        let of_drag = elements.drag.iter();
        Gram {
            stiffness: apart(&elements.stiffness, &|mode| self.squares[mode]),
            mass: apart(&elements.mass, &|_| 1.0),
            elastic: elements
                .elastic
                .as_ref()
                .map(|it| gram_of(it, &self.columns)),
            dashpots: diagonal_gram(&elements.dashpots, &self.columns),
            drag: of_drag
                .map(|(_, dashpots)| diagonal_gram(dashpots, &self.columns))
                .collect(),
        }
    }

    /// The pole of a mode, 1/s, where it turns.
    fn turning(&self, mode: usize, gram: &Gram) -> Option<Complex64> {
        let place = (mode, mode);
        let pole = self.elements.pole(&Mode {
            stiffness: self.squares[mode],
            dashpot: gram.dashpots[place],
            elastic: gram.elastic.as_ref().map_or(0.0, |it| it[place]),
            drag: gram.drag.iter().map(|it| it[place]).collect(),
        });
        (pole.im.abs() > LEAST_TURN * pole.norm()).then_some(pole)
    }

    /// How a force at each site bends the modes that turn: where all is at rest, and where it grows slowly.
    /// Then what fades is bent otherwise than as they turn.
    fn bent(&self, turning: &[Option<Complex64>]) -> Mat<f64> {
        let sites = self.elements.places.len();
        Mat::from_fn(
            self.columns.ncols(),
            2 * sites,
            |shape, column| match turning.get(shape) {
                Some(Some(_)) if column < sites => {
                    self.at_site(column, shape) / self.squares[shape]
                }
                Some(Some(_)) => self.in_modes[(shape, column - sites)],
                _ => 0.0,
            },
        )
    }
}

/// The same with shapes more, each of which is made of those that are there.
fn with_more(gram: &Gram, more: &Mat<f64>) -> Gram {
    let (all, size) = (more.nrows(), more.nrows() + more.ncols());
    let made_of = Mat::from_fn(all, size, |shape, column| match column.checked_sub(all) {
        Some(column) => more[(shape, column)],
        None if shape == column => 1.0,
        None => 0.0,
    });
    let of = |matrix: &Mat<f64>| gram_of(matrix, &made_of);
    Gram {
        stiffness: of(&gram.stiffness),
        mass: of(&gram.mass),
        elastic: gram.elastic.as_ref().map(of),
        dashpots: of(&gram.dashpots),
        drag: gram.drag.iter().map(of).collect(),
    }
}

/// XᵀMX.
fn gram_of(matrix: &Mat<f64>, shapes: &Mat<f64>) -> Mat<f64> {
    shapes.transpose() * (matrix * shapes)
}

/// The same of a diagonal matrix.
fn diagonal_gram(diagonal: &[f64], shapes: &Mat<f64>) -> Mat<f64> {
    let weighted = Mat::from_fn(shapes.nrows(), shapes.ncols(), |row, column| {
        diagonal[row] * shapes[(row, column)]
    });
    shapes.transpose() * weighted
}
