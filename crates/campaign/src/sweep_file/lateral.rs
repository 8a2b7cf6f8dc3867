//! The keys of lateral motion: bending, the borehole wall at the sites, disturbances.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::number_or::is_default;
use crate::quantities::WallQuantity;

/// Bending constants of the string, `[string.bending]`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BendingTable {
    /// Young's modulus E; steel has about 210.
    #[schemars(range(min = 0.1, max = 1000.0))]
    pub youngs_modulus_gpa: f64,
    /// Lateral damping c_b of Eq. 19: drag on each metre of the string as it moves sideways, the
    /// same at every frequency. It may be left out, for none, where a `loss_factor` or the
    /// `viscosity_cp` of the mud is given.
    #[schemars(range(min = 0.0, max = 1e7))]
    #[serde(default)]
    pub damping_ns_m2: f64,
    /// Pre-compression C; tension where negative.
    #[schemars(range(min = -1e5, max = 1e5))]
    #[serde(default)]
    pub compression_kn: f64,
    /// How the surface holds the string sideways.
    #[serde(default)]
    pub surface: SupportName,
}

/// How the surface holds the string laterally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
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
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct WallTable {
    /// From the string to the wall, when it is in the middle.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub clearance_mm: Option<f64>,
    /// Instead of `clearance_mm`: what the hole of `[well]` leaves, its radius at the depth of
    /// a site less the radius with which the string touches there, to a nanometre. Where two
    /// sections of hole meet the narrower counts, where two parts do the wider. A site's own
    /// `clearance_mm` goes first, and an axis of clearance before both. A string that does not
    /// fit into its hole is refused; but a bit, or blades, as wide as the hole have drilled it,
    /// which is then taken to be 0.8 mm (1/32 in) wider there, with waterways of a fifth for
    /// `[mud]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub clearance: Option<ClearanceName>,
    /// Hertzian stiffness k_c; left out, the wall is rigid, and `finite-element` needs γ = 0.7
    /// or so.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub stiffness_gn_m15: Option<f64>,
    /// Coefficient of friction μ₀, static where it falls; needed unless it is an axis, or of
    /// each site one.
    #[schemars(range(min = 0.0, max = 50.0))]
    pub friction: Option<f64>,
    /// Dynamic by static coefficient, μ_d/μ₀. Left out it is 1: friction does not depend on the
    /// speed of sliding, as in the paper.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub friction_dynamic_ratio: Option<f64>,
    /// Stribeck speed v_s: at a speed of sliding v the coefficient is μ_d + (μ₀ − μ_d)
    /// exp(−(v/v_s)²). Left out it is 0: friction falls with the first slip.
    #[schemars(range(min = 0.0, max = 100.0))]
    pub friction_stribeck_m_s: Option<f64>,
    /// Whether a string in a well that `[well]` says to be inclined lies on the low side of its hole
    /// under its weight; with `false` it hangs in the middle, as in a vertical well.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lies_on_low_side: Option<bool>,
    /// The acceleration sideways within its band, in g, beyond which a shock is counted, where accelerations are
    /// measured: those of a string that lies in its hole or has `[[tools]]` (left out, 25 g), others only
    /// if this is given.
    #[schemars(range(min = 0.001, max = 1e5))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub shock_g: Option<f64>,
    /// Measures how the moving string is bent and stressed: at its sites, and between them and the bit at
    /// places no further apart than this. Left out, neither is measured.
    #[schemars(range(min = 0.1, max = 2e4))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stress_every_m: Option<f64>,
    /// At which places the wall may be touched.
    #[schemars(!skip_serializing_if)]
    #[serde(skip_serializing_if = "is_default")]
    pub sites: SitesName,
    /// Of `"all"`: candidates are at every multiple of this distance from the bit, the bit
    /// included; left out, where the string is wide. Of `"ends"`: no two are further apart; left out, as
    /// far as the string hardly sags through its wall. Of `"auto"`: sites are made there; left out, every metre.
    #[schemars(range(min = 0.001, max = 2e4))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_every_m: Option<f64>,
    /// Of `"all"`, `"ends"` and `"auto"`: how far up from the bit; left out, to the surface.
    #[schemars(range(min = 0.001, max = 2e4))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_to_m: Option<f64>,
    /// Of `"auto"`: how much farther beyond the wall than the sites next to it the string may
    /// go; left out, 1 mm.
    #[schemars(range(min = 0.001, max = 1000.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_tolerance_mm: Option<f64>,
    /// Of `"auto"`: how often a case is run again at most; left out, 20 times.
    #[schemars(range(min = 1, max = 1000))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sites_rounds: Option<usize>,
}

