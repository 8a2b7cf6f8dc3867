//! Held loads in simulations: stick-slip against waves handed on in time, whirl against the
//! balance of forces, and what fineness of step changes.

use linear::bending_decay::BendingDecay;
use linear::deviation::exact_undershoot;
use linear::estimates::{stick_slip_speed_limit, torsional_travel_time};
use linear::sampling::frequency_for_fronts;
use linear::steady::winding;
use linear::waves::lateral::BendingNetwork;
use linear::{
    Drillstring, Hole, HoleSection, Method, Mud, Request, Section, Sites, SurfaceSupport, responses,
};
use problems::academic::{self, BENDING, tube};
use problems::oracles::assert_close;
use problems::plain_lattice::PlainLattice;
use proptest::prelude::*;
use sim::excitation::least_impulse;
use sim::laws::contact::{Approach, Spin, WallLaw};
use sim::watch::lateral::{LateralMeasures, LateralRegime};
use sim::{
    BitTorque, Impulse, Lateral, Sampling, Scene, Simulator, Start, Stopping, Timing,
    TorsionRegime, Wall, WhirlingSite, torsion_timing,
};

const BIT: BitTorque = BitTorque {
    torque_static: 4800.0,
    torque_dynamic: 4000.0,
    decay_speed: 0.0,
};

fn string_of(lengths: &[(f64, f64)]) -> Drillstring {
    let sections = lengths.iter().map(|&(length, radius)| Section {
        repeat: 1,
        parts: vec![tube(length, radius)],
    });
    let material = academic::string().material();
    Drillstring::new(material, sections.collect(), 10.0).unwrap()
}

