//! Limits of steady drilling and roots of D(s) against numbers of an independent program.

use std::f64::consts::{FRAC_PI_2, TAU};

use linear::regenerative::{CuttingLoop, Rotor, SteadyCut};
use linear::{Axial, Complex64, Drillstring, Hoist};
use problems::dashpots::{BelowDashpots, collar, pipe};
use problems::wells::{Draw, Well, with_loss};

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

/// A cut that is this many times as stiff is sampled as many times as far.
const FURTHER: f64 = 8.0;

/// How many roots grow does not depend on where samples end: resonances beyond may be sharper than those
/// of the last octave of samples, by more than is allowed for. `STRINGS=1500` asks for more of them.
#[test]
fn val_roots_beyond_the_samples_do_not_grow() {
    let count = std::env::var("STRINGS").map_or(12, |count| count.parse().unwrap());
    let mut others = 0;
    for number in 0..count {
        let mut draw = Draw::new(number);
        let mut string = Well::draw(number, &mut draw).string;
        if number % 2 == 0 {
            string = with_loss(&string, &mut draw);
        }
        let hoist = Hoist {
            mass: draw.uniform(0.0, 3e4),
            damping: draw.log_uniform(1e4, 1e6),
            stiffness: 0.0,
        };
        let axial = Axial {
            youngs_modulus: 210e9,
            damping: draw.log_uniform(10.0, 1000.0),
            hoist: (number % 3 > 0).then_some(hoist),
        };
        let rod = axial.rod(&string).unwrap();
        let blades = draw.uniform(3.0, 9.0).floor();
        let (radius, energy) = (draw.uniform(0.08, 0.22), draw.log_uniform(2e6, 1e8));
        let speed = draw.log_uniform(3.0, 25.0);
        let cut = SteadyCut {
            delay: TAU / blades / speed,
            advance: draw.log_uniform(1e-4, 2e-3),
            torque: 0.5 * energy * radius.powi(2) * blades,
            weight: draw.uniform(0.4, 1.0) * energy * radius * blades,
        };
        let further = SteadyCut {
            torque: FURTHER * cut.torque,
            weight: FURTHER * cut.weight,
            ..cut
        };
        let found = CuttingLoop::new(&string, &rod)
            .unwrap()
            .sampled_for(&cut)
            .growing(&cut);
        let known = CuttingLoop::new(&string, &rod)
            .unwrap()
            .sampled_for(&further)
            .growing(&cut);
        assert!(found.is_some() && known.is_some(), "{number}: too sharp");
        others += usize::from(found != known);
    }
    println!("{others} of {count} differ");
    assert_eq!(others, 0);
}

/// Below a motor: as many roots grow as are found by Newton's method from all over the plane; a rotor
/// without slip and hardly any inertia changes nothing, and one so heavy that nothing turns it leaves the
/// axis alone.
#[test]
fn val_roots_below_a_motor() {
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, 0.7]);
    let driven = |slip: f64, inertia: f64| {
        let cutting = CuttingLoop::new(&below.string, &below.rod).unwrap();
        cutting.above_motor(Rotor { slip, inertia })
    };
    let steady = cut(6e6, 0.02, 8.0, BOTH);
    for (slip, inertia) in [(6e-4, 20.0), (2e-4, 3.0), (2e-3, 80.0)] {
        let cutting = driven(slip, inertia);
        let mut found: Vec<Complex64> = Vec::new();
        for guess in 0..800 {
            let guess = Complex64::new([0.1, 0.6][guess % 2], 0.2 * guess as f64 + 0.1);
            let Some(root) = cutting.root(&steady, guess) else {
                continue;
            };
            let is_new = found.iter().all(|other| (other - root).norm() > 1e-6);
            if root.re > 0.0 && root.im > 0.0 && is_new {
                found.push(root);
            }
        }
        assert_eq!(cutting.growing(&steady), Some(2 * found.len()), "{found:?}");
    }
    let at = Complex64::new(0.3, 21.0);
    let plain = CuttingLoop::new(&below.string, &below.rod).unwrap();
    let without = plain.characteristic(&steady, at);
    let light = driven(0.0, 1e-9).characteristic(&steady, at);
    assert!((light - without).norm() < 1e-6 * without.norm());
    let axis = plain.characteristic(&cut(6e6, 0.02, 8.0, AXIAL), at);
    let heavy = driven(0.0, 1e12).characteristic(&steady, at);
    assert!((heavy - axis).norm() < 1e-6 * axis.norm());
}

/// Counted from a growth on, a root is there or not as it grows faster or more slowly.
#[test]
fn val_roots_count_from_a_growth_on() {
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, 0.7]);
    let exact = CuttingLoop::new(&below.string, &below.rod).unwrap();
    let cut = cut(6e6, 0.02, 8.0, BOTH);
    let growth = exact.root(&cut, Complex64::new(0.45, 22.0)).unwrap().re;
    let faster = |growth: f64| {
        let counted = CuttingLoop::new(&below.string, &below.rod).unwrap();
        counted.faster_than(growth).growing(&cut).unwrap()
    };
    assert_eq!(faster(0.0), exact.growing(&cut).unwrap());
    assert_eq!(faster(0.999 * growth) - faster(1.001 * growth), 2);
}
