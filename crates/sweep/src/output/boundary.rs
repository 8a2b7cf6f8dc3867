//! `boundary.csv`: the analytic limit of a map. For stick-slip that is Eq. 74 for
//! every method, along the torque axis of the design; for whirl the friction
//! below which none is steady.

use std::path::Path;

use anyhow::{Context, Result};
use linear::estimates::{largest_undershoot, stick_slip_speed_limit};
use linear::waves::lateral::BendingNetwork;
use serde::{Deserialize, Serialize};
use sim::steady_backward_whirl;

use crate::engine::MethodSystem;
use crate::spec::{Axis, Bit, LateralSettings, Sweep, to_rpm};

/// Points of the line between the ends of an axis.
const POINTS: usize = 200;

/// The limit of a map.
#[derive(Debug, Clone, PartialEq)]
pub enum Boundary {
    /// Of stick-slip, Eq. 74.
    StickSlip(Vec<StickSlipPoint>),
    /// Of backward whirl.
    Whirl(Vec<WhirlPoint>),
}

/// One point of the limit of stick-slip.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StickSlipPoint {
    /// Weight on bit, kN; empty where the design varies the torque itself.
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    pub torque_dynamic_nm: f64,
    /// Surface speed below which stick-slip can sustain itself, rpm.
    pub surface_speed_rpm: f64,
    /// The method whose Δ is used.
    pub method: String,
}

/// One point of the limit of backward whirl: steady rolling at one site alone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WhirlPoint {
    /// Surface speed, rpm.
    pub surface_speed_rpm: f64,
    /// The least friction that sustains it.
    pub friction: f64,
    /// The site, m from the bit.
    pub site_from_bit_m: f64,
    /// Radius of the centre, mm.
    pub radius_mm: f64,
    /// Rate of precession, against the rotation.
    pub precession_turns_per_s: f64,
    /// Normal force, kN.
    pub normal_force_kn: f64,
}

/// The limit over the range of the design's axes: of whirl where friction is
/// one of them, else of stick-slip; without points where neither applies.
///
/// # Errors
/// Where a rock's table does not reach.
pub fn boundary(sweep: &Sweep, systems: &[MethodSystem]) -> Result<Boundary, String> {
    // Every string has limits of its own.
    if sweep.design.varies_string() {
        return Ok(Boundary::StickSlip(Vec::new()));
    }
    if let (Some(lateral), Some(_)) = (
        &sweep.setting.lateral,
        position(sweep, |axis| axis == Axis::Friction),
    ) {
        return Ok(Boundary::Whirl(whirl_limit(sweep, lateral)));
    }
    let is_torque = |axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    match (&sweep.bit, position(sweep, is_torque)) {
        (Some(bit), Some(position)) => {
            stick_slip_limit(sweep, systems, bit, position).map(Boundary::StickSlip)
        }
        _ => Ok(Boundary::StickSlip(Vec::new())),
    }
}

fn position(sweep: &Sweep, is_wanted: impl Fn(Axis) -> bool) -> Option<usize> {
    sweep.design.axes().iter().position(|&axis| is_wanted(axis))
}

/// Values from the least to the greatest of an axis.
fn along_axis(sweep: &Sweep, position: usize) -> impl Iterator<Item = f64> + use<> {
    let (mut from, mut to) = (f64::INFINITY, f64::NEG_INFINITY);
    for case in 0..sweep.design.cases() {
        let value = sweep.design.values(case)[position];
        (from, to) = (from.min(value), to.max(value));
    }
    (0..=POINTS).map(move |step| from + (to - from) * step as f64 / POINTS as f64)
}

fn stick_slip_limit(
    sweep: &Sweep,
    systems: &[MethodSystem],
    bit: &Bit,
    position: usize,
) -> Result<Vec<StickSlipPoint>, String> {
    let axis = sweep.design.axes()[position];
    let mut points = Vec::with_capacity(systems.len() * (POINTS + 1));
    for system in systems {
        let Some(taps) = system.driving_point() else {
            continue;
        };
        let undershoot = largest_undershoot(taps);
        for value in along_axis(sweep, position) {
            let conditions = sweep.conditions.with(axis, value);
            let Some(torque) = bit.torque_dynamic(&conditions)? else {
                continue;
            };
            let torques = bit.torques(torque);
            let limit =
                stick_slip_speed_limit(undershoot, torques.torque_static, torques.torque_dynamic);
            points.push(StickSlipPoint {
                weight_on_bit_kn: conditions.weight_on_bit_kn,
                torque_dynamic_nm: torque,
                surface_speed_rpm: to_rpm(limit),
                method: system.method.name().to_owned(),
            });
        }
    }
    Ok(points)
}

