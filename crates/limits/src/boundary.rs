//! `boundary.csv`: the analytic lines of a map. For stick-slip that is the one-slip estimate, Eq. 74, for
//! every method, along the torque axis of the design; for whirl the friction that
//! sustains it steadily at each site.

use std::path::Path;

use anyhow::{Context, Result};
use linear::DrillstringError;
use linear::deviation::exact_undershoot;
use linear::estimates::largest_undershoot;
use linear::falling_torque::{highest_frequency, steepest_fall};

use crate::axes::{position, range_of_axis};
use crate::lying_limit::{LyingLimit, LyingPoint, lying_points};
use crate::many_sites_limit::many_sites_limit;
use crate::motor_stall::motor_stall_points;
use crate::sliding_together::sliding_together;
use crate::steady_drilling::steady_drilling_points;
use crate::torsion_limit::{StickSlipPoint, TorsionLimit, WAVES};
use crate::whirl_limit::{WhirlPoint, whirl_limit};
use campaign::engine::{MethodSystem, stick_slip_limit};
use campaign::plan::{Bit, LateralSettings, Sweep, TorqueError};
use campaign::quantities::{Axis, WallQuantity};
use campaign::records::to_rpm;
use campaign::text_file::unreadable;

/// Points of the line between the ends of an axis.
const POINTS: usize = 200;

/// The limit of a map.
#[derive(Debug, Clone, PartialEq)]
pub enum Boundary {
    /// Of stick-slip, Eq. 74.
    StickSlip(Vec<StickSlipPoint>),
    /// Of backward whirl.
    Whirl(Vec<WhirlPoint>),
    /// Of a string that lies in its hole, or buckles under the weight on bit.
    Lying(Vec<LyingPoint>),
}

/// Why the limit of a map is not known.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BoundaryError {
    /// A rock has no torque at a weight.
    #[error("{0}")]
    Rock(TorqueError),
    /// A site is not on the string.
    #[error(transparent)]
    Site(#[from] DrillstringError),
}

/// The limit over the range of the design's axes: of whirl where friction at every site is
/// one of them, or of a string that lies in its hole; else of stick-slip; without points where
/// neither applies, below a motor or a drive whose torque is limited, which have no such limit in
/// closed form unless the bit cuts, or where other axes give each case its own. Below a motor the
/// weight or torque at which that stalls comes with them, but for limits of whirl.
///
/// # Errors
/// Where a rock's table does not reach, or a site is not on the string.
pub fn boundary(sweep: &Sweep, systems: &[MethodSystem]) -> Result<Boundary, BoundaryError> {
    let axes = sweep.design.axes();
    let has_friction = position(sweep, |axis| axis == Axis::FRICTION).is_some();
    // Its weight on bit changes the string.
    let is_of_wall = has_friction || sweep.bit.is_none() || !is_one_limit(sweep);
    let lies = sweep.setting.lying.is_some() && is_of_wall;
    let is_pushed = position(sweep, |axis| axis == Axis::WeightOnBitKn).is_some();
    if lies || (is_pushed && sweep.setting.hanging.is_some() && !has_friction) {
        let mut points = lying_points(sweep);
        points.extend(
            motor_stall_points(sweep)
                .into_iter()
                .map(|point| LyingPoint {
                    limit: LyingLimit::MotorStall,
                    swing: None,
                    friction: None,
                    weight_on_bit_kn: point.weight_on_bit_kn,
                    surface_speed_rpm: Some(point.surface_speed_rpm),
                }),
        );
        return Ok(Boundary::Lying(points));
    }
    if !is_one_limit(sweep) {
        return Ok(Boundary::StickSlip(motor_stall_points(sweep)));
    }
    if let (Some(lateral), true) = (sweep.setting.whirling_with_string(), has_friction) {
        // So has every wall.
        let is_one = !axes.iter().any(|axis| axis.changes_whirl_limit());
        let points = match speeds_of(sweep).filter(|_| is_one) {
            Some(range) => whirl_points(sweep, lateral, range)?,
            None => Vec::new(),
        };
        return Ok(Boundary::Whirl(points));
    }
    if let (Some(bit), Some(_)) = (&sweep.bit, &sweep.setting.cutting) {
        let rubs = sweep.setting.friction.is_some();
        let mut points = match rubs {
            false => steady_drilling_points(sweep, bit),
            // Friction along the string is not linear.
            true => Vec::new(),
        };
        points.extend(motor_stall_points(sweep));
        return Ok(Boundary::StickSlip(points));
    }
    let is_torque = |axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm);
    let has_limit = sweep.setting.has_stick_slip_limit();
    match (&sweep.bit, position(sweep, is_torque).filter(|_| has_limit)) {
        (Some(bit), Some(position)) => {
            limit_of_methods(sweep, systems, bit, position).map(Boundary::StickSlip)
        }
        _ => Ok(Boundary::StickSlip(motor_stall_points(sweep))),
    }
}

