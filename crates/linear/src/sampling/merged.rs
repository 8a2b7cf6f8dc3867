//! A string independent of how its lengths were divided: equal neighbours become one tube, and
//! repetitions one section.

use crate::drillstring::{Drillstring, Section, Tube};
use crate::error::DrillstringError;

/// Lengths are rounded to this, m: parts that were cut and put together again are as long as
/// before only up to rounding.
const ROUNDED_TO: f64 = 1e-6;

/// Radii differ by more than this, m, where tubes do.
const SAME_RADIUS: f64 = 1e-9;

/// Most parts of what repeats: a pipe, its joint in halves, and a few more.
const MOST_PARTS: usize = 8;

/// The same string in torsion with its equal neighbours joined and what repeats in sections,
/// under the same drive and with the same loss; without what surrounds it, viscous mud apart.
///
/// # Errors
/// Where the string is so short that rounding leaves nothing of it.
pub fn merged(string: &Drillstring) -> Result<Drillstring, DrillstringError> {
    let sections = sections(&tubes(string));
    let merged = Drillstring::new(string.material(), sections, string.torsional_damping())?
        .with_loss_of(string)?;
    match string.top_drive() {
        None => Ok(merged),
        Some(drive) => merged.with_top_drive(drive),
    }
}

/// Tubes from the surface down, no two equal ones next to each other.
fn tubes(string: &Drillstring) -> Vec<Tube> {
    let mut tubes: Vec<Tube> = Vec::new();
    for section in string.sections() {
        for part in (0..section.repeat).flat_map(|_| &section.parts) {
            match tubes.last_mut().filter(|last| are_alike(last, part)) {
                Some(last) => last.length += part.length,
                None => tubes.push(*part),
            }
        }
    }
    for tube in &mut tubes {
        tube.length = (tube.length / ROUNDED_TO).round().max(1.0) * ROUNDED_TO;
    }
    tubes
}

fn are_alike(one: &Tube, other: &Tube) -> bool {
    (one.inner_radius - other.inner_radius).abs() < SAME_RADIUS
        && (one.outer_radius - other.outer_radius).abs() < SAME_RADIUS
}

fn are_equal(one: &Tube, other: &Tube) -> bool {
    are_alike(one, other) && (one.length - other.length).abs() < 0.5 * ROUNDED_TO
}

/// The tubes in sections: at each place the pattern that covers most of what follows.
fn sections(tubes: &[Tube]) -> Vec<Section> {
    let (mut sections, mut place): (Vec<Section>, usize) = (Vec::new(), 0);
    while place < tubes.len() {
        let left = &tubes[place..];
        let (parts, repeat) = (1..=MOST_PARTS.min(left.len()))
            .map(|parts| (parts, repeats(left, parts)))
            .filter(|(_, repeat)| *repeat > 1)
            .max_by_key(|(parts, repeat)| (parts * repeat, usize::MAX - parts))
            .unwrap_or((1, 1));
        sections.push(Section {
            repeat,
            parts: left[..parts].to_vec(),
        });
        place += parts * repeat;
    }
    sections
}

/// How often a number of tubes, the first ones, come one after the other.
fn repeats(tubes: &[Tube], parts: usize) -> usize {
    let pattern = &tubes[..parts];
    let is_pattern =
        |cell: &&[Tube]| (cell.iter().zip(pattern)).all(|(one, other)| are_equal(one, other));
    tubes.chunks_exact(parts).take_while(is_pattern).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drillstring::Material;

    fn tube(length: f64, outer_radius: f64) -> Tube {
        Tube {
            length,
            inner_radius: 0.05,
            outer_radius,
        }
    }

    fn string(sections: &[(usize, &[Tube])]) -> Drillstring {
        let steel = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let sections = sections.iter().map(|(repeat, parts)| Section {
            repeat: *repeat,
            parts: parts.to_vec(),
        });
        Drillstring::new(steel, sections.collect(), 10.0).unwrap()
    }

    #[test]
    fn equal_cells_are_one_tube_and_cut_pipes_are_whole() {
        let (pipe, joint) = (|length| tube(length, 0.06), tube(0.4, 0.08));
        let collars: &[Tube] = &[tube(10.0, 0.1)];
        let as_given = string(&[(30, &[pipe(9.1), joint]), (7, collars)]);
        let cut: &[Tube] = &[pipe(2.7), pipe(6.4), tube(0.15, 0.08), tube(0.25, 0.08)];
        let divided = string(&[
            (11, cut),
            (19, &[pipe(9.1), joint]),
            (1, &[tube(3.0, 0.1), tube(47.0, 0.1), tube(20.0, 0.1)]),
        ]);
        let [one, other] = [&as_given, &divided].map(|string| merged(string).unwrap());
        assert_eq!(one.sections(), other.sections());
        let repeats: Vec<usize> = one.sections().iter().map(|it| it.repeat).collect();
        assert_eq!(repeats, [30, 1]);
        assert!((one.length() - as_given.length()).abs() < 1e-4);
    }
}
