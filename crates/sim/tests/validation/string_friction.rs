//! Friction all along the string: against the responses of the whole string, against closed
//! forms, and against a string of masses and springs stepped finely in time.

use linear::{Cascade, ChannelRequest, Drillstring, Method, Request, Sites, TopDrive};
use problems::academic;
use problems::masses::MassesAndSprings;
use problems::pipes;
use problems::wells::{Draw, with_loss};
use sim::{
    BitTorque, LoadLine, PipeFriction, Recording, Scene, Simulator, Start, Stopping,
    SurfaceProfile, SurfaceTorque, Timing, TorqueLaw, Trajectory,
};

fn timing(duration: f64) -> Timing {
    Timing {
        duration,
        closing_window: 0.5 * duration,
    }
}

fn friction(torque_static: f64, ratio: f64, stribeck_speed: f64) -> Option<PipeFriction> {
    Some(PipeFriction {
        torque_static,
        torque_dynamic: ratio * torque_static,
        stribeck_speed,
    })
}

/// From rest, with friction at the nodes and a bit that cuts or does not.
fn rubbing(
    surface_speed: f64,
    friction: Vec<Option<PipeFriction>>,
    bit: Option<BitTorque>,
    duration: f64,
) -> Scene {
    Scene {
        surface_speed,
        start: Start::Rest,
        bit,
        friction,
        axial: None,
        lateral: None,
        timing: timing(duration),
    }
}

fn recorded(simulator: &Simulator, scene: &Scene) -> (sim::Outcome, Trajectory) {
    let mut record = Trajectory::default();
    let outcome = simulator.simulate(scene, Stopping::Full, Some(&mut record));
    (outcome.unwrap(), record)
}

/// The middles of equal pieces, and the bit.
fn middles(string: &Drillstring, pieces: usize) -> Sites {
    let piece = string.length() / pieces as f64;
    let middle = |index: usize| (index as f64 + 0.5) * piece;
    let distances: Vec<f64> = (0..pieces).map(middle).chain([0.0]).collect();
    Sites::new(string, &distances).unwrap()
}

fn cascade(
    string: &Drillstring,
    method: Method,
    nodes: &Sites,
    frequency: f64,
    time: f64,
) -> Simulator {
    let cascade = Cascade::new(string, &method, nodes, frequency, time).unwrap();
    Simulator::in_pieces(&cascade, &SurfaceProfile::default(), 0.0).unwrap()
}

/// Two sections of joints and collars, a drive or none, and in mud.
fn strings() -> Vec<Drillstring> {
    let drive = TopDrive {
        inertia: 2900.0,
        proportional_gain: 3000.0,
        integral_gain: 2000.0,
        delay: 0.0,
        late_inertia: 0.0,
    };
    let jointed = academic::string();
    vec![
        jointed.clone().with_top_drive(drive).unwrap(),
        jointed.clone(),
        pipes::row(160, 0.0),
        academic::damped_string(1.0),
        with_loss(
            &jointed.clone().with_top_drive(drive).unwrap(),
            &mut Draw::new(1),
        ),
        with_loss(&jointed, &mut Draw::new(2)),
    ]
}

