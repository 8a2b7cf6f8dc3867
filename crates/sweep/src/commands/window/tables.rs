//! The window as a table, in SI units.

use anyhow::Result;
use campaign::records::Field;

use results::window::{Chart, WINDOW_COLUMNS};

/// Every cell: where it is, how it stands, and what it is not clear of.
///
/// # Errors
/// Where memory does not take it.
pub fn window(chart: &Chart) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(WINDOW_COLUMNS.map(|(name, _)| name))?;
    for row in chart.rows() {
        writer.write_record(row.each_ref().map(Field::to_string))?;
    }
    Ok(writer.into_inner()?)
}
