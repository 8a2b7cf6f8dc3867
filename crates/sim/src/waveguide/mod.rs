//! Torsional waves handed on in time along delay lines, without any response: between
//! two nodes a wave only travels, and at a node impedance steps scatter it and the damping of half
//! of both neighbouring pieces acts on it. The bit's law is solved in every step, by separate code,
//! independent of the linear methods and of the stepper, which can so be held to it.
//!
//! ```
//! use linear::{Drillstring, Material, Section, Tube};
//! use sim::waveguide::{Friction, Waveguide};
//!
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! let law = Friction { torque_static: 1200.0, torque_dynamic: 1000.0 };
//! // Its bit held, it is wound up at 0.02 rad/s until that breaks loose.
//! let mut waves = Waveguide::new(&string, 500.0, law);
//! let held = (0..).take_while(|_| waves.advance(0.02, false) == 0.0).count();
//! let stiffness = linear::estimates::torsional_stiffness(&string);
//! let wound = 1200.0 / (0.02 * stiffness);
//! assert!((held as f64 * waves.step / wound - 1.0).abs() < 0.02);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod motor;
mod wound;

use linear::Drillstring;
use linear::estimates::torsional_impedance;

use motor::Motor;
use wound::{Reach, Wound};

/// A string at rest, its bit held.
pub struct Waveguide {
    /// Step, s.
    pub step: f64,
    stretches: Vec<Stretch>,
    reaches: Vec<Reach>,
    /// Waves in speed on their way down and up each stretch, in rings: what leaves a node
    /// arrives at the next when the ring has gone round.
    down: Vec<f64>,
    up: Vec<f64>,
    /// What turns the surface, where that is not set as prescribed.
    drive: Option<Motor>,
    /// Speed of the bit per wave that arrives there, and of that per torque left.
    bit: [f64; 2],
    law: Friction,
}

/// A row of steps of travel below a node.
struct Stretch {
    /// Its ring, and where that is.
    first: usize,
    end: usize,
    place: usize,
    /// What waves from above and from below make of the speed of the node above it.
    gains: [f64; 2],
}

/// Stuck up to one torque, sliding against another.
#[derive(Debug, Clone, Copy)]
pub struct Friction {
    /// N m.
    pub torque_static: f64,
    /// N m.
    pub torque_dynamic: f64,
}

/// Pieces of one impedance (N m s/rad) between two nodes.
struct Row {
    pieces: usize,
    impedance: f64,
}

impl Waveguide {
    /// A string cut into pieces, at least as many as `places` and none longer than its shortest
    /// part, with damping in about that many places.
    pub fn new(string: &Drillstring, places: f64, law: Friction) -> Self {
        let parts: Vec<(f64, f64)> = (string.sections().iter())
            .flat_map(|section| (0..section.repeat).flat_map(|_| &section.parts))
            .map(|part| (part.length, torsional_impedance(string, part)))
            .collect();
        let piece = best_piece(&parts, places);
        let longest = ((string.length() / (places * piece)).round() as usize).max(1);
        let rows = rows(&parts, piece, longest);
        let damping = |row: &Row| 0.5 * string.torsional_damping() * row.pieces as f64 * piece;
        let (mut stretches, mut first) = (Vec::new(), 0);
        let mut above: Option<&Row> = None;
        for row in &rows {
            let gains = above.map_or([0.0; 2], |above| {
                let taken = damping(above) + damping(row);
                [above.impedance, row.impedance]
                    .map(|one| 2.0 * one / (above.impedance + row.impedance + taken))
            });
            let end = first + row.pieces;
            stretches.push(Stretch {
                first,
                end,
                place: first,
                gains,
            });
            (first, above) = (end, Some(row));
        }
        let step = piece / string.torsional_wave_speed();
        let drive = string.top_drive().zip(rows.first());
        let drive = drive.map(|(drive, row)| Motor::new(&drive, row.impedance, damping(row), step));
        let bit = above.map_or([0.0; 2], |last| {
            [2.0 * last.impedance, 1.0 / (last.impedance + damping(last))]
        });
        let [down, up] = at_rest(first);
        let reach = |row: &Row| Reach {
            pieces: row.pieces,
            impedance: row.impedance,
            damping: damping(row),
        };
        Self {
            step,
            stretches,
            reaches: rows.iter().map(reach).collect(),
            down,
            up,
            drive,
            bit,
            law,
        }
    }

