//! Loss that depends on frequency, in torsion: modes by an independent calculation, the exact
//! response in time, and passivity, by every method.

use linear::deviation::{ExactMotions, exact_undershoot};
use linear::elements::error_of_drag;
use linear::estimates::{largest_undershoot, torsional_resistance, torsional_travel_time};
use linear::method::{FiniteElement, Transform};
use linear::modes::{damped_modes, torsional_modes};
use linear::natural_frequencies::NaturalFrequencies;
use linear::waves::inversion::time_response;
use linear::waves::lateral::BendingNetwork;
use linear::waves::network::TorsionNetwork;
use linear::{
    Bending, Channel, ChannelRequest, Complex64, Drillstring, Hole, HoleSection, Material, Method,
    Mud, RaisedCosine, Request, Section, Sites, SurfaceSupport, Tube,
};
use proptest::prelude::*;
use std::f64::consts::TAU;

const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

/// 5-inch pipe, 2000 m of it.
const PIPE: Tube = Tube {
    length: 2000.0,
    inner_radius: 0.054,
    outer_radius: 0.0635,
};

fn methods() -> [Method; 3] {
    let elements = FiniteElement {
        elements_per_cell: 400,
        ..FiniteElement::default()
    };
    [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(elements),
    ]
}

fn hole(length: f64, radius: f64, viscosity: f64) -> Hole {
    Hole {
        sections: vec![HoleSection { length, radius }],
        mud: Mud {
            density: 1200.0,
            viscosity,
        },
    }
}

fn pipe(torsional_damping: f64) -> Drillstring {
    let section = Section {
        repeat: 1,
        parts: vec![PIPE],
    };
    Drillstring::new(STEEL, vec![section], torsional_damping).unwrap()
}

fn in_mud(string: Drillstring) -> Drillstring {
    let length = string.length();
    string.in_hole(hole(length, 0.108, 0.03)).unwrap()
}

/// The three cases of the table of modes.
fn case(name: &str) -> Drillstring {
    match name {
        "mud" => in_mud(pipe(0.0)),
        "steel" => pipe(0.0).with_loss_factor(1e-3).unwrap(),
        _ => in_mud(pipe(0.03)).with_loss_factor(1e-3).unwrap(),
    }
}

/// Frequency, Hz, and rate of decay, 1/s, of modes by number, found in 34 digits by mpmath
/// (`scripts/mud-drag.py`).
fn modes(name: &str) -> Vec<(usize, Complex64)> {
    let table = include_str!("../../src/loss/reference/modes.csv");
    let rows = table
        .lines()
        .filter_map(|line| line.strip_prefix(name)?.strip_prefix(','));
    let mode = |line: &str| {
        let numbers: Vec<f64> = line
            .split(',')
            .map(|field| field.parse().unwrap())
            .collect();
        (
            numbers[0] as usize,
            Complex64::new(-numbers[2], TAU * numbers[1]),
        )
    };
    rows.map(mode).collect()
}

#[test]
fn val_modes_in_mud_and_of_steel_are_those_of_their_equation() {
    for name in ["mud", "steel", "all"] {
        let string = case(name);
        let bare = NaturalFrequencies::torsion(&string).unwrap();
        let bare = bare.all_below(TAU * 401.0).unwrap();
        let damped = damped_modes(&string, &bare).unwrap();
        let lowest = torsional_modes(&string, 20).unwrap();
        let expected = modes(name);
        assert_eq!(expected.len(), 22);
        for (number, pole) in expected {
            let found = damped[number - 1].unwrap().pole;
            let error = (found.im / pole.im - 1.0)
                .abs()
                .max((found.re / pole.re - 1.0).abs());
            assert!(error < 1e-6, "{name} {number}: {found} {pole}");
            if let Some(mode) = lowest.get(number - 1) {
                assert!(
                    (mode.pole - found).norm() < 1e-6 * found.norm(),
                    "{name} {number}"
                );
            }
        }
    }
}

