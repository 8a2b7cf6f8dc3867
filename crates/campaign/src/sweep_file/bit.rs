//! `[bit]`: the keys of the torque law and of the rock.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number_or::is_zero;
use crate::quantities::RockConstant;

/// Torque at the bit: given, or from a rock and a weight on bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BitTable {
    /// Dynamic torque T_d.
    #[schemars(range(min = 0.0, max = 1e7))]
    pub torque_dynamic_nm: Option<f64>,
    /// What gives T_d from the weight on bit.
    pub rock: Option<RockName>,
    /// The law of a rock, with `rock = "law"`.
    pub law: Option<LawTable>,
    /// The table of a rock, with `rock = "table"`: weight on bit and T_d, both increasing;
    /// straight lines between. Outside, there is no answer.
    pub table_kn_nm: Option<Vec<(f64, f64)>>,
    /// Weight on bit W.
    #[schemars(range(min = 0.0, max = 2000.0))]
    pub weight_on_bit_kn: Option<f64>,
    /// Static by dynamic torque, T_s/T_d.
    #[schemars(range(min = 1.0, max = 10.0))]
    #[serde(default = "default_static_ratio")]
    pub torque_static_ratio: f64,
    /// The speed over which the torque falls from T_s to T_d (Stribeck): at ω, T_d + (T_s −
    /// T_d) exp(−ω/ω_c). With 0 it falls at once, as in the paper.
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e4))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub torque_decay_rpm: f64,
    /// The blades, where each cuts what the one before has left: the string then moves along its
    /// axis, too, and torque, weight on bit and rate of penetration are what comes out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cutting: Option<CuttingTable>,
}

/// The blades of a bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CuttingTable {
    /// Number of blades, evenly spaced.
    #[schemars(range(min = 1, max = 20))]
    #[serde(default = "default_blades")]
    pub blades: usize,
    /// Instead: the angle from each blade to the next, 360° together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub blade_angles_deg: Option<Vec<f64>>,
    /// Angle of relief behind the cutters: the bit advances no more per angle than that lets it.
    #[schemars(range(min = 0.5, max = 60.0))]
    #[serde(default = "default_relief")]
    pub relief_deg: f64,
    /// When the wear flats carry weight.
    #[serde(default)]
    pub contact: ContactName,
    /// With `start = "smooth"`: a torque on the bit for `kick_s`, instead of `start_disturbance`.
    #[schemars(range(min = -1e7, max = 1e7))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kick_nm: Option<f64>,
    /// The same as a force on the bit, down.
    #[schemars(range(min = -2000.0, max = 2000.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kick_kn: Option<f64>,
    /// How long it lasts.
    #[schemars(range(min = 0.001, max = 1000.0))]
    #[serde(default = "default_kick")]
    pub kick_s: f64,
}

/// When the wear flats carry weight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ContactName {
    /// As the depth of cut grows, by the contact growth of the rock.
    #[default]
    Grows,
    /// All that they can, as soon as the bit goes down.
    AtOnce,
}

fn default_blades() -> usize {
    6
}

fn default_relief() -> f64 {
    15.0
}

fn default_kick() -> f64 {
    1.0
}

fn default_static_ratio() -> f64 {
    1.2
}

/// Where the law between weight on bit and torque comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum RockName {
    /// Representative sandstone, for a bit of 0.15 m radius.
    Sandstone,
    /// Representative shale, for a bit of 0.15 m radius.
    Shale,
    /// The law of `[bit.law]`.
    Law,
    /// The table `table_kn_nm`.
    Table,
}

/// Cutting and contact parameters of a rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LawTable {
    /// Radius of the bit, a.
    #[schemars(range(min = 0.001, max = 2.0))]
    pub bit_radius_m: f64,
    /// Intrinsic specific energy ε.
    #[schemars(range(min = 0.1, max = 1e4))]
    pub specific_energy_mpa: f64,
    /// Ratio ζ of the vertical to the horizontal cutting force.
    #[schemars(range(min = 0.01, max = 10.0))]
    pub cutting_ratio: f64,
    /// Friction at the wear flats, μγ.
    #[schemars(range(min = 0.0, max = 10.0))]
    pub friction: f64,
    /// Contact strength σ.
    #[schemars(range(min = 0.1, max = 1e4))]
    pub contact_strength_mpa: f64,
    /// Contact growth κ.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub contact_growth: f64,
    /// Wear-flat length ℓ.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub wear_flat_mm: f64,
    /// Weight on bit beyond which cuttings are cleared poorly.
    #[schemars(range(min = 0.001, max = 1e5))]
    pub poor_cleaning_from_kn: Option<f64>,
    /// Torque per weight on bit beyond it.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub poor_cleaning_nm_per_kn: Option<f64>,
}

impl LawTable {
    /// The place of a constant; of poor cleaning there is none where that is not modelled.
    pub fn constant(&mut self, constant: RockConstant) -> Option<&mut f64> {
        match constant {
            RockConstant::BitRadius => Some(&mut self.bit_radius_m),
            RockConstant::SpecificEnergy => Some(&mut self.specific_energy_mpa),
            RockConstant::CuttingRatio => Some(&mut self.cutting_ratio),
            RockConstant::Friction => Some(&mut self.friction),
            RockConstant::ContactStrength => Some(&mut self.contact_strength_mpa),
            RockConstant::ContactGrowth => Some(&mut self.contact_growth),
            RockConstant::WearFlat => Some(&mut self.wear_flat_mm),
            RockConstant::PoorCleaningFrom => self.poor_cleaning_from_kn.as_mut(),
            RockConstant::PoorCleaningSlope => self.poor_cleaning_nm_per_kn.as_mut(),
        }
    }
}
