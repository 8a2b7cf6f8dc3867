//! The borehole wall at a site.

use sim::Wall;

use super::conditions::Conditions;
use super::contacts::{Contact, StringInHole};
use crate::quantities::{Axis, WallQuantity};
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// The wall at a site, but for what a case says of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallSettings {
    /// Which site of the file it is at; none at a candidate.
    pub site: Option<usize>,
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
    /// Radius R₀ with which the string touches it, which friction turns, m.
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

/// The wall at a place, which is a site of the file or a candidate.
///
/// # Errors
/// Where a number is refused, or missing.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    site: Option<usize>,
    (in_hole, contact): (&StringInHole, Contact),
    friction_by_axis: bool,
) -> Result<WallSettings, SweepFileError> {
    let common = content.wall.unwrap_or_default();
    let own = |quantity| site.and_then(|site| content.sites[site].value(quantity));
    // Both: where a site has its own, what holds for all is still read back.
    check(source, "wall", |quantity| common.value(quantity))?;
    if let Some(site) = site {
        check(source, &format!("sites[{site}]"), own)?;
    }
    let mut wall = WallSettings {
        site,
        clearance: 0.0,
        stiffness: f64::INFINITY,
        friction: None,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: contact.radius,
    };
    for quantity in WallQuantity::ALL {
        if let Some(value) = own(quantity).or(common.value(quantity)) {
            wall.set(quantity, value);
        }
    }
    if own(WallQuantity::Clearance)
        .or(common.clearance_mm)
        .is_none()
    {
        let clearance = left_by_hole(source, content, site, in_hole, &contact)?;
        wall.set(WallQuantity::Clearance, clearance);
    }
    let is_missing = wall.friction.is_none() && !friction_by_axis;
    let message = "is needed: give a number, or make it an axis of the design";
    source.refuse_if(is_missing, "wall.friction", message)?;
    Ok(wall)
}

/// The clearance (mm) at a place for which the file gives none.
fn left_by_hole(
    source: &Source,
    content: &FileContent,
    site: Option<usize>,
    in_hole: &StringInHole,
    contact: &Contact,
) -> Result<f64, SweepFileError> {
    let distance = contact.distance_from_bit;
    if !content.clearance_is_of_hole() {
        // Also where an axis gives it: I₀ is that of the string in the file.
        let message = format!("the site {distance} m from the bit has no clearance");
        return Err(source.error("wall", message));
    }
    let depth = in_hole.depth(distance);
    let of_site = site.map(|site| format!("sites[{site}].distance_from_bit_m"));
    let Some(clearance) = contact.clearance_mm else {
        let message = format!(
            "the site {distance} m from the bit is at a depth of {depth} m, and the hole ends at \
             {} m",
            in_hole.depth_of_hole()
        );
        return Err(source.error(of_site.as_deref().unwrap_or("well.holes"), message));
    };
    let key = of_site.as_deref().unwrap_or("wall.clearance");
    let axis = Axis::Wall(WallQuantity::Clearance);
    axis.check(clearance).map_err(|reason| {
        let message = format!(
            "{distance} m from the bit, at a depth of {depth} m, the string touches with a radius \
             of {} m, and the clearance that the hole leaves it is out of range: {reason}",
            contact.radius
        );
        source.error(key, message)
    })?;
    Ok(clearance)
}

fn check(
    source: &Source,
    at: &str,
    value: impl Fn(WallQuantity) -> Option<f64>,
) -> Result<(), SweepFileError> {
    for quantity in WallQuantity::ALL {
        if let Some(value) = value(quantity) {
            let key = format!("{at}.{}", quantity.key());
            source.check_axis(&key, Axis::Wall(quantity), value)?;
        }
    }
    Ok(())
}
