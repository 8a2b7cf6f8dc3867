//! Sparse matrices, and what has no decomposition.

use numerics::NumericsError;
use numerics::sparse::{Cholesky, Entry, SparseMatrix};

fn matrix(entries: &[(usize, usize, f64)]) -> Result<SparseMatrix, NumericsError> {
    let entry = |&(row, column, value): &(usize, usize, f64)| Entry::new(row, column, value);
    SparseMatrix::new(2, &entries.iter().map(entry).collect::<Vec<_>>())
}

#[test]
fn equal_places_are_summed() {
    let matrix = matrix(&[(1, 0, 2.0), (0, 0, 1.0), (1, 0, 3.0)]).unwrap();
    let found: Vec<_> = matrix.entries().collect();
    assert_eq!(found, [(0, 0, 1.0), (1, 0, 5.0)]);
    let mut sum = [1.0, 1.0];
    matrix.add_product(-2.0, &[3.0, 7.0], &mut sum);
    assert_eq!(sum, [-5.0, -29.0]);
}

#[test]
fn what_has_no_decomposition_is_an_error() {
    let outside = matrix(&[(2, 1, 1.0)]).unwrap_err();
    assert_eq!(outside, NumericsError::Outside { row: 2, column: 1 });
    let indefinite = matrix(&[(0, 0, 1.0), (1, 1, -1.0)]).unwrap();
    let error = Cholesky::new(&indefinite).unwrap_err();
    let is_indefinite = matches!(error, NumericsError::NotPositiveDefinite { .. });
    assert!(is_indefinite, "{error}");
}
