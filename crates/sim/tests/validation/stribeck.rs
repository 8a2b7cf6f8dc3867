//! A torque that falls with the speed of the bit: in the limit the law that falls at once, and
//! the same motion in much shorter steps.

use linear::Method;
use problems::academic;
use sim::{BitTorque, Scene, Simulator, Stopping, Timing, TorsionMeasures};

const RPM: f64 = std::f64::consts::TAU / 60.0;

/// Stick-slip of the paper's string as in its Fig. 8(b), with a torque that falls over a speed.
fn measures(method: Method, sampling_frequency: f64, decay_rpm: f64) -> TorsionMeasures {
    let request = linear::Request {
        sampling_frequency,
        ..academic::bit_request(60.0)
    };
    let responses = linear::responses(&academic::string(), &method, &request).unwrap();
    let scene = Scene {
        start: sim::Start::Rest,
        surface_speed: 0.1 * RPM,
        bit: Some(BitTorque {
            torque_static: 4800.0,
            torque_dynamic: 4000.0,
            decay_speed: decay_rpm * RPM,
        }),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: 60.0,
            closing_window: 10.0,
        },
    };
    let simulator = Simulator::new(&responses).unwrap();
    let outcome = simulator.simulate(&scene, Stopping::Full, None).unwrap();
    outcome.torsion().unwrap()
}

#[track_caller]
fn assert_near(one: &TorsionMeasures, other: &TorsionMeasures, part: f64) {
    assert_eq!(one.regime, other.regime);
    let numbers =
        |it: &TorsionMeasures| [it.first_slip, it.period, it.slip_time].map(Option::unwrap);
    for (one, other) in numbers(one).into_iter().zip(numbers(other)) {
        assert!((one / other - 1.0).abs() < part, "{one} {other}");
    }
    // Of a front, which a step smears.
    let peak = one.peak_speed / other.peak_speed - 1.0;
    assert!(peak.abs() < 3.0 * part, "{peak}");
}

#[test]
fn val_over_a_speed_of_nothing_it_falls_at_once() {
    let at_once = measures(Method::Quadrature, 640.0, 0.0);
    assert_near(&measures(Method::Quadrature, 640.0, 1e-6), &at_once, 1e-9);
}

/// Friedlander's rule keeps to its branch at any step. (A torque that falls over a higher
/// speed feeds high modes as well; by `held`, which damps none of them, the bit then chatters, the
/// faster the shorter the step.)
#[test]
fn val_motion_is_that_of_a_fine_time_step() {
    for (method, decay_rpm, part) in [
        (Method::Quadrature, 0.05, 0.015),
        (Method::Held, 0.05, 0.025),
        (Method::Quadrature, 0.2, 0.035),
    ] {
        let coarse = measures(method, 640.0, decay_rpm);
        let fine = measures(method, 5120.0, decay_rpm);
        assert_near(&coarse, &fine, part);
    }
}

/// The slower the torque falls, the less there is to slip with.
#[test]
fn val_a_torque_that_falls_slowly_drives_weaker_slips_and_in_the_end_none() {
    let of = |decay| measures(Method::Quadrature, 640.0, decay);
    let (at_once, slow) = (of(0.0), of(0.3));
    assert!(slow.peak_speed < 0.9 * at_once.peak_speed, "{slow:?}");
    assert!(slow.period < at_once.period, "{slow:?}");
    let slower = of(3.0);
    assert_ne!(slower.regime, sim::TorsionRegime::StickSlip, "{slower:?}");
}
