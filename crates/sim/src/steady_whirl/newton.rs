//! Newton's method for a few unknowns, with steps that are halved until they help.

use numerics::{Mat, equations};

/// Steps, and how often one is halved.
const STEPS: usize = 40;
const HALVINGS: i32 = 12;

/// By how much an unknown is changed to see what that changes.
const DIFFERENCE: f64 = 1e-6;

/// What is left of each equation at a root, in parts of its size.
const BALANCED: f64 = 1e-10;

/// The root to which the method converges from a start, of as many equations as unknowns: `left` is
/// the residual of each, relative to its size. `None` where it does not converge.
pub(super) fn root(start: Vec<f64>, left: impl Fn(&[f64]) -> Vec<f64>) -> Option<Vec<f64>> {
    let mut place = start;
    let mut here = left(&place);
    for _ in 0..STEPS {
        if size(&here) < BALANCED {
            return Some(place);
        }
        let right = Mat::from_fn(here.len(), 1, |row, _| -here[row]);
        let step = equations::solve(&slopes(&place, &left), &right);
        (place, here) = (0..HALVINGS).find_map(|halving| {
            let part = 0.5_f64.powi(halving);
            let moved = place.iter().enumerate();
            let next: Vec<f64> = moved.map(|(row, it)| it + part * step[(row, 0)]).collect();
            let next_left = left(&next);
            (size(&next_left) < size(&here)).then_some((next, next_left))
        })?;
    }
    None
}

/// How what is left changes with the unknowns, by central differences.
fn slopes(place: &[f64], left: &impl Fn(&[f64]) -> Vec<f64>) -> Mat<f64> {
    let moved = |column: usize, by: f64| {
        let mut moved = place.to_vec();
        moved[column] += by;
        left(&moved)
    };
    let ends: Vec<[Vec<f64>; 2]> = (0..place.len())
        .map(|column| [-DIFFERENCE, DIFFERENCE].map(|by| moved(column, by)))
        .collect();
    Mat::from_fn(place.len(), place.len(), |row, column| {
        let [before, after] = &ends[column];
        (after[row] - before[row]) / (2.0 * DIFFERENCE)
    })
}

/// The root of the sum of squares; NaN where a value is.
fn size(left: &[f64]) -> f64 {
    left.iter().map(|part| part * part).sum::<f64>().sqrt()
}