/// Whether all cases have the same: every string and every law of the bit has its own.
fn is_one_limit(sweep: &Sweep) -> bool {
    let mut axes = sweep.design.axes().iter();
    !sweep.design.varies_string() && !axes.any(|axis| axis.changes_bit())
}

/// Values from the least to the greatest of an axis.
fn along_axis(sweep: &Sweep, position: usize) -> impl Iterator<Item = f64> + use<> {
    between(range_of_axis(sweep, position))
}

fn between([from, to]: [f64; 2]) -> impl Iterator<Item = f64> + use<> {
    // Rounding would miss the end.
    let inner = (0..POINTS).map(move |step| from + (to - from) * step as f64 / POINTS as f64);
    inner.chain([to])
}

fn limit_of_methods(
    sweep: &Sweep,
    systems: &[MethodSystem],
    bit: &Bit,
    position: usize,
) -> Result<Vec<StickSlipPoint>, BoundaryError> {
    let axis = sweep.design.axes()[position];
    let mut points = Vec::with_capacity(systems.len() * (POINTS + 1));
    for system in systems {
        let Some(taps) = system.driving_point() else {
            continue;
        };
        let front = (system.method.name(), largest_undershoot(taps));
        let values = along_axis(sweep, position);
        points.extend(stick_slip_points(sweep, bit, (axis, values), front)?);
    }
    if sweep.setting.friction.is_none() {
        points.extend(smooth_rotation_points(sweep, bit, position));
    }
    Ok(points)
}

/// Eq. 74 at values of an axis, by a method and its undershoot Δ, rad/s per N m.
fn stick_slip_points(
    sweep: &Sweep,
    bit: &Bit,
    (axis, values): (Axis, impl Iterator<Item = f64>),
    (method, undershoot): (&str, f64),
) -> Result<Vec<StickSlipPoint>, BoundaryError> {
    let conditions = &sweep.conditions;
    let points = stick_slip_limit((bit, conditions), (axis, values), undershoot)
        .map_err(BoundaryError::Rock)?;
    let points = points.into_iter().map(|point| StickSlipPoint {
        weight_on_bit_kn: point.weight_on_bit_kn,
        torque_dynamic_nm: point.torque_dynamic_nm,
        surface_speed_rpm: point.surface_speed_rpm,
        method: method.to_owned(),
        limit: TorsionLimit::StickSlip,
    });
    Ok(points.collect())
}

/// Where smooth rotation is lost along an axis, for a torque that falls with the bit's speed: the
/// speed at which it falls as steeply as the string bears ([`steepest_fall`]) without swinging in one
/// of the modes up to [`highest_frequency`]. Without points where it lasts at every speed.
fn smooth_rotation_points(sweep: &Sweep, bit: &Bit, position: usize) -> Vec<StickSlipPoint> {
    let string = &sweep.setting.string;
    let steepest = steepest_fall(string, highest_frequency(string));
    let Some(steepest) = steepest.ok().flatten() else {
        return Vec::new();
    };
    let axis = sweep.design.axes()[position];
    let at = |value| {
        let conditions = sweep.conditions.with(axis, value);
        let torque_dynamic_nm = bit.torque_dynamic(&conditions).ok()??;
        let law = conditions.torques(torque_dynamic_nm);
        let speed = law.speed_of_fall(steepest)?;
        Some(StickSlipPoint {
            weight_on_bit_kn: conditions.weight_on_bit_kn,
            torque_dynamic_nm,
            surface_speed_rpm: to_rpm(speed),
            method: WAVES.to_owned(),
            limit: TorsionLimit::SmoothRotation,
        })
    };
    along_axis(sweep, position).filter_map(at).collect()
}

