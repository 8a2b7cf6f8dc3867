//! Every step of a bit on random strings obeys its load lines and its laws: what the past leaves is
//! summed directly, and the rock is kept here once more.

use std::f64::consts::TAU;

use linear::{Axial, Drillstring, Hoist, Method, Responses, TopDrive};
use problems::dashpots::BelowDashpots;
use problems::wells::{Draw, Well, with_loss};
use proptest::prelude::*;
use sim::laws::cutting::CutStep;
use sim::laws::rock::CuttingLaw;
use sim::{Blades, Cutting, FlatContact, Kick};

use super::scene::{Drilling, responses};

const STEP: f64 = 1.0 / 640.0;
const DURATION: f64 = 6.0;

/// What is not more than this part of what there is, is rounding.
const ROUNDING: f64 = 1e-9;

/// Where a bit stands, and the rock that its blades have left.
struct Bottom {
    angle: f64,
    depth: f64,
    deepest: f64,
    /// From each blade to the one before, rad.
    apart: Vec<f64>,
    /// How the rock rises before all of that, m/rad.
    advance: f64,
    /// Angles at the ends of steps that turned on, and what each blade left at them.
    angles: Vec<f64>,
    left: Vec<Vec<f64>>,
}

impl Bottom {
    fn new(cutting: &Cutting, advance: f64) -> Self {
        let apart = cutting.blade_angles();
        Self {
            angle: 0.0,
            depth: 0.0,
            deepest: 0.0,
            advance,
            angles: vec![0.0],
            left: vec![vec![0.0]; apart.len()],
            apart,
        }
    }

    fn furthest(&self) -> f64 {
        self.angles[self.angles.len() - 1]
    }

    /// Of the rock before a blade, m.
    fn rock(&self, blade: usize, angle: f64) -> f64 {
        let ahead = angle >= self.furthest();
        let (left, angle) = match ahead {
            true => {
                let before = (blade + self.apart.len() - 1) % self.apart.len();
                (&self.left[before], angle - self.apart[blade])
            }
            false => (&self.left[blade], angle),
        };
        let next = self.angles.partition_point(|it| *it < angle);
        if next == 0 {
            return self.advance * angle;
        }
        let part = (angle - self.angles[next - 1]) / (self.angles[next] - self.angles[next - 1]);
        left[next - 1] + part * (left[next] - left[next - 1])
    }

    fn depths(&self, angle: f64, depth: f64) -> Vec<f64> {
        let blades = 0..self.apart.len();
        blades
            .map(|blade| depth - self.rock(blade, angle))
            .collect()
    }

    fn end_step(&mut self, cut: &CutStep) {
        self.angle += STEP * cut.speed;
        self.depth += STEP * cut.rate;
        if self.angle > self.furthest() {
            let found = self.depths(self.angle, self.depth);
            self.angles.push(self.angle);
            for (left, depth) in self.left.iter_mut().zip(found) {
                left.push(self.depth - depth.min(0.0));
            }
        }
        if cut.speed > 0.0 || self.depth > self.deepest {
            self.deepest = self.depth;
        }
    }
}

/// What a step leaves open.
struct Line {
    /// From its beginning to where the law is met, s.
    within: f64,
    /// Along the axis, m/s per N.
    compliance: f64,
    /// Torque and weight that there are, N m and N.
    size: [f64; 2],
}

/// The constants of the law, from those of the rock.
struct Constants {
    torque: f64,
    weight: f64,
    growth: f64,
    flats: f64,
    flat_radius: f64,
    relief: f64,
}

impl Constants {
    fn of(cutting: &Cutting) -> Self {
        let (rock, blades) = (&cutting.rock, cutting.blades() as f64);
        let radius = rock.bit_radius;
        Self {
            torque: 0.5 * rock.specific_energy * radius.powi(2) * blades,
            weight: rock.cutting_ratio * rock.specific_energy * radius * blades,
            growth: match cutting.contact {
                FlatContact::Grows => radius * rock.contact_strength * rock.contact_growth * blades,
                _ => f64::INFINITY,
            },
            flats: radius * rock.contact_strength * rock.wear_flat,
            flat_radius: 0.5 * rock.friction * radius,
            relief: cutting.relief * radius,
        }
    }

    /// What flats can carry at a depth of cut.
    fn carried(&self, depth: f64) -> f64 {
        match (depth >= 0.0, self.growth.is_finite()) {
            (false, _) => 0.0,
            (true, true) => (self.growth * depth).min(self.flats),
            (true, false) => self.flats,
        }
    }

