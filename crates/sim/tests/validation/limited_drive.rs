//! Validation of a drive that gives no more than its greatest torque: against rigid rotors in closed
//! form, the linear drive, masses and springs in small steps, energy, and its own law on strings
//! drawn at random.

use crate::bits::bit;
use linear::estimates::{torsional_inertia, torsional_stiffness};
use linear::{
    Budget, ChannelRequest, Drillstring, DrivenSurface, DrivenSurfacePlan, IntegralRule, Method,
    Request, Responses, Sites, TopDrive, controllers,
};
use problems::academic;
use problems::masses::MassesAndSprings;
use problems::methods;
use problems::pipes;
use problems::wells::{Draw, Well, with_loss};
use proptest::prelude::*;
use sim::{
    BitTorque, Impulse, Lateral, LimitedDrive, Scene, Simulator, Start, Stepper, Stopping,
    SurfaceProfile, SurfaceStep, SurfaceTorque, System, Timing, TorsionRegime, Trajectory, Wall,
};

fn scene(surface_speed: f64, start: Start, bit: Option<BitTorque>, duration: f64) -> Scene {
    Scene {
        surface_speed,
        start,
        bit,
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration,
            closing_window: 0.3 * duration,
        },
    }
}

/// The linear part of a string below its drive, and of the surface.
struct Parts {
    responses: Responses,
    surface: DrivenSurface,
    request: Request,
    method: Method,
}

impl Parts {
    fn new(string: &Drillstring, method: Method, (frequency, time): (f64, f64)) -> Self {
        let request = Request {
            sites: Sites::bit(),
            channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
            sampling_frequency: frequency,
            longest_time: time,
        };
        let plan = DrivenSurfacePlan::new(string, &method, &request).unwrap();
        Self {
            responses: linear::responses(string, &method, &request).unwrap(),
            surface: plan.build(&Budget::unlimited()).unwrap(),
            request,
            method,
        }
    }

    fn limited(&self, limit: f64, profile: &SurfaceProfile) -> System {
        let drive = LimitedDrive::new(&self.surface, &[0], limit, profile).unwrap();
        let system = System::started(&self.responses, profile).unwrap();
        system.below_limited(drive).unwrap()
    }

    fn motion(&self, limit: f64, scene: &Scene) -> Trajectory {
        let simulator = Simulator::of(self.limited(limit, &SurfaceProfile::default()));
        let mut motion = Trajectory::default();
        let simulated = simulator.simulate(scene, Stopping::Full, Some(&mut motion));
        simulated.unwrap();
        motion
    }
}

/// All speeds of the bit, and what turns the surface.
fn stepped(system: &System, scene: &Scene) -> (Vec<f64>, Vec<SurfaceStep>) {
    let mut stepper = Stepper::new(system, scene).unwrap();
    let (mut speeds, mut surface) = (Vec::new(), Vec::new());
    while let Some(step) = stepper.step().unwrap() {
        speeds.push(step.speeds[0]);
        surface.extend(step.surface);
    }
    (speeds, surface)
}

const ROTOR: TopDrive = TopDrive {
    inertia: 2000.0,
    proportional_gain: 3000.0,
    integral_gain: 600.0,
    delay: 0.0,
    late_inertia: 0.0,
};

/// With all of T_most a rotor is brought up to speed evenly, its integral standing still; from the
/// moment at which K_p e is less, J e″ + K_p e′ + K_i e = 0.
#[test]
fn val_a_rigid_rotor_is_brought_up_as_in_closed_form() {
    // It is ahead by what it gains until it has wound up the string, for some hundredths of a second;
    // with nothing on its bit, by half a step at most.
    is_brought_up(Some(bit(2e3, 2e3)), 2e3, -0.02..0.0);
    is_brought_up(None, 0.0, -3e-3..3e-3);
}

