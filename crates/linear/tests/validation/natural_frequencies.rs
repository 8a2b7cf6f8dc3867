//! Validation of natural frequencies counted by exact waves: closed forms of shafts and beams,
//! elements, and the modes of damped strings.

use std::f64::consts::PI;

use linear::bending_modes::BendingModes;
use linear::estimates::torsional_impedance;
use linear::modes::{damped_modes, torsional_modes};
use linear::natural_frequencies::{NaturalFrequencies, held_lateral_frequencies_below};
use linear::well::HangingString;
use linear::{
    AxialForce, Bending, Drillstring, Hole, HoleSection, Mud, Section, Sites, SurfaceSupport, Tube,
};
use problems::academic::BENDING;
use problems::pipes::{STEEL, pipe, row};
use proptest::prelude::*;

/// Bisection ends at a part of 1e-10.
const SAME: f64 = 2e-10;

fn of(sections: Vec<Section>) -> Drillstring {
    Drillstring::new(STEEL, sections, 3.0).unwrap()
}

fn one(parts: Vec<Tube>) -> Drillstring {
    of(vec![Section { repeat: 1, parts }])
}

fn solid(length: f64, outer_radius: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.0,
        outer_radius,
    }
}

fn is_close(found: f64, expected: f64, part: f64) -> bool {
    (found / expected - 1.0).abs() < part
}

