//! Validation of the top drive: closed forms, a wave and a motor stepped in time without a
//! response, limits, energy, passivity and modes of random strings.

use linear::controllers;
use linear::drive_delay::longest_delay;
use linear::estimates::{
    first_mode, torsional_impedance, torsional_travel_time, winding_stiffness,
};
use linear::method::FiniteElement;
use linear::modes::torsional_modes;
use linear::waves::lattice::Lattice;
use linear::waves::network::TorsionNetwork;
use linear::{
    BuildError, ChannelRequest, ChannelResponses, Complex64, Drillstring, Method, RaisedCosine,
    Request, Section, Sites, SteppedString, SurfaceSupport, TopDrive, Tube,
};
use problems::academic::{self, tube};
use problems::methods;
use problems::oracles;
use problems::pipes::{self, pipe};
use proptest::prelude::*;

/// Methods that need no damping.
fn drive(inertia: f64, proportional_gain: f64, integral_gain: f64) -> TopDrive {
    TopDrive {
        inertia,
        proportional_gain,
        integral_gain,
        delay: 0.0,
        late_inertia: 0.0,
    }
}

fn below(string: &Drillstring, drive: TopDrive) -> Drillstring {
    string.clone().with_top_drive(drive).unwrap()
}

fn at_bit(string: &Drillstring, method: Method, frequency: f64, time: f64) -> ChannelResponses {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: frequency,
        longest_time: time,
    };
    let responses = linear::responses(string, &method, &request).unwrap();
    responses.torsion().unwrap().clone()
}

/// A torque on the bit of a uniform undamped string meets the impedance Z alone, and for ever,
/// where the drive has that of the pipe.
#[test]
fn val_a_matched_drive_without_inertia_reflects_nothing() {
    let string = pipes::row(100, 0.0);
    let matched = TopDrive {
        integral_gain: 0.0,
        ..controllers::impedance_matched(&string)
    };
    let impedance = torsional_impedance(&string, &pipe(10.0));
    let string = below(&string, matched);
    let round_trip = (2.0 * torsional_travel_time(&string) * 640.0) as usize;
    // Elements do not carry the highest frequencies: those come back, and late.
    for (method, allowed) in methods::in_time().into_iter().zip([1e-12, 1e-12, 0.15]) {
        let taps = &at_bit(&string, method, 640.0, 5.0).from_loads[0][0];
        let late: f64 = taps.iter().skip(round_trip).map(|tap| tap.abs()).sum();
        assert!(late * impedance < allowed, "{}: {late:e}", method.name());
        let all: f64 = taps.iter().sum();
        assert!((all * impedance - 1.0).abs() < 1e-3, "{}", method.name());
    }
}

/// Taps of the bit from the surface and from its own torque, of a mesh that is stepped with its
/// drive.
fn stepped_at_bit(string: &Drillstring, frequency: f64, time: f64) -> [Vec<f64>; 2] {
    let bending = academic::BENDING;
    let (support, sites) = (SurfaceSupport::Free, Sites::bit());
    let parameters = FiniteElement::default();
    let mesh = SteppedString::new(string, &bending, support, &sites, &parameters, frequency);
    let responses = mesh.unwrap().responses(&[0], time).unwrap();
    let torsion = responses.torsion().unwrap();
    [&torsion.from_surface[0], &torsion.from_loads[0][0]].map(Vec::clone)
}

/// A torque T that stays on the bit of a uniform undamped string turns it at T/Z; its front comes
/// back from a drive (Z − K_p)/(Z + K_p) times as large, and a free end doubles that.
#[test]
fn val_a_front_comes_back_from_the_drive_as_from_its_impedance() {
    let plain = pipes::row(100, 0.0);
    let impedance = torsional_impedance(&plain, &pipe(10.0));
    let frequency = 640.0;
    let round_trip = (2.0 * torsional_travel_time(&plain) * frequency) as usize;
    for part in [0.2, 1.0, 5.0, 1e6] {
        let string = below(&plain, drive(0.0, part * impedance, 0.0));
        let [_, taps] = stepped_at_bit(&string, frequency, 2.0);
        let mut speed = 0.0;
        let speeds: Vec<f64> = (taps.iter())
            .map(|tap| {
                speed += tap * impedance;
                speed
            })
            .collect();
        let mean = |from: usize| {
            let within = from + round_trip / 4..from + 3 * round_trip / 4;
            let count = within.len() as f64;
            speeds[within].iter().sum::<f64>() / count
        };
        let reflection = (1.0 - part) / (1.0 + part);
        for (found, expected) in [
            (mean(0), 1.0),
            (mean(round_trip), 1.0 + 2.0 * reflection),
            (
                mean(2 * round_trip),
                1.0 + 2.0 * (reflection + reflection * reflection),
            ),
        ] {
            assert!(
                (found - expected).abs() < 0.01,
                "{part}: {found} {expected}"
            );
        }
    }
}

