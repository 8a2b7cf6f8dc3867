//! The rows of a sheet, in SI.

use super::columns::{Quantity, SheetColumns};
use super::kind::ToolKind;
use crate::tables::{self, Table};

/// A row of a sheet: some joints of one kind.
#[derive(Debug, Clone)]
pub struct SheetRow {
    /// Its line.
    pub line: usize,
    /// What it is, as the sheet says.
    pub name: String,
    /// What that says it is.
    pub kind: ToolKind,
    /// How many joints, where it says that.
    pub joints: Option<usize>,
    /// Outer diameter, m.
    pub outer_diameter: f64,
    /// Inner diameter, m.
    pub inner_diameter: f64,
    /// Outer diameter of what touches the wall, m, where it says that.
    pub blade_outer_diameter: Option<f64>,
    /// Length of all together, m.
    pub length: f64,
    /// Mass of all together, kg, where it says that.
    pub mass: Option<f64>,
    /// A tool joint, pin and box together, as far as it is given: diameters and length, m.
    pub tool_joint: ToolJoint,
}

/// What a sheet says of a tool joint, m.
#[derive(Debug, Clone, Copy, Default)]
pub struct ToolJoint {
    /// Outer diameter.
    pub outer_diameter: Option<f64>,
    /// Inner diameter.
    pub inner_diameter: Option<f64>,
    /// Length of pin and box.
    pub length: Option<f64>,
}

/// Reads all rows but those of totals, whose lines are listed separately.
///
/// # Errors
/// Which cell of which line is no number, or none.
pub fn rows_of(
    table: &Table,
    columns: &SheetColumns,
) -> Result<(Vec<SheetRow>, Vec<usize>), String> {
    let readers = table.rows.iter().map(|row| RowReader { row, columns });
    let (totals, rows): (Vec<_>, Vec<_>) = readers.partition(RowReader::is_total);
    let rows = rows.iter().map(|reader| {
        let line = reader.row.line;
        reader.row().map_err(|reason| format!("{line}: {reason}"))
    });
    let totals = totals.iter().map(|reader| reader.row.line).collect();
    Ok((rows.collect::<Result<_, _>>()?, totals))
}

/// No length of several joints together, m: it is that of one.
const ONE_JOINT: std::ops::Range<f64> = 5.5..15.5;

struct RowReader<'a> {
    row: &'a tables::Row,
    columns: &'a SheetColumns,
}

impl RowReader<'_> {
    /// Whether it adds up others: it has no diameters, and says so or says nothing.
    fn is_total(&self) -> bool {
        let is_empty = |quantity| {
            let column = self.columns.get(quantity);
            column.is_none_or(|column| self.row.is_empty_at(column.place))
        };
        let name = self.name().to_lowercase();
        let says_so = name.is_empty() || name.contains("total") || name.starts_with("sum");
        is_empty(Quantity::OuterDiameter) && is_empty(Quantity::InnerDiameter) && says_so
    }

    fn row(&self) -> Result<SheetRow, String> {
        let joints = self.joints()?;
        let length = self.length(joints)?;
        let mass = self.given(Quantity::Mass)?;
        let linear_mass = self.given(Quantity::LinearMass)?;
        if mass.is_some() && linear_mass.is_some() {
            return Err("a mass and a mass per length: give one of them".to_owned());
        }
        Ok(SheetRow {
            line: self.row.line,
            name: self.name(),
            kind: ToolKind::of(
                &self.text(Quantity::Element),
                &self.text(Quantity::Specification),
            ),
            joints,
            outer_diameter: self.needed(Quantity::OuterDiameter)?,
            inner_diameter: self.needed(Quantity::InnerDiameter)?,
            blade_outer_diameter: self.given(Quantity::BladeOuterDiameter)?,
            length,
            mass: mass.or(linear_mass.map(|linear| linear * length)),
            tool_joint: ToolJoint {
                outer_diameter: self.given(Quantity::ToolJointOuterDiameter)?,
                inner_diameter: self.given(Quantity::ToolJointInnerDiameter)?,
                length: self.given(Quantity::ToolJointLength)?,
            },
        })
    }

    /// Of all joints together.
    fn length(&self, joints: Option<usize>) -> Result<f64, String> {
        let of_all = self.given(Quantity::Length)?;
        let of_one = self.given(Quantity::JointLength)?;
        match (of_all, of_one, joints) {
            (Some(_), Some(_), _) => {
                Err("a length of all joints together and one of each: give one of them".to_owned())
            }
            (None, Some(one), joints) => Ok(one * joints.unwrap_or(1) as f64),
            (Some(all), None, Some(joints)) if joints > 1 && ONE_JOINT.contains(&all) => {
                let each = all / joints as f64;
                Err(format!(
                    "{joints} joints in {all:.2} m are {each:.2} m each: is that the length of one? a \
                     length is that of all joints of a row together, and `joint_length_m` that of one"
                ))
            }
            (Some(all), None, _) => Ok(all),
            (None, None, _) => {
                self.needed(Quantity::Length)?;
                self.needed(Quantity::JointLength)
            }
        }
    }

    fn text(&self, quantity: Quantity) -> String {
        let column = self.columns.get(quantity);
        column.map_or_else(String::new, |column| self.row.text(column.place))
    }

    /// Element and specification, each once.
    fn name(&self) -> String {
        let element = self.text(Quantity::Element);
        let specification = self.text(Quantity::Specification);
        match (element.as_str(), specification.as_str()) {
            ("", specification) => specification.to_owned(),
            (element, specification) if specification.is_empty() || specification == element => {
                element.to_owned()
            }
            (element, specification) => format!("{element}: {specification}"),
        }
    }

    fn joints(&self) -> Result<Option<usize>, String> {
        let text = self.text(Quantity::Joints);
        if text.is_empty() {
            return Ok(None);
        }
        let number =
            (self.columns.get(Quantity::Joints)).map(|column| self.row.number(column.place));
        let count = number
            .and_then(Result::ok)
            .filter(|count| *count >= 1.0 && count.fract() == 0.0);
        let message = || format!("joints: `{text}` is not a number of joints");
        count.map(|count| Some(count as usize)).ok_or_else(message)
    }

    /// A positive number, where the cell is not empty.
    fn given(&self, quantity: Quantity) -> Result<Option<f64>, String> {
        let Some(column) = self.columns.get(quantity) else {
            return Ok(None);
        };
        if self.row.is_empty_at(column.place) {
            return Ok(None);
        }
        let value = self.columns.number(self.row, quantity)?;
        let may_be_zero = matches!(
            quantity,
            Quantity::InnerDiameter | Quantity::ToolJointInnerDiameter
        );
        if !(value.is_finite() && (value > 0.0 || may_be_zero && value == 0.0)) {
            let message = format!("{} is not a positive number", self.text(quantity));
            return Err(self.columns.named(quantity, &message));
        }
        Ok(Some(value))
    }

    fn needed(&self, quantity: Quantity) -> Result<f64, String> {
        let value = self.given(quantity)?;
        let empty = || self.columns.named(quantity, "the cell is empty");
        value.ok_or_else(empty)
    }
}
