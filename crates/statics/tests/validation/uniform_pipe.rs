//! Strings of one pipe against closed forms: 8 × 2.81 in, in mud of 1200 kg/m³ and a hole of 12¼ in.

use std::f64::consts::FRAC_PI_2;

use linear::well::{Station, Survey};
use linear::{Drillstring, Material, Mud, Section, Stress, SurfaceSupport, Tube};
use statics::closed_forms::{BeamColumn, buckling, touchdown};
use statics::{Bit, Conditions, Contact, ContactState, Course, LyingString, Top};

/// E I, N m².
pub const RIGIDITY: f64 = 16_976_985.7;
/// m.
pub const CLEARANCE: f64 = 0.053_975;
/// Buoyed weight, N/m: across a hole it is times the sine of the inclination.
pub const LOAD_PER_SINE: f64 = 1853.7371;

const PIPE: Tube = Tube {
    length: 1.0,
    inner_radius: 0.0357,
    outer_radius: 0.1016,
};

fn string(length: usize) -> Drillstring {
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let section = Section {
        repeat: length,
        parts: vec![PIPE],
    };
    Drillstring::new(steel, vec![section], 0.0).unwrap()
}

fn conditions(course: Course) -> Conditions {
    Conditions {
        mud: Some(Mud {
            density: 1200.0,
            viscosity: 0.0,
        }),
        top: Top::Surface,
        ..Conditions::new(206e9, course)
    }
}

fn at(distance_from_bit: f64, clearance: f64) -> Contact {
    Contact {
        distance_from_bit,
        clearance,
        radius: 0.1016,
        stiffness: None,
    }
}

fn flat() -> Course {
    Course::Straight {
        inclination: FRAC_PI_2,
    }
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let off = (found / expected - 1.0).abs();
    assert!(off <= tolerance, "{found}, not {expected}: {off:.1e}");
}

/// Held at both ends, with tension and compression.
#[test]
fn val_a_single_span_bends_as_a_beam_column() {
    let length = 12.0;
    for part in [0.0, 0.25, 0.75] {
        let span = BeamColumn {
            length,
            rigidity: RIGIDITY,
            load: LOAD_PER_SINE,
            compression: 0.0,
        };
        let compression = part * span.pinned_buckling_load();
        let expected = BeamColumn {
            compression,
            ..span
        }
        .with_pinned_ends()
        .unwrap();
        let conditions = Conditions {
            bit: Bit::Pinned,
            weight_on_bit: compression,
            ..conditions(flat())
        };
        let contacts = [at(5.0, 1.0)];
        let state = LyingString::new(&string(12), &conditions, &contacts).unwrap();
        let state = state.at_rest().unwrap();
        let middle = state.at(0.5 * length);
        assert_near(-middle.displacement[0], expected.deflection, 2e-6);
        assert_near(middle.moment[0], expected.middle_moment, 2e-6);
        assert_near(
            state.greatest_moment(length).1,
            expected.middle_moment,
            2e-6,
        );
    }
}

/// Contacts as near as elements: it lies down as by its closed form, and the wall bears the rest.
#[test]
fn val_a_string_lies_down_above_a_pinned_bit() {
    for weight_on_bit in [0.0, 100e3, 300e3] {
        let expected = touchdown(RIGIDITY, CLEARANCE, LOAD_PER_SINE, weight_on_bit);
        let contacts: Vec<Contact> = (1..1279)
            .map(|it| at(f64::from(it) / 16.0, CLEARANCE))
            .collect();
        let conditions = Conditions {
            bit: Bit::Pinned,
            weight_on_bit,
            ..conditions(flat())
        };
        let lying = LyingString::new(&string(80), &conditions, &contacts).unwrap();
        let state = lying.at_rest().unwrap();
        assert_near(-state.side_force_at_bit()[0], expected.bit_force, 1e-5);
        let touching = state.contacts().iter().rev().skip(1).find(|it| it.touches);
        let first = touching.unwrap().contact.distance_from_bit;
        assert!((first - expected.length).abs() < 0.08, "{first}");
        // In the middle what it weighs.
        let middle = state.contacts().iter();
        let middle = middle.filter(|it| (30.0..50.0).contains(&it.contact.distance_from_bit));
        let borne: f64 = middle.map(|it| it.normal()).sum();
        assert_near(borne, 20.0 * LOAD_PER_SINE, 1e-3);
    }
}