/// Around the first modes, which depend on the drive, a mesh stepped with it responds as exact
/// waves do.
#[test]
fn val_a_mesh_and_its_drive_have_the_exact_response_at_their_modes() {
    let plain = academic::string();
    for drive in [
        controllers::soft_torque(&plain, 2000.0),
        controllers::stiff(&plain, 2000.0),
        controllers::impedance_matched(&plain),
    ] {
        let string = below(&plain, drive);
        let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
        let (frequency, time) = (1000.0, 30.0);
        let [from_surface, from_torque] = stepped_at_bit(&string, frequency, time);
        for mode in torsional_modes(&string, 3).unwrap() {
            let hertz = mode.frequency();
            let exact = network.at_frequency(hertz);
            let sum = |taps: &[f64]| -> Complex64 {
                let angle = -std::f64::consts::TAU * hertz / frequency;
                let terms = taps.iter().enumerate();
                terms
                    .map(|(step, tap)| Complex64::from_polar(*tap, angle * step as f64))
                    .sum()
            };
            for (found, exact) in [
                (sum(&from_surface), exact.from_surface[0]),
                (sum(&from_torque), exact.from_torque[(0, 0)]),
            ] {
                let off = (found - exact).norm() / exact.norm();
                assert!(off < 0.02, "{drive:?} at {hertz} Hz: {off}");
            }
        }
    }
}

/// A drive ten times as stiff is ten times as near to a surface that turns as prescribed.
#[test]
fn val_a_stiff_drive_is_a_surface_that_turns_as_prescribed() {
    let string = academic::string();
    for method in methods::in_time()
        .into_iter()
        .chain([Method::Hilbert(Default::default())])
    {
        let rigid = at_bit(&string, method, 640.0, 5.0);
        let off = |gain: f64| -> f64 {
            let string = below(&string, drive(0.0, gain, 1e3 * gain));
            let found = at_bit(&string, method, 640.0, 5.0);
            let difference = |one: &[f64], other: &[f64]| -> f64 {
                let pairs = one.iter().zip(other);
                let sum: f64 = pairs.map(|(one, other)| (one - other).abs()).sum();
                sum / other.iter().map(|tap| tap.abs()).sum::<f64>()
            };
            difference(&found.from_surface[0], &rigid.from_surface[0])
                .max(difference(&found.from_loads[0][0], &rigid.from_loads[0][0]))
        };
        let [soft, stiff] = [1e8, 1e9].map(off);
        assert!(stiff < 1e-4, "{}: {stiff:e}", method.name());
        let ratio = soft / stiff;
        assert!((5.0..20.0).contains(&ratio), "{}: {ratio}", method.name());
    }
}

