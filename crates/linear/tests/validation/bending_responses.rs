//! Validation of the lateral responses: closed forms in time, and the exact motion by
//! inverting the Laplace transform of the waves, which knows no step in time.

use linear::method::{FiniteElement, Transform};
use linear::passivity::STABLE_MARGIN;
use linear::waves::inversion::time_response;
use linear::waves::lateral::BendingNetwork;
use linear::{
    Bending, ChannelRequest, ChannelResponses, Complex64, Drillstring, Method, RaisedCosine,
    Request, Responses, Section, Sites, SurfaceSupport,
};
use problems::academic::{self, BENDING, SAMPLING_FREQUENCY, tube};
use problems::oracles::{self, assert_close};

const PULSE: RaisedCosine = RaisedCosine { duration: 0.02 };

fn hilbert(seconds: f64) -> Method {
    Method::Hilbert(Transform {
        seconds: Some(seconds),
    })
}

fn elements() -> Method {
    Method::FiniteElement(FiniteElement::default())
}

fn of_method(method: &Method, distances: &[f64], longest_time: f64) -> Responses {
    let string = academic::string();
    let request = Request {
        channels: vec![academic::free_in_bending()],
        ..academic::lateral_request(&string, distances, longest_time)
    };
    linear::responses(&string, method, &request).unwrap()
}

fn responses(method: &Method, distances: &[f64], longest_time: f64) -> ChannelResponses {
    let responses = of_method(method, distances, longest_time);
    responses.bending().unwrap().clone()
}

/// Response to the band-limited unit impulse (1 − cos 2πt/τ)/τ, τ = 0.02 s.
fn pulse_response(taps: &[f64]) -> Vec<f64> {
    let pulse: Vec<f64> = (0..taps.len())
        .map(|step| PULSE.at(step as f64 / SAMPLING_FREQUENCY))
        .collect();
    oracles::convolve(taps, &pulse)
}

fn peak(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, x| most.max(x.abs()))
}

/// The exact response to the impulse at one of `distances`, there, at the times of the
/// first steps.
fn exact_pulse_response(distances: &[f64], site: usize, steps: usize) -> Vec<f64> {
    let string = academic::string();
    let sites = Sites::new(&string, distances).unwrap();
    let network = BendingNetwork::new(&string, BENDING, SurfaceSupport::Free, &sites).unwrap();
    let displaced = |s: Complex64| network.receptance(s)[(site, site)] * PULSE.transform(s);
    time_response(displaced, 1.0 / SAMPLING_FREQUENCY, steps, 4)
}

#[test]
fn val_sites_are_displaced_as_the_exact_waves_are() {
    let steps = (9.0 * SAMPLING_FREQUENCY) as usize;
    for (distances, site) in [(&[0.0][..], 0), (&[0.0, 50.0, 100.0], 1)] {
        let exact = exact_pulse_response(distances, site, steps);
        for method in [Method::Quadrature, elements()] {
            let taps = responses(&method, distances, 9.5);
            let found = pulse_response(&taps.from_loads[site][site]);
            // The peak says which impulse reaches a wall.
            assert_close(peak(&found[..steps]), peak(&exact), 0.003);
            assert_close(found[steps - 1], exact[steps - 1], 0.005);
        }
    }
}

/// What makes the digital filter's tail too low: the response near zero frequency is
/// narrower than the frequency step, so that the error falls with the inverse of the
/// filter's length. The peak loses by it too.
#[test]
fn val_the_digital_filter_loses_the_tail_of_the_displacement() {
    let steps = (9.0 * SAMPLING_FREQUENCY) as usize;
    let exact = exact_pulse_response(&[0.0], 0, steps);
    let lost = |seconds: f64| {
        let taps = responses(&hilbert(seconds), &[0.0], 9.5);
        let found = pulse_response(&taps.from_loads[0][0]);
        let at_peak = 1.0 - peak(&found[..steps]) / peak(&exact);
        [at_peak, 1.0 - found[steps - 1] / exact[steps - 1]]
    };
    let all = [20.0, 40.0, 80.0, 160.0].map(lost);
    assert!(all[0][0] > 0.01 && all[0][1] > 0.5, "{all:?}");
    for pair in all.windows(2) {
        for (one, next) in pair[0].iter().zip(pair[1]) {
            assert!((1.8..2.8).contains(&(one / next)), "{all:?}");
        }
    }
}

/// It is what makes a step implicit, and small. By quadrature it is the receptance at
/// s = δ(0) f_s with δ(0) = 3/2.
#[test]
fn val_the_first_tap_is_a_few_per_cent_of_the_peak() {
    for method in [hilbert(40.0), Method::Quadrature, elements()] {
        let taps = &responses(&method, &[0.0], 5.0).from_loads[0][0];
        let part = taps[0] / peak(taps);
        assert!((0.03..0.1).contains(&part), "{}: {part}", method.name());
        if method == Method::Quadrature {
            let string = academic::string();
            let network =
                BendingNetwork::new(&string, BENDING, SurfaceSupport::Free, &Sites::bit());
            let s = Complex64::new(1.5 * SAMPLING_FREQUENCY, 0.0);
            let receptance = network.unwrap().receptance(s)[(0, 0)];
            assert_close(taps[0], receptance.re, 1e-8);
        }
    }
}

