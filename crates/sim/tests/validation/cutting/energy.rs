//! Energy of a string above a bit that cuts: what the surface and a kick put in is what waves store,
//! what dashpots lose and what the rock takes. Waves are handed on by delay lines of whole steps, from
//! the loads of the stepper alone, and works are those of its loads at its speeds.

use linear::Method;
use linear::estimates::{torsional_impedance, torsional_travel_time};
use problems::dashpots::{BelowDashpots, STEEL, collar, pipe};
use problems::delay_lines::Waves;
use sim::laws::cutting::CutStep;
use sim::{Cutting, Kick};

use super::scene::{Drilling, bit, part, responses};

/// Along the axis waves are this many times as fast as in torsion: then both take whole numbers of
/// steps through each tube.
const FASTER: f64 = 1.6;

/// Steps that a wave of torsion takes to the bit.
const STEPS_DOWN: f64 = 640.0;

/// A case, and how a motion of it is read.
struct Case {
    below: BelowDashpots,
    tubes: Vec<linear::Tube>,
    etas: [f64; 2],
    steady: [f64; 2],
    kick: Kick,
    step: f64,
    steps: Vec<CutStep>,
}

impl Case {
    fn run(
        tubes: Vec<linear::Tube>,
        etas: [f64; 2],
        (cutting, steady, kick): (&Cutting, [f64; 2], Kick),
        duration: f64,
    ) -> Self {
        let youngs_modulus = FASTER * FASTER * STEEL.shear_modulus;
        let below = BelowDashpots::of_stiffness(&tubes, youngs_modulus, etas);
        let step = torsional_travel_time(&below.string) / STEPS_DOWN;
        let responses = responses(&below, &Method::Held, [step, duration]);
        let steps = Drilling::steadily(&responses, cutting, steady, kick).steps();
        Self {
            below,
            tubes,
            etas,
            steady,
            kick,
            step,
            steps,
        }
    }

    /// Both motions close to a part of what is put in, in every step.
    fn closes(&self, cutting: &Cutting) {
        let [speed, rate] = self.steady;
        let blades = cutting.blades() as f64;
        let loads = cutting.steady(rate / speed * std::f64::consts::TAU / blades);
        let kick = [self.kick.torque, self.kick.force];
        let rods = [&self.below.string, &self.below.rod];
        for motion in 0..2 {
            let rod = rods[motion];
            let whole = torsional_travel_time(rod);
            let length: f64 = self.tubes.iter().map(|tube| tube.length).sum();
            let tube = |tube: &linear::Tube| {
                [torsional_impedance(rod, tube), whole * tube.length / length]
            };
            let tubes: Vec<[f64; 2]> = self.tubes.iter().map(tube).collect();
            let steady = [self.steady[motion], loads[motion]];
            let mut waves = Waves::steady(&tubes, self.etas[motion], self.step, steady);
            let begun = waves.energy(self.step);
            let (mut put_in, mut lost, mut taken) = (0.0, 0.0, 0.0);
            for (index, now) in self.steps.iter().enumerate() {
                let time = (index as f64 + 0.5) * self.step;
                let kicked = match time < self.kick.duration {
                    true => kick[motion],
                    false => 0.0,
                };
                let [load, moved] = match motion {
                    0 => [now.torque, now.speed],
                    _ => [now.weight, now.rate],
                };
                let by_waves = waves.free_speed() - (load - kicked) / waves.impedance();
                let [surface, dashpot] = waves.end_step(by_waves);
                put_in += self.step * (surface + kicked * moved);
                lost += self.step * dashpot;
                taken += self.step * load * moved;
                if index % 97 == 0 || index + 1 == self.steps.len() {
                    let stored = waves.energy(self.step) - begun;
                    let off = put_in - stored - lost - taken;
                    assert!(
                        off.abs() <= 1e-9 * put_in,
                        "{motion} {index}: {put_in} is not {stored} + {lost} + {taken}: {off}"
                    );
                }
            }
        }
    }
}

/// It sticks and comes loose, and rests along the axis.
#[test]
fn val_a_bit_that_sticks_balances_its_energy() {
    let cutting = bit(60e6, 5e-3);
    let kick = Kick {
        torque: 1000.0,
        force: 5000.0,
        duration: 2.0,
    };
    let tubes = vec![pipe(2000.0)];
    let case = Case::run(tubes, [0.9, 0.3], (&cutting, [4.0, 0.006], kick), 20.0);
    let stuck = part(&case.steps, |step| step.speed == 0.0);
    assert!(stuck > 0.05, "{stuck}");
    case.closes(&cutting);
}

/// It turns on, while the axis chatters.
#[test]
fn val_axial_chatter_balances_its_energy() {
    let cutting = bit(60e6, 5e-3);
    let kick = Kick {
        torque: 300.0,
        force: 0.0,
        duration: 1.0,
    };
    let tubes = vec![pipe(1800.0), collar(200.0)];
    let case = Case::run(tubes, [0.7, 0.0], (&cutting, [8.0, 0.004], kick), 30.0);
    let rests = part(&case.steps, |step| step.rate == 0.0);
    assert!(rests > 0.1, "{rests}");
    case.closes(&cutting);
}
