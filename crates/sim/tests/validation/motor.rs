//! Validation of a mud motor between string and bit, against closed forms before the first wave
//! comes back, and against what turns steadily.

use crate::bits::bit;
use linear::estimates::{torsional_impedance, torsional_travel_time};
use linear::{ChannelRequest, Drillstring, Method, Request, Sites, steady};
use problems::academic;
use problems::methods;
use problems::pipes;
use proptest::prelude::*;
use sim::laws::contact::Touch;
use sim::{
    BitTorque, Impulse, Lateral, MudMotor, Scene, Simulator, Start, Stopping, Timing,
    TorsionMeasures, Trajectory, Wall,
};

const FREQUENCY: f64 = 1000.0;

const MOTOR: MudMotor = MudMotor {
    speed: 12.0,
    slip: 2e-4,
    stall_torque: 12e3,
    rotor_inertia: 3.0,
};

fn motion(
    string: &Drillstring,
    method: &Method,
    motor: MudMotor,
    case: (f64, BitTorque, f64),
) -> Trajectory {
    outcome(string, method, motor, case).0
}

fn outcome(
    string: &Drillstring,
    method: &Method,
    motor: MudMotor,
    (surface_speed, bit, duration): (f64, BitTorque, f64),
) -> (Trajectory, TorsionMeasures) {
    let sites = Sites::new(string, &[400.0, 0.0]).unwrap();
    let request = Request {
        sites,
        channels: vec![ChannelRequest::Torsion { torques: vec![1] }],
        sampling_frequency: FREQUENCY,
        longest_time: duration,
    };
    let responses = linear::responses(string, method, &request).unwrap();
    let simulator = Simulator::new(&responses).unwrap();
    let simulator = simulator.above_motor(motor).unwrap();
    let scene: Scene = Scene {
        surface_speed,
        start: Start::Rest,
        bit: Some(bit),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration,
            closing_window: 0.5 * duration,
        },
    };
    let mut record = Trajectory::default();
    let outcome = simulator.simulate(&scene, Stopping::Full, Some(&mut record));
    (record, outcome.unwrap().torsion().unwrap())
}

/// A bit off bottom. Before a wave comes back the string is a damper Z, and rotor, slip and damper
/// have one time constant: ω = ω₀ (1 − e^(−t/τ)), τ = J (σ + 1/Z).
#[test]
fn val_a_free_bit_spins_up_as_rotor_and_string_let_it() {
    let string = pipes::row(200, 0.0);
    let impedance = torsional_impedance(&string, &string.sections()[0].parts[0]);
    let back = 2.0 * torsional_travel_time(&string);
    let compliance = MOTOR.slip + impedance.recip();
    let settling = MOTOR.rotor_inertia * compliance;
    assert!(settling < 0.1 * back);
    for method in methods::in_time() {
        let record = motion(&string, &method, MOTOR, (0.0, bit(0.0, 0.0), 0.9 * back));
        let bits = &record.speeds[1];
        let exact = |time: f64| MOTOR.speed * (1.0 - (-time / settling).exp());
        // The inertia is that of steps: of first order in them.
        let most = (record.times.iter().zip(bits))
            .map(|(&time, speed)| (speed - exact(time + 0.5 / FREQUENCY)).abs())
            .fold(0.0, f64::max);
        let allowed = 0.75 * MOTOR.speed / (FREQUENCY * settling);
        assert!(most < allowed, "{method:?}: {most} {allowed}");
        let last = bits.last().unwrap();
        assert!(
            (last / MOTOR.speed - 1.0).abs() < 1e-3,
            "{method:?}: {last}"
        );
        assert!(record.mud_motor_torque.last().unwrap().abs() < 1.0);
    }
}

/// A bit that the rock holds: the rotor stands, and the housing turns the string backwards, by the
/// load line of the motor or, where that would be beyond it, by its stall torque.
#[test]
fn val_a_held_bit_turns_the_string_back_by_the_motor() {
    let string = pipes::row(200, 0.0);
    let impedance = torsional_impedance(&string, &string.sections()[0].parts[0]);
    let back = 2.0 * torsional_travel_time(&string);
    let rock = bit(1e6, 1e6);
    for stall_torque in [40e3, 12e3] {
        let motor = MudMotor {
            stall_torque,
            ..MOTOR
        };
        let driven = motor.speed / (motor.slip + impedance.recip());
        assert!(driven > 12e3 && driven < 40e3, "{driven}");
        let torque = driven.min(stall_torque);
        for method in methods::in_time() {
            let record = motion(&string, &method, motor, (0.0, rock, 0.9 * back));
            assert!(record.speeds[1].iter().all(|speed| *speed == 0.0));
            // Methods other than `held` smear the front of a step.
            for passed in record.mud_motor_torque.iter().skip(100) {
                assert!(
                    (passed / torque - 1.0).abs() < 2e-3,
                    "{method:?}: {passed} {torque}"
                );
            }
        }
    }
}

