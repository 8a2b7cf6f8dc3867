//! Tables whose rows name their columns.

use anyhow::Result;

/// A table as CSV, of rows that pair each field with its name.
///
/// # Errors
/// Where memory does not take it, or rows have different numbers of fields.
pub fn csv_table(
    rows: impl Iterator<Item = impl AsRef<[(&'static str, String)]>>,
) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for (index, row) in rows.enumerate() {
        let row = row.as_ref();
        if index == 0 {
            writer.write_record(row.iter().map(|(name, _)| name))?;
        }
        writer.write_record(row.iter().map(|(_, field)| field))?;
    }
    Ok(writer.into_inner()?)
}
