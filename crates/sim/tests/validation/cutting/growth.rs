//! How small motion about steady drilling grows, step by step: by the roots of the linear limit.

use std::f64::consts::{PI, TAU};

use linear::method::FiniteElement;
use linear::regenerative::{CuttingLoop, Rotor, SteadyCut};
use linear::{Complex64, Method, Responses};
use problems::dashpots::{BelowDashpots, collar, pipe};
use problems::wells::Draw;
use sim::laws::cutting::CutStep;
use sim::{Cutting, Kick, MudMotor, SteppedLoop};

use super::scene::{Drilling, bit, immovable, responses};

/// Time of a step, s.
const STEP: f64 = 1e-3;

/// Steady drilling at a speed (rad/s) and a rate (m/s), as small motion feels it.
fn cut(cutting: &Cutting, [speed, rate]: [f64; 2]) -> SteadyCut {
    let apart = TAU / cutting.blades() as f64;
    let advance = rate / speed;
    let [torque, weight] = cutting.steady_stiffnesses(advance * apart);
    SteadyCut {
        delay: apart / speed,
        advance,
        torque,
        weight,
    }
}

/// The same where torsion is left out.
fn axial_cut(cutting: &Cutting, steady: [f64; 2]) -> SteadyCut {
    SteadyCut {
        torque: 0.0,
        ..cut(cutting, steady)
    }
}

/// Of steps about a steady weight, the growth (1/s) and frequency (rad/s) of what moves near a frequency,
/// by the change from one window of a time to another that it overlaps by half.
fn root(steps: &[CutStep], weight: f64, (frequency, window): (f64, f64)) -> Complex64 {
    let count = (window / STEP) as usize;
    let ending = |end: usize| -> Complex64 {
        let of = |index: usize| {
            let at = end - count + index;
            let hann = 0.5 - 0.5 * (TAU * index as f64 / count as f64).cos();
            let turn = Complex64::from_polar(hann, -frequency * at as f64 * STEP);
            turn * (steps[at].weight - weight)
        };
        (0..count).map(of).sum()
    };
    let change = ending(steps.len()) / ending(steps.len() - count / 2);
    change.ln() / (count as f64 / 2.0 * STEP) + Complex64::new(0.0, frequency)
}

/// The root near a frequency (rad/s) of a case that is kicked by so little that it never rests.
fn simulated(
    responses: &Responses,
    cutting: &Cutting,
    [speed, rate]: [f64; 2],
    (frequency, window, force): (f64, f64, f64),
) -> Complex64 {
    let kick = Kick {
        torque: 0.0,
        force,
        duration: PI / frequency,
    };
    let drilling = Drilling::steadily(responses, cutting, [speed, rate], kick);
    grown(&drilling, cutting, [speed, rate], (frequency, window))
}

/// The root near a frequency (rad/s) in the motion of a case.
fn grown(
    drilling: &Drilling,
    cutting: &Cutting,
    [speed, rate]: [f64; 2],
    (frequency, window): (f64, f64),
) -> Complex64 {
    let steps = drilling.steps();
    assert!(
        steps.iter().all(|step| step.rate > 0.0 && step.speed > 0.0),
        "it rests"
    );
    let [_, weight] = cutting.steady(rate / speed * TAU / cutting.blades() as f64);
    root(&steps, weight, (frequency, window))
}

/// The speed at which a simulated growth is zero, from those on both sides of an exact limit.
fn simulated_limit(
    responses: &Responses,
    cutting: &Cutting,
    rate: f64,
    (limit, frequency): (f64, f64),
) -> f64 {
    let [low, high] = [0.997 * limit, 1.003 * limit];
    let growth = |speed: f64| {
        // Other motion has died away in the time of the case.
        let how = (frequency, 20.0, 1.0);
        simulated(responses, cutting, [speed, rate], how).re
    };
    let (below, above) = (growth(low), growth(high));
    low + (high - low) * below / (below - above)
}

