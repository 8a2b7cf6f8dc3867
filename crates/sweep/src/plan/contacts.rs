//! Where a string may touch its wall: how wide it is there, how much clearance the hole leaves it,
//! and which places are likely to touch. Geometry alone, of the string in the middle of its hole.

use linear::{Drillstring, HoleSection};

use crate::sweep_file::SectionTable;

/// Radii that differ by no more than this, m, are the same: one may be given in inches.
const SAME_RADIUS: f64 = 1e-6;

/// A place where the string may touch the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Distance from the bit, m.
    pub distance_from_bit: f64,
    /// Radius with which the string touches the wall there, m.
    pub radius: f64,
    /// Clearance that the hole leaves, mm; none where there is no hole. Not positive where the
    /// string does not fit.
    pub clearance_mm: Option<f64>,
}

/// Which places are candidates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidates {
    /// All of these many metres, from the bit up; left out, the middle of every wide part.
    pub every: Option<f64>,
    /// How far up from the bit, m.
    pub to: f64,
}

/// A part of the string that is as wide as its hole, or wider.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TooWide {
    /// In which section it is.
    pub section: usize,
    /// Which part of its cell it is.
    pub part: usize,
    /// Radius with which it touches, m.
    pub radius: f64,
    /// Where it does not fit first, as depth, m.
    pub depth: f64,
    /// Radius of the hole there, m.
    pub hole_radius: f64,
}

/// A string in its hole.
#[derive(Debug, Clone, Copy)]
pub struct StringInHole<'a> {
    /// The string.
    pub string: &'a Drillstring,
    /// Its sections as the file has them, which says with what they touch.
    pub sections: &'a [SectionTable],
    /// Its hole, from the surface down; empty where it is not known.
    pub hole: &'a [HoleSection],
}

/// A part of the string, where it hangs.
#[derive(Debug, Clone, Copy)]
struct Hanging {
    section: usize,
    part: usize,
    /// Distances of its lower and its upper end from the bit, m.
    ends: [f64; 2],
    /// Radius with which it touches, m.
    radius: f64,
    /// Whether the file says that radius.
    is_given: bool,
}

impl StringInHole<'_> {
    /// How it is at a distance from the bit (m). At a joint between two parts the wider touches,
    /// and where two sections of hole meet the narrower is touched.
    pub fn contact(&self, distance_from_bit: f64) -> Contact {
        let parts = self.string.parts_around(distance_from_bit);
        let radii =
            parts.map(|(section, part)| self.sections[section].parts[part].contact_radius());
        let radius = radii[0].max(radii[1]);
        let hole = self.hole_radius(self.string.length() - distance_from_bit);
        Contact {
            distance_from_bit,
            radius,
            clearance_mm: hole.map(|hole| to_decimals(1e3 * (hole - radius), 1e6)),
        }
    }

    /// The candidates, from the bit up.
    pub fn candidates(&self, which: Candidates) -> impl Iterator<Item = Contact> {
        let of_parts = which
            .every
            .is_none()
            .then(|| self.middles_of_wide_parts(which.to));
        let even = (which.every.into_iter())
            .flat_map(|every| (0..).map(move |count| f64::from(count) * every));
        let same_place = self.string.same_place();
        let below_surface = self.string.length() - same_place;
        (of_parts.into_iter().flatten().chain(even))
            .map(|distance| to_decimals(distance, 1e9))
            .take_while(move |distance| {
                *distance <= which.to + same_place && *distance < below_surface
            })
            .map(|distance| self.contact(distance))
    }

    /// The lowest part that does not fit into the hole, if there is one.
    pub fn too_wide(&self) -> Option<TooWide> {
        let length = self.string.length();
        let same_place = self.string.same_place();
        let mut parts = self.parts();
        parts.find_map(|hanging| {
            let [bottom, top] = hanging.ends.map(|end| length - end);
            let mut sections = depths(self.hole);
            let narrow = sections.find(|(from, to, radius)| {
                let is_around = *from < bottom - same_place && *to > top + same_place;
                is_around && hanging.radius >= *radius
            });
            narrow.map(|(from, _, hole_radius)| TooWide {
                section: hanging.section,
                part: hanging.part,
                radius: hanging.radius,
                depth: top.max(from),
                hole_radius,
            })
        })
    }

    /// Where the hole ends, as depth, m.
    pub fn depth_of_hole(&self) -> f64 {
        self.hole.iter().map(|section| section.length).sum()
    }

    /// Radius of the hole at a depth (m), if it goes so deep.
    fn hole_radius(&self, depth: f64) -> Option<f64> {
        let same_place = self.string.same_place();
        depths(self.hole)
            .filter(|(from, to, _)| *from - same_place <= depth && depth <= *to + same_place)
            .map(|(.., radius)| radius)
            .reduce(f64::min)
    }

    /// The middle of every part that is wider than one beside it, or whose radius of contact is
    /// given, up to a distance from the bit (m).
    fn middles_of_wide_parts(&self, to: f64) -> impl Iterator<Item = f64> {
        let mut parts = self.parts().peekable();
        let mut below = None;
        std::iter::from_fn(move || {
            loop {
                let part = parts.next()?;
                if part.ends[0] > to {
                    return None;
                }
                let above = parts.peek().map(|above| above.radius);
                let mut beside = [below.replace(part.radius), above].into_iter().flatten();
                if part.is_given || beside.any(|beside| part.radius > beside + SAME_RADIUS) {
                    return Some(0.5 * (part.ends[0] + part.ends[1]));
                }
            }
        })
    }

    /// All parts, from the bit up.
    fn parts(&self) -> impl Iterator<Item = Hanging> {
        let mut end = 0.0;
        let sections = self.sections.iter().enumerate().rev();
        sections.flat_map(move |(index, section)| {
            let cell: f64 = section.parts.iter().map(|part| part.length_m).sum();
            let start = end;
            end += section.repeat as f64 * cell;
            (0..section.repeat).flat_map(move |count| {
                let mut upper = start + count as f64 * cell;
                (section.parts.iter().enumerate().rev()).map(move |(part, tube)| {
                    let lower = upper;
                    upper += tube.length_m;
                    Hanging {
                        section: index,
                        part,
                        ends: [lower, upper],
                        radius: tube.contact_radius(),
                        is_given: tube.contact_radius_m.is_some(),
                    }
                })
            })
        })
    }
}

/// From which depth to which each section of a hole goes, m, and its radius.
fn depths(hole: &[HoleSection]) -> impl Iterator<Item = (f64, f64, f64)> {
    let mut depth = 0.0;
    hole.iter().map(move |section| {
        let from = depth;
        depth += section.length;
        (from, depth, section.radius)
    })
}

/// The nearest decimal of so many parts of one, such as a person would write: sums and differences
/// of lengths are off by a rounding.
fn to_decimals(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts
}
