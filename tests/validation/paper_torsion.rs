//! Validation of torsion against the paper: the linear numbers, Figs. 7(a), 8
//! and 9, the limit of Eq. 74, and the failures the paper reports.

mod regression;

use problems::academic;
use problems::oracles::assert_close;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::process::Command;

use linear::estimates::{
    largest_undershoot, stick_slip_speed_limit, torsional_impedance, torsional_stiffness,
};
use linear::method::{FiniteElement, Transform};
use linear::passivity::STABLE_MARGIN;
use linear::waves::network::TorsionNetwork;
use linear::{Complex64, Method, Responses, Sites};
use sim::{
    BitTorque, Rock, Scene, Simulator, Stopping, Timing, TorsionMeasures, TorsionRegime,
    Trajectory, torsion_timing,
};

use crate::support::Workplace;

const RPM: f64 = std::f64::consts::TAU / 60.0;
const QUADRATURE: Method = Method::Quadrature;

/// No case here lasts longer, s.
const LONGEST: f64 = 400.0;

/// Responses are built for this long, s: those that have decayed by then are good for
/// any time.
const BUILT_FOR: f64 = 60.0;

fn hilbert() -> Method {
    Method::Hilbert(Transform::default())
}

fn elements(gamma: f64) -> Method {
    Method::FiniteElement(FiniteElement {
        gamma,
        ..Default::default()
    })
}

fn responses(method: &Method) -> Responses {
    let request = academic::bit_request(BUILT_FOR);
    linear::responses(&academic::string(), method, &request).unwrap()
}

fn simulator(method: &Method) -> Simulator {
    let responses = Responses {
        longest_time: LONGEST,
        ..responses(method)
    };
    Simulator::new(&responses).unwrap()
}

fn bit(torque_dynamic: f64) -> BitTorque {
    BitTorque {
        torque_static: 1.2 * torque_dynamic,
        torque_dynamic,
        decay_speed: 0.0,
    }
}

fn simulate(
    simulator: &Simulator,
    rpm: f64,
    torque: f64,
    duration: Option<f64>,
) -> TorsionMeasures {
    let bit = bit(torque);
    let mut timing = torsion_timing(&academic::string(), rpm * RPM, &bit, &sim::Start::Rest);
    if let Some(duration) = duration {
        timing.duration = duration;
    }
    let scene = Scene {
        start: sim::Start::Rest,
        surface_speed: rpm * RPM,
        bit: Some(bit),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing,
    };
    simulator
        .simulate(&scene, Stopping::Full, None)
        .unwrap()
        .torsion()
        .unwrap()
}

#[test]
fn val_stiffness_and_impedance_are_those_of_table_2() {
    let string = academic::string();
    assert_close(torsional_stiffness(&string), 32_353.0, 1e-4);
    let collar = &string.sections()[1].parts[0];
    assert_close(1.0 / torsional_impedance(&string, collar), 5.084e-5, 1e-4);
    assert_close(linear::estimates::sampling_frequency(&string), 638.9, 1e-4);
}

#[test]
fn val_figure_7a_arrives_peaks_and_settles() {
    let taps = responses(&QUADRATURE);
    let speed: Vec<f64> = taps.torsion().unwrap().from_surface[0]
        .iter()
        .scan(0.0, |sum, tap| {
            *sum += tap;
            Some(*sum)
        })
        .collect();
    let time = |step: usize| step as f64 / academic::SAMPLING_FREQUENCY;
    let peak = speed.iter().copied().fold(0.0, f64::max);
    assert_close(peak, 1.554, 0.01);
    // The peak is flat: its edge, where it comes within 2 % of the top.
    let edge = speed.iter().position(|speed| *speed > 0.98 * peak).unwrap();
    assert_close(time(edge), 0.89, 0.02);
    let front = speed.iter().position(|speed| *speed > 0.1).unwrap();
    assert_close(time(front), 0.31, 0.01);
    assert_close(speed[speed.len() - 1], 1.0, 0.01);
}

/// Until it first slips the bit is held, and its torque winds up as k_eff Ω (t − t_d) once
/// the waves have died away: what the surface has turned by, less what is on its way.
fn first_slip(rpm: f64, torque_static: f64) -> f64 {
    let string = academic::string();
    let network = TorsionNetwork::new(&string, &Sites::bit()).unwrap();
    let s = Complex64::new(1e-4, 0.0);
    let admittance = network.admittance(s);
    let held = (admittance.from_surface[0] / admittance.from_torque[(0, 0)]).re * s.re;
    let stiffness = torsional_stiffness(&string);
    let delay = (1.0 - held / stiffness) / s.re;
    torque_static / (stiffness * rpm * RPM) + delay
}