/// The value between two at which `is_inside` ends, to a thousandth.
fn limit([mut inside, mut outside]: [f64; 2], is_inside: impl Fn(f64) -> bool) -> f64 {
    assert!(is_inside(inside) && !is_inside(outside));
    while (outside / inside - 1.0).abs() > 1e-3 {
        let middle = 0.5 * (inside + outside);
        if is_inside(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    0.5 * (inside + outside)
}

/// Whether a bit sticks again and again, by waves handed on from piece to piece of a metre.
fn sticks_by_waves(string: &Drillstring, surface_speed: f64) -> bool {
    let timing = torsion_timing(string, surface_speed, &BIT, &sim::Start::Rest);
    let mut lattice = PlainLattice::new(string, 1.0);
    let compliance = lattice.compliance();
    let steps = (timing.duration / lattice.step) as usize;
    let closing = steps - (timing.closing_window / lattice.step) as usize;
    let (mut is_stuck, mut recaptured, mut last) = (true, 0, 0);
    for step in 0..steps {
        lattice.advance(surface_speed, |free| {
            let holds = -free / compliance;
            let slides = free - compliance * BIT.torque_dynamic > 0.0;
            if is_stuck && -holds > BIT.torque_static {
                is_stuck = false;
            } else if !is_stuck && !slides {
                (is_stuck, recaptured, last) = (true, recaptured + 1, step);
            }
            if is_stuck { holds } else { -BIT.torque_dynamic }
        });
    }
    recaptured >= 3 && last >= closing
}

/// Where a front that has been up and down the string arrives with a step, so that it is no
/// longer than one.
#[test]
fn val_sharp_fronts_leave_the_limit_of_stick_slip_where_waves_have_it() {
    for lengths in [&[(1000.0, 0.15)][..], &[(900.0, 0.125), (100.0, 0.15)]] {
        let string = string_of(lengths);
        let by_waves = limit([0.15, 0.35], |speed| sticks_by_waves(&string, rpm(speed)));
        for steps_to_bit in [50.0, 200.0] {
            let request = Request {
                sampling_frequency: steps_to_bit / torsional_travel_time(&string),
                ..academic::bit_request(200.0)
            };
            let responses = responses(&string, &Method::Held, &request).unwrap();
            let simulator = Simulator::new(&responses).unwrap();
            let found = limit([0.15, 0.35], |speed| {
                let scene = Scene {
                    start: sim::Start::Rest,
                    surface_speed: rpm(speed),
                    bit: Some(BIT),
                    friction: Vec::new(),
                    axial: None,
                    lateral: None,
                    timing: torsion_timing(&string, rpm(speed), &BIT, &sim::Start::Rest),
                };
                let outcome = simulator.simulate(&scene, Stopping::Full, None).unwrap();
                outcome.torsion().unwrap().regime == TorsionRegime::StickSlip
            });
            assert_close(found, by_waves, 0.015);
        }
    }
}

/// In mud, of a material with loss.
fn uniform_in_mud(length: f64, loss_factor: f64) -> Drillstring {
    let section = Section {
        repeat: 1,
        parts: vec![tube(length, 0.0635)],
    };
    let hole = Hole {
        sections: vec![HoleSection {
            length,
            radius: 0.11,
        }],
        mud: Mud {
            density: 1200.0,
            viscosity: 0.01,
        },
    };
    let material = academic::string().material();
    (Drillstring::new(material, vec![section], 0.0))
        .and_then(|string| string.in_hole(hole))
        .and_then(|string| string.with_loss_factor(loss_factor))
        .unwrap()
}

/// A short uniform string that loses little remembers echoes for dozens of round trips. In 512
/// steps per travel time, in which its undershoot is as it is, labels are not.
#[test]
fn val_the_default_frequency_has_the_labels_of_a_short_string_that_loses_little() {
    let string = uniform_in_mud(671.0, 0.001);
    let undershoot = exact_undershoot(&string).unwrap();
    let guess = stick_slip_speed_limit(undershoot, BIT.torque_static, BIT.torque_dynamic);
    let speeds: Vec<f64> = (0..40)
        .map(|it| guess * (0.4 + 0.09 * f64::from(it)))
        .collect();
    let torque = (1.0 + 1e-9) * BIT.torque_static;
    let start = |speed| Start::Steady(winding(&string, &Sites::bit(), speed, torque));
    let timing = |speed| torsion_timing(&string, speed, &BIT, &start(speed));
    let labels_at = |frequency: f64| -> Vec<bool> {
        let request = Request {
            sampling_frequency: frequency,
            ..academic::bit_request(timing(speeds[0]).duration)
        };
        let responses = responses(&string, &Method::Held, &request).unwrap();
        let simulator = Simulator::new(&responses).unwrap();
        let sticks = |speed: &f64| {
            let scene = Scene {
                start: start(*speed),
                surface_speed: *speed,
                bit: Some(BIT),
                friction: Vec::new(),
                axial: None,
                lateral: None,
                timing: timing(*speed),
            };
            let outcome = simulator.simulate(&scene, Stopping::Early, None).unwrap();
            outcome.torsion().unwrap().regime == TorsionRegime::StickSlip
        };
        speeds.iter().map(sticks).collect()
    };
    let travel = torsional_travel_time(&string);
    let exact = labels_at(8192.0 / travel);
    let wrong_at = |frequency: f64| {
        let labels = labels_at(frequency);
        labels
            .iter()
            .zip(&exact)
            .filter(|(one, other)| one != other)
            .count()
    };
    let by_rule = frequency_for_fronts(&string).unwrap();
    let [by_rule, of_undershoot] = [by_rule, 512.0 / travel].map(wrong_at);
    assert!(
        by_rule <= 1 && of_undershoot > 5,
        "{by_rule} {of_undershoot}"
    );
}

fn rpm(speed: f64) -> f64 {
    speed * std::f64::consts::PI / 30.0
}

const CLEARANCE: f64 = 0.015;
const SPEED: f64 = std::f64::consts::TAU;

fn wall(stiffness: f64, friction: f64) -> Wall {
    Wall {
        clearance: CLEARANCE,
        stiffness,
        friction,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.15,
    }
}

/// The academic string with one wall at the bit, pushed by 3 I₀, at a sampling frequency.
struct Pushed {
    simulator: Simulator,
    impulse: Impulse,
}

impl Pushed {
    fn new(method: Method, sampling_frequency: f64) -> Self {
        let string = academic::string();
        let request = Request {
            sampling_frequency,
            ..academic::lateral_request(&string, &[0.0], 10.0)
        };
        let responses = responses(&string, &method, &request).unwrap();
        let taps = &responses.bending().unwrap().from_loads[0][0];
        let sampling = Sampling::new(sampling_frequency, method.collocation_offset());
        let impulse = Impulse {
            site: 0,
            amount: 3.0 * least_impulse(taps, sampling, 0.02, CLEARANCE),
            start: 1.0,
            duration: 0.02,
            direction: 0.0,
        };
        Self {
            simulator: Simulator::new(&responses).unwrap(),
            impulse,
        }
    }

    fn run(&self, wall: Wall) -> LateralMeasures {
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: SPEED,
            bit: None,
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: vec![wall],
                impulses: vec![self.impulse],
                eccentric_masses: vec![],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: 10.0,
                closing_window: 2.0,
            },
        };
        let outcome = self.simulator.simulate(&scene, Stopping::Full, None);
        outcome.unwrap().lateral().unwrap()
    }

    /// The least friction with which whirl continues.
    fn limit(&self) -> f64 {
        limit([2.0, 1.0], |friction| {
            self.run(wall(1e9, friction)).regime == LateralRegime::BackwardWhirl
        })
    }
}