/// A torque at the bit alone: pieces stepped one by one are the whole string's response.
#[test]
fn val_pieces_one_by_one_are_the_whole_string() {
    let methods = [
        Method::Quadrature,
        Method::FiniteElement(Default::default()),
    ];
    for (string, method) in strings().iter().flat_map(|s| methods.map(|m| (s, m))) {
        for pieces in [1, 3, 17] {
            let (time, frequency) = (25.0, 64.0);
            let law = BitTorque {
                torque_static: 3000.0,
                torque_dynamic: 2400.0,
                decay_speed: 0.0,
            };
            let nodes = middles(string, pieces);
            let request = Request {
                sites: nodes.clone(),
                channels: vec![ChannelRequest::Torsion {
                    torques: vec![pieces],
                }],
                sampling_frequency: frequency,
                longest_time: time,
            };
            let responses = linear::responses(string, &method, &request).unwrap();
            let scene = Scene {
                start: sim::Start::Rest,
                surface_speed: 1.0,
                bit: Some(law),
                friction: Vec::new(),
                axial: None,
                lateral: None,
                timing: timing(time),
            };
            let mut expected = Trajectory::default();
            let simulator = Simulator::new(&responses).unwrap();
            let outcome = simulator
                .simulate(&scene, Stopping::Full, Some(&mut expected))
                .unwrap();
            let taps = linear::surface_torque(string, &method, &request).unwrap();
            let profile = SurfaceProfile::default();
            let torque = SurfaceTorque::new(&responses, &taps, &profile, 0.0).unwrap();
            let at_surface = torque.of(1.0, &sim::Start::Rest, &expected);
            let scene = rubbing(1.0, Vec::new(), Some(law), time);
            let simulator = cascade(string, method, &nodes, frequency, time);
            let (of_pieces, found) = recorded(&simulator, &scene);
            let largest = |one: &[f64], other: &[f64]| {
                assert_eq!(one.len(), other.len());
                std::iter::zip(one, other).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
            };
            for (one, other) in found.speeds.iter().zip(&expected.speeds) {
                let off = largest(one, other);
                assert!(off < 2e-7, "{pieces} {method:?}: {off:e}");
            }
            let off = largest(&found.surface_torque, &at_surface);
            assert!(off < 1e-3, "{pieces} {method:?}: {off:e} N m");
            let (one, other) = (of_pieces.torsion().unwrap(), outcome.torsion().unwrap());
            assert_eq!((one.regime, one.sticks), (other.regime, other.sticks));
        }
    }
}

/// Torques that do not fall: the torque at the surface tends to the sum of all, and of the damping.
#[test]
fn val_the_torque_that_keeps_it_turning_is_the_sum_of_all() {
    let string = pipes::row(200, 1.0);
    let pieces = 20;
    let nodes = middles(&string, pieces);
    let mut torques = vec![friction(400.0, 1.0, 0.0); pieces];
    torques.push(None);
    let scene = rubbing(0.3, torques, None, 120.0);
    let simulator = cascade(&string, Method::Quadrature, &nodes, 32.0, 120.0);
    let measures = recorded(&simulator, &scene).0.surface.unwrap();
    let against = 400.0 * pieces as f64 + 1.0 * 0.3 * string.length();
    for torque in [
        measures.least_torque,
        measures.mean_torque,
        measures.greatest_torque,
    ] {
        assert!((torque / against - 1.0).abs() < 1e-4, "{measures:?}");
    }
}

/// No friction, no change; and a string that is held by friction stands still.
#[test]
fn val_what_does_not_act_changes_nothing() {
    let string = academic::string();
    let nodes = middles(&string, 5);
    let simulator = cascade(&string, Method::Quadrature, &nodes, 64.0, 10.0);
    let run = |of_pieces: Option<PipeFriction>| {
        let scene = rubbing(1.0, vec![of_pieces; 6], None, 10.0);
        recorded(&simulator, &scene).1
    };
    let (free, weightless) = (run(None), run(friction(0.0, 1.0, 0.0)));
    for (one, other) in free.speeds.iter().zip(&weightless.speeds) {
        for (one, other) in one.iter().zip(other) {
            assert!((one - other).abs() < 1e-12);
        }
    }
    let held = run(friction(1e9, 1.0, 0.0));
    assert!(held.speeds.iter().flatten().all(|speed| *speed == 0.0));
}

/// The greatest torque at the surface, and the least after it.
fn peak_and_trough(torques: &[f64]) -> (f64, f64) {
    let peak = torques.iter().copied().fold(f64::MIN, f64::max);
    let at = torques.iter().position(|torque| *torque == peak).unwrap();
    let trough = torques[at..].iter().copied().fold(peak, f64::min);
    (peak, trough)
}

