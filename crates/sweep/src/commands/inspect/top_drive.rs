//! The string below a top drive: its reflection coefficient, and the lowest modes.

use std::f64::consts::TAU;

use anyhow::Result;
use linear::controllers::reflection;
use linear::drive_delay::longest_delay;
use linear::estimates::{FirstMode, first_mode, torsional_impedance};
use linear::modes::{TorsionalMode, torsional_modes};
use linear::{Drillstring, TopDrive};
use serde::Serialize;

use super::rows::row;
use campaign::quantities::{INERTIA, INTEGRAL_GAIN, PROPORTIONAL_GAIN, TORQUE, Units};
use campaign::words::short;
use plot::{Across, Axis, Look, Panel, Picture, Reference, Series, panels};

/// Modes that are shown.
const MODES: usize = 5;

/// Points of the reflection that is drawn.
const POINTS: usize = 2000;

/// The lower axis of both panels, which share its range.
const FREQUENCY: &str = "Frequency f (Hz)";

/// A string below a drive in numbers.
#[derive(Serialize)]
pub struct InspectedDrive {
    inertia_kg_m2: f64,
    proportional_gain_knms_rad: f64,
    pipe_impedance_knms_rad: f64,
    integral_gain_knm_rad: f64,
    /// How late its controller answers.
    delay_ms: f64,
    /// How late it may answer before the string grows unstable below it, where that is known.
    longest_delay_ms: Option<f64>,
    /// The most torque that it gives, where that is a law.
    #[serde(skip_serializing_if = "Option::is_none")]
    limited_to_kn_m: Option<f64>,
    /// With the surface held.
    first_mode_hz: f64,
    first_mode_inertia_kg_m2: f64,
    /// The part of a wave of that frequency that comes back.
    reflection_at_first_mode: f64,
    /// Those of string and drive.
    modes: Vec<InspectedMode>,
    modes_surface_held: Vec<InspectedMode>,
}

/// A mode that swings.
#[derive(Serialize)]
struct InspectedMode {
    frequency_hz: f64,
    damping_ratio: f64,
}

impl InspectedMode {
    fn of(mode: &TorsionalMode) -> Self {
        Self {
            frequency_hz: mode.frequency(),
            damping_ratio: mode.damping_ratio(),
        }
    }
}

impl InspectedDrive {
    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let [inertia, gain, integral_gain] =
            [&INERTIA, &PROPORTIONAL_GAIN, &INTEGRAL_GAIN].map(|twin| units.of(twin));
        let of_drive = short(inertia.number(self.inertia_kg_m2));
        let proportional = short(gain.number(self.proportional_gain_knms_rad));
        let impedance = gain.number(self.pipe_impedance_knms_rad);
        let integral = short(integral_gain.number(self.integral_gain_knm_rad));
        let first = short(self.first_mode_hz);
        let mut text = "\ntop drive\n".to_owned();
        let rows = [
            ("inertia", format!("{of_drive} {}", inertia.name)),
            (
                "proportional gain K_p",
                format!(
                    "{proportional} {}; impedance of the pipe {impedance:.3}",
                    gain.name
                ),
            ),
            (
                "integral gain K_i",
                format!("{integral} {}", integral_gain.name),
            ),
            ("delay", self.delay()),
        ];
        let of_string = [
            (
                "first mode, surface held",
                format!(
                    "{first} Hz, {}",
                    inertia.text(self.first_mode_inertia_kg_m2, 0)
                ),
            ),
            (
                "of a wave, then comes back",
                format!("{:.0} %", 100.0 * self.reflection_at_first_mode),
            ),
        ];
        let limited = self.limited(units).map(|torque| ("torque", torque));
        for (title, value) in rows.into_iter().chain(limited).chain(of_string) {
            text += &row(2, title, &value);
        }
        text + &self.mode_lines()
    }

    /// What it gives at most, where that is a law.
    fn limited(&self, units: Units) -> Option<String> {
        let limit = units.of(&TORQUE).text(1e3 * self.limited_to_kn_m?, 0);
        Some(format!(
            "limited to {limit}; its integral stands still while it lacks any"
        ))
    }

    fn delay(&self) -> String {
        let delay = short(self.delay_ms);
        match self.longest_delay_ms {
            Some(longest) => format!("{delay} ms; stable below {longest:.3} ms"),
            None => format!("{delay} ms"),
        }
    }

    fn mode_lines(&self) -> String {
        let in_words = |mode: Option<&InspectedMode>| {
            mode.map_or_else(String::new, |mode| {
                let (frequency, damping) = (mode.frequency_hz, 100.0 * mode.damping_ratio);
                format!("{frequency:.3} Hz, damping {damping:.1} %")
            })
        };
        let count = self.modes.len().max(self.modes_surface_held.len());
        let lines = (0..count).map(|index| {
            let [below, held] = [&self.modes, &self.modes_surface_held];
            let [below, held] = [below, held].map(|modes| in_words(modes.get(index)));
            format!("    {below:<29}{held}\n")
        });
        let title = "  modes of string and drive      with the surface held\n".to_owned();
        title + &lines.collect::<String>()
    }
}