    /// Waveguide below a drive that gives no more than a torque, N m.
    pub fn limited(self, torque: f64) -> Self {
        let drive = self.drive.map(|drive| drive.limited(torque));
        Self { drive, ..self }
    }

    /// The same wound up steadily by a surface that is set to a speed (rad/s), the bit held by a
    /// torque (N m) in the first step.
    pub fn wound_up(mut self, set_speed: f64, torque: f64) -> Self {
        let gain = self.drive.as_ref().map(Motor::integral_gain);
        let wound = Wound::new(&self.reaches, self.step, set_speed, torque, gain);
        if let Some(drive) = &mut self.drive {
            drive.turn(set_speed, &wound);
        }
        Self {
            down: wound.down,
            up: wound.up,
            ..self
        }
    }

    /// One step under a surface that turns at a speed (rad/s), of a bit that turned or was
    /// held; gives the bit's speed, zero when it is held.
    pub fn advance(&mut self, surface_speed: f64, turned: bool) -> f64 {
        let (mut arrived, mut left_at) = (0.0, None);
        for stretch in &mut self.stretches {
            let place = stretch.place;
            let (down, up) = (self.down[place], self.up[place]);
            let speed = match left_at {
                None => match &mut self.drive {
                    None => surface_speed,
                    Some(drive) => drive.advance(surface_speed, up),
                },
                Some(above) => {
                    let [from_above, from_below] = stretch.gains;
                    let speed = from_above * arrived + from_below * up;
                    self.up[above] = speed - arrived;
                    speed
                }
            };
            self.down[place] = speed - up;
            (arrived, left_at) = (down, Some(place));
            stretch.place = if place + 1 == stretch.end {
                stretch.first
            } else {
                place + 1
            };
        }
        let [torque_of, compliance] = self.bit;
        let speed = compliance * self.law.left(torque_of * arrived, turned);
        if let Some(above) = left_at {
            self.up[above] = speed - arrived;
        }
        speed
    }
}

/// Waves down and up a string of a number of pieces that does not move.
fn at_rest(pieces: usize) -> [Vec<f64>; 2] {
    [vec![0.0; pieces], vec![0.0; pieces]]
}

impl Friction {
    /// What rock leaves of a torque (N m) on a bit that turned forwards, or was held.
    fn left(self, torque: f64, turned: bool) -> f64 {
        let forwards = torque - self.torque_dynamic;
        if turned && forwards > 0.0 {
            forwards
        } else if torque.abs() <= self.torque_static {
            0.0
        } else {
            torque - self.torque_dynamic * torque.signum()
        }
    }
}

/// Parts (length in m and impedance) in pieces, none longer than `longest` of them; ends
/// are where they are, to half a piece.
fn rows(parts: &[(f64, f64)], piece: f64, longest: usize) -> Vec<Row> {
    let (mut rows, mut place, mut pieces) = (Vec::new(), 0.0, 0);
    for &(length, impedance) in parts {
        place += length;
        let end = ((place / piece).round() as usize).max(pieces);
        let count = end - pieces;
        let cuts = count.div_ceil(longest);
        rows.extend((0..cuts).map(|cut| Row {
            pieces: count * (cut + 1) / cuts - count * cut / cuts,
            impedance,
        }));
        pieces = end;
    }
    rows
}

/// The length of a piece (m) for which parts are best whole numbers of pieces long.
fn best_piece(parts: &[(f64, f64)], places: f64) -> f64 {
    let total: f64 = parts.iter().map(|part| part.0).sum();
    let mut lengths: Vec<f64> = parts.iter().map(|part| part.0).collect();
    lengths.sort_by(f64::total_cmp);
    lengths.dedup();
    let misfit = |piece: f64| {
        let of = |length: &f64| ((length / piece).round() * piece - length).abs() / length;
        lengths.iter().map(of).fold(0.0, f64::max)
    };
    let longest = lengths[0].min(total / places);
    let pieces = (0..TRIED).map(|index| longest / (1.0 + FINEST * index as f64 / TRIED as f64));
    let best = pieces.min_by(|one, other| misfit(*one).total_cmp(&misfit(*other)));
    best.unwrap_or(longest)
}