/// Mud that moves along makes the first mode slower by 3.6 %.
#[test]
fn val_torsion_feels_the_inertia_of_mud() {
    let string = case("mud");
    let bare = NaturalFrequencies::torsion(&string)
        .unwrap()
        .lowest(1)
        .unwrap();
    let slower = damped_modes(&string, &bare).unwrap()[0].unwrap().pole.im / bare[0] - 1.0;
    assert!((-0.037..-0.035).contains(&slower), "{slower}");
}

fn request(sampling_frequency: f64, longest_time: f64) -> Request {
    Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency,
        longest_time,
    }
}

fn bit_taps(string: &Drillstring, method: &Method, request: &Request) -> Vec<f64> {
    let responses = linear::responses(string, method, request).unwrap();
    responses.torsion().unwrap().from_loads[0][0].clone()
}

/// The pole that a response has near another: what it has of e^(iωt) in two windows, one later than
/// the other, that let no other mode through.
fn pole_of(taps: &[f64], sampling_frequency: f64, near: Complex64) -> Complex64 {
    let (window, later) = (20.0, 4.0);
    let count = (window * sampling_frequency) as usize;
    let shift = (later * sampling_frequency) as usize;
    let amplitude = |first: usize| -> Complex64 {
        let weighted = (0..count).map(|index| {
            let place = index as f64 / count as f64;
            // Four terms: side lobes are below 1e-4.
            let weight = 0.35875 - 0.48829 * (TAU * place).cos()
                + 0.14128 * (2.0 * TAU * place).cos()
                - 0.01168 * (3.0 * TAU * place).cos();
            let time = index as f64 / sampling_frequency;
            weight * taps[first + index] * (-near * time).exp()
        });
        weighted.sum()
    };
    let advanced = amplitude(shift) / amplitude(0);
    let since = shift as f64 / sampling_frequency;
    // Over that time it has turned by about as much as the other.
    let off = (advanced / (near * since).exp()).ln() / since;
    near + off
}

/// To a hundredth, by methods whose own damping is less than that there.
#[test]
fn val_taps_swing_and_decay_as_modes_do() {
    for name in ["mud", "all"] {
        let string = case(name);
        let samplings = [(640.0, 15), (2560.0, 5), (2560.0, 4)];
        for (method, (frequency, highest)) in methods().iter().zip(samplings) {
            let taps = bit_taps(&string, method, &request(frequency, 30.0));
            for (number, pole) in modes(name).into_iter().filter(|mode| mode.0 <= highest) {
                let found = pole_of(&taps, frequency, pole);
                let [decay, rate] = [found.re / pole.re - 1.0, found.im / pole.im - 1.0];
                let method = method.name();
                assert!(
                    decay.abs() < 0.01,
                    "{name} {method} {number}: {found} {pole}"
                );
                assert!(
                    rate.abs() < 1e-3,
                    "{name} {method} {number}: {found} {pole}"
                );
            }
        }
    }
}
/// Δ of Eq. 75 of the pipe with constant damping, in mud, with both, and with a loss factor too, rad/s per N m,
/// by inverting the Laplace transform.
#[test]
fn val_mud_takes_a_fifth_of_the_undershoot() {
    let strings = [
        (pipe(0.03), 2.666_252e-3),
        (in_mud(pipe(0.0)), 2.802_932e-3),
        (in_mud(pipe(0.03)), 2.119_538e-3),
        (case("all"), 2.112_500e-3),
    ];
    for (string, expected) in strings {
        let taps = bit_taps(&string, &Method::Held, &request(640.0, 10.0));
        let undershoot = largest_undershoot(&taps);
        assert!(
            (undershoot / expected - 1.0).abs() < 1e-2,
            "{undershoot} {expected}"
        );
    }
}