/// Speed of the bit of a uniform undamped string, and the torque of the motor, while its drive
/// follows a set speed: waves that go down arrive a travel time later, turn round at the free
/// bit, and the motor's equation of motion is stepped in between, by Heun's rule in very short
/// steps.
fn stepped(
    string: &Drillstring,
    set: impl Fn(f64) -> f64,
    time: f64,
) -> (impl Fn(f64) -> f64, impl Fn(f64) -> f64) {
    let (drive, travel) = (string.top_drive().unwrap(), torsional_travel_time(string));
    let impedance = torsional_impedance(string, &string.sections()[0].parts[0]);
    let delay = 4000;
    let step = travel / f64::from(delay as u32);
    let steps = (time / step) as usize;
    // Speeds that the wave which goes down has at the surface.
    let mut down: Vec<f64> = Vec::with_capacity(steps);
    let mut torques: Vec<f64> = Vec::with_capacity(steps);
    let (mut speed, mut turned) = (0.0, 0.0);
    // Speeds of the motor, which its controller measures late.
    let mut speeds: Vec<f64> = Vec::with_capacity(steps);
    let late_by = (drive.delay / step).round() as usize;
    // From the free bit a wave comes back as it was.
    let up = |down: &[f64], index: usize| match index.checked_sub(2 * delay) {
        Some(before) => down[before],
        None => 0.0,
    };
    for index in 0..steps {
        speeds.push(speed);
        let late = |index: usize, now: f64| match late_by {
            0 => now,
            _ => index.checked_sub(late_by).map_or(0.0, |it| speeds[it]),
        };
        // What the controller makes up for of the acceleration that it measured, between two samples.
        let late_acceleration = |index: usize| match index.checked_sub(late_by) {
            Some(it) if it + 1 < speeds.len() => (speeds[it + 1] - speeds[it]) / step,
            _ => 0.0,
        };
        let made_up = drive.late_inertia * late_acceleration(index);
        let rate = |[time, measured]: [f64; 2], speed: f64, turned: f64, up: f64| {
            // The string pulls with Z times what goes down less what comes up.
            let pull = impedance * (speed - 2.0 * up);
            let motor =
                drive.proportional_gain * (set(time) - measured) + drive.integral_gain * turned;
            (motor + made_up - pull) / (drive.inertia + drive.late_inertia)
        };
        let now = index as f64 * step;
        down.push(speed - up(&down, index));
        let measured = late(index, speed);
        let first = rate([now, measured], speed, turned, up(&down, index));
        let missing = set(now) - measured;
        torques.push(drive.proportional_gain * missing + drive.integral_gain * turned);
        let next_up = if index + 1 < 2 * delay {
            0.0
        } else {
            down[index + 1 - 2 * delay]
        };
        let tried = speed + step * first;
        let next_measured = late(index + 1, tried);
        let next_missing = set(now + step) - next_measured;
        let next_turned = turned + 0.5 * step * (missing + next_missing);
        let second = rate([now + step, next_measured], tried, next_turned, next_up);
        speed += 0.5 * step * (first + second);
        turned = next_turned;
    }
    let between = |values: &[f64], place: f64| {
        let (index, part) = (place as usize, place.fract());
        values[index] * (1.0 - part) + values[index + 1] * part
    };
    let bit_speed = move |time: f64| match (time - travel) / step {
        place if place < 0.0 => 0.0,
        place => 2.0 * between(&down, place),
    };
    (bit_speed, move |time: f64| between(&torques, time / step))
}

/// Two methods that share no code; errors fall as the square of the step.
#[test]
fn val_a_motor_and_a_wave_stepped_in_time_say_the_same() {
    a_motor_and_a_wave_say_the_same(drive(2000.0, 3000.0, 2000.0));
}

/// So they do where its controller measures the speed late.
#[test]
fn val_so_they_do_of_a_motor_that_answers_late() {
    a_motor_and_a_wave_say_the_same(TopDrive {
        delay: 0.0873,
        ..drive(2000.0, 3000.0, 2000.0)
    });
}

/// So they do where it makes up for inertia by an acceleration that is as old.
#[test]
fn val_so_they_do_of_a_motor_that_makes_up_for_inertia_late() {
    a_motor_and_a_wave_say_the_same(TopDrive {
        delay: 0.0873,
        late_inertia: 1200.0,
        ..drive(2000.0, 3000.0, 2000.0)
    });
}

