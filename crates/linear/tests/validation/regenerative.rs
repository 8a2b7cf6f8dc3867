//! Limits of steady drilling and roots of D(s) against numbers of an independent program.

use std::f64::consts::{FRAC_PI_2, TAU};

use linear::regenerative::{CuttingLoop, SteadyCut};
use linear::{Axial, Complex64, Drillstring};
use problems::dashpots::{BelowDashpots, collar, pipe};

/// A bit of four blades of a radius of 0.108 m, in phase II.
fn cut(energy: f64, advance: f64, speed: f64, [torsion, axial]: [bool; 2]) -> SteadyCut {
    let (radius, ratio, blades) = (0.108_f64, 0.6, 4.0);
    let felt = |is_felt: bool, stiffness: f64| if is_felt { stiffness } else { 0.0 };
    SteadyCut {
        delay: FRAC_PI_2 / speed,
        advance: advance / speed,
        torque: felt(torsion, 0.5 * energy * radius.powi(2) * blades),
        weight: felt(axial, ratio * energy * radius * blades),
    }
}

const AXIAL: [bool; 2] = [false, true];
const TORSION: [bool; 2] = [true, false];
const BOTH: [bool; 2] = [true, true];

#[test]
fn val_limits_of_steady_drilling() {
    let plain = vec![pipe(2000.0)];
    let with_collar = vec![pipe(1800.0), collar(200.0)];
    let cases = [
        (
            &plain,
            [0.7, 0.7],
            6e6,
            AXIAL,
            0.004,
            19.36061835,
            53.56542572,
        ),
        (
            &plain,
            [0.7, 0.7],
            6e6,
            TORSION,
            0.02,
            8.88974120,
            2.44495752,
        ),
        (
            &plain,
            [0.7, 0.7],
            6e6,
            BOTH,
            0.02,
            19.07801227,
            53.52402290,
        ),
        (
            &with_collar,
            [0.7, 0.7],
            20e6,
            AXIAL,
            0.004,
            37.61105974,
            85.85256164,
        ),
        (
            &with_collar,
            [0.7, 0.7],
            60e6,
            TORSION,
            0.004,
            11.24209169,
            1.88596503,
        ),
        (
            &with_collar,
            [0.7, 0.7],
            20e6,
            BOTH,
            0.02,
            61.78621335,
            166.22718595,
        ),
        (
            &plain,
            [0.7, -0.7],
            6e6,
            AXIAL,
            0.004,
            20.04599943,
            57.50895048,
        ),
    ];
    for (tubes, etas, energy, felt, advance, speed, frequency) in cases {
        let below = BelowDashpots::new(tubes, etas);
        let cutting = CuttingLoop::new(&below.string, &below.rod).unwrap();
        let at = |speed: f64| cut(energy, advance, speed, felt);
        let near = [0.97 * speed, 1.03 * speed];
        let (found, omega) = cutting.limit(at, near).unwrap();
        assert!((found / speed - 1.0).abs() < 1e-8, "{found} {speed}");
        assert!(
            (omega / frequency - 1.0).abs() < 1e-8,
            "{omega} {frequency}"
        );
    }
}

/// The string of Table 2, its surface held, with distributed damping.
#[test]
fn val_limits_of_the_string_of_table_2() {
    let string = problems::academic::string();
    let string = Drillstring::new(string.material(), string.sections().to_vec(), 10.0).unwrap();
    let axial = Axial {
        youngs_modulus: 210e9,
        damping: 200.0,
        hoist: None,
    };
    let rod = axial.rod(&string).unwrap();
    let cutting = CuttingLoop::new(&string, &rod).unwrap();
    let (radius, ratio, energy, blades) = (0.15_f64, 0.6, 60e6, 6.0);
    let at = |[torsion, axial]: [f64; 2], speed: f64| SteadyCut {
        delay: TAU / blades / speed,
        advance: 0.005 / speed,
        torque: torsion * 0.5 * energy * radius.powi(2) * blades,
        weight: axial * ratio * energy * radius * blades,
    };
    for (felt, speed, frequency) in [
        ([0.0, 1.0], 50.55912, 186.10517678),
        ([1.0, 0.0], 1.49015805, 2.95143795),
    ] {
        let near = [0.97 * speed, 1.03 * speed];
        let (found, omega) = cutting.limit(|speed| at(felt, speed), near).unwrap();
        assert!((found / speed - 1.0).abs() < 1e-6, "{found} {speed}");
        assert!(
            (omega / frequency - 1.0).abs() < 1e-6,
            "{omega} {frequency}"
        );
    }
}

#[test]
fn val_roots_of_steady_drilling_and_their_number() {
    let plain = vec![pipe(2000.0)];
    let with_collar = vec![pipe(1800.0), collar(200.0)];
    for (tubes, energy, speed, advance, root, count) in [
        (
            &plain,
            6e6,
            8.0,
            0.02,
            Complex64::new(0.456948388, 21.971820544),
            6,
        ),
        (
            &plain,
            6e6,
            16.0,
            0.004,
            Complex64::new(0.092718552, 45.499245421),
            4,
        ),
        (
            &with_collar,
            20e6,
            12.0,
            0.004,
            Complex64::new(0.402159387, 85.003103715),
            2,
        ),
    ] {
        let below = BelowDashpots::new(tubes, [0.7, 0.7]);
        let cutting = CuttingLoop::new(&below.string, &below.rod).unwrap();
        let cut = cut(energy, advance, speed, BOTH);
        let found = cutting
            .root(&cut, root + Complex64::new(0.01, -0.02))
            .unwrap();
        assert!((found - root).norm() < 1e-7, "{found} {root}");
        assert_eq!(cutting.growing(&cut), Some(count));
    }
}
