//! A bit, and blades, of full gauge in the hole that they drilled, which is hardly wider.

use linear::HoleSection;

/// What is as wide as its hole up to this has drilled it, m.
const SAME_WIDTH: f64 = 1e-4;

/// A hole is wider than the bit that drilled it by this all around, m: 1/64 in.
const OVER_GAUGE: f64 = 0.4e-3;

/// The part of the hole that a bit, or a tool with blades, fills: mud passes through the rest.
const FILLED: f64 = 0.8;

/// The clearance that a hole leaves to what touches it with a radius, m, and may have drilled it.
pub fn clearance(hole: f64, radius: f64, may_have_drilled_it: bool) -> f64 {
    let clearance = hole - radius;
    match may_have_drilled_it && clearance.abs() <= SAME_WIDTH {
        true => OVER_GAUGE,
        false => clearance,
    }
}

/// Whether what drilled a hole, with a radius (m), is no wider than that.
pub fn fits(hole: f64, radius: f64) -> bool {
    radius <= hole + SAME_WIDTH
}

/// A hole as mud has it: around each of the parts (from a depth to another, and with an outer
/// radius, m) that is as wide as the hole it is wider by the waterways.
pub fn with_waterways(
    hole: &[HoleSection],
    parts: impl Iterator<Item = (f64, f64, f64)>,
    same_place: f64,
) -> Vec<HoleSection> {
    let mut narrow: Vec<(f64, f64, f64)> = Vec::new();
    for (top, bottom, outer_radius) in parts {
        let around =
            depths(hole).filter(|(.., radius)| (outer_radius - radius).abs() <= SAME_WIDTH);
        let shared = around.map(|(from, to, _)| (from.max(top), to.min(bottom)));
        let shared = shared.filter(|(from, to)| from < to);
        narrow.extend(shared.map(|(from, to)| (from, to, outer_radius / FILLED.sqrt())));
    }
    if narrow.is_empty() {
        return hole.to_vec();
    }
    let mut ends: Vec<f64> = depths(hole).map(|(_, to, _)| to).collect();
    ends.extend(narrow.iter().flat_map(|(from, to, _)| [*from, *to]));
    ends.sort_by(f64::total_cmp);
    let radius_at = |depth: f64| {
        let is_there = |(from, to, _): &(f64, f64, f64)| (*from..*to).contains(&depth);
        let of_part = narrow.iter().copied().find(is_there);
        of_part.or_else(|| depths(hole).find(is_there))
    };
    let mut from = 0.0;
    let mut sections = Vec::new();
    for to in ends {
        if to - from > same_place {
            let radius = radius_at(0.5 * (from + to)).map(|(.., radius)| radius);
            sections.extend(radius.map(|radius| HoleSection {
                length: to - from,
                radius,
            }));
            from = to;
        }
    }
    sections
}

/// From which depth to which each section of a hole goes, m, and its radius.
pub fn depths(hole: &[HoleSection]) -> impl Iterator<Item = (f64, f64, f64)> {
    let mut depth = 0.0;
    hole.iter().map(move |section| {
        let from = depth;
        depth += section.length;
        (from, depth, section.radius)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A bit of 0.3 m at the end of 100 m of hole, half of it cased.
    #[test]
    fn mud_passes_the_bit_through_a_fifth_of_the_hole() {
        let section = |length, radius| HoleSection { length, radius };
        let hole = [section(50.0, 0.2), section(60.0, 0.15)];
        let parts = || [(0.0, 99.7, 0.1), (99.7, 100.0, 0.15)].into_iter();
        let found = with_waterways(&hole, parts(), 1e-6);
        let lengths: Vec<f64> = found.iter().map(|it| it.length).collect();
        for (length, expected) in lengths.iter().zip([50.0, 49.7, 0.3, 10.0]) {
            assert!((length - expected).abs() < 1e-9, "{lengths:?}");
        }
        let bit = found[2].radius;
        assert!(
            (0.15_f64.powi(2) / bit.powi(2) - 0.8).abs() < 1e-12,
            "{bit}"
        );
        assert_eq!([found[1].radius, found[3].radius], [0.15, 0.15]);
        assert_eq!(with_waterways(&hole, parts().take(1), 1e-6), hole);
    }

    #[test]
    fn only_what_drilled_the_hole_may_be_as_wide() {
        assert_eq!(clearance(0.15, 0.15, true), OVER_GAUGE);
        assert_eq!(clearance(0.15, 0.15, false), 0.0);
        assert!(fits(0.15, 0.15) && !fits(0.15, 0.151));
    }
}