fn a_motor_and_a_wave_say_the_same(drive: TopDrive) {
    let string = below(&pipes::row(100, 0.0), drive);
    let rise = RaisedCosine { duration: 0.4 };
    let (exact, exact_torque) = stepped(&string, |time| rise.integral(time), 8.0);
    for method in methods::in_time() {
        let error = |frequency: f64| -> f64 {
            let steps = (7.0 * frequency) as usize;
            // The mean over each step where loads are held, else the end of it.
            let moment = if method == Method::Held { 0.5 } else { 0.0 };
            let time = |step: usize| (step as f64 + moment) / frequency;
            let input: Vec<f64> = (0..steps).map(|step| rise.integral(time(step))).collect();
            let taps = at_bit(&string, method, frequency, 7.0);
            let found = oracles::convolve(&taps.from_surface[0], &input);
            let errors = found.iter().enumerate();
            let speed = errors
                .map(|(step, speed)| (speed - exact(time(step))).abs())
                .fold(0.0, f64::max);
            let request = Request {
                sites: Sites::bit(),
                channels: Vec::new(),
                sampling_frequency: frequency,
                longest_time: 7.0,
            };
            let taps = linear::surface_torque(&string, &method, &request).unwrap();
            let found = oracles::convolve(&taps, &input);
            let errors = found.iter().enumerate();
            let torque = errors
                .map(|(step, torque)| (torque - exact_torque(time(step))).abs())
                .fold(0.0, f64::max);
            // The motor's torque is some thousand N m.
            speed.max(torque / 1e4)
        };
        let [coarse, fine] = [160.0, 320.0].map(error);
        assert!(fine < 0.02, "{}: {fine:e}", method.name());
        if drive.delay > 0.0 {
            // Between two steps the delay is met straight on, which a step half as long may meet
            // no better.
            let most = if drive.late_inertia > 0.0 { 5e-3 } else { 2e-3 };
            assert!(fine < most, "{}: {fine:e}", method.name());
            continue;
        }
        // Elements are as long as they are; what is left at Newmark's γ is of the first order.
        let least = if method == Method::Quadrature {
            3.0
        } else {
            1.5
        };
        assert!(
            coarse / fine > least,
            "{}: {coarse:e} {fine:e}",
            method.name()
        );
    }
}

/// A rotor alone whose controller answers late swings with ωτ = atan(ω K_p/K_i), ω² J = |K_i + iω K_p|,
/// at the longest delay; a string as short as a metre only adds its inertia.
#[test]
fn val_the_longest_delay_of_a_rotor_is_that_of_the_closed_form() {
    let stub = pipes::row(1, 0.1);
    let tube = &stub.sections()[0].parts[0];
    let of_string = stub.material().density * tube.polar_moment() * stub.length();
    for [inertia, proportional_gain, integral_gain] in [
        [2000.0, 4e4, 0.0],
        [2900.0, 3.8e4, 4.5e4],
        [2500.0, 1500.0, 800.0],
    ] {
        let drive = drive(inertia, proportional_gain, integral_gain);
        let longest = longest_delay(&below(&stub, drive)).unwrap().unwrap();
        let heavy = inertia + of_string;
        let (p, i) = (proportional_gain / heavy, integral_gain / heavy);
        let square = 0.5 * (p * p + (p.powi(4) + 4.0 * i * i).sqrt());
        let rate = square.sqrt();
        let expected = (rate * proportional_gain).atan2(integral_gain) / rate;
        assert!(
            (longest / expected - 1.0).abs() < 3e-3,
            "{longest} {expected}"
        );
    }
}

/// In the end the surface is turned against the damping of the whole string, under any drive.
#[test]
fn val_the_torque_at_the_surface_is_in_the_end_what_damping_takes() {
    let string = academic::string();
    let resistance = string.torsional_damping() * string.length();
    let soft = controllers::soft_torque(&string, 4000.0);
    for string in [string.clone(), below(&string, soft)] {
        for method in methods::in_time()
            .into_iter()
            .chain([Method::Hilbert(Default::default())])
        {
            let taps =
                linear::surface_torque(&string, &method, &academic::bit_request(20.0)).unwrap();
            let torque: f64 = taps.iter().sum();
            let off = torque / resistance - 1.0;
            assert!(off.abs() < 1e-4, "{}: {off:e}", method.name());
        }
    }
}

