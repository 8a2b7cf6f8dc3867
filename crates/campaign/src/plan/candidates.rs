//! Which places of a string are likely to touch its hole: the middles of what is wide, or, of a string
//! that lies, the bit, the ends of what is wide, blades, and places between where it would sag.

use super::contacts::{Contact, Hanging, SAME_RADIUS, StringInHole, to_decimals};

/// Candidates are given to a millimetre: the place of a stabiliser is not known more finely.
pub const CANDIDATES_TO: f64 = 1e-3;

/// More candidates than this are more than anybody waits for.
pub const MOST_CANDIDATES: usize = 2000;

/// A span sags by q L⁴/185EI between an end that turns and one that does not. Where the file does not
/// say how far candidates may be apart, it is so far that the string sags between them by no more than
/// this part of its clearance, if it were level and without mud.
pub const SAG: f64 = 0.5;
const SAG_OF_SPAN: f64 = 1.0 / 185.0;

/// Part of the clearance that the string at rest, which is solved at once, sags at most: sixteen spans to half a wave of
/// buckling on the low side, which is π (EI c/q)^¼ long.
pub const SAG_AT_REST: f64 = 97.409 * SAG_OF_SPAN / 65536.0;

/// What is closer to the bit than this, m, touches with it.
const OF_BIT: f64 = 0.5;

/// Which places are candidates.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidates {
    /// By what they are chosen.
    pub at: CandidatePlaces,
    /// How far up from the bit, m.
    pub to: f64,
}

/// By what candidates are chosen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CandidatePlaces {
    /// All of these many metres, from the bit up.
    Every(f64),
    /// The middle of every wide part: what is thrown against its wall touches about there.
    Middles,
    /// The bit, both ends of every wide part, and the middle of blades: there a string touches that
    /// lies in its hole; between them others wherever a span is too long.
    Ends(Spans),
}

/// How long a span between two candidates may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spans {
    /// No longer than this, m.
    Given(f64),
    /// So short that the string hardly sags through its wall between them.
    OfLittleSag {
        /// Young's modulus by density and gravity, m.
        stiffness_by_weight: f64,
        /// The clearance, m, where the hole does not say it.
        clearance: Option<f64>,
        /// The part of that by which it sags at most.
        part: f64,
    },
}

