//! `[string]`: the keys of the drillstring.

use serde::{Deserialize, Serialize};

use super::lateral::BendingTable;
use crate::quantities::TubeMeasure;

/// The drillstring: material, damping, sections from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StringTable {
    /// Shear modulus G, GPa.
    pub shear_modulus_gpa: f64,
    /// Density ρ, kg/m³.
    pub density_kg_m3: f64,
    /// Distributed torsional damping c_t, N m s/rad per metre of string.
    pub torsional_damping_nms_rad_m: f64,
    /// Bending constants, needed with a wall.
    pub bending: Option<BendingTable>,
    /// A BHA sheet, as CSV or a workbook, from which the sections come.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// In which order its rows are. Default `from-surface`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<RowOrder>,
    /// Sections from the surface down.
    pub sections: Vec<SectionTable>,
}

/// In which order the rows of a sheet are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RowOrder {
    /// From the surface down.
    FromSurface,
    /// From the bit up.
    FromBit,
}

/// Equal cells of pipe and joint, or of collar, one below the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionTable {
    /// What it is, for the reader.
    pub name: Option<String>,
    /// Number of cells.
    pub repeat: usize,
    /// The tubes of one cell, from the top down.
    pub parts: Vec<TubeTable>,
}

/// A uniform tube.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TubeTable {
    /// Length, m.
    pub length_m: f64,
    /// Internal radius, m.
    pub inner_radius_m: f64,
    /// External radius, m.
    pub outer_radius_m: f64,
    /// Radius with which it touches the wall, m, where that is not the external one: of the
    /// blades of a stabiliser, or of a wear band.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_radius_m: Option<f64>,
}

impl TubeTable {
    /// Radius with which it touches the wall, m.
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius_m.unwrap_or(self.outer_radius_m)
    }

    /// One of its measures.
    pub fn measure(&mut self, measure: TubeMeasure) -> &mut f64 {
        match measure {
            TubeMeasure::Length => &mut self.length_m,
            TubeMeasure::InnerRadius => &mut self.inner_radius_m,
            TubeMeasure::OuterRadius => &mut self.outer_radius_m,
        }
    }
}
