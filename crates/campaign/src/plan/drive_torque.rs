//! The torque that a top drive has to give, held against what it can: unless it is said to saturate,
//! the model's drive gives any torque that its controller asks for.

use linear::estimates::{torsional_inertia, torsional_resistance};
use sim::SurfaceProfile;

use super::conditions::Conditions;
use super::sweep::Sweep;
use crate::quantities::Axis;
use crate::sweep_file::StartName;
use crate::words::short;

/// What the strongest top drives give, N m, where a file does not say.
const STRONGEST: f64 = 100e3;

impl Sweep {
    /// What is doubtful about the torque of the top drive at the ends of the design.
    pub(super) fn doubts_about_drive(&self) -> Vec<String> {
        if self.setting.string.top_drive().is_none() {
            return Vec::new();
        }
        let conditions = self.ends_of_torque();
        [
            self.start_is_doubtful(&conditions),
            self.rotation_is_doubtful(&conditions),
            self.hold_is_doubtful(&conditions),
        ]
        .into_iter()
        .flatten()
        .collect()
    }

    /// Conditions with what decides the drive's torque at the ends of its range.
    fn ends_of_torque(&self) -> Vec<Conditions> {
        let deciding = [
            Axis::SurfaceSpeedRpm,
            Axis::WeightOnBitKn,
            Axis::TorqueDynamicNm,
        ];
        let axes = (deciding.into_iter()).filter(|axis| self.design.axes().contains(axis));
        axes.fold(vec![self.conditions.clone()], |conditions, axis| {
            let Some(ends) = self.design.ends(axis) else {
                return conditions;
            };
            let at_ends = |one: Conditions| ends.map(|end| one.with(axis, end));
            conditions.into_iter().flat_map(at_ends).collect()
        })
    }

    /// Of a start from rest.
    fn start_is_doubtful(&self, ends: &[Conditions]) -> Option<String> {
        let SurfaceProfile::Rise(rise) = self.setting.profile else {
            return None;
        };
        if self.starts.name != StartName::Ramp || self.setting.drive_limit.is_some() {
            return None;
        }
        let speeds = ends.iter().filter_map(Conditions::surface_speed);
        let torque = self.start_torque(speeds.map(f64::abs).fold(0.0, f64::max), rise);
        let limit = self.torque_limit().unwrap_or(STRONGEST);
        let what_has = match self.torque_limit() {
            Some(_) => "`top_drive.torque_limit_kn_m` allows",
            None => "the strongest drives give",
        };
        let text = format!(
            "at the start the top drive gives up to {}, more than the {} that {what_has}: let the \
             speed rise over `surface_speed_rise_s`, or begin cases without it (`start`)",
            self.in_units(torque),
            self.in_units(limit)
        );
        (torque > limit).then_some(text)
    }

    /// Of steady rotation, where the file says what the drive can give.
    fn rotation_is_doubtful(&self, ends: &[Conditions]) -> Option<String> {
        let limit = self.torque_limit()?;
        let string = &self.setting.string;
        let torque = |conditions: &Conditions| {
            let speed = conditions.surface_speed()?.abs();
            let on_bit = match &self.bit {
                Some(bit) => bit.torque_dynamic(conditions).ok()??,
                None => 0.0,
            };
            Some(on_bit + torsional_resistance(string) * speed)
        };
        let torque = ends.iter().filter_map(torque).fold(0.0, f64::max);
        let what_follows = match self.setting.drive_limit {
            None => "the drive of the model gives it, one of that limit would stall",
            Some(_) => "there the string turns more slowly than it is set to, or stalls",
        };
        let text = format!(
            "steady rotation takes up to {}, more than the {} of `top_drive.torque_limit_kn_m`: \
             {what_follows}",
            self.in_units(torque),
            self.in_units(limit)
        );
        (torque > limit).then_some(text)
    }

    /// Of a start with the bit held by more than a drive of limited torque winds up.
    fn hold_is_doubtful(&self, ends: &[Conditions]) -> Option<String> {
        let limit = self.setting.drive_limit?;
        if !matches!(self.starts.name, StartName::Stuck | StartName::Both) {
            return None;
        }
        let torque = |conditions: &Conditions| {
            let dynamic = self.bit.as_ref()?.torque_dynamic(conditions).ok()??;
            Some(conditions.torques(dynamic).torque_static)
        };
        let torque = ends.iter().filter_map(torque).fold(0.0, f64::max);
        let text = format!(
            "cases begin with the bit held by up to {}, more than the {} of \
             `top_drive.torque_limit_kn_m`: they say whether stick-slip lasts, but only a rotor that swings \
             winds the string up so far; `start = \"ramp\"` says whether that breaks the bit loose",
            self.in_units(torque),
            self.in_units(limit)
        );
        (torque > limit).then_some(text)
    }

    /// About the greatest torque of the motor (N m) while the surface reaches a speed (rad/s) over
    /// a rise (s): what accelerates drive and string, but no more than the controller asks
    /// for at its largest error.
    fn start_torque(&self, speed: f64, rise: f64) -> f64 {
        let string = &self.setting.string;
        let Some(drive) = string.top_drive() else {
            return 0.0;
        };
        let at_once = drive.proportional_gain * speed;
        let accelerates = (drive.inertia + torsional_inertia(string)) * speed / rise;
        at_once.min(accelerates)
    }

    /// N m.
    fn torque_limit(&self) -> Option<f64> {
        Some(1e3 * self.content.top_drive.as_ref()?.torque_limit_kn_m?)
    }

    fn in_units(&self, torque: f64) -> String {
        let unit = Axis::TorqueDynamicNm.unit(self.content.units);
        format!("{} {}", short(unit.number(torque).round()), unit.name)
    }
}
