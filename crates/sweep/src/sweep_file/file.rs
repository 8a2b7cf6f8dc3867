//! The keys of a sweep file. Every key carries its unit in its name; what is
//! optional says what happens without it.

use std::collections::BTreeMap;
use std::fmt;
use std::path::PathBuf;

use linear::method::{FiniteElement, Transform};
use serde::{Deserialize, Deserializer, Serialize};

use super::accuracy::Accuracy;
use super::lateral::{BendingTable, EccentricMassTable, ImpulseTable, WallTable};
use super::source::{Source, SweepFileError};
use crate::quantities::Axis;

/// A sweep file, its bases merged in, as it is written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileContent {
    /// One line for pictures and reports; by default the file's name.
    #[serde(default)]
    pub title: Option<String>,
    /// The drillstring.
    pub string: StringTable,
    /// Surface speed from t = 0 on, unless an axis gives it.
    #[serde(default)]
    pub surface_speed_rpm: Option<f64>,
    /// Torque at the bit; without it the bit is free.
    #[serde(default)]
    pub bit: Option<BitTable>,
    /// Places on the string: with a wall, where it may touch; else, besides the
    /// bit, where it is looked at.
    #[serde(default)]
    pub sites: Vec<SiteTable>,
    /// The borehole wall; without it lateral motion is not modelled.
    #[serde(default)]
    pub wall: Option<WallTable>,
    /// Lateral impulses.
    #[serde(default)]
    pub impulses: Vec<ImpulseTable>,
    /// Eccentric masses.
    #[serde(default)]
    pub eccentric_masses: Vec<EccentricMassTable>,
    /// Largest error wanted, instead of methods and a sampling frequency: the
    /// cheapest that deliver it are chosen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Linear methods, in the order of the results. Default: `quadrature`.
    #[serde(default = "default_methods")]
    pub methods: Vec<MethodName>,
    /// Parameters of the methods.
    #[serde(default)]
    pub method: MethodTables,
    /// Sampling frequency; `"auto"` (default) is four times the first torsional
    /// mode of one cell of the drillpipe.
    #[serde(default)]
    pub sampling_frequency_hz: AutoOr,
    /// Time simulated; `"auto"` (default) lets every case run until its regime
    /// can be told.
    #[serde(default)]
    pub time_s: AutoOr,
    /// The cases; without it there is one.
    #[serde(default)]
    pub design: Option<DesignTable>,
    /// How the regime map is drawn.
    #[serde(default)]
    pub map: MapTable,
}

fn default_methods() -> Vec<MethodName> {
    vec![MethodName::Quadrature]
}

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
    #[serde(default)]
    pub bending: Option<BendingTable>,
    /// Sections from the surface down.
    pub sections: Vec<SectionTable>,
}

/// Equal cells of pipe and joint, or of collar, one below the other.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SectionTable {
    /// What it is, for the reader.
    #[serde(default)]
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
}

/// Torque at the bit: given, or from a rock and a weight on bit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BitTable {
    /// T_d, N m.
    #[serde(default)]
    pub torque_dynamic_nm: Option<f64>,
    /// The rock that gives T_d from the weight on bit.
    #[serde(default)]
    pub rock: Option<RockName>,
    /// A rock's own law, with `rock = "law"`.
    #[serde(default)]
    pub law: Option<LawTable>,
    /// A rock's own table, with `rock = "table"`: rows of weight on bit (kN)
    /// and T_d (N m), both increasing.
    #[serde(default)]
    pub table_kn_nm: Option<Vec<(f64, f64)>>,
    /// Weight on bit, kN.
    #[serde(default)]
    pub weight_on_bit_kn: Option<f64>,
    /// T_s / T_d. Default 1.2.
    #[serde(default = "default_static_ratio")]
    pub torque_static_ratio: f64,
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
    #[serde(default)]
    pub poor_cleaning_from_kn: Option<f64>,
    /// Torque per weight on bit beyond, N m per kN.
    #[serde(default)]
    pub poor_cleaning_nm_per_kn: Option<f64>,
}

/// A place on the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SiteTable {
    /// Distance from the bit, m.
    pub distance_from_bit_m: f64,
    /// Clearance here, mm, instead of the wall's.
    #[serde(default)]
    pub clearance_mm: Option<f64>,
    /// Contact stiffness here, GN/m^(3/2), instead of the wall's.
    #[serde(default)]
    pub stiffness_gn_m15: Option<f64>,
    /// Friction here, instead of the wall's; an axis changes it everywhere.
    #[serde(default)]
    pub friction: Option<f64>,
}

/// A linear method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MethodName {
    /// The paper's digital filter.
    Hilbert,
    /// Convolution quadrature, BDF2.
    Quadrature,
    /// Finite elements, Newmark.
    FiniteElement,
    /// Plain inverse DFT, which fails.
    DirectIdft,
    /// Convolution quadrature, trapezoidal rule, which fails.
    Trapezoidal,
}

impl MethodName {
    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            MethodName::Hilbert => "hilbert",
            MethodName::Quadrature => "quadrature",
            MethodName::FiniteElement => "finite-element",
            MethodName::DirectIdft => "direct-idft",
            MethodName::Trapezoidal => "trapezoidal",
        }
    }
}

