//! The failures that the atlas of `sweep study stability` is about: each failing method
//! is seen to fail, and its margin says so beforehand; each remedy holds. The
//! paper's string, its bit held by rock or its side on the wall.

use linear::estimates::torsional_stiffness;
use linear::method::{FiniteElement, Transform};
use linear::passivity::STABLE_MARGIN;
use linear::waves::lateral::BendingNetwork;
use linear::waves::transfer::tip_receptance;
use linear::{Drillstring, Method, Request, Responses, Section, Sites, SurfaceSupport};
use problems::academic::{self, BENDING};
use sim::Simulator;
use sim::diagnosis::{Sticking, sticking};
use sim::oscillator::worst_load_gain;

/// As long as Fig. 8(b), s.
const HELD_FOR: f64 = 40.0;

fn sticking_of(responses: &Responses, string: &Drillstring) -> Sticking {
    sticking(
        Simulator::new(responses).unwrap().stuck_torque().unwrap(),
        responses.sampling_frequency,
        torsional_stiffness(string),
        responses.at_bit().unwrap()[0],
    )
}

/// A number of sections of the paper's drillpipe.
fn drillpipe(repeat: usize, damping: f64) -> Drillstring {
    let academic = academic::string();
    let pipe = Section {
        repeat,
        ..academic.sections()[0].clone()
    };
    Drillstring::new(academic.material(), vec![pipe], damping).unwrap()
}

fn elements(gamma: f64) -> Method {
    Method::FiniteElement(FiniteElement {
        gamma,
        ..FiniteElement::default()
    })
}

fn hilbert(seconds: f64) -> Method {
    Method::Hilbert(Transform {
        seconds: Some(seconds),
    })
}

/// What holding the bit shows, the margin that predicts it, and what a load tuned to
/// its place gains.
fn held(method: &Method) -> (Sticking, f64, f64) {
    let request = academic::bit_request(HELD_FOR);
    let responses = linear::responses(&academic::string(), method, &request).unwrap();
    let found = sticking_of(&responses, &academic::string());
    let margin = responses.torsion_margin().unwrap().unwrap();
    let gain = worst_load_gain(&responses.torsion().unwrap().driving_points()).unwrap();
    (found, margin, gain)
}

#[track_caller]
fn assert_fails_as_predicted(method: &Method) -> Sticking {
    let (found, margin, gain) = held(method);
    assert!(margin < STABLE_MARGIN, "{margin}");
    assert!(gain > -STABLE_MARGIN, "{gain}");
    found
}

#[track_caller]
fn assert_holds(method: &Method) {
    let (found, margin, gain) = held(method);
    assert!(margin > STABLE_MARGIN, "{margin}");
    assert!(gain < -STABLE_MARGIN, "{gain}");
    assert!(found.chatter < 1e-6, "{found:?}");
    assert!(found.drift.abs() < 1e-3, "{found:?}");
}

#[test]
fn the_plain_inverse_transform_diverges_while_the_bit_sticks() {
    let found = assert_fails_as_predicted(&Method::DirectIdft(Transform::default()));
    assert!(found.chatter > 1.0 && found.growth > 1e6, "{found:?}");
}

#[test]
fn a_short_digital_filter_drifts_and_a_longer_one_does_not() {
    let found = assert_fails_as_predicted(&hilbert(3.0));
    assert!(found.drift > 0.2, "{found:?}");
    let found = assert_fails_as_predicted(&hilbert(4.0));
    assert!(found.drift.abs() > 0.05, "{found:?}");
    assert_holds(&hilbert(20.0));
}

#[test]
fn newmark_without_numerical_damping_chatters_and_with_a_little_does_not() {
    let found = assert_fails_as_predicted(&elements(0.5));
    assert!(found.chatter > 1e-4, "{found:?}");
    assert_holds(&elements(0.52));
}

#[test]
fn the_trapezoidal_rule_chatters_and_backward_differences_do_not() {
    let found = assert_fails_as_predicted(&Method::Trapezoidal);
    assert!(found.chatter > 1e-4, "{found:?}");
    assert_holds(&Method::Quadrature);
}