/// Eq. 74 between two weights on bit (kN) by the undershoot of the string as it is, whose fronts
/// no step smears; without points where the cases have no one limit, or where that undershoot
/// would take too much memory.
///
/// # Errors
/// Where a rock's table does not reach.
pub fn exact_stick_slip_limit(sweep: &Sweep, weights: [f64; 2]) -> Result<Boundary, BoundaryError> {
    let is_one = sweep.setting.has_stick_slip_limit() && is_one_limit(sweep);
    let undershoot = exact_undershoot(&sweep.setting.string).ok();
    let points = match (&sweep.bit, undershoot.filter(|_| is_one)) {
        (Some(bit), Some(undershoot)) => {
            let values = between(weights);
            stick_slip_points(
                sweep,
                bit,
                (Axis::WeightOnBitKn, values),
                ("the exact undershoot", undershoot),
            )?
        }
        _ => Vec::new(),
    };
    Ok(Boundary::StickSlip(points))
}

/// The limit of whirl between two surface speeds (rpm), of the string and the walls as the sweep
/// file has them, for any design; without points where it has no wall, or a bit there below a motor.
///
/// # Errors
/// Where a site is not on the string.
pub fn whirl_boundary(sweep: &Sweep, range: [f64; 2]) -> Result<Boundary, BoundaryError> {
    let points = match sweep.setting.whirling_with_string() {
        Some(lateral) => whirl_points(sweep, lateral, range)?,
        None => Vec::new(),
    };
    Ok(Boundary::Whirl(points))
}

/// All surface speeds of the design, from the least to the greatest.
fn speeds_of(sweep: &Sweep) -> Option<[f64; 2]> {
    match position(sweep, |axis| axis == Axis::SurfaceSpeedRpm) {
        Some(position) => Some(range_of_axis(sweep, position)),
        None => sweep.conditions.surface_speed_rpm.map(|speed| [speed; 2]),
    }
}

/// The limit of whirl between two surface speeds.
fn whirl_points(
    sweep: &Sweep,
    lateral: &LateralSettings,
    range: [f64; 2],
) -> Result<Vec<WhirlPoint>, DrillstringError> {
    let mut points = whirl_limit(&sweep.setting, lateral, range)?;
    if lateral.finding.is_some() {
        // Each case touches at others too.
        return Ok(points);
    }
    points.extend(many_sites_limit(&sweep.setting, lateral, range)?);
    // What slides has less friction than the axis says where that falls.
    let falls = |axis| {
        use WallQuantity::DynamicRatio as Ratio;
        matches!(
            axis,
            Axis::Wall(Ratio)
                | Axis::WallAtSite {
                    quantity: Ratio,
                    ..
                }
        )
    };
    if position(sweep, falls).is_none() {
        points.extend(sliding_together(&sweep.setting, lateral, range)?);
    }
    Ok(points)
}

