//! Each method's responses, and whether they are stable in sticking.

use linear::estimates::largest_undershoot;
use serde::Serialize;

use super::rows::row;
use campaign::engine::{MethodSystem, is_unstable};
use campaign::plan::steps_of_turn;
use campaign::quantities::{IMPULSE, TORQUE, Unit, Units};
use campaign::words::{counted, short};

/// The linear system of a method.
#[derive(Serialize)]
pub struct InspectedMethod {
    method: &'static str,
    sampling_frequency_hz: f64,
    /// Steps in a turn of the fastest whirl to expect, with a wall.
    steps_of_whirl: Option<f64>,
    /// Steps of its response.
    taps: usize,
    response_s: f64,
    build_s: f64,
    /// At the bit, where a torque acts there.
    #[serde(flatten)]
    at_bit: Option<AtBit>,
    /// The undershoot as it is, where it was compared.
    exact_undershoot_rad_s_per_nm: Option<f64>,
    /// By what part of that the method's is too large.
    overshoot: Option<f64>,
    least_impulses_ns: Vec<f64>,
    positive_real_margin: Option<f64>,
    bending_margin: Option<f64>,
    axial_margin: Option<f64>,
}

/// The response of the bit to a torque on it.
#[derive(Serialize)]
struct AtBit {
    /// A(0).
    first_response_rad_s_per_nm: f64,
    /// Δ of Eq. 75.
    undershoot_rad_s_per_nm: f64,
}

impl InspectedMethod {
    /// That of a system that is built.
    pub fn of(system: &MethodSystem) -> Self {
        Self {
            method: system.method.name(),
            sampling_frequency_hz: system.responses.sampling_frequency,
            steps_of_whirl: system.setting.steps_of_whirl(&system.method),
            taps: system.torsion_taps(),
            response_s: system.torsion_taps() as f64 / system.responses.sampling_frequency,
            build_s: system.build_seconds,
            at_bit: system.driving_point().map(|taps| AtBit {
                first_response_rad_s_per_nm: taps[0],
                undershoot_rad_s_per_nm: largest_undershoot(taps),
            }),
            exact_undershoot_rad_s_per_nm: system.front.map(|front| front.exact),
            overshoot: system.front.map(|front| front.relative()),
            least_impulses_ns: system.least_impulses.clone(),
            positive_real_margin: system.torsion_margin,
            bending_margin: system.bending_margin,
            axial_margin: system.axial_margin,
        }
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let impulse = units.of(&IMPULSE);
        let mobility = Unit::unchanged("rad/s").per(&units.of(&TORQUE));
        let mut text = format!(
            "  {}: response of {} ({:.2} s), built in {:.3} s\n",
            self.method,
            counted(self.taps, "step"),
            self.response_s,
            self.build_s,
        );
        if let Some(steps) = self.steps_of_whirl {
            let frequency = self.sampling_frequency_hz;
            let value = format!(
                "{steps:.0} steps at {} Hz, of {} that it needs",
                short(frequency),
                steps_of_turn(self.method)
            );
            let title = format!("a turn of whirl, {:.0} a second at most", frequency / steps);
            text += &row(4, &title, &value);
        }
        if let Some(at_bit) = &self.at_bit {
            for (title, value) in [
                ("A(0) at the bit", at_bit.first_response_rad_s_per_nm),
                ("undershoot Δ (Eq. 75)", at_bit.undershoot_rad_s_per_nm),
            ] {
                let value = format!("{:.4e} {}", mobility.number(value), mobility.name);
                text += &row(4, title, &value);
            }
        }
        if let (Some(exact), Some(overshoot)) = (self.exact_undershoot_rad_s_per_nm, self.overshoot)
        {
            let value = format!(
                "{:.4e}: {:+.1} % here",
                mobility.number(exact),
                100.0 * overshoot
            );
            text += &row(4, "exactly", &value);
        }
        for least in &self.least_impulses_ns {
            text += &row(4, "least impulse I₀", &impulse.text(*least, 1));
        }
        for (margin, what) in [
            (self.positive_real_margin, "torsion"),
            (self.bending_margin, "bending"),
            (self.axial_margin, "axial motion"),
        ] {
            if let Some(margin) = margin {
                let verdict = if is_unstable(margin) {
                    "a stuck site chatters"
                } else {
                    "stable in sticking"
                };
                let value = format!("{} in {what}: {verdict}", short(margin));
                text += &row(4, "positive-real margin", &value);
            }
        }
        text
    }
}
