//! Sampling frequencies that do not damp whirl away.
//!
//! A method takes from a site that whirls some of its energy in every turn, the more the fewer steps a turn
//! has. So each has a number of steps that a turn needs; the rate follows from wall, speed and string.

use std::borrow::Cow;
use std::f64::consts::TAU;

use linear::estimates::bending_wave_stiffness;
use linear::{Drillstring, Method, Sites};
use sim::MudMotor;
use sim::steady_whirl::expected_rate;

use super::conditions::Conditions;
use super::lateral::LateralSettings;
use super::setting::Setting;
use super::sweep::Sweep;
use super::wall::WallSettings;
use crate::design::Design;
use crate::quantities::{Axis, WallQuantity};
use crate::sweep_file::AutoOr;
use crate::words::short;

/// Whirl in fast contact, for which no default frequency is raised further, Hz: rigid walls, and those of
/// little clearance, ask for more than can be stepped.
const MOST_HZ: f64 = 10_240.0;

/// Steps that a turn of whirl needs by a method of a name. With 8, 24 and 32 the force of whirl on one site
/// is right to 5 %, of 806 held to the balance of rolling; the rate to expect is an eighth above the one
/// that lasts, and more.
pub fn steps_of_turn(method: &str) -> f64 {
    match method {
        "finite-element" => 21.0,
        "quadrature" | "trapezoidal" => 28.0,
        _ => 7.0,
    }
}

/// The greatest rate of whirl to expect in any case of a design, turns a second; 0 where nothing turns.
pub(super) fn greatest_rate(
    (string, sites, lateral): (&Drillstring, &Sites, &LateralSettings),
    motor: Option<MudMotor>,
    (conditions, design): (&Conditions, &Design),
) -> f64 {
    let conditions = fastest(conditions, design);
    let surface = conditions.surface_speed().unwrap_or_default();
    let rate = |(site, wall): (usize, &WallSettings)| {
        let distance = sites.distances_from_bit()[site];
        let at_motor = motor.filter(|_| sites.bit_site() == Some(site));
        let speed = surface + at_motor.map_or(0.0, |motor| motor.speed);
        // Friction plays no part.
        let wall = wall.in_case(&conditions).with_friction(0.0);
        expected_rate(&wall, speed, |rate| {
            bending_wave_stiffness(string, &lateral.bending, distance, rate)
        })
    };
    lateral
        .walls
        .iter()
        .enumerate()
        .map(rate)
        .fold(0.0, f64::max)
        / TAU
}

/// The conditions of a design under which whirl is fastest.
fn fastest(conditions: &Conditions, design: &Design) -> Conditions {
    let mut fastest = conditions.clone();
    for &axis in design.axes() {
        let quantity = match axis {
            Axis::Wall(quantity) | Axis::WallAtSite { quantity, .. } => Some(quantity),
            _ => None,
        };
        let Some([least, most]) = design.ends(axis) else {
            continue;
        };
        match (axis, quantity) {
            (_, Some(WallQuantity::Clearance)) => fastest = fastest.with(axis, least),
            (Axis::SurfaceSpeedRpm, _) | (_, Some(WallQuantity::Stiffness)) => {
                fastest = fastest.with(axis, most);
            }
            _ => {}
        }
    }
    fastest
}

impl Setting {
    /// The sampling frequency of a method, Hz: that of all, or more where the file gives none and whirl needs it.
    pub fn frequency_by(&self, method: &Method) -> f64 {
        let rate = self.whirl_rate.filter(|_| self.steps_per_travel.is_some());
        let needed = rate.map_or(0.0, |rate| {
            (steps_of_turn(method.name()) * rate).min(MOST_HZ)
        });
        self.sampling_frequency.max(needed)
    }

    /// The setting as a method is sampled.
    pub fn by(&self, method: &Method) -> Cow<'_, Self> {
        let frequency = self.frequency_by(method);
        match frequency > self.sampling_frequency {
            true => Cow::Owned(self.sampled_at(frequency)),
            false => Cow::Borrowed(self),
        }
    }

    /// Steps in a turn of the fastest whirl to expect, as a method is sampled; `None` where there is none.
    pub fn steps_of_whirl(&self, method: &Method) -> Option<f64> {
        let rate = self.whirl_rate.filter(|rate| *rate > 0.0)?;
        Some(self.frequency_by(method) / rate)
    }
}

impl Sweep {
    /// Methods that damp the fastest whirl to expect.
    pub(super) fn doubts_about_whirl(&self) -> Option<String> {
        let setting = &self.setting;
        let too_coarse = |method: &Method| {
            let (steps, needed) = (
                setting.steps_of_whirl(method)?,
                steps_of_turn(method.name()),
            );
            (steps < needed * (1.0 - 1e-9)).then(|| {
                let frequency = short(setting.frequency_by(method));
                format!(
                    "{} at {frequency} Hz has {steps:.1} of {needed}",
                    method.name()
                )
            })
        };
        let methods: Vec<String> = self.methods.iter().filter_map(too_coarse).collect();
        let remedy = match (self.content.accuracy, self.content.sampling_frequency_hz) {
            (Some(_), _) => "give `methods` in place of `accuracy`",
            (None, AutoOr::Given(_)) => "leave `sampling_frequency_hz` out, or raise it",
            (None, AutoOr::Auto) => "give the wall the stiffness of rock, or more clearance",
        };
        (!methods.is_empty()).then(|| {
            format!(
                "whirl at up to {:.0} turns/s is to be expected at the walls, and of the steps that a turn needs {}: \
                 whirl that lasts may be missed, and its force is too small; {remedy}",
                setting.whirl_rate.unwrap_or_default(),
                methods.join(", "),
            )
        })
    }
}