    /// What is wrong with a step, in words.
    fn wrong(&self, bottom: &Bottom, cut: &CutStep, line: &Line) -> Option<String> {
        let within = line.within;
        let [of_torque, of_weight] = line.size.map(|size| ROUNDING * size);
        let angle = bottom.angle + within * cut.speed;
        let depths = bottom.depths(angle, bottom.depth + within * cut.rate);
        let mean = |of: &dyn Fn(f64) -> f64| {
            depths.iter().map(|depth| of(*depth)).sum::<f64>() / depths.len() as f64
        };
        let deep = mean(&|depth| depth.max(0.0));
        // Where flats land at once, they carry anything up to all they can.
        let [least, most] = [-1e-12, 1e-12].map(|off| mean(&|depth| self.carried(depth + off)));
        let flat = cut.weight - self.weight * deep;
        let start = bottom.depths(angle, bottom.depth);
        let above = start
            .iter()
            .fold(f64::INFINITY, |least, depth| least.min(-depth));
        let room = (bottom.deepest - bottom.depth).max(above).max(0.0);
        let bound = self.relief * cut.speed.max(0.0) + room / STEP;
        if cut.rate > bound + 1e-12 {
            return Some(format!("sinks faster than {bound}"));
        }
        let is_bound = cut.rate >= bound - 1e-12 && flat >= least - of_weight;
        let is_carried = match cut.rate {
            rate if rate > 0.0 => {
                is_bound || (least - of_weight..=most + of_weight).contains(&flat)
            }
            0.0 => is_bound || (-of_weight..=most + of_weight).contains(&flat),
            _ => flat.abs() <= of_weight,
        };
        if !is_carried {
            return Some(format!("flats carry {flat}, not {least} to {most}"));
        }
        let by_law = |most: f64| self.torque * deep + self.flat_radius * flat.clamp(0.0, most);
        let [low, high] = [by_law(least) - of_torque, by_law(most) + of_torque];
        let is_right = match cut.speed {
            // Blades cut one way alone, and rock holds them the other way: if it did not turn, it
            // would be in the air.
            speed if speed < 0.0 => {
                let unloaded = cut.rate + line.compliance * cut.weight;
                let standing = bottom.depths(bottom.angle, bottom.depth + line.within * unloaded);
                cut.torque.abs() <= of_torque && standing.iter().all(|depth| *depth < 1e-12)
            }
            0.0 => cut.torque <= high,
            // The ledge where its own cut ends holds a bit that turned back.
            _ if (angle - bottom.furthest()).abs() < 1e-9 => cut.torque >= -of_torque,
            _ => (low..=high).contains(&cut.torque),
        };
        (!is_right).then(|| format!("torque is not {low} to {high}"))
    }
}

/// A scene on a random string.
#[derive(Debug, Clone)]
struct Ride {
    number: usize,
    cutting: Cutting,
    speed: f64,
    /// Depth of cut that it drills steadily at, m.
    depth: f64,
    /// In parts of steady torque and weight; at rest without.
    kick: Option<[f64; 2]>,
    is_quadrature: bool,
}

fn ride() -> impl Strategy<Value = Ride> {
    let blades = prop_oneof![
        (3usize..9).prop_map(Blades::Even),
        prop::collection::vec(0.4..1.0f64, 3..7).prop_map(|parts| {
            let sum: f64 = parts.iter().sum();
            Blades::Uneven(parts.iter().map(|part| part / sum * TAU).collect())
        }),
    ];
    let contact = prop_oneof![Just(FlatContact::Grows), Just(FlatContact::AtOnce)];
    let rock = (
        2e6..1e8f64,
        0.3..1.0f64,
        0.0..0.9f64,
        0.0..8e-3f64,
        1.0..20.0f64,
    );
    let kick = prop::option::of([-1.0..1.0f64, -1.5..1.5f64]);
    let motion = (1.0..25.0f64, 2e-4..4e-3f64, kick, prop::bool::ANY);
    let cutting =
        (blades, contact, rock, 0.01..0.5f64).prop_map(|(blades, contact, rock, relief)| {
            let (specific_energy, cutting_ratio, friction, wear_flat, contact_growth) = rock;
            Cutting {
                rock: CuttingLaw {
                    bit_radius: 0.12,
                    specific_energy,
                    cutting_ratio,
                    friction,
                    contact_strength: 4e7,
                    contact_growth,
                    wear_flat,
                    poor_cleaning: None,
                },
                contact,
                blades,
                relief,
            }
        });
    (0usize..1000, cutting, motion).prop_map(
        |(number, cutting, (speed, depth, kick, is_quadrature))| Ride {
            number,
            cutting,
            speed,
            depth,
            kick,
            is_quadrature,
        },
    )
}