#[test]
fn val_figure_8a_slips_and_turns_smoothly() {
    for method in [QUADRATURE, hilbert(), elements(0.52)] {
        let found = simulate(&simulator(&method), 0.2, 2000.0, Some(10.0));
        assert_eq!(found.regime, TorsionRegime::Smooth, "{}", method.name());
        assert_close(found.first_slip.unwrap(), first_slip(0.2, 2400.0), 0.002);
        assert_eq!(found.sticks, 0);
    }
}

#[test]
fn val_figure_8b_sticks_and_slips() {
    for method in [QUADRATURE, hilbert(), elements(0.52)] {
        let found = simulate(&simulator(&method), 0.1, 4000.0, Some(40.0));
        assert_eq!(found.regime, TorsionRegime::StickSlip, "{}", method.name());
        assert_close(found.first_slip.unwrap(), first_slip(0.1, 4800.0), 0.002);
    }
}

/// Ω/T_d (rpm per kN m) between stick-slip and smooth, by bisection.
fn simulated_limit(simulator: &Simulator) -> f64 {
    let (mut low, mut high) = (0.05, 0.065);
    while high - low > 2e-5 {
        let middle = 0.5 * (low + high);
        match simulate(simulator, 3.0 * middle, 3000.0, None).regime {
            TorsionRegime::StickSlip => low = middle,
            _ => high = middle,
        }
    }
    0.5 * (low + high)
}

/// The same by Eq. 74, with the undershoot of the method's own responses.
fn limit_by_equation_74(method: &Method) -> f64 {
    let (taps, bit) = (responses(method), bit(1000.0));
    let undershoot = largest_undershoot(taps.at_bit().unwrap());
    stick_slip_speed_limit(undershoot, bit.torque_static, bit.torque_dynamic) / RPM
}

#[test]
fn val_the_simulated_limit_lies_just_above_equation_74() {
    for method in [QUADRATURE, hilbert(), elements(0.52)] {
        let found = simulated_limit(&simulator(&method));
        let margin = found / limit_by_equation_74(&method);
        assert!((1.0..1.06).contains(&margin), "{}: {margin}", method.name());
    }
}

/// Eq. 74 asks what one slip from even rotation does. A bit that was held leaves a tube without loss
/// wound up: it speeds up by 2Ω until the front of its slip comes back after 2τ, is then at 2Ω less
/// (T_s − T_d)/Z, and slows down by 2Ω until 4τ, so it stops at 4τ − τ (T_s − T_d)/(Z Ω) at any speed,
/// here at three times that of Eq. 74.
#[test]
fn val_a_bit_that_was_held_stops_again_far_above_equation_74() {
    let place = Workplace::new();
    let (inner, outer, length, shear, density) = (0.054, 0.0635, 1000.0, 80e9, 7840.0);
    let polar = FRAC_PI_2 * (f64::powi(outer, 4) - f64::powi(inner, 4));
    let speed_of_wave = f64::sqrt(shear / density);
    let (impedance, travel) = (density * polar * speed_of_wave, length / speed_of_wave);
    let drop = 200.0 / impedance;
    let speed = 3.0 * drop;
    place.write(
        "tube.toml",
        format!(
            "surface_speed_rpm = {}\ntime_s = 5\nmethods = [\"held\"]\n[string]\n\
             shear_modulus_gpa = 80\ndensity_kg_m3 = {density}\ntorsional_damping_nms_rad_m = 0.001\n\
             [[string.sections]]\nrepeat = 1\nparts = [{{ length_m = {length}, inner_radius_m = {inner}, \
             outer_radius_m = {outer} }}]\n[bit]\ntorque_dynamic_nm = 1000\ntorque_static_ratio = 1.2\n\
             [design]\nkind = \"grid\"\n[design.axes]\ntorque_dynamic_nm = {{ values = [1000] }}\n",
            speed / RPM
        ),
    );
    let answer = place.sweep(&["simulate", "tube.toml", "--out", "one"]);
    assert_eq!(answer.code, 0, "{}", answer.errors);
    let table = std::fs::read_to_string(place.path("one/case.csv")).unwrap();
    let mut lines = table.lines().map(|line| line.split(','));
    let (header, mut row) = (
        lines.next().unwrap(),
        lines.next().unwrap().collect::<Vec<_>>(),
    );
    let row: BTreeMap<&str, &str> = header.zip(row.drain(..)).collect();
    let number = |name: &str| row[name].parse::<f64>().unwrap();
    // The line is at a third of the speed.
    assert_close(number("stick_slip_margin_rpm") * RPM, 2.0 * drop, 0.005);
    assert!(number("sticks") >= 1.0);
    assert_close(
        number("bit_speed_peak_rpm") * RPM,
        drop + 2.0 * speed,
        0.005,
    );
    assert_close(
        number("slip_time_s"),
        4.0 * travel - travel * drop / speed,
        0.005,
    );
}