/// At any sampling frequency.
#[test]
fn held_loads_hold_a_sticking_bit() {
    assert_holds(&Method::Held);
    let string = academic::string();
    for sampling_frequency in [100.0, 1000.0] {
        let request = Request {
            sampling_frequency,
            ..academic::bit_request(HELD_FOR)
        };
        let responses = linear::responses(&string, &Method::Held, &request).unwrap();
        let margin = responses.torsion_margin().unwrap().unwrap();
        assert!(margin > STABLE_MARGIN, "{margin}");
        let found = sticking_of(&responses, &string);
        assert!(found.chatter < 1e-6, "{found:?}");
        assert!(found.drift.abs() < 1e-6, "{found:?}");
    }
}

/// A wall meets differences of positions from step to step, by `held` from the beginning
/// of a step to its middle; from step to step they would give energy.
#[test]
fn what_a_wall_takes_for_the_velocity_is_passive_but_by_newmarks_scheme() {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![academic::free_in_bending()],
        sampling_frequency: academic::SAMPLING_FREQUENCY,
        longest_time: 9.0,
    };
    let margins = |method: &Method| {
        let found = linear::responses(&academic::string(), method, &request).unwrap();
        let wall = found.margin_of_differences().unwrap().unwrap();
        (wall, found.bending_margin().unwrap().unwrap())
    };
    let (wall, own) = margins(&Method::Held);
    assert!(wall > 0.3 && (wall - own).abs() < 1e-9, "{wall} {own}");
    assert!(margins(&Method::Quadrature).0 > 0.3);
    assert!(margins(&elements(0.52)).0 < -0.1);
}

/// The displacement at the bit 9 s after an impulse, m per N s.
fn displacement_left(method: &Method) -> f64 {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![academic::free_in_bending()],
        sampling_frequency: academic::SAMPLING_FREQUENCY,
        longest_time: 9.0,
    };
    let found = linear::responses(&academic::string(), method, &request).unwrap();
    assert!(found.bending_margin().unwrap().unwrap() > STABLE_MARGIN);
    let taps = found.bending().unwrap().taps_between(0, 0).unwrap();
    taps.last().unwrap() * academic::SAMPLING_FREQUENCY
}

/// Passive all the same: no margin predicts it.
#[test]
fn a_digital_filter_in_bending_loses_the_tail_and_a_longer_one_loses_less() {
    let truly = displacement_left(&Method::Quadrature);
    assert!((truly / 2.353e-5 - 1.0).abs() < 0.005, "{truly}");
    let left = [20.0, 40.0, 160.0].map(|seconds| displacement_left(&hilbert(seconds)) / truly);
    assert!(left[0] < 0.25 && left[1] < 0.72, "{left:?}");
    assert!((0.9..1.0).contains(&left[2]), "{left:?}");
    let by_held = displacement_left(&Method::Held) / truly;
    assert!((by_held - 1.0).abs() < 1e-6, "{by_held}");
}

#[test]
fn products_of_transfer_matrices_overflow_and_joined_stiffnesses_do_not() {
    let string = drillpipe(2000, 0.0);
    let rate = std::f64::consts::TAU * 100.0;
    assert!(!tip_receptance(&string, &BENDING, rate).is_finite());
    let bit = Sites::bit();
    let network = BendingNetwork::new(&string, BENDING, SurfaceSupport::Free, &bit).unwrap();
    let joined = network.at_rate(rate)[(0, 0)];
    // Passive: the force does work.
    assert!(joined.is_finite() && joined.im < 0.0, "{joined}");
}

/// A transform that suits the paper's string would be too short for one of ten
/// kilometres, along which torque seeps for minutes.
#[test]
fn the_digital_filter_of_a_very_long_string_lasts_until_torque_has_seeped_along() {
    let string = drillpipe(1000, academic::string().torsional_damping());
    let request = Request {
        sampling_frequency: 40.0,
        ..academic::bit_request(400.0)
    };
    let method = Method::Hilbert(Transform::default());
    let responses = linear::responses(&string, &method, &request).unwrap();
    let found = sticking_of(&responses, &string);
    assert!(found.drift.abs() < 0.01, "{found:?}");
}