/// The undershoot after a torque that rises within a time (s), by inverting the Laplace transform.
fn inverted_undershoot(string: &Drillstring, rise: f64) -> f64 {
    let network = TorsionNetwork::new(string, &Sites::bit()).unwrap();
    let pulse = RaisedCosine { duration: rise };
    let speed = |s: Complex64| network.admittance(s).from_torque[(0, 0)] * pulse.transform(s) / s;
    let (step, time) = (0.5 * rise, 6.0 * torsional_travel_time(string));
    let speeds = time_response(speed, step, (time / step) as usize, 4);
    -speeds.into_iter().fold(0.0, f64::min)
}

/// However little a string loses, down to fronts of a third of a millisecond.
#[test]
fn val_the_exact_undershoot_is_that_of_the_inverted_waves() {
    let long = Tube {
        length: 2155.7,
        inner_radius: 0.0543,
        outer_radius: 0.0635,
    };
    let section = |parts| Section { repeat: 1, parts };
    let of_material = |loss_factor: f64| {
        let material = Material {
            shear_modulus: 77.2e9,
            density: 7881.0,
        };
        let string = Drillstring::new(material, vec![section(vec![long])], 0.0).unwrap();
        string.with_loss_factor(loss_factor).unwrap()
    };
    assert!((exact_undershoot(&of_material(0.00135)).unwrap() / 3.4039e-3 - 1.0).abs() < 5e-4);
    let lossy = [(0.0005, 4e-5), (0.005, 3e-4)].map(|(loss, rise)| (of_material(loss), rise));
    let others = [in_mud(pipe(0.0)), case("all")].map(|string| (string, 1e-4));
    for (string, rise) in lossy.into_iter().chain(others) {
        let inverted = inverted_undershoot(&string, rise);
        let exact = exact_undershoot(&string).unwrap();
        assert!((exact / inverted - 1.0).abs() < 1e-4, "{exact} {inverted}");
    }
}

/// What steps of a held torque do to speeds that are averaged over steps, by inverting the Laplace
/// transform, has no lattice and no lumps: it and `held` have the same undershoot to 0.2 %, and to as
/// much of it the same speeds after a step of torque (root mean square).
#[test]
fn val_lumps_on_the_lattice_answer_as_the_inversion_does() {
    let collars = Tube {
        length: 200.0,
        inner_radius: 0.0357,
        outer_radius: 0.1016,
    };
    let pipe = Tube {
        length: 1800.0,
        ..PIPE
    };
    let sections = [pipe, collars].map(|tube| Section {
        repeat: 1,
        parts: vec![tube],
    });
    let with_collars = Drillstring::new(STEEL, sections.to_vec(), 0.0).unwrap();
    let (frequency, time) = (640.0, 4.0);
    let step = 1.0 / frequency;
    for string in [case("mud"), case("all"), in_mud(with_collars)] {
        let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
        let held = |s: Complex64| {
            let both_ways = (s * step).exp() - 2.0 + (-s * step).exp();
            network.admittance(s).from_torque[(0, 0)] * both_ways / (s * s * step)
        };
        let count = (time * frequency) as usize;
        let inverted = time_response(held, step, count, 128);
        let lumps = bit_taps(&string, &Method::Held, &request(frequency, time));
        let undershoots = [&inverted, &lumps].map(|taps| largest_undershoot(taps));
        let off = undershoots[1] / undershoots[0] - 1.0;
        assert!(off.abs() < 2e-3, "{undershoots:?}");
        let sums = |taps: &[f64]| -> Vec<f64> {
            let mut sum = 0.0;
            taps.iter()
                .map(|tap| {
                    sum += tap;
                    sum
                })
                .collect()
        };
        let pairs = std::iter::zip(sums(&inverted), sums(&lumps));
        let squares = pairs.map(|(one, other)| (one - other).powi(2)).sum::<f64>();
        let off = (squares / count as f64).sqrt() / undershoots[0];
        assert!(off < 2e-3, "{off}");
    }
}

