//! The assembly of `sweeps/bha_12in_blades.csv` below drillpipe, in its 12¼-inch hole, and where it
//! may touch that: tool joints make up for what its pipe weighs more than its dimensions.

use linear::{Drillstring, Material, Mud, Section, Tube};

const INCH: f64 = 0.0254;
const POUND: f64 = 0.453_592_37;
const STEEL: Material = Material {
    shear_modulus: 79.3e9,
    density: 7850.0,
};

/// Its Young's modulus, Pa.
pub const YOUNGS_MODULUS: f64 = 206e9;

/// Its mud.
pub const MUD: Mud = Mud {
    density: 1200.0,
    viscosity: 0.0,
};

/// Radius of its hole, m.
pub const HOLE: f64 = 0.155_575;

/// Clearance of its bit, m.
pub const BIT: f64 = 1.6e-3;

/// Diameter over blades, in.
const BLADES: f64 = 12.125;

/// Outer and inner diameter, in, length, m, weight, lbf, joints, whether it is pipe and whether it
/// has blades, from the surface down.
const ROWS: [(f64, f64, f64, f64, usize, bool, bool); 14] = [
    (5.875, 5.045, 4072.3, 411_041.3, 424, true, false),
    (5.875, 4.055, 28.63, 6123.7, 3, true, false),
    (7.953, 2.795, 9.66, 4366.6, 1, false, false),
    (5.875, 4.055, 28.63, 6123.7, 3, true, false),
    (9.606, 3.031, 9.32, 6759.2, 1, false, false),
    (9.685, 3.228, 2.53, 1841.2, 1, false, false),
    (9.488, 2.835, 1.14, 815.8, 1, false, false),
    (9.528, 3.031, 1.56, 973.6, 1, false, true),
    (9.685, 3.268, 3.68, 2669.9, 1, false, false),
    (9.173, 4.252, 8.59, 5315.0, 1, false, false),
    (9.488, 4.016, 1.51, 942.4, 1, false, true),
    (9.173, 4.291, 5.81, 3813.0, 1, false, false),
    (9.094, 6.750, 8.65, 4497.5, 1, false, true),
    (7.953, 2.835, 0.41, 349.1, 1, false, false),
];

/// A place where it may touch its hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touching {
    /// m.
    pub distance_from_bit: f64,
    /// m.
    pub clearance: f64,
    /// Radius with which it touches, m.
    pub radius: f64,
}

/// A part, from the bit up.
#[derive(Debug, Clone, Copy)]
struct Part {
    lower: f64,
    upper: f64,
    radius: f64,
    has_blades: bool,
}

fn tube(outer: f64, inner: f64, length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.5 * INCH * inner,
        outer_radius: 0.5 * INCH * outer,
    }
}

fn sections() -> Vec<(Section, bool)> {
    let section = |&(outer, inner, length, weight, joints, is_pipe, has_blades): &(
        f64,
        f64,
        f64,
        f64,
        usize,
        bool,
        bool,
    )| {
        let cell = length / joints as f64;
        let body = tube(outer, inner, cell);
        let joint = tube(1.25 * outer, inner, 0.0);
        let excess = weight * POUND / (STEEL.density * body.area() * length) - 1.0;
        let of_joint = excess * body.area() * cell / (joint.area() - body.area());
        let parts = match is_pipe {
            true => vec![
                tube(outer, inner, cell - of_joint),
                tube(1.25 * outer, inner, of_joint),
            ],
            false => vec![body],
        };
        let repeat = joints;
        (Section { repeat, parts }, has_blades)
    };
    ROWS.iter().map(section).collect()
}

/// The string.
pub fn string() -> Drillstring {
    let sections = sections().into_iter().map(|(section, _)| section);
    Drillstring::new(STEEL, sections.collect(), 0.0).expect("it is a string")
}

/// Its parts from the bit up to a distance (m).
fn parts(to: f64) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    for (section, has_blades) in sections().iter().rev() {
        for tube in (0..section.repeat).flat_map(|_| section.parts.iter().rev()) {
            let lower = parts.last().map_or(0.0, |below| below.upper);
            if lower > to {
                return parts;
            }
            let radius = match has_blades {
                true => 0.5 * INCH * BLADES,
                false => tube.outer_radius,
            };
            let (upper, has_blades) = (lower + tube.length, *has_blades);
            parts.push(Part {
                lower,
                upper,
                radius,
                has_blades,
            });
        }
    }
    parts
}

fn touching(distance_from_bit: f64, radius: f64) -> Touching {
    let clearance = if distance_from_bit == 0.0 {
        BIT
    } else {
        HOLE - radius
    };
    Touching {
        distance_from_bit,
        clearance,
        radius,
    }
}

/// The bit, and blades in their middles.
fn bit_and_blades(parts: &[Part]) -> Vec<Touching> {
    let bladed = parts.iter().filter(|part| part.has_blades);
    let blades = bladed.map(|part| touching(0.5 * (part.lower + part.upper), part.radius));
    std::iter::once(touching(0.0, HOLE)).chain(blades).collect()
}

/// The bit, and the middle of every part up to a distance (m) that is wider than a neighbour.
pub fn middles(to: f64) -> Vec<Touching> {
    let parts = parts(to + 20.0);
    let mut found = bit_and_blades(&parts);
    for it in 1..parts.len() - 1 {
        let (below, part, above) = (parts[it - 1], parts[it], parts[it + 1]);
        let middle = 0.5 * (part.lower + part.upper);
        if !part.has_blades && part.radius > below.radius.min(above.radius) && middle < to {
            found.push(touching(middle, part.radius));
        }
    }
    found
}

/// The bit, the middle of blades, and both ends of every part up to a distance (m) that is wider
/// than a neighbour, where no blades are next to them.
pub fn ends(to: f64) -> Vec<Touching> {
    let parts = parts(to + 20.0);
    let mut found = bit_and_blades(&parts);
    let is_wide = |it: usize| {
        let least = parts[it - 1].radius.min(parts[it + 1].radius);
        !parts[it].has_blades && parts[it].radius > least
    };
    for it in 1..parts.len() - 2 {
        let (part, above) = (parts[it], parts[it + 1]);
        let is_end = is_wide(it) || is_wide(it + 1);
        if is_end && !part.has_blades && !above.has_blades && part.upper < to {
            found.push(touching(part.upper, part.radius.max(above.radius)));
        }
    }
    found
}

/// The bit, the middle of blades, and no farther than a spacing (m) from each other anywhere up to
/// a distance (m), ends of parts included.
pub fn anywhere(spacing: f64, to: f64) -> Vec<Touching> {
    let parts = parts(to);
    let mut found = bit_and_blades(&parts);
    for (part, above) in parts.iter().zip(&parts[1..]) {
        // Of blades the tube itself.
        let body = |part: &Part| if part.has_blades { 0.11 } else { part.radius };
        let count = ((part.upper - part.lower) / spacing).ceil();
        for step in 1..=count as usize {
            let distance = part.lower + step as f64 / count * (part.upper - part.lower);
            let radius = match step as f64 == count {
                true => body(part).max(body(above)),
                false => body(part),
            };
            let is_blade =
                part.has_blades && (distance - 0.5 * (part.lower + part.upper)).abs() < 0.01;
            if distance < to && !is_blade {
                found.push(touching(distance, radius));
            }
        }
    }
    found
}