/// A root of a function between two places where it has different signs.
fn root(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let negative_first = function(low) < 0.0;
    assert_ne!(negative_first, function(high) < 0.0, "{low} {high}");
    while high - low > 1e-14 * high {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if (function(middle) < 0.0) == negative_first {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// ω = (n − ½)πc/L, however the shaft is cut up.
#[test]
fn val_a_uniform_shaft_swings_in_odd_quarter_waves() {
    for string in [
        row(1, 0.0),
        row(100, 20.0),
        row(500, 0.0),
        one(vec![pipe(3000.0)]),
    ] {
        let unit = PI * string.torsional_wave_speed() / string.length();
        let found = NaturalFrequencies::torsion(&string)
            .unwrap()
            .lowest(60)
            .unwrap();
        assert_eq!(found.len(), 60);
        for (index, found) in found.iter().enumerate() {
            let expected = (index as f64 + 0.5) * unit;
            assert!(
                is_close(*found, expected, SAME),
                "{index}: {found} {expected}"
            );
        }
    }
}

/// With equal travel times tan²(kl) = Z₁/Z₂: two in every half turn.
#[test]
fn val_a_shaft_of_two_impedances_swings_as_its_tangent_says() {
    let (upper, lower) = (solid(700.0, 0.06), solid(700.0, 0.09));
    let string = one(vec![upper, lower]);
    let ratio = torsional_impedance(&string, &upper) / torsional_impedance(&string, &lower);
    let first = ratio.sqrt().atan();
    let found = NaturalFrequencies::torsion(&string)
        .unwrap()
        .lowest(40)
        .unwrap();
    for (index, omega) in found.iter().enumerate() {
        let half_turns = (index / 2) as f64 * PI;
        let turns = if index % 2 == 0 { first } else { PI - first };
        let expected = (half_turns + turns) * string.torsional_wave_speed() / 700.0;
        assert!(
            is_close(*omega, expected, SAME),
            "{index}: {omega} {expected}"
        );
    }
}

/// kL tan kL = J_shaft/J_tip: one in every half turn.
#[test]
fn val_a_tip_inertia_slows_a_shaft() {
    let (shaft, tip) = (solid(800.0, 0.05), solid(0.01, 4.0));
    let string = one(vec![shaft, tip]);
    let ratio = shaft.polar_moment() * shaft.length / (tip.polar_moment() * tip.length);
    assert!((0.001..0.1).contains(&ratio), "{ratio}");
    let found = NaturalFrequencies::torsion(&string)
        .unwrap()
        .lowest(20)
        .unwrap();
    for (index, omega) in found.iter().enumerate() {
        let low = index as f64 * PI;
        let turns = root(low + 1e-9, low + 0.5 * PI - 1e-9, |turns| {
            turns * turns.tan() - ratio
        });
        let expected = turns * string.torsional_wave_speed() / shaft.length;
        assert!(
            is_close(*omega, expected, 1e-8),
            "{index}: {omega} {expected}"
        );
    }
}

/// (kL) of uniform beams, their lower end free, by 1/cosh so that nothing overflows.
fn beam_root(support: SurfaceSupport, index: usize) -> f64 {
    let (middle, function): (f64, fn(f64) -> f64) = match support {
        // cosh cos = 1
        SurfaceSupport::Free => (1.5, |x| x.cos() - 1.0 / x.cosh()),
        // tan = tanh
        SurfaceSupport::Pinned => (1.25, |x| x.sin() - x.cos() * x.tanh()),
        // cosh cos = −1
        SurfaceSupport::Clamped => (0.5, |x| x.cos() + 1.0 / x.cosh()),
    };
    let middle = (index as f64 + middle) * PI;
    root(middle - 1.0, middle + 1.0, function)
}

#[test]
fn val_uniform_beams_have_the_roots_of_cosh_cos() {
    for (length, pipes) in [(10.0, 1), (100.0, 10), (5000.0, 1), (5000.0, 500)] {
        let part = pipe(length / pipes as f64);
        let parts = vec![part];
        let string = of(vec![Section {
            repeat: pipes,
            parts,
        }]);
        let rigidity = BENDING.youngs_modulus * part.second_moment();
        let unit = (rigidity / (STEEL.density * part.area())).sqrt() / length.powi(2);
        for (support, unrestored) in [
            (SurfaceSupport::Free, 2),
            (SurfaceSupport::Pinned, 1),
            (SurfaceSupport::Clamped, 0),
        ] {
            let modes = NaturalFrequencies::bending(&string, &BENDING, support).unwrap();
            assert_eq!(
                modes.unrestored().unwrap(),
                unrestored,
                "{length} {support:?}"
            );
            for (index, found) in modes.lowest(50).unwrap().into_iter().enumerate() {
                let expected = unit * beam_root(support, index).powi(2);
                let context = format!("{length} {pipes} {support:?} {index}: {found} {expected}");
                assert!(is_close(found, expected, 1e-8), "{context}");
            }
        }
    }
}

/// Pinned at the top, free below and pulled: with w = A sinh αx + B sin βx, α² − β² = T/(E I) and
/// ω² = E I α²β²/m, neither moment nor force at the end gives β³ tan βL = α³ tanh αL.
#[test]
fn val_tension_pulls_a_beam_straight_as_its_closed_form_says() {
    for (length, tension) in [(30.0, 1e5), (1000.0, 2e4), (1000.0, 1e6), (4000.0, 1e6)] {
        let string = of(vec![Section {
            repeat: 10,
            parts: vec![pipe(length / 10.0)],
        }]);
        let part = pipe(length);
        let rigidity = BENDING.youngs_modulus * part.second_moment();
        let mass = STEEL.density * part.area();
        let pulled = Bending {
            compression: -tension,
            ..BENDING
        };
        let pinned = SurfaceSupport::Pinned;
        // As a pre-compression, or as an axial force.
        let under = vec![AxialForce { length, tension }];
        let hung = string.clone().under_axial_force(under).unwrap();
        let modes = NaturalFrequencies::bending(&string, &pulled, pinned).unwrap();
        let other = NaturalFrequencies::bending(&hung, &BENDING, pinned).unwrap();
        assert_eq!(modes.unrestored().unwrap(), 0);
        let found = modes.lowest(40).unwrap();
        let other = other.lowest(40).unwrap();
        let mut both = found.iter().zip(&other);
        assert!(both.all(|(one, other)| is_close(*one, *other, SAME)));
        for (index, omega) in found.into_iter().enumerate() {
            let alpha = |beta: f64| (beta * beta + tension / rigidity).sqrt();
            let off = |turns: f64| {
                let beta = turns / length;
                let (sine, cosine) = turns.sin_cos();
                let alpha = alpha(beta);
                (beta / alpha).powi(3) * sine - cosine * (alpha * length).tanh()
            };
            let low = index as f64 * PI;
            let beta = root(low, low + 0.5 * PI, off) / length;
            let expected = alpha(beta) * beta * (rigidity / mass).sqrt();
            assert!(
                is_close(omega, expected, 1e-8),
                "{length} {index}: {omega} {expected}"
            );
        }
    }
}

fn held(string: &Drillstring, bending: &Bending, places: &[f64], count: usize) -> Vec<f64> {
    let sites = Sites::new(string, places).unwrap();
    let mut highest = 1.0;
    loop {
        let mut found = held_lateral_frequencies_below(string, bending, &sites, highest).unwrap();
        if found.len() >= count {
            found.truncate(count);
            return found;
        }
        highest *= 2.0;
    }
}

/// Held at both ends, ω² = (nπ/l)⁴ EI/m + (nπ/l)² T/m; what is above has no part in it.
#[test]
fn val_a_beam_held_at_both_ends_swings_in_half_sines() {
    let string = row(300, 0.0);
    let part = pipe(10.0);
    let rigidity = BENDING.youngs_modulus * part.second_moment();
    let mass = STEEL.density * part.area();
    for (length, tension) in [(7.0, 0.0), (33.0, 0.0), (33.0, 2e5), (2500.0, 1e6)] {
        let pulled = Bending {
            compression: -tension,
            ..BENDING
        };
        let found = held(&string, &pulled, &[0.0, length], 12);
        for (index, omega) in found.into_iter().enumerate() {
            let wave = (index + 1) as f64 * PI / length;
            let square = (wave.powi(4) * rigidity + wave.powi(2) * tension) / mass;
            let expected = square.sqrt();
            let context = format!("{length} {index}: {omega} {expected}");
            assert!(is_close(omega, expected, 1e-8), "{context}");
        }
    }
}

/// Of two equal spans every other mode is that of one held at both ends, and between them are
/// those of one clamped at one end, tan kl = tanh kl.
#[test]
fn val_two_equal_spans_swing_as_one_pinned_or_clamped_in_the_middle() {
    let string = row(100, 0.0);
    let part = pipe(10.0);
    let rigidity = BENDING.youngs_modulus * part.second_moment();
    let unit = (rigidity / (STEEL.density * part.area())).sqrt() / 18f64.powi(2);
    let found = held(&string, &BENDING, &[36.0, 18.0, 0.0], 12);
    for (index, omega) in found.iter().enumerate() {
        let turns = match index % 2 {
            0 => (index / 2 + 1) as f64 * PI,
            _ => beam_root(SurfaceSupport::Pinned, index / 2),
        };
        let expected = unit * turns * turns;
        assert!(is_close(*omega, expected, 1e-8), "{omega} {expected}");
    }
}

/// Spans of 18, 12 and 24 m that are held at three places, the lowest with a free end: every mode is
/// at rest at each place, and its elastic and kinetic energy are one (Lord Rayleigh), by
/// differences along its shape. Two equal spans have half sines.
#[test]
fn val_shapes_of_a_held_string_rest_where_it_is_held_and_have_their_frequency() {
    let string = row(100, 0.0);
    let part = pipe(10.0);
    let unit = BENDING.youngs_modulus * part.second_moment() / (STEEL.density * part.area());
    let held_at = |places: &[f64]| {
        let sites = Sites::new(&string, places).unwrap();
        NaturalFrequencies::held(&string, &BENDING, &sites).unwrap()
    };
    let at = |depths: &[f64], amplitudes: &[f64], height: f64| {
        let place = depths
            .iter()
            .position(|depth| (1000.0 - depth - height).abs() < 1e-6);
        amplitudes[place.unwrap()]
    };
    let places = [54.0, 36.0, 24.0];
    let natural = held_at(&places);
    for omega in natural.lowest(8).unwrap() {
        let shape = natural.shape(omega, 1801).unwrap();
        for place in places {
            let there = at(&shape.depths, &shape.amplitudes, place);
            assert!(there.abs() < 1e-6, "{omega} {place}: {there}");
        }
        assert!((shape.depths[0] - 946.0).abs() < 1e-9);
        let (step, inner) = (0.03, shape.amplitudes.windows(3));
        let bent = inner.map(|it| ((it[0] - 2.0 * it[1] + it[2]) / (step * step)).powi(2));
        let moved = shape.amplitudes.iter().map(|it| it * it);
        let square = unit * bent.sum::<f64>() / moved.sum::<f64>();
        assert!(
            is_close(square.sqrt(), omega, 5e-3),
            "{omega} {}",
            square.sqrt()
        );
    }
    let natural = held_at(&[36.0, 18.0, 0.0]);
    let first = natural.lowest(1).unwrap()[0];
    let shape = natural.shape(first, 101).unwrap();
    for (depth, amplitude) in shape.depths.iter().zip(&shape.amplitudes) {
        let expected = (PI * (1000.0 - depth) / 18.0).sin();
        let sign = -shape.amplitudes[1].signum();
        assert!(
            (amplitude - sign * expected).abs() < 1e-4,
            "{depth}: {amplitude} {expected}"
        );
    }
}

/// A heavy piece between two shafts, the upper twice as long: all odd modes of the upper have one
/// of the lower next to them, nearer the heavier the piece.
#[test]
fn val_pairs_are_found_however_close_they_are() {
    for (radius, nearer) in [(2.0, 1e-2), (8.0, 1e-4), (60.0, 1e-7), (400.0, SAME)] {
        let parts = vec![solid(1000.0, 0.06), solid(0.1, radius), solid(500.0, 0.06)];
        let string = one(parts);
        let unit = PI * string.torsional_wave_speed() / 1000.0;
        let modes = NaturalFrequencies::torsion(&string).unwrap();
        // One is the slow swing of the heavy piece itself.
        let found = modes.lowest(31).unwrap();
        let near = |frequency: f64| {
            let close = found.iter().filter(|it| is_close(**it, frequency, nearer));
            close.count()
        };
        for mode in 1..20 {
            let expected = if mode % 2 == 1 { 2 } else { 1 };
            assert_eq!(near(f64::from(mode) * unit), expected, "{radius} {mode}");
        }
    }
}

/// As many are found below a frequency as are counted there, and none is counted twice.
#[test]
fn val_what_is_found_is_what_is_counted() {
    let string = jointed(80, 12, 0.06);
    let lateral = (SurfaceSupport::Free, 20.0);
    let torsion = NaturalFrequencies::torsion(&string).unwrap();
    let bending = NaturalFrequencies::bending(&string, &BENDING, lateral.0).unwrap();
    for (modes, highest) in [(&torsion, 2000.0), (&bending, lateral.1)] {
        let first = modes.unrestored().unwrap();
        let found = modes.all_below(highest).unwrap();
        assert!(found.len() > 50, "{}", found.len());
        // By other steps of bisection.
        for (one, other) in found.iter().zip(modes.lowest(found.len()).unwrap()) {
            assert!(is_close(*one, other, SAME), "{one} {other}");
        }
        for (index, omega) in found.iter().enumerate() {
            let below = |part: f64| modes.below(part * omega).unwrap();
            assert_eq!(below(1.0 - SAME), first + index, "{omega}");
            assert_eq!(below(1.0 + SAME), first + index + 1, "{omega}");
        }
    }
}

/// sin((n − ½)πx/L) in torsion; a clamped beam is as its closed form says.
#[test]
fn val_uniform_strings_have_the_shapes_of_closed_forms() {
    let string = row(30, 5.0);
    let torsion = NaturalFrequencies::torsion(&string).unwrap();
    for (index, omega) in torsion.lowest(8).unwrap().into_iter().enumerate() {
        let shape = torsion.shape(omega, 121).unwrap();
        for (depth, amplitude) in shape.depths.iter().zip(&shape.amplitudes) {
            let along = ((index as f64 + 0.5) * PI * depth / 300.0).sin();
            // The greatest is 1, wherever that is.
            let off = (amplitude.abs() - along.abs()).abs();
            assert!(off < 2e-5, "{index} {depth}: {amplitude} {along}");
        }
    }
    let clamped = SurfaceSupport::Clamped;
    let bending = NaturalFrequencies::bending(&string, &BENDING, clamped).unwrap();
    for (index, omega) in bending.lowest(4).unwrap().into_iter().enumerate() {
        let shape = bending.shape(omega, 61).unwrap();
        let turns = beam_root(clamped, index);
        let sigma = (turns.cosh() + turns.cos()) / (turns.sinh() + turns.sin());
        let at = |x: f64| x.cosh() - x.cos() - sigma * (x.sinh() - x.sin());
        for (depth, amplitude) in shape.depths.iter().zip(&shape.amplitudes) {
            let expected = at(turns * depth / 300.0) / at(turns);
            assert!(
                (amplitude - expected).abs() < 2e-5,
                "{index} {depth}: {amplitude} {expected}"
            );
        }
    }
}

/// Pipe with joints, or without where their length is zero, above collars.
fn jointed(pipes: usize, collars: usize, radius: f64) -> Drillstring {
    let tube = |length, outer_radius| Tube {
        length,
        inner_radius: 0.04,
        outer_radius,
    };
    let pipes = Section {
        repeat: pipes,
        parts: vec![tube(9.5, radius), tube(0.5, 1.3 * radius)],
    };
    let collars = Section {
        repeat: collars,
        parts: vec![tube(9.0, 0.1)],
    };
    of(vec![pipes, collars])
}

/// Torsional natural frequencies below ω by the signs of pivots of two-node elements, consistent
/// masses.
fn below_by_elements(string: &Drillstring, longest: f64, omega: f64) -> usize {
    let mut pivot = f64::INFINITY;
    let mut negative = 0;
    let material = string.material();
    let mut carry = 0.0;
    for section in string.sections() {
        for tube in (0..section.repeat).flat_map(|_| &section.parts) {
            let count = (tube.length / longest).ceil();
            let length = tube.length / count;
            let spring = material.shear_modulus * tube.polar_moment() / length;
            let inertia = material.density * tube.polar_moment() * length * omega * omega;
            let (own, cross) = (spring - inertia / 3.0, -spring - inertia / 6.0);
            for _ in 0..count as usize {
                // The node above has all it gets: that of the surface is held.
                if pivot.is_finite() {
                    pivot = carry + own;
                    negative += usize::from(pivot < 0.0);
                    carry = own - cross * cross / pivot;
                } else {
                    pivot = 0.0;
                    carry = own;
                }
            }
        }
    }
    negative + usize::from(carry < 0.0)
}

/// Lateral natural frequencies below ω of the lowest part of a string, held at some places (m from
/// the bit, the uppermost first): Hermite's elements of unequal length with consistent masses, as a
/// banded matrix, its rows and columns of held displacements left out.
fn held_below_by_elements(
    string: &Drillstring,
    bending: &Bending,
    held: &[f64],
    longest: f64,
    omega: f64,
) -> usize {
    // Rigidity and mass of each element from the bit up, cut at every held place.
    let mut elements = Vec::new();
    let mut nodes_held = vec![held.last() == Some(&0.0)];
    let mut height = 0.0;
    let tubes = string.sections().iter().rev().flat_map(|section| {
        let upwards = section.parts.iter().rev();
        std::iter::repeat_n(upwards, section.repeat).flatten()
    });
    'string: for tube in tubes {
        let mut left = tube.length;
        while left > 1e-9 {
            let to_held = held.iter().map(|place| place - height);
            let next = to_held.filter(|it| *it > 1e-9).fold(left, f64::min);
            let count = (next / longest).ceil() as usize;
            for index in 0..count {
                let length = next / count as f64;
                let mass = string.material().density * tube.area();
                elements.push((length, bending.youngs_modulus * tube.second_moment(), mass));
                let at = height + length * (index + 1) as f64;
                nodes_held.push(held.iter().any(|place| (place - at).abs() < 1e-6));
            }
            height += next;
            left -= next;
            if height > held[0] - 1e-6 {
                break 'string;
            }
        }
    }
    // Upwards, eliminating one degree of freedom after another: displacement, then slope.
    let mut carried = [[0.0; 2]; 2];
    let mut negative = 0;
    for ((length, rigidity, mass), is_held) in elements.iter().zip(&nodes_held) {
        let (l, tension) = (*length, -bending.compression);
        let stiff = rigidity / l.powi(3);
        let pull = tension / (30.0 * l);
        let inert = omega * omega * mass * l / 420.0;
        let entry = |elastic: f64, geometric: f64, inertia: f64| {
            stiff * elastic + pull * geometric - inert * inertia
        };
        let l2 = l * l;
        let mut matrix = [
            [
                entry(12.0, 36.0, 156.0),
                entry(6.0 * l, 3.0 * l, 22.0 * l),
                entry(-12.0, -36.0, 54.0),
                entry(6.0 * l, 3.0 * l, -13.0 * l),
            ],
            [
                0.0,
                entry(4.0 * l2, 4.0 * l2, 4.0 * l2),
                entry(-6.0 * l, -3.0 * l, 13.0 * l),
                entry(2.0 * l2, -l2, -3.0 * l2),
            ],
            [
                0.0,
                0.0,
                entry(12.0, 36.0, 156.0),
                entry(-6.0 * l, -3.0 * l, -22.0 * l),
            ],
            [0.0, 0.0, 0.0, entry(4.0 * l2, 4.0 * l2, 4.0 * l2)],
        ];
        for row in 0..2 {
            for column in row..2 {
                matrix[row][column] += carried[row][column];
            }
        }
        for pivot in usize::from(*is_held)..2 {
            let divisor = matrix[pivot][pivot];
            negative += usize::from(divisor < 0.0);
            for row in pivot + 1..4 {
                let factor = matrix[pivot][row] / divisor;
                for column in row..4 {
                    matrix[row][column] -= factor * matrix[pivot][column];
                }
            }
        }
        carried = [[matrix[2][2], matrix[2][3]], [0.0, matrix[3][3]]];
    }
    // The uppermost place is held, and free to turn.
    negative + usize::from(carried[1][1] < 0.0)
}

fn strings() -> impl Strategy<Value = Drillstring> {
    (
        (8usize..480, 1usize..25),
        (0.05..0.08f64, 0.08..0.13f64),
        prop::bool::ANY,
    )
        .prop_map(|((pipes, collars), (radius, collar), is_jointed)| {
            let tube = |length, outer_radius| Tube {
                length,
                inner_radius: 0.04,
                outer_radius,
            };
            let mut parts = vec![tube(9.5, radius)];
            if is_jointed {
                parts.push(tube(0.5, 1.3 * radius));
            }
            let pipes = Section {
                repeat: pipes,
                parts,
            };
            let collars = Section {
                repeat: 1,
                parts: vec![tube(9.0 * collars as f64, collar)],
            };
            of(vec![pipes, collars])
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..Default::default() })]

    /// Elements are a little too fast, by a twenty-fourth of the square of how far waves turn in
    /// one; counts between are the same.
    #[test]
    fn val_torsion_is_that_of_elements(string in strings()) {
        let modes = NaturalFrequencies::torsion(&string).unwrap();
        for (index, omega) in modes.lowest(25).unwrap().into_iter().enumerate() {
            let turns = omega * 1.0 / string.torsional_wave_speed();
            let too_fast = turns * turns / 24.0;
            prop_assert_eq!(below_by_elements(&string, 1.0, omega * (1.0 - 1e-8)), index);
            let above = omega * (1.0 + 1.2 * too_fast + 1e-8);
            prop_assert_eq!(below_by_elements(&string, 1.0, above), index + 1);
        }
    }

    /// Between two modes of a torsional string lies one more place at rest (J. C. F. Sturm).
    #[test]
    fn val_each_torsional_mode_has_one_more_node(string in strings()) {
        let modes = NaturalFrequencies::torsion(&string).unwrap();
        for (index, omega) in modes.lowest(12).unwrap().into_iter().enumerate() {
            let shape = modes.shape(omega, 401).unwrap();
            let below = shape.amplitudes[1..].windows(2);
            let nodes = below.filter(|pair| pair[0] * pair[1] < 0.0).count();
            prop_assert_eq!(nodes, index);
            let greatest = shape.amplitudes.iter().fold(0.0, |most: f64, it| most.max(it.abs()));
            prop_assert_eq!(greatest, 1.0);
        }
    }

    /// Elements take a little more to bend than the string, however it hangs; modes
    /// without a restoring force are as many.
    #[test]
    fn val_bending_is_that_of_elements(
        string in strings(),
        support in prop_oneof![
            Just(SurfaceSupport::Free),
            Just(SurfaceSupport::Pinned),
            Just(SurfaceSupport::Clamped),
        ],
        hangs in prop::option::of(0.0..3e4f64),
        hole in prop::option::of((0.1..0.9f64, 0.2..0.4f64, 0.2..0.4f64)),
    ) {
        let mut string = string;
        if let Some(weight_on_bit) = hangs {
            let force = HangingString::new(&string, None, None);
            let force = force.axial_force(&BENDING, weight_on_bit, 1e-2);
            string = string.under_axial_force(force).unwrap();
        }
        if let Some((part, above, below)) = hole {
            let section = |part: f64, radius| HoleSection { length: part * string.length(), radius };
            let sections = vec![section(part, above), section(1.0 - part, below)];
            let mud = Mud { density: 1500.0, viscosity: 0.0 };
            string = string.in_hole(Hole { sections, mud }).unwrap();
        }
        let exact = NaturalFrequencies::bending(&string, &BENDING, support).unwrap();
        let elements = BendingModes::new(&string, &BENDING, support).unwrap();
        let unrestored = exact.unrestored().unwrap();
        let exact = exact.lowest(17).unwrap();
        for index in [0, 1, 2, 4, 8, 16] {
            let (omega, found) = (exact[index], elements.frequency(unrestored + index).unwrap());
            // What rounding leaves to elements of the slowest motions, 1/s².
            let off = (found * found - omega * omega).abs();
            prop_assert!(off < 1e-3 * omega * omega + 1e-9, "{index}: {found} {omega}");
        }
    }

    /// Elements are a little too fast, by a part (kl)⁴/1440 at most; the string is held at two to
    /// five places, of which the bit may be one.
    #[test]
    fn val_a_held_string_is_that_of_elements(
        string in strings(),
        spans in prop::collection::vec(2.0..40.0f64, 1..5),
        overhang in prop::option::of(0.5..6.0f64),
        compression in -3e5..2e4f64,
    ) {
        let mut places = vec![overhang.unwrap_or(0.0)];
        for span in &spans {
            places.insert(0, places[0] + span);
        }
        let bending = Bending { compression, ..BENDING };
        let found = held(&string, &bending, &places, 10);
        let tubes = string.sections().iter().flat_map(|section| &section.parts);
        let slackest = tubes.map(|tube| {
            STEEL.density * tube.area() / (BENDING.youngs_modulus * tube.second_moment())
        });
        let slackest = slackest.fold(0.0, f64::max);
        let count = |omega| held_below_by_elements(&string, &bending, &places, 0.2, omega);
        // Ways in which an overhang or a compressed span buckles.
        let unrestored = count(1e-9);
        for (index, omega) in found.into_iter().enumerate() {
            let too_fast = omega * omega * slackest * 0.2f64.powi(4) / 1440.0;
            let context = format!("{index}: {omega} of {places:?}");
            prop_assert_eq!(count(omega * (1.0 - 1e-7)), unrestored + index, "{}", context);
            let above = omega * (1.0 + too_fast + 1e-7);
            prop_assert_eq!(count(above), unrestored + index + 1, "{}", context);
        }
    }

    /// Every natural frequency has its pole, at the same |s| but for a part of the damping that is
    /// not the same everywhere; those found from lumped inertias are among them.
    #[test]
    fn val_every_mode_has_its_pole(string in strings(), part in prop_oneof![1e-6..1e-3f64, 1e-3..0.3]) {
        let exact = NaturalFrequencies::torsion(&string).unwrap().lowest(12).unwrap();
        let tube = string.sections()[0].parts[0];
        // The damping ratio of the first mode, were all of it pipe.
        let damping = 2.0 * part * exact[0] * STEEL.density * tube.polar_moment();
        let damped = Drillstring::new(STEEL, string.sections().to_vec(), damping).unwrap();
        let modes = damped_modes(&damped, &exact).unwrap();
        for (mode, omega) in modes.iter().zip(&exact) {
            let pole = mode.unwrap().pole;
            let off = (pole.norm() / omega - 1.0).abs();
            prop_assert!(off < 2e-8 + 0.5 * part * part && pole.re < 0.0, "{pole} {omega}");
        }
        let lumped = torsional_modes(&damped, 12).unwrap();
        prop_assert_eq!(lumped.len(), 12);
        for (one, other) in lumped.iter().zip(&modes) {
            let apart = (one.pole - other.unwrap().pole).norm();
            prop_assert!(apart < 1e-6 * one.pole.norm(), "{one:?} {other:?}");
        }
    }
}
