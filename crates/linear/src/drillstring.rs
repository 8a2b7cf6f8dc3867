//! The drillstring as data (Table 2 of the paper): material, sections from the
//! surface down, damping, and what is around it and above it.
//!
//! ```
//! use linear::{Drillstring, DrillstringError, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 9.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let joint = Tube { length: 0.5, inner_radius: 0.048, outer_radius: 0.084 };
//! let collar = Tube { length: 9.5, inner_radius: 0.036, outer_radius: 0.1 };
//! let drillpipe = Section { repeat: 100, parts: vec![pipe, joint] };
//! let collars = Section { repeat: 10, parts: vec![collar] };
//! let string = Drillstring::new(steel, vec![drillpipe, collars], 0.1)?;
//! assert!((string.length() - 1045.0).abs() < 1e-9);
//! assert_eq!(string.torsional_wave_speed().round(), 3194.0);
//!
//! let inside_out = Tube { inner_radius: 0.07, ..pipe };
//! let section = Section { repeat: 1, parts: vec![inside_out] };
//! let refused = Drillstring::new(steel, vec![section], 0.1);
//! assert!(matches!(refused, Err(DrillstringError::Radii { section: 0, part: 0, .. })));
//! # Ok::<(), DrillstringError>(())
//! ```

use std::hash::{DefaultHasher, Hash, Hasher};

use crate::channel::Channel;
use crate::error::DrillstringError;
use crate::loss::Loss;
use crate::surroundings::{AxialForce, Hole, HoleSection, Stretch, stretches};
use crate::top_drive::TopDrive;

/// Two lengths closer than this fraction of the string are the same place.
pub(crate) const SAME_PLACE: f64 = 1e-9;

/// What pipe, joints and collars are made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Shear modulus G, Pa.
    pub shear_modulus: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
}

/// A uniform piece of tube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tube {
    /// Length L, m.
    pub length: f64,
    /// Internal radius r, m.
    pub inner_radius: f64,
    /// External radius R, m.
    pub outer_radius: f64,
}

impl Tube {
    /// Area of the cross-section A = π(R² − r²), m².
    pub fn area(&self) -> f64 {
        std::f64::consts::PI * (self.outer_radius.powi(2) - self.inner_radius.powi(2))
    }

    /// Second moment of area in bending I = J/2, m⁴.
    pub fn second_moment(&self) -> f64 {
        0.5 * self.polar_moment()
    }

    /// Polar second moment of area J = π(R⁴ − r⁴)/2, m⁴.
    pub fn polar_moment(&self) -> f64 {
        std::f64::consts::FRAC_PI_2 * (self.outer_radius.powi(4) - self.inner_radius.powi(4))
    }
}

/// A cell of tubes, from the top down (a pipe and its joint, or a plain
/// collar), repeated.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Number of equal cells N.
    pub repeat: usize,
    /// The tubes of one cell, from the top down.
    pub parts: Vec<Tube>,
}

impl Section {
    /// Length of one cell, m.
    pub fn cell_length(&self) -> f64 {
        self.parts.iter().map(|part| part.length).sum()
    }

    /// Length of all cells together, m.
    pub fn length(&self) -> f64 {
        self.repeat as f64 * self.cell_length()
    }
}

/// A straight drillstring hanging from the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Drillstring {
    material: Material,
    sections: Vec<Section>,
    loss: Loss,
    top_drive: Option<TopDrive>,
    hole: Option<Hole>,
    axial_force: Vec<AxialForce>,
    /// Where it is held sideways, and above, m from the bit.
    held_above: Option<f64>,
    rod: Rod,
}

/// The motion that a string is asked about as a rod: both obey one equation of waves
/// ([`crate::axial`]).
#[derive(Debug, Clone, Copy, PartialEq)]
enum Rod {
    /// It twists: GJ resists, ρJ is moved.
    Twisting,
    /// It stretches: EA resists, ρA is moved.
    Stretching {
        /// E, Pa.
        youngs_modulus: f64,
    },
}

/// By which responses are known to be those of a string, within one run of a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct StringId(u64);

