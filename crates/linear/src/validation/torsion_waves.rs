//! Validation of the torsional waves: closed forms, static limits, reciprocity,
//! passivity.

use super::academic::{self, SAMPLING_FREQUENCY, tube};
use linear::RaisedCosine;
use linear::assembly::chain::{self, Ends};
use linear::assembly::torsion::DynamicStiffness;
use linear::distributed_loss::LossAlong;
use linear::estimates::{
    torsional_impedance, torsional_stiffness, torsional_travel_time, torsional_wave_left,
};
use linear::passivity::Ending;
use linear::waves::{network::TorsionNetwork, torsion};
use linear::{
    ChannelRequest, ChannelResponses, Drillstring, Method, Request, Section, Sites, Tube,
};
use num_complex::Complex64;
use proptest::prelude::*;

fn methods() -> [Method; 3] {
    [
        Method::Quadrature,
        Method::Hilbert(Default::default()),
        Method::FiniteElement(Default::default()),
    ]
}

fn responses(string: &Drillstring, method: &Method, request: &Request) -> ChannelResponses {
    let responses = linear::responses(string, method, request).unwrap();
    responses.torsion().unwrap().clone()
}

/// A tube without mud around it.
fn bare(string: &Drillstring, tube: &Tube, s: Complex64) -> DynamicStiffness {
    let loss = LossAlong::exact(string, linear::Channel::Torsion, &[]);
    torsion::uniform(string, (tube, None), s, &loss.at(|| s))
}

fn running_sum(taps: &[f64]) -> Vec<f64> {
    taps.iter()
        .scan(0.0, |sum, tap| {
            *sum += tap;
            Some(*sum)
        })
        .collect()
}

#[test]
fn val_a_wave_arrives_when_it_has_travelled_the_string() {
    let string = academic::string();
    let arrival = 1000.0 / (80e9f64 / 7840.0).sqrt();
    for method in methods() {
        let taps = responses(&string, &method, &academic::bit_request(5.0));
        let speed = running_sum(&taps.from_surface[0]);
        let front = speed.iter().position(|&speed| speed > 0.407).unwrap();
        let time = front as f64 / SAMPLING_FREQUENCY;
        assert!(
            (time / arrival - 1.0).abs() < 0.03,
            "{}: {time}",
            method.name()
        );
        // A tenth of the travel time ahead of it all is quiet.
        let ahead = (0.9 * arrival * SAMPLING_FREQUENCY) as usize;
        let quiet = speed[..ahead]
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(quiet < 0.02, "{}: {quiet}", method.name());
    }
}

/// After the front has passed and before the next reflection in the collars
/// comes back: transmission into the collars, doubled at the free bit, damped
/// along both.
#[test]
fn val_the_first_plateau_is_that_of_two_impedances_in_series() {
    let string = academic::string();
    let pipe = &string.sections()[0];
    // Low frequencies see the cell's mean compliance and inertia.
    let mean = |weight: &dyn Fn(&Tube) -> f64| -> f64 {
        pipe.parts
            .iter()
            .map(|part| part.length * weight(part))
            .sum::<f64>()
            / pipe.cell_length()
    };
    let material = string.material();
    let inertia = material.density * mean(&|part| part.polar_moment());
    let compliance = mean(&|part| 1.0 / part.polar_moment()) / material.shear_modulus;
    let pipe_impedance = (inertia / compliance).sqrt();
    let collar_impedance = torsional_impedance(&string, &string.sections()[1].parts[0]);
    let damping = string.torsional_damping();
    let loss = damping * (900.0 / (2.0 * pipe_impedance) + 100.0 / (2.0 * collar_impedance));
    let plateau = 2.0 * 2.0 * pipe_impedance / (pipe_impedance + collar_impedance) * (-loss).exp();
    assert!((plateau / 0.814 - 1.0).abs() < 0.01, "{plateau}");
    let left = torsional_wave_left(&string);
    assert!((left / (-loss).exp() - 1.0).abs() < 0.01, "{left}");

    // A ramp without the high frequencies that the joints scatter, and a
    // sampling frequency that follows it.
    let (ramp, sampling_frequency) = (0.02, 2560.0);
    let request = Request {
        sampling_frequency,
        ..academic::bit_request(2.0)
    };
    let taps = responses(&string, &Method::Quadrature, &request);
    let input: Vec<f64> = (0..1280)
        .map(|n| RaisedCosine { duration: ramp }.integral(n as f64 / sampling_frequency))
        .collect();
    let speed = super::oracles::convolve(&taps.from_surface[0], &input);
    // The plateau lasts until the wave has been up and down the collars. The
    // formula is its value at the front; damping lets it rise from there.
    let front = 900.0 * (inertia * compliance).sqrt() + 100.0 / string.torsional_wave_speed();
    let window = (front + ramp + 0.012)..(front + ramp / 2.0 + 0.045);
    let inside: Vec<(f64, f64)> = (0..speed.len())
        .map(|step| (step as f64 / sampling_frequency, speed[step]))
        .filter(|(time, _)| window.contains(time))
        .collect();
    let at_front = extrapolate(&inside, front + ramp / 2.0);
    assert!(
        (at_front / plateau - 1.0).abs() < 0.01,
        "{at_front} {plateau}"
    );
}

