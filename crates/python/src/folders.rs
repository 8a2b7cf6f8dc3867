//! What is asked of results folders: how often each regime occurs and which axis decides, as
//! `sweep analyse` has it, and operating windows, as `sweep window` has them.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use campaign::quantities::Axis;
use campaign::sweep_file::axis_in_units;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use results::analysis::{Analysis, COUNT_COLUMNS, INDEX_COLUMNS, count_rows, index_rows};
use results::folder::ResultTables;
use results::window::{AXES, Best, OperatingWindow, WINDOW_COLUMNS, WindowAsked};

use crate::errors::{refused, warn};
use crate::read::ReadSweep;
use crate::table::{by_name, table_of};
use crate::wait::wait_for;

/// The tables of folders.
pub fn open(py: Python<'_>, folders: &[PathBuf]) -> PyResult<Vec<ResultTables>> {
    if folders.is_empty() {
        return Err(refused("name at least one results folder"));
    }
    let (mut all, mut notes) = (Vec::new(), Vec::new());
    for folder in folders {
        let opened = py.detach(|| ResultTables::open(folder, |note| notes.push(note)));
        all.push(opened.map_err(refused)?);
    }
    for note in notes {
        warn(py, note)?;
    }
    Ok(all)
}

/// How often each regime occurs, over each set of axes, and Sobol's indices: the columns of both
/// tables of `sweep analyse`.
#[pyfunction]
pub fn _analyse<'py>(
    py: Python<'py>,
    folders: Vec<PathBuf>,
    by: Vec<Vec<String>>,
    bins: usize,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
    if !(1..=1000).contains(&bins) {
        return Err(refused(format_args!("bins {bins}: not from 1 to 1000")));
    }
    let by = by.iter().map(|names| axes_of(names));
    let by = by.collect::<PyResult<Vec<_>>>()?;
    let tables = open(py, &folders)?;
    let analysed = wait_for(py, move || {
        let analysis = Analysis::of(&folders, &tables, &by, bins)?;
        let counts = count_rows(&analysis.counts);
        let indices = index_rows(&analysis.axes, &analysis.blocks);
        Ok::<_, results::analysis::NoAnalysis>((
            table_of(&COUNT_COLUMNS, counts.iter().map(|row| row.fields())),
            table_of(&INDEX_COLUMNS, indices.iter().map(|row| row.fields())),
        ))
    })?;
    let (counts, indices) = analysed.map_err(refused)?;
    Ok((by_name(py, counts)?, by_name(py, indices)?))
}

/// One axis or two.
fn axes_of(names: &[String]) -> PyResult<Vec<Axis>> {
    let axes = names.iter().map(|name| axis_in_units(name).map(|it| it.0));
    let axes = axes.collect::<Result<Vec<_>, _>>().map_err(refused)?;
    if axes.is_empty() || axes.len() > 2 || (axes.len() == 2 && axes[0] == axes[1]) {
        let names = names.join(",");
        return Err(refused(format_args!("`{names}` is not one axis, or two")));
    }
    Ok(axes)
}

/// The operating window of a sweep by results of its string: the columns of `window.csv`, and the
/// best point.
///
/// # Errors
/// Where there is none, or a number is out of its range.
pub fn window<'py>(
    py: Python<'py>,
    sweep: &ReadSweep,
    folders: Vec<PathBuf>,
    asked: WindowAsked,
    clearance: f64,
) -> PyResult<(Bound<'py, PyDict>, Option<Bound<'py, PyDict>>)> {
    check(&asked, clearance)?;
    let tables = open(py, &folders)?;
    let campaign = Arc::clone(&sweep.campaign);
    let found = wait_for(py, move || {
        let all: Vec<_> = folders.into_iter().zip(tables).collect();
        let window = OperatingWindow::of(&campaign.sweep, &all, &asked)?;
        let best = window.chart.best(clearance);
        let cells = table_of(&WINDOW_COLUMNS, window.chart.rows());
        Ok::<_, results::window::WindowError>((cells, best))
    })?;
    let (cells, best) = found.map_err(refused)?;
    let best = best.map(|best| point(py, &best)).transpose()?;
    Ok((by_name(py, cells)?, best))
}

/// As the command line has them.
fn check(asked: &WindowAsked, clearance: f64) -> PyResult<()> {
    let parts = [
        ("margin", asked.margin),
        ("risk", asked.risk),
        ("clearance", clearance),
    ];
    if let Some((name, part)) = parts.iter().find(|(_, part)| !(0.0..=0.5).contains(part)) {
        let words = format_args!("{name} {part}: not a part from 0 to 0.5").to_string();
        return Err(refused(words));
    }
    if let Some(order) = asked
        .orders
        .iter()
        .find(|it| !(0.01..=1000.0).contains(*it))
    {
        return Err(refused(format_args!(
            "orders {order}: not a multiple from 0.01 to 1000"
        )));
    }
    match asked.bins {
        2..=100 => Ok(()),
        bins => Err(refused(format_args!("bins {bins}: not from 2 to 100"))),
    }
}

/// The best point by name.
fn point<'py>(py: Python<'py>, best: &Best) -> PyResult<Bound<'py, PyDict>> {
    let point = PyDict::new(py);
    for (axis, at) in AXES.iter().zip(best.at) {
        point.set_item(axis.name(), at)?;
    }
    point.set_item("clearance", best.clearance)?;
    point.set_item("standing", best.standing.key())?;
    point.set_item("is_as_asked", best.is_as_asked)?;
    if let Some(rate) = best.rate_of_penetration_m_h {
        point.set_item("rate_of_penetration_m_h", rate)?;
    }
    Ok(point)
}

/// The folder that `sweep run` writes, where no other is named.
pub fn own_folder(sweep: &ReadSweep) -> PathBuf {
    Path::new("results").join(&sweep.campaign.sweep.name)
}
