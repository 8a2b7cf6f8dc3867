//! A row as a section, and what its weight says of its dimensions: drillpipe is heavier than
//! its body by its tool joints, whose dimensions sheets seldom have.

use serde::Serialize;
use toml::{Table, Value};

use super::kind::ToolKind;
use super::rows::SheetRow;
use crate::quantities::{Axis, INCH, LENGTH, StringAxis, TubeMeasure, Units};

/// Length of a joint where the sheet does not count them: 31½ ft, range 2 with its tool
/// joints, m.
const USUAL_JOINT: f64 = 9.6;

/// Rows longer than this are of more than one joint, m.
const LONGEST_JOINT: f64 = 15.0;

/// Outer diameter of a tool joint by that of its pipe, where it is not given; of API sizes it is
/// from 1.19 to 1.36.
const TOOL_JOINT: f64 = 1.25;

/// No tool joint, with the pad in the middle of heavy-weight pipe, is longer than this part of a
/// joint.
const LONGEST_TOOL_JOINT: f64 = 0.5;

/// A weight that differs by no more than this part from that of the dimensions is theirs.
const SAME_WEIGHT: f64 = 0.02;

/// Beyond this part either may be wrong.
const DOUBTFUL: f64 = 0.1;

/// What a row's weight says.
#[derive(Debug, Clone, Serialize)]
pub struct WeightCheck {
    /// Its line in the sheet.
    pub line: usize,
    /// What it is.
    pub name: String,
    /// What that says it is.
    #[serde(skip)]
    pub kind: ToolKind,
    /// Its mass less that of the dimensions as the sheet has them, as a part of the latter.
    pub excess: Option<f64>,
    /// What was made of it.
    pub made: Made,
}

/// What is made of a row.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Made {
    /// Tubes of its dimensions.
    AsGiven,
    /// Pipe with tool joints of as much mass as its weight asks for: their outer diameter and
    /// their length, m, and how many.
    WithToolJoints {
        /// Outer diameter, m.
        #[serde(rename = "outer_diameter_m")]
        outer_diameter: f64,
        /// Length of each, m.
        #[serde(rename = "length_m")]
        length: f64,
        /// How many.
        joints: usize,
    },
}

/// A tube of a cell: length, inner and outer diameter, m.
#[derive(Debug, Clone, Copy)]
struct Part {
    length: f64,
    inner: f64,
    outer: f64,
}

impl WeightCheck {
    /// How its weight was treated, where it has one that differs from that of its dimensions.
    pub fn words(&self, units: Units) -> Option<String> {
        let per_cent = 100.0 * self.excess.filter(|excess| excess.abs() > SAME_WEIGHT)?;
        let weight = match per_cent {
            more if more >= 0.0 => format!("{more:.1} % more"),
            less => format!("{:.1} % less", -less),
        };
        let differs = format!("its weight is {weight} than that of its dimensions");
        Some(match self.made {
            Made::AsGiven => format!("{differs}, which are taken"),
            Made::WithToolJoints {
                outer_diameter,
                length,
                joints,
            } => format!(
                "{differs}: {joints} tool joints of {:.2} in, {} long, make up for it",
                outer_diameter / INCH,
                units.of(&LENGTH).text(length, 2)
            ),
        })
    }

    /// Whether its dimensions, which are taken, are hardly those of its weight.
    pub fn is_doubtful(&self) -> bool {
        let differs = self.excess.is_some_and(|excess| excess.abs() > DOUBTFUL);
        differs && self.made == Made::AsGiven
    }
}

impl Part {
    fn area(&self) -> f64 {
        0.25 * std::f64::consts::PI * (self.outer * self.outer - self.inner * self.inner)
    }
}

/// The section of a row, of steel of a density (kg/m³), and what its weight says.
///
/// # Errors
/// Which of its numbers is that of no tube; begins with its line.
pub fn section(row: &SheetRow, density: f64) -> Result<(Value, WeightCheck), String> {
    let joints = row.joints.unwrap_or_else(|| {
        let many = row.length > LONGEST_JOINT;
        let usual = if many { row.length / USUAL_JOINT } else { 1.0 };
        usual.round() as usize
    });
    let body = Part {
        length: row.length / joints as f64,
        inner: row.inner_diameter,
        outer: row.outer_diameter,
    };
    if let Some(length) = row
        .tool_joint
        .length
        .filter(|length| *length >= body.length)
    {
        let (line, joint) = (row.line, body.length);
        return Err(format!(
            "{line}: a tool joint of {length:.3} m is not shorter than the joint, {joint:.3} m"
        ));
    }
    let given = given_parts(row, body);
    let dimensions: f64 = given
        .iter()
        .map(|part| density * part.area() * part.length)
        .sum();
    let excess = row
        .mass
        .map(|mass| mass / (joints as f64 * dimensions) - 1.0);
    let (parts, made) = match excess.and_then(|excess| equivalent(row, body, joints, excess)) {
        Some((parts, made)) if given.len() == 1 => (parts, made),
        _ => (given, Made::AsGiven),
    };
    for part in &parts {
        check(part).map_err(|reason| format!("{}: {reason}", row.line))?;
    }
    let touches = touching(row, &parts).map_err(|reason| format!("{}: {reason}", row.line))?;
    let check = WeightCheck {
        line: row.line,
        name: row.name.clone(),
        kind: row.kind,
        excess,
        made,
    };
    Ok((table(row, joints, &parts, touches), check))
}

