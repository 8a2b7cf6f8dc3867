//! The modes as tables, in SI units.

use anyhow::Result;
use serde::Serialize;

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

/// A surface speed at which a multiple of it meets a mode.
#[derive(Serialize)]
pub struct CriticalSpeed {
    motion: &'static str,
    order: f64,
    mode: usize,
    frequency_hz: f64,
    surface_speed_rpm: f64,
}

/// Every surface speed in the range at which a multiple meets a mode.
pub fn critical(found: &[Modes], excitation: &Excitation) -> Vec<CriticalSpeed> {
    let mut speeds = Vec::new();
    for modes in found {
        for &order in &excitation.orders {
            for (index, &frequency_hz) in modes.frequencies.iter().enumerate() {
                let speed = excitation.critical(order, frequency_hz);
                speeds.extend(speed.map(|surface_speed_rpm| CriticalSpeed {
                    motion: modes.of.name(),
                    order,
                    mode: index + 1,
                    frequency_hz,
                    surface_speed_rpm,
                }));
            }
        }
    }
    speeds
}

/// They as a table.
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
    for speed in critical(found, excitation) {
        writer.write_record([
            speed.motion.to_owned(),
            speed.order.to_string(),
            speed.mode.to_string(),
            speed.frequency_hz.to_string(),
            speed.surface_speed_rpm.to_string(),
        ])?;
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