/// Parameters of the methods, one table each.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct MethodTables {
    /// `[method.hilbert]`
    pub hilbert: Transform,
    /// `[method.direct-idft]`
    pub direct_idft: Transform,
    /// `[method.finite-element]`
    pub finite_element: FiniteElement,
}

/// A number, or `"auto"`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum AutoOr {
    /// By rule.
    #[default]
    Auto,
    /// As given.
    Given(f64),
}

impl Serialize for AutoOr {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            AutoOr::Auto => serializer.serialize_str("auto"),
            AutoOr::Given(value) => serializer.serialize_f64(*value),
        }
    }
}

impl<'de> Deserialize<'de> for AutoOr {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl serde::de::Visitor<'_> for Visitor {
            type Value = AutoOr;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number or \"auto\"")
            }
            fn visit_str<E: serde::de::Error>(self, text: &str) -> Result<AutoOr, E> {
                match text {
                    "auto" => Ok(AutoOr::Auto),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(text), &self)),
                }
            }
            fn visit_f64<E>(self, value: f64) -> Result<AutoOr, E> {
                Ok(AutoOr::Given(value))
            }
            fn visit_i64<E>(self, value: i64) -> Result<AutoOr, E> {
                Ok(AutoOr::Given(value as f64))
            }
            fn visit_u64<E>(self, value: u64) -> Result<AutoOr, E> {
                Ok(AutoOr::Given(value as f64))
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

/// The kinds of design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DesignKind {
    /// Every combination of the axes' values.
    Grid,
    /// Independent random values.
    MonteCarlo,
    /// The rows of a CSV file.
    List,
}

/// The cases of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DesignTable {
    /// Which kind.
    pub kind: DesignKind,
    /// The axes of a grid or a Monte Carlo design.
    #[serde(default)]
    pub axes: BTreeMap<Axis, AxisRange>,
    /// Number of Monte Carlo cases.
    #[serde(default)]
    pub cases: Option<usize>,
    /// Seed of a Monte Carlo design. Default 0.
    #[serde(default)]
    pub seed: Option<u64>,
    /// CSV file of a list, beside the file that names it.
    #[serde(default)]
    pub file: Option<PathBuf>,
}

/// The values of one axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AxisRange {
    /// First value, or lower end of a Monte Carlo range.
    #[serde(default)]
    pub from: Option<f64>,
    /// Last value, or upper end.
    #[serde(default)]
    pub to: Option<f64>,
    /// Number of grid values from `from` to `to`.
    #[serde(default)]
    pub count: Option<usize>,
    /// Even steps in the value or in its logarithm. Default `linear`.
    #[serde(default)]
    pub spacing: Spacing,
    /// Grid values one by one, instead of `from`, `to` and `count`.
    #[serde(default)]
    pub values: Option<Vec<f64>>,
}

impl AxisRange {
    /// Its least and its greatest value, where it has any.
    pub fn ends(&self) -> Option<[f64; 2]> {
        let values = self.values.iter().flatten().copied();
        let all = values.chain(self.from).chain(self.to);
        all.fold(None, |ends: Option<[f64; 2]>, value| {
            let [low, high] = ends.unwrap_or([value; 2]);
            Some([low.min(value), high.max(value)])
        })
    }

    /// Refuses ends in the wrong order, or at zero on a logarithmic axis.
    pub(crate) fn check_ends(
        &self,
        source: &Source,
        key: &str,
        from: f64,
        to: f64,
    ) -> Result<(), SweepFileError> {
        if self.spacing == Spacing::Log && from <= 0.0 {
            let message = "logarithmic spacing starts above zero";
            return Err(source.error(&format!("{key}.from"), message));
        }
        if from < to || (from == to && self.count == Some(1)) {
            Ok(())
        } else {
            let message = format!("{to} is not above `from`, {from}: the range is empty");
            Err(source.error(&format!("{key}.to"), message))
        }
    }
}

/// How values are spread between two ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// Evenly.
    #[default]
    Linear,
    /// Evenly in the logarithm.
    Log,
}

impl Spacing {
    /// The value a fraction of the way from `from` to `to`.
    pub fn between(self, from: f64, to: f64, fraction: f64) -> f64 {
        match self {
            Spacing::Linear => from + (to - from) * fraction,
            Spacing::Log => from * (to / from).powf(fraction),
        }
    }
}

/// How the regime map is drawn.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct MapTable {
    /// Axis to the right. Default: the design's second axis.
    pub x: Option<Axis>,
    /// Axis upwards. Default: the design's first axis.
    pub y: Option<Axis>,
    /// Cases to point out.
    pub marks: Vec<MarkTable>,
}

/// A case pointed out on the map, by any quantities that place it there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkTable {
    /// What is written beside it.
    pub name: String,
    /// Surface speed, rpm.
    #[serde(default)]
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit, kN; with a rock, T_d will do.
    #[serde(default)]
    pub weight_on_bit_kn: Option<f64>,
    /// T_d, N m.
    #[serde(default)]
    pub torque_dynamic_nm: Option<f64>,
    /// Impulse in multiples of I₀.
    #[serde(default)]
    pub impulse_ratio: Option<f64>,
    /// Friction.
    #[serde(default)]
    pub friction: Option<f64>,
}
