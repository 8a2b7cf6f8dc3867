//! The borehole wall at a site.

use sim::Wall;

use crate::quantities::Axis;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// The wall at a site, but for what a case says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallSettings {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ₀; none where every case gives it.
    pub friction: Option<f64>,
    /// Radius R₀ of the string, which friction turns, m.
    pub radius: f64,
}

impl WallSettings {
    /// The wall with this friction.
    pub fn with_friction(&self, friction: f64) -> Wall {
        Wall {
            clearance: self.clearance,
            stiffness: self.stiffness,
            friction,
            radius: self.radius,
        }
    }
}

/// The wall at a site of the file, where the string has an outer radius (m).
///
/// # Errors
/// Where a number is refused, or missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    index: usize,
    radius: f64,
    friction_by_axis: bool,
) -> Result<WallSettings, SweepFileError> {
    let common = content.wall.unwrap_or_default();
    let site = &content.sites[index];
    let chosen = |own: Option<f64>, common: Option<f64>, name: &str| match own {
        Some(value) => (Some(value), format!("sites[{index}].{name}")),
        None => (common, format!("wall.{name}")),
    };
    let (clearance, key) = chosen(site.clearance_mm, common.clearance_mm, "clearance_mm");
    let Some(clearance) = clearance else {
        let distance = site.distance_from_bit_m;
        let message = format!("the site {distance} m from the bit has no clearance");
        return Err(source.error("wall", message));
    };
    source.within(&key, clearance, 1e-3, 1e3, "mm")?;
    let (own, of_all) = (site.stiffness_gn_m15, common.stiffness_gn_m15);
    let (stiffness, key) = chosen(own, of_all, "stiffness_gn_m15");
    if let Some(stiffness) = stiffness {
        source.within(&key, stiffness, 1e-6, 1e6, "GN/m^1.5")?;
    }
    let (friction, key) = chosen(site.friction, common.friction, "friction");
    if let Some(friction) = friction {
        source.check_axis(&key, Axis::Friction, friction)?;
    }
    let is_missing = friction.is_none() && !friction_by_axis;
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(is_missing, "wall.friction", message)?;
    Ok(WallSettings {
        clearance: 1e-3 * clearance,
        stiffness: stiffness.map_or(f64::INFINITY, |stiffness| 1e9 * stiffness),
        friction,
        radius,
    })
}