/// Strings of two sections, of which the upper may be jointed, in a hole that is wider above.
fn any_string() -> impl Strategy<Value = Drillstring> {
    let pipes = (3usize..60, 1.0..12.0f64, 0.05..0.07f64);
    let collars = (20.0..250.0f64, 0.07..0.1f64);
    (pipes, collars, 0.0..0.1f64).prop_map(|((repeat, length, outer), (below, wide), damping)| {
        let tube = |length, outer_radius| Tube {
            length,
            inner_radius: 0.04,
            outer_radius,
        };
        let sections = vec![
            Section {
                repeat,
                parts: vec![tube(length, outer), tube(0.5, outer + 0.015)],
            },
            Section {
                repeat: 1,
                parts: vec![tube(below, wide)],
            },
        ];
        Drillstring::new(STEEL, sections, damping).unwrap()
    })
}

/// The same with viscous mud and of a material with loss.
fn lossy(string: &Drillstring, viscosity: f64, loss_factor: f64) -> Drillstring {
    let above = 0.4 * string.length();
    let section = |length, radius| HoleSection { length, radius };
    let hole = Hole {
        sections: vec![
            section(above, 0.16),
            section(string.length() - above + 1.0, 0.108),
        ],
        mud: Mud {
            density: 1300.0,
            viscosity,
        },
    };
    let string = string.clone().in_hole(hole).unwrap();
    string.with_loss_factor(loss_factor).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..Default::default() })]

    /// No loss gives energy back, and what takes some takes it from every frequency.
    #[test]
    fn val_taps_of_any_string_with_loss_are_passive(
        string in any_string(),
        viscosity in 0.001..0.3f64,
        loss_factor in 1e-4..1e-2f64,
        steps in 60.0..300.0f64,
    ) {
        let travel = torsional_travel_time(&string);
        let request = request(steps / travel, 30.0 * travel);
        for method in methods() {
            let margin = |string: &Drillstring| {
                let responses = linear::responses(string, &method, &request).unwrap();
                responses.torsion_margin().unwrap().unwrap()
            };
            let (without, with) = (margin(&string), margin(&lossy(&string, viscosity, loss_factor)));
            let name = method.name();
            prop_assert!(with > -1e-9, "{name}: {with}");
            prop_assert!(with >= without - 1e-9, "{name}: {with} {without}");
        }
    }

    /// The exact motion of a smooth load, by inverting the Laplace transform of the waves.
    #[test]
    fn val_taps_of_any_string_with_loss_give_the_exact_motion(
        string in any_string(),
        viscosity in 0.001..0.3f64,
        loss_factor in 1e-4..1e-2f64,
    ) {
        let bare = string;
        let string = lossy(&bare, viscosity, loss_factor);
        let travel = torsional_travel_time(&string);
        let request = request(320.0 / travel, 20.0 * travel);
        let frequency = request.sampling_frequency;
        for method in methods() {
            let error = |string: &Drillstring| {
                let bit = Sites::bit();
                let exact = ExactMotions::in_torsion(string, &bit, frequency).unwrap();
                let responses = linear::responses(string, &method, &request).unwrap();
                exact.error_of(&responses).unwrap()
            };
            // What steps do to fronts is as without loss, or less.
            let (with, without) = (error(&string), error(&bare));
            let name = method.name();
            prop_assert!(with < 1.02 * without + 1e-3, "{name}: {with} {without}");
        }
    }
}

/// Elements have mud by a fit, to a part in 200, and say so.
#[test]
fn val_elements_have_the_drag_of_mud_to_a_part_in_200() {
    let string = case("all");
    for channel in [Channel::Torsion, Channel::Bending] {
        let error = error_of_drag(&string, channel).unwrap();
        assert!((1e-6..5e-3).contains(&error), "{channel}: {error}");
        assert_eq!(error_of_drag(&pipe(0.03), channel), None);
    }
}

