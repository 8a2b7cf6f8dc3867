//! Cycles of a bit that cuts what its blades have left, on strings whose answer independent programs
//! know: exact delay lines in steps of 5 µs.

use std::f64::consts::TAU;

use linear::Method;
use problems::dashpots::{BelowDashpots, collar, pipe};
use problems::delay_lines::{CuttingBit, Rock};
use sim::Kick;
use sim::laws::cutting::CutStep;

use super::scene::{
    Drilling, assert_part, bit, given, immovable, mean, most, one_blade, part, responses, ringing,
};

/// The time near a guess after which speeds are most alike, s.
fn period(steps: &[CutStep], guess: f64, step: f64) -> f64 {
    let apart = |lag: usize| -> f64 {
        let pairs = steps.iter().zip(&steps[lag..]);
        pairs
            .map(|(one, other)| (one.speed - other.speed).powi(2))
            .sum()
    };
    let near = (guess / step) as usize;
    let lags = near - near / 20..near + near / 20;
    let best = lags
        .min_by(|one, other| apart(*one).total_cmp(&apart(*other)))
        .unwrap();
    // The lowest point of a parabola.
    let [before, at, after] = [best - 1, best, best + 1].map(apart);
    let off = 0.5 * (before - after) / (before - 2.0 * at + after);
    (best as f64 + off) * step
}

/// It sticks: a plain string, most of a torsional wave sent back and little of an axial one.
#[test]
fn val_stick_slip_of_a_bit_that_cuts() {
    let kick = Kick {
        torque: 1000.0,
        force: 5000.0,
        duration: 2.0,
    };
    let cutting = bit(60e6, 5e-3);
    let (step, duration) = (1e-3, 100.0);
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.9, 0.3]);
    let responses = responses(&below, &Method::Held, [step, duration]);
    let steps = Drilling::steadily(&responses, &cutting, [4.0, 0.006], kick).steps();
    // 48 cycles.
    let last = &steps[steps.len() - 39_659..];
    assert_part("period", period(last, 0.826, step), 0.826237, 3e-4);
    assert_part("mean torque", mean(last, |it| it.torque), 4328.15, 3e-4);
    assert_part("mean weight", mean(last, |it| it.weight), 69064.66, 3e-4);
    assert_part("mean rate", mean(last, |it| it.rate), 0.0059201, 3e-4);
    assert_part(
        "deepest cut",
        most(last, |it| it.depth_of_cut),
        2.45811e-3,
        3e-4,
    );
    assert_part("greatest torque", most(last, |it| it.torque), 4490.32, 3e-4);
    assert_part("greatest speed", most(last, |it| it.speed), 9.634, 1e-2);
    let stuck = part(last, |it| it.speed == 0.0);
    assert!((stuck - 0.11282).abs() < 2e-3, "{stuck}");
    let at_rest = part(last, |it| it.rate == 0.0);
    assert!((at_rest - 0.6075).abs() < 2e-3, "{at_rest}");
}

/// It turns on, while the axis swings.
#[test]
fn val_axial_chatter_of_a_bit_that_cuts() {
    let kick = Kick {
        torque: 300.0,
        force: 0.0,
        duration: 1.0,
    };
    let tubes = [pipe(1800.0), collar(200.0)];
    let cutting = bit(60e6, 5e-3);
    let below = BelowDashpots::new(&tubes, [0.7, 0.0]);
    let responses = responses(&below, &Method::Held, [5e-4, 140.0]);
    let steps = Drilling::steadily(&responses, &cutting, [8.0, 0.004], kick).steps();
    let last = &steps[steps.len() - 80_000..];
    assert_part("mean torque", mean(last, |it| it.torque), 2197.18, 3e-4);
    assert_part("mean weight", mean(last, |it| it.weight), 44577.31, 3e-4);
    assert_part(
        "deepest cut",
        most(last, |it| it.depth_of_cut),
        1.12292e-3,
        1e-3,
    );
    assert_part("greatest torque", most(last, |it| it.torque), 2621.49, 1e-3);
    let at_rest = part(last, |it| it.rate == 0.0);
    assert!((at_rest - 0.3352).abs() < 2e-3, "{at_rest}");
}

