//! High-frequency torsional oscillation: which resonance of the bit a falling torque feeds most
//! easily, and from which speed on.

use anyhow::Result;
use serde::Serialize;

use campaign::plan::Sweep;
use campaign::quantities::{TORQUE, Unit, Units};
use campaign::words::wrapped;
use limits::{BitResonance, bit_resonances};

/// How many are described.
const MOST: usize = 5;

/// The resonances that grow most easily.
#[derive(Serialize)]
#[serde(transparent)]
pub struct InspectedResonances(Vec<BitResonance>);

impl InspectedResonances {
    /// Those of a string with a bit; none without one.
    ///
    /// # Errors
    /// Where the string cannot be cut up.
    pub fn find(sweep: &Sweep) -> Result<Self> {
        let found = match sweep.bit {
            Some(_) => bit_resonances(sweep, MOST)?,
            None => Vec::new(),
        };
        Ok(Self(found))
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        if self.0.is_empty() {
            return String::new();
        }
        let torque = units.of(&TORQUE);
        let fall = torque.per(&Unit::unchanged("rad/s"));
        let line = |it: &BitResonance| {
            let bears = fall.text(it.steepest_fall_nms_rad, 1);
            let grows = match it.grows_below_rpm {
                Some(speed) => format!("grows below {speed:.0} rpm"),
                None => "never grows under the torque of this file".to_owned(),
            };
            format!("    {:>8.2} Hz   {bears:<26}{grows}\n", it.frequency_hz)
        };
        let lines: String = self.0.iter().map(line).collect();
        let title = wrapped(
            "high-frequency torsional oscillation: resonances of the bit up to 1 kHz, by the fall of \
             its torque with speed that each bears",
            2,
            4,
        );
        title + &lines
    }
}
