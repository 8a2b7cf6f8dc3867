//! How the string lies in its well, where it rubs there.

use serde::Serialize;

use super::rows::row;
use campaign::plan::Sweep;
use campaign::quantities::{FORCE, TORQUE, Units};
use campaign::sweep_file::per_cent;

/// A string that rubs along its well.
#[derive(Serialize)]
pub struct InspectedWell {
    inclination_at_bit_deg: f64,
    hook_load_kn: f64,
    weight_on_bit_kn: f64,
    /// Torque that turns the string, for each unit of friction.
    torque_to_turn_off_bottom_knm: f64,
    torque_to_turn_on_bottom_knm: f64,
    /// Pieces that slip as wholes.
    pieces: usize,
    /// The greatest error of the torque that turns all, as a fraction of it.
    off_by: f64,
}

impl InspectedWell {
    /// That of a sweep, if the string rubs.
    pub fn of(sweep: &Sweep) -> Option<Self> {
        let friction = sweep.setting.friction.as_ref()?;
        let weight = sweep.conditions.weight_on_bit_kn.unwrap_or(0.0);
        let [off_bottom, on_bottom] =
            [0.0, 1e3 * weight].map(|weight| 1e-3 * friction.torque_to_turn(weight));
        Some(Self {
            inclination_at_bit_deg: friction.inclination_at_bit().to_degrees(),
            hook_load_kn: 1e-3 * friction.hook_load(),
            weight_on_bit_kn: weight,
            torque_to_turn_off_bottom_knm: off_bottom,
            torque_to_turn_on_bottom_knm: on_bottom,
            pieces: friction.pieces(),
            off_by: friction.off_by(),
        })
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let (force, torque) = (units.of(&FORCE), units.of(&TORQUE).kilo());
        let mut rows = vec![
            (
                "inclination at the bit",
                format!("{:.1}°", self.inclination_at_bit_deg),
            ),
            (
                "weight along the well",
                format!("{} off bottom", force.text(self.hook_load_kn, 1)),
            ),
            (
                "torque to turn it",
                format!(
                    "{} off bottom, per coefficient of friction",
                    torque.text(self.torque_to_turn_off_bottom_knm, 2)
                ),
            ),
        ];
        if self.weight_on_bit_kn > 0.0 {
            let torque = torque.text(self.torque_to_turn_on_bottom_knm, 2);
            let weight = force.rounded(self.weight_on_bit_kn);
            rows.push((
                "",
                format!("{torque} at {weight} {} on the bit", force.name),
            ));
        }
        rows.push((
            "pieces that slip as wholes",
            format!(
                "{}, off by {} % of the torque that turns all at most, where friction does not fall",
                self.pieces,
                per_cent(self.off_by)
            ),
        ));
        let lines = rows.iter().map(|(title, value)| row(2, title, value));
        "\nwell\n".to_owned() + &lines.collect::<String>()
    }
}
