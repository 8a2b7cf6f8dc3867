//! Mud around a string and loss in its material, drawn at random.

use linear::Section;

use super::draw::Draw;

/// Viscous mud in a hole, and the loss of the material in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Surroundings {
    /// m.
    hole_radius: f64,
    /// Of the mud, kg/m³.
    density: f64,
    /// The same, cP.
    pub viscosity: f64,
    /// Of the material.
    pub loss_factor: f64,
}

impl Surroundings {
    /// In a hole that the widest tube fits into.
    pub(super) fn draw(draw: &mut Draw, sections: &[Section]) -> Self {
        let tubes = sections.iter().flat_map(|section| &section.parts);
        let widest = tubes.map(|tube| tube.outer_radius).fold(0.0, f64::max);
        Self {
            hole_radius: widest * draw.uniform(1.1, 2.0),
            density: draw.uniform(1000.0, 2000.0),
            viscosity: draw.log_uniform(3.0, 60.0),
            loss_factor: draw.log_uniform(4e-4, 5e-3),
        }
    }

    /// Its tables in a sweep file.
    pub(super) fn text(&self) -> String {
        format!(
            "[well]\nhole_radius_m = {}\n\n[mud]\ndensity_kg_m3 = {}\nviscosity_cp = {}\n",
            self.hole_radius, self.density, self.viscosity
        )
    }
}
