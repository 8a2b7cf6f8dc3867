//! The reference as it is written.

use anyhow::Result;
use sim::{Label, Motion};

use crate::commands::margin::margin_line;
use campaign::printable::printable;
use results::folder::{CaseRows, Manifest};

/// How a reference begins.
pub const BEGINNING: &str = "# Reference of ";

/// The rows of cases, under comments that say where they are from and how far they are from where
/// a label changes: case, method, axes and labels, which alone are compared.
///
/// # Errors
/// Where memory does not take it.
pub fn reference_table(
    manifest: &Manifest,
    cases: &[CaseRows],
    margin: &str,
    counts: &str,
) -> Result<Vec<u8>> {
    let name = printable(&manifest.name).replace(['\n', '\t'], " ");
    let comments = format!(
        "{BEGINNING}{name}, made by `sweep reference`: {counts}. No label of these\n\
         # changes by any method where one axis alone is changed by the margin, up or down.\n{}",
        margin_line(margin)
    );
    let mut writer = csv::Writer::from_writer(comments.into_bytes());
    let mut header = vec!["case".to_owned(), "method".to_owned()];
    header.extend(manifest.axes.iter().map(|axis| axis.name()));
    let cuts = manifest.sweep.has_cutting();
    let motions = Motion::ALL.into_iter();
    let motions: Vec<Motion> = motions.filter(|it| *it != Motion::Axial || cuts).collect();
    header.extend(motions.iter().map(|motion| motion.name().to_owned()));
    writer.write_record(&header)?;
    for row in cases.iter().flat_map(|case| &case.rows) {
        let mut fields = vec![row.case.to_string(), row.method.clone()];
        fields.extend(row.values.iter().map(f64::to_string));
        let label = |motion: &Motion| row.labels[*motion].map_or("", Label::name).to_owned();
        fields.extend(motions.iter().map(label));
        writer.write_record(&fields)?;
    }
    Ok(writer.into_inner()?)
}
