//! The mud motor between string and bit: its chart, and where it stalls.

use serde::Serialize;

use super::rows::row;
use campaign::plan::Sweep;
use campaign::quantities::{Axis, FORCE, INERTIA, TORQUE, Units};
use campaign::records::to_rpm;
use campaign::words::short;
use limits::motor_stalls;

/// A mud motor in numbers.
#[derive(Serialize)]
pub struct InspectedMotor {
    /// Of the rotor against its housing.
    speed_without_load_rpm: f64,
    speed_about_to_stall_rpm: f64,
    stall_torque_kn_m: f64,
    rotor_inertia_kg_m2: f64,
    /// The weights on bit from which on it stalls, the least and the greatest over the surface speeds
    /// of the design; none where it stalls at none that the rock knows, or at a torque that no
    /// weight gives.
    stalls_from_kn: Option<[f64; 2]>,
    /// The greatest weight on bit up to which that was looked for.
    looked_for_to_kn: Option<f64>,
}

impl InspectedMotor {
    /// That of a sweep, where it has one.
    pub fn of(sweep: &Sweep) -> Option<Self> {
        let motor = sweep.setting.motor?;
        let weights = sweep.bit.as_ref().and_then(|bit| bit.weights_kn());
        let speed = sweep.conditions.surface_speed_rpm.unwrap_or_default();
        let speeds = sweep
            .design
            .ends(Axis::SurfaceSpeedRpm)
            .unwrap_or([speed; 2]);
        let found = sweep.bit.as_ref().zip(weights).map(|(bit, weights)| {
            let stalls = motor_stalls(sweep, bit, Axis::WeightOnBitKn, (weights, speeds));
            stalls.map(|(_, from)| from).collect::<Option<Vec<f64>>>()
        });
        let from = found.flatten().filter(|from| !from.is_empty());
        let ends = |from: Vec<f64>| {
            let least = from.iter().copied().fold(f64::INFINITY, f64::min);
            [least, from.into_iter().fold(least, f64::max)]
        };
        Some(Self {
            speed_without_load_rpm: to_rpm(motor.speed),
            speed_about_to_stall_rpm: to_rpm(motor.speed_at_stall()),
            stall_torque_kn_m: 1e-3 * motor.stall_torque,
            rotor_inertia_kg_m2: motor.rotor_inertia,
            stalls_from_kn: from.map(ends),
            looked_for_to_kn: weights.map(|[_, most]| most),
        })
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let torque = units.of(&TORQUE).text(1e3 * self.stall_torque_kn_m, 0);
        let [unloaded, loaded] = [self.speed_without_load_rpm, self.speed_about_to_stall_rpm];
        let rows = [
            (
                "rotor against its housing",
                format!(
                    "{} rpm without load, {} where it is about to stall",
                    short(unloaded),
                    short(loaded)
                ),
            ),
            ("stall torque", torque.clone()),
            (
                "inertia with the bit",
                units.of(&INERTIA).text(self.rotor_inertia_kg_m2, 1),
            ),
            ("stalls", self.stalls(&torque, units)),
        ];
        let lines = rows.map(|(title, value)| row(2, title, &value));
        format!("\nmud motor\n{}", lines.concat())
    }

    /// Where it stalls.
    fn stalls(&self, torque: &str, units: Units) -> String {
        let force = units.of(&FORCE);
        let weight = |weight: f64| force.text(weight, 1);
        match (self.stalls_from_kn, self.looked_for_to_kn) {
            (Some([least, most]), _) if most - least < 1e-3 * most => {
                format!("from {} on the bit on, in steady rotation", weight(least))
            }
            (Some([least, most]), _) => format!(
                "from {} to {} on the bit on, by the surface speed, in steady rotation",
                weight(least),
                weight(most)
            ),
            (None, Some(most)) => format!(
                "where turning the bit takes more than {torque}; at no one weight up to {}",
                weight(most)
            ),
            (None, None) => format!("where turning the bit takes more than {torque}"),
        }
    }
}