/// The least-squares line through `points` at `x`.
fn extrapolate(points: &[(f64, f64)], x: f64) -> f64 {
    let count = points.len() as f64;
    let mean_x = points.iter().map(|point| point.0).sum::<f64>() / count;
    let mean_y = points.iter().map(|point| point.1).sum::<f64>() / count;
    let spread: f64 = points.iter().map(|point| (point.0 - mean_x).powi(2)).sum();
    let slope = points
        .iter()
        .map(|point| (point.0 - mean_x) * (point.1 - mean_y))
        .sum::<f64>()
        / spread;
    mean_y + slope * (x - mean_x)
}

#[test]
fn val_a_uniform_undamped_string_follows_dalembert() {
    let string = Drillstring::new(
        academic::string().material(),
        vec![Section {
            repeat: 50,
            parts: vec![tube(10.0, 0.125)],
        }],
        0.0,
    )
    .unwrap();
    let travel = torsional_travel_time(&string);
    let (sampling_frequency, count) = (4000.0, 8000);
    let ramp = |time: f64| RaisedCosine { duration: 0.2 }.integral(time);
    let input: Vec<f64> = (0..count)
        .map(|n| ramp(n as f64 / sampling_frequency))
        .collect();
    let exact: Vec<f64> = (0..count)
        .map(|n| super::oracles::free_bit_speed(n as f64 / sampling_frequency, travel, ramp))
        .collect();
    for method in [
        Method::Quadrature,
        Method::FiniteElement(linear::method::FiniteElement {
            gamma: 0.5,
            ..Default::default()
        }),
    ] {
        let request = Request {
            sites: Sites::bit(),
            channels: vec![ChannelRequest::Torsion { torques: vec![] }],
            sampling_frequency,
            longest_time: count as f64 / sampling_frequency,
        };
        let taps = responses(&string, &method, &request);
        let speed = super::oracles::convolve(&taps.from_surface[0], &input);
        let error = super::oracles::relative_difference(&speed, &exact);
        assert!(error < 2e-3, "{}: {error}", method.name());
    }
}

#[test]
fn val_a_constant_torque_twists_every_site_statically() {
    let string = academic::string();
    let sites = Sites::new(&string, &[0.0, 333.0]).unwrap();
    let request = Request {
        sites,
        channels: vec![ChannelRequest::Torsion {
            torques: vec![0, 1],
        }],
        sampling_frequency: SAMPLING_FREQUENCY,
        longest_time: 40.0,
    };
    // The upper site holds only what is above it, 667 m of drillpipe.
    let pipe = &string.sections()[0];
    let flexibility: f64 = pipe
        .parts
        .iter()
        .map(|part| part.length / part.polar_moment())
        .sum();
    let mut above = 66.0 * flexibility;
    above += 7.0 / pipe.parts[0].polar_moment();
    let upper_flexibility = above / 80e9;
    let lower_flexibility = 1.0 / torsional_stiffness(&string);
    for method in methods() {
        let taps = responses(&string, &method, &request);
        // With no speed left in the end, the rotation is −Σ n A(n) / f_s.
        let twist = |taps: &[f64]| -> f64 {
            let moment: f64 = taps.iter().enumerate().map(|(n, tap)| n as f64 * tap).sum();
            -moment / SAMPLING_FREQUENCY
        };
        for (output, input, expected) in [
            (0, 0, upper_flexibility),
            (0, 1, upper_flexibility),
            (1, 0, upper_flexibility),
            (1, 1, lower_flexibility),
        ] {
            let found = twist(&taps.from_loads[output][input]);
            // Half a step of delay is all that a method may add.
            assert!(
                (found / expected - 1.0).abs() < 2e-3,
                "{} {output} {input}: {found} {expected}",
                method.name()
            );
        }
    }
}

