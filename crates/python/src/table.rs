//! Rows of `labels.csv` and other tables as columns in memory.

use std::collections::HashMap;

use campaign::labels::LabelTable;
use campaign::records::{Certainty, Field, Kind, Record};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyNone, PyString};

use crate::arrays::vector;

/// A column; missing values are `None`, or NaN.
pub enum Column {
    /// Names.
    Text(Vec<Option<String>>),
    /// Numbers.
    Number(Vec<f64>),
    /// Numbers of things.
    Count(Vec<Option<usize>>),
    /// Whether something is so.
    Flag(Vec<Option<bool>>),
}

/// Columns by name, in their order.
pub type Columns = Vec<(String, Column)>;

/// The columns of rows in their order.
pub fn columns(table: &LabelTable, records: &[Record]) -> Columns {
    let mut columns: Vec<(String, Column)> = (table.columns().into_iter())
        .map(|(name, kind)| (name, Column::with_capacity(kind, records.len())))
        .collect();
    for (record, certainty) in records.iter().zip(table.certainties(records)) {
        let fields = table.fields(record, certainty);
        for ((_, column), field) in columns.iter_mut().zip(fields) {
            column.push(field);
        }
    }
    columns
}

/// The columns of a table of any rows.
pub fn table_of<'a, const COLUMNS: usize>(
    columns: &[(&str, Kind); COLUMNS],
    rows: impl Iterator<Item = [Field<'a>; COLUMNS]>,
) -> Vec<(String, Column)> {
    let column = |&(name, kind): &(&str, Kind)| (name.to_owned(), Column::with_capacity(kind, 0));
    let mut table: Vec<(String, Column)> = columns.iter().map(column).collect();
    for row in rows {
        for ((_, column), field) in table.iter_mut().zip(row) {
            column.push(field);
        }
    }
    table
}

/// The columns of a table that is read row by row.
///
/// # Errors
/// Where a row cannot be read.
pub fn typed_columns(
    columns: &[(String, Kind)],
    rows: impl Iterator<Item = anyhow::Result<Vec<Field<'static>>>>,
) -> anyhow::Result<Columns> {
    let column = |(name, kind): &(String, Kind)| (name.clone(), Column::with_capacity(*kind, 0));
    let mut table: Columns = columns.iter().map(column).collect();
    for row in rows {
        for ((_, column), field) in table.iter_mut().zip(row?) {
            column.push(field);
        }
    }
    Ok(table)
}

/// Columns as arrays by name.
///
/// # Errors
/// Where memory does not take it.
pub fn by_name(py: Python<'_>, table: Vec<(String, Column)>) -> PyResult<Bound<'_, PyDict>> {
    let arrays = PyDict::new(py);
    for (name, column) in table {
        arrays.set_item(name, column.array(py)?)?;
    }
    Ok(arrays)
}

impl Column {
    fn with_capacity(kind: Kind, rows: usize) -> Self {
        match kind {
            Kind::Text => Column::Text(Vec::with_capacity(rows)),
            Kind::Number => Column::Number(Vec::with_capacity(rows)),
            Kind::Count => Column::Count(Vec::with_capacity(rows)),
            Kind::Flag => Column::Flag(Vec::with_capacity(rows)),
        }
    }

    fn push(&mut self, field: Field) {
        match (self, field) {
            (Column::Text(column), Field::Text(text)) => column.push(Some(text.into_owned())),
            (Column::Text(column), _) => column.push(None),
            (Column::Number(column), Field::Number(number)) => column.push(number),
            (Column::Number(column), _) => column.push(f64::NAN),
            (Column::Count(column), Field::Count(count)) => column.push(Some(count)),
            (Column::Count(column), _) => column.push(None),
            (Column::Flag(column), Field::Flag(flag)) => column.push(Some(flag)),
            (Column::Flag(column), _) => column.push(None),
        }
    }

    /// As an array of NumPy: of objects where rows lack a word or a flag, of floating-point
    /// numbers where they lack a count.
    ///
    /// # Errors
    /// Where memory does not take it.
    pub fn array(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let objects = |objects: Vec<Py<PyAny>>| PyArray1::from_vec(py, objects).into_any();
        Ok(match self {
            Column::Number(numbers) => vector(py, numbers).into_any(),
            Column::Count(counts) => match whole(&counts) {
                Some(counts) => {
                    let counts = counts.into_iter().map(|count| count as i64);
                    vector(py, counts.collect()).into_any()
                }
                None => {
                    let number = |count: Option<usize>| count.map_or(f64::NAN, |it| it as f64);
                    vector(py, counts.into_iter().map(number).collect()).into_any()
                }
            },
            Column::Flag(flags) => match whole(&flags) {
                Some(flags) => vector(py, flags).into_any(),
                None => {
                    let flag = |flag: Option<bool>| flag.into_pyobject(py).map(Bound::unbind);
                    objects(flags.into_iter().map(flag).collect::<Result<_, _>>()?)
                }
            },
            Column::Text(texts) => {
                // There are few words.
                let mut known: HashMap<String, Py<PyAny>> = HashMap::new();
                let word = |text: Option<String>| match text {
                    None => PyNone::get(py).to_owned().into_any().unbind(),
                    Some(text) => (known.entry(text))
                        .or_insert_with_key(|text| PyString::new(py, text).into_any().unbind())
                        .clone_ref(py),
                };
                objects(texts.into_iter().map(word).collect())
            }
        })
    }
}

/// The values where none is missing.
fn whole<T: Copy>(values: &[Option<T>]) -> Option<Vec<T>> {
    values.iter().copied().collect()
}

/// Puts the row of a record into a dictionary by column.
///
/// # Errors
/// Where memory does not take it.
pub fn put_row(table: &LabelTable, record: &Record, row: &Bound<'_, PyDict>) -> PyResult<()> {
    let fields = table.fields(record, Certainty::default());
    for ((name, _), field) in table.columns().into_iter().zip(fields) {
        match field {
            Field::Nothing => row.set_item(name, row.py().None())?,
            Field::Text(text) => row.set_item(name, text)?,
            Field::Number(number) => row.set_item(name, number)?,
            Field::Count(count) => row.set_item(name, count)?,
            Field::Flag(flag) => row.set_item(name, flag)?,
        }
    }
    Ok(())
}