/// Axial motion alone: no torque changes the speed of the string.
fn axial_responses(below: &BelowDashpots, method: &Method, duration: f64) -> Responses {
    let mut responses = responses(below, method, [STEP, duration]);
    let torsion = &mut responses.channels[0].from_loads[0][0];
    *torsion = immovable(torsion.len());
    responses
}

/// At steps of 1 ms to within a thousandth, on strings whose limit an independent program knows.
#[test]
fn val_simulated_motion_grows_beyond_the_limit_of_steady_drilling() {
    let plain = vec![pipe(2000.0)];
    let with_collar = vec![pipe(1800.0), collar(200.0)];
    for (tubes, etas, energy, known) in [
        (&plain, [0.7, 0.7], 6e6, 19.36061835),
        (&with_collar, [0.7, 0.7], 20e6, 37.61105974),
        (&plain, [0.7, -0.7], 6e6, 20.04599943),
    ] {
        let (cutting, rate) = (bit(energy, 5e-3), 0.004);
        let below = BelowDashpots::new(tubes, etas);
        let exact = CuttingLoop::new(&below.string, &below.rod).unwrap();
        let at = |speed: f64| axial_cut(&cutting, [speed, rate]);
        let limit = exact.limit(at, [0.97 * known, 1.03 * known]).unwrap();
        let responses = axial_responses(&below, &Method::Held, 200.0);
        let found = simulated_limit(&responses, &cutting, rate, limit);
        assert!((found / limit.0 - 1.0).abs() < 1e-3, "{found} {limit:?}");
    }
}

/// The same of strings drawn at random, both motions together.
#[test]
fn val_simulated_limits_of_random_strings() {
    let mut known = 0;
    for number in 0..12 {
        let mut draw = Draw::new(number);
        let tubes = [
            pipe(draw.uniform(500.0, 2500.0)),
            collar(draw.uniform(50.0, 250.0)),
        ];
        let etas = [draw.uniform(0.5, 0.8), draw.uniform(0.5, 0.8)];
        let cutting = bit(draw.log_uniform(2e6, 6e6), 5e-3);
        let rate = draw.uniform(0.004, 0.01);
        let below = BelowDashpots::new(&tubes, etas);
        let exact = CuttingLoop::new(&below.string, &below.rod).unwrap();
        let at = |speed: f64| cut(&cutting, [speed, rate]);
        let Some(limit) = exact.limit(at, [4.0, 50.0]) else {
            continue;
        };
        known += 1;
        let responses = responses(&below, &Method::Held, [STEP, 120.0]);
        let found = simulated_limit(&responses, &cutting, rate, limit);
        assert!(
            (found / limit.0 - 1.0).abs() < 1e-3,
            "{number}: {found} {limit:?}"
        );
    }
    assert!(known > 4, "{known}");
}

/// By methods whose loads and motion are sampled, too, where elements hardly damp; with the damping
/// that a sticking site wants of them elsewhere they call drilling steady that is not.
#[test]
fn val_simulated_limits_of_sampled_methods() {
    let (cutting, rate) = (bit(6e6, 5e-3), 0.004);
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, -0.7]);
    let exact = CuttingLoop::new(&below.string, &below.rod).unwrap();
    let at = |speed: f64| axial_cut(&cutting, [speed, rate]);
    let limit = exact.limit(at, [19.0, 21.0]).unwrap();
    let off = |method: &Method| {
        let responses = axial_responses(&below, method, 200.0);
        (simulated_limit(&responses, &cutting, rate, limit) / limit.0 - 1.0).abs()
    };
    let elements = |gamma: f64| {
        let usual = FiniteElement::default();
        Method::FiniteElement(FiniteElement { gamma, ..usual })
    };
    let [quadrature, little, usual] =
        [Method::Quadrature, elements(0.502), elements(0.52)].map(|method| off(&method));
    assert!(quadrature < 0.01, "{quadrature}");
    assert!(little < 0.1, "{little}");
    assert!(usual > 5.0 * little, "{usual} {little}");
}