/// Smooth rotation: the bit turns faster than the string by the chart, at any torque that the motor
/// can pass on, and with the string beyond its stall.
#[test]
fn val_a_steady_bit_turns_faster_than_the_string_by_the_chart() {
    let string = pipes::row(100, 4.0);
    for (torque, stalls) in [(2e3, false), (6e3, false), (14e3, true)] {
        let record = motion(
            &string,
            &Method::Held,
            MOTOR,
            (8.0, bit(torque, torque), 60.0),
        );
        let expected = 8.0 + MOTOR.relative_speed(torque);
        assert_eq!(MOTOR.relative_speed(torque) == 0.0, stalls);
        let [above, bit] = [0, 1].map(|site| *record.speeds[site].last().unwrap());
        assert!(
            (bit / expected - 1.0).abs() < 1e-4,
            "{torque}: {bit} {expected}"
        );
        assert!((above / 8.0 - 1.0).abs() < 1e-4, "{torque}: {above}");
        let passed = record.mud_motor_torque.last().unwrap();
        assert!((passed / torque - 1.0).abs() < 1e-4, "{torque}: {passed}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 16, failure_persistence: None, ..Default::default() })]

    /// What turns steadily stalls the motor all the time where the bit takes more than the stall torque,
    /// and never where it takes less; the severity is the swing by the speed that string and chart
    /// give the bit.
    #[test]
    fn val_a_motor_stalls_where_the_bit_takes_more_than_it_gives(
        surface_speed in 6.0..15.0f64,
        speed in 5.0..20.0f64,
        part in 0.0..0.9f64,
        stall_torque in 3e3..12e3f64,
        load in prop_oneof![0.2..0.97f64, 1.03..1.5f64],
    ) {
        let motor = MudMotor { speed, slip: part * speed / stall_torque, stall_torque, rotor_inertia: 3.0 };
        let torque = load * stall_torque;
        let string = pipes::row(100, 4.0);
        let case = (surface_speed, bit(torque, torque), 60.0);
        let (record, found) = outcome(&string, &Method::Held, motor, case);
        prop_assert_eq!(found.sticks, 0);
        prop_assert_eq!(found.motor_stalled_fraction, Some(f64::from(load > 1.0)));
        let expected = surface_speed + motor.relative_speed(torque);
        prop_assert!((found.closing_speed / expected - 1.0).abs() < 1e-3);
        let closing = record.times.iter().zip(&record.speeds[1]).filter(|(time, _)| **time > 30.0);
        let closing: Vec<f64> = closing.map(|(_, speed)| *speed).collect();
        let most = closing.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = closing.iter().copied().fold(f64::INFINITY, f64::min);
        let severity = 0.5 * (most - least) / expected;
        let error = found.severity.unwrap() - severity;
        prop_assert!(error.abs() < 1e-3 * severity + 1e-4, "{error} {severity}");
    }
}

/// A string with walls above a motor, or without one, that is pushed while it turns steadily.
struct Whirling {
    distances: &'static [f64],
    clearances: &'static [f64],
    motor: Option<MudMotor>,
    surface_speed: f64,
    pushed: usize,
}

/// Torque on a bit that always slides, N m.
const SLIDING: f64 = 1500.0;

impl Whirling {
    fn record(&self) -> Trajectory {
        let string = academic::string();
        let request = academic::lateral_request(&string, self.distances, 4.0);
        let sites = &request.sites;
        let start = steady::rotation(&string, sites, self.surface_speed, SLIDING);
        let responses = linear::responses(&string, &Method::Quadrature, &request).unwrap();
        let mut simulator = Simulator::new(&responses).unwrap();
        if let Some(motor) = self.motor {
            simulator = simulator.above_motor(motor).unwrap();
        }
        let wall = |clearance: &f64| Wall {
            clearance: *clearance,
            stiffness: 1e9,
            friction: 0.3,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.15,
        };
        let impulse = Impulse {
            site: self.pushed,
            amount: 4000.0,
            start: 0.5,
            duration: 0.02,
            direction: 0.0,
        };
        let scene: Scene = Scene {
            surface_speed: self.surface_speed,
            start: Start::Steady(start),
            bit: Some(bit(SLIDING, SLIDING)),
            friction: Vec::new(),
            axial: None,
            lateral: Some(Lateral {
                walls: self.clearances.iter().map(wall).collect(),
                impulses: vec![impulse],
                eccentric_masses: vec![],
                lying: None,
                shocks: None,
            }),
            timing: Timing {
                duration: 4.0,
                closing_window: 1.0,
            },
        };
        let mut record = Trajectory::default();
        simulator
            .simulate(&scene, Stopping::Full, Some(&mut record))
            .unwrap();
        record
    }

    /// How far a site that strikes its wall is from where that of another is, at most, in parts of its
    /// clearance.
    fn apart(&self, other: &Self, site: usize) -> f64 {
        let [one, other] = [self, other].map(Self::record);
        let touches = one.touches[site].iter().filter(|it| **it != Touch::Free);
        assert!(touches.count() > 100);
        let places = one.positions[site].iter().zip(&other.positions[site]);
        let apart = places.map(|(one, other)| (one[0] - other[0]).hypot(one[1] - other[1]));
        apart.fold(0.0, f64::max) / self.clearances[site]
    }
}

/// A rotor that hardly weighs anything and never gives way adds its speed, no more: at its wall the bit
/// moves as that of a string without a motor that turns as much faster.
#[test]
fn val_a_bit_below_a_motor_meets_its_wall_at_its_own_speed() {
    let motor = MudMotor {
        slip: 0.0,
        stall_torque: 1e9,
        rotor_inertia: 1e-6,
        ..MOTOR
    };
    let below = Whirling {
        distances: &[0.0],
        clearances: &[0.015],
        motor: Some(motor),
        surface_speed: 4.0,
        pushed: 0,
    };
    let alone = Whirling {
        motor: None,
        surface_speed: 4.0 + motor.speed,
        ..below
    };
    let apart = below.apart(&alone, 0);
    assert!(apart < 1e-4, "{apart}");
    // At the speed of its string it would move otherwise.
    let slower = Whirling {
        motor: None,
        ..below
    };
    let apart = below.apart(&slower, 0);
    assert!(apart > 0.1, "{apart}");
}

/// What touches above a motor turns with the string, on which a bit that always slides has the same
/// torque at any speed.
#[test]
fn val_walls_above_a_motor_turn_with_the_string() {
    let motor = MudMotor {
        rotor_inertia: 1e-6,
        ..MOTOR
    };
    let above = Whirling {
        distances: &[60.0, 0.0],
        clearances: &[0.015, 1.0],
        motor: Some(motor),
        surface_speed: 8.0,
        pushed: 0,
    };
    let alone = Whirling {
        motor: None,
        ..above
    };
    let apart = above.apart(&alone, 0);
    assert!(apart < 1e-4, "{apart}");
}

/// Rock and wall act on the rotor together, and the motor on it by its chart.
#[test]
fn val_rock_wall_and_motor_balance_the_rotor() {
    let record = Whirling {
        distances: &[0.0],
        clearances: &[0.015],
        motor: Some(MOTOR),
        surface_speed: 4.0,
        pushed: 0,
    }
    .record();
    let speeds = &record.speeds[0];
    let mut hardest: f64 = 0.0;
    for step in 1..speeds.len() {
        let changed = academic::SAMPLING_FREQUENCY * (speeds[step] - speeds[step - 1]);
        let [motor, rock, wall] = [
            &record.mud_motor_torque,
            &record.bit_torque,
            &record.wall_torques[0],
        ]
        .map(|torques| torques[step]);
        let left = MOTOR.rotor_inertia * changed - (motor + rock + wall);
        assert!(
            left.abs() < 1e-6 * (motor.abs() + rock.abs() + wall.abs()),
            "{step}: {left}"
        );
        hardest = hardest.max(wall.abs());
    }
    assert!(hardest > 100.0, "{hardest}");
}