/// From rest to steady drilling under a weight that is set, by its closed form.
#[test]
fn val_steady_drilling_from_rest() {
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, -0.7]);
    let [gain, damping] = below.dampings;
    let cutting = bit(4e6, 2e-3);
    let responses = responses(&below, &Method::Held, [1.0 / 640.0, 120.0]);
    let (set_speed, set_weight) = (20.0, 20e3);
    let set = [set_speed, set_weight / damping];
    let steps = Drilling::from_rest(&responses, &cutting, 5.0, set).steps();
    let last = steps[steps.len() - 1];
    // Set speeds less what torque and weight take of them; d the advance of a revolution.
    let depth = {
        let off = |depth: f64| {
            let [torque, weight] = cutting.steady(depth);
            let speed = set_speed - torque / gain;
            let rate = depth * 4.0 * speed / TAU;
            set_weight - damping * rate - weight
        };
        let (mut low, mut high) = (0.0, 0.01);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if off(middle) > 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        low
    };
    let [torque, weight] = cutting.steady(depth);
    assert_part("depth of cut", last.depth_of_cut, depth, 1e-6);
    assert_part("torque", last.torque, torque, 1e-6);
    assert_part("weight", last.weight, weight, 1e-6);
    assert_part("speed", last.speed, set_speed - torque / gain, 1e-6);
    // To the digits of the independent program.
    for (found, known) in [
        (last.speed, 19.475303),
        (last.depth_of_cut, 5.222063e-3),
        (last.rate, 0.0647450),
        (last.torque, 907.185),
        (last.weight, 18374.235),
    ] {
        assert_part("known", found, known, 1e-6);
    }
}

/// Axial vibration alone, of a string that turns at one speed under any torque, in the numbers of
/// the literature, where a wave of torsion takes a time of 1 to the bit. The cycles do not quite repeat:
/// means, deepest cut and part at rest are over a time of 200, to those of an independent program, and of delay
/// lines next to it.
#[test]
fn val_axial_cycles_of_the_literature() {
    let known = [
        (10.0, [(1.0, 9.9544), (2.0, 4.8055), (4.0, 2.3238)]),
        (20.0, [(1.0, 19.9047), (2.0, 9.8585), (4.0, 4.8953)]),
        (40.0, [(1.0, 39.8955), (2.0, 19.8505), (4.0, 9.8006)]),
    ];
    for (stiffness, rows) in known {
        for (speed, weight) in rows {
            let steps = axial_cycle(stiffness, speed);
            let last = &steps[(BEGUN / CYCLE_STEP) as usize..];
            let name = format!("{stiffness} {speed}");
            let mean_weight = mean(last, |it| it.weight) - FLAT;
            assert_part(&name, mean_weight, weight, 1e-3);
            let exact = exact_axial_cycle(stiffness, speed);
            assert_part(&name, mean_weight, exact.weight, 5e-4);
            let deepest = most(last, |it| it.depth_of_cut);
            assert_part(&name, deepest, exact.deepest, 1.5e-3);
            let at_rest = part(last, |it| it.rate == 0.0);
            assert!((at_rest - exact.at_rest).abs() < 5e-3, "{name}: {at_rest}");
        }
    }
}

/// What the flats carry there, W_f, and what a wave along the axis takes and leaves.
const FLAT: f64 = 100.0;
const TRAVEL: f64 = 1.0 / 1.6;
const IMPEDANCE: f64 = 1.0 / 1.6;
const SENT_BACK: f64 = 0.7;

/// A push at the start, for how long; from when on what is found counts, and until when.
const PUSH: f64 = -2.0;
const PUSHED: f64 = 5.0;
const BEGUN: f64 = 40.0;
const DURATION: f64 = 240.0;
const CYCLE_STEP: f64 = 0.0025;

/// Steps of such a cycle, of a bit of one blade whose delay is 1 over the speed.
fn axial_cycle(stiffness: f64, speed: f64) -> Vec<CutStep> {
    let count = (DURATION / CYCLE_STEP) as usize;
    let axial = ringing(1.0 / IMPEDANCE, 2.0 * TRAVEL / CYCLE_STEP, SENT_BACK, count);
    // k_a of one blade of 2π radians; the flats carry FLAT.
    let cutting = one_blade(stiffness, [1.0, 0.0], FLAT);
    let kick = Kick {
        torque: 0.0,
        force: PUSH,
        duration: PUSHED,
    };
    // One turn takes 1/speed.
    let responses = given([immovable(count), axial], CYCLE_STEP);
    Drilling::steadily(&responses, &cutting, [TAU * speed, 1.0], kick).steps()
}

/// What comes out of one.
struct AxialCycle {
    weight: f64,
    deepest: f64,
    at_rest: f64,
}