/// The limit of the loop in steps is that of the steps, by methods whose limits are off from the exact one.
#[test]
fn val_limits_of_the_stepped_loop_are_those_of_steps() {
    let (cutting, rate) = (bit(6e6, 5e-3), 0.004);
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, -0.7]);
    let exact = CuttingLoop::new(&below.string, &below.rod).unwrap();
    let at = |speed: f64| axial_cut(&cutting, [speed, rate]);
    let limit = exact.limit(at, [19.0, 21.0]).unwrap();
    let elements = Method::FiniteElement(FiniteElement {
        gamma: 0.502,
        ..FiniteElement::default()
    });
    for method in [Method::Quadrature, elements] {
        let responses = axial_responses(&below, &method, 200.0);
        let stepped = SteppedLoop::new(&responses, 0.0, 1.0).unwrap();
        let grows = |speed: f64| stepped.growing(&at(speed)) > 0;
        let (mut low, mut high) = (0.85 * limit.0, 1.15 * limit.0);
        assert!(grows(low) && !grows(high));
        for _ in 0..20 {
            let middle = 0.5 * (low + high);
            if grows(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        let found = simulated_limit(&responses, &cutting, rate, (low, limit.1 * low / limit.0));
        let (off, from_exact) = ((found / low - 1.0).abs(), (low / limit.0 - 1.0).abs());
        assert!(off < 2e-4 && off < 0.1 * from_exact, "{off} {from_exact}");
    }
}

/// Growth and frequency of the motion that grows fastest, to the digits of an independent program.
#[test]
fn val_small_motion_grows_as_the_leading_root() {
    let plain = vec![pipe(2000.0)];
    let with_collar = vec![pipe(1800.0), collar(200.0)];
    for (tubes, energy, steady, root, duration, part) in [
        (
            &plain,
            6e6,
            [8.0, 0.02],
            [0.456948388, 21.971820544],
            40.0,
            1e-4,
        ),
        (
            &plain,
            6e6,
            [16.0, 0.004],
            [0.092718552, 45.499245421],
            150.0,
            5e-4,
        ),
        (
            &with_collar,
            20e6,
            [12.0, 0.004],
            [0.402159387, 85.003103715],
            40.0,
            2e-3,
        ),
    ] {
        let below = BelowDashpots::new(tubes, [0.7, 0.7]);
        let responses = responses(&below, &Method::Held, [STEP, duration]);
        let how = (root[1], 10.0, 1e-6);
        let found = simulated(&responses, &bit(energy, 5e-3), steady, how);
        let off = found - Complex64::new(root[0], root[1]);
        assert!(off.norm() < part, "{found} {root:?}");
    }
}

/// Below a motor the bit feels its slip and its inertia, too: the root is that of the limit that knows
/// both, up to steps of the rotor, and not that of the bit without.
#[test]
fn val_small_motion_below_a_motor_grows_as_the_leading_root() {
    let motor = MudMotor {
        speed: 12.0,
        slip: 6e-4,
        stall_torque: 18e3,
        rotor_inertia: 20.0,
    };
    let rotor = Rotor {
        slip: motor.slip,
        inertia: motor.rotor_inertia,
    };
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, 0.7]);
    let responses = responses(&below, &Method::Held, [STEP, 40.0]);
    let alone = CuttingLoop::new(&below.string, &below.rod).unwrap();
    let driven = CuttingLoop::new(&below.string, &below.rod)
        .unwrap()
        .above_motor(rotor);
    let (cutting, steady) = (bit(6e6, 5e-3), [8.0, 0.02]);
    let of_steady = cut(&cutting, steady);
    let guess = Complex64::new(0.456948388, 21.971820544);
    let without = alone.root(&of_steady, guess).unwrap();
    let exact = driven.root(&of_steady, guess).unwrap();
    let kick = Kick {
        torque: 0.0,
        force: 1e-6,
        duration: PI / exact.im,
    };
    let drilling = Drilling::steadily(&responses, &cutting, steady, kick).above_motor(motor);
    let found = grown(&drilling, &cutting, steady, (exact.im, 10.0));
    let off = (found - exact).norm();
    assert!(
        off < 0.02 * (without - exact).norm(),
        "{found} {exact} {without}"
    );
}