/// The parts of a cell by the sheet's dimensions.
fn given_parts(row: &SheetRow, body: Part) -> Vec<Part> {
    let joint = row.tool_joint;
    match (joint.outer_diameter, joint.length) {
        (Some(outer), Some(length)) => vec![
            Part {
                length: body.length - length,
                ..body
            },
            Part {
                length,
                inner: joint.inner_diameter.unwrap_or(body.inner),
                outer,
            },
        ],
        _ => vec![body],
    }
}

/// Pipe with tool joints as long as its weight asks for, where it is pipe, and they are not
/// longer than any.
fn equivalent(row: &SheetRow, body: Part, joints: usize, excess: f64) -> Option<(Vec<Part>, Made)> {
    if excess < SAME_WEIGHT || !row.kind.is_pipe() {
        return None;
    }
    let outer = (row.tool_joint.outer_diameter).unwrap_or(TOOL_JOINT * body.outer);
    let inner = row.tool_joint.inner_diameter.unwrap_or(body.inner);
    let joint = Part {
        length: 1.0,
        inner,
        outer,
    };
    let length = excess * body.area() * body.length / (joint.area() - body.area());
    let is_one = length > 0.0 && length <= LONGEST_TOOL_JOINT * body.length;
    is_one.then(|| {
        let parts = vec![
            Part {
                length: body.length - length,
                ..body
            },
            Part { length, ..joint },
        ];
        let made = Made::WithToolJoints {
            outer_diameter: outer,
            length,
            joints,
        };
        (parts, made)
    })
}

/// Refuses what is no tube of a string.
fn check(part: &Part) -> Result<(), String> {
    if part.inner >= part.outer {
        let [inner, outer] = [part.inner, part.outer].map(|diameter| diameter / INCH);
        return Err(format!(
            "an inner diameter of {inner:.3} in is not less than the outer of {outer:.3} in"
        ));
    }
    let numbers = [
        (TubeMeasure::Length, part.length, "the length of a joint"),
        (
            TubeMeasure::InnerRadius,
            0.5 * part.inner,
            "half the inner diameter",
        ),
        (
            TubeMeasure::OuterRadius,
            0.5 * part.outer,
            "half the outer diameter",
        ),
    ];
    for (measure, value, words) in numbers {
        let axis = Axis::String(StringAxis::Tube {
            section: 0,
            part: 0,
            measure,
        });
        axis.check(value)
            .map_err(|error| format!("{words}: {error}"))?;
    }
    Ok(())
}

/// Which part of a cell has the row's blades, and their outer diameter (m): its widest.
fn touching(row: &SheetRow, parts: &[Part]) -> Result<Option<(usize, f64)>, String> {
    let Some(blade) = row.blade_outer_diameter else {
        return Ok(None);
    };
    let widths = parts.iter().map(|part| part.outer).enumerate();
    let widest = widths.max_by(|(_, one), (_, other)| one.total_cmp(other));
    let narrower = widest.filter(|(_, width)| blade < *width);
    if let Some((_, width)) = narrower {
        let [blade, width] = [blade, width].map(|diameter| diameter / INCH);
        return Err(format!(
            "blades of {blade:.3} in are narrower than what they are on, {width:.3} in"
        ));
    }
    Ok(widest.map(|(part, _)| (part, blade)))
}

/// As it would stand under `[[string.sections]]`, where a part touches the wall with blades of an
/// outer diameter (m), if one does.
fn table(row: &SheetRow, joints: usize, parts: &[Part], touches: Option<(usize, f64)>) -> Value {
    let parts = parts.iter().enumerate().map(|(index, part)| {
        let blade = touches.filter(|(touching, _)| *touching == index);
        let radii = [
            ("inner_radius_m", Some(part.inner)),
            ("outer_radius_m", Some(part.outer)),
            ("contact_radius_m", blade.map(|(_, blade)| blade)),
        ];
        let radii = radii.into_iter().filter_map(|(key, diameter)| {
            let radius = Value::Float(0.5 * diameter?);
            Some((key.to_owned(), radius))
        });
        let length = ("length_m".to_owned(), Value::Float(part.length));
        Value::Table(std::iter::once(length).chain(radii).collect())
    });
    let mut section = Table::from_iter([
        ("repeat".to_owned(), Value::Integer(joints as i64)),
        ("parts".to_owned(), Value::Array(parts.collect())),
    ]);
    if !row.name.is_empty() {
        section.insert("name".to_owned(), Value::String(row.name.clone()));
    }
    Value::Table(section)
}

