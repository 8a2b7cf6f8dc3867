//! What is solved gives the right side again.

use numerics::equations::{solve, solve_complex};
use numerics::{Complex64, Mat};

/// The first pivot is zero: rows have to change places.
#[test]
fn a_solution_gives_the_right_side_again() {
    let entries = [[0.0, 2.0, 1.0], [1.0, -1.0, 3.0], [4.0, 0.5, -2.0]];
    let sides = [[1.0, 0.0], [-2.0, 5.0], [0.5, 1.0]];
    let matrix = Mat::from_fn(3, 3, |row, column| entries[row][column]);
    let right = Mat::from_fn(3, 2, |row, column| sides[row][column]);
    let found = solve(&matrix, &right);
    // Both sides turned by the same angle.
    let turned = |it: f64| Complex64::new(0.6, 0.8) * it;
    let matrix = Mat::from_fn(3, 3, |row, column| turned(entries[row][column]));
    let right = Mat::from_fn(3, 2, |row, column| turned(sides[row][column]));
    let of_turned = solve_complex(&matrix, &right);
    for (row, column) in (0..3).flat_map(|row| [(row, 0), (row, 1)]) {
        let again: f64 = (0..3)
            .map(|it| entries[row][it] * found[(it, column)])
            .sum();
        assert!((again - sides[row][column]).abs() < 1e-14);
        assert!((of_turned[(row, column)] - found[(row, column)]).norm() < 1e-14);
    }
}
