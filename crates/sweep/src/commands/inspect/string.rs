//! The string, from the surface to the bit.

use linear::estimates::{
    torsional_decay_rate, torsional_stiffness, torsional_travel_time, torsional_wave_left,
};
use serde::Serialize;

use super::rows::row;
use campaign::plan::{Choice, POUND_PER_FOOT, Sweep};
use campaign::quantities::{INCH, LENGTH, TORQUE, Unit, Units};
use campaign::sweep_file::{SheetNotes, per_cent};
use campaign::words::wrapped;

/// The string in numbers.
#[derive(Serialize)]
pub struct InspectedString<'a> {
    length_m: f64,
    sections: Vec<InspectedSection<'a>>,
    /// What the weights of a BHA sheet say of its dimensions.
    #[serde(skip_serializing_if = "Option::is_none")]
    sheet: Option<&'a SheetNotes>,
    torsional_stiffness_nm_rad: f64,
    torsional_wave_speed_m_s: f64,
    travel_time_s: f64,
    torsional_decay_rate_1_s: f64,
    /// The part of a wave's amplitude that damping leaves at the bit.
    wave_left: f64,
    sampling_frequency_hz: f64,
    sampling_frequency: SampledBy,
    /// Of the rule, where that gives the frequency.
    steps_per_travel_time: Option<f64>,
    accuracy: Option<&'a Choice>,
}

/// Cells that repeat.
#[derive(Serialize)]
struct InspectedSection<'a> {
    repeat: usize,
    name: Option<&'a str>,
    cell_length_m: f64,
    parts: Vec<InspectedPart>,
}

/// A part of a cell.
#[derive(Serialize)]
struct InspectedPart {
    outer_diameter_m: f64,
    inner_diameter_m: f64,
    mass_kg_m: f64,
    length_m: f64,
}

/// What decides the sampling frequency.
#[derive(Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
enum SampledBy {
    Accuracy,
    Rule,
    File,
}

impl<'a> InspectedString<'a> {
    /// That of a sweep.
    pub fn of(sweep: &'a Sweep) -> Self {
        let (setting, string) = (&sweep.setting, &sweep.setting.string);
        let sections = string.sections().iter().zip(&sweep.content.string.sections);
        let sections = sections.map(|(section, table)| {
            let parts = section.parts.iter().map(|part| InspectedPart {
                outer_diameter_m: 2.0 * part.outer_radius,
                inner_diameter_m: 2.0 * part.inner_radius,
                mass_kg_m: sweep.mass_per_length(part),
                length_m: part.length,
            });
            InspectedSection {
                repeat: section.repeat,
                name: table.name.as_deref(),
                cell_length_m: section.cell_length(),
                parts: parts.collect(),
            }
        });
        let steps_per_travel_time = match sweep.choice {
            Some(_) => None,
            None => setting.steps_per_travel,
        };
        Self {
            length_m: string.length(),
            sections: sections.collect(),
            sheet: sweep.sheet.as_ref(),
            torsional_stiffness_nm_rad: torsional_stiffness(string),
            torsional_wave_speed_m_s: string.torsional_wave_speed(),
            travel_time_s: torsional_travel_time(string),
            torsional_decay_rate_1_s: torsional_decay_rate(string),
            wave_left: torsional_wave_left(string),
            sampling_frequency_hz: setting.sampling_frequency,
            sampling_frequency: match (&sweep.choice, steps_per_travel_time) {
                (Some(_), _) => SampledBy::Accuracy,
                (None, Some(_)) => SampledBy::Rule,
                (None, None) => SampledBy::File,
            },
            steps_per_travel_time,
            accuracy: sweep.choice.as_ref(),
        }
    }

    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let (length, torque) = (units.of(&LENGTH), units.of(&TORQUE));
        let [second, radian] = ["s", "rad"].map(Unit::unchanged);
        let mut text = "\nstring\n".to_owned();
        text += &row(2, "length", &length.text(self.length_m, 3));
        text += &self.part_lines(&length);
        text += &self.sheet_lines(units);
        let (travel, decay) = (self.travel_time_s, self.torsional_decay_rate_1_s);
        let left = 100.0 * self.wave_left;
        let stiffness = self.torsional_stiffness_nm_rad;
        let speed = self.torsional_wave_speed_m_s;
        for (title, value) in [
            (
                "torsional stiffness k_eff",
                torque.per(&radian).text(stiffness, 1),
            ),
            ("torsional wave speed", length.per(&second).text(speed, 1)),
            (
                "travel time to the bit",
                format!("{travel:.4} s, and back {:.4} s", 2.0 * travel),
            ),
            ("torsional decay rate", format!("{decay:.3} 1/s")),
            (
                "of a wave, damping leaves",
                format!("{left:.3} % of its amplitude at the bit"),
            ),
            ("sampling frequency f_s", self.sampling()),
        ] {
            text += &row(2, title, &value);
        }
        text + &self.accuracy.map_or_else(String::new, choice_lines)
    }

    fn sampling(&self) -> String {
        let frequency = self.sampling_frequency_hz;
        let decimals = if frequency < 1e4 { 2 } else { 0 };
        let why = match (self.sampling_frequency, self.steps_per_travel_time) {
            (SampledBy::Accuracy, _) => "by the accuracy asked for",
            (_, Some(steps)) => &format!("by rule, {steps:.0} steps a travel time"),
            (_, None) => "given in the sweep file",
        };
        format!("{frequency:.decimals$} Hz ({why})")
    }

    /// The parts of the string from the surface down, as on a BHA sheet.
    fn part_lines(&self, length: &Unit) -> String {
        let mut text = format!(
            "    outer diameter      inner diameter      mass               length\n    \
             mm         in       mm         in       kg/m      lb/ft    {}\n",
            length.name
        );
        for section in &self.sections {
            let cell = length.text(section.cell_length_m, 3);
            let mut title = format!("{} × {cell}", section.repeat);
            if let Some(name) = section.name {
                title += &format!(", {name}");
            }
            text += &wrapped(&title, 2, 4);
            for part in &section.parts {
                text += "  ";
                for diameter in [part.outer_diameter_m, part.inner_diameter_m] {
                    text += &format!("  {:<9.1}{:<9.3}", 1e3 * diameter, diameter / INCH);
                }
                let mass = part.mass_kg_m;
                let pounds = mass / POUND_PER_FOOT;
                let (length, decimals) = (length.number(part.length_m), length.decimals(3));
                text += &format!("  {mass:<8.1}  {pounds:<7.1}  {length:.decimals$}\n");
            }
        }
        text
    }

    fn sheet_lines(&self, units: Units) -> String {
        let Some(sheet) = self.sheet else {
            return String::new();
        };
        let title = format!(
            "rows of {} whose weight is not that of their dimensions",
            sheet.file
        );
        let lines = sheet.lines(units);
        let lines: String = lines.map(|line| wrapped(&line, 4, 6)).collect();
        match lines.is_empty() {
            true => lines,
            false => wrapped(&title, 2, 4) + &lines,
        }
    }
}

/// What was chosen for an accuracy, and what else was tried.
fn choice_lines(choice: &Choice) -> String {
    let mut text = format!("\n{}", choice.lines(0));
    for tried in &choice.tried {
        let error = (tried.error).map_or_else(
            || "refused".to_owned(),
            |error| format!("{} %", per_cent(error)),
        );
        text += &wrapped(&format!("{}: {error}, {}", tried.candidate, tried.of), 2, 4);
    }
    text
}