/// Free end of an undamped semi-infinite beam, unit impulse:
/// x(t) = 2√(2/π) √t / ((ρA)^¾ (EI)^¼).
#[test]
fn val_a_semi_infinite_beam_follows_its_closed_form() {
    let part = tube(10.0, 0.125);
    let section = Section {
        repeat: 200,
        parts: vec![part],
    };
    let string = Drillstring::new(academic::string().material(), vec![section], 0.0).unwrap();
    let bending = Bending {
        damping: 0.0,
        ..BENDING
    };
    let support = SurfaceSupport::Free;
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Bending { bending, support }],
        sampling_frequency: 2000.0,
        longest_time: 0.5,
    };
    let inertia = string.material().density * part.area();
    let rigidity = bending.youngs_modulus * part.second_moment();
    let scale = inertia.powf(0.75) * rigidity.powf(0.25);
    for method in [Method::Quadrature, elements()] {
        let responses = linear::responses(&string, &method, &request).unwrap();
        let taps = responses.bending().unwrap();
        for step in [100, 400, 900] {
            let time = step as f64 / 2000.0;
            let exact = 2.0 * (2.0 / std::f64::consts::PI * time).sqrt() / scale;
            // A tap is the response to a unit force over one step.
            let found = taps.from_loads[0][0][step] * 2000.0;
            assert_close(found, exact, 0.01);
        }
    }
}

/// Positive-real in each scheme's own sense of velocity: what holds against any
/// wall, and what does not.
#[test]
fn val_the_margin_tells_the_methods_that_hold_from_those_that_fail() {
    let margin = |method: Method, sites: &[f64]| {
        let responses = of_method(&method, sites, 10.0);
        responses.bending_margin().unwrap().unwrap()
    };
    let trapezoidal = Method::FiniteElement(FiniteElement {
        gamma: 0.5,
        ..FiniteElement::default()
    });
    let direct = Method::DirectIdft(Transform {
        seconds: Some(20.0),
    });
    for sites in [&[0.0][..], &[100.0, 50.0, 0.0]] {
        for method in [Method::Quadrature, elements(), hilbert(20.0)] {
            let found = margin(method, sites);
            assert!(found > STABLE_MARGIN, "{}: {found}", method.name());
        }
        assert!(margin(trapezoidal, sites) < -0.5);
        assert!(margin(direct, sites) < -0.5);
    }
}

/// Sites so close that they are nearly one: what differs between them is a millionth of what
/// they share, and would be lost were the stiff piece between them taken by its ends.
#[test]
fn val_sites_side_by_side_are_passive() {
    for spacing in [0.05, 0.01] {
        for method in [Method::Quadrature, Method::Held] {
            let found = of_method(&method, &[spacing, 0.0], 5.0);
            let margin = found.bending_margin().unwrap().unwrap();
            assert!(margin > -1e-7, "{} {spacing} m: {margin}", method.name());
        }
    }
}

/// In bending mud is nothing but more mass: a tube of the density that makes up for it responds
/// alike, by waves and by elements; and torsion does not feel it.
#[test]
fn val_mud_is_more_mass_sideways_and_none_in_torsion() {
    let tube = academic::tube(10.0, 0.1);
    let sections = vec![linear::Section {
        repeat: 40,
        parts: vec![tube],
    }];
    let string = |density: f64| {
        let steel = linear::Material {
            shear_modulus: 80e9,
            density,
        };
        linear::Drillstring::new(steel, sections.clone(), 5.0).unwrap()
    };
    let (hole, mud) = (0.155, 1600.0);
    let filled = |sections: &[(f64, f64)]| linear::Hole {
        sections: (sections.iter())
            .map(|&(length, radius)| linear::HoleSection { length, radius })
            .collect(),
        mud: linear::Mud {
            density: mud,
            viscosity: 0.0,
        },
    };
    let in_mud = string(7840.0).in_hole(filled(&[(400.0, hole)])).unwrap();
    // 0.1² of 0.155²: what moves around is 2.43 times what the tube displaces.
    let squares = [tube.inner_radius, tube.outer_radius, hole].map(|radius: f64| radius.powi(2));
    let moved = squares[0] + squares[1] * (squares[2] + squares[1]) / (squares[2] - squares[1]);
    let heavier = 7840.0 + mud * moved / (squares[1] - squares[0]);
    assert!((moved - (squares[0] + 2.426 * squares[1])).abs() < 1e-5);
    let request = |string: &linear::Drillstring| academic::lateral_request(string, &[0.0], 2.0);
    for method in [
        Method::Quadrature,
        Method::FiniteElement(Default::default()),
    ] {
        let build = |string: &linear::Drillstring| {
            linear::responses(string, &method, &request(string)).unwrap()
        };
        let (found, expected, dry) = (
            build(&in_mud),
            build(&string(heavier)),
            build(&string(7840.0)),
        );
        let bending = |it: &linear::Responses| it.bending().unwrap().from_loads[0][0].clone();
        let largest = bending(&expected)
            .iter()
            .fold(0.0, |most: f64, tap| most.max(tap.abs()));
        let off = |one: Vec<f64>, other: Vec<f64>| {
            let pairs = one.into_iter().zip(other);
            pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / largest
        };
        assert!(off(bending(&found), bending(&expected)) < 1e-9);
        assert!(off(bending(&found), bending(&dry)) > 0.05);
        assert_eq!(found.torsion(), dry.torsion());
    }
    // Too narrow, somewhere; too short; and wide enough where the string is, though not below.
    for (sections, fits) in [
        (&[(400.0, 0.1)][..], false),
        (&[(200.0, 0.2), (10.0, 0.1), (190.0, 0.2)], false),
        (&[(200.0, 0.2), (199.0, 0.3)], false),
        (&[(200.0, 0.2), (200.0, 0.3), (50.0, 0.1)], true),
    ] {
        assert_eq!(
            string(7840.0).in_hole(filled(sections)).is_ok(),
            fits,
            "{sections:?}"
        );
    }
}