/// U. J. F. Aarsnes and R. J. Shor, "Torsional vibrations with bit off bottom: modeling,
/// identification and field data validation", *Journal of Petroleum Science and Engineering*,
/// 2018, Eqs. 38 and 39: a string that is wound up slowly slides when the torque has reached ∫F dx;
/// where it is then turned faster and friction falls everywhere, the torque swings by twice that.
#[test]
fn val_a_string_breaks_loose_and_swings_by_twice_what_friction_falls() {
    // Damped as much as keeps a friction that falls a little from making it swing.
    let (string, pieces, total) = (pipes::row(200, 0.1), 40, 9000.0);
    let nodes = middles(&string, pieces);
    let (slow, wound_up, time) = (0.002, 450.0, 480.0);
    let surface = Recording::new(vec![0.0, wound_up, wound_up + 5.0], vec![slow, slow, 0.2]);
    let cascade = Cascade::new(&string, &Method::Quadrature, &nodes, 16.0, time).unwrap();
    let profile = SurfaceProfile::Recorded(surface.unwrap());
    let simulator = Simulator::in_pieces(&cascade, &profile, 0.0).unwrap();
    for ratio in [0.5, 0.8] {
        let torques = vec![friction(total / pieces as f64, ratio, 0.3); pieces];
        let torques = torques.into_iter().chain([None]).collect();
        let (_, record) = recorded(&simulator, &rubbing(1.0, torques, None, time));
        let before = (wound_up * 16.0) as usize;
        let sliding = record.surface_torque[before];
        assert!((sliding / total - 1.0).abs() < 1e-3, "{sliding}");
        let (peak, trough) = peak_and_trough(&record.surface_torque);
        let swing = (peak - trough) / (2.0 * (1.0 - ratio) * total);
        assert!((swing - 1.0).abs() < 0.2, "{ratio}: {swing}");
    }
}

/// A uniform row as masses and springs in small steps, each mass under its part of the friction:
/// the torque at the surface at the times of a sampling frequency, and the greatest in each spring.
fn masses_and_springs(
    law: PipeFriction,
    length: f64,
    damping: f64,
    surface: impl Fn(f64) -> f64,
    (frequency, time): (f64, f64),
) -> (Vec<f64>, Vec<f64>) {
    let (masses, substeps) = (250, 25);
    let step = 1.0 / (frequency * substeps as f64);
    let mut row = MassesAndSprings::new(length, masses, step);
    let inertia = row.inertia;
    let compliance = step / (inertia + step * damping * row.piece);
    let mut states = vec![Default::default(); masses];
    let (mut torques, mut angle) = (Vec::new(), 0.0);
    let mut greatest = vec![0.0; masses];
    let steps = (frequency * time) as usize + 1;
    for index in 0..steps * substeps {
        angle += step * surface(step * index as f64);
        let inside = row.torques(angle);
        if index % substeps == 0 {
            torques.push(inside[0]);
        }
        for (greatest, torque) in greatest.iter_mut().zip(&inside) {
            *greatest = torque.abs().max(*greatest);
        }
        row.step(&inside, |mass, speed, torque| {
            let line = LoadLine {
                time: 0.0,
                free_speed: compliance * (inertia / step * speed + torque),
                compliance,
            };
            let met = law.meet(&states[mass], line);
            states[mass] = met.state;
            met.speed
        });
    }
    (torques, greatest)
}

