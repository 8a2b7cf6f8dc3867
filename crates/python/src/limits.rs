//! `Sweep.limits`: the analytic limit, with the columns and numbers of `boundary.csv`.

use std::sync::Arc;

use campaign::memory::Limit;
use campaign::run::RunSystems;
use limits::{Boundary, ForwardContact, boundary, boundary_csv, whirl_boundary};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::about::curves;
use crate::errors::refused;
use crate::read::ReadSweep;
use crate::run::not_begun;
use crate::table::{Column, Columns, by_name};
use crate::wait::wait_for;

/// The limits of a sweep, by column.
///
/// # Errors
/// Where it takes too much memory, or a method cannot treat the string.
pub fn limits<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    memory: Limit,
) -> PyResult<Bound<'py, PyDict>> {
    let boundary = boundary_of(py, sweep, memory)?;
    by_name(py, columns_of(&boundary_csv(&boundary)))
}

/// The same as curves that a map shows.
///
/// # Errors
/// As of [`limits`].
pub fn limit_curves<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    memory: Limit,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let plan = &sweep.campaign.sweep;
    let units = plan.content.units;
    let boundary = boundary_of(py, sweep, memory)?;
    let mut all = boundary.curves(plan.design.axes(), units);
    let forward = ForwardContact::of(plan).map_err(|error| sweep.about_file(error))?;
    all.extend(forward.and_then(|forward| forward.curve(units)));
    curves(py, all)
}

fn boundary_of(py: Python<'_>, sweep: &ReadSweep, memory: Limit) -> PyResult<Boundary> {
    let survey = sweep.look(py)?;
    let campaign = Arc::clone(&sweep.campaign);
    let systems = {
        let campaign = Arc::clone(&campaign);
        wait_for(py, move || {
            RunSystems::admitted(&campaign.sweep, &survey, &memory)
        })?
        .map_err(|error| not_begun(py, sweep, error))?
    };
    let found = wait_for(py, move || boundary(&campaign.sweep, &systems.methods))?;
    found.map_err(|error| sweep.about_file(error))
}

/// The limit of whirl between two surface speeds (rpm) of the string as the file has it, by the same
/// columns.
///
/// # Errors
/// Where the speeds are invalid.
pub fn whirl_limits<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    speeds: [f64; 2],
) -> PyResult<Bound<'py, PyDict>> {
    let [least, most] = speeds;
    if !(least > 0.0 && least <= most && most.is_finite()) {
        return Err(refused(format_args!(
            "{least} and {most} rpm are no least and greatest surface speed"
        )));
    }
    let campaign = Arc::clone(&sweep.campaign);
    let text = wait_for(py, move || {
        whirl_boundary(&campaign.sweep, speeds).map(|limit| boundary_csv(&limit))
    })?;
    by_name(
        py,
        columns_of(&text.map_err(|error| sweep.about_file(error))?),
    )
}

/// The columns of a table without quotes: numbers, where a column has no words.
pub fn columns_of(text: &str) -> Columns {
    let mut lines = text.lines();
    let names = lines.next().unwrap_or_default().split(',');
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |(place, name): (usize, &str)| {
        let fields: Vec<&str> = rows.iter().map(|row| row[place]).collect();
        let number = |field: &&str| match *field {
            "" => Some(f64::NAN),
            field => field.parse().ok(),
        };
        let numbers: Option<Vec<f64>> = fields.iter().map(number).collect();
        let word = |field: &&str| (!field.is_empty()).then(|| (*field).to_owned());
        let column = numbers.map_or_else(
            || Column::Text(fields.iter().map(word).collect()),
            Column::Number,
        );
        (name.to_owned(), column)
    };
    names.enumerate().map(column).collect()
}