#[cfg(test)]
mod tests {
    use super::super::rows::ToolJoint;
    use super::*;

    fn pipe() -> SheetRow {
        SheetRow {
            line: 2,
            name: "Drillpipe".to_owned(),
            kind: ToolKind::Drillpipe,
            joints: Some(10),
            outer_diameter: 0.127,
            inner_diameter: 0.1086,
            blade_outer_diameter: None,
            length: 96.0,
            mass: None,
            tool_joint: ToolJoint::default(),
        }
    }

    fn mass_of(section: &Value) -> f64 {
        let parts = section["parts"].as_array().unwrap().iter();
        let mass = parts.map(|part| {
            let [length, inner, outer] = ["length_m", "inner_radius_m", "outer_radius_m"]
                .map(|key| part[key].as_float().unwrap());
            std::f64::consts::PI * (outer * outer - inner * inner) * length * 7850.0
        });
        mass.sum::<f64>() * section["repeat"].as_integer().unwrap() as f64
    }

    /// For any weight, the section has that weight, or that of its dimensions.
    #[test]
    fn a_section_weighs_what_its_row_does() {
        let plain = section(&pipe(), 7850.0).unwrap();
        assert_eq!((plain.1.made, plain.1.excess), (Made::AsGiven, None));
        let body = mass_of(&plain.0);
        for part in [1.1, 1.25, 1.4] {
            let row = SheetRow {
                mass: Some(part * body),
                ..pipe()
            };
            let (found, check) = section(&row, 7850.0).unwrap();
            assert!((mass_of(&found) / (part * body) - 1.0).abs() < 1e-12);
            assert!((check.excess.unwrap() - (part - 1.0)).abs() < 1e-12);
            assert!(matches!(
                check.made,
                Made::WithToolJoints { joints: 10, .. }
            ));
            assert_eq!(found["parts"].as_array().unwrap().len(), 2);
        }
        // Lighter than its body, far too heavy, or no pipe: as the dimensions say.
        for (name, part) in [("Drillpipe", 0.9), ("Drillpipe", 4.0), ("Collar", 1.2)] {
            let row = SheetRow {
                name: name.to_owned(),
                kind: ToolKind::of(name, ""),
                mass: Some(part * body),
                ..pipe()
            };
            let (found, check) = section(&row, 7850.0).unwrap();
            assert_eq!(check.made, Made::AsGiven, "{name} {part}");
            assert!((mass_of(&found) / body - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn rows_of_many_joints_are_divided_and_tool_joints_that_are_given_are_kept() {
        let row = SheetRow {
            joints: None,
            tool_joint: ToolJoint {
                outer_diameter: Some(0.168),
                inner_diameter: Some(0.095),
                length: Some(0.45),
            },
            ..pipe()
        };
        let (found, _) = section(&row, 7850.0).unwrap();
        assert_eq!(found["repeat"].as_integer(), Some(10));
        let joint = &found["parts"][1];
        assert_eq!(joint["length_m"].as_float(), Some(0.45));
        assert_eq!(joint["inner_radius_m"].as_float(), Some(0.0475));
    }

    #[test]
    fn blades_touch_where_a_joint_is_widest_and_weigh_nothing() {
        let row = SheetRow {
            mass: Some(3000.0),
            blade_outer_diameter: Some(0.2),
            ..pipe()
        };
        let (found, _) = section(&row, 7850.0).unwrap();
        let parts = found["parts"].as_array().unwrap();
        assert_eq!(parts.len(), 2);
        assert!(parts[0].get("contact_radius_m").is_none());
        assert_eq!(parts[1]["contact_radius_m"].as_float(), Some(0.1));
        assert!((mass_of(&found) / 3000.0 - 1.0).abs() < 1e-12);
        let narrow = SheetRow {
            blade_outer_diameter: Some(0.12),
            ..pipe()
        };
        let reason = section(&narrow, 7850.0).unwrap_err();
        let words = "2: blades of 4.724 in are narrower than what they are on, 5.000 in";
        assert_eq!(reason, words);
    }

    #[test]
    fn what_is_no_tube_is_refused_with_its_line() {
        let wide = SheetRow {
            inner_diameter: 0.2,
            ..pipe()
        };
        let reason = section(&wide, 7850.0).unwrap_err();
        assert!(
            reason.starts_with("2: an inner diameter of 7.874 in is not"),
            "{reason}"
        );
    }
}