/// A string below a drive, seen from the surface.
pub struct DriveView<'a> {
    string: &'a Drillstring,
    drive: TopDrive,
    first: FirstMode,
    /// The lowest modes of string and drive.
    below_drive: Vec<TorsionalMode>,
    /// Those of the same string where the surface turns as prescribed.
    surface_held: Vec<TorsionalMode>,
    /// s.
    longest_delay: Option<f64>,
    /// N m.
    limit: Option<f64>,
}

impl<'a> DriveView<'a> {
    /// That of a string, its drive limited to a torque (N m) or not; `None` without a top drive.
    ///
    /// # Errors
    /// Where its modes cannot be found.
    pub fn of(string: &'a Drillstring, limit: Option<f64>) -> Result<Option<Self>> {
        let Some(drive) = string.top_drive() else {
            return Ok(None);
        };
        let held = string.clone().without_top_drive();
        Ok(Some(Self {
            string,
            drive,
            first: first_mode(string),
            below_drive: torsional_modes(string, MODES)?,
            surface_held: torsional_modes(&held, MODES)?,
            longest_delay: longest_delay(string)?,
            limit,
        }))
    }

    /// The part of a wave that comes back at a frequency, rad/s.
    fn reflection(&self, frequency: f64) -> f64 {
        reflection(self.string, &self.drive, frequency).norm()
    }

    /// Its numbers.
    pub fn numbers(&self) -> InspectedDrive {
        let FirstMode {
            frequency, inertia, ..
        } = self.first;
        let uppermost = &self.string.sections()[0].parts[0];
        InspectedDrive {
            inertia_kg_m2: self.drive.inertia,
            proportional_gain_knms_rad: 1e-3 * self.drive.proportional_gain,
            pipe_impedance_knms_rad: 1e-3 * torsional_impedance(self.string, uppermost),
            integral_gain_knm_rad: 1e-3 * self.drive.integral_gain,
            delay_ms: 1e3 * self.drive.delay,
            longest_delay_ms: self.longest_delay.map(|delay| 1e3 * delay),
            limited_to_kn_m: self.limit.map(|limit| 1e-3 * limit),
            first_mode_hz: frequency / TAU,
            first_mode_inertia_kg_m2: inertia,
            reflection_at_first_mode: self.reflection(frequency),
            modes: self.below_drive.iter().map(InspectedMode::of).collect(),
            modes_surface_held: self.surface_held.iter().map(InspectedMode::of).collect(),
        }
    }

    /// The reflection over frequency, and the damping of the modes below it.
    pub fn picture(&self, look: &Look, title: &str, shown: &[Panel]) -> Picture {
        let title = format!("{title}: reflection coefficient of the top drive");
        panels(look, &title, shown)
    }

    /// What the picture shows.
    pub fn panels(&self) -> [Panel; 2] {
        [self.reflection_panel(), self.damping_panel()]
    }

    fn reflection_panel(&self) -> Panel {
        let modes = self.below_drive.iter().chain(&self.surface_held);
        let highest = modes
            .map(|mode| mode.pole.im)
            .fold(self.first.frequency, f64::max);
        let point = |index: usize| {
            let frequency = highest * index as f64 / POINTS as f64;
            (frequency / TAU, self.reflection(frequency))
        };
        Panel {
            axes: [FREQUENCY, "|reflection|"].map(Axis::linear),
            series: vec![Series::new("reflection", (1..=POINTS).map(point).collect())],
            references: vec![Reference {
                across: Across::X,
                at: self.first.frequency / TAU,
                name: "first mode".to_owned(),
            }],
            walls: Vec::new(),
            is_difference: false,
        }
    }

    fn damping_panel(&self) -> Panel {
        let series = |name: &str, modes: &[TorsionalMode]| {
            let points = modes.iter();
            let points = points.map(|mode| (mode.frequency(), 100.0 * mode.damping_ratio()));
            Series::new(name, points.collect())
        };
        Panel {
            axes: [FREQUENCY, "Damping of modes (%)"].map(Axis::linear),
            series: vec![
                series("modes below the drive", &self.below_drive),
                series("modes, surface held", &self.surface_held),
            ],
            references: Vec::new(),
            walls: Vec::new(),
            is_difference: false,
        }
    }
}
