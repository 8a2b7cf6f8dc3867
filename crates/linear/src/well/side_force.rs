//! How a string presses on the wall of its well: it lies there as one without stiffness in
//! bending would (C. A. Johancsik, D. B. Friesen and R. Dawson, "Torque and drag in directional
//! wells: prediction and measurement", *Journal of Petroleum Technology* 36, 1984, 987–992), while
//! it turns, so that friction does not hold it along the well.

use super::GRAVITY;
use super::quasi_static_twist::{QuasiStaticTwist, Stretch};
use super::short_lengths::{ShortLength, short_lengths};
use super::supports::supports;
use super::survey::{Survey, Vector, combine, length};
use crate::drillstring::{Drillstring, Section};
use crate::surroundings::Mud;

/// What is taken to press a string against its well.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum PressedBy {
    /// Its weight across the well, and its tension where that turns.
    WeightAndTension,
    /// Its weight across the well alone.
    Weight,
}

/// What presses the string against the wall, piece by short piece from the surface down. The
/// axial force depends on the weight on bit, and where the well turns so does what presses.
#[derive(Debug, Clone, PartialEq)]
pub struct SideForce {
    pieces: Vec<Piece>,
    /// The weight of all along the well, N.
    hook_load: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    /// Of its middle from the surface, m.
    depth: f64,
    length: f64,
    /// Of what lies on the wall, m.
    radius: f64,
    /// By which a torque twists it, rad per N m and metre.
    compliance: f64,
    /// Tension of a string that hangs free, N.
    tension: f64,
    /// What presses it aside without weight on bit, N/m, and per tension, 1/m.
    pressing: Vector,
    turn: Vector,
}

/// A short length of a string as it lies on the wall.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PressedLength {
    /// Of its middle from the surface, m.
    pub depth: f64,
    /// Its length, m.
    pub length: f64,
    /// Of what lies on the wall, m.
    pub radius: f64,
    /// Tension, N; negative where it is pushed.
    pub tension: f64,
    /// What it presses on the wall with, N/m.
    pub load: f64,
}

impl SideForce {
    /// Of a string in a well that is surveyed at least as deep; in `mud` it is buoyed. Parts lie on
    /// wider ones that carry them, as pipe on its joints, or on themselves where they sag to the wall.
    pub fn new(
        string: &Drillstring,
        survey: &Survey,
        mud: Option<Mud>,
        pressed_by: PressedBy,
    ) -> Self {
        let own = |section: &Section| {
            let parts = section.parts.iter();
            parts.map(|part| part.outer_radius).collect()
        };
        let touching: Vec<Vec<f64>> = string.sections().iter().map(own).collect();
        Self::touching(string, &touching, survey, mud, pressed_by)
    }

    /// The same of a string whose parts touch the wall at other radii than that of their body, as
    /// stabilisers with their blades: `contact_radii` has those of each part of each section, m.
    ///
    /// # Panics
    /// Where there is not a radius for each part.
    pub fn touching(
        string: &Drillstring,
        contact_radii: &[Vec<f64>],
        survey: &Survey,
        mud: Option<Mud>,
        pressed_by: PressedBy,
    ) -> Self {
        let heavier = string.material().density - mud.map_or(0.0, |mud| mud.density);
        let supports = supports(string, contact_radii, heavier);
        let piece = |it: ShortLength| {
            let weight = heavier * it.part.area() * GRAVITY;
            let turn = match pressed_by {
                PressedBy::WeightAndTension => it.turn,
                PressedBy::Weight => [0.0; 3],
            };
            Piece {
                depth: it.depth,
                length: it.length,
                radius: supports[it.part_index].mean_radius(it.depth, it.length),
                compliance: 1.0 / (string.material().shear_modulus * it.part.polar_moment()),
                // Its own weight along the well, for now.
                tension: weight * it.along[2] * it.length,
                pressing: combine(weight, [0.0, 0.0, 1.0], -weight * it.along[2], it.along),
                turn,
            }
        };
        let mut pieces: Vec<_> = short_lengths(string, Some(survey))
            .into_iter()
            .map(piece)
            .collect();
        let mut below = 0.0;
        for piece in pieces.iter_mut().rev() {
            let own = piece.tension;
            piece.tension = below + 0.5 * own;
            below += own;
            piece.pressing = combine(1.0, piece.pressing, piece.tension, piece.turn);
        }
        Self {
            pieces,
            hook_load: below,
        }
    }

    /// Torque that the wall may exert per coefficient of friction, N m, on each of a number of
    /// equal pieces of the string, under a weight on bit (N). A short length of string, up to two
    /// metres, is not divided between two of them ([`QuasiStaticTwist::friction_torques`] does).
    pub fn friction_torques(&self, pieces: usize, weight_on_bit: f64) -> Vec<f64> {
        let mut torques = vec![0.0; pieces];
        let whole = (self.pieces.last()).map_or(0.0, |last| last.depth + 0.5 * last.length);
        for piece in &self.pieces {
            let place = (piece.depth / whole * pieces as f64) as usize;
            torques[place.min(pieces - 1)] += piece.friction_torque(weight_on_bit);
        }
        torques
    }

