//! `[string]`: the drillstring, its numbers checked.

use linear::{Drillstring, DrillstringError, Material, Section, Tube};

use super::file::{FileContent, SectionTable};
use super::resolve::Check;
use super::source::SweepFileError;
use crate::quantities::{Axis, LONGEST_STRING, StringAxis, TubeMeasure};

impl Check<'_> {
    pub(super) fn string(&self, content: &FileContent) -> Result<Drillstring, SweepFileError> {
        let table = &content.string;
        self.within(
            "string.shear_modulus_gpa",
            table.shear_modulus_gpa,
            0.1,
            1e3,
            "GPa",
        )?;
        self.within(
            "string.density_kg_m3",
            table.density_kg_m3,
            100.0,
            3e4,
            "kg/m³",
        )?;
        let damping = table.torsional_damping_nms_rad_m;
        self.measure(
            "string.torsional_damping_nms_rad_m",
            StringAxis::TorsionalDamping,
            damping,
        )?;
        for (section, data) in table.sections.iter().enumerate() {
            self.section(section, data)?;
        }
        let sections = table.sections.iter().map(|section| Section {
            repeat: section.repeat,
            parts: section
                .parts
                .iter()
                .map(|part| Tube {
                    length: part.length_m,
                    inner_radius: part.inner_radius_m,
                    outer_radius: part.outer_radius_m,
                })
                .collect(),
        });
        let material = Material {
            shear_modulus: 1e9 * table.shear_modulus_gpa,
            density: table.density_kg_m3,
        };
        let string = Drillstring::new(material, sections.collect(), damping)
            .map_err(|error| self.source.error(&key_of(&error), error.to_string()))?;
        self.length(&string)?;
        Ok(string)
    }

    /// Millimetres for metres show in the whole string, if not in a part.
    fn length(&self, string: &Drillstring) -> Result<(), SweepFileError> {
        if string.length() <= LONGEST_STRING {
            return Ok(());
        }
        let parts = string
            .sections()
            .iter()
            .enumerate()
            .flat_map(|(index, section)| {
                let count = section.repeat as f64;
                let parts = section.parts.iter().enumerate();
                parts.map(move |(part, tube)| (count * tube.length, index, part))
            });
        let (_, section, part) = parts
            .max_by(|one, other| one.0.total_cmp(&other.0))
            .unwrap_or_default();
        let message = format!(
            "the string is {} m long, more than {LONGEST_STRING} m; is this in another unit?",
            string.length()
        );
        let key = format!("string.sections[{section}].parts[{part}].length_m");
        Err(self.source.error(&key, message))
    }

    fn section(&self, section: usize, table: &SectionTable) -> Result<(), SweepFileError> {
        let key = format!("string.sections[{section}]");
        let repeat = table.repeat as f64;
        self.measure(
            &format!("{key}.repeat"),
            StringAxis::Repeat { section },
            repeat,
        )?;
        for (part, tube) in table.parts.iter().enumerate() {
            for (name, measure, value) in [
                ("length_m", TubeMeasure::Length, tube.length_m),
                (
                    "inner_radius_m",
                    TubeMeasure::InnerRadius,
                    tube.inner_radius_m,
                ),
                (
                    "outer_radius_m",
                    TubeMeasure::OuterRadius,
                    tube.outer_radius_m,
                ),
            ] {
                let axis = StringAxis::Tube {
                    section,
                    part,
                    measure,
                };
                self.measure(&format!("{key}.parts[{part}].{name}"), axis, value)?;
            }
        }
        Ok(())
    }

    /// A quantity that could be an axis too has one range for both.
    pub(super) fn measure(
        &self,
        key: &str,
        axis: StringAxis,
        value: f64,
    ) -> Result<(), SweepFileError> {
        self.source.check_axis(key, Axis::String(axis), value)
    }
}

/// The key that an error about the string is about.
fn key_of(error: &DrillstringError) -> String {
    match error {
        DrillstringError::NoSections => "string.sections".to_owned(),
        DrillstringError::NoRepeat { section } => format!("string.sections[{section}].repeat"),
        DrillstringError::NoParts { section } => format!("string.sections[{section}].parts"),
        DrillstringError::Length { section, part, .. } => {
            format!("string.sections[{section}].parts[{part}].length_m")
        }
        DrillstringError::Radii { section, part, .. } => {
            format!("string.sections[{section}].parts[{part}].inner_radius_m")
        }
        _ => "string".to_owned(),
    }
}