/// The whole of `boundary.csv`; numbers spelt as in `labels.csv`. No field needs quotes:
/// they are names and numbers.
pub fn boundary_csv(boundary: &Boundary) -> String {
    match boundary {
        Boundary::StickSlip(points) => {
            let header = "weight_on_bit_kn,torque_dynamic_nm,surface_speed_rpm,method,limit\n";
            let row = |point: &StickSlipPoint| {
                let weight = point.weight_on_bit_kn.map(|weight| weight.to_string());
                format!(
                    "{},{},{},{},{}\n",
                    weight.unwrap_or_default(),
                    point.torque_dynamic_nm,
                    point.surface_speed_rpm,
                    point.method,
                    point.limit.name()
                )
            };
            header.to_owned() + &points.iter().map(row).collect::<String>()
        }
        Boundary::Whirl(points) => {
            let header = format!(
                "surface_speed_rpm,friction,{ONLY_OF_WHIRL},radius_mm,precession_turns_per_s,\
                 normal_force_kn,branch,motion,least,sites_from_bit_m\n"
            );
            let known = |number: Option<f64>| number.map_or(String::new(), |it| it.to_string());
            let row = |point: &WhirlPoint| {
                let branch = point.branch.map(|branch| branch.to_string());
                let sites: Vec<_> = (point.sites_from_bit_m.iter())
                    .map(f64::to_string)
                    .collect();
                format!(
                    "{},{},{},{},{},{},{},{},{},{}\n",
                    point.surface_speed_rpm,
                    point.friction,
                    point.site_from_bit_m,
                    known(point.radius_mm),
                    point.precession_turns_per_s,
                    known(point.normal_force_kn),
                    branch.unwrap_or_default(),
                    point.motion.name(),
                    point.least,
                    sites.join(";")
                )
            };
            header + &points.iter().map(row).collect::<String>()
        }
        Boundary::Lying(points) => {
            let header =
                format!("limit,{ONLY_OF_LYING},friction,weight_on_bit_kn,surface_speed_rpm\n");
            let known = |number: Option<f64>| number.map_or(String::new(), |it| it.to_string());
            let row = |point: &LyingPoint| {
                let swing = point.swing.map(|swing| swing.to_string());
                format!(
                    "{},{},{},{},{}\n",
                    point.limit.name(),
                    swing.unwrap_or_default(),
                    known(point.friction),
                    known(point.weight_on_bit_kn),
                    known(point.surface_speed_rpm)
                )
            };
            header + &points.iter().map(row).collect::<String>()
        }
    }
}

/// A column that only the limit of whirl has,
const ONLY_OF_WHIRL: &str = "site_from_bit_m";

/// and one that only limits of a string that lies have.
const ONLY_OF_LYING: &str = "swing";

/// Reads `boundary.csv` back.
pub fn read_boundary(path: &Path) -> Result<Boundary> {
    let read = || -> csv::Result<Boundary> {
        let mut reader = csv::Reader::from_path(path)?;
        let headers = reader.headers()?.clone();
        let has = |column: &str| headers.iter().any(|name| name == column);
        Ok(if has(ONLY_OF_WHIRL) {
            Boundary::Whirl(reader.deserialize().collect::<Result<_, _>>()?)
        } else if has(ONLY_OF_LYING) {
            Boundary::Lying(reader.deserialize().collect::<Result<_, _>>()?)
        } else {
            Boundary::StickSlip(reader.deserialize().collect::<Result<_, _>>()?)
        })
    };
    read().with_context(|| unreadable(path))
}

#[cfg(test)]
mod tests {
    use linear::estimates::torsional_travel_time;
    use linear::falling_torque::{Resonance, resonances};

    use super::*;
    use crate::whirl_limit::WhirlMotion;

    fn read(table: &str) -> Boundary {
        let file = tempfile::NamedTempFile::new().expect("a file");
        std::fs::write(file.path(), table).expect("written");
        read_boundary(file.path()).expect("a boundary")
    }

    #[test]
    fn a_table_is_read_back_as_it_was_written() {
        let boundary = read(
            "surface_speed_rpm,friction,site_from_bit_m,radius_mm,precession_turns_per_s,\
             normal_force_kn,branch,motion,least,sites_from_bit_m\n\
             60,1.5,0,16,9,34,0,rolling,true,0\n\
             60,1.2,0,16,9,34,,rolling_or_sliding,true,0\n\
             60,0.2,50,,8,,,any_sites,true,0;50\n\
             60,0.4,50,,6,,,sliding_together,true,0;50\n",
        );
        let Boundary::Whirl(points) = &boundary else {
            panic!("{boundary:?}");
        };
        assert_eq!(points[2].sites_from_bit_m, [0.0, 50.0]);
        assert_eq!(read(&boundary_csv(&boundary)), boundary);
        let boundary = read(
            "limit,swing,friction,weight_on_bit_kn,surface_speed_rpm\n\
             buckling,,,302.5,\n\
             swing,0,0.3,,93.4\n\
             rolls_all_round,,0.3,,90.5\n",
        );
        let Boundary::Lying(points) = &boundary else {
            panic!("{boundary:?}");
        };
        assert_eq!((points[1].swing, points[2].swing), (Some(0), None));
        assert_eq!(read(&boundary_csv(&boundary)), boundary);
    }

