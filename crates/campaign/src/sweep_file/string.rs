//! `[string]`: the keys of the drillstring.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::lateral::BendingTable;
use super::number_or::is_zero;
use crate::quantities::TubeMeasure;

/// The drillstring: material, damping, sections from the surface down.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StringTable {
    /// Shear modulus G; steel has about 80.
    #[schemars(range(min = 0.1, max = 1000.0))]
    pub shear_modulus_gpa: f64,
    /// Density ρ; steel has 7850.
    #[schemars(range(min = 100.0, max = 30000.0))]
    pub density_kg_m3: f64,
    /// Torsional damping c_t of Eq. 1: drag on each metre of the turning string, the same at every
    /// frequency. `inspect` prints what it leaves of a wave. It may be left out, for none, where a
    /// `loss_factor` or the `viscosity_cp` of the mud is given.
    #[schemars(range(min = 0.0, max = 1e5))]
    #[serde(default)]
    pub torsional_damping_nms_rad_m: f64,
    /// Loss factor η of the material and of its joints: over 2π, the part of its energy that the
    /// string loses in a cycle, at any frequency. Steel by itself has 0.0001 to 0.0006, strings with
    /// joints more.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 0.2))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub loss_factor: f64,
    /// Constants of bending; needed with a wall.
    pub bending: Option<BendingTable>,
    /// Constants of axial motion, of a bit with `[bit.cutting]`; left out, by their defaults.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial: Option<AxialTable>,
    /// Instead of `sections`: a BHA sheet, a CSV file or a workbook in the folder of the file that
    /// names it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// In which order the rows of the sheet are. Left out, the names of its rows decide or,
    /// where they do not, it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<RowOrder>,
    /// Sections from the surface down, unless a sheet has them.
    pub sections: Vec<SectionTable>,
}

/// Constants of axial motion.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AxialTable {
    /// Young's modulus E. Left out, that of `[string.bending]` or, without one, 210.
    #[schemars(range(min = 0.1, max = 1000.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub youngs_modulus_gpa: Option<f64>,
    /// Axial damping c_a. Left out, the one by which axial vibration dies away as fast as
    /// `torsional_damping_nms_rad_m` lets torsion.
    #[schemars(range(min = 0.0, max = 1e7))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub damping_ns_m2: Option<f64>,
}

/// In which order the rows of a sheet are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RowOrder {
    /// From the surface down.
    FromSurface,
    /// From the bit up.
    FromBit,
}

/// Equal cells of pipe and joint, or of collar, one below the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SectionTable {
    /// What it is, for the reader.
    pub name: Option<String>,
    /// Number of cells.
    #[schemars(range(min = 1, max = 100_000))]
    pub repeat: usize,
    /// The tubes of a cell, from the top down: a pipe and its joint, or a plain collar.
    pub parts: Vec<TubeTable>,
}

/// A uniform tube.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TubeTable {
    /// Length.
    #[schemars(range(min = 0.001, max = 2e4))]
    pub length_m: f64,
    /// Internal radius.
    #[schemars(range(min = 0.0, max = 2.0))]
    pub inner_radius_m: f64,
    /// External radius, larger than the internal radius.
    #[schemars(range(min = 0.001, max = 2.0))]
    pub outer_radius_m: f64,
    /// Radius with which it touches a wall, no less than the external radius, which it is if
    /// left out: of the blades of a stabiliser, of a wear band. Neither mass nor stiffness
    /// change, but the clearance that a hole leaves, and R₀, with which the string turns on its
    /// wall.
    #[schemars(range(min = 0.001, max = 2.0))]
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