/// The limit by the exact waves, at every surface speed of the design.
fn whirl_limit(sweep: &Sweep, lateral: &LateralSettings) -> Vec<WhirlPoint> {
    let speeds: Vec<f64> = match position(sweep, |axis| axis == Axis::SurfaceSpeedRpm) {
        Some(position) => along_axis(sweep, position).collect(),
        None => sweep.conditions.surface_speed_rpm.into_iter().collect(),
    };
    let limits = speeds.into_iter();
    limits
        .filter_map(|speed| whirl_bound(sweep, lateral, speed))
        .collect()
}

/// The least friction of steady whirl at a surface speed, at the site where it is
/// least.
pub fn whirl_bound(
    sweep: &Sweep,
    lateral: &LateralSettings,
    surface_speed_rpm: f64,
) -> Option<WhirlPoint> {
    let sites = 0..sweep.setting.sites.len();
    let of_sites = sites.filter_map(|site| whirl_at(sweep, lateral, surface_speed_rpm, site));
    of_sites.min_by(|one, other| one.friction.total_cmp(&other.friction))
}

/// The limit of whirl at one site, the others free.
fn whirl_at(
    sweep: &Sweep,
    lateral: &LateralSettings,
    surface_speed_rpm: f64,
    site: usize,
) -> Option<WhirlPoint> {
    let conditions = sweep
        .conditions
        .with(Axis::SurfaceSpeedRpm, surface_speed_rpm);
    let network = BendingNetwork::new(
        &sweep.setting.string,
        lateral.bending,
        lateral.support,
        &sweep.setting.sites,
    )
    .ok()?;
    let dynamic_stiffness = |rate: f64| {
        let stiffness = network.at_rate(rate)[(site, site)].inv();
        [stiffness.re, stiffness.im]
    };
    let speed = conditions.surface_speed()?;
    let whirl = steady_backward_whirl(&lateral.walls[site], speed, dynamic_stiffness)?;
    Some(WhirlPoint {
        surface_speed_rpm,
        friction: whirl.least_friction,
        site_from_bit_m: sweep.setting.sites.distances_from_bit()[site],
        radius_mm: 1e3 * whirl.radius,
        precession_turns_per_s: whirl.rate / std::f64::consts::TAU,
        normal_force_kn: 1e-3 * whirl.normal_force,
    })
}

/// The whole of `boundary.csv`; numbers spelt as in `labels.csv`.
pub fn write_boundary(boundary: &Boundary) -> Result<Vec<u8>> {
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    match boundary {
        Boundary::StickSlip(points) => {
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
        }
        Boundary::Whirl(points) => {
            writer.write_record([
                "surface_speed_rpm",
                "friction",
                ONLY_OF_WHIRL,
                "radius_mm",
                "precession_turns_per_s",
                "normal_force_kn",
            ])?;
            for point in points {
                let numbers = [
                    point.surface_speed_rpm,
                    point.friction,
                    point.site_from_bit_m,
                    point.radius_mm,
                    point.precession_turns_per_s,
                    point.normal_force_kn,
                ];
                writer.write_record(numbers.map(|number| number.to_string()))?;
            }
        }
    }
    Ok(writer.into_inner()?)
}

/// A column that only the limit of whirl has.
const ONLY_OF_WHIRL: &str = "site_from_bit_m";

/// Reads `boundary.csv` back.
pub fn read_boundary(path: &Path) -> Result<Boundary> {
    let read = || -> csv::Result<Boundary> {
        let mut reader = csv::Reader::from_path(path)?;
        let is_whirl = reader.headers()?.iter().any(|name| name == ONLY_OF_WHIRL);
        Ok(if is_whirl {
            Boundary::Whirl(reader.deserialize().collect::<Result<_, _>>()?)
        } else {
            Boundary::StickSlip(reader.deserialize().collect::<Result<_, _>>()?)
        })
    };
    read().with_context(|| format!("{} cannot be read", path.display()))
}