/// The torsion problem is homogeneous: Ω and T_d scaled together scale the
/// motion and leave the label alone. By a power of two, to the last bit.
#[test]
fn val_scaling_speed_and_torque_together_changes_no_label() {
    let simulator = simulator(&QUADRATURE);
    let timed = |rpm: f64, torque: f64, timing: Timing| {
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: rpm * RPM,
            bit: Some(bit(torque)),
            friction: Vec::new(),
            axial: None,
            lateral: None,
            timing,
        };
        simulator
            .simulate(&scene, Stopping::Full, None)
            .unwrap()
            .torsion()
            .unwrap()
    };
    for ratio in [0.02, 0.05, 0.057, 0.058, 0.1, 0.5, 3.0] {
        let torque = 2500.0;
        let rpm = ratio * 1e-3 * torque;
        let timing = torsion_timing(
            &academic::string(),
            rpm * RPM,
            &bit(torque),
            &sim::Start::Rest,
        );
        let one = timed(rpm, torque, timing);
        let doubled = timed(2.0 * rpm, 2.0 * torque, timing);
        assert_eq!(doubled.regime, one.regime);
        assert_eq!(doubled.first_slip, one.first_slip);
        assert_eq!(doubled.sticks, one.sticks);
        assert_eq!(doubled.peak_speed, 2.0 * one.peak_speed);
        for scale in [0.37, 11.0] {
            assert_eq!(
                timed(scale * rpm, scale * torque, timing).regime,
                one.regime
            );
        }
    }
}

/// Static twist of a stuck bit: the torque winds up at the rate k_eff Ω.
#[test]
fn val_a_stuck_bit_is_wound_up_at_the_static_stiffness() {
    let string = academic::string();
    for method in [QUADRATURE, hilbert(), elements(0.52)] {
        let simulator = simulator(&method);
        let scene = Scene {
            start: sim::Start::Rest,
            surface_speed: 0.1,
            bit: Some(bit(1e9)),
            friction: Vec::new(),
            axial: None,
            lateral: None,
            timing: Timing {
                duration: 40.0,
                closing_window: 2.0,
            },
        };
        let mut trajectory = Trajectory::default();
        let outcome = simulator
            .simulate(&scene, Stopping::Full, Some(&mut trajectory))
            .unwrap();
        assert_eq!(outcome.torsion().unwrap().regime, TorsionRegime::Stuck);
        let torque =
            |time: f64| trajectory.bit_torque[(time * academic::SAMPLING_FREQUENCY) as usize];
        let rate = (torque(20.0) - torque(39.0)) / 19.0;
        assert_close(rate, 0.1 * torsional_stiffness(&string), 1e-4);
    }
}

fn labels_of_figure_9() -> Vec<(f64, f64, String, String)> {
    let folder = tempfile::tempdir().unwrap();
    let sweep_file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../sweeps/fig09.toml");
    let status = Command::new(env!("CARGO_BIN_EXE_sweep"))
        .args(["run", sweep_file, "--quiet", "--out"])
        .arg(folder.path())
        .status()
        .unwrap();
    assert!(status.success());
    let mut reader = csv::Reader::from_path(folder.path().join("labels.csv")).unwrap();
    let header = reader.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|field| field == name).unwrap();
    let (speed, torque) = (column("surface_speed_rpm"), column("torque_dynamic_nm"));
    let (method, label) = (column("method"), column("torsion"));
    reader
        .records()
        .map(|record| {
            let record = record.unwrap();
            (
                record[speed].parse().unwrap(),
                record[torque].parse().unwrap(),
                record[method].to_owned(),
                record[label].to_owned(),
            )
        })
        .collect()
}

