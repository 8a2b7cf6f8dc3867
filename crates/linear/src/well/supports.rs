//! What each part of a string lies on: pipe on its joints, collars between two stabilisers on these,
//! and any part that sags to the wall between wider ones on itself.

use std::ops::Range;

use super::GRAVITY;
use crate::drillstring::{Drillstring, Tube};

/// Young's modulus over the shear modulus of steel: 2(1 + ν) with Poisson's ratio ν = 0.3.
const YOUNGS_OVER_SHEAR_MODULUS: f64 = 2.6;

/// A beam under an even load q, clamped at both ends of a length L, sags by q L⁴ over this times its
/// rigidity EI: pipe over a joint is level there, as it sags as much on either side.
const CLAMPED: f64 = 384.0;

/// What carries one part of a string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Supports {
    /// Outer radius of what lies on the wall above the part, m; its own where it lies there itself.
    above: f64,
    /// The same below it.
    below: f64,
    /// Half way between the two, m from the surface.
    middle: f64,
}

impl Supports {
    /// Outer radius of what carries a length of the part about a depth, both in m: of the nearer of
    /// the two, in the mean.
    pub(super) fn mean_radius(&self, depth: f64, length: f64) -> f64 {
        let above = ((self.middle - depth) / length + 0.5).clamp(0.0, 1.0);
        above * self.above + (1.0 - above) * self.below
    }
}

/// What carries each part of a string from the surface down, cells that repeat one after the other,
/// `heavier` than what is around it by so much (kg/m³). A part is carried by the nearest wider ones
/// above and below it if between them, level, it sags by less than they are wider, and so on where
/// those are carried. The ends of the string are held. `contact_radii` are those with which each part of
/// each section touches the wall, m.
pub(super) fn supports(
    string: &Drillstring,
    contact_radii: &[Vec<f64>],
    heavier: f64,
) -> Vec<Supports> {
    let placed = placed(string, contact_radii);
    let mut supports: Vec<Supports> = placed.iter().map(Placed::alone).collect();
    let mut widest_first: Vec<usize> = (0..placed.len()).collect();
    widest_first.sort_by(|&one, &other| {
        let radius = |index: usize| placed[index].radius;
        radius(other).total_cmp(&radius(one))
    });
    let above = nearest_wider(placed.iter());
    let mut below = nearest_wider(placed.iter().rev());
    below.reverse();
    let last = placed.len() - 1;
    let rigidity = YOUNGS_OVER_SHEAR_MODULUS * string.material().shear_modulus;
    for index in widest_first {
        let carriers = [above[index], below[index].map(|it| last - it)];
        let [top, bottom] = carriers;
        let from = top.map_or(0.0, |it| placed[it].depths.end);
        let to = bottom.map_or(placed[last].depths.end, |it| placed[it].depths.start);
        let part = placed[index].part;
        let wider = carriers.into_iter().flatten();
        let wider = wider.map(|it| placed[it].radius - placed[index].radius);
        let weight = heavier * part.area() * GRAVITY;
        let sag = weight * (to - from).powi(4) / (CLAMPED * rigidity * part.second_moment());
        // Without a carrier there is nothing that it could sag less than.
        if sag < wider.reduce(f64::min).unwrap_or(0.0) {
            let upper = top.map(|it| supports[it].below);
            let lower = bottom.map(|it| supports[it].above);
            let own = placed[index].radius;
            supports[index] = Supports {
                above: upper.or(lower).unwrap_or(own),
                below: lower.or(upper).unwrap_or(own),
                middle: 0.5 * (from + to),
            };
        }
    }
    supports
}

/// A part in its place.
struct Placed<'string> {
    part: &'string Tube,
    /// With which it touches the wall, m.
    radius: f64,
    /// From the surface, m.
    depths: Range<f64>,
}

impl Placed<'_> {
    /// It lies on itself.
    fn alone(&self) -> Supports {
        Supports {
            above: self.radius,
            below: self.radius,
            middle: self.depths.start,
        }
    }
}

fn placed<'string>(
    string: &'string Drillstring,
    contact_radii: &[Vec<f64>],
) -> Vec<Placed<'string>> {
    let mut placed = Vec::new();
    let mut top = 0.0;
    for (section, radii) in string.sections().iter().zip(contact_radii) {
        for _ in 0..section.repeat {
            for (part, &radius) in section.parts.iter().zip(radii) {
                let bottom = top + part.length;
                let depths = top..bottom;
                placed.push(Placed {
                    part,
                    radius,
                    depths,
                });
                top = bottom;
            }
        }
    }
    placed
}

/// The nearest wider part before each, by its number in this order.
fn nearest_wider<'string>(
    parts: impl Iterator<Item = &'string Placed<'string>>,
) -> Vec<Option<usize>> {
    // Those before the part that nothing nearer hides, from the widest to the narrowest.
    let mut seen: Vec<(usize, f64)> = Vec::new();
    let nearest = |(index, placed): (usize, &Placed)| {
        let radius = placed.radius;
        while seen.last().is_some_and(|(_, other)| *other <= radius) {
            seen.pop();
        }
        let nearest = seen.last().map(|(index, _)| *index);
        seen.push((index, radius));
        nearest
    };
    parts.enumerate().map(nearest).collect()
}
