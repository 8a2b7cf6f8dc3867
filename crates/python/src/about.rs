//! What a table of rows is of: the same of a sweep and of a results folder.

use campaign::plan::{MapSettings, Sweep};
use campaign::quantities::Axis;
use campaign::sweep_file::{FileContent, Spacing};
use limits::Curve;
use plot::method_style;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use results::folder::Manifest;

use crate::errors::refused;
use crate::look::UNITS;

/// Of the table that a sweep's run gives.
///
/// # Errors
/// Where memory does not take it.
pub fn about_sweep<'py>(py: Python<'py>, sweep: &Sweep) -> PyResult<Bound<'py, PyDict>> {
    let methods = sweep.methods.iter().map(|method| method.name()).collect();
    let axes = sweep.design.axes();
    let parts = (&sweep.title, axes, methods, sweep.map.as_ref());
    about(py, parts, &sweep.content, sweep.design.cases())
}

/// Of that of a folder.
///
/// # Errors
/// Where memory does not take it.
pub fn about_folder<'py>(py: Python<'py>, manifest: &Manifest) -> PyResult<Bound<'py, PyDict>> {
    let axes = manifest.axes.as_slice();
    let methods = manifest.method_names();
    let parts = (&manifest.title, axes, methods, manifest.map.as_ref());
    about(py, parts, &manifest.sweep, manifest.cases)
}

type Parts<'a> = (
    &'a String,
    &'a [Axis],
    Vec<&'a str>,
    Option<&'a MapSettings>,
);

fn about<'py>(
    py: Python<'py>,
    (title, axes, methods, map): Parts<'_>,
    content: &FileContent,
    cases: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let about = PyDict::new(py);
    let names = |axes: &[Axis]| axes.iter().map(|axis| axis.name()).collect::<Vec<_>>();
    let design = content.design.as_ref().map(|design| design.kind);
    // As a sweep file has it.
    let design = design.map(serde_json::to_value).transpose();
    let design = design.map_err(refused)?;
    let units = UNITS.iter().find(|(_, units)| *units == content.units);
    let on_map = map.map(|map| names(&[map.x, map.y]));
    about.set_item("title", title)?;
    about.set_item("axes", names(axes))?;
    about.set_item("methods", methods)?;
    about.set_item("cases", cases)?;
    about.set_item("design", design.as_ref().and_then(|design| design.as_str()))?;
    about.set_item("map_axes", on_map)?;
    let log = axes.iter().copied();
    let log = log.filter(|axis| content.spread(*axis) == Spacing::Log);
    about.set_item("log_axes", names(&log.collect::<Vec<_>>()))?;
    about.set_item("surface_speed_rpm", content.surface_speed_rpm)?;
    about.set_item("units", units.map(|(name, _)| *name))?;
    Ok(about)
}

/// Limits as curves, each by name with what it is of, its colour and its pieces.
///
/// # Errors
/// Where memory does not take them.
pub fn curves<'py>(py: Python<'py>, curves: Vec<Curve>) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let curve = |curve: Curve| {
        let colour = curve
            .method
            .as_deref()
            .and_then(|it| method_style(it).colour());
        let entry = PyDict::new(py);
        entry.set_item("name", curve.name)?;
        entry.set_item("motion", curve.motion.name())?;
        entry.set_item("along", curve.along.name())?;
        entry.set_item("limited", curve.limited.name())?;
        entry.set_item("colour", colour.map(|colour| colour.to_string()))?;
        entry.set_item("pieces", curve.pieces)?;
        Ok(entry)
    };
    curves.into_iter().map(curve).collect()
}