/// R.m.s. error of the torque at the surface, of a number of pieces at a sampling frequency,
/// against masses and springs: a start in 3 s under friction that falls to half above a speed.
fn errors_of_start(total: f64, stribeck_speed: f64) -> Vec<f64> {
    let (length, damping, time) = (2000.0, 0.1, 15.0);
    let string = pipes::row(200, damping);
    let (speed, rise) = (6.0, 3.0);
    let friction_of = |pieces: usize| PipeFriction {
        torque_static: total / pieces as f64,
        torque_dynamic: 0.5 * total / pieces as f64,
        stribeck_speed,
    };
    let surface = |time: f64| speed * (time / rise).min(1.0);
    let start = (32.0, time);
    let (exact, _) = masses_and_springs(friction_of(250), length, damping, surface, start);
    let error = |method: Method, pieces: usize, frequency: f64| {
        let nodes = middles(&string, pieces);
        let cascade = Cascade::new(&string, &method, &nodes, frequency, time).unwrap();
        let profile = SurfaceProfile::Rise(rise);
        let simulator = Simulator::in_pieces(&cascade, &profile, 0.0).unwrap();
        let torques = vec![Some(friction_of(pieces)); pieces];
        let torques = torques.into_iter().chain([None]).collect();
        let (_, record) = recorded(&simulator, &rubbing(speed, torques, None, time));
        let every = (frequency / 32.0) as usize;
        let found = record.surface_torque.iter().step_by(every);
        let square = |(one, other): (&f64, &f64)| (one - other).powi(2);
        let sum: f64 = found.zip(&exact).map(square).sum();
        (sum / exact.len() as f64).sqrt()
    };
    vec![
        error(Method::Quadrature, 10, 32.0),
        error(Method::Quadrature, 20, 64.0),
        error(Method::Quadrature, 40, 128.0),
        error(Method::FiniteElement(Default::default()), 40, 128.0),
    ]
}

/// A start that breaks loose and swings, against another method and code; more pieces and shorter
/// steps come nearer to it, the slower the more friction falls while it moves.
#[test]
fn val_a_start_is_that_of_masses_and_springs_in_small_steps() {
    let total = 16_000.0;
    for (stribeck_speed, most) in [(0.0, 0.01), (0.5, 0.04)] {
        let errors = errors_of_start(total, stribeck_speed);
        assert!(
            errors[2] < most * total && errors[3] < most * total,
            "{errors:?}"
        );
        assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    }
}

