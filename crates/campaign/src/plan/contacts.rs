//! Where a string may touch its wall: how wide it is there, how much clearance the hole leaves it,
//! and which places are likely to touch. Geometry alone, of the string in the middle of its hole.

use linear::{Drillstring, HoleSection};

use super::full_gauge::{self, depths};
use crate::sweep_file::{SectionTable, ToolKind, diameter_in_name};

/// Radii that differ by no more than this, m, are the same: one may be given in inches.
pub(super) const SAME_RADIUS: f64 = 1e-6;

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
    /// Whether a bit is at its end, regardless of what that is called.
    pub drills: bool,
}

/// A part of the string, where it hangs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hanging {
    pub(super) section: usize,
    pub(super) part: usize,
    /// Distances of its lower and its upper end from the bit, m.
    pub(super) ends: [f64; 2],
    /// Radius with which it touches, m.
    pub(super) radius: f64,
    /// Whether the file says that radius.
    pub(super) is_given: bool,
}

impl Hanging {
    /// Whether it is the bit, or has blades.
    fn is_of_gauge(&self, of: &StringInHole) -> bool {
        self.is_given || self.ends[0] <= of.string.same_place()
    }
}

impl StringInHole<'_> {
    /// How it is at a distance from the bit (m). At a joint between two parts the wider touches,
    /// and where two sections of hole meet the narrower is touched.
    pub fn contact(&self, distance_from_bit: f64) -> Contact {
        let parts = self.string.parts_around(distance_from_bit);
        let tubes = parts.map(|(section, part)| &self.sections[section].parts[part]);
        let radius = tubes[0].contact_radius().max(tubes[1].contact_radius());
        let has_blades = (tubes.iter())
            .any(|tube| tube.contact_radius() == radius && tube.contact_radius_m.is_some());
        let same_place = self.string.same_place();
        let is_bit = distance_from_bit <= self.lowest_length() + same_place;
        let is_of_gauge = has_blades || is_bit;
        let gauge = self
            .bit_radius()
            .filter(|_| distance_from_bit <= same_place);
        let radius = gauge.map_or(radius, |gauge| gauge.max(radius));
        let hole = self.hole_radius(self.depth(distance_from_bit));
        Contact {
            distance_from_bit,
            radius,
            clearance_mm: hole.map(|hole| {
                to_decimals(1e3 * full_gauge::clearance(hole, radius, is_of_gauge), 1e6)
            }),
        }
    }

    /// Length of the lowest part: of the bit, where the string has one.
    fn lowest_length(&self) -> f64 {
        let lowest = self
            .sections
            .last()
            .and_then(|section| section.parts.last());
        lowest.map_or(0.0, |part| part.length_m)
    }

    /// Radius with which the bit drills and touches its hole, m: that of its gauge where it is given, else
    /// that which its name says, but no more than that of the hole, and else that of the hole at its
    /// end; none where no bit is there, or nothing says its size.
    pub fn bit_radius(&self) -> Option<f64> {
        let lowest = self.sections.last()?;
        let part = lowest.parts.last()?;
        let name = lowest.name.as_deref().unwrap_or_default();
        if !self.drills && ToolKind::of(name, "") != ToolKind::Bit {
            return None;
        }
        let hole = self.hole_radius(self.depth(0.0));
        let named = diameter_in_name(name)
            .map(|diameter| (0.5 * diameter).min(hole.unwrap_or(f64::INFINITY)));
        let radius = part.contact_radius_m.or(named).or(hole)?;
        Some(radius.max(part.contact_radius()))
    }

    /// The clearance along the string: corners by depth and clearance, m, from the surface down to
    /// the bit, or to the end of the hole. It is level between two corners or, at the same depth,
    /// changes from one to the other.
    pub fn clearances(&self) -> Vec<(f64, f64)> {
        let mut corners: Vec<(f64, f64)> = Vec::new();
        let mut parts: Vec<Hanging> = self.parts().collect();
        parts.reverse();
        for part in parts {
            let [bottom, top] = part.ends.map(|end| self.depth(end));
            for (from, to, radius) in depths(self.hole) {
                let (from, to) = (from.max(top), to.min(bottom));
                if from >= to {
                    continue;
                }
                let clearance = full_gauge::clearance(radius, part.radius, part.is_of_gauge(self));
                match corners.last_mut() {
                    // The same as above continues.
                    Some(last) if (last.1 - clearance).abs() <= SAME_RADIUS => last.0 = to,
                    _ => corners.extend([(from, clearance), (to, clearance)]),
                }
            }
        }
        corners
    }

    /// The lowest part that does not fit into the hole, if there is one.
    pub fn too_wide(&self) -> Option<TooWide> {
        let same_place = self.string.same_place();
        self.parts().find_map(|hanging| {
            let [bottom, top] = hanging.ends.map(|end| self.depth(end));
            let mut sections = depths(self.hole);
            let narrow = sections.find(|(from, to, radius)| {
                let is_around = *from < bottom - same_place && *to > top + same_place;
                let drilled_it =
                    hanging.is_of_gauge(self) && full_gauge::fits(*radius, hanging.radius);
                is_around && hanging.radius >= *radius && !drilled_it
            });
            narrow.map(|(from, _, hole_radius)| TooWide {
                section: hanging.section,
                part: hanging.part,
                radius: hanging.radius,
                depth: to_decimals(top.max(from), 1e9),
                hole_radius,
            })
        })
    }

    /// The hole as mud has it, which passes what drilled it.
    pub fn with_waterways(&self) -> Vec<HoleSection> {
        let parts = self.parts().map(|part| {
            let [bottom, top] = part.ends.map(|end| self.depth(end));
            let tube = &self.sections[part.section].parts[part.part];
            (top, bottom, tube.outer_radius_m)
        });
        full_gauge::with_waterways(self.hole, parts, self.string.same_place())
    }

    /// The depth (m) at a distance from the bit (m).
    pub fn depth(&self, distance_from_bit: f64) -> f64 {
        to_decimals(self.string.length() - distance_from_bit, 1e9)
    }

    /// Where the hole ends, as depth, m.
    pub fn depth_of_hole(&self) -> f64 {
        let length = self.hole.iter().map(|section| section.length).sum();
        to_decimals(length, 1e9)
    }

    /// Radius of the hole at a depth (m), if it goes so deep.
    fn hole_radius(&self, depth: f64) -> Option<f64> {
        let same_place = self.string.same_place();
        depths(self.hole)
            .filter(|(from, to, _)| *from - same_place <= depth && depth <= *to + same_place)
            .map(|(.., radius)| radius)
            .reduce(f64::min)
    }

    /// All parts, from the bit up.
    pub(super) fn parts(&self) -> impl Iterator<Item = Hanging> {
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

/// The nearest decimal in a number of parts of one, as a person would write it: sums and
/// differences of lengths are off by a rounding.
pub(super) fn to_decimals(value: f64, parts: f64) -> f64 {
    (value * parts).round() / parts
}

#[cfg(test)]
pub(super) mod tests {
    use linear::{Material, Section, Tube};
    use proptest::prelude::*;

    use super::*;
    use crate::sweep_file::TubeTable;

    /// A section by its cells and, from the top down, length, outer radius and perhaps radius of
    /// contact of its parts, m.
    pub fn section(repeat: usize, parts: &[(f64, f64, Option<f64>)]) -> SectionTable {
        let part =
            |&(length_m, outer_radius_m, contact_radius_m): &(f64, f64, Option<f64>)| TubeTable {
                length_m,
                inner_radius_m: 0.03,
                outer_radius_m,
                contact_radius_m,
            };
        SectionTable {
            name: None,
            repeat,
            parts: parts.iter().map(part).collect(),
        }
    }

    pub fn string(sections: &[SectionTable]) -> Drillstring {
        let tube = |part: &TubeTable| Tube {
            length: part.length_m,
            inner_radius: part.inner_radius_m,
            outer_radius: part.outer_radius_m,
        };
        let section = |section: &SectionTable| Section {
            repeat: section.repeat,
            parts: section.parts.iter().map(tube).collect(),
        };
        let steel = Material {
            shear_modulus: 80e9,
            density: 7850.0,
        };
        Drillstring::new(steel, sections.iter().map(section).collect(), 1.0).unwrap()
    }

    fn hole(sections: &[(f64, f64)]) -> Vec<HoleSection> {
        let section = |&(length, radius): &(f64, f64)| HoleSection { length, radius };
        sections.iter().map(section).collect()
    }

    /// Pipe with joints, collars, a stabiliser and a bit: 47.5 m.
    pub fn assembly() -> Vec<SectionTable> {
        vec![
            section(3, &[(9.5, 0.06, None), (0.5, 0.08, None)]),
            section(2, &[(8.0, 0.1, None)]),
            section(1, &[(1.0, 0.1, Some(0.15))]),
            section(1, &[(0.5, 0.1, None)]),
        ]
    }

    /// Casing, open hole with a washout.
    #[test]
    fn clearances_are_those_by_hand() {
        let sections = assembly();
        let string = string(&sections);
        let in_hole = StringInHole {
            string: &string,
            sections: &sections,
            hole: &hole(&[(30.0, 0.2), (10.0, 0.16), (4.0, 0.25), (2.5, 0.16)]),
            drills: false,
        };
        for (distance, radius, clearance_mm) in [
            // Beyond the end of the hole, at 46.5 m.
            (0.9, 0.15, None),
            (1.0, 0.15, Some(10.0)),
            (1.5, 0.15, Some(10.0)),
            (5.0, 0.1, Some(150.0)),
            // The washout begins there.
            (7.5, 0.1, Some(60.0)),
            (13.5, 0.1, Some(60.0)),
            // The casing ends there, and the collar.
            (17.5, 0.1, Some(60.0)),
            (17.75, 0.08, Some(120.0)),
            (18.0, 0.08, Some(120.0)),
            (18.1, 0.06, Some(140.0)),
            (47.5, 0.06, Some(140.0)),
        ] {
            let expected = Contact {
                distance_from_bit: distance,
                radius,
                clearance_mm,
            };
            assert_eq!(in_hole.contact(distance), expected);
        }
        assert_eq!(in_hole.too_wide(), None);
    }

    /// A bit touches as wide as it drills: by its gauge, its name or its hole, not by its shank.
    #[test]
    fn a_bit_touches_with_what_it_drills() {
        let touches = |name: Option<&str>, gauge: Option<f64>, radius: f64, drills: bool| {
            let mut sections = assembly();
            sections[3].name = name.map(str::to_owned);
            sections[3].parts[0].contact_radius_m = gauge;
            let string = string(&sections);
            let in_hole = StringInHole {
                string: &string,
                sections: &sections,
                hole: &hole(&[(60.0, radius)]),
                drills,
            };
            let bit = in_hole.contact(0.0);
            (bit.radius, bit.clearance_mm)
        };
        let named = Some("12 1/4 in PDC bit");
        let size = 0.5 * 12.25 * 0.0254;
        assert_eq!(touches(named, None, size, false), (size, Some(0.4)));
        assert_eq!(touches(named, None, 0.16, false), (size, Some(4.425)));
        assert_eq!(touches(named, Some(0.152), 0.16, false), (0.152, Some(8.0)));
        // No wider than its hole, which it has drilled.
        assert_eq!(touches(named, None, 0.152, false), (0.152, Some(0.4)));
        assert_eq!(touches(Some("Bit"), None, 0.16, false), (0.16, Some(0.4)));
        assert_eq!(touches(None, None, 0.16, true), (0.16, Some(0.4)));
        // Nothing says that it is a bit.
        assert_eq!(touches(Some("Shoe"), None, 0.16, false), (0.1, Some(60.0)));
    }

    #[test]
    fn the_lowest_part_that_is_too_wide_is_reported_with_where_it_jams() {
        let sections = assembly();
        let string = string(&sections);
        let too_wide = |sections_of_hole: &[(f64, f64)]| {
            let hole = hole(sections_of_hole);
            let in_hole = StringInHole {
                string: &string,
                sections: &sections,
                hole: &hole,
                drills: false,
            };
            let found = in_hole.too_wide();
            found.map(|it| (it.section, it.radius, it.depth, it.hole_radius))
        };
        // By its blades, not its body; those of full gauge fit.
        let narrow = [(46.6, 0.2), (9.0, 0.1495)];
        assert_eq!(too_wide(&narrow), Some((2, 0.15, 46.6, 0.1495)));
        assert_eq!(too_wide(&[(46.6, 0.2), (9.0, 0.15)]), None);
        // Collars are not.
        assert!(too_wide(&[(60.0, 0.1)]).is_some());
        assert_eq!(too_wide(&[(47.0, 0.2), (9.0, 0.11)]), None);
        // A joint next to a stretch that is narrow over less than its length.
        let stretch = [(9.6, 0.2), (0.1, 0.07), (40.0, 0.2)];
        assert_eq!(too_wide(&stretch), Some((0, 0.08, 9.6, 0.07)));
        assert_eq!(too_wide(&[]), None);
    }

    prop_compose! {
        /// Strings of 1 to 4 sections of 1 to 20 cells.
        pub fn strings()(sections in proptest::collection::vec(
            (1usize..20, proptest::collection::vec((0.1f64..12.0, 0.05f64..0.2, proptest::option::of(0.2f64..0.3)), 1..4)),
            1..5,
        )) -> Vec<SectionTable> {
            sections.iter().map(|(repeat, parts)| section(*repeat, parts)).collect()
        }
    }

    proptest! {
        /// What is found by dividing lengths is what is found by walking from part to part.
        #[test]
        fn a_radius_is_that_of_the_part_at_the_place(
            sections in strings(),
            place in 0.0f64..1.0,
        ) {
            let string = string(&sections);
            let in_hole = StringInHole { string: &string, sections: &sections, hole: &[], drills: false };
            let ends = in_hole.parts().map(|part| part.ends[1]).collect::<Vec<_>>();
            let same_place = string.same_place();
            let at_joint = ends[(place * ends.len() as f64) as usize];
            for distance in [place * string.length(), at_joint] {
                let there = in_hole.parts().filter(|part| {
                    part.ends[0] <= distance + same_place && distance - same_place <= part.ends[1]
                });
                let widest = there.map(|part| part.radius).reduce(f64::max);
                prop_assert_eq!(Some(in_hole.contact(distance).radius), widest);
            }
        }
    }
}
