//! Validation of a mud motor between string and bit, against closed forms before the first wave
//! comes back, and against what turns steadily.

use crate::bits::bit;
use linear::estimates::{torsional_impedance, torsional_travel_time};
use linear::{ChannelRequest, Drillstring, Method, Request, Sites};
use problems::methods;
use problems::pipes;
use sim::{BitTorque, MudMotor, Scene, Simulator, Start, Stopping, Timing, Trajectory};

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
    (surface_speed, bit, duration): (f64, BitTorque, f64),
) -> Trajectory {
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
    simulator
        .simulate(&scene, Stopping::Full, Some(&mut record))
        .unwrap();
    record
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