/// In steady rotation a response ends at the constant drag, Couette flow, within the time that is asked
/// for: what comes later is cut anywhere.
#[test]
fn val_steady_rotation_meets_the_drag_of_steady_flow() {
    let string = case("all");
    let outer = [PIPE.outer_radius, 0.108].map(|radius: f64| radius * radius);
    let couette = 4.0 * std::f64::consts::PI * 0.03 * outer[0] * outer[1] / (outer[1] - outer[0]);
    let resistance = torsional_resistance(&string);
    assert!((resistance / (2000.0 * (0.03 + couette)) - 1.0).abs() < 1e-12);
    for method in methods() {
        let taps = linear::surface_torque(&string, &method, &request(640.0, 120.0)).unwrap();
        let asked = (640.0 * 120.0) as usize;
        let torque: f64 = taps.iter().take(asked).sum();
        let name = method.name();
        assert!(
            (torque / resistance - 1.0).abs() < 1e-3,
            "{name}: {torque} {resistance}"
        );
    }
}

/// Force on the bit that bends a collar in mud: the exact motion, by every method, and passive.
#[test]
fn val_bending_in_mud_is_the_exact_motion_and_passive() {
    let bending = Bending {
        youngs_modulus: 210e9,
        damping: 0.0,
        compression: 2e4,
    };
    let collar = Tube {
        length: 120.0,
        inner_radius: 0.0381,
        outer_radius: 0.0825,
    };
    let section = Section {
        repeat: 1,
        parts: vec![collar],
    };
    let string = |viscosity: f64, loss_factor: f64| {
        let string = Drillstring::new(STEEL, vec![section.clone()], 0.0).unwrap();
        let string = string.in_hole(hole(120.0, 0.108, viscosity)).unwrap();
        string.with_loss_factor(loss_factor).unwrap()
    };
    let request = Request {
        channels: vec![ChannelRequest::Bending {
            bending,
            support: SurfaceSupport::Pinned,
        }],
        ..request(1280.0, 3.0)
    };
    let elements = FiniteElement {
        elements_per_cell: 300,
        ..FiniteElement::default()
    };
    for method in [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(elements),
    ] {
        let of = |string: &Drillstring| {
            let bit = Sites::bit();
            let exact = ExactMotions::in_bending(
                string,
                &bending,
                SurfaceSupport::Pinned,
                &bit,
                0.05,
                1280.0,
            );
            let responses = linear::responses(string, &method, &request).unwrap();
            let error = exact.unwrap().error_of(&responses).unwrap();
            (error, responses.bending_margin().unwrap().unwrap())
        };
        let [(without, _), (thin, _), (thick, margin)] =
            [(0.0, 0.0), (1e-3, 0.0), (0.1, 2e-3)].map(|(mu, eta)| of(&string(mu, eta)));
        let name = method.name();
        assert!(thin < 1.05 * without + 1e-3, "{name}: {thin} {without}");
        assert!(thick < 1.05 * without + 1e-3, "{name}: {thick} {without}");
        assert!(margin > -1e-9, "{name}: {margin}");
    }
}

