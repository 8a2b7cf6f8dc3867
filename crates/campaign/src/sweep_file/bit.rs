//! `[bit]`: the keys of the torque law and of the rock.

use serde::{Deserialize, Serialize};

use super::number_or::is_zero;
use crate::quantities::RockConstant;

/// Torque at the bit: given, or from a rock and a weight on bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BitTable {
    /// T_d, N m.
    pub torque_dynamic_nm: Option<f64>,
    /// The rock that gives T_d from the weight on bit.
    pub rock: Option<RockName>,
    /// A rock's own law, with `rock = "law"`.
    pub law: Option<LawTable>,
    /// A rock's own table, with `rock = "table"`: rows of weight on bit (kN)
    /// and T_d (N m), both increasing.
    pub table_kn_nm: Option<Vec<(f64, f64)>>,
    /// Weight on bit, kN.
    pub weight_on_bit_kn: Option<f64>,
    /// T_s / T_d. Default 1.2.
    #[serde(default = "default_static_ratio")]
    pub torque_static_ratio: f64,
    /// Speed over which the torque falls from T_s to T_d, rpm. Default 0: at once.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub torque_decay_rpm: f64,
}

fn default_static_ratio() -> f64 {
    1.2
}

/// Where the law between weight on bit and torque comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RockName {
    /// Representative sandstone, built in.
    Sandstone,
    /// Representative shale, built in.
    Shale,
    /// `[bit.law]`.
    Law,
    /// `bit.table_kn_nm`.
    Table,
}

/// Cutting and contact parameters of a rock.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawTable {
    /// Radius of the bit, m.
    pub bit_radius_m: f64,
    /// Intrinsic specific energy ε, MPa.
    pub specific_energy_mpa: f64,
    /// Ratio ζ of the vertical to the horizontal cutting force.
    pub cutting_ratio: f64,
    /// μγ, friction at the wear flats.
    pub friction: f64,
    /// Contact strength σ, MPa.
    pub contact_strength_mpa: f64,
    /// Contact growth κ.
    pub contact_growth: f64,
    /// Wear-flat length ℓ, mm.
    pub wear_flat_mm: f64,
    /// Weight on bit beyond which cuttings are cleared poorly, kN.
    pub poor_cleaning_from_kn: Option<f64>,
    /// Torque per weight on bit beyond, N m per kN.
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