/// How late it is in time against a law with one torque (N m), s.
fn is_brought_up(law: Option<BitTorque>, against: f64, expected_late: std::ops::Range<f64>) {
    let (limit, speed) = (10e3, 8.0);
    // So short that it turns as one.
    let string = pipes::row(1, 0.0).with_top_drive(ROTOR).unwrap();
    let inertia = ROTOR.inertia + torsional_inertia(&string);
    let acceleration = (limit - against) / inertia;
    let error = limit / ROTOR.proportional_gain;
    let limited_until = (speed - error) / acceleration;
    let decay = 0.5 * ROTOR.proportional_gain / inertia;
    let root = (decay * decay - ROTOR.integral_gain / inertia).sqrt();
    let [slow, fast] = [root - decay, -root - decay];
    let slowly = (-acceleration - fast * error) / (slow - fast);
    let speed_at = |time: f64| match time - limited_until {
        left if left < 0.0 => acceleration * time,
        gone => speed - slowly * (slow * gone).exp() - (error - slowly) * (fast * gone).exp(),
    };
    let scene = scene(speed, Start::Rest, law, 9.0);
    for method in methods::in_time() {
        let motion = Parts::new(&string, method, (200.0, 9.0)).motion(limit, &scene);
        let first = motion.times.iter().position(|time| *time > 0.2).unwrap();
        let late = motion.times[first] - motion.surface_speed[first] / acceleration;
        let is_expected = expected_late.contains(&late);
        assert!(is_expected, "{}: {late}", method.name());
        for (step, time) in motion.times.iter().enumerate().skip(first) {
            let (found, expected) = (motion.surface_speed[step], speed_at(time - late));
            assert!(
                (found - expected).abs() < 1e-3 * speed,
                "{} {time}: {found} {expected}",
                method.name()
            );
            if (time - limited_until).abs() > 0.1 {
                let is_limited = motion.surface_torque[step] == limit;
                assert_eq!(is_limited, *time < limited_until, "{time}");
            }
        }
    }
}

/// A limit that is never met changes no byte of the motion, and the torque is then that of the linear
/// drive by reciprocity.
#[test]
fn val_a_limit_that_is_never_met_changes_nothing() {
    let plain = pipes::row(100, 0.5).with_loss_factor(0.01).unwrap();
    let string = plain
        .clone()
        .with_top_drive(controllers::soft_torque(&plain, 2000.0))
        .unwrap();
    let (speed, law) = (3.0, bit(9e3, 7e3));
    let starts = [
        Start::Rest,
        Start::Steady(linear::steady::winding(&string, &Sites::bit(), speed, 9e3)),
        Start::Steady(linear::steady::rotation(
            &string,
            &Sites::bit(),
            speed,
            6.9e3,
        )),
    ];
    for (method, allowed) in methods::in_time().into_iter().zip([1e-3, 1e-9, 1e-9]) {
        let parts = Parts::new(&string, method, (256.0, 15.0));
        let profile = SurfaceProfile::default();
        let linear = System::started(&parts.responses, &profile).unwrap();
        let taps = linear::surface_torque(&string, &parts.method, &parts.request).unwrap();
        let by_reciprocity = SurfaceTorque::new(&parts.responses, &taps, &profile, 0.0).unwrap();
        for start in &starts {
            let scene = scene(speed, start.clone(), Some(law), 15.0);
            let (expected, none) = stepped(&linear, &scene);
            let (found, surface) = stepped(&parts.limited(1e6, &profile), &scene);
            assert!(none.is_empty());
            assert_eq!(found, expected);
            let torques = by_reciprocity.of(speed, start, &parts.motion(1e6, &scene));
            let off = surface.iter().zip(&torques);
            let off = off.map(|(one, other)| (one.torque - other).abs());
            let off = off.fold(0.0, f64::max) / 1e4;
            assert!(off < allowed, "{} {start:?}: {off:e}", method.name());
        }
    }
}

const LENGTH: f64 = 1000.0;
const DAMPING: f64 = 4.0;

/// The same row of pipes, its drive and its rock in small steps: speeds of surface and bit and the
/// drive's torque at the times of a sampling frequency.
fn masses_and_springs(
    drive: TopDrive,
    limit: f64,
    (speed, law): (f64, BitTorque),
    (frequency, time, offset): (f64, f64, f64),
) -> Vec<[f64; 3]> {
    let (masses, substeps) = (400, (16_384.0 / frequency) as usize);
    let step = 1.0 / (frequency * substeps as f64);
    let mut row = MassesAndSprings::new(LENGTH, masses, step);
    let (inertia, drag) = (row.inertia, DAMPING * row.piece);
    let (mut angle, mut own, mut integral, mut of_bit) = (0.0, 0.0, 0.0, 0.0);
    let mut rows = Vec::new();
    let sampled = (offset * substeps as f64) as usize;
    for index in 0..(frequency * time) as usize * substeps {
        let inside = row.torques(angle);
        let error = speed - own;
        let asked: f64 = drive.proportional_gain * error + integral;
        let torque = asked.clamp(-limit, limit);
        if asked == torque || asked * error < 0.0 {
            integral += drive.integral_gain * error * step;
        }
        if index % substeps == sampled {
            rows.push([own, of_bit, torque]);
        }
        own += step * (torque - inside[0]) / drive.inertia;
        angle += step * own;
        row.step(&inside, |mass, speed, torque| {
            let free = speed + step * (torque - drag * speed) / inertia;
            if mass < masses - 1 {
                return free;
            }
            let most = match speed == 0.0 {
                true => law.torque_static,
                false => law.torque_dynamic,
            };
            let braked = match free.abs() <= step * most / inertia {
                true => 0.0,
                false => free - step * law.torque_dynamic.copysign(free) / inertia,
            };
            of_bit = braked;
            braked
        });
    }
    rows
}