#[test]
fn val_everything_turns_with_the_surface_in_the_end() {
    let string = academic::string();
    for method in methods() {
        let taps = responses(&string, &method, &academic::bit_request(40.0));
        let final_speed: f64 = taps.from_surface[0].iter().sum();
        assert!(
            (final_speed - 1.0).abs() < 1e-6,
            "{}: {final_speed}",
            method.name()
        );
    }
}

/// Rounding in what a chain is joined from may hide that its response has decayed: it would
/// then be built, and summed, for as long as a case may last.
#[test]
fn val_taps_end_where_they_have_decayed() {
    let (string, request) = (academic::string(), academic::bit_request(300.0));
    for method in [
        Method::Quadrature,
        Method::Held,
        Method::FiniteElement(Default::default()),
    ] {
        let found = responses(&string, &method, &request);
        let lasts = found.from_loads[0][0].len() as f64 / request.sampling_frequency;
        assert_eq!(found.ending, Ending::Whole, "{}", method.name());
        assert!(lasts < 30.0, "{}: {lasts} s", method.name());
    }
}

/// A string that rings for longer than it is simulated has no taps beyond; those that it has
/// are the first of all, and no less passive.
#[test]
fn val_taps_end_where_nothing_looks_any_more() {
    let string = academic::damped_string(2.0);
    for method in [
        Method::Quadrature,
        Method::Held,
        Method::FiniteElement(Default::default()),
    ] {
        let found = responses(&string, &method, &academic::bit_request(10.0));
        let whole = responses(&string, &method, &academic::bit_request(300.0));
        assert_eq!(whole.ending, Ending::Whole, "{}", method.name());
        let lasts = found.taps() as f64 / SAMPLING_FREQUENCY;
        assert!(
            (10.0..11.0).contains(&lasts),
            "{}: {lasts} s",
            method.name()
        );
        let (found, whole) = (&found.from_loads[0][0], &whole.from_loads[0][0]);
        // The last step of held impulses is not over.
        let compared = found.len() - 1;
        let difference =
            super::oracles::relative_difference(&found[..compared], &whole[..compared]);
        assert!(difference < 1e-8, "{}: {difference}", method.name());
    }
}

#[test]
fn val_a_string_turned_over_has_its_ends_exchanged() {
    let string = academic::string();
    let upside_down = Drillstring::new(
        string.material(),
        string
            .sections()
            .iter()
            .rev()
            .map(|section| Section {
                repeat: section.repeat,
                parts: section.parts.iter().rev().copied().collect(),
            })
            .collect(),
        string.torsional_damping(),
    )
    .unwrap();
    for omega in [0.1, 3.0, 77.0, 950.0, 2100.0] {
        let s = Complex64::new(0.3, omega);
        let whole = |string: &Drillstring| {
            let pieces = string.sections().iter().filter_map(|section| {
                chain::section(section, Ends::Both, |tube| bare(string, tube, s))
            });
            chain::hung(pieces).unwrap()
        };
        let (one, other) = (whole(&string), whole(&upside_down));
        for (a, b) in [
            (one.top, other.bottom),
            (one.bottom, other.top),
            (one.cross, other.cross),
        ] {
            assert!((a - b).norm() <= 1e-10 * one.top.norm(), "{omega}: {a} {b}");
        }
    }
}