/// The middle one of some numbers.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// A string of even friction F in all, L long, of G, J, ρ, c = √(G/ρ) and Z = ρ J c, whose friction
/// falls to r F as soon as it turns, below a surface that turns slowly at ω.
///
/// *Slip.* It breaks loose when the torque in it is F (1 − s/L) from the surface (s = 0) down.
/// With r F (1 − s/L) it would slide on; what is more, (1 − r) F (1 − s/L), sets it in motion.
/// With u how far a place then is ahead of sliding on, u″ = (1 − r) F/(GJ L) = a at first. Odd
/// about the surface and even about the bit, u″ continues as a square wave g of period 4L, and of
/// that both ways comes ∂²u/∂t² = c² [g(s − ct) + g(s + ct)]/2: a place speeds up at c² a until
/// t = s/c, keeps the speed c a s until t = (2L − s)/c, and slows down as it sped up. **All of
/// the string stops at t = 2L/c**, half of a free period of 4L/c, the bit having reached
/// c a L = (1 − r) F/Z. Nothing sets it going again, for the torque left, (2r − 1) F (1 − s/L), is
/// within what friction holds.
///
/// *Winding up.* While the surface turns on, static friction f = F/L gives way down to a depth d:
/// T = (2r − 1) F (1 − d/L) + F d/L at the surface, dφ = d/(GJ) dT, and until d = L
///
/// Δφ = ∫ (d/GJ) 2 (1 − r) (F/L) dd = (1 − r) F L/(GJ),
///
/// which is what the bit turned by in the slip, 2 (1 − r) F L/(2 GJ). The period is Δφ/ω + 2L/c
/// (Aarsnes and Shor 2018, Eq. 40, call the second part the free period).
///
/// That is so where friction falls at once and everywhere. With Stribeck's curve it takes
/// ω ≪ ω_s ≪ (1 − r) F/Z; where ω_s is below a tenth of the latter, parts of the string break
/// loose by themselves before it is wound up, and where it is not far below, it slips less.
#[test]
fn val_a_string_that_sticks_and_slips_has_the_period_of_winding_up_and_of_a_round_trip() {
    let (pieces, total) = (40, 60e3);
    // Each with Δφ/ω in round trips, and ω_s in parts of the greatest speed of the bit.
    for (length, ratio, trips, part) in [
        (60, 0.5, 20.0, 0.15),
        (60, 0.8, 40.0, 0.12),
        (200, 0.5, 40.0, 0.12),
        (200, 0.8, 20.0, 0.15),
    ] {
        let string = pipes::row(length, 0.01);
        let tube = string.sections()[0].parts[0];
        let rigidity = pipes::STEEL.shear_modulus * tube.polar_moment();
        let (length, wave_speed) = (string.length(), string.torsional_wave_speed());
        let round_trip = 2.0 * length / wave_speed;
        let angle = (1.0 - ratio) * total * length / rigidity;
        let surface_speed = angle / (trips * round_trip);
        let greatest = (1.0 - ratio) * total * wave_speed / rigidity;
        let (expected, stribeck_speed) = (angle / surface_speed + round_trip, part * greatest);
        let (time, frequency) = (8.0 * expected, 200.0 / round_trip);
        let mut torques = vec![friction(total / pieces as f64, ratio, stribeck_speed); pieces];
        torques.push(None);
        let scene = rubbing(surface_speed, torques, None, time);
        let nodes = middles(&string, pieces);
        let simulator = cascade(&string, Method::Quadrature, &nodes, frequency, time);
        let (_, record) = recorded(&simulator, &scene);
        // When the lowest piece becomes faster than ω_s, and when it stops after that.
        let (mut slips, mut stops) = (Vec::new(), Vec::new());
        for (step, &speed) in record.speeds[pieces - 1].iter().enumerate() {
            let now = step as f64 / frequency;
            if slips.len() == stops.len() && speed > stribeck_speed {
                slips.push(now);
            } else if slips.len() > stops.len() && speed == 0.0 {
                stops.push(now);
            }
        }
        let periods = slips.windows(2).map(|slips| slips[1] - slips[0]).collect();
        // The bit speeds up evenly: half of that part of the slip it is slower.
        let as_fast = (1.0 - 0.5 * part) * round_trip;
        let moving = std::iter::zip(&slips, &stops).map(|(slip, stop)| stop - slip);
        let (period, moving) = (
            median(periods) / expected,
            median(moving.collect()) / as_fast,
        );
        assert!((period - 1.0).abs() < 0.05, "{length} {ratio}: {period}");
        assert!((moving - 1.0).abs() < 0.06, "{length} {ratio}: {moving}");
    }
}

/// The torques of a scene from rest: what the string's greatest is, where, and its record.
fn greatest_torque(
    string: &Drillstring,
    (torques, bit): (Vec<Option<PipeFriction>>, Option<BitTorque>),
    (surface_speed, rise): (f64, f64),
    (frequency, time): (f64, f64),
) -> (sim::StringTorque, Trajectory) {
    let nodes = middles(string, torques.len() - 1);
    let cascade = Cascade::new(string, &Method::Quadrature, &nodes, frequency, time).unwrap();
    let profile = SurfaceProfile::Rise(rise);
    let simulator = Simulator::in_pieces(&cascade, &profile, 0.0).unwrap();
    let scene = rubbing(surface_speed, torques, bit, time);
    let (outcome, record) = recorded(&simulator.following_torque(true), &scene);
    (outcome.string_torque.unwrap(), record)
}