/// Stick-slip in which the limit is met in every cycle: three methods, and masses and springs. Fronts
/// are sharp at the bit, and a step sooner or later there.
#[test]
fn val_stick_slip_below_a_limited_drive_is_that_of_masses_and_springs() {
    let drive = TopDrive {
        inertia: 2000.0,
        proportional_gain: 20e3,
        integral_gain: 3000.0,
        delay: 0.0,
        late_inertia: 0.0,
    };
    let (limit, speed, law) = (12.3e3, 0.6, bit(12e3, 6e3));
    let (frequency, time) = (256.0, 24.0);
    let string = pipes::row(100, DAMPING).with_top_drive(drive).unwrap();
    let scene = scene(speed, Start::Rest, Some(law), time);
    for (method, allowed) in methods::in_time().into_iter().zip([0.03, 0.07, 0.05]) {
        let offset = method.collocation_offset();
        let expected = masses_and_springs(drive, limit, (speed, law), (frequency, time, offset));
        let motion = Parts::new(&string, method, (frequency, time)).motion(limit, &scene);
        let off = |found: &[f64], at: usize| {
            let pairs = found.iter().zip(&expected);
            let squares: f64 = pairs.map(|(one, row)| (one - row[at]).powi(2)).sum();
            let size: f64 = expected.iter().map(|row| row[at] * row[at]).sum();
            (squares / size).sqrt()
        };
        for (found, at) in [(&motion.surface_speed, 0), (&motion.surface_torque, 2)] {
            let off = off(found, at);
            assert!(off < allowed, "{} {at}: {off}", method.name());
        }
        let slips = |speeds: &mut dyn Iterator<Item = f64>| {
            let speeds: Vec<f64> = speeds.collect();
            let pairs = speeds.windows(2);
            pairs.filter(|pair| pair[0] == 0.0 && pair[1] > 0.0).count()
        };
        let of_bit = slips(&mut motion.speeds[0].iter().copied());
        assert_eq!(of_bit, slips(&mut expected.iter().map(|row| row[1])));
        assert!(of_bit > 10, "{of_bit}");
        let limited = motion.surface_torque.iter();
        let limited = limited.filter(|torque| **torque == limit).count();
        assert!(limited > 1000, "{limited}");
    }
}

/// What the drive has done is in the motion and in the twist of a string that loses nothing, or went
/// into the rock.
#[test]
fn val_the_work_of_a_limited_drive_is_all_accounted_for() {
    let plain = pipes::row(100, 0.0);
    let string = plain
        .clone()
        .with_top_drive(controllers::soft_torque(&plain, 2000.0))
        .unwrap();
    let (speed, against, frequency, time) = (8.0, 5e3, 256.0, 60.0);
    let scene = scene(speed, Start::Rest, Some(bit(against, against)), time);
    for limit in [6e3, 9e3] {
        for method in methods::in_time() {
            let motion = Parts::new(&string, method, (frequency, time)).motion(limit, &scene);
            let work = |torques: &[f64], speeds: &[f64]| {
                let power = torques.iter().zip(speeds).map(|(one, other)| one * other);
                power.sum::<f64>() / frequency
            };
            let done = work(&motion.surface_torque, &motion.surface_speed);
            let rubbed = -work(&motion.bit_torque, &motion.speeds[0]);
            let inertia = torsional_inertia(&string) + string.top_drive().unwrap().inertia;
            let twisted = against * against / (2.0 * torsional_stiffness(&string));
            let stored = 0.5 * inertia * speed * speed + twisted;
            let off = (done - rubbed - stored) / stored;
            assert!(off.abs() < 5e-3, "{} {limit}: {off}", method.name());
            let limited = motion.surface_torque.iter();
            assert!(limited.filter(|torque| **torque == limit).count() > 256);
        }
    }
}

