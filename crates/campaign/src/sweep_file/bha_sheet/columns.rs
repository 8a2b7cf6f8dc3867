//! What the columns of a sheet are called.

use crate::tables::{Columns, Dimension, Wanted};

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
    /// Length of one of them.
    JointLength,
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

/// The columns of a sheet.
pub type SheetColumns = Columns<Quantity>;

const fn text(quantity: Quantity, names: &'static [&'static str]) -> Wanted<Quantity> {
    Wanted {
        quantity,
        names,
        dimension: None,
        needed: None,
        assumed: None,
    }
}

const fn number(
    quantity: Quantity,
    names: &'static [&'static str],
    dimension: Dimension,
) -> Wanted<Quantity> {
    Wanted {
        dimension: Some(dimension),
        ..text(quantity, names)
    }
}

const fn needed(wanted: Wanted<Quantity>, words: &'static str) -> Wanted<Quantity> {
    Wanted {
        needed: Some(words),
        ..wanted
    }
}

const ELEMENT: [&str; 16] = [
    "element",
    "elements",
    "component",
    "components",
    "name",
    "item_name",
    "tool",
    "bha_component",
    "bha_element",
    "component_name",
    "component_type",
    "element_type",
    "equipment",
    "item_description",
    "tool_name",
    "section_type",
];
const SPECIFICATION: [&str; 8] = [
    "specification",
    "specifications",
    "description",
    "desc",
    "remarks",
    "comment",
    "comments",
    "type",
];
const JOINTS: [&str; 14] = [
    "joints",
    "count",
    "joint_count",
    "no_of_joints",
    "no_joints",
    "number_of_joints",
    "num_joints",
    "nr_of_joints",
    "num_of_joints",
    "qty",
    "quantity",
    "no_of_items",
    "pieces",
    "pcs",
];
const OUTER_DIAMETER: [&str; 10] = [
    "od",
    "outer_diameter",
    "outside_diameter",
    "body_od",
    "od_body",
    "pipe_od",
    "nominal_od",
    "ext_diameter",
    "external_diameter",
    "o_d",
];
const INNER_DIAMETER: [&str; 11] = [
    "id",
    "inner_diameter",
    "inside_diameter",
    "body_id",
    "id_body",
    "pipe_id",
    "nominal_id",
    "bore",
    "internal_diameter",
    "int_diameter",
    "i_d",
];
const BLADE: [&str; 10] = [
    "blade_od",
    "blade_outer_diameter",
    "blade_diameter",
    "gauge",
    "gauge_od",
    "gauge_diameter",
    "od_gauge",
    "gage",
    "gage_od",
    "od_blade",
];
const LENGTH: [&str; 2] = ["length", "section_length"];
const JOINT_LENGTH: [&str; 7] = [
    "joint_length",
    "length_per_joint",
    "length_of_joint",
    "length_of_one_joint",
    "length_each",
    "average_joint_length",
    "length_joint",
];
const MASS: [&str; 7] = [
    "weight",
    "mass",
    "weight_in_air",
    "air_weight",
    "weight_air",
    "mass_in_air",
    "dry_weight",
];
const LINEAR_MASS: [&str; 22] = [
    "weight",
    "mass",
    "",
    "unit_weight",
    "unit_mass",
    "linear_weight",
    "linear_mass",
    "nominal_weight",
    "adjusted_weight",
    "approximate_weight",
    "weight_in_air",
    "air_weight",
    "weight_per_length",
    "average_weight",
    "adjusted_mass",
    "approximate_mass",
    "average_mass",
    "nominal_mass",
    "mass_per_length",
    "weight_per_foot",
    "weight_per_meter",
    "weight_per_metre",
];

/// What a sheet may have.
pub const WANTED: [Wanted<Quantity>; 13] = [
    text(Quantity::Element, &ELEMENT),
    text(Quantity::Specification, &SPECIFICATION),
    text(Quantity::Joints, &JOINTS),
    needed(
        number(Quantity::OuterDiameter, &OUTER_DIAMETER, Dimension::Length),
        "an outer diameter, such as `od_in` or `OD (mm)`",
    ),
    needed(
        number(Quantity::InnerDiameter, &INNER_DIAMETER, Dimension::Length),
        "an inner diameter, such as `id_in` or `ID (mm)`",
    ),
    number(Quantity::BladeOuterDiameter, &BLADE, Dimension::Length),
    number(Quantity::Length, &LENGTH, Dimension::Length),
    number(Quantity::JointLength, &JOINT_LENGTH, Dimension::Length),
    number(Quantity::Mass, &MASS, Dimension::Mass),
    number(Quantity::LinearMass, &LINEAR_MASS, Dimension::LinearMass),
    number(
        Quantity::ToolJointOuterDiameter,
        &[
            "tool_joint_od",
            "tj_od",
            "tool_joint_outer_diameter",
            "od_tool_joint",
            "od_tj",
        ],
        Dimension::Length,
    ),
    number(
        Quantity::ToolJointInnerDiameter,
        &[
            "tool_joint_id",
            "tj_id",
            "tool_joint_inner_diameter",
            "id_tool_joint",
            "id_tj",
        ],
        Dimension::Length,
    ),
    number(
        Quantity::ToolJointLength,
        &[
            "tool_joint_length",
            "tj_length",
            "length_tool_joint",
            "length_tj",
        ],
        Dimension::Length,
    ),
];

