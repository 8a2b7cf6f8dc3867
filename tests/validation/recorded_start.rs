//! Labels under a recorded surface speed, against waves handed on in time, which share no code with the
//! method, on random strings.

use std::f64::consts::TAU;

use campaign::engine::{Case, Recipe, RunOptions, answer};
use campaign::quantities::Axis;
use campaign::random::Stream;
use sim::waveguide::{Friction, Waveguide};
use sim::{Label, Motion, Recording, SurfaceProfile, TorsionRegime};
use studies::promises::{Begins, Problem};

/// Numbers of the surface speed, which no other test has.
const SEED: u64 = 91;

/// How long the speed is recorded, s.
const RECORDED: f64 = 90.0;

/// Recaptures that make stick-slip.
const REPEATED: usize = 3;

/// Places of damping of the two waveguides.
const PLACES: [f64; 2] = [500.0, 750.0];

/// The speed in parts of its mean: from rest over some seconds, and up and down by up to a fifth after,
/// every tenth of a second.
fn recorded(draw: &mut Stream) -> Recording {
    let (rise, part) = (2.0 + 8.0 * draw.part(), 0.2 * draw.part());
    let period = 5.0 + 20.0 * draw.part();
    let times: Vec<f64> = (0..=(10.0 * RECORDED) as usize + 20)
        .map(|it| 0.1 * it as f64)
        .collect();
    let speed = |time: &f64| (time / rise).min(1.0) * (1.0 + part * (TAU * time / period).sin());
    let speeds = times.iter().map(speed).collect();
    Recording::new(times, speeds).unwrap()
}

/// `STRINGS=200` for what the guide says; here are three.
#[test]
fn val_labels_under_a_recorded_speed_are_those_of_waves_handed_on_in_time() {
    let strings = std::env::var("STRINGS").map_or(3, |count| count.parse().unwrap());
    let [mut known, mut wrong, mut sticking] = [0; 3];
    for number in 0..strings {
        let problem = Problem::draw_family(number, SEED, Begins::Ramp).unwrap();
        let head = format!("methods = [\"held\"]\ntime_s = {RECORDED}\n");
        let sweep = problem.sweep(&head).unwrap().for_run().unwrap();
        // The slower of its cases is at 0.8 of the estimate.
        let mut draw = Stream::new(SEED, number as u64);
        let speed_rpm = (0.3 + draw.part()) * sweep.design.values(0)[0] / 0.8;
        let speed = speed_rpm * TAU / 60.0;
        let recording = recorded(&mut draw);
        let mut setting = sweep.setting.for_labels().into_owned();
        setting.profile = SurfaceProfile::Recorded(recording.clone());
        let conditions = sweep.conditions.with(Axis::SurfaceSpeedRpm, speed_rpm);
        let case = Case::under(&sweep, &setting, 0, vec![speed_rpm], &conditions).unwrap();
        let system = Recipe::of(&sweep, &setting, sweep.methods[0], RECORDED).build();
        let record = answer(&system.unwrap(), &case, 0, RunOptions::default(), &sweep);
        let label = record.outcome.unwrap().labels()[Motion::Torsion].unwrap();
        let bit = sweep.bit.as_ref().unwrap();
        let torque = bit.torque_dynamic(&sweep.conditions).unwrap().unwrap();
        let torques = sweep.conditions.torques(torque);
        let sticks = |places: f64| {
            let law = Friction {
                torque_static: torques.torque_static,
                torque_dynamic: torques.torque_dynamic,
            };
            let mut guide = Waveguide::new(&setting.string, places, law);
            let timing = case.scene.timing;
            let closing = timing.duration - timing.closing_window;
            let (mut turns, mut sticks, mut last) = (false, 0, 0.0);
            for step in 0..(timing.duration / guide.step) as usize {
                let (time, turned) = (step as f64 * guide.step, turns);
                turns = guide.advance(speed * recording.at(time), turned) > 0.0;
                sticks += usize::from(turned && !turns);
                if !turns && sticks > 0 {
                    last = time;
                }
            }
            sticks >= REPEATED && last >= closing
        };
        let truth = PLACES.map(sticks);
        if truth[0] != truth[1] {
            continue;
        }
        known += 1;
        sticking += usize::from(truth[0]);
        let is_sticking = label == Label::from(TorsionRegime::StickSlip);
        if is_sticking != truth[0] {
            wrong += 1;
            println!("string {number}: {} at {speed_rpm} rpm", label.name());
        }
    }
    println!("{wrong} of {known} labels are wrong, {sticking} stick and slip");
    assert!(20 * wrong <= known);
}