    /// The string as it is wound up by its surface under this friction and a weight on bit (N).
    pub fn wound_up(&self, weight_on_bit: f64) -> QuasiStaticTwist {
        let stretches = self.pieces.iter().map(|piece| Stretch {
            length: piece.length,
            torque: piece.friction_torque(weight_on_bit),
            compliance: piece.compliance,
        });
        QuasiStaticTwist::new(stretches)
    }

    /// Each short length of the string under a weight on bit (N), from the surface down.
    pub fn along(&self, weight_on_bit: f64) -> impl Iterator<Item = PressedLength> {
        let pieces = self.pieces.iter();
        pieces.map(move |piece| PressedLength {
            depth: piece.depth,
            length: piece.length,
            radius: piece.radius,
            tension: piece.tension - weight_on_bit,
            load: piece.force(weight_on_bit) / piece.length,
        })
    }

    /// The weight of the string along the well, buoyed, N: what the hook carries above a bit that
    /// is off bottom.
    pub fn hook_load(&self) -> f64 {
        self.hook_load
    }
}

impl Piece {
    /// What it presses with, N.
    fn force(&self, weight_on_bit: f64) -> f64 {
        length(combine(1.0, self.pressing, -weight_on_bit, self.turn)) * self.length
    }

    /// Torque per coefficient of friction, N m.
    fn friction_torque(&self, weight_on_bit: f64) -> f64 {
        self.force(weight_on_bit) * self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::super::survey::Station;
    use super::*;
    use crate::drillstring::{Material, Section, Tube};

    const STEEL: Material = Material {
        shear_modulus: 79.3e9,
        density: 7850.0,
    };

    fn pipe(length: f64) -> Drillstring {
        let pipe = Tube {
            length,
            inner_radius: 0.06,
            outer_radius: 0.07,
        };
        let sections = vec![Section {
            repeat: 1,
            parts: vec![pipe],
        }];
        Drillstring::new(STEEL, sections, 0.0).unwrap()
    }

    fn well(stations: &[[f64; 2]]) -> Survey {
        let station = |[measured_depth, inclination]: &[f64; 2]| Station {
            measured_depth: *measured_depth,
            inclination: inclination.to_radians(),
            azimuth: 1.0,
        };
        Survey::new(stations.iter().map(station).collect()).unwrap()
    }

    /// In a straight well a fraction sin(inclination) of the weight presses, under any tension.
    #[test]
    fn a_straight_well_bears_the_weight_across_it() {
        let string = pipe(1000.0);
        let weight = 7850.0 * string.sections()[0].parts[0].area() * GRAVITY;
        for (inclination, weight_on_bit) in [(0.0, 0.0), (30.0, 0.0), (60.0, 1e5)] {
            let survey = well(&[[0.0, inclination], [1500.0, inclination]]);
            let mud = Some(Mud {
                density: 1570.0,
                viscosity: 0.0,
            });
            let force = SideForce::new(&string, &survey, mud, PressedBy::WeightAndTension);
            let buoyed = weight * 0.8;
            let torques = force.friction_torques(10, weight_on_bit);
            let expected = buoyed * inclination.to_radians().sin() * 100.0 * 0.07;
            for torque in torques {
                assert!(
                    (torque - expected).abs() < 1e-6 * buoyed,
                    "{torque} {expected}"
                );
            }
            let along = buoyed * 1000.0 * inclination.to_radians().cos();
            let off = force.hook_load() / along - 1.0;
            assert!(off.abs() < 1e-12, "{off}");
        }
    }

    /// In an arc in the vertical plane tension lifts the string off the low side: with θ the
    /// inclination, |w sin θ − T/R| presses, T growing upwards by w cos θ.
    #[test]
    fn an_arc_bears_what_tension_leaves_of_the_weight() {
        let (radius, string) = (400.0, pipe(600.0));
        let bend = 600.0 / radius;
        let survey = well(&[[0.0, 0.0], [600.0, f64::to_degrees(bend)]]);
        let weight = 7850.0 * string.sections()[0].parts[0].area() * GRAVITY;
        for weight_on_bit in [0.0, 2e5] {
            let force = SideForce::new(&string, &survey, None, PressedBy::WeightAndTension);
            let found: f64 = force.friction_torques(1, weight_on_bit).iter().sum();
            let steps = 60_000;
            let expected: f64 = (0..steps)
                .map(|index| {
                    let angle = bend * (f64::from(index) + 0.5) / f64::from(steps);
                    let tension = weight * radius * (bend.sin() - angle.sin()) - weight_on_bit;
                    // Building: the wall above holds down what is pulled.
                    (tension / radius - weight * angle.sin()).abs() * 0.07
                })
                .sum::<f64>()
                * 600.0
                / f64::from(steps);
            assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
        }
    }
}