impl Drillstring {
    /// A string of `sections` from the surface down, with the distributed
    /// torsional damping c_t in N m s/rad per metre of string (Eq. 1).
    ///
    /// # Errors
    /// Where a length, radius or constant is not what a real string can have.
    pub fn new(
        material: Material,
        sections: Vec<Section>,
        torsional_damping: f64,
    ) -> Result<Self, DrillstringError> {
        positive("shear modulus", material.shear_modulus)?;
        positive("density", material.density)?;
        if !(torsional_damping.is_finite() && torsional_damping >= 0.0) {
            return Err(DrillstringError::NegativeDamping {
                value: torsional_damping,
            });
        }
        if sections.is_empty() {
            return Err(DrillstringError::NoSections);
        }
        for (index, section) in sections.iter().enumerate() {
            check_section(index, section)?;
        }
        Ok(Self {
            material,
            sections,
            loss: Loss::constant(torsional_damping),
            top_drive: None,
            hole: None,
            axial_force: Vec::new(),
            held_above: None,
            rod: Rod::Twisting,
        })
    }

    /// The same string below a top drive, where without one the surface turns as prescribed.
    ///
    /// # Errors
    /// Where there is no such drive.
    pub fn with_top_drive(self, drive: TopDrive) -> Result<Self, DrillstringError> {
        drive.check()?;
        Ok(Self {
            top_drive: Some(drive),
            ..self
        })
    }

    /// The same string of a material that loses, joints included, the loss factor η of its energy
    /// over 2π in each cycle, at any frequency (see [`crate::loss`]); none where that is 0.
    ///
    /// # Errors
    /// Where it is below 0 or as large as 1.
    pub fn with_loss_factor(self, loss_factor: f64) -> Result<Self, DrillstringError> {
        if !(0.0..1.0).contains(&loss_factor) {
            return Err(DrillstringError::LossFactor { value: loss_factor });
        }
        Ok(Self {
            loss: self.loss.with_loss_factor(loss_factor),
            ..self
        })
    }

    /// The same string in a hole full of mud, which moves with it in bending, and holds it back
    /// where it is viscous.
    ///
    /// # Errors
    /// Where there is no such mud, or a part is not narrower than the hole.
    pub fn in_hole(self, hole: Hole) -> Result<Self, DrillstringError> {
        positive("density of the mud", hole.mud.density)?;
        let viscosity = hole.mud.viscosity;
        if !(viscosity.is_finite() && viscosity >= 0.0) {
            return Err(DrillstringError::Viscosity { value: viscosity });
        }
        for section in &hole.sections {
            positive("length of a section of hole", section.length)?;
            positive("radius of the hole", section.radius)?;
        }
        let (length, depth) = (
            self.length(),
            hole.sections.iter().map(|it| it.length).sum(),
        );
        if depth < length * (1.0 - SAME_PLACE) {
            return Err(DrillstringError::HoleTooShort { length, depth });
        }
        self.check_width(&hole.sections)?;
        Ok(Self {
            loss: self.loss.with_mud(hole.mud),
            hole: Some(hole),
            ..self
        })
    }

    /// The same string under an axial force, from the surface down, where without one it has
    /// none but the pre-compression of [`crate::Bending`]. It matters in bending: tension pulls the
    /// string straight.
    ///
    /// # Errors
    /// Where there is no such force, or it is not that of a string as long.
    pub fn under_axial_force(self, pieces: Vec<AxialForce>) -> Result<Self, DrillstringError> {
        for piece in &pieces {
            positive("length under an axial force", piece.length)?;
            if !piece.tension.is_finite() {
                let value = piece.tension;
                return Err(DrillstringError::Tension { value });
            }
        }
        let (length, under) = (
            self.length(),
            pieces.iter().map(|it| it.length).sum::<f64>(),
        );
        if (length - under).abs() > SAME_PLACE * length * pieces.len() as f64 {
            return Err(DrillstringError::AxialForceOfAnother { length, under });
        }
        Ok(Self {
            axial_force: pieces,
            ..self
        })
    }

    /// The same string, held sideways at a distance from its bit (m) and above, as one is that lies on
    /// its hole there. It turns as a whole, but bends below alone, where its upper end is then what
    /// [`crate::SurfaceSupport`] says of the surface.
    ///
    /// # Errors
    /// Where that is no place of the string above its bit.
    pub fn held_above(self, distance_from_bit: f64) -> Result<Self, DrillstringError> {
        let (distance, length) = (distance_from_bit, self.length());
        let least = self.same_place();
        if !(distance > least && distance < length - least) {
            return Err(DrillstringError::HeldOffString { distance, length });
        }
        Ok(Self {
            held_above: Some(distance),
            ..self
        })
    }