/// With an integral gain alone nothing takes energy: a torque at any frequency does no work
/// in the mean, and by `held`, whose lattice keeps energy as the string does, it rings on.
#[test]
fn val_without_a_proportional_gain_energy_stays() {
    let lossless = below(&pipes::row(40, 0.0), drive(300.0, 0.0, 5e3));
    let damped = below(&pipes::row(40, 0.0), drive(30.0, 1e3, 5e3));
    let at = |string: &Drillstring, frequency| {
        let network = TorsionNetwork::new(string, &Sites::bit()).unwrap();
        network.at_frequency(frequency).from_torque[(0, 0)]
    };
    for frequency in [0.03, 0.4, 1.7, 9.3, 60.0] {
        let response = at(&lossless, frequency);
        assert!(response.re.abs() < 1e-9 * response.norm(), "{frequency}");
        assert!(at(&damped, frequency).re > 0.0, "{frequency}");
    }
    let ringing = |string: &Drillstring| {
        let taps = &at_bit(string, Method::Held, 640.0, 60.0).from_loads[0][0];
        let power = |part: &[f64]| -> f64 { part.iter().map(|tap| tap * tap).sum() };
        power(&taps[28_000..38_000]) / power(&taps[..10_000])
    };
    let [kept, lost] = [&lossless, &damped].map(ringing);
    // Fronts fall into one step or two: powers of parts differ by that.
    assert!((kept - 1.0).abs() < 0.05, "{kept}");
    assert!(lost < 0.5, "{lost}");
}

/// J ω² − K_i = −Z ω tan(ωL/c) of a uniform undamped string without a proportional gain.
#[test]
fn val_modes_of_a_uniform_string_are_those_of_the_closed_form() {
    let string = below(&pipes::row(100, 0.0), drive(800.0, 0.0, 3e3));
    let impedance = torsional_impedance(&string, &pipe(10.0));
    let travel = torsional_travel_time(&string);
    let modes = torsional_modes(&string, 5).unwrap();
    assert_eq!(modes.len(), 5);
    for mode in &modes {
        let rate = mode.pole.im;
        let off = (3e3 - 800.0 * rate * rate) * (rate * travel).cos()
            - impedance * rate * (rate * travel).sin();
        assert!(off.abs() < 1e-5 * impedance * rate, "{mode:?}: {off}");
        assert!(mode.damping_ratio().abs() < 1e-8, "{mode:?}");
    }
    // One between every two zeros of the tangent's denominator, and one below the first.
    for (index, mode) in modes.iter().enumerate() {
        let place = mode.pole.im * travel / std::f64::consts::PI + 0.5;
        assert_eq!(place as usize, index, "{mode:?}");
    }
    // A surface that turns as prescribed has quarter waves.
    let held = torsional_modes(&pipes::row(100, 0.0), 3).unwrap();
    for (index, mode) in held.iter().enumerate() {
        let quarters = 4.0 * mode.frequency() * travel;
        assert!(
            (quarters - (2 * index + 1) as f64).abs() < 1e-6,
            "{quarters}"
        );
    }
}

/// Quarter waves of a uniform string carry 8/π² of its inertia.
#[test]
fn val_the_first_mode_of_a_uniform_string_is_a_quarter_wave() {
    let string = pipes::row(100, 3.0);
    let mode = first_mode(&string);
    let quarter = std::f64::consts::FRAC_PI_2 / torsional_travel_time(&string);
    assert!((mode.frequency / quarter - 1.0).abs() < 1e-12);
    let inertia = string.material().density * pipe(1000.0).polar_moment() * 1000.0;
    let part = mode.inertia / inertia * std::f64::consts::PI.powi(2) / 8.0;
    assert!((part - 1.0).abs() < 1e-10, "{part}");
}

/// Collar, pipe and joints of a random string.
fn strings() -> impl Strategy<Value = Drillstring> {
    (
        (1usize..200, 1usize..20),
        (0.06..0.1f64, 0.08..0.14f64),
        prop_oneof![Just(0.0), 0.01..20.0f64],
        prop::bool::ANY,
    )
        .prop_map(|((pipes, collars), (radius, collar), damping, jointed)| {
            let mut parts = vec![tube(9.5, radius)];
            if jointed {
                parts.push(tube(0.5, 1.3 * radius));
            }
            let sections = vec![
                Section {
                    repeat: pipes,
                    parts,
                },
                Section {
                    repeat: collars,
                    parts: vec![tube(9.0, collar)],
                },
            ];
            Drillstring::new(academic::string().material(), sections, damping).unwrap()
        })
}

