//! The borehole wall at a site.

use sim::Wall;

use super::conditions::Conditions;
use crate::quantities::{Axis, WallQuantity};
use crate::sweep_file::{FileContent, Source, SweepFileError, WallTable};

/// The wall at a site, but for what a case says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallSettings {
    /// Which site of the file it is at.
    pub site: usize,
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
    /// The same as axes make it in a case.
    pub fn in_case(&self, conditions: &Conditions) -> Self {
        let mut wall = *self;
        for quantity in WallQuantity::ALL {
            if let Some(value) = conditions.of_wall(self.site, quantity) {
                wall.set(quantity, value);
            }
        }
        wall
    }

    /// Gives it a quantity in the unit of the file.
    fn set(&mut self, quantity: WallQuantity, value: f64) {
        match quantity {
            WallQuantity::Clearance => self.clearance = 1e-3 * value,
            WallQuantity::Stiffness => self.stiffness = 1e9 * value,
            WallQuantity::Friction => self.friction = Some(value),
            WallQuantity::DynamicRatio => self.dynamic_ratio = value,
            WallQuantity::StribeckSpeed => self.stribeck_speed = value,
        }
    }

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
    let own = site.wall();
    // Both: where a site has its own, what holds for all is still read back.
    check(source, "wall", &common)?;
    check(source, &format!("sites[{index}]"), &own)?;
    let Some(clearance) = own.clearance_mm.or(common.clearance_mm) else {
        let distance = site.distance_from_bit_m;
        // Where an axis gives it too: I₀ is told of the string as the file says it.
        let message = format!("the site {distance} m from the bit has no clearance");
        return Err(source.error("wall", message));
    };
    let mut wall = WallSettings {
        site: index,
        clearance: 1e-3 * clearance,
        stiffness: f64::INFINITY,
        friction: None,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius,
    };
    for quantity in WallQuantity::ALL {
        if let Some(value) = own.value(quantity).or(common.value(quantity)) {
            wall.set(quantity, value);
        }
    }
    let is_missing = wall.friction.is_none() && !friction_by_axis;
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(is_missing, "wall.friction", message)?;
    Ok(wall)
}

fn check(source: &Source, at: &str, table: &WallTable) -> Result<(), SweepFileError> {
    for quantity in WallQuantity::ALL {
        if let Some(value) = table.value(quantity) {
            let key = format!("{at}.{}", quantity.key());
            source.check_axis(&key, Axis::Wall(quantity), value)?;
        }
    }
    Ok(())
}