    /// Every tube is narrower than the hole is where it hangs.
    fn check_width(&self, hole: &[HoleSection]) -> Result<(), DrillstringError> {
        let same_place = self.same_place();
        let mut top = 0.0;
        for (section, cell) in self.sections.iter().enumerate() {
            for (part, tube) in (0..cell.repeat).flat_map(|_| cell.parts.iter().enumerate()) {
                let (bottom, outer) = (top + tube.length, tube.outer_radius);
                let mut above = 0.0;
                for around in hole {
                    let below = above + around.length;
                    let is_in_it = above < bottom - same_place && below > top + same_place;
                    if is_in_it && outer >= around.radius {
                        return Err(DrillstringError::WiderThanHole {
                            section,
                            part,
                            outer,
                            hole: around.radius,
                        });
                    }
                    above = below;
                }
                top = bottom;
            }
        }
        Ok(())
    }

    /// Mass per length of a tube that moves sideways in a hole of a radius (m), kg/m: its own,
    /// the mud inside, and what mud around it adds, π R² ρ (R_h² + R²)/(R_h² − R²) in the middle of a hole of radius R_h
    /// (S. S. Chen, M. W. Wambsganss and J. A. Jendrzejczyk, "Added mass and damping of a
    /// vibrating rod in confined viscous fluids", *Journal of Applied Mechanics* 43, 1976,
    /// 325–329, without viscosity).
    pub(crate) fn mass_sideways(&self, tube: &Tube, hole_radius: Option<f64>) -> f64 {
        let own = self.material.density * tube.area();
        let Some((hole, around)) = self.hole.as_ref().zip(hole_radius) else {
            return own;
        };
        let [inner, outer, around] =
            [tube.inner_radius, tube.outer_radius, around].map(|radius| radius * radius);
        let displaced = inner + outer * (around + outer) / (around - outer);
        own + std::f64::consts::PI * hole.mud.density * displaced
    }

    /// The same of itself and the mud inside alone, which moves along at any viscosity.
    pub(crate) fn mass_with_bore(&self, tube: &Tube) -> f64 {
        let mud = self.hole.as_ref().map_or(0.0, |hole| hole.mud.density);
        let bore = std::f64::consts::PI * tube.inner_radius.powi(2);
        self.material.density * tube.area() + mud * bore
    }

    /// The same string, about as long as another, with the loss of that which depends on
    /// frequency: in its hole of mud, where that is viscous, and of its material.
    ///
    /// # Errors
    /// Where it does not fit into that hole.
    pub fn with_loss_of(self, other: &Self) -> Result<Self, DrillstringError> {
        let string = self.with_loss_factor(other.loss.loss_factor())?;
        let hole = other.hole.as_ref().filter(|hole| hole.mud.viscosity > 0.0);
        let Some(hole) = hole else {
            return Ok(string);
        };
        // Deep enough however lengths were rounded.
        let mut deeper = hole.clone();
        if let Some(last) = deeper.sections.last_mut() {
            last.length *= 2.0;
        }
        string.in_hole(deeper)
    }

    /// The same string, its surface turning as prescribed.
    pub fn without_top_drive(self) -> Self {
        Self {
            top_drive: None,
            ..self
        }
    }

    /// The drive that turns it, if its surface does not turn as prescribed.
    pub fn top_drive(&self) -> Option<TopDrive> {
        self.top_drive
    }

    /// The hole of mud that it is in.
    pub(crate) fn hole(&self) -> Option<&Hole> {
        self.hole.as_ref()
    }

    /// What is around it where it bends, from the surface down.
    pub(crate) fn surroundings(&self) -> Vec<Stretch> {
        let length = self.length();
        let hole = self.hole.as_ref();
        stretches(&self.axial_force, hole, length, self.same_place())
    }

    /// The hole of viscous mud that holds it back where it turns, from the surface down; empty
    /// where none does.
    pub(crate) fn mud_around(&self) -> Vec<Stretch> {
        let hole = self.hole.as_ref().filter(|hole| hole.mud.viscosity > 0.0);
        hole.map_or_else(Vec::new, |hole| {
            stretches(&[], Some(hole), self.length(), self.same_place())
        })
    }