/// The first mode of a collar between two pins in mud: (EI k⁴ − C k²) m + s²M + s d(s) = 0 at k = π/L
/// holds where its receptance has a pole.
#[test]
fn val_a_pinned_collar_in_mud_swings_as_its_equation_says() {
    let bending = Bending {
        youngs_modulus: 210e9,
        damping: 0.0,
        compression: 0.0,
    };
    let collar = Tube {
        length: 30.0,
        inner_radius: 0.0381,
        outer_radius: 0.0825,
    };
    let section = Section {
        repeat: 1,
        parts: vec![collar],
    };
    let mud = hole(30.0, 0.108, 0.05);
    let string = Drillstring::new(STEEL, vec![section], 0.0).unwrap();
    let string = string.in_hole(mud).unwrap().with_loss_factor(5e-3).unwrap();
    let wave = std::f64::consts::PI / 30.0;
    let rigidity = bending.youngs_modulus * collar.second_moment() * wave.powi(4);
    let bore = std::f64::consts::PI * 1200.0 * collar.inner_radius.powi(2);
    let mass = STEEL.density * collar.area() + bore;
    let radii = [collar.inner_radius, collar.outer_radius];
    let closed = |s: Complex64| {
        let loss = string.loss();
        rigidity * loss.stiffening(s) + s * (s * mass + loss.against_moving(radii, Some(0.108), s))
    };
    // A string that hangs from a pin and is held by a very stiff one at the bit is pinned at both
    // ends: both answer in the middle as one half sine does, next to its pole.
    let sites = Sites::new(&string, &[15.0, 0.0]).unwrap();
    let network = BendingNetwork::new(&string, bending, SurfaceSupport::Pinned, &sites).unwrap();
    let pinned = |s: Complex64| {
        let free = network.receptance(s);
        free[(0, 0)] - free[(0, 1)] * free[(1, 0)] / free[(1, 1)]
    };
    let mut s = Complex64::new(-0.5, (rigidity / (2.0 * mass)).sqrt());
    for _ in 0..60 {
        let step = 1e-6 * s;
        let slope = (closed(s + step) - closed(s - step)) / (2.0 * step);
        s -= closed(s) / slope;
    }
    assert!(s.re < -0.1 && s.im > 1.0, "{s}");
    // Next to a pole a response is its residue over the distance, 2/L over the slope there.
    let near = 1e-4 * s;
    let slope = (closed(s + near) - closed(s - near)) / (2.0 * near);
    let expected = 2.0 / 30.0 / slope / near;
    let found = 0.5 * (pinned(s + near) - pinned(s - near));
    assert!((found / expected - 1.0).norm() < 1e-5, "{found} {expected}");
}

/// What is pushed aside stays where drag along the string left it: pipe and collars, which mud holds
/// back differently, shift and turn as a rod does, by the method that samples what they do in the
/// end and by one that does not.
#[test]
fn val_a_free_string_in_mud_ends_where_its_drag_leaves_it() {
    let parts = [(40.0, 0.0635), (20.0, 0.1)].map(|(length, outer_radius)| Tube {
        length,
        inner_radius: 0.04,
        outer_radius,
    });
    let sections = parts.map(|part| Section {
        repeat: 1,
        parts: vec![part],
    });
    let string = Drillstring::new(STEEL, sections.to_vec(), 1.0).unwrap();
    let string = string.in_hole(hole(60.0, 0.12, 0.5)).unwrap();
    for damping in [0.0, 3.0] {
        let bending = Bending {
            youngs_modulus: 210e9,
            damping,
            compression: 0.0,
        };
        let drags = parts.map(|part| {
            let radii = [part.inner_radius, part.outer_radius];
            let at_rest = Complex64::new(1e-9, 0.0);
            damping + string.loss().against_moving(radii, Some(0.12), at_rest).re
        });
        // Moments of the drag about the surface, by parts of the length.
        let moment = |power: i32| {
            let part = |from: f64, to: f64| {
                (to.powi(power + 1) - from.powi(power + 1)) / f64::from(power + 1)
            };
            60.0 * (drags[0] * part(0.0, 2.0 / 3.0) + drags[1] * part(2.0 / 3.0, 1.0))
        };
        let [whole, first, second] = [0, 1, 2].map(moment);
        // At the bit, of a force there: (1, 1) M⁻¹ (1, 1)ᵀ.
        let expected = (second - 2.0 * first + whole) / (whole * second - first * first);
        let found = [
            Method::Quadrature,
            Method::Hilbert(Transform {
                seconds: Some(400.0),
            }),
        ]
        .map(|method| {
            let request = Request {
                sites: Sites::bit(),
                channels: vec![ChannelRequest::Bending {
                    bending,
                    support: SurfaceSupport::Free,
                }],
                sampling_frequency: 200.0,
                longest_time: 40.0,
            };
            let responses = linear::responses(&string, &method, &request).unwrap();
            responses.bending().unwrap().from_loads[0][0]
                .last()
                .unwrap()
                * 200.0
        });
        for found in found {
            assert!(
                (found / expected - 1.0).abs() < 1e-6,
                "{damping} {found} {expected}"
            );
        }
    }
}
