//! The window as a table, in SI units.

use anyhow::Result;

use crate::commands::csv_table::csv_table;
use results::window::{Chart, Standing};

/// Every cell: where it is, how it stands, and what it is not clear of.
///
/// # Errors
/// Where memory does not take it.
pub fn window(chart: &Chart) -> Result<Vec<u8>> {
    let rows = chart.cells().map(|cell| {
        let [[weight, to_weight], [speed, to_speed]] = chart.ends(cell);
        [
            ("weight_on_bit_kn_from", weight.to_string()),
            ("weight_on_bit_kn_to", to_weight.to_string()),
            ("surface_speed_rpm_from", speed.to_string()),
            ("surface_speed_rpm_to", to_speed.to_string()),
            ("standing", chart.standing(cell).key().to_owned()),
            ("limits", chart.worse_than(Standing::Clear, cell).join("; ")),
        ]
    });
    csv_table(rows)
}