/// Wound up slowly it is twisted most at the surface, by what turns that; and where only a bit
/// holds it, as much everywhere.
#[test]
fn val_a_string_that_is_turned_slowly_is_twisted_most_at_the_surface() {
    let string = pipes::row(200, 0.0);
    let pieces = 20;
    let slow = (0.005, 20.0);
    let mut torques = vec![friction(450.0, 1.0, 0.0); pieces];
    torques.push(None);
    let (greatest, record) = greatest_torque(&string, (torques, None), slow, (16.0, 300.0));
    let at_surface = record.surface_torque.iter().copied().fold(0.0, f64::max);
    assert!((at_surface / 9000.0 - 1.0).abs() < 0.01, "{at_surface}");
    let off = greatest.peak_torque / at_surface - 1.0;
    assert!(off.abs() < 1e-3, "{greatest:?} {at_surface}");
    // The uppermost node.
    assert!((greatest.from_bit - 1950.0).abs() < 1e-6, "{greatest:?}");
    let bit = BitTorque {
        torque_static: 9000.0,
        torque_dynamic: 9000.0,
        decay_speed: 0.0,
    };
    let mut torques = vec![friction(1.0, 1.0, 0.0); pieces];
    torques.push(None);
    let (greatest, record) = greatest_torque(&string, (torques, Some(bit)), slow, (16.0, 600.0));
    let at_surface = record.surface_torque.iter().copied().fold(0.0, f64::max);
    assert!((at_surface / 9020.0 - 1.0).abs() < 0.01, "{at_surface}");
    let off = greatest.peak_torque / at_surface - 1.0;
    assert!(off.abs() < 2e-3, "{greatest:?} {at_surface}");
}

/// A fast start under little friction, and a slower one under much: the greatest torque is that of
/// masses and springs, and where it is they have it too.
#[test]
fn val_the_greatest_torque_of_a_start_is_that_of_masses_and_springs() {
    let (length, damping, time) = (2000.0, 0.1, 8.0);
    let string = pipes::row(200, damping);
    for (total, speed, rise) in [(3000.0, 8.0, 0.5), (16_000.0, 6.0, 3.0)] {
        let friction_of = |pieces: usize| PipeFriction {
            torque_static: total / pieces as f64,
            torque_dynamic: 0.8 * total / pieces as f64,
            stribeck_speed: 0.5,
        };
        let surface = |time: f64| speed * (time / rise).min(1.0);
        let start = (32.0, time);
        let (_, springs) = masses_and_springs(friction_of(250), length, damping, surface, start);
        let most = springs.iter().copied().fold(0.0, f64::max);
        let pieces = 80;
        let mut torques = vec![Some(friction_of(pieces)); pieces];
        torques.push(None);
        let all = (torques, None);
        let (found, _) = greatest_torque(&string, all, (speed, rise), (256.0, time));
        let off = found.peak_torque / most - 1.0;
        assert!(off.abs() < 0.02, "{found:?} {most}");
        let place = (length - found.from_bit) / length * springs.len() as f64;
        let there = springs[(place as usize).min(springs.len() - 1)];
        assert!(there > 0.97 * most, "{found:?} {there} {most}");
    }
}

/// Turning steadily, the torque above a node is the sum of all below.
#[test]
fn val_the_torque_in_a_string_that_turns_is_the_sum_of_all_below() {
    let string = pipes::row(200, 0.0);
    let (pieces, bit) = (8, 5000.0);
    let of = |index: usize| 100.0 * (index + 1) as f64;
    let mut torques: Vec<_> = (0..pieces).map(|it| friction(of(it), 1.0, 0.0)).collect();
    torques.push(None);
    let cuts = BitTorque {
        torque_static: bit,
        torque_dynamic: bit,
        decay_speed: 0.0,
    };
    let all = (torques, Some(cuts));
    let (greatest, _) = greatest_torque(&string, all, (0.01, 100.0), (16.0, 400.0));
    let sum = bit + (0..pieces).map(of).sum::<f64>();
    let off = greatest.peak_torque / sum - 1.0;
    assert!(off.abs() < 0.01, "{greatest:?} {sum}");
}
