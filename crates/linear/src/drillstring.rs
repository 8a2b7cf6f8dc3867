//! The drillstring as data (Table 2 of the paper): material, sections from the
//! surface down, damping, and the sites where something acts on it.

use std::hash::{DefaultHasher, Hash, Hasher};

use crate::error::DrillstringError;

/// Two lengths closer than this fraction of the string are the same place.
const SAME_PLACE: f64 = 1e-9;

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
    torsional_damping: f64,
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
            torsional_damping,
        })
    }

    /// What tells it from other strings.
    pub fn id(&self) -> StringId {
        let mut hasher = DefaultHasher::new();
        let mut add = |number: f64| number.to_bits().hash(&mut hasher);
        add(self.material.shear_modulus);
        add(self.material.density);
        add(self.torsional_damping);
        for section in &self.sections {
            add(section.repeat as f64);
            for part in &section.parts {
                add(part.length);
                add(part.inner_radius);
                add(part.outer_radius);
            }
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
        self.torsional_damping
    }

    /// Length from the surface to the bit, m.
    pub fn length(&self) -> f64 {
        self.sections.iter().map(Section::length).sum()
    }

    /// Speed of torsional waves √(G/ρ), m/s (without damping).
    pub fn torsional_wave_speed(&self) -> f64 {
        (self.material.shear_modulus / self.material.density).sqrt()
    }

    /// External radius at a distance from the bit, m; at a joint between two
    /// tubes, that of the lower; beyond an end of the string, that of the end.
    pub fn outer_radius_at(&self, distance_from_bit: f64) -> f64 {
        let same_place = SAME_PLACE * self.length();
        let mut left = distance_from_bit + same_place;
        let mut radius = self.sections[0].parts[0].outer_radius;
        for section in self.sections.iter().rev() {
            let cell = section.cell_length();
            if left > section.length() {
                left -= section.length();
                continue;
            }
            left %= cell;
            for part in section.parts.iter().rev() {
                radius = part.outer_radius;
                if left <= part.length + same_place {
                    return radius;
                }
                left -= part.length;
            }
        }
        radius
    }

    /// Every tube with the number of times it occurs, from the surface down.
    pub(crate) fn tubes(&self) -> impl Iterator<Item = (f64, &Tube)> {
        self.sections.iter().flat_map(|section| {
            let count = section.repeat as f64;
            section.parts.iter().map(move |part| (count, part))
        })
    }

    /// The string cut at the sites: one span above each site, and one more
    /// below the last where that is not the bit. Sites of another string may not
    /// be places of this one.
    pub(crate) fn spans(&self, sites: &Sites) -> Result<Vec<Span>, DrillstringError> {
        sites.check(self)?;
        let mut below: Vec<Section> = self.sections.iter().rev().cloned().collect();
        let mut depth = 0.0;
        let mut spans: Vec<Span> = Vec::with_capacity(sites.len() + 1);
        for site in sites.depths(self) {
            spans.push(cut_off_top(
                &mut below,
                site - depth,
                SAME_PLACE * self.length(),
            ));
            depth = site;
        }
        if sites.bit_site().is_some() {
            // Rounding may have left a sliver; the bit ends the string.
            let left: f64 = below.iter().map(Section::length).sum();
            debug_assert!(left <= sites.len() as f64 * SAME_PLACE * self.length());
        } else {
            below.reverse();
            spans.push(Span { runs: below });
        }
        Ok(spans)
    }
}

fn positive(quantity: &'static str, value: f64) -> Result<(), DrillstringError> {
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

/// What bending needs to know of a string, beyond what torsion does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bending {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Distributed lateral damping c_b, N s/m per metre of string (Eq. 19).
    pub damping: f64,
    /// Pre-compression C, N; tension where negative.
    pub compression: f64,
}

impl Bending {
    /// Checks that a string can bend so.
    pub(crate) fn check(&self) -> Result<(), DrillstringError> {
        positive("Young's modulus", self.youngs_modulus)?;
        if !(self.damping.is_finite() && self.damping >= 0.0) {
            return Err(DrillstringError::NegativeLateralDamping {
                value: self.damping,
            });
        }
        if !self.compression.is_finite() {
            return Err(DrillstringError::Compression {
                value: self.compression,
            });
        }
        Ok(())
    }
}