/// What decides the clearance, where the file does not give it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ClearanceName {
    /// How wide the hole is, and the string in it.
    Hole,
}

/// Where the wall may be touched.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SitesName {
    /// At those of `[[sites]]`.
    #[default]
    Given,
    /// At candidates all along the string, too.
    All,
    /// At the bit and the ends of its wide parts, too, where a string touches that lies in its hole.
    Ends,
    /// Also where a case goes through its wall, which it is run again for.
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
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ImpulseTable {
    /// Which site, by its distance from the bit.
    #[schemars(range(min = 0.0))]
    pub distance_from_bit_m: f64,
    /// Its amount I.
    #[schemars(range(min = 0.0, max = 1e9))]
    pub amount_ns: Option<f64>,
    /// Its amount in multiples of I₀, which just brings the site to the wall. One of
    /// `amount_ns`, `ratio` and the axis `impulse_ratio` is needed.
    #[schemars(range(min = 0.0, max = 1e9))]
    pub ratio: Option<f64>,
    /// When it begins: before the end of every case, for the label of a case that ends before
    /// would say nothing of it.
    #[schemars(range(min = 0.0, max = 1e6))]
    #[serde(default = "default_start")]
    pub start_s: f64,
    /// How long it lasts, τ: two steps or more.
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 100.0))]
    #[serde(default = "default_duration")]
    pub duration_s: f64,
    /// Its direction from the x axis.
    #[schemars(range(min = -360.0, max = 360.0))]
    #[serde(default)]
    pub direction_deg: f64,
}

fn default_start() -> f64 {
    1.0
}

fn default_duration() -> f64 {
    0.02
}

/// The force of an eccentric mass at a radius r of the string.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum MassForm {
    /// Force of its inertia, m_e (d θ̇² e^(iθ) − r̈): the string carries the mass.
    #[default]
    Carried,
    /// Force of Section 5.2.3 at a radius r, m_e (d + r) θ̇² e^(iθ), which has the wrong sign of r above a
    /// critical speed.
    Paper,
}

/// An eccentric mass at a site.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EccentricMassTable {
    /// Which site, by its distance from the bit.
    #[schemars(range(min = 0.0))]
    pub distance_from_bit_m: f64,
    /// Its mass m_e.
    #[schemars(range(min = 0.0, max = 1e6))]
    pub mass_kg: f64,
    /// Its offset d from the string's centre.
    #[schemars(range(min = 0.0, max = 10.0))]
    pub offset_m: f64,
    /// Its force.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "MassForm::is_carried")]
    pub form: MassForm,
}

impl MassForm {
    /// Whether the string carries the mass.
    pub fn is_carried(&self) -> bool {
        *self == Self::Carried
    }
}

/// A tool in the string that feels how it is shaken.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ToolTable {
    /// Where on the string, at a site or anywhere else.
    #[schemars(range(min = 0.0))]
    pub distance_from_bit_m: f64,
    /// The band within which it records: its three-pole Bessel filter has half the power there; left
    /// out, 100 Hz. No more than a quarter of the sampling frequency is held, and `run`, `simulate` and
    /// `inspect` warn where that is less.
    #[schemars(range(min = 0.1, max = 1e5))]
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub band_hz: Option<f64>,
}

/// A place on the string.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SiteTable {
    /// Where on the string. With a bit that cuts and a wall, one of the sites is the bit, 0.
    #[schemars(range(min = 0.0))]
    pub distance_from_bit_m: f64,
    /// Clearance here, if it is not the wall's. Needs a wall, as the following keys.
    #[schemars(range(min = 0.001, max = 1000.0))]
    pub clearance_mm: Option<f64>,
    /// Stiffness of the wall here, if it is not the wall's.
    #[schemars(range(min = 1e-6, max = 1e6))]
    pub stiffness_gn_m15: Option<f64>,
    /// Coefficient of friction here, if it is not the wall's, unless it is an axis.
    #[schemars(range(min = 0.0, max = 50.0))]
    pub friction: Option<f64>,
    /// Dynamic by static coefficient here, if it is not the wall's.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub friction_dynamic_ratio: Option<f64>,
    /// Stribeck speed here, if it is not the wall's.
    #[schemars(range(min = 0.0, max = 100.0))]
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
