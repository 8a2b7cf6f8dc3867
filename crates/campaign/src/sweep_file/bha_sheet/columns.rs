//! What the columns of a sheet are, by their names: a quantity and its unit.

use crate::quantities::{FOOT, INCH, POUND, POUND_FORCE};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// What the row is.
    Element,
    /// What else is said of it.
    Specification,
    /// How many joints the row has.
    Joints,
    /// Outer diameter.
    OuterDiameter,
    /// Inner diameter.
    InnerDiameter,
    /// Outer diameter of what touches the wall: the blades of a stabiliser, a wear band.
    BladeOuterDiameter,
    /// Length of all joints together.
    Length,
    /// Mass of all joints together, or their weight in air.
    Mass,
    /// Mass, or weight in air, per length.
    LinearMass,
    /// Of a tool joint, pin and box together: outer diameter.
    ToolJointOuterDiameter,
    /// Its inner diameter.
    ToolJointInnerDiameter,
    /// Its length.
    ToolJointLength,
}

/// Names of quantities without a unit.
const PLAIN: [(Quantity, &[&str]); 3] = [
    (Quantity::Element, &["element", "component", "name"]),
    (Quantity::Specification, &["specification", "description"]),
    (Quantity::Joints, &["joints", "count"]),
];

/// A unit and what numbers in it are multiplied by.
type Unit = (&'static str, f64);

/// Names of quantities, each to be followed by a unit, and their units.
const WITH_UNIT: [(Quantity, &[&str], &[Unit]); 9] = [
    (
        Quantity::OuterDiameter,
        &["od", "outer_diameter"],
        &DIAMETERS,
    ),
    (
        Quantity::InnerDiameter,
        &["id", "inner_diameter"],
        &DIAMETERS,
    ),
    (
        Quantity::BladeOuterDiameter,
        &["blade_od", "blade_outer_diameter"],
        &DIAMETERS,
    ),
    (Quantity::Length, &["length"], &LENGTHS),
    (Quantity::Mass, &["weight", "mass"], &MASSES),
    (
        Quantity::LinearMass,
        &["weight", "mass", ""],
        &LINEAR_MASSES,
    ),
    (
        Quantity::ToolJointOuterDiameter,
        &["tool_joint_od", "tj_od"],
        &DIAMETERS,
    ),
    (
        Quantity::ToolJointInnerDiameter,
        &["tool_joint_id", "tj_id"],
        &DIAMETERS,
    ),
    (
        Quantity::ToolJointLength,
        &["tool_joint_length", "tj_length"],
        &TOOL_JOINT_LENGTHS,
    ),
];

const DIAMETERS: [Unit; 3] = [("in", INCH), ("mm", 1e-3), ("m", 1.0)];
const LENGTHS: [Unit; 2] = [("m", 1.0), ("ft", FOOT)];
const TOOL_JOINT_LENGTHS: [Unit; 4] = [("m", 1.0), ("ft", FOOT), ("in", INCH), ("mm", 1e-3)];

/// Standard acceleration of free fall, by which a weight has a mass, m/s².
const GRAVITY: f64 = 9.806_65;

const MASSES: [Unit; 7] = [
    ("kg", 1.0),
    ("lb", POUND),
    ("t", 1e3),
    ("lbf", POUND_FORCE / GRAVITY),
    ("klbf", 1e3 * POUND_FORCE / GRAVITY),
    ("kn", 1e3 / GRAVITY),
    ("n", 1.0 / GRAVITY),
];
const LINEAR_MASSES: [Unit; 5] = [
    ("kg_per_m", 1.0),
    ("lb_per_ft", POUND / FOOT),
    ("lbf_per_ft", POUND / FOOT),
    ("kg_m", 1.0),
    ("lb_ft", POUND / FOOT),
];

/// A column that is read.
#[derive(Debug, Clone)]
pub struct Column {
    /// What it holds.
    pub quantity: Quantity,
    /// Its place.
    pub place: usize,
    /// Its name, as the sheet has it.
    pub name: String,
    /// What its numbers are multiplied by, to SI.
    pub factor: f64,
}

/// The columns of a sheet.
#[derive(Debug, Clone)]
pub struct Columns {
    known: Vec<Column>,
    /// Names of the others.
    pub passed_over: Vec<String>,
}

impl Columns {
    /// By the header of a sheet.
    ///
    /// # Errors
    /// Where one that is needed is missing, or there twice.
    pub fn find(header: &[String]) -> Result<Self, String> {
        let mut columns = Self {
            known: Vec::new(),
            passed_over: Vec::new(),
        };
        for (place, name) in header.iter().enumerate() {
            let Some((quantity, factor)) = meaning(name) else {
                if !name.is_empty() {
                    columns.passed_over.push(name.clone());
                }
                continue;
            };
            if let Some(other) = columns.get(quantity) {
                let other = &other.name;
                return Err(format!("the columns `{other}` and `{name}` say the same"));
            }
            columns.known.push(Column {
                quantity,
                place,
                name: name.clone(),
                factor,
            });
        }
        let needed = [
            (
                Quantity::OuterDiameter,
                "an outer diameter, such as `od_in` or `od_mm`",
            ),
            (
                Quantity::InnerDiameter,
                "an inner diameter, such as `id_in` or `id_mm`",
            ),
            (
                Quantity::Length,
                "a length, such as `length_m` or `length_ft`",
            ),
        ];
        for (quantity, words) in needed {
            if columns.get(quantity).is_none() {
                return Err(format!("there is no column with {words}"));
            }
        }
        Ok(columns)
    }

    /// The column of a quantity, where there is one.
    pub fn get(&self, quantity: Quantity) -> Option<&Column> {
        self.known.iter().find(|column| column.quantity == quantity)
    }
}

/// What a name says, and the factor of its unit; `None` where it says nothing here.
fn meaning(name: &str) -> Option<(Quantity, f64)> {
    // "OD (in)", "Length [m]", "lb/ft".
    let plain = name.to_lowercase().replace('/', "_per_");
    let words = plain.split(|letter: char| !letter.is_alphanumeric());
    let plain = words
        .filter(|word| !word.is_empty())
        .collect::<Vec<_>>()
        .join("_");
    let named = PLAIN
        .iter()
        .find(|(_, names)| names.contains(&plain.as_str()));
    if let Some((quantity, _)) = named {
        return Some((*quantity, 1.0));
    }
    WITH_UNIT.iter().find_map(|(quantity, names, units)| {
        let is_so = |stem: &str, unit: &str| match stem {
            "" => plain == unit,
            stem => {
                plain
                    .strip_prefix(stem)
                    .and_then(|rest| rest.strip_prefix('_'))
                    == Some(unit)
            }
        };
        let unit = units
            .iter()
            .find(|(unit, _)| names.iter().any(|stem| is_so(stem, unit)));
        unit.map(|(_, factor)| (*quantity, *factor))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_sheets_are_known_with_their_units() {
        for (name, quantity, factor) in [
            ("od_in", Quantity::OuterDiameter, 0.0254),
            ("OD (mm)", Quantity::OuterDiameter, 1e-3),
            ("Length [ft]", Quantity::Length, 0.3048),
            ("weight_lbf", Quantity::Mass, 0.45359237),
            ("Weight, kN", Quantity::Mass, 101.97162),
            ("lb/ft", Quantity::LinearMass, 1.488163944),
            ("Mass kg/m", Quantity::LinearMass, 1.0),
            ("tool_joint_od_in", Quantity::ToolJointOuterDiameter, 0.0254),
            ("Blade OD (in)", Quantity::BladeOuterDiameter, 0.0254),
            ("blade_od_mm", Quantity::BladeOuterDiameter, 1e-3),
            ("Joints", Quantity::Joints, 1.0),
        ] {
            let (found, found_factor) = meaning(name).expect(name);
            assert_eq!(found, quantity, "{name}");
            assert!((found_factor / factor - 1.0).abs() < 1e-7, "{name}");
        }
        for name in ["", "od", "thread", "length_in", "cumulative_length_m"] {
            assert!(meaning(name).is_none(), "{name}");
        }
    }

    #[test]
    fn columns_are_not_guessed() {
        let find = |names: &[&str]| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            Columns::find(&names)
        };
        let missing = find(&["od_in", "length_m"]).unwrap_err();
        assert!(missing.contains("inner diameter"), "{missing}");
        let twice = find(&["od_in", "od_mm", "id_in", "length_m"]).unwrap_err();
        assert!(
            twice.contains("`od_in` and `od_mm` say the same"),
            "{twice}"
        );
        let found = find(&["od_in", "id_in", "length_m", "thread"]).unwrap();
        assert_eq!(found.passed_over, ["thread"]);
    }
}
