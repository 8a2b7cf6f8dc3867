//! The stepper next to exact delay lines in small explicit steps, on random strings.

use std::f64::consts::TAU;

use linear::Method;
use linear::estimates::torsional_impedance;
use problems::dashpots::{BelowDashpots, collar, pipe};
use problems::delay_lines::{CuttingBit, Moment, Rock};
use problems::wells::Draw;
use sim::laws::cutting::CutStep;
use sim::{Cutting, FlatContact, Kick};

use super::scene::{Drilling, bit, responses};

const STEP: f64 = 5e-4;

/// Explicit steps to one of the stepper.
const FINER: usize = 25;
const DURATION: f64 = 10.0;

fn rock(cutting: &Cutting) -> Rock {
    let (rock, blades) = (&cutting.rock, cutting.blades() as f64);
    let cut = rock.specific_energy * rock.bit_radius * blades;
    let strength = rock.bit_radius * rock.contact_strength;
    Rock {
        stiffnesses: [0.5 * cut * rock.bit_radius, rock.cutting_ratio * cut],
        flats: strength * rock.wear_flat,
        growth: match cutting.contact {
            FlatContact::Grows => strength * rock.contact_growth * blades,
            _ => f64::INFINITY,
        },
        flat_radius: 0.5 * rock.friction * rock.bit_radius,
        apart: TAU / blades,
        relief: cutting.relief * rock.bit_radius,
    }
}

/// What the bit does in each step, by delay lines: means over finer ones.
fn by_delay_lines(mut lines: CuttingBit, kick: Kick, steps: usize) -> Vec<Moment> {
    let of_step = |index: usize| {
        let mut all = Moment::default();
        for part in 0..FINER {
            let time = (index as f64 + part as f64 / FINER as f64) * STEP;
            let is_kicked = time < kick.duration;
            let now = lines.advance(match is_kicked {
                true => [kick.torque, kick.force],
                false => [0.0; 2],
            });
            let part = 1.0 / FINER as f64;
            all.speed += part * now.speed;
            all.rate += part * now.rate;
            all.torque += part * now.torque;
            all.weight += part * now.weight;
        }
        all
    };
    (0..steps).map(of_step).collect()
}

/// A part of what a bit does in a step.
type Part = fn(Moment) -> f64;

fn as_moment(step: &CutStep) -> Moment {
    Moment {
        speed: step.speed,
        rate: step.rate,
        torque: step.torque,
        weight: step.weight,
        depth_of_cut: step.depth_of_cut,
    }
}

/// Their difference in the mean, in parts of the size of the second.
fn apart(one: impl Iterator<Item = f64>, other: impl Iterator<Item = f64>) -> f64 {
    let (mut apart, mut size) = (0.0, 0.0);
    for (one, other) in one.zip(other) {
        apart += (one - other).powi(2);
        size += other.powi(2);
    }
    f64::sqrt(apart / size)
}

/// Bits that are kicked so hard that they stick, rest and leave their rock.
#[test]
fn val_bits_on_random_strings_move_as_below_delay_lines() {
    let (mut sticks, mut rests, mut leaves) = (0, 0, 0);
    for number in 0..16 {
        let mut draw = Draw::new(number);
        let tubes = [
            pipe(draw.uniform(500.0, 2500.0)),
            collar(draw.uniform(50.0, 250.0)),
        ];
        let etas = [draw.uniform(0.3, 0.9), draw.uniform(-0.5, 0.7)];
        let mut cutting = bit(draw.log_uniform(5e6, 6e7), draw.uniform(1e-3, 6e-3));
        if number % 2 == 0 {
            cutting.contact = FlatContact::Grows;
            cutting.rock.contact_growth = draw.uniform(2.0, 10.0);
            cutting.relief = draw.uniform(0.1, 0.4);
        }
        let steady = [draw.uniform(3.0, 15.0), draw.uniform(0.002, 0.008)];
        let loads = cutting.steady(steady[1] / steady[0] * TAU / cutting.blades() as f64);
        let kick = Kick {
            torque: -loads[0] * draw.uniform(0.5, 2.0),
            force: loads[1] * draw.uniform(-2.0, 1.0),
            duration: 1.0,
        };
        let below = BelowDashpots::new(&tubes, etas);
        let responses = responses(&below, &Method::Held, [STEP, DURATION]);
        let steps = Drilling::steadily(&responses, &cutting, steady, kick).steps();
        let lines = [&below.string, &below.rod].map(|rod| {
            let speed = rod.torsional_wave_speed();
            tubes.map(|tube| [torsional_impedance(rod, &tube), tube.length / speed])
        });
        let lines = [&lines[0][..], &lines[1]];
        let fine = STEP / FINER as f64;
        let bit = CuttingBit::drilling(rock(&cutting), lines, etas, steady, fine);
        let exact = by_delay_lines(bit, kick, steps.len());
        let any = |of: &dyn Fn(&CutStep) -> bool| usize::from(steps.iter().any(of));
        sticks += any(&|step| step.speed == 0.0);
        rests += any(&|step| step.rate == 0.0);
        leaves += any(&|step| !step.touches);
        // Speeds along the axis jump where flats land.
        let parts: [(Part, f64); 4] = [
            (|now| now.speed, 5e-3),
            (|now| now.rate, 7e-2),
            (|now| now.torque, 1e-2),
            (|now| now.weight, 2e-2),
        ];
        for (index, (of, most)) in parts.into_iter().enumerate() {
            let off = apart(
                steps.iter().map(as_moment).map(of),
                exact.iter().copied().map(of),
            );
            assert!(off < most, "{number} {index}: {off}");
        }
    }
    assert!(
        sticks > 4 && rests > 12 && leaves > 1,
        "{sticks} {rests} {leaves}"
    );
}
