//! The closed forms against elements, an ODE solver and simulations that share no code with the
//! program. Pipe P is 8 × 2.81 in, in mud of 1200 kg/m³ and a hole of 12¼ in.

use std::f64::consts::PI;

use statics::closed_forms::{BeamColumn, LyingPipe, buckling, climb, touchdown, with_amplitude};

use crate::uniform_pipe::{CLEARANCE, LOAD_PER_SINE, RIGIDITY};

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{found}, not {expected}");
}

#[test]
fn val_beam_column_factors_are_those_of_their_table() {
    let span = |compression: f64| BeamColumn {
        length: 10.0,
        rigidity: RIGIDITY,
        load: 1000.0,
        compression,
    };
    let free = span(0.0);
    let [pinned, fixed] = [free.with_pinned_ends(), free.with_fixed_ends()].map(Option::unwrap);
    assert_near(pinned.deflection / fixed.deflection, 5.0, 1e-12);
    #[rustfmt::skip]
    let rows = [
        (-1.0, [0.498473, 0.487528, 0.505945, 0.654539, 0.442553]),
        (-0.5, [0.665593, 0.657857, 0.670812, 0.774694, 0.623031]),
        (0.1, [1.111494, 1.114271, 1.109648, 1.072660, 1.128475]),
        (0.25, [1.334504, 1.342995, 1.328878, 1.215854, 1.388010]),
        (0.5, [2.003620, 2.029945, 1.986288, 1.635939, 2.178606]),
        (0.75, [4.011205, 4.092891, 3.957766, 2.868527, 4.586993]),
        (0.9, [10.034265, 10.284459, 9.871230, 6.527243, 11.866168]),
    ];
    for (part, factors) in rows {
        let one = span(part * free.pinned_buckling_load())
            .with_pinned_ends()
            .unwrap();
        let other = span(part * free.fixed_buckling_load())
            .with_fixed_ends()
            .unwrap();
        let found = [
            one.deflection / pinned.deflection,
            one.middle_moment / pinned.middle_moment,
            other.deflection / fixed.deflection,
            other.end_moment / fixed.end_moment,
            other.middle_moment / fixed.middle_moment,
        ];
        for (found, expected) in found.into_iter().zip(factors) {
            assert_near(found, expected, 6e-7);
        }
    }
    // Series and closed forms meet.
    for sign in [-1.0, 1.0] {
        let near = |part: f64| {
            let pushed = span(sign * part * 4e-5 * RIGIDITY);
            let [a, b] = [pushed.with_pinned_ends(), pushed.with_fixed_ends()].map(Option::unwrap);
            [
                a.deflection,
                a.middle_moment,
                b.deflection,
                b.end_moment,
                b.middle_moment,
            ]
        };
        for (below, above) in near(0.999_999).into_iter().zip(near(1.000_001)) {
            assert_near(below / above, 1.0, 1e-8);
        }
    }
    assert!(
        span(1.01 * free.pinned_buckling_load())
            .with_pinned_ends()
            .is_none()
    );
    assert!(
        span(1.01 * free.fixed_buckling_load())
            .with_fixed_ends()
            .is_none()
    );
}

#[test]
fn val_a_string_lies_down_where_its_table_says() {
    for (degrees, compression, length, bit_force, force) in [
        (30.0, 0.0, 12.411137, 5751.746, 5751.746),
        (60.0, 0.0, 10.818609, 8684.008, 8684.008),
        (90.0, 0.0, 10.436481, 9673.246, 9673.246),
        (90.0, 100e3, 10.270327, 8993.700, 10044.786),
        (90.0, 300e3, 9.945912, 7590.497, 10846.609),
        (90.0, -100e3, 10.605063, 10338.454, 9320.544),
    ] {
        let load = LOAD_PER_SINE * f64::to_radians(degrees).sin();
        let found = touchdown(RIGIDITY, CLEARANCE, load, compression);
        assert_near(found.length, length, 2e-6);
        assert_near(found.bit_force, bit_force, 2e-3);
        assert_near(found.force, force, 2e-3);
        assert_near(found.force + found.bit_force, load * found.length, 1e-6);
    }
}