    /// The axial force along it, from the surface down; empty where none but that of
    /// [`crate::Bending`] acts.
    pub fn axial_force(&self) -> &[AxialForce] {
        &self.axial_force
    }

    /// The same string as a rod that stretches, of this Young's modulus (Pa), with a
    /// distributed damping (N s/m per metre), under a hoist if any.
    pub(crate) fn stretching(
        &self,
        youngs_modulus: f64,
        damping: f64,
        hoist: Option<TopDrive>,
    ) -> Self {
        Self {
            rod: Rod::Stretching { youngs_modulus },
            loss: self.loss.clone().with_constant(damping),
            top_drive: hoist,
            ..self.clone()
        }
    }

    /// The same rod without loss; what it hangs from keeps its mass alone.
    ///
    /// # Errors
    /// Where it cannot be cut up.
    pub(crate) fn undamped(&self) -> Result<Self, DrillstringError> {
        let same = Self::new(self.material, self.sections.clone(), 0.0)?;
        let drive = self.top_drive.map(|drive| TopDrive {
            proportional_gain: 0.0,
            integral_gain: 0.0,
            delay: 0.0,
            late_inertia: 0.0,
            ..drive
        });
        Ok(Self {
            rod: self.rod,
            top_drive: drive,
            ..same
        })
    }

    /// Its motion as a rod.
    pub fn channel(&self) -> Channel {
        match self.rod {
            Rod::Twisting => Channel::Torsion,
            Rod::Stretching { .. } => Channel::Axial,
        }
    }

    /// The modulus that resists it: G where it twists, E where it stretches, Pa.
    pub(crate) fn modulus(&self) -> f64 {
        match self.rod {
            Rod::Twisting => self.material.shear_modulus,
            Rod::Stretching { youngs_modulus } => youngs_modulus,
        }
    }

    /// What of the cross-section of a tube resists and moves: J where the string twists, m⁴, A
    /// where it stretches, m².
    pub(crate) fn section_constant(&self, tube: &Tube) -> f64 {
        match self.rod {
            Rod::Twisting => tube.polar_moment(),
            Rod::Stretching { .. } => tube.area(),
        }
    }

    /// What tells it from other strings.
    pub fn id(&self) -> StringId {
        let mut hasher = DefaultHasher::new();
        let mut add = |number: f64| number.to_bits().hash(&mut hasher);
        add(f64::from(u8::from(self.channel() == Channel::Axial)));
        add(self.modulus());
        add(self.material.density);
        add(self.torsional_damping());
        add(self.loss.loss_factor());
        for section in &self.sections {
            add(section.repeat as f64);
            for part in &section.parts {
                add(part.length);
                add(part.inner_radius);
                add(part.outer_radius);
            }
        }
        if let Some(drive) = self.top_drive {
            add(drive.inertia);
            add(drive.proportional_gain);
            add(drive.integral_gain);
            add(drive.delay);
            add(drive.late_inertia);
        }
        if let Some(hole) = &self.hole {
            add(hole.mud.density);
            add(hole.mud.viscosity);
            for section in &hole.sections {
                add(section.length);
                add(section.radius);
            }
        }
        for piece in &self.axial_force {
            add(piece.length);
            add(piece.tension);
        }
        if let Some(distance) = self.held_above {
            add(distance);
        }
        StringId(hasher.finish())
    }

    /// What the string is made of.
    pub fn material(&self) -> Material {
        self.material
    }

