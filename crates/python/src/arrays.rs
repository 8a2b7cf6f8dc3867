//! Numbers as arrays of NumPy, in memory that they take over.

use linear::Complex64;
use numpy::{Element, PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// An array of one axis.
pub fn vector<'py, T: Element>(py: Python<'py>, values: Vec<T>) -> Bound<'py, PyArray1<T>> {
    PyArray1::from_vec(py, values)
}

/// An array of any shape, its numbers row by row.
///
/// # Errors
/// Where they are not as many.
pub fn shaped<'py, T: Element>(
    py: Python<'py>,
    values: Vec<T>,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    vector(py, values).reshape(shape.to_vec())
}

/// Rows of equal length as an array of two axes.
///
/// # Errors
/// Where they are not equally long.
pub fn rows<'py, T: Element + Copy>(
    py: Python<'py>,
    rows: &[Vec<T>],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let length = rows.first().map_or(0, Vec::len);
    shaped(py, rows.concat(), &[rows.len(), length])
}

/// Points in a plane, of which each row has equally many, as an array of three axes.
///
/// # Errors
/// Where the rows are not equally long.
pub fn planes<'py>(
    py: Python<'py>,
    rows: &[Vec<[f64; 2]>],
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let length = rows.first().map_or(0, Vec::len);
    let values = rows.iter().flatten().flatten().copied().collect();
    shaped(py, values, &[rows.len(), length, 2])
}

/// Any numbers in a sequence or an array, in their order.
///
/// # Errors
/// Where they are not numbers.
pub fn numbers(values: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    values.try_iter()?.map(|value| value?.extract()).collect()
}

/// Complex numbers of NumPy.
pub type Complex = Complex64;