/// Sixty metres, free at both ends, without axial force, on nine elastic walls: by elements of
/// another program. At 60° the pipe weighs as much across the hole as horizontally in heavier mud.
#[test]
fn val_a_string_with_free_ends_lies_on_nine_walls_as_by_elements() {
    let conditions = Conditions {
        mud: Some(Mud {
            density: 7850.0 - (7850.0 - 1200.0) * 60f64.to_radians().sin(),
            viscosity: 0.0,
        }),
        bit: Bit::Free,
        surface: SurfaceSupport::Free,
        ..conditions(flat())
    };
    let contacts: Vec<Contact> = (0..9)
        .map(|it| Contact {
            stiffness: Some(1e9),
            ..at((f64::from(it) + 0.5) * 60.0 / 9.0, CLEARANCE)
        })
        .collect();
    let lying = LyingString::new(&string(60), &conditions, &contacts).unwrap();
    assert!(!lying.buckles_without_contacts());
    let state = lying.at_rest().unwrap();
    assert!(state.is_stable());
    let expected = [11_261.174, 10_004.243, 10_876.063, 10_658.886, 10_722.275];
    for (site, it) in state.contacts().iter().enumerate() {
        assert_near(it.normal(), expected[site.min(8 - site)], 1e-6);
    }
    // Clamped at the surface it does not lie down there.
    let clamped = Conditions {
        surface: SurfaceSupport::Clamped,
        ..conditions
    };
    let lying = LyingString::new(&string(60), &clamped, &contacts).unwrap();
    let at_surface = lying.at_rest().unwrap().at(60.0);
    assert_eq!(
        (at_surface.displacement, at_surface.slope),
        ([0.0; 2], [0.0; 2])
    );
    assert!(at_surface.moment[0].abs() > 1e3);
}

/// Three pins on an arc, without weight: the one in the middle bends it.
#[test]
fn val_pins_on_an_arc_bend_the_string() {
    let curvature = 3f64.to_radians() / 30.0;
    let station = |measured_depth: f64| Station {
        measured_depth,
        inclination: FRAC_PI_2 - (20.0 - measured_depth) * curvature,
        azimuth: 0.3,
    };
    let survey = Survey::new(vec![station(0.0), station(20.0)]).unwrap();
    let steel = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };
    let section = Section {
        repeat: 20,
        parts: vec![PIPE],
    };
    let string = Drillstring::new(steel, vec![section], 0.0).unwrap();
    let conditions = Conditions {
        // As heavy as its steel.
        mud: Some(Mud {
            density: 7850.0,
            viscosity: 0.0,
        }),
        bit: Bit::Pinned,
        top: Top::Surface,
        ..Conditions::new(206e9, Course::Surveyed(survey))
    };
    let tight = at(10.0, 1e-9);
    let lying = LyingString::new(&string, &conditions, &[tight]).unwrap();
    let state = lying.at_rest().unwrap();
    assert_near(state.contacts()[0].force[0], -8889.1289, 2e-7);
    assert!(state.contacts()[0].force[1].abs() < 1e-6);
}

/// Bent by its compression alone, the same in whichever plane its hole builds or turns.
#[test]
fn val_a_string_without_weight_does_not_know_which_way_is_up() {
    let well = |[[i0, a0], [i1, a1]]: [[f64; 2]; 2]| {
        let station = |measured_depth: f64, inclination: f64, azimuth: f64| Station {
            measured_depth,
            inclination: inclination.to_radians(),
            azimuth: azimuth.to_radians(),
        };
        let survey = Survey::new(vec![station(0.0, i0, a0), station(120.0, i1, a1)]);
        Course::Surveyed(survey.unwrap())
    };
    let contacts: Vec<Contact> = (0..12)
        .map(|it| at(10.0 * f64::from(it), 0.01 + 0.002 * f64::from(it % 3)))
        .collect();
    // Each turns by 6°: it builds, it turns to the right, and both.
    let wells = [
        [[60.0, 0.0], [66.0, 0.0]],
        [[90.0, 0.0], [90.0, 6.0]],
        [[90.0, 0.0], [90.0 - 18f64.sqrt(), 0.0]],
    ];
    let mut found = Vec::new();
    for (number, stations) in wells.into_iter().enumerate() {
        let mut stations = stations;
        if number == 2 {
            // cos 6° = sin I cos A.
            let inclination = stations[1][0].to_radians();
            stations[1][1] = (6f64.to_radians().cos() / inclination.sin())
                .acos()
                .to_degrees();
        }
        let conditions = Conditions {
            mud: Some(Mud {
                density: 7850.0,
                viscosity: 0.0,
            }),
            weight_on_bit: 200e3,
            ..conditions(well(stations))
        };
        let lying = LyingString::new(&string(120), &conditions, &contacts).unwrap();
        let state = lying.at_rest().unwrap();
        let normals: Vec<f64> = state.contacts().iter().map(ContactState::normal).collect();
        assert!(
            normals.iter().filter(|it| **it > 1e3).count() > 4,
            "{normals:?}"
        );
        found.push((normals, state.greatest_moment(100.0).1));
    }
    for (normals, moment) in &found[1..] {
        assert_near(*moment, found[0].1, 1e-8);
        for (one, other) in normals.iter().zip(&found[0].0) {
            assert!((one - other).abs() < 1e-3, "{one} {other}");
        }
    }
}

