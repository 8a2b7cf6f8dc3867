//! High-frequency torsional oscillation: which resonances of the bit a falling torque feeds, and from
//! which speed on.

use std::path::Path;

use anyhow::Result;
use serde::Serialize;

use crate::commands::csv_table::csv_table;
use campaign::plan::Sweep;
use campaign::quantities::{TORQUE, Unit, Units};
use campaign::words::wrapped;
use limits::{BitResonance, bit_resonances};
use plot::{Axis, Look, Panel, Picture, Series, panels};
use results::files::write_atomically;

/// How many are described.
const DESCRIBED: usize = 5;

/// The resonances of the bit.
pub struct Resonances {
    /// From the slowest on; none of a string without a bit.
    all: Vec<BitResonance>,
}

/// Those that grow most easily, the one that bears least first.
#[derive(Serialize)]
#[serde(transparent)]
pub struct InspectedResonances(Vec<BitResonance>);

impl Resonances {
    /// Those of a string with a bit.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn find(sweep: &Sweep) -> Result<Self> {
        // A bit that cuts has no torque that falls with speed: roots of D(s) say what grows.
        let falls = sweep.bit.is_some() && sweep.setting.cutting.is_none();
        let all = match falls {
            true => bit_resonances(sweep)?,
            false => Vec::new(),
        };
        Ok(Self { all })
    }

    /// Whether there is a bit that they are of.
    pub fn are_there(&self) -> bool {
        !self.all.is_empty()
    }

    /// Writes the table of all of them.
    ///
    /// # Errors
    /// Where the file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let rows = self.all.iter().map(|it| {
            let speed = it.grows_below_rpm.map(|speed| speed.to_string());
            [
                ("frequency_hz", it.frequency_hz.to_string()),
                ("mobility_rad_s_nm", it.mobility_rad_s_nm.to_string()),
                (
                    "steepest_fall_nms_rad",
                    it.steepest_fall_nms_rad.to_string(),
                ),
                ("grows_below_rpm", speed.unwrap_or_default()),
            ]
        });
        write_atomically(&folder.join("bit_resonances.csv"), &csv_table(rows)?)
    }

    /// The mobility of each and, where the torque falls, the speed below which it grows.
    pub fn picture(&self, look: &Look, title: &str, units: Units) -> Picture {
        let mobility = Unit::unchanged("rad/s").per(&units.of(&TORQUE));
        let panel = |axis: String, name: &str, points: Vec<(f64, f64)>| Panel {
            axes: [Axis::logarithmic("Frequency f (Hz)"), Axis::linear(axis)],
            series: vec![Series::new(
                name,
                points.into_iter().flat_map(stem).collect(),
            )],
            references: Vec::new(),
            walls: Vec::new(),
            is_difference: false,
        };
        let mobile = self.all.iter();
        let mobile = mobile.map(|it| (it.frequency_hz, mobility.number(it.mobility_rad_s_nm)));
        let mut shown = vec![panel(
            format!("Mobility ({})", mobility.name),
            "speed of the bit per torque on it, at each resonance",
            mobile.collect(),
        )];
        let grows = self.all.iter();
        let grows: Vec<_> = grows
            .filter_map(|it| Some((it.frequency_hz, it.grows_below_rpm?)))
            .collect();
        if !grows.is_empty() {
            shown.push(panel(
                "Grows below (rpm)".to_owned(),
                "speed of the bit below which it grows",
                grows,
            ));
        }
        panels(look, &format!("{title}: resonances of the bit"), &shown)
    }

    /// A few of them, for words and documents.
    pub fn most_easily_fed(mut self) -> InspectedResonances {
        (self.all).sort_by(|one, other| other.mobility_rad_s_nm.total_cmp(&one.mobility_rad_s_nm));
        self.all.truncate(DESCRIBED);
        InspectedResonances(self.all)
    }
}

/// A line up from the frequency axis and down again: nothing is known between resonances.
fn stem((frequency, value): (f64, f64)) -> [(f64, f64); 3] {
    [(frequency, 0.0), (frequency, value), (frequency, 0.0)]
}

/// Of torque per rotation speed.
fn fall_unit(units: Units) -> Unit {
    units.of(&TORQUE).per(&Unit::unchanged("rad/s"))
}

impl InspectedResonances {
    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        if self.0.is_empty() {
            return String::new();
        }
        let fall = fall_unit(units);
        let line = |it: &BitResonance| {
            let bears = fall.text(it.steepest_fall_nms_rad, 1);
            let grows = match it.grows_below_rpm {
                Some(speed) => format!("grows below {speed:.0} rpm"),
                None => "does not grow by this torque".to_owned(),
            };
            format!("    {:>8.2} Hz   {bears:<24}{grows}\n", it.frequency_hz)
        };
        let lines: String = self.0.iter().map(line).collect();
        let title = "high-frequency torsional oscillation: the resonances of the bit up to 1 kHz that \
                     bear the least fall of its torque with speed";
        wrapped(title, 2, 4) + &lines
    }
}