/// Where all of the torque is not enough for the set speed, the string turns as fast as that lets it;
/// where it does not turn the bit, drive and bit stop.
#[test]
fn val_a_drive_without_the_torque_for_its_speed_is_slow_or_stalls() {
    let (plain, speed, against) = (pipes::row(100, DAMPING), 2.0, 5e3);
    let string = plain
        .clone()
        .with_top_drive(controllers::stiff(&plain, 2000.0))
        .unwrap();
    let drags = DAMPING * LENGTH;
    let rotation = linear::steady::rotation(&string, &Sites::bit(), speed, against);
    let starts = [Start::Rest, Start::Steady(rotation)];
    for (limit, slowed, regime) in [
        (9e3, (9e3 - against) / drags, TorsionRegime::Smooth),
        (4.9e3, 0.0, TorsionRegime::Stuck),
    ] {
        for method in methods::in_time() {
            let parts = Parts::new(&string, method, (128.0, 60.0));
            let simulator = Simulator::of(parts.limited(limit, &SurfaceProfile::default()));
            for start in &starts {
                let scene = scene(speed, start.clone(), Some(bit(against, against)), 60.0);
                let mut motion = Trajectory::default();
                let outcome = simulator.simulate(&scene, Stopping::Early, Some(&mut motion));
                let outcome = outcome.unwrap();
                let torsion = outcome.torsion().unwrap();
                assert_eq!(torsion.regime, regime, "{} {start:?}", method.name());
                let last = motion.surface_speed.last().unwrap();
                for found in [torsion.closing_speed, *last] {
                    assert!((found - slowed).abs() < 2e-3 * speed, "{found} {slowed}");
                }
                assert_eq!(outcome.surface.unwrap().mean_torque, limit);
            }
        }
    }
}

/// A string drawn at random below a drive drawn at random, and a scene.
fn drawn(number: usize) -> (Drillstring, SurfaceProfile, f64, Scene) {
    let mut draw = Draw::new(number);
    let mut string = Well::draw(number, &mut draw).string;
    if number % 2 == 1 {
        string = with_loss(&string, &mut draw);
    }
    let drive = TopDrive {
        inertia: match number % 7 {
            0 => 0.0,
            _ => draw.log_uniform(300.0, 5000.0),
        },
        proportional_gain: draw.log_uniform(300.0, 3e4),
        integral_gain: match number % 3 {
            0 => 0.0,
            _ => draw.log_uniform(100.0, 1e4),
        },
        delay: 0.0,
        late_inertia: 0.0,
    };
    let string = string.with_top_drive(drive).unwrap();
    let (speed, torque) = (draw.uniform(-15.0, 15.0), draw.log_uniform(500.0, 2e4));
    let law = bit(torque * draw.uniform(1.0, 2.0), torque);
    let limit = torque * draw.log_uniform(0.3, 5.0);
    let (start, profile) = match number % 4 {
        0 => (Start::Rest, SurfaceProfile::Rise(draw.uniform(0.1, 5.0))),
        1 => (Start::Rest, SurfaceProfile::default()),
        2 => {
            let winding = linear::steady::winding(&string, &Sites::bit(), speed, 0.9 * torque);
            (Start::Steady(winding), SurfaceProfile::default())
        }
        _ => {
            let rotation = linear::steady::rotation(&string, &Sites::bit(), speed, torque);
            (Start::Steady(rotation), SurfaceProfile::default())
        }
    };
    let scene = scene(speed, start, Some(law), 12.0);
    (string, profile, limit, scene)
}

/// The law of a drive whose torque is limited, step by step.
struct DriveLaw {
    drive: TopDrive,
    rule: IntegralRule,
    limit: f64,
    /// From the last one back.
    errors: [f64; 2],
    integrals: [f64; 2],
    /// What its own integral makes of the torque, and that of the linear drive, N m.
    own: f64,
    of_linear: f64,
}

/// What the controller asked for in a step and the linear drive would give, and of what size all that
/// is, N m.
struct Obeyed {
    linear: f64,
    asked: f64,
    size: f64,
}

impl DriveLaw {
    /// That begins with a torque, N m.
    fn new(surface: &DrivenSurface, limit: f64, torque: f64) -> Self {
        Self {
            drive: surface.drive,
            rule: surface.integral,
            limit,
            errors: [0.0; 2],
            integrals: [0.0; 2],
            own: torque,
            of_linear: torque,
        }
    }

