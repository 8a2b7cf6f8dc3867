//! The string in coordinates in which its energy is half a sum of squares.

use numerics::{Mat, eigenvalues};

use crate::error::BuildError;
use crate::loss::Relaxation;

/// Coordinates with less than this part of the energy of the one that has most are left out: they are
/// rounding of the others.
const LEAST_ENERGY: f64 = 1e-11;

/// A state of the whole string: a shape, times each of these.
pub(super) struct Coordinates {
    pub(super) shape: usize,
    pub(super) displacement: f64,
    pub(super) speed: f64,
    /// Of the spring behind each dashpot of drag that fades: its rate times how far it is bent, m/s.
    pub(super) drag: Vec<f64>,
    /// Of each relaxation of the material: how far what fades of it is bent.
    pub(super) material: Vec<f64>,
}

/// What matrices of the elements are between shapes.
pub(super) struct Gram {
    pub(super) stiffness: Mat<f64>,
    pub(super) mass: Mat<f64>,
    pub(super) elastic: Option<Mat<f64>>,
    pub(super) dashpots: Mat<f64>,
    pub(super) drag: Vec<Mat<f64>>,
}

/// q̇ = `system` q + `by_force` f.
pub(super) struct Projected {
    pub(super) system: Mat<f64>,
    pub(super) by_force: Mat<f64>,
    /// Speeds at what is seen besides (columns) by each coordinate.
    pub(super) seen: Mat<f64>,
}

impl Projected {
    /// Of some states between their shapes, of relaxations of drag (1/s) and of the material, and of the
    /// displacement at each site (row) of each shape, and at what is seen besides.
    pub(super) fn of(
        states: &[Coordinates],
        gram: &Gram,
        (drag_rates, material): (&[f64], &[Relaxation]),
        outputs: &[Mat<f64>; 2],
    ) -> Result<Self, BuildError> {
        let count = states.len();
        let (mut energy, mut flow) = (Mat::zeros(count, count), Mat::zeros(count, count));
        for (row, one) in states.iter().enumerate() {
            for (column, other) in states.iter().enumerate() {
                let place = (one.shape, other.shape);
                let stiffness = gram.stiffness[place];
                let speeds = one.speed * other.speed;
                let mut stored =
                    one.displacement * other.displacement * stiffness + speeds * gram.mass[place];
                let mut exchanged =
                    (one.displacement * other.speed - one.speed * other.displacement) * stiffness;
                let mut lost = speeds * gram.dashpots[place];
                let of_drag = gram
                    .drag
                    .iter()
                    .zip(drag_rates)
                    .zip(one.drag.iter().zip(&other.drag));
                for ((dashpots, rate), (here, there)) in of_drag {
                    let dashpot = dashpots[place];
                    stored += here * there * dashpot / rate;
                    lost += (one.speed - here) * (other.speed - there) * dashpot;
                }
                let fading = gram.elastic.as_ref().map_or(0.0, |it| it[place]);
                let of_material = material
                    .iter()
                    .zip(one.material.iter().zip(&other.material));
                for (it, (here, there)) in of_material {
                    let elastic = it.weight * fading;
                    stored += here * there * elastic;
                    exchanged += (here * other.speed - one.speed * there) * elastic;
                    lost += it.rate * here * there * elastic;
                }
                energy[(row, column)] = stored;
                flow[(row, column)] = exchanged - lost;
            }
        }
        // Each state of energy one: what is left of them is compared. Some have none.
        let scale = |it: usize| match energy[(it, it)] {
            stored if stored > 0.0 => stored.sqrt().recip(),
            _ => 0.0,
        };
        let scales: Vec<f64> = (0..count).map(scale).collect();
        let scaled = Mat::from_fn(count, count, |row, column| {
            0.5 * (energy[(row, column)] + energy[(column, row)]) * scales[row] * scales[column]
        });
        let (parts, vectors) = eigenvalues::of_symmetric_with_vectors(&scaled)?;
        let most = parts.last().copied().unwrap_or(0.0);
        let first = parts.partition_point(|part| *part <= LEAST_ENERGY * most);
        let turn = Mat::from_fn(count, count - first, |row, column| {
            let part = first + column;
            scales[row] * vectors[(row, part)] / parts[part].sqrt()
        });
        let [by_force, seen] = outputs.each_ref().map(|at| {
            let speeds = Mat::from_fn(count, at.nrows(), |state, place| {
                states[state].speed * at[(place, states[state].shape)]
            });
            turn.transpose() * &speeds
        });
        Ok(Self {
            system: turn.transpose() * (&flow * &turn),
            by_force,
            seen,
        })
    }
}