/// How the surface holds the string laterally.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SurfaceSupport {
    /// Not at all.
    #[default]
    Free,
    /// No displacement.
    Pinned,
    /// No displacement and no slope.
    Clamped,
}

impl SurfaceSupport {
    /// How many of the surface's two degrees of freedom, displacement and
    /// slope, are held.
    pub(crate) fn held(self) -> usize {
        match self {
            SurfaceSupport::Free => 0,
            SurfaceSupport::Pinned => 1,
            SurfaceSupport::Clamped => 2,
        }
    }
}

/// The places where something acts on the string or is looked at, from the
/// surface down.
#[derive(Debug, Clone, PartialEq)]
pub struct Sites {
    /// Distances from the bit, m, strictly decreasing.
    distances_from_bit: Vec<f64>,
}

impl Sites {
    /// Sites at the given distances from the bit (m), in any order; they are
    /// numbered from the surface down, so that the bit, if it is one, is last.
    ///
    /// # Errors
    /// Where there is none, one is not between the bit and the surface, or
    /// two are at one place.
    pub fn new(string: &Drillstring, distances_from_bit: &[f64]) -> Result<Self, DrillstringError> {
        let mut sorted = distances_from_bit.to_vec();
        sorted.sort_by(|a, b| b.total_cmp(a));
        let mut sites = Self {
            distances_from_bit: sorted,
        };
        sites.check(string)?;
        match sites.distances_from_bit.last_mut() {
            None => return Err(DrillstringError::NoSites),
            Some(last) if *last <= SAME_PLACE * string.length() => *last = 0.0,
            Some(_) => {}
        }
        Ok(sites)
    }

    /// Checks that these are places of `string`, which may be another than that
    /// they were made for.
    ///
    /// # Errors
    /// Where one is not between the bit and the surface, or two are at one place.
    pub fn check(&self, string: &Drillstring) -> Result<(), DrillstringError> {
        let length = string.length();
        let same_place = SAME_PLACE * length;
        for &distance in &self.distances_from_bit {
            if !(distance >= 0.0 && distance < length - same_place) {
                return Err(DrillstringError::SiteOffString { distance, length });
            }
        }
        let mut pairs = self.distances_from_bit.windows(2);
        match pairs.find(|pair| pair[0] - pair[1] <= same_place) {
            Some(pair) => Err(DrillstringError::SitesCoincide { distance: pair[1] }),
            None => Ok(()),
        }
    }

    /// The bit alone.
    pub fn bit() -> Self {
        Self {
            distances_from_bit: vec![0.0],
        }
    }

    /// Number of sites, at least one.
    #[expect(clippy::len_without_is_empty, reason = "there is always one")]
    pub fn len(&self) -> usize {
        self.distances_from_bit.len()
    }

    /// Distances from the bit, m, from the surface down.
    pub fn distances_from_bit(&self) -> &[f64] {
        &self.distances_from_bit
    }

    /// The number of the site that is the bit itself: the last, if any.
    pub fn bit_site(&self) -> Option<usize> {
        let last = self.len() - 1;
        (self.distances_from_bit[last] == 0.0).then_some(last)
    }

    fn depths(&self, string: &Drillstring) -> impl Iterator<Item = f64> {
        let length = string.length();
        self.distances_from_bit
            .iter()
            .map(move |distance| length - distance)
    }
}

/// The string between two neighbouring nodes, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Span {
    pub(crate) runs: Vec<Section>,
}

/// Takes `length` metres off the top of a string held upside down (its top
/// section last, where it is cheap to take).
fn cut_off_top(upside_down: &mut Vec<Section>, length: f64, same_place: f64) -> Span {
    let mut runs = Vec::new();
    let mut left = length;
    while left > same_place {
        let Some(section) = upside_down.pop() else {
            break;
        };
        let cell = section.cell_length();
        let whole = (((left + same_place) / cell).floor() as usize).min(section.repeat);
        let Section { repeat, parts } = section;
        if whole == 0 {
            let (above, beneath) = cut_cell(&parts, left, same_place);
            push_cells(upside_down, repeat - 1, parts);
            push_cells(upside_down, 1, beneath);
            push_cells(&mut runs, 1, above);
            break;
        }
        push_cells(upside_down, repeat - whole, parts.clone());
        push_cells(&mut runs, whole, parts);
        left -= whole as f64 * cell;
    }
    Span { runs }
}

