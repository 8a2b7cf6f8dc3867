//! `Sweep.static_string`: how the string lies at rest in its hole.

use std::sync::Arc;

use campaign::static_string::{NamedFields, StaticString};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use statics::Bit;

use crate::errors::refused;
use crate::read::ReadSweep;
use crate::table::{Column, by_name};
use crate::wait::wait_for;

/// Its numbers as JSON, and its tables by column.
pub type Parts<'py> = (String, Bound<'py, PyDict>, Bound<'py, PyDict>);

/// The string of a sweep as it lies at rest, its bit held as in its cases or as is said; nothing where
/// the course of its well is not known, or it has no wall.
///
/// # Errors
/// Where it has no such state, or the bit is held in no way that is known.
pub fn static_string<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    bit: Option<&str>,
) -> PyResult<Option<Parts<'py>>> {
    let bit = match bit {
        None => None,
        Some("contact") => Some(Bit::Contact),
        Some("pinned") => Some(Bit::Pinned),
        Some("free") => Some(Bit::Free),
        Some(other) => {
            return Err(refused(format_args!(
                "bit: {other:?} is neither \"contact\", \"pinned\" nor \"free\""
            )));
        }
    };
    let campaign = Arc::clone(&sweep.campaign);
    let found = wait_for(py, move || {
        let plan = &campaign.sweep;
        StaticString::of(&plan.setting, &plan.under_greatest_weight(), bit)
    })?;
    let Some(string) = found.transpose().map_err(|error| sweep.about_file(error))? else {
        return Ok(None);
    };
    let numbers = serde_json::to_string(&string.numbers()).map_err(refused)?;
    let along = by_name(py, columns(&string.along()))?;
    Ok(Some((
        numbers,
        along,
        by_name(py, columns(&string.sites()))?,
    )))
}

/// The columns of rows that name them.
fn columns<const COUNT: usize>(rows: &[NamedFields<COUNT>]) -> Vec<(String, Column)> {
    let Some(first) = rows.first() else {
        return Vec::new();
    };
    let column = |(place, (name, _)): (usize, &(&str, Option<f64>))| {
        let values = rows.iter().map(|row| row[place].1.unwrap_or(f64::NAN));
        ((*name).to_owned(), Column::Number(values.collect()))
    };
    first.iter().enumerate().map(column).collect()
}