/// Lengths of pieces that are tried, down to a fourth of the longest.
const TRIED: usize = 20_000;
const FINEST: f64 = 3.0;

#[cfg(test)]
mod tests {
    use super::*;
    use linear::estimates::{torsional_travel_time, torsional_wave_left};
    use linear::{Material, Section, TopDrive, Tube};

    fn string(lengths: &[(f64, f64)]) -> Drillstring {
        let steel = Material {
            shear_modulus: 80e9,
            density: 7840.0,
        };
        let tube = |&(length, outer_radius): &(f64, f64)| Section {
            repeat: 1,
            parts: vec![Tube {
                length,
                inner_radius: 0.05,
                outer_radius,
            }],
        };
        Drillstring::new(steel, lengths.iter().map(tube).collect(), 10.0).unwrap()
    }

    /// A free bit is at rest until a wave arrives, then has twice what damping left of it.
    #[test]
    fn a_front_arrives_when_it_does_with_what_damping_leaves() {
        let string = string(&[(700.0, 0.12)]);
        let free = Friction {
            torque_static: 0.0,
            torque_dynamic: 0.0,
        };
        let mut guide = Waveguide::new(&string, 1000.0, free);
        let travel = (torsional_travel_time(&string) / guide.step).round() as usize;
        let speeds: Vec<f64> = (0..=travel).map(|_| guide.advance(1.0, true)).collect();
        assert_eq!(speeds[travel - 1], 0.0);
        let front = 2.0 * torsional_wave_left(&string);
        assert!(
            (speeds[travel] / front - 1.0).abs() < 1e-3,
            "{}",
            speeds[travel]
        );
    }

    /// A string in the middle of its winding continues as steadily: the bit breaks loose when its
    /// torque, which grows by k Ω, is T_s, and moves all of a sudden as its impedance says.
    #[test]
    fn a_string_that_is_wound_up_continues_to_wind_up() {
        let law = Friction {
            torque_static: 5000.0,
            torque_dynamic: 4000.0,
        };
        let plain = string(&[(300.0, 0.1), (77.0, 0.13)]);
        let drive = TopDrive {
            inertia: 800.0,
            proportional_gain: 3000.0,
            integral_gain: 900.0,
            delay: 0.0,
            late_inertia: 0.0,
        };
        let driven = plain.clone().with_top_drive(drive).unwrap();
        for string in [plain, driven] {
            let (speed, begun) = (2.0, 3000.0);
            let mut guide = Waveguide::new(&string, 1000.0, law).wound_up(speed, begun);
            let speeds = (0..).map(|_| guide.advance(speed, false));
            let (first, found) = speeds.enumerate().find(|(_, it)| *it != 0.0).unwrap();
            let rate = linear::estimates::winding_stiffness(&string) * speed;
            let time = first as f64 * guide.step;
            assert!((time / (2000.0 / rate) - 1.0).abs() < 0.01, "{time}");
            let tube = string.sections()[1].parts[0];
            let jump = 1000.0 / torsional_impedance(&string, &tube);
            assert!((found / jump - 1.0).abs() < 0.01, "{found} {jump}");
        }
    }

    /// The torque of a held bit winds up at the string's stiffness, and it slips when that
    /// is T_s.
    #[test]
    fn a_held_bit_slips_when_the_torque_is_there() {
        let string = string(&[(300.0, 0.1), (77.0, 0.13)]);
        let law = Friction {
            torque_static: 3000.0,
            torque_dynamic: 2000.0,
        };
        let mut guide = Waveguide::new(&string, 1000.0, law);
        let speed = 0.02;
        let first = (0..).find(|_| guide.advance(speed, false) != 0.0).unwrap();
        let stiffness = linear::estimates::torsional_stiffness(&string);
        let time = first as f64 * guide.step;
        let wound = 3000.0 / (stiffness * speed);
        assert!((time / wound - 1.0).abs() < 0.02, "{time} {wound}");
    }
}