    /// In a step with this error of the speed (rad/s), a torque of the integral that has none, and the
    /// torque that was given, N m.
    fn follow(&mut self, error: f64, base: f64, given: f64) -> Obeyed {
        let Self { drive, rule, .. } = *self;
        let integral = rule.of_values[0] * error
            + rule.of_values[1] * self.errors[0]
            + rule.of_values[2] * self.errors[1]
            + rule.of_integrals[0] * self.integrals[0]
            + rule.of_integrals[1] * self.integrals[1];
        self.errors = [error, self.errors[0]];
        self.integrals = [integral, self.integrals[0]];
        let by_integral = base + drive.integral_gain * integral;
        let change = by_integral - self.of_linear;
        self.of_linear = by_integral;
        let asked = drive.proportional_gain * error + self.own + change;
        let is_limited = given.abs() == self.limit;
        if !(is_limited && change * given > 0.0) {
            self.own += change;
        }
        Obeyed {
            linear: drive.proportional_gain * error + by_integral,
            asked,
            size: self.limit + asked.abs() + by_integral.abs(),
        }
    }
}

/// Σ A(k − n) E(n).
fn summed(taps: &[f64], inputs: &[f64]) -> f64 {
    let past = inputs.iter().rev().zip(taps);
    past.map(|(input, tap)| input * tap).sum()
}

/// A string with two walls, a bit and a drive, from rest, pushed to its walls: the law of the drive, and
/// the responses between surface and all ports, hold in every step, also where the string is so short
/// that a torque at one end is felt at the other within a step.
#[test]
fn val_a_limited_drive_above_walls_obeys_its_law_and_the_string_its_responses() {
    for (pipes, frequency) in [(3, 200.0), (40, 400.0)] {
        let plain = pipes::row(pipes, 0.5);
        let string = plain.clone().with_top_drive(ROTOR).unwrap();
        for method in methods::in_time() {
            obeys_above_walls(&string, &method, frequency);
        }
    }
}