fn push_cells(runs: &mut Vec<Section>, repeat: usize, parts: Vec<Tube>) {
    if repeat > 0 && !parts.is_empty() {
        runs.push(Section { repeat, parts });
    }
}

/// One cell cut `length` metres below its top, without slivers.
fn cut_cell(parts: &[Tube], length: f64, same_place: f64) -> (Vec<Tube>, Vec<Tube>) {
    let (mut above, mut beneath) = (Vec::new(), Vec::new());
    let mut left = length;
    for &part in parts {
        let taken = left.clamp(0.0, part.length);
        for (piece, side) in [(taken, &mut above), (part.length - taken, &mut beneath)] {
            if piece > same_place {
                side.push(Tube {
                    length: piece,
                    ..part
                });
            }
        }
        left -= part.length;
    }
    (above, beneath)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tube(length: f64) -> Tube {
        Tube {
            length,
            inner_radius: 0.05,
            outer_radius: 0.125,
        }
    }

    fn string() -> Drillstring {
        Drillstring::new(
            Material {
                shear_modulus: 80e9,
                density: 7840.0,
            },
            vec![
                Section {
                    repeat: 9,
                    parts: vec![tube(9.5), tube(0.5)],
                },
                Section {
                    repeat: 1,
                    parts: vec![tube(10.0)],
                },
            ],
            10.0,
        )
        .unwrap()
    }

    fn lengths(spans: &[Span]) -> Vec<f64> {
        spans
            .iter()
            .map(|span| span.runs.iter().map(Section::length).sum())
            .collect()
    }

    #[test]
    fn spans_between_sites_have_the_distances_between_them() {
        let string = string();
        let sites = Sites::new(&string, &[0.0, 33.3, 70.0]).unwrap();
        let spans = string.spans(&sites).unwrap();
        for (found, expected) in lengths(&spans).iter().zip([30.0, 36.7, 33.3]) {
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }

    #[test]
    fn what_hangs_below_the_last_site_is_a_span_of_its_own() {
        let string = string();
        let sites = Sites::new(&string, &[25.0]).unwrap();
        assert_eq!(lengths(&string.spans(&sites).unwrap()), [75.0, 25.0]);
    }

    #[test]
    fn a_cut_at_a_joint_leaves_no_sliver() {
        let string = string();
        let sites = Sites::new(&string, &[10.0 + 0.5, 0.0]).unwrap();
        let spans = string.spans(&sites).unwrap();
        let pieces = |span: &Span| {
            span.runs
                .iter()
                .flat_map(|run| run.parts.iter().map(|part| part.length))
                .collect::<Vec<_>>()
        };
        assert!(
            spans
                .iter()
                .flat_map(pieces)
                .all(|length| length > 0.5 - 1e-9)
        );
    }

    #[test]
    fn the_radius_at_a_place_is_that_of_the_tube_there() {
        let mut string = string();
        string.sections[0].parts[1].outer_radius = 0.15;
        for (distance, radius) in [
            (0.0, 0.125),
            (9.9, 0.125),
            (10.2, 0.15),
            (10.7, 0.125),
            (20.4, 0.15),
            (99.0, 0.125),
            (-1.0, 0.125),
            (101.0, 0.125),
        ] {
            assert_eq!(string.outer_radius_at(distance), radius, "{distance}");
        }
    }

    #[test]
    fn what_no_string_can_be_is_refused() {
        let good = string();
        let with = |parts: Vec<Tube>, repeat| {
            Drillstring::new(good.material(), vec![Section { repeat, parts }], 0.0)
        };
        assert!(with(vec![tube(0.0)], 1).is_err());
        assert!(with(vec![tube(-1.0)], 1).is_err());
        assert!(with(vec![tube(f64::NAN)], 1).is_err());
        assert!(with(vec![], 1).is_err());
        assert!(with(vec![tube(1.0)], 0).is_err());
        let inside_out = Tube {
            inner_radius: 0.2,
            ..tube(1.0)
        };
        assert!(with(vec![inside_out], 1).is_err());
        assert!(Sites::new(&good, &[100.0]).is_err());
        assert!(Sites::new(&good, &[-1.0]).is_err());
        assert!(Sites::new(&good, &[5.0, 5.0]).is_err());
        assert!(Sites::new(&good, &[]).is_err());
    }
}