/// Drives from ones hardly there to ones that are hard to move.
fn drives() -> impl Strategy<Value = TopDrive> {
    (
        prop_oneof![Just(0.0), 10.0..5000.0f64],
        1.0..5.5f64,
        0.0..5.5f64,
    )
        .prop_map(|(inertia, proportional, integral)| {
            drive(inertia, 10f64.powf(proportional), 10f64.powf(integral))
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..Default::default() })]

    /// In the end the bit turns as the drive is set to, and a torque that lasts does not
    /// change that; no stuck bit is unstable.
    #[test]
    fn val_any_string_below_any_drive_is_passive_and_keeps_its_speed(
        (string, drive) in (strings(), drives())
    ) {
        let string = below(&string, drive);
        for method in methods::in_time() {
            let request = Request {
                sites: Sites::bit(),
                channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
                sampling_frequency: 100.0,
                longest_time: 20.0,
            };
            // What such a drive hardly damps rings on for longer than taps are built.
            let responses = linear::responses(&string, &method, &request);
            prop_assume!(!matches!(
                responses,
                Err(BuildError::TooManyTaps { .. } | BuildError::TooManyImpulses { .. })
            ));
            let responses = responses.unwrap();
            let margin = responses.torsion_margin().unwrap().unwrap();
            prop_assert!(margin > linear::passivity::STABLE_MARGIN, "{}: {margin}", method.name());
            let torsion = responses.torsion().unwrap();
            if torsion.ending == linear::passivity::Ending::Whole {
                let speed: f64 = torsion.from_surface[0].iter().sum();
                prop_assert!((speed - 1.0).abs() < 1e-5, "{}: {speed}", method.name());
                let taps = &torsion.from_loads[0][0];
                let all: f64 = taps.iter().sum();
                let size: f64 = taps.iter().map(|tap| tap.abs()).sum();
                prop_assert!(all.abs() < 1e-5 * size, "{}: {all}", method.name());
            }
        }
    }

    /// The first mode's frequency is the exact string's, and its inertia the one that pulls
    /// on a drive: near ω₁, where no other mode matters, the surface feels
    /// −ω² J₁ ω₁²/(ω₁² − ω²) in excess of a smooth rest.
    #[test]
    fn val_the_first_mode_is_that_of_the_exact_string(string in strings()) {
        let damping = string.torsional_damping();
        let still = Drillstring::new(string.material(), string.sections().to_vec(), 0.0).unwrap();
        let mode = first_mode(&still);
        let lowest = torsional_modes(&still, 1).unwrap()[0];
        prop_assert!((lowest.pole.im / mode.frequency - 1.0).abs() < 1e-7);
        // A drive of an inertia so large that it hardly moves shifts its frequency by
        // J₁/2J: ω² (1 + J₁/J) in the limit.
        let inertia = 1e7 * mode.inertia;
        let heavy = below(&still, drive(inertia, 0.0, 1e-9));
        let modes = torsional_modes(&heavy, 2).unwrap();
        let shifted = modes.iter().find(|found| found.pole.im > 0.5 * mode.frequency).unwrap();
        let found = 2.0 * (shifted.pole.im / mode.frequency - 1.0) * inertia / mode.inertia;
        prop_assert!((found - 1.0).abs() < 0.02, "{found}");
        prop_assert!(damping == 0.0 || first_mode(&string) == mode);
    }

}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..Default::default() })]

    /// As many as the argument of a determinant of transfer matrices turns around all that
    /// swing up to the highest.
    #[test]
    fn val_no_mode_is_missed((string, drive) in (strings(), prop::option::of(drives()))) {
        let string = match drive {
            Some(drive) => below(&string, drive),
            None => string,
        };
        let modes = torsional_modes(&string, 6).unwrap();
        prop_assert_eq!(modes.len(), 6);
        let highest = modes.last().unwrap().pole.im;
        // Nothing damps faster than the lightest tube alone, a drive aside.
        let tubes = string.sections().iter().flat_map(|section| &section.parts);
        let lightest = tubes.map(Tube::polar_moment).fold(f64::INFINITY, f64::min);
        let damps = string.torsional_damping() / (string.material().density * lightest);
        let (fastest, slowest) = (-damps - 2.0 * highest, 1e-3 * highest);
        let (low, high) = (1e-4 * highest, 1.001 * highest);
        let corners = [(slowest, low), (slowest, high), (fastest, high), (fastest, low)]
            .map(|(re, im)| Complex64::new(re, im));
        let swings = |s| oracles::free_torque(&string, s);
        let turned: f64 = (0..4)
            .map(|side| oracles::turned(&swings, corners[side], corners[(side + 1) % 4]))
            .sum();
        let counted = turned / std::f64::consts::TAU;
        prop_assert!((counted - 6.0).abs() < 0.01, "{counted}: {modes:?}");
    }

    /// Of a drive at least as heavy as the first mode.
    #[test]
    fn val_soft_torque_damps_the_slower_of_the_first_two_modes_best(
        (string, ratio) in (strings(), 1.0..12.0f64)
    ) {
        let still = Drillstring::new(string.material(), string.sections().to_vec(), 0.0).unwrap();
        let first = first_mode(&still);
        let inertia = ratio * first.inertia;
        // Those that the drive and the first mode make of one another.
        let slower = |drive: TopDrive| -> f64 {
            let modes = torsional_modes(&below(&still, drive), 2).unwrap();
            let low = modes.iter().filter(|mode| mode.pole.im < 2.0 * first.frequency);
            low.map(|mode| -mode.pole.re).fold(f64::INFINITY, f64::min)
        };
        let soft = controllers::soft_torque(&still, inertia);
        let own = slower(soft);
        let parts = [0.7, 0.85, 1.0, 1.15, 1.3];
        let tried = parts.into_iter().flat_map(|p| parts.map(|i| (p, i)));
        let best = tried
            .map(|(p, i)| slower(drive(inertia, p * soft.proportional_gain, i * soft.integral_gain)))
            .filter(|rate| rate.is_finite())
            .fold(0.0, f64::max);
        prop_assert!(own.is_finite() && own > 0.9 * best, "{ratio}: {own} {best}");
    }
}

