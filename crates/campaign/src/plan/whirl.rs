//! Sampling frequencies that do not damp whirl away.
//!
//! A method takes from a site that whirls some of its energy in every turn, the more the fewer steps a turn
//! has. So each has a number of steps that a turn needs; the rate follows from wall, speed and string.

use std::f64::consts::TAU;

use linear::estimates::bending_wave_stiffness;
use linear::{Drillstring, Sites};
use sim::MudMotor;
use sim::steady_whirl::expected_rate;

use super::conditions::Conditions;
use super::lateral::LateralSettings;
use super::wall::WallSettings;
use crate::design::Design;
use crate::quantities::{Axis, WallQuantity};

/// Whirl in fast contact, for which no default frequency is raised further, Hz: rigid walls, and those of
/// little clearance, ask for more than can be stepped.
pub(super) const MOST_HZ: f64 = 10_240.0;

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