/// What is said where a sheet has neither of its lengths.
pub const NO_LENGTH: &str = "there is no column with a length, such as `length_m` or `Length (ft)`, of all joints of a row \
     together, or `joint_length_m` of one";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::Heading;

    fn find(names: &[&str]) -> Result<SheetColumns, String> {
        let headings: Vec<Heading> = names.iter().map(|name| Heading::new(name)).collect();
        SheetColumns::find(&headings, &WANTED, &|_| true)
    }

    #[test]
    fn names_of_sheets_are_known_with_their_units() {
        for (name, quantity, factor) in [
            ("od_in", Quantity::OuterDiameter, 0.0254),
            ("OD (mm)", Quantity::OuterDiameter, 1e-3),
            ("O.D. [inch]", Quantity::OuterDiameter, 0.0254),
            ("OD (\")", Quantity::OuterDiameter, 0.0254),
            ("Length [ft]", Quantity::Length, 0.3048),
            ("Length (feet)", Quantity::Length, 0.3048),
            ("length_in", Quantity::Length, 0.0254),
            ("Joint length (m)", Quantity::JointLength, 1.0),
            ("weight_lbf", Quantity::Mass, 0.45359237),
            ("Weight (lbs)", Quantity::Mass, 0.45359237),
            ("Weight (kips)", Quantity::Mass, 453.59237),
            ("Weight, daN", Quantity::Mass, 1.0197162),
            ("Weight (tonnes)", Quantity::Mass, 1e3),
            ("Weight [kgs]", Quantity::Mass, 1.0),
            ("Weight, kN", Quantity::Mass, 101.97162),
            ("lb/ft", Quantity::LinearMass, 1.488163944),
            ("ppf", Quantity::LinearMass, 1.488163944),
            ("Weight (ppf)", Quantity::LinearMass, 1.488163944),
            ("Weight (lbs/ft)", Quantity::LinearMass, 1.488163944),
            ("Nom. weight (#/ft)", Quantity::LinearMass, 1.488163944),
            ("Mass kg/m", Quantity::LinearMass, 1.0),
            ("Lin. Wt (lb/ft)", Quantity::LinearMass, 1.488163944),
            ("Adj. Wt. (ppf)", Quantity::LinearMass, 1.488163944),
            ("Length (usft)", Quantity::Length, 1200.0 / 3937.0),
            ("Lgth. (m)", Quantity::Length, 1.0),
            ("Avg Jt Len (ft)", Quantity::JointLength, 0.3048),
            ("Jts", Quantity::Joints, 1.0),
            ("tool_joint_od_in", Quantity::ToolJointOuterDiameter, 0.0254),
            ("Blade OD (in)", Quantity::BladeOuterDiameter, 0.0254),
            ("Gauge (in)", Quantity::BladeOuterDiameter, 0.0254),
            ("blade_od_mm", Quantity::BladeOuterDiameter, 1e-3),
            ("Joints", Quantity::Joints, 1.0),
            ("No. of Joints", Quantity::Joints, 1.0),
            ("# Joints", Quantity::Joints, 1.0),
        ] {
            // What else a sheet needs, under names that this one does not have.
            let others = [
                ("outer diameter m", Quantity::OuterDiameter),
                ("inner diameter m", Quantity::InnerDiameter),
            ];
            let others = others.iter().filter(|(_, other)| *other != quantity);
            let names: Vec<&str> = std::iter::once(name)
                .chain(others.map(|(name, _)| *name))
                .collect();
            let found = find(&names).unwrap_or_else(|error| panic!("{name}: {error}"));
            let column = found
                .get(quantity)
                .unwrap_or_else(|| panic!("{name}: {found:?}"));
            assert!(
                (column.factor / factor - 1.0).abs() < 1e-7,
                "{name}: {}",
                column.factor
            );
        }
    }

    #[test]
    fn columns_are_not_guessed() {
        let missing = find(&["od_in", "length_m"]).unwrap_err();
        assert!(missing.contains("inner diameter"), "{missing}");
        let twice = find(&["od_in", "od_mm", "id_in", "length_m"]).unwrap_err();
        assert!(
            twice.contains("`od_in` and `od_mm` say the same"),
            "{twice}"
        );
        let found = find(&[
            "od_in",
            "id_in",
            "length_m",
            "thread",
            "cumulative_length_m",
            "Weight in mud (lbs)",
        ])
        .unwrap();
        assert_eq!(
            found.ignored,
            ["thread", "cumulative_length_m", "Weight in mud (lbs)"]
        );
    }

    /// They would be ignored, and the string would be another.
    #[test]
    fn units_that_are_not_known_are_refused_with_those_that_are() {
        for (name, words) in [
            (
                "Weight (stone)",
                "`Weight (stone)`: `stone` is not one of the known units: kg, lb, ",
            ),
            ("weight_stone", "`weight_stone`: `stone` is not one"),
            ("Weight (hp)", "or kg/m, lb/ft"),
            ("Weight", "`Weight` names no unit: kg, lb"),
            (
                "Length (yd)",
                "`yd` is not one of the known units: m, ft, in, mm, cm",
            ),
            ("OD", "`OD` names no unit: m, ft"),
        ] {
            let others = ["outer diameter m", "inner diameter m", "len m"];
            let refused = find(&[&others[..], &[name]].concat()).unwrap_err();
            assert!(refused.contains(words), "{name}: {refused}");
        }
    }
}
