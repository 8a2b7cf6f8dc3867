//! Tables whose rows name their columns.

use anyhow::Result;

/// A table as CSV, of rows that pair each field with its name.
///
/// # Errors
/// Where memory does not take it.
pub fn csv_table<const COLUMNS: usize>(
    rows: impl Iterator<Item = [(&'static str, String); COLUMNS]>,
) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (index, row) in rows.enumerate() {
        if index == 0 {
            writer.write_record(row.each_ref().map(|(name, _)| name))?;
        }
        writer.write_record(row.map(|(_, field)| field))?;
    }
    Ok(writer.into_inner()?)
}
