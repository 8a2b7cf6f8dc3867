//! The rows of a sheet, in SI.

use super::columns::{Columns, Quantity};
use crate::hand_table::number;
use crate::sweep_file::cells::Cells;

/// A row of a sheet: some joints of one kind.
#[derive(Debug, Clone)]
pub struct Row {
    /// Its line.
    pub line: usize,
    /// What it is, as the sheet says.
    pub name: String,
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

/// Reads all rows.
///
/// # Errors
/// Which cell of which line is no number, or none.
pub fn rows_of(cells: &Cells, columns: &Columns) -> Result<Vec<Row>, String> {
    let rows = cells.rows.iter();
    rows.map(|(line, cells)| {
        let reader = RowReader { cells, columns };
        reader
            .row(*line)
            .map_err(|reason| format!("{line}: {reason}"))
    })
    .collect()
}

struct RowReader<'a> {
    cells: &'a [String],
    columns: &'a Columns,
}

impl RowReader<'_> {
    fn row(&self, line: usize) -> Result<Row, String> {
        let length = self.needed(Quantity::Length)?;
        let mass = self.given(Quantity::Mass)?;
        let linear_mass = self.given(Quantity::LinearMass)?;
        if mass.is_some() && linear_mass.is_some() {
            return Err("a mass and a mass per length: give one of them".to_owned());
        }
        Ok(Row {
            line,
            name: self.name(),
            joints: self.joints()?,
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

    fn text(&self, quantity: Quantity) -> &str {
        let column = self.columns.get(quantity);
        let cell = column.and_then(|column| self.cells.get(column.place));
        cell.map_or("", String::as_str)
    }

    /// Element and specification, each once.
    fn name(&self) -> String {
        let element = self.text(Quantity::Element);
        let specification = self.text(Quantity::Specification);
        match (element, specification) {
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
        let count = number(text)
            .ok()
            .filter(|count| *count >= 1.0 && count.fract() == 0.0);
        let message = || format!("joints: `{text}` is not a number of joints");
        count.map(|count| Some(count as usize)).ok_or_else(message)
    }

    /// A positive number, where the cell is not empty.
    fn given(&self, quantity: Quantity) -> Result<Option<f64>, String> {
        let Some(column) = self.columns.get(quantity) else {
            return Ok(None);
        };
        let text = self.text(quantity);
        if text.is_empty() {
            return Ok(None);
        }
        let name = &column.name;
        let value = number(text).map_err(|error| format!("{name}: {error}"))?;
        let may_be_zero = matches!(
            quantity,
            Quantity::InnerDiameter | Quantity::ToolJointInnerDiameter
        );
        if !(value.is_finite() && (value > 0.0 || may_be_zero && value == 0.0)) {
            return Err(format!("{name}: {value} is not a positive number"));
        }
        Ok(Some(column.factor * value))
    }

    fn needed(&self, quantity: Quantity) -> Result<f64, String> {
        let name = (self.columns.get(quantity)).map_or("", |column| column.name.as_str());
        let value = self.given(quantity)?;
        value.ok_or_else(|| format!("{name}: the cell is empty"))
    }
}