/// Met at the end of a step, the law of the wall would put it off by a fifth at 160 Hz.
#[test]
fn val_the_limit_of_whirl_is_found_in_few_steps() {
    let limit = |method, frequency| Pushed::new(method, frequency).limit();
    let [coarse, middle, fine] = [160.0, 320.0, 640.0].map(|f| limit(Method::Held, f));
    assert_close(coarse, fine, 3e-3);
    assert_close(middle, fine, 2e-3);
    // Quadrature, met at the ends of steps, comes there by much finer ones.
    assert_close(fine, limit(Method::Quadrature, 1280.0), 2e-3);
}

/// On a rigid wall too the site rolls in every step, with the force that the exact waves
/// ask for; how far off falls with the square of the step.
#[test]
fn val_rolling_along_a_rigid_wall_obeys_the_balance_of_forces() {
    let string = academic::string();
    let support = SurfaceSupport::Free;
    let network = BendingNetwork::new(&string, BENDING, support, &Sites::bit()).unwrap();
    let site = WhirlingSite {
        wall: wall(f64::INFINITY, 2.0),
        dynamic_stiffness: |rate| network.dynamic_stiffness(0, rate),
        decay: BendingDecay::new(&string, &BENDING),
    };
    let [steady] = site.rolling_at(SPEED)[..] else {
        panic!("one steady whirl");
    };
    let error = |sampling_frequency: f64| {
        let found = Pushed::new(Method::Held, sampling_frequency).run(site.wall);
        assert_eq!(found.rolling_fraction, 1.0, "{sampling_frequency}");
        found.mean_normal_force / steady.normal_force - 1.0
    };
    let (coarse, fine) = (error(320.0), error(640.0));
    assert!(
        fine.abs() < 3e-3 && (coarse / fine - 4.0).abs() < 1.0,
        "{coarse} {fine}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 50_000, max_global_rejects: 1_000_000, failure_persistence: None, ..Default::default() })]

    /// In any step the normal force does the work that the wall stores, none if it is
    /// rigid, and there is an answer.
    #[test]
    fn val_the_wall_stores_what_it_takes(
        [before, moved] in prop::array::uniform2((-0.011..0.011f64, -0.011..0.011f64)),
        exponents in (-9.5..-6.0f64, 6.0..11.0f64, -6.0..-3.0f64),
        (friction, free_speed, is_rigid) in (0.0..3.0f64, -50.0..50.0f64, any::<bool>()),
    ) {
        let stiffness = if is_rigid { f64::INFINITY } else { 10f64.powf(exponents.1) };
        prop_assume!(!is_rigid || before.0.hypot(before.1) <= CLEARANCE);
        let middle = (before.0 + moved.0, before.1 + moved.1);
        let wall = wall(stiffness, friction);
        let approach = Approach {
            free_position: middle.into(),
            previous_position: before.into(),
            previous_sliding_speed: None,
            last_force: [0.0; 2],
            present_position: None,
            compliance: 10f64.powf(exponents.0),
            spin: Spin {
                free_speed,
                compliance: 10f64.powf(exponents.2),
                resistance: None,
            },
            sampling: Sampling::new(640.0, 0.5),
        };
        let contact = wall.meet(&approach);
        prop_assert!(contact.is_ok(), "{contact:?}");
        let contact = contact.unwrap();
        // A step goes twice as far as its middle.
        let way = 2.0 * (middle.0 - before.0).hypot(middle.1 - before.1);
        prop_assert!(!contact.ambiguous || way > CLEARANCE, "{way}");
        prop_assume!(contact.touches() && !contact.ambiguous);
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let ([x, y], end) = (contact.position, approach.end_of_step(contact.position));
        let radius = length([x, y]);
        let outwards = ((end[0] - before.0) * x + (end[1] - before.1) * y) / radius;
        let work = contact.normal_force * outwards;
        let depth = |end: f64| (end - CLEARANCE).max(0.0);
        let [first, last] = [before.into(), end].map(|end| depth(length(end)));
        if is_rigid {
            // Where it came from within, the wall stops it.
            prop_assert!(last < 1e-9 * CLEARANCE && work >= -1e-9 * contact.normal_force * CLEARANCE);
        } else {
            let stored = 0.4 * stiffness * (last.powf(2.5) - first.powf(2.5));
            // The depth is found to 1e-11 of the clearance.
            let force = contact.normal_force;
            let steepness = 1.5 * stiffness.powf(2.0 / 3.0) * libm::cbrt(force);
            let rounding = 1e-9 * force + 1e-11 * steepness * CLEARANCE;
            prop_assert!((work - stored).abs() <= rounding * CLEARANCE, "{work} {stored}");
        }
    }
}