fn obeys_above_walls(string: &Drillstring, method: &Method, frequency: f64) {
    let (speed, limit, duration) = (6.0, 5e3, 3.0);
    let request = Request {
        sites: Sites::new(string, &[10.0, 0.0]).unwrap(),
        channels: vec![
            ChannelRequest::Torsion {
                torques: vec![0, 1],
            },
            academic::free_in_bending(),
        ],
        sampling_frequency: frequency,
        longest_time: duration,
    };
    let responses = linear::responses(string, method, &request).unwrap();
    let plan = DrivenSurfacePlan::new(string, method, &request).unwrap();
    let surface = plan.build(&Budget::unlimited()).unwrap();
    let drive = LimitedDrive::new(&surface, &[0, 1], limit, &SurfaceProfile::default()).unwrap();
    let system = System::new(&responses)
        .unwrap()
        .below_limited(drive)
        .unwrap();
    let wall = Wall {
        clearance: 0.01,
        stiffness: 1e8,
        friction: 0.3,
        dynamic_ratio: 1.0,
        stribeck_speed: 0.0,
        radius: 0.1,
    };
    let impulse = Impulse {
        site: 0,
        amount: 3e3,
        start: 0.3,
        duration: 0.05,
        direction: 0.0,
    };
    let mut scene = scene(speed, Start::Rest, Some(bit(2e3, 1.5e3)), duration);
    scene.lateral = Some(Lateral {
        walls: vec![wall; 2],
        impulses: vec![impulse],
        eccentric_masses: vec![],
        lying: None,
        shocks: None,
    });
    let torsion = responses.torsion().unwrap();
    let mut stepper = Stepper::new(&system, &scene).unwrap();
    let mut law = DriveLaw::new(&surface, limit, 0.0);
    let [mut extra, mut set] = [const { Vec::new() }; 2];
    let mut torques = [const { Vec::new() }; 2];
    let (mut limited, mut rubbed) = (0, 0);
    while let Some(step) = stepper.step().unwrap() {
        let turned = step.surface.unwrap();
        set.push(speed);
        let Obeyed {
            linear,
            asked,
            size,
        } = law.follow(speed - turned.speed, 0.0, turned.torque);
        let given = asked.clamp(-limit, limit);
        assert!(
            (turned.torque - given).abs() < 1e-6 * size,
            "{given} {}",
            turned.torque
        );
        extra.push(turned.torque - linear);
        let on_bit = step.bit.as_ref().unwrap().torque;
        torques[0].push(step.contacts[0].torque);
        torques[1].push(step.contacts[1].torque + on_bit);
        limited += usize::from(turned.torque.abs() == limit);
        rubbed += usize::from(step.contacts.iter().any(|contact| contact.torque != 0.0));
        let below = std::iter::zip(&surface.sites_by_torque, &torques);
        let by_ports: f64 = below.map(|(taps, torques)| summed(taps, torques)).sum();
        let found = summed(&surface.speed_by_set, &set)
            + by_ports
            + summed(&surface.speed_by_torque, &extra);
        assert!(
            (turned.speed - found).abs() < 1e-6 * speed,
            "{} {found}",
            turned.speed
        );
        for (port, found) in step.speeds.iter().enumerate() {
            let own = std::iter::zip(&torsion.from_loads[port], &torques);
            let expected = summed(&torsion.from_surface[port], &set)
                + own
                    .map(|(taps, torques)| summed(taps, torques))
                    .sum::<f64>()
                + summed(&surface.sites_by_torque[port], &extra);
            assert!(
                (found - expected).abs() < 1e-6 * speed,
                "{port}: {found} {expected}"
            );
        }
    }
    assert!(limited > 20 && rubbed > 10, "{limited} {rubbed}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// In every step the torque is what the law says of all speeds so far, within the limit; and surface
    /// and bit turn as the string of the responses does under what that differs by from the linear
    /// drive's.
    #[test]
    fn val_in_every_step_the_drive_obeys_its_law_and_the_string_its_responses(number in 0usize..100_000) {
        let (string, profile, limit, scene) = drawn(number);
        let method = methods::in_time()[number % 5 % 3];
        let frequency = 32.0;
        let parts = Parts::new(&string, method, (frequency, 12.0));
        let system = parts.limited(limit, &profile);
        let mut stepper = Stepper::new(&system, &scene).unwrap();
        let drive = string.top_drive().unwrap();
        let [mut on_bit, mut extra, mut set] = [const { Vec::new() }; 3];
        let steady = scene.start.steady();
        let base = |time: f64| steady.map_or(0.0, |motion| motion.at_surface.at(time));
        let turns = steady.map_or(0.0, |motion| {
            let torque = motion.at_surface;
            let error = match drive.integral_gain > 0.0 {
                true => torque.rate / drive.integral_gain,
                false => torque.torque / drive.proportional_gain,
            };
            scene.surface_speed - error
        });
        let mut law = DriveLaw::new(&parts.surface, limit, base(0.0));
        let torques = &parts.responses.torsion().unwrap().from_loads[0][0];
        let from_surface = &parts.responses.torsion().unwrap().from_surface[0];
        // Steps in which the bit would stick with all of the torque and slip with less, or the other way
        // round: then it is all.
        let mut undecided = 0;
        while let Some(step) = stepper.step().unwrap() {
            let (surface, time) = (step.surface.unwrap(), step.time);
            let asked_speed = match steady {
                None => scene.surface_speed * profile.at(time),
                Some(_) => 0.0,
            };
            set.push(asked_speed);
            let error = asked_speed - (surface.speed - turns);
            let Obeyed { linear, asked, size } = law.follow(error, base(time), surface.torque);
            prop_assert!(surface.torque.abs() <= limit);
            let given = asked.clamp(-limit, limit);
            if (surface.torque - given).abs() > 1e-9 * size {
                prop_assert!(surface.torque.abs() == limit);
                undecided += 1;
            }
            let bit = step.bit.as_ref().unwrap();
            on_bit.push(bit.torque - steady.map_or(0.0, |motion| motion.at_bit.at(time)));
            extra.push(surface.torque - linear);
            let scale = |taps: &[f64]| taps.iter().map(|tap| tap.abs()).sum::<f64>() * size;
            let across = &parts.surface.sites_by_torque[0];
            let own_taps = &parts.surface.speed_by_torque;
            let speed = turns
                + summed(&parts.surface.speed_by_set, &set)
                + summed(across, &on_bit)
                + summed(own_taps, &extra);
            let most = surface.speed.abs() + scale(across) + scale(own_taps);
            prop_assert!((surface.speed - speed).abs() <= 1e-9 * most, "{} {speed}", surface.speed);
            let speed = steady.map_or(0.0, |motion| motion.speeds[0])
                + summed(from_surface, &set)
                + summed(torques, &on_bit)
                + summed(across, &extra);
            let most = bit.speed.abs() + scale(across) + scale(torques);
            prop_assert!((bit.speed - speed).abs() <= 1e-9 * most, "{} {speed}", bit.speed);
        }
        prop_assert!(undecided <= 2, "{undecided}");
    }
}