impl StringInHole<'_> {
    /// The candidates, from the bit up.
    pub fn candidates(&self, which: Candidates) -> impl Iterator<Item = Contact> {
        let same_place = self.string.same_place();
        let below_surface = self.string.length() - same_place;
        let found: Box<dyn Iterator<Item = f64>> = match which.at {
            CandidatePlaces::Every(every) => {
                Box::new((0..).map(move |count| f64::from(count) * every))
            }
            CandidatePlaces::Middles => Box::new(self.middles_of_wide_parts(which.to)),
            CandidatePlaces::Ends(spans) => Box::new(
                self.ends_and_between(which.to.min(below_surface), spans)
                    .into_iter(),
            ),
        };
        found
            .map(|distance| to_decimals(distance, 1.0 / CANDIDATES_TO))
            .take_while(move |distance| {
                *distance <= which.to + same_place && *distance < below_surface
            })
            .map(|distance| self.contact(distance))
    }

    /// The middle of every part that is wider than a neighbour, or whose radius of contact is
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
                let mut neighbours = [below.replace(part.radius), above].into_iter().flatten();
                if part.is_given
                    || neighbours.any(|neighbour| part.radius > neighbour + SAME_RADIUS)
                {
                    return Some(0.5 * (part.ends[0] + part.ends[1]));
                }
            }
        })
    }

    /// The bit, the [ends of wide parts](Self::ends_of_wide_parts), and others at even distances between
    /// two that are too far apart, from the bit up to a distance (m).
    fn ends_and_between(&self, to: f64, spans: Spans) -> Vec<f64> {
        let mut places = vec![0.0];
        let ends = self.ends_of_wide_parts(to).into_iter();
        let ends: Vec<f64> = ends.filter(|it| (OF_BIT..=to).contains(it)).collect();
        // Up to where they end the string sags, too.
        for place in ends.iter().copied().chain([to]) {
            let below = places[places.len() - 1];
            let length = place - below;
            let longest = self.longest_span([below, place], spans);
            let count = (length / longest - SAME_RADIUS).ceil().max(1.0);
            // More than that are refused.
            let count = count.min(MOST_CANDIDATES as f64 + 1.0);
            let between = (1..count as usize).map(|it| below + length * it as f64 / count);
            places.extend(between);
            places.push(place);
            if places.len() > MOST_CANDIDATES + 1 {
                break;
            }
        }
        places.pop();
        places
    }

    /// How long a span between two distances from the bit (m) may be, m.
    fn longest_span(&self, [below, above]: [f64; 2], spans: Spans) -> f64 {
        let (stiffness_by_weight, clearance, sag) = match spans {
            Spans::Given(length) => return length,
            Spans::OfLittleSag {
                stiffness_by_weight,
                clearance,
                part,
            } => (stiffness_by_weight, clearance, part),
        };
        let parts = self.parts().skip_while(|part| part.ends[1] <= below);
        let parts = parts.take_while(|part| part.ends[0] < above);
        // Blades have a site.
        let parts = parts.filter(|part| !part.is_given);
        let longest = parts.filter_map(|part| {
            let tube = &self.sections[part.section].parts[part.part];
            let of_hole = || {
                self.contact(0.5 * (part.ends[0] + part.ends[1]))
                    .clearance_mm
            };
            let clearance = clearance.or_else(|| of_hole().map(|it| 1e-3 * it))?;
            // I by area is a quarter of this, and so EI by weight.
            let radii = tube.outer_radius_m.powi(2) + tube.inner_radius_m.powi(2);
            let bending = 0.25 * stiffness_by_weight * radii;
            (clearance > 0.0).then(|| (sag / SAG_OF_SPAN * bending * clearance).sqrt().sqrt())
        });
        longest.fold(f64::INFINITY, f64::min)
    }

    /// The middle of every part whose radius of contact is given, and both ends of every other that
    /// is wider than a neighbour, where no such part is next to them and touches instead; from the
    /// bit up to the first beyond a distance (m).
    fn ends_of_wide_parts(&self, to: f64) -> Vec<f64> {
        let parts: Vec<Hanging> = self.parts().take_while(|part| part.ends[0] <= to).collect();
        let after = self.parts().nth(parts.len());
        let parts: Vec<Hanging> = parts.into_iter().chain(after).collect();
        let mut places: Vec<(f64, Hanging)> = Vec::new();
        for (index, part) in parts.iter().enumerate() {
            let middle = 0.5 * (part.ends[0] + part.ends[1]);
            if part.is_given {
                places.push((middle, *part));
                continue;
            }
            let below = index.checked_sub(1).map(|below| parts[below]);
            let above = parts.get(index + 1).copied();
            let is_wider = |neighbour: Hanging| part.radius > neighbour.radius + SAME_RADIUS;
            if [below, above].into_iter().flatten().any(is_wider) {
                let is_free = |neighbour: Option<Hanging>| neighbour.is_none_or(|it| !it.is_given);
                let is_end = is_free(below) && below.is_some();
                places.extend(is_end.then_some((part.ends[0], *part)));
                places.extend(is_free(above).then_some((part.ends[1], *part)));
            }
        }
        // Where two wide parts meet, the wider touches.
        places.dedup_by(|next, before| {
            let is_same = next.0 - before.0 < CANDIDATES_TO;
            if is_same && next.1.radius > before.1.radius {
                *before = *next;
            }
            is_same
        });
        let within = |(place, part): (f64, Hanging)| {
            let parts_of_metre = place / CANDIDATES_TO;
            // The nearest may be beyond the end.
            let inner = match place {
                it if it == part.ends[0] => (parts_of_metre - 1e-6).ceil(),
                it if it == part.ends[1] => (parts_of_metre + 1e-6).floor(),
                _ => parts_of_metre,
            };
            inner * CANDIDATES_TO
        };
        places.into_iter().map(within).collect()
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::contacts::tests::{assembly, section, string, strings};
    use super::*;
    use crate::sweep_file::SectionTable;

    /// Places of candidates on a string that hangs free.
    fn candidates(sections: &[SectionTable], every: Option<f64>, to: f64) -> Vec<f64> {
        let string = string(sections);
        let in_hole = StringInHole {
            string: &string,
            sections,
            hole: &[],
            drills: false,
        };
        let at = every.map_or(CandidatePlaces::Middles, CandidatePlaces::Every);
        let found = in_hole.candidates(Candidates { at, to });
        found.map(|it| it.distance_from_bit).collect()
    }

    /// The same at the ends of wide parts.
    fn ends(sections: &[SectionTable], to: f64) -> Vec<f64> {
        let string = string(sections);
        let in_hole = StringInHole {
            string: &string,
            sections,
            hole: &[],
            drills: false,
        };
        let at = CandidatePlaces::Ends(Spans::Given(15.0));
        let found = in_hole.candidates(Candidates { at, to });
        found.map(|it| it.distance_from_bit).collect()
    }

    #[test]
    fn candidates_are_where_a_string_is_wider_than_its_neighbours() {
        let none: [f64; 0] = [];
        let everywhere = f64::INFINITY;
        // Of two collars the upper, which is below pipe; of the joints each.
        let all = [1.0, 13.5, 17.75, 27.75, 37.75];
        assert_eq!(candidates(&assembly(), None, everywhere), all);
        assert_eq!(candidates(&assembly(), None, 17.75), all[..3]);
        assert_eq!(candidates(&assembly(), None, 17.7), all[..2]);
        let uniform = [
            section(5, &[(9.0, 0.1, None)]),
            section(1, &[(3.0, 0.1, None)]),
        ];
        assert_eq!(candidates(&uniform, None, everywhere), none);
        // One radius, given in inches and in metres.
        let same = [section(
            1,
            &[(9.0, 0.1016, None), (9.0, 4.0 * 0.0254 + 1e-12, None)],
        )];
        assert_eq!(candidates(&same, None, everywhere), none);
        // A wear band touches where it is no wider than its neighbours.
        let band = [section(2, &[(9.0, 0.1, None), (1.0, 0.09, Some(0.1))])];
        assert_eq!(candidates(&band, None, everywhere), [0.5, 10.5]);
        let taper = [section(
            1,
            &[(9.0, 0.1, None), (3.0, 0.09, None), (1.0, 0.08, None)],
        )];
        assert_eq!(candidates(&taper, None, everywhere), [2.5, 8.5]);
    }

    #[test]
    fn candidates_at_even_distances_begin_at_the_bit_and_end_below_the_surface() {
        let even = candidates(&assembly(), Some(9.5), f64::INFINITY);
        assert_eq!(even, [0.0, 9.5, 19.0, 28.5, 38.0]);
        assert_eq!(
            candidates(&assembly(), Some(0.1), 0.3),
            [0.0, 0.1, 0.2, 0.3]
        );
        assert_eq!(candidates(&assembly(), Some(100.0), f64::INFINITY), [0.0]);
    }

    #[test]
    fn a_string_that_lies_touches_with_the_ends_of_its_wide_parts() {
        let everywhere = f64::INFINITY;
        // The middle of blades; of the collars what pipe is above; of joints both ends.
        let all = [0.0, 1.0, 9.5, 17.5, 18.0, 27.5, 28.0, 37.5, 38.0];
        assert_eq!(ends(&assembly(), everywhere), all);
        assert_eq!(ends(&assembly(), 17.5), all[..4]);
        assert_eq!(ends(&assembly(), 0.7), [0.0]);
        // Next to blades the blades touch.
        let bladed = [section(
            1,
            &[
                (9.0, 0.06, None),
                (1.0, 0.08, None),
                (1.0, 0.05, Some(0.1)),
                (2.0, 0.06, None),
            ],
        )];
        assert_eq!(ends(&bladed, everywhere), [0.0, 2.5, 4.0]);
        let bit = [section(1, &[(9.0, 0.06, None), (0.5, 0.1, None)])];
        assert_eq!(ends(&bit, everywhere), [0.0, 0.5]);
        // A short bit with a gauge touches as the bit.
        let gauge = [section(1, &[(9.0, 0.06, None), (0.4, 0.1, Some(0.15))])];
        assert_eq!(ends(&gauge, everywhere), [0.0]);
    }

    #[test]
    fn a_string_that_lies_may_touch_between_the_ends_of_long_parts() {
        let pipe = [section(1, &[(60.5, 0.06, None)])];
        let every = [0.0, 12.1, 24.2, 36.3, 48.4];
        assert_eq!(ends(&pipe, f64::INFINITY), every);
        assert_eq!(ends(&pipe, 45.0), [0.0, 15.0, 30.0]);
        let collars = [section(
            1,
            &[(40.0, 0.06, None), (31.0, 0.1, None), (10.0, 0.08, None)],
        )];
        let between = [0.0, 10.0, 20.333, 30.667, 41.0, 54.333, 67.667];
        assert_eq!(ends(&collars, f64::INFINITY), between);
    }

    proptest! {
        /// For every part it is decided by hand whether it is wide.
        #[test]
        fn every_wide_part_is_a_candidate_and_no_other(sections in strings()) {
            let string = string(&sections);
            let in_hole = StringInHole { string: &string, sections: &sections, hole: &[], drills: false };
            let parts: Vec<Hanging> = in_hole.parts().collect();
            let middles = parts.iter().enumerate().filter(|(index, part)| {
                let below = index.checked_sub(1).map(|below| parts[below].radius);
                let above = parts.get(index + 1).map(|above| above.radius);
                let least = below.into_iter().chain(above).fold(f64::INFINITY, f64::min);
                part.is_given || part.radius > least + SAME_RADIUS
            });
            let middles: Vec<f64> = middles
                .map(|(_, part)| 0.5 * (part.ends[0] + part.ends[1]))
                .collect();
            let found = candidates(&sections, None, f64::INFINITY);
            prop_assert_eq!(found.len(), middles.len());
            for (found, middle) in found.iter().zip(middles) {
                prop_assert!((found - middle).abs() <= 0.51 * CANDIDATES_TO);
            }
        }
    }
}
