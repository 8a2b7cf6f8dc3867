//! The borehole wall at a site.

use sim::Wall;

use crate::quantities::Axis;
use crate::sweep_file::{FileContent, Source, SweepFileError, WallTable};

/// The wall at a site, but for what a case says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallSettings {
    /// Clearance c between string and wall, m.
    pub clearance: f64,
    /// Hertzian stiffness k_c, N/m^(3/2); infinite for a rigid wall.
    pub stiffness: f64,
    /// Coefficient of friction μ₀, static where it falls; none where every case gives it.
    pub friction: Option<f64>,
    /// Dynamic coefficient in parts of that.
    pub dynamic_ratio: f64,
    /// Stribeck speed of sliding, m/s.
    pub stribeck_speed: f64,
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
            dynamic_ratio: self.dynamic_ratio,
            stribeck_speed: self.stribeck_speed,
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
    let own = WallTable {
        clearance_mm: site.clearance_mm,
        stiffness_gn_m15: site.stiffness_gn_m15,
        friction: site.friction,
        friction_dynamic_ratio: site.friction_dynamic_ratio,
        friction_stribeck_m_s: site.friction_stribeck_m_s,
    };
    // Both: where a site has its own, what holds for all is still read back.
    check(source, "wall", &common)?;
    check(source, &format!("sites[{index}]"), &own)?;
    let Some(clearance) = own.clearance_mm.or(common.clearance_mm) else {
        let distance = site.distance_from_bit_m;
        let message = format!("the site {distance} m from the bit has no clearance");
        return Err(source.error("wall", message));
    };
    let stiffness = own.stiffness_gn_m15.or(common.stiffness_gn_m15);
    let friction = own.friction.or(common.friction);
    let is_missing = friction.is_none() && !friction_by_axis;
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(is_missing, "wall.friction", message)?;
    let dynamic_ratio = (own.friction_dynamic_ratio).or(common.friction_dynamic_ratio);
    let stribeck_speed = (own.friction_stribeck_m_s).or(common.friction_stribeck_m_s);
    Ok(WallSettings {
        clearance: 1e-3 * clearance,
        stiffness: stiffness.map_or(f64::INFINITY, |stiffness| 1e9 * stiffness),
        friction,
        dynamic_ratio: dynamic_ratio.unwrap_or(1.0),
        stribeck_speed: stribeck_speed.unwrap_or(0.0),
        radius,
    })
}

fn check(source: &Source, at: &str, table: &WallTable) -> Result<(), SweepFileError> {
    if let Some(clearance) = table.clearance_mm {
        source.within(&format!("{at}.clearance_mm"), clearance, 1e-3, 1e3, "mm")?;
    }
    if let Some(stiffness) = table.stiffness_gn_m15 {
        let key = format!("{at}.stiffness_gn_m15");
        source.within(&key, stiffness, 1e-6, 1e6, "GN/m^1.5")?;
    }
    if let Some(friction) = table.friction {
        source.check_axis(&format!("{at}.friction"), Axis::Friction, friction)?;
    }
    if let Some(ratio) = table.friction_dynamic_ratio {
        source.within(&format!("{at}.friction_dynamic_ratio"), ratio, 0.0, 1.0, "")?;
    }
    if let Some(speed) = table.friction_stribeck_m_s {
        source.within(
            &format!("{at}.friction_stribeck_m_s"),
            speed,
            0.0,
            100.0,
            "m/s",
        )?;
    }
    Ok(())
}