#[test]
fn val_figure_9_has_a_line_and_the_methods_differ_only_there() {
    let rows = labels_of_figure_9();
    let of = |method: &str| {
        rows.iter()
            .filter(|row| row.2 == method)
            .collect::<Vec<_>>()
    };
    let (quadrature, elements, hilbert) = (of("quadrature"), of("finite-element"), of("hilbert"));
    assert!(quadrature.len() >= 400);
    assert!(rows.iter().all(|row| row.3 != "stuck"));
    let differing = |other: &[&(f64, f64, String, String)]| {
        quadrature
            .iter()
            .zip(other)
            .filter(|(a, b)| a.3 != b.3)
            .map(|(a, _)| a.0 / (1e-3 * a.1))
            .collect::<Vec<f64>>()
    };
    let by_elements = differing(&elements);
    assert!(
        by_elements.len() as f64 <= 0.01 * quadrature.len() as f64,
        "{by_elements:?}"
    );
    // A thin band around Ω/T_d = 0.0576 rpm per kN m.
    for ratio in differing(&hilbert).iter().chain(&by_elements) {
        assert_close(*ratio, 0.0576, 0.03);
    }
    for row in &rows {
        let ratio = row.0 / (1e-3 * row.1);
        if ratio < 0.97 * 0.0568 {
            assert_eq!(row.3, "stick_slip", "{row:?}");
        } else if ratio > 1.03 * 0.0583 {
            assert_eq!(row.3, "smooth", "{row:?}");
        }
    }
}

#[test]
fn val_the_cases_of_figure_8_lie_on_either_side_of_figure_9() {
    let rock = Rock::sandstone();
    assert_close(rock.weight_on_bit(2000.0).unwrap(), 43e3, 0.01);
    assert_close(rock.weight_on_bit(4000.0).unwrap(), 63e3, 0.01);
}

// What the paper warns of (Sections 2.4 and 5.2.1): each failure is seen, and
// the margin predicts it.

#[test]
fn val_the_plain_inverse_transform_chatters() {
    let taps = responses(&Method::DirectIdft(Transform::default()));
    assert!(taps.torsion_margin().unwrap().unwrap() < -1.0);
    let found = simulate(&Simulator::new(&taps).unwrap(), 0.1, 4000.0, Some(40.0));
    assert!(found.sticks > 100, "{found:?}");
}

#[test]
fn val_a_digital_filter_cut_short_has_the_wrong_stiffness() {
    let taps = responses(&Method::Hilbert(Transform { seconds: Some(4.0) }));
    assert!(taps.torsion_margin().unwrap().unwrap() < STABLE_MARGIN);
    let found = simulate(&Simulator::new(&taps).unwrap(), 0.1, 4000.0, Some(40.0));
    assert!(
        found.first_slip.unwrap() > 1.03 * first_slip(0.1, 4800.0),
        "{found:?}"
    );
}

/// Mean second difference of the torque over the first wind-up, when it should
/// be a straight line but for waves that die away.
fn roughness_while_stuck(method: &Method) -> f64 {
    let simulator = Simulator::new(&responses(method)).unwrap();
    let scene = Scene {
        start: sim::Start::Rest,
        surface_speed: 0.1 * RPM,
        bit: Some(bit(4000.0)),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: 14.0,
            closing_window: 2.0,
        },
    };
    let mut trajectory = Trajectory::default();
    simulator
        .simulate(&scene, Stopping::Full, Some(&mut trajectory))
        .unwrap();
    let late = &trajectory.bit_torque[trajectory.bit_torque.len() / 2..];
    late.windows(3)
        .map(|t| (t[0] - 2.0 * t[1] + t[2]).abs())
        .sum::<f64>()
        / late.len() as f64
}

#[test]
fn val_newmark_without_numerical_damping_chatters_while_the_bit_sticks() {
    assert!(responses(&elements(0.5)).torsion_margin().unwrap().unwrap() < STABLE_MARGIN);
    assert!(
        responses(&elements(0.52))
            .torsion_margin()
            .unwrap()
            .unwrap()
            > STABLE_MARGIN
    );
    let (chattering, damped) = (
        roughness_while_stuck(&elements(0.5)),
        roughness_while_stuck(&elements(0.52)),
    );
    assert!(chattering > 100.0 * damped, "{chattering} {damped}");
}
