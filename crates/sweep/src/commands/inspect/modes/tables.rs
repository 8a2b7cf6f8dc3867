//! The modes as tables, in SI units.

use anyhow::Result;

use super::found::Modes;
use super::speeds::Excitation;
use crate::commands::csv_table::csv_table;

/// Every mode that was found.
///
/// # Errors
/// Where memory does not take it.
pub fn modes(found: &[Modes]) -> Result<Vec<u8>> {
    let rows = found.iter().flat_map(|modes| {
        let damped = modes.frequencies.iter().zip(&modes.damping).enumerate();
        damped.map(|(index, (frequency, damping))| {
            [
                ("motion", modes.of.name().to_owned()),
                ("mode", (index + 1).to_string()),
                ("frequency_hz", frequency.to_string()),
                (
                    "damping_ratio",
                    damping.map_or_else(String::new, |it| it.to_string()),
                ),
            ]
        })
    });
    csv_table(rows)
}

/// Every surface speed in the range at which a multiple meets a mode.
///
/// # Errors
/// Where memory does not take it.
pub fn critical_speeds(found: &[Modes], excitation: &Excitation) -> Result<Vec<u8>> {
    let header = [
        "motion",
        "order",
        "mode",
        "frequency_hz",
        "surface_speed_rpm",
    ];
    let mut writer = csv::Writer::from_writer(Vec::new());
    // There may be none.
    writer.write_record(header)?;
    for modes in found {
        for &order in &excitation.orders {
            for (index, &frequency) in modes.frequencies.iter().enumerate() {
                if let Some(speed) = excitation.critical(order, frequency) {
                    writer.write_record([
                        modes.of.name().to_owned(),
                        order.to_string(),
                        (index + 1).to_string(),
                        frequency.to_string(),
                        speed.to_string(),
                    ])?;
                }
            }
        }
    }
    Ok(writer.into_inner()?)
}

/// The shapes of the lowest modes.
///
/// # Errors
/// Where memory does not take it.
pub fn shapes(found: &[Modes]) -> Result<Vec<u8>> {
    let rows = found.iter().flat_map(|modes| {
        modes
            .shapes
            .iter()
            .enumerate()
            .flat_map(move |(index, shape)| {
                let along = shape.depths.iter().zip(&shape.amplitudes);
                along.map(move |(depth, amplitude)| {
                    [
                        ("motion", modes.of.name().to_owned()),
                        ("mode", (index + 1).to_string()),
                        ("depth_m", depth.to_string()),
                        ("amplitude", amplitude.to_string()),
                    ]
                })
            })
    });
    csv_table(rows)
}