    /// The sections, from the surface down.
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }

    /// The section repeated most often (the upper of equals): the drillpipe,
    /// whose cell sets the natural scales of frequency and element length.
    pub fn drillpipe(&self) -> &Section {
        self.sections
            .iter()
            .rev()
            .max_by_key(|section| section.repeat)
            .unwrap_or(&self.sections[0])
    }

    /// Distributed torsional damping c_t, N m s/rad per metre.
    pub fn torsional_damping(&self) -> f64 {
        self.loss.torsional_damping()
    }

    /// All that takes energy from it in torsion, and what mud and material take in bending.
    pub fn loss(&self) -> &Loss {
        &self.loss
    }

    /// Length of what bends, down to the bit, m: all of it, unless it is
    /// [held above](Drillstring::held_above) a place.
    pub fn bending_length(&self) -> f64 {
        self.held_above.unwrap_or_else(|| self.length())
    }

    /// Length from the surface to the bit, m.
    pub fn length(&self) -> f64 {
        self.sections.iter().map(Section::length).sum()
    }

    /// Speed of torsional waves √(G/ρ), m/s (without damping).
    pub fn torsional_wave_speed(&self) -> f64 {
        (self.modulus() / self.material.density).sqrt()
    }

    /// Two places that are no further apart than this, m, are one.
    pub fn same_place(&self) -> f64 {
        SAME_PLACE * self.length()
    }

    /// The tubes just below and just above a place at a distance from the bit (m), each by its
    /// section and its part of the cell; the same twice but at a joint between two. Beyond an end
    /// of the string it is that of the end.
    pub fn parts_around(&self, distance_from_bit: f64) -> [(usize, usize); 2] {
        let same_place = self.same_place();
        [-same_place, same_place].map(|offset| self.part_at(distance_from_bit + offset))
    }

    /// The tube at a distance from the bit (m), which is not one of its ends.
    fn part_at(&self, distance_from_bit: f64) -> (usize, usize) {
        let mut left = distance_from_bit.max(0.0);
        for (index, section) in self.sections.iter().enumerate().rev() {
            if left >= section.length() {
                left -= section.length();
                continue;
            }
            left %= section.cell_length();
            for (part, tube) in section.parts.iter().enumerate().rev() {
                if left < tube.length {
                    return (index, part);
                }
                left -= tube.length;
            }
            // Missed by a rounding.
            return (index, 0);
        }
        (0, 0)
    }

    /// Every tube with the number of times it occurs, from the surface down.
    pub(crate) fn tubes(&self) -> impl Iterator<Item = (f64, &Tube)> {
        self.sections.iter().flat_map(|section| {
            let count = section.repeat as f64;
            section.parts.iter().map(move |part| (count, part))
        })
    }
}

pub(crate) fn positive(quantity: &'static str, value: f64) -> Result<(), DrillstringError> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(DrillstringError::NotPositive { quantity, value })
    }
}

fn check_section(section: usize, data: &Section) -> Result<(), DrillstringError> {
    if data.repeat == 0 {
        return Err(DrillstringError::NoRepeat { section });
    }
    if data.parts.is_empty() {
        return Err(DrillstringError::NoParts { section });
    }
    for (part, tube) in data.parts.iter().enumerate() {
        if !(tube.length.is_finite() && tube.length > 0.0) {
            return Err(DrillstringError::Length {
                section,
                part,
                value: tube.length,
            });
        }
        let (inner, outer) = (tube.inner_radius, tube.outer_radius);
        if !(inner >= 0.0 && inner < outer && outer.is_finite()) {
            return Err(DrillstringError::Radii {
                section,
                part,
                inner,
                outer,
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validation::academic;

    #[test]
    fn the_tubes_around_a_place_are_those_there() {
        let string = academic::string();
        let (pipe, joint, collar) = ((0, 0), (0, 1), (1, 0));
        for (distance, around) in [
            (-1.0, [collar; 2]),
            (0.0, [collar; 2]),
            (99.9, [collar; 2]),
            (100.0, [collar, joint]),
            (100.2, [joint; 2]),
            (100.5, [joint, pipe]),
            (100.7, [pipe; 2]),
            (109.9, [pipe; 2]),
            (110.0, [pipe, joint]),
            (110.4, [joint; 2]),
            (999.0, [pipe; 2]),
            (1000.0, [pipe; 2]),
            (1001.0, [pipe; 2]),
        ] {
            assert_eq!(string.parts_around(distance), around, "{distance}");
        }
    }

    #[test]
    fn what_no_string_can_be_is_refused() {
        let steel = academic::string().material();
        let with = |parts: Vec<Tube>, repeat| {
            Drillstring::new(steel, vec![Section { repeat, parts }], 0.0).is_ok()
        };
        let tube = |length| academic::tube(length, 0.125);
        assert!(with(vec![tube(1.0)], 1));
        for length in [0.0, -1.0, f64::NAN] {
            assert!(!with(vec![tube(length)], 1), "{length}");
        }
        assert!(!with(vec![], 1) && !with(vec![tube(1.0)], 0));
        assert!(!with(vec![academic::tube(1.0, 0.04)], 1));
    }
}