#[test]
fn val_rows_of_cells_agree_with_the_eigenvectors_of_the_paper() {
    let string = academic::string();
    let parts = &string.sections()[0].parts;
    for count in [1, 2, 7, 90, 500] {
        for omega in [0.5, 11.0, 200.0, 980.0, 1000.0, 1900.0] {
            let s = Complex64::new(0.0, omega);
            let cell = super::oracles::times(
                &super::oracles::transfer_matrix(&string, &parts[1], s),
                &super::oracles::transfer_matrix(&string, &parts[0], s),
            );
            let [top, cross, bottom] = super::oracles::eigenvector_chain(&cell, count);
            let section = Section {
                repeat: count,
                parts: parts.clone(),
            };
            let tube = |tube: &Tube| bare(&string, tube, s);
            let doubled = chain::section(&section, Ends::Both, tube).unwrap();
            for (found, expected) in [
                (doubled.top, top),
                (doubled.cross, cross),
                (doubled.bottom, bottom),
            ] {
                assert!(
                    (found - expected).norm() <= 1e-9 * top.norm(),
                    "{count} cells at {omega} rad/s: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn val_plain_products_of_transfer_matrices_overflow_where_joined_stiffnesses_do_not() {
    let string = academic::damped_string(1e5);
    let s = Complex64::new(0.0, 2000.0);
    let part = tube(10.0, 0.125);
    let cell = super::oracles::transfer_matrix(&string, &part, s);
    let product = (0..2000).fold(cell, |product, _| super::oracles::times(&cell, &product));
    let [top, ..] = super::oracles::stiffness_of_transfer(&product);
    assert!(!top.is_finite(), "the product was expected to overflow");
    let section = Section {
        repeat: 2001,
        parts: vec![part],
    };
    let joined = chain::section(&section, Ends::Both, |tube| bare(&string, tube, s)).unwrap();
    // So long and so damped, the string is one-way: its top is alone.
    let infinite = bare(&string, &tube(1e5, 0.125), s).top;
    assert!((joined.top - infinite).norm() <= 1e-9 * infinite.norm());
    assert!(joined.bottom.is_finite() && joined.cross.norm() == 0.0);
}

#[test]
fn val_a_site_in_the_middle_of_a_pipe_splits_nothing_but_the_arithmetic() {
    let string = academic::string();
    let with = |distances: &[f64]| Sites::new(&string, distances).unwrap();
    let s = Complex64::new(1.0, 300.0);
    let whole = TorsionNetwork::new(&string, &with(&[0.0]))
        .unwrap()
        .admittance(s);
    let split = TorsionNetwork::new(&string, &with(&[0.0, 123.4, 804.7]))
        .unwrap()
        .admittance(s);
    let difference = |a: Complex64, b: Complex64| (a - b).norm() / b.norm();
    assert!(difference(split.from_surface[2], whole.from_surface[0]) < 1e-10);
    assert!(difference(split.from_torque[(2, 2)], whole.from_torque[(0, 0)]) < 1e-10);
    let hanging = TorsionNetwork::new(&string, &with(&[123.4]))
        .unwrap()
        .admittance(s);
    assert!(difference(hanging.from_torque[(0, 0)], split.from_torque[(1, 1)]) < 1e-10);
}

fn any_string() -> impl Strategy<Value = Drillstring> {
    let part = (0.1..30.0f64, 0.01..0.1f64, 1.05..4.0f64).prop_map(|(length, inner, ratio)| Tube {
        length,
        inner_radius: inner,
        outer_radius: inner * ratio,
    });
    let section = (1..2000usize, prop::collection::vec(part, 1..4))
        .prop_map(|(repeat, parts)| Section { repeat, parts });
    (prop::collection::vec(section, 1..4), 0.0..1000.0f64).prop_map(|(sections, damping)| {
        Drillstring::new(academic::string().material(), sections, damping).unwrap()
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..Default::default() })]

    /// The exact admittance, at any frequency in the right half plane.
    #[test]
    fn val_the_driving_point_of_any_string_is_positive_real(
        string in any_string(),
        real in 0.0..10.0f64,
        omega in 1e-3..5e3f64,
        place in 0.0..1.0f64,
    ) {
        let distance = 0.99 * place * string.length();
        let sites = Sites::new(&string, &[distance]).unwrap();
        let admittance = TorsionNetwork::new(&string, &sites).unwrap().admittance(Complex64::new(real, omega));
        let point = admittance.from_torque[(0, 0)];
        // An undamped string on the imaginary axis has a real part of zero.
        prop_assert!(point.re >= -1e-9 * point.norm(), "{}", point);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..Default::default() })]

    /// The taps of the quadrature, on any string, as long as they are kept until they have decayed.
    #[test]
    fn val_the_taps_of_any_damped_string_are_positive_real(
        repeat in 1..2000usize,
        ratio in 1.05..4.0f64,
        decay_per_round_trip in 1.0..10.0f64,
        samples_per_round_trip in 20.0..300.0f64,
    ) {
        let inner = 0.05;
        let part = Tube { length: 9.0, inner_radius: inner, outer_radius: inner * ratio };
        let joint = Tube { length: 1.0, outer_radius: 1.2 * inner * ratio, ..part };
        let material = academic::string().material();
        let section = Section { repeat, parts: vec![part, joint] };
        let undamped = Drillstring::new(material, vec![section.clone()], 0.0).unwrap();
        let round_trip = 2.0 * torsional_travel_time(&undamped);
        let decay_rate = decay_per_round_trip / round_trip;
        let damping = 2.0 * decay_rate * material.density * part.polar_moment();
        let string = Drillstring::new(material, vec![section], damping).unwrap();
        let request = Request {
            sites: Sites::bit(),
            channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
            sampling_frequency: samples_per_round_trip / round_trip,
            longest_time: 1e3 * round_trip,
        };
        let responses = linear::responses(&string, &Method::Quadrature, &request).unwrap();
        let margin = responses.torsion_margin().unwrap().unwrap();
        prop_assert!(margin > linear::passivity::STABLE_MARGIN, "{}", margin);
    }
}