/// W = f (EI w²)^⅓: a vertical string of some length that its ends alone hold.
#[test]
fn val_a_vertical_column_buckles_as_by_elements() {
    let unit = (RIGIDITY / LOAD_PER_SINE).powf(1.0 / 3.0);
    let force = (RIGIDITY * LOAD_PER_SINE.powi(2)).powf(1.0 / 3.0);
    for (lengths, bit, factor) in [
        (8.0, Bit::Free, 1.018793),
        (20.0, Bit::Free, 1.018793),
        (8.0, Bit::Pinned, 1.937040),
        (12.0, Bit::Pinned, 1.821589),
        (20.0, Bit::Pinned, 1.711041),
    ] {
        let whole = string((lengths * unit).ceil() as usize + 1);
        let conditions = Conditions {
            bit,
            top: Top::At(lengths * unit),
            ..conditions(Course::Straight { inclination: 0.0 })
        };
        let lying = LyingString::new(&whole, &conditions, &[at(20.0, CLEARANCE)]).unwrap();
        let buckles = |part: f64| {
            lying
                .under(part * factor * force)
                .buckles_without_contacts()
        };
        assert!(
            !buckles(1.0 - 2e-6) && buckles(1.0 + 2e-6),
            "{lengths} {bit:?}"
        );
    }
}

/// On the low side it snakes under 2 √(EI q/c), a little earlier where contacts are few.
#[test]
fn val_a_lying_string_snakes_under_a_weight_on_bit() {
    let load = LOAD_PER_SINE;
    let force = buckling::of_lying_string(RIGIDITY, load, CLEARANCE);
    let half = buckling::half_wave(RIGIDITY, load, CLEARANCE);
    for (to_a_half_wave, part) in [(3, 0.99885), (8, 0.99998)] {
        let spacing = half / f64::from(to_a_half_wave);
        let count = 10 * to_a_half_wave;
        let contacts: Vec<Contact> = (0..count)
            .map(|it| at((f64::from(it) + 0.5) * spacing, CLEARANCE))
            .collect();
        let length = f64::from(count) * spacing;
        let whole = string(length.ceil() as usize + 1);
        let conditions = Conditions {
            bit: Bit::Pinned,
            top: Top::At(length),
            ..conditions(flat())
        };
        let lying = LyingString::new(&whole, &conditions, &contacts).unwrap();
        let ways = |part: f64| {
            let state = lying.under(part * force).at_rest().unwrap();
            state.unstable_directions()
        };
        // Its ends are held in the middle, and there fewer contacts bear it.
        assert_eq!(ways(0.98 * part), [0, 0], "{to_a_half_wave}");
        assert!(ways(1.02 * part)[1] > 0, "{to_a_half_wave}");
    }
}

#[test]
fn val_stress_is_that_of_its_table() {
    let inches = |outer: f64, inner: f64| Tube {
        length: 1.0,
        inner_radius: 0.5 * 0.0254 * inner,
        outer_radius: 0.5 * 0.0254 * outer,
    };
    for (tube, tension, moment, [axial, bending, shear, von_mises]) in [
        (
            inches(9.173, 4.252),
            -79_064.36,
            67_979.794,
            [-2.361869, 57.394737, 6.332183, 60.754766],
        ),
        (
            inches(9.094, 6.750),
            -94_242.29,
            52_809.065,
            [-5.008020, 62.666785, 8.900004, 69.408280],
        ),
    ] {
        let stress = Stress::new(&tube, tension, moment, 15e3);
        assert_near(stress.axial, 1e6 * axial, 1e-6);
        assert_near(stress.bending, 1e6 * bending, 1e-6);
        assert_near(stress.shear, 1e6 * shear, 1e-6);
        assert_near(stress.von_mises, 1e6 * von_mises, 1e-6);
    }
}