/// By delay lines, in steps twenty times as small.
fn exact_axial_cycle(stiffness: f64, speed: f64) -> AxialCycle {
    let step = CYCLE_STEP / 20.0;
    let rock = Rock {
        stiffnesses: [0.0, stiffness],
        flats: FLAT,
        growth: f64::INFINITY,
        flat_radius: 0.0,
        apart: 1.0,
        relief: f64::INFINITY,
    };
    let lines = [&[[1e12, 1.0]][..], &[[IMPEDANCE, TRAVEL]]];
    let etas = [0.0, SENT_BACK];
    let mut bit = CuttingBit::drilling(rock, lines, etas, [speed, 1.0], step);
    let mut force = |time: f64| bit.advance([0.0, if time < PUSHED { PUSH } else { 0.0 }]);
    let [begun, count] = [BEGUN, DURATION].map(|time| (time / step) as usize);
    for index in 0..begun {
        force(index as f64 * step);
    }
    let last: Vec<_> = (begun..count)
        .map(|index| force(index as f64 * step))
        .collect();
    let part = 1.0 / last.len() as f64;
    AxialCycle {
        weight: part * last.iter().map(|now| now.weight - FLAT).sum::<f64>(),
        deepest: last
            .iter()
            .fold(0.0, |most, now| now.depth_of_cut.max(most)),
        at_rest: part * last.iter().filter(|now| now.rate == 0.0).count() as f64,
    }
}

/// Stick-slip of the literature, of two lumps: an inertia on a spring of torsion and a mass that its
/// weight presses down, whose surface turns and sinks steadily.
#[test]
fn val_stick_slip_of_two_lumps() {
    for (speed, rate, start, expected) in [
        (3.0, 0.001, -1.0, [2.129703, 2020.08, 5.1451]),
        (12.0, 0.004, -3.0, [2.202827, 1786.499, 20.2293]),
    ] {
        let step = 1e-3;
        let steps = two_lumps([speed, rate], start, (step, 120.0));
        let [cycle, torque, greatest]: [f64; 3] = expected;
        // 18 cycles.
        let last = &steps[steps.len() - (18.0 * cycle / step).round() as usize..];
        let name = format!("{speed}");
        // No cycle is quite like another.
        assert_part(&name, period(last, cycle, step), cycle, 1.5e-2);
        assert_part(&name, mean(last, |it| it.torque), torque, 5e-4);
        assert_part(&name, most(last, |it| it.speed), greatest, 2e-3);
    }
}

/// Steps of them, at steady drilling but for a change of the speed at the start.
fn two_lumps([speed, rate]: [f64; 2], change: f64, (step, duration): (f64, f64)) -> Vec<CutStep> {
    let (inertia, spring, mass) = (116.0_f64, 938.0_f64, 34e3);
    let count = (duration / step) as usize;
    // Mean speeds over the steps after a load that is held over one: of an oscillator, and of a mass.
    let frequency = (spring / inertia).sqrt();
    let turned = |time: f64| match time > 0.0 {
        true => (1.0 - (frequency * time).cos()) / spring,
        false => 0.0,
    };
    let of_step = |time: f64| turned(time) - turned(time - step);
    let torsion = (0..count).map(|at| {
        let from = at as f64 * step;
        (of_step(from + step) - of_step(from)) / step
    });
    let torsion: Vec<f64> = torsion.collect();
    let mut axial = vec![step / mass; count];
    axial[0] *= 0.5;
    let kick = Kick {
        torque: inertia * change / step,
        force: 0.0,
        // The first step alone.
        duration: 0.75 * step,
    };
    let responses = given([torsion, axial], step);
    Drilling::steadily(&responses, &bit(60e6, 5e-3), [speed, rate], kick).steps()
}

/// A step in which the bit would turn past a blade has no answer: it is refused, with its time.
#[test]
fn val_a_step_past_a_blade_is_an_error() {
    let below = BelowDashpots::new(&[pipe(2000.0)], [0.7, -0.7]);
    let responses = responses(&below, &Method::Held, [1.0, 60.0]);
    let set = [20.0, 20e3 / below.dampings[1]];
    let past = Drilling::from_rest(&responses, &bit(4e6, 2e-3), 0.0, set).try_steps();
    let error = past.unwrap_err();
    assert!(
        matches!(error, sim::SimulationError::PastABlade { .. }),
        "{error}"
    );
}
