//! The keys of lateral motion: bending, the borehole wall at the sites, disturbances.

use serde::{Deserialize, Serialize};

use super::number_or::is_default;
use crate::quantities::WallQuantity;

/// Bending constants of the string, `[string.bending]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BendingTable {
    /// Young's modulus E, GPa.
    pub youngs_modulus_gpa: f64,
    /// Distributed lateral damping c_b, N s/m per metre of string.
    pub damping_ns_m2: f64,
    /// Pre-compression C, kN; tension where negative. Default 0.
    #[serde(default)]
    pub compression_kn: f64,
    /// How the surface holds the string laterally. Default `free`.
    #[serde(default)]
    pub surface: SupportName,
}

/// How the surface holds the string laterally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SupportName {
    /// Not at all.
    #[default]
    Free,
    /// No displacement.
    Pinned,
    /// No displacement and no slope.
    Clamped,
}

/// The borehole wall, at every site that does not say otherwise, and where there are sites.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct WallTable {
    /// Clearance between string and wall, mm.
    pub clearance_mm: Option<f64>,
    /// What decides the clearance instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearance: Option<ClearanceName>,
    /// Hertzian stiffness k_c in GN/m^(3/2); left out, the wall is rigid.
    pub stiffness_gn_m15: Option<f64>,
    /// Coefficient of friction μ₀, static where it falls, unless an axis gives it.
    pub friction: Option<f64>,
    /// Dynamic coefficient in parts of the static one; left out, friction does not fall.
    pub friction_dynamic_ratio: Option<f64>,
    /// Stribeck speed of sliding, over which friction falls, m/s; left out, it falls with the
    /// first slip.
    pub friction_stribeck_m_s: Option<f64>,
    /// Where the wall may be touched. Default `given`.
    #[serde(skip_serializing_if = "is_default")]
    pub sites: SitesName,
    /// Distance between candidate sites, m; left out, they are where the string is wide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_every_m: Option<f64>,
    /// How far up from the bit there are candidate sites, m; left out, to the surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_to_m: Option<f64>,
    /// Where sites are found: how far the string may go beyond the wall between them, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_tolerance_mm: Option<f64>,
    /// Where sites are found: how often a case is run again at most.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_rounds: Option<usize>,
}

/// What decides the clearance, where the file does not give it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClearanceName {
    /// How wide the hole is, and the string in it.
    Hole,
}

/// Where the wall may be touched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SitesName {
    /// At the sites of the file.
    #[default]
    Given,
    /// At every candidate besides.
    All,
    /// Where a case is found to go through its wall, besides.
    Auto,
}

impl WallTable {
    /// What it says of a quantity.
    pub fn value(&self, quantity: WallQuantity) -> Option<f64> {
        match quantity {
            WallQuantity::Clearance => self.clearance_mm,
            WallQuantity::Stiffness => self.stiffness_gn_m15,
            WallQuantity::Friction => self.friction,
            WallQuantity::DynamicRatio => self.friction_dynamic_ratio,
            WallQuantity::StribeckSpeed => self.friction_stribeck_m_s,
        }
    }
}

/// A lateral impulse at a site.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ImpulseTable {
    /// Which site, by its distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Its amount, N s.
    pub amount_ns: Option<f64>,
    /// Its amount in multiples of I₀, which just brings the site to the wall.
    pub ratio: Option<f64>,
    /// When it begins, s. Default 1.
    #[serde(default = "default_start")]
    pub start_s: f64,
    /// How long it lasts, s. Default 0.02.
    #[serde(default = "default_duration")]
    pub duration_s: f64,
    /// Its direction from the x axis, degrees. Default 0.
    #[serde(default)]
    pub direction_deg: f64,
}

fn default_start() -> f64 {
    1.0
}

fn default_duration() -> f64 {
    0.02
}

/// An eccentric mass at a site.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EccentricMassTable {
    /// Which site, by its distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Mass m_e, kg.
    pub mass_kg: f64,
    /// Offset d from the string's centre, m.
    pub offset_m: f64,
}

/// A place on the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SiteTable {
    /// Distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Clearance here, mm, instead of the wall's.
    pub clearance_mm: Option<f64>,
    /// Contact stiffness here, GN/m^(3/2), instead of the wall's.
    pub stiffness_gn_m15: Option<f64>,
    /// Friction here, instead of the wall's, unless an axis gives it.
    pub friction: Option<f64>,
    /// Dynamic over static coefficient here, instead of the wall's.
    pub friction_dynamic_ratio: Option<f64>,
    /// Stribeck speed of sliding here, m/s, instead of the wall's.
    pub friction_stribeck_m_s: Option<f64>,
}

impl SiteTable {
    /// A place (m from the bit) whose wall is that of all sites.
    pub fn at(distance_from_bit_m: f64) -> Self {
        Self {
            distance_from_bit_m,
            clearance_mm: None,
            stiffness_gn_m15: None,
            friction: None,
            friction_dynamic_ratio: None,
            friction_stribeck_m_s: None,
        }
    }

    /// What it says of the wall here.
    pub fn value(&self, quantity: WallQuantity) -> Option<f64> {
        match quantity {
            WallQuantity::Clearance => self.clearance_mm,
            WallQuantity::Stiffness => self.stiffness_gn_m15,
            WallQuantity::Friction => self.friction,
            WallQuantity::DynamicRatio => self.friction_dynamic_ratio,
            WallQuantity::StribeckSpeed => self.friction_stribeck_m_s,
        }
    }
}