#[test]
fn val_a_string_swings_on_the_low_side_as_simulated() {
    let load = LOAD_PER_SINE * 60f64.to_radians().sin();
    let pipe = LyingPipe {
        mass: 324.736985,
        load,
        rigidity: RIGIDITY,
        compression: 0.0,
        clearance: CLEARANCE,
        radius: 0.1016,
        spin_inertia: 1.29387707,
        torsional_rigidity: 13_070_630.7,
    };
    for (amplitude, sliding, rolling) in [(0.01, 1.523137, 1.293777), (0.5, 1.499374, 1.273593)] {
        // Simulated with a wall that gives by micrometres.
        assert_near(
            with_amplitude(pipe.frictionless(0.0), amplitude),
            sliding,
            3e-5,
        );
        assert_near(with_amplitude(pipe.rolling(0.0), amplitude), rolling, 3e-5);
    }
    for (compression, frequencies) in [
        (0.0, [1.526430, 1.574575, 1.768120, 2.206369]),
        (500e3, [1.432337, 1.471030, 1.490995, 1.776873]),
    ] {
        let pushed = LyingPipe {
            compression,
            ..pipe
        };
        let mut found: Vec<f64> = (1..9)
            .map(|waves| pushed.frictionless(f64::from(waves) * PI / 60.0))
            .collect();
        found.sort_by(f64::total_cmp);
        for (found, expected) in found.into_iter().zip(frequencies) {
            assert_near(found, expected, 3e-6);
        }
    }
    for (waves, expected) in [(1.0, 14.036337), (2.0, 27.977942)] {
        let found = pipe.rolling(waves * PI / 60.0);
        assert_near(found / expected, 1.0, 4e-4);
    }
    assert_near(60.0 * pipe.sliding(0.3), 93.380, 1e-2);
}

#[test]
fn val_a_string_climbs_and_rolls_round_as_by_an_ode() {
    let acceleration = LOAD_PER_SINE * 60f64.to_radians().sin() / 324.736985;
    let rpm =
        |ratio: f64| climb::rotation_speed(ratio, CLEARANCE, 0.1016, acceleration) * 30.0 / PI;
    assert_near(rpm(1.0), 48.551, 1e-3);
    for (friction, steady, greatest) in [
        (0.1, 5.71059, 11.49815),
        (0.3, 16.69924, 35.62235),
        (0.6, 30.96376, 88.97001),
    ] {
        assert_near(climb::steady_angle(friction).to_degrees(), steady, 1e-5);
        let found = climb::greatest_angle(friction).unwrap();
        assert_near(found.to_degrees(), greatest, 2e-5);
    }
    for (friction, rolls, rolls_rpm, goes, goes_rpm) in [
        (0.1, 10.049876, 153.914, 3.6321, 92.529),
        (0.3, 3.480102, 90.572, 2.3770, 74.853),
        (0.6, 1.943651, 67.687, 1.6621, 62.593),
        (0.8, 1.600781, 61.427, 1.4473, 58.409),
        (1.0, 2f64.sqrt(), 57.737, 1.3189, 55.757),
    ] {
        assert_near(climb::rolls_all_round(friction), rolls, 1e-6);
        assert_near(rpm(climb::rolls_all_round(friction)), rolls_rpm, 2e-3);
        assert_near(climb::goes_round_once_rolling(friction), goes, 1e-4);
        assert_near(
            rpm(climb::goes_round_once_rolling(friction)),
            goes_rpm,
            2e-3,
        );
    }
    assert_near(
        climb::least_friction_to_go_round_from_rest(),
        0.713089,
        2e-6,
    );
}

#[test]
fn val_a_lying_string_buckles_as_by_elements() {
    let load = LOAD_PER_SINE * 60f64.to_radians().sin();
    assert_near(
        buckling::of_lying_string(RIGIDITY, load, CLEARANCE),
        1_421_193.951,
        0.02,
    );
    let half = buckling::half_wave(RIGIDITY, load, CLEARANCE);
    assert_near(half, 15.355660, 1e-6);
    for (waves, expected) in [
        (5.0, 1_421_193.99),
        (10.3, 1_423_678.16),
        (20.5, 1_422_844.87),
    ] {
        let found = buckling::of_length(RIGIDITY, load, CLEARANCE, waves * half);
        assert_near(found, expected, 0.1);
    }
}
