//! Eigenvalues of matrices of two rows, and whether all are positive of up to nine.

use numerics::eigenvalues::{
    are_positive, are_positive_of_symmetric, general, of_hermitian, of_pencil, with_vectors,
};
use numerics::{Complex64, Mat, NumericsError};

fn complex(entries: [[Complex64; 2]; 2]) -> Mat<Complex64> {
    Mat::from_fn(2, 2, |row, column| entries[row][column])
}

fn real(entries: [[f64; 2]; 2]) -> Mat<f64> {
    Mat::from_fn(2, 2, |row, column| entries[row][column])
}

#[test]
fn a_hermitian_matrix_turns_its_vectors_into_their_multiples() {
    let (i, two) = (Complex64::I, Complex64::from(2.0));
    let matrix = complex([[two, -i], [i, two]]);
    let (values, vectors) = with_vectors(&matrix).unwrap();
    let alone = of_hermitian(&matrix).unwrap();
    for (place, expected) in [1.0, 3.0].into_iter().enumerate() {
        assert!((values[place] - expected).abs() < 1e-14);
        assert!((alone[place] - expected).abs() < 1e-14);
        let [up, down] = [vectors[(0, place)], vectors[(1, place)]];
        assert!((two * up - i * down - expected * up).norm() < 1e-14);
        assert!((i * up + two * down - expected * down).norm() < 1e-14);
        assert!((up.norm_sqr() + down.norm_sqr() - 1.0).abs() < 1e-14);
    }
}

/// They are 1 ± the entry off the diagonal.
#[test]
fn all_are_positive_where_the_least_is() {
    let matrix = |off: f64| {
        let (one, off) = (Complex64::from(1.0), Complex64::new(0.0, off));
        complex([[one, -off], [off, one]])
    };
    assert!(are_positive(&matrix(0.99)));
    assert!(!are_positive(&matrix(1.01)));
}

/// Gram matrices of sines of rising arguments, less what is close to the least eigenvalue.
#[test]
fn all_of_a_symmetric_matrix_are_positive_where_the_least_is() {
    for size in 1..=9 {
        let vector = |row: usize, place: usize| (((row + 1) * (place + 2) * 37) as f64).sin();
        let gram = |row: usize, column: usize| -> f64 {
            let places = 0..size + 3;
            places
                .map(|place| vector(row, place) * vector(column, place))
                .sum()
        };
        let matrix = Mat::from_fn(size, size, |row, column| Complex64::from(gram(row, column)));
        let least = of_hermitian(&matrix).unwrap()[0];
        for (part, expected) in [(0.999, true), (1.001, false), (f64::NAN, false)] {
            let below = |row| (0..=row).map(move |column| (row, column));
            let places = (0..size).flat_map(below);
            let mut lower: Vec<f64> = places
                .map(|(row, column)| match row == column {
                    true => gram(row, row) - part * least,
                    false => gram(row, column),
                })
                .collect();
            assert_eq!(
                are_positive_of_symmetric(&mut lower),
                expected,
                "{size} {part}"
            );
        }
    }
}

/// Two masses on springs between walls: ω² in phase and in opposition.
#[test]
fn a_pencil_has_the_squared_frequencies_of_masses_on_springs() {
    let stiffness = real([[3.0, -1.0], [-1.0, 3.0]]);
    let mass = real([[2.0, 0.0], [0.0, 2.0]]);
    let found = of_pencil(&stiffness, &mass).unwrap();
    assert!((found[0] - 1.0).abs() < 1e-14 && (found[1] - 2.0).abs() < 1e-14);
    let indefinite = real([[1.0, 2.0], [2.0, 1.0]]);
    let error = of_pencil(&stiffness, &indefinite).unwrap_err();
    assert_eq!(error, NumericsError::NotPositiveDefinite { row: 1 });
}

#[test]
fn a_matrix_that_is_not_finite_has_no_eigenvalues() {
    let matrix = real([[f64::NAN, 1.0], [1.0, 0.0]]);
    assert_eq!(general(&matrix), Err(NumericsError::NoConvergence));
}