/// A drawn string below a motor under control and a hoist, or held by both.
fn below(number: usize) -> BelowDashpots {
    let mut draw = Draw::new(number);
    let mut string = Well::draw(number, &mut draw).string;
    if number % 2 == 0 {
        string = with_loss(&string, &mut draw);
    }
    let axial = |string: &Drillstring, hoist| {
        let axial = Axial {
            youngs_modulus: 210e9,
            damping: 100.0,
            hoist,
        };
        axial.rod(string).unwrap()
    };
    if number % 3 == 0 {
        let rod = axial(&string, None);
        return BelowDashpots {
            string,
            rod,
            dampings: [f64::INFINITY; 2],
        };
    }
    let hoist = Hoist {
        mass: draw.uniform(0.0, 3e4),
        damping: draw.log_uniform(1e4, 1e6),
        stiffness: 0.0,
    };
    let rod = axial(&string, Some(hoist));
    let drive = TopDrive {
        inertia: draw.uniform(0.0, 4000.0),
        proportional_gain: draw.log_uniform(100.0, 1e4),
        integral_gain: draw.uniform(0.0, 5000.0),
        delay: 0.0,
        late_inertia: 0.0,
    };
    BelowDashpots {
        string: string.with_top_drive(drive).unwrap(),
        rod,
        dampings: [drive.proportional_gain, hoist.damping],
    }
}

/// The sums of what loads of steps before leave, and of how the surface moves.
fn past(responses: &Responses, channel: usize, loads: &[f64]) -> f64 {
    let taps = &responses.channels[channel].from_loads[0][0];
    let later = taps.iter().skip(1);
    loads
        .iter()
        .rev()
        .zip(later)
        .map(|(load, tap)| load * tap)
        .sum()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..Default::default() })]

    #[test]
    fn val_every_step_obeys_its_lines_and_laws(ride in ride()) {
        let method = match ride.is_quadrature {
            true => Method::Quadrature,
            false => Method::Held,
        };
        let responses = responses(&below(ride.number), &method, [STEP, DURATION]);
        let (cutting, constants) = (&ride.cutting, Constants::of(&ride.cutting));
        let mean = TAU / cutting.blades() as f64;
        let rate = ride.depth * ride.speed / mean;
        let steady = cutting.steady(ride.depth);
        let kick = ride.kick.map(|parts| Kick {
            torque: parts[0] * steady[0],
            force: parts[1] * steady[1],
            duration: 1.0,
        });
        let drilling = match kick {
            Some(kick) => Drilling::steadily(&responses, cutting, [ride.speed, rate], kick),
            None => Drilling::from_rest(&responses, cutting, 0.0, [ride.speed, rate]),
        };
        let offset = method.collocation_offset();
        let advance = if kick.is_some() { rate / ride.speed } else { 0.0 };
        let mut bottom = Bottom::new(cutting, advance);
        let mut loads = [Vec::new(), Vec::new()];
        let mut reached = [0.0; 2];
        for (index, cut) in drilling.steps().iter().enumerate() {
            let time = (index as f64 + offset) * STEP;
            let kicked = kick.filter(|kick| time < kick.duration).map_or([0.0; 2], |kick| [kick.torque, kick.force]);
            let mut size = [0.0; 2];
            for channel in 0..2 {
                let of = &responses.channels[channel];
                let compliance = of.from_loads[0][0][0];
                let (moves, load) = [(cut.speed, cut.torque), (cut.rate, cut.weight)][channel];
                let (driven, held) = match kick {
                    Some(_) => ([ride.speed, rate][channel], steady[channel]),
                    None => {
                        reached[channel] += of.from_surface[0].get(index).copied().unwrap_or(0.0);
                        ([ride.speed, rate][channel] * reached[channel], 0.0)
                    }
                };
                let change = held - load + kicked[channel];
                let by_line = driven + past(&responses, channel, &loads[channel]) + compliance * change;
                let set = [ride.speed, rate][channel];
                size[channel] = load.abs() + held + (moves.abs() + set) / compliance;
                let off = (moves - by_line).abs();
                prop_assert!(off <= ROUNDING * compliance * size[channel], "{index} {channel}: {moves} is not {by_line}");
                loads[channel].push(change);
            }
            let line = Line {
                within: 0.5 * STEP,
                compliance: responses.channels[1].from_loads[0][0][0],
                size,
            };
            let found = constants.wrong(&bottom, cut, &line);
            prop_assert!(found.is_none(), "{index}: {found:?} {cut:?}");
            bottom.end_step(cut);
        }
    }
}
