//! `Results.read`: what is in a results folder.

use std::path::{Path, PathBuf};

use anyhow::{Result, bail};
use campaign::memory::{Limit, Size};
use limits::{Boundary, Curve, boundary_csv};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use results::folder::{ResultTables, typed_rows};

use crate::about::{about_folder, curves};
use crate::errors::refused;
use crate::folders::open;
use crate::limits::columns_of;
use crate::table::{Columns, by_name, typed_columns};
use crate::wait::wait_for;

/// What a table takes in memory, in parts of its text: a word of ten letters takes fifty bytes.
const IN_MEMORY: f64 = 5.0;

/// Reads a results folder: what its table is of, the columns of `labels.csv`, `boundary.csv` and
/// `failures.csv`, its limits as curves, the manifest as JSON, and how far it is where it is not
/// finished.
#[pyfunction]
pub fn _read_results<'py>(
    py: Python<'py>,
    folder: PathBuf,
    memory: Option<&str>,
) -> PyResult<Bound<'py, PyDict>> {
    let size = memory.map(str::parse::<Size>).transpose();
    let limit = Limit::of(size.map_err(refused)?);
    let tables = open(py, &[folder])?.swap_remove(0);
    let found = PyDict::new(py);
    found.set_item("about", about_folder(py, &tables.manifest)?)?;
    let manifest = serde_json::to_string(&tables.manifest).map_err(refused)?;
    found.set_item("manifest", manifest)?;
    let so_far = tables.so_far.map(|so_far| (so_far.done, so_far.of));
    found.set_item("so_far", so_far)?;
    let contents = wait_for(py, move || Contents::of(&tables, &limit))?;
    let contents = contents.map_err(|error| refused(format_args!("{error:#}")))?;
    found.set_item("labels", by_name(py, contents.labels)?)?;
    found.set_item("boundary", by_name(py, contents.boundary)?)?;
    found.set_item("failures", by_name(py, contents.failures)?)?;
    found.set_item("curves", curves(py, contents.curves)?)?;
    Ok(found)
}

/// The tables of a folder.
struct Contents {
    labels: Columns,
    boundary: Columns,
    failures: Columns,
    curves: Vec<Curve>,
}

impl Contents {
    fn of(tables: &ResultTables, limit: &Limit) -> Result<Self> {
        let manifest = &tables.manifest;
        let labels = tables.folder.join("labels.csv");
        refuse_large(&labels, limit)?;
        let boundary = match tables.folder.join("boundary.csv").exists() {
            true => tables.boundary()?,
            // Of a shard, or a run that is not finished.
            false => Boundary::StickSlip(Vec::new()),
        };
        let mut curves = boundary.curves(&manifest.axes, manifest.sweep.units);
        let forward = manifest.forward_contact.as_ref();
        curves.extend(forward.and_then(|it| it.curve(manifest.sweep.units)));
        Ok(Self {
            labels: table(&labels)?,
            boundary: columns_of(&boundary_csv(&boundary)),
            failures: table(&tables.folder.join("failures.csv"))?,
            curves,
        })
    }
}

fn table(path: &Path) -> Result<Columns> {
    let (columns, rows) = typed_rows(path)?;
    typed_columns(&columns, rows)
}

fn refuse_large(labels: &Path, limit: &Limit) -> Result<()> {
    let size = IN_MEMORY * std::fs::metadata(labels)?.len() as f64;
    if size > limit.bytes {
        bail!(
            "the table of {} would take about {} of memory, more than {limit}; to read a part of \
             it, use `sweep export --format parquet`",
            labels.display(),
            Size(size)
        );
    }
    Ok(())
}