/// Held, a bit winds up against the string and the integral gain in series.
#[test]
fn val_a_held_bit_winds_up_as_springs_in_series_do() {
    let string = below(&pipes::row(100, 0.0), drive(1000.0, 2000.0, 400.0));
    let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
    let s = Complex64::new(1e-6, 0.0);
    let admittance = network.admittance(s);
    // Torque that grows at a rate of 1, per set speed: T s = K Ω.
    let torque = admittance.from_surface[0] / admittance.from_torque[(0, 0)];
    let stiffness = (torque * s).re / winding_stiffness(&string);
    assert!((stiffness - 1.0).abs() < 1e-4, "{stiffness}");
}

#[test]
fn what_no_drive_can_be_is_refused() {
    let string = pipes::row(10, 0.0);
    for (inertia, proportional, integral) in [
        (-1.0, 1.0, 1.0),
        (1.0, -1.0, 1.0),
        (1.0, 1.0, f64::NAN),
        (1.0, 0.0, 0.0),
    ] {
        let refused = string
            .clone()
            .with_top_drive(drive(inertia, proportional, integral));
        assert!(refused.is_err(), "{inertia} {proportional} {integral}");
    }
}

/// A drive has no part in what the string's material loses: on the lattice, too, its integral is K_i/s.
#[test]
fn val_a_drive_loses_nothing_to_the_material_of_the_string() {
    let plain = academic::string().with_loss_factor(0.05).unwrap();
    let string = below(&plain, drive(2000.0, 1e3, 2e3));
    let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
    let lattice = Lattice::new(&string, &Sites::bit()).unwrap();
    for frequency in [0.01, 0.03, 0.1, 0.3] {
        let s = Complex64::new(0.0, std::f64::consts::TAU * frequency);
        let zeta = (-s * lattice.step).exp();
        let (found, expected) = (lattice.surface_torque(zeta), network.surface_torque(s));
        let off = (found - expected).norm() / expected.norm();
        assert!(off < 1e-3, "{frequency}: {off}");
    }
}
