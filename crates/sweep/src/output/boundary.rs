//! `boundary.csv`: the analytic limit of stick-slip (Eq. 74) for every method,
//! along the torque axis of the design.

use std::path::Path;

use anyhow::{Context, Result};
use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use serde::Deserialize;

use crate::engine::MethodSystem;
use crate::spec::{Axis, Sweep, to_rpm};

/// Points of the line between the ends of the axis.
const POINTS: usize = 200;

/// One point of the limit.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct BoundaryPoint {
    /// Weight on bit, kN; empty where the design varies the torque itself.
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    pub torque_dynamic_nm: f64,
    /// Surface speed below which stick-slip can sustain itself, rpm.
    pub surface_speed_rpm: f64,
    /// The method whose Δ is used.
    pub method: String,
}

impl BoundaryPoint {
    /// The coordinate along an axis.
    pub fn value(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::SurfaceSpeedRpm => Some(self.surface_speed_rpm),
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            Axis::TorqueDynamicNm => Some(self.torque_dynamic_nm),
            Axis::ImpulseRatio | Axis::Friction => None,
        }
    }
}

/// The limit over the range of the design's torque axis; empty without one.
///
/// # Errors
/// Where a rock's table does not reach.
pub fn boundary(sweep: &Sweep, systems: &[MethodSystem]) -> Result<Vec<BoundaryPoint>, String> {
    let axes = sweep.design.axes();
    let torque_axis = axes
        .iter()
        .position(|axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm));
    let (Some(position), Some(bit)) = (torque_axis, &sweep.bit) else {
        return Ok(Vec::new());
    };
    let axis = axes[position];
    let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
    for case in 0..sweep.design.cases() {
        let value = sweep.design.values(case)[position];
        (from, to) = (from.min(value), to.max(value));
    }
    let mut points = Vec::with_capacity(systems.len() * (POINTS + 1));
    for system in systems {
        let Some(taps) = system.driving_point() else {
            continue;
        };
        let undershoot = largest_undershoot(taps);
        for step in 0..=POINTS {
            let value = from + (to - from) * step as f64 / POINTS as f64;
            let conditions = sweep.conditions.with(axis, value);
            let Some(torque) = bit.torque_dynamic(&conditions)? else {
                continue;
            };
            let torques = bit.torques(torque);
            let limit =
                stick_slip_speed_limit(undershoot, torques.torque_static, torques.torque_dynamic);
            points.push(BoundaryPoint {
                weight_on_bit_kn: conditions.weight_on_bit_kn,
                torque_dynamic_nm: torque,
                surface_speed_rpm: to_rpm(limit),
                method: system.method.name().to_owned(),
            });
        }
    }
    Ok(points)
}

/// The whole of `boundary.csv`; numbers spelt as in `labels.csv`.
pub fn write_boundary(points: &[BoundaryPoint]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "weight_on_bit_kn",
        "torque_dynamic_nm",
        "surface_speed_rpm",
        "method",
    ])?;
    for point in points {
        let weight = point.weight_on_bit_kn.map(|weight| weight.to_string());
        writer.write_record([
            weight.unwrap_or_default(),
            point.torque_dynamic_nm.to_string(),
            point.surface_speed_rpm.to_string(),
            point.method.clone(),
        ])?;
    }
    Ok(writer.into_inner()?)
}

/// Reads `boundary.csv` back.
pub fn read_boundary(path: &Path) -> Result<Vec<BoundaryPoint>> {
    let unreadable = || format!("{} cannot be read", path.display());
    csv::Reader::from_path(path)
        .with_context(unreadable)?
        .deserialize()
        .collect::<Result<_, _>>()
        .with_context(unreadable)
}