    #[test]
    fn a_table_without_branches_is_one_line() {
        let boundary = read(
            "surface_speed_rpm,friction,site_from_bit_m,radius_mm,precession_turns_per_s,\
             normal_force_kn\n60,1.14,0,16,9,34\n",
        );
        let Boundary::Whirl(points) = &boundary else {
            panic!("{boundary:?}");
        };
        assert_eq!(
            (points[0].motion, points[0].least),
            (WhirlMotion::Rolling, true)
        );
    }

    /// Drillpipe above collars, with torque that falls with the bit's speed.
    fn falling(loss: &str) -> Sweep {
        let text = format!(
            r#"
            surface_speed_rpm = 100
            methods = ["quadrature"]
            [string]
            shear_modulus_gpa = 80
            density_kg_m3 = 7840
            torsional_damping_nms_rad_m = 0.3
            {loss}
            [[string.sections]]
            name = "drillpipe"
            repeat = 200
            parts = [{{ length_m = 9, inner_radius_m = 0.054, outer_radius_m = 0.0635 }}]
            [[string.sections]]
            name = "collars"
            repeat = 3
            parts = [{{ length_m = 9, inner_radius_m = 0.035, outer_radius_m = 0.0825 }}]
            [bit]
            rock = "sandstone"
            torque_static_ratio = 1.5
            torque_decay_rpm = 40
            [design]
            kind = "grid"
            [design.axes]
            weight_on_bit_kn = {{ from = 50, to = 200, count = 4 }}
            "#
        );
        Sweep::read_from(Path::new("sweep.toml"), &[], &|_, _| Ok(text.clone())).unwrap()
    }

    /// There the law of the bit, by its differences, is as steep as the least that a resonance bears:
    /// of all up to 1 kHz where the material has loss, of the slow ones by one constant alone.
    #[test]
    fn smooth_rotation_is_lost_where_the_torque_falls_as_the_weakest_resonance_bears() {
        let mut weakest_at = Vec::new();
        for (loss, has_loss) in [("loss_factor = 0.0001", true), ("", false)] {
            let sweep = falling(loss);
            let (string, bit) = (&sweep.setting.string, sweep.bit.as_ref().unwrap());
            let highest = match has_loss {
                true => 1000.0,
                false => 12.0 / torsional_travel_time(string),
            };
            let all = resonances(string, highest).unwrap();
            let falls = |one: &&Resonance, other: &&Resonance| {
                one.steepest_fall().total_cmp(&other.steepest_fall())
            };
            let weakest = all.iter().min_by(falls).unwrap();
            weakest_at.push(weakest.frequency);
            let points = smooth_rotation_points(&sweep, bit, 0);
            assert_eq!(points.len(), POINTS + 1);
            for point in points.iter().step_by(50) {
                let law = sweep.conditions.torques(point.torque_dynamic_nm);
                let speed = point.surface_speed_rpm * std::f64::consts::PI / 30.0;
                let step = 1e-4 * speed;
                let [slower, faster] = [speed - step, speed + step].map(|it| law.torque_at(it));
                let fall = (slower - faster).abs() / (2.0 * step);
                let expected = weakest.steepest_fall();
                assert!((fall / expected - 1.0).abs() < 1e-3, "{fall} {expected}");
            }
        }
        // Else the two would not differ.
        let [with_loss, by_constant] = weakest_at[..] else {
            panic!("{weakest_at:?}");
        };
        assert!(with_loss > 30.0 && by_constant < 20.0, "{weakest_at:?}");
    }
}
