//! How deep a wall gives way, and whether rock bears that.
//!
//! A wall answers with F = k_c δ^1.5, as Hertz has it of two bodies that touch at a point. Here their
//! patch is taken as round, of the radius √(R δ) that the radius R of the string there gives: a blade
//! that touches along its length has a longer patch and presses less, one that touches with an edge
//! more. Below a sphere rock begins to yield where the mean pressure on it, F/πRδ, is 1.1 times its
//! strength, and yields all around from 3 times on (K. L. Johnson, *Contact Mechanics*, 1985, 6.1 and
//! 6.3); the strength is the intrinsic specific energy ε of the file's rock, which is about that of an
//! unconfined sample (T. Richard et al., Engineering Geology 147–148, 2012). The wall breaks from 3
//! times on, and from 1.1 times on where it gives way by more than its clearance, so that the string
//! moves in what it has pressed out more than in its hole.
//!
//! ```
//! use campaign::records::WallPush;
//! use sim::{Push, Wall};
//!
//! let wall = Wall {
//!     clearance: 1.6e-3,
//!     stiffness: 1e9,
//!     friction: 0.3,
//!     dynamic_ratio: 1.0,
//!     stribeck_speed: 0.0,
//!     radius: 0.15,
//! };
//! let hardest = Push { normal_force: 1e6, site: 0 };
//! let push = WallPush::new(&hardest, 4.7, &wall, 60e6);
//! assert!((push.depth - 0.01).abs() < 1e-12);
//! assert_eq!(push.breaks, Some(true));
//! ```

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};
use sim::{Push, Rock, Wall};

use crate::quantities::{FORCE, LENGTH, STRESS, Units, WIDTH};
use crate::words::short;

/// Depth, mm, below which two decimals are too few.
const SHALLOW: f64 = 0.1;

/// Mean pressures by the strength of the rock: at first yield, and where all around yields.
const FIRST_YIELD: f64 = 1.1;
const FULL_YIELD: f64 = 3.0;

/// The hardest push of a string into its wall, and what rock would make of it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WallPush {
    /// Where it is, m from the bit.
    pub from_bit: f64,
    /// How deep the wall gives way, m; zero of a rigid one.
    pub depth: f64,
    /// The normal force that answers, N; none in records of earlier versions of a rigid wall.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub force: Option<f64>,
    /// The mean pressure on the patch, Pa.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressure: Option<f64>,
    /// Whether that breaks the rock.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub breaks: Option<bool>,
}

impl WallPush {
    /// Push of a place (m from the bit) into a wall of rock of a strength, Pa.
    pub fn new(hardest: &Push, from_bit: f64, wall: &Wall, strength: f64) -> Self {
        let force = hardest.normal_force;
        let depth = (force / wall.stiffness).powf(2.0 / 3.0);
        // A rigid wall has no patch.
        let pressure = Some(force / (PI * wall.radius * depth)).filter(|it| it.is_finite());
        let bears = match depth > wall.clearance {
            true => FIRST_YIELD * strength,
            false => FULL_YIELD * strength,
        };
        Self {
            from_bit,
            depth,
            force: Some(force),
            pressure,
            breaks: pressure.map(|pressure| pressure > bears),
        }
    }
}

impl WallPush {
    /// The push as it is read back from the columns of a table: counts of it are then those of merged tables.
    pub fn as_in_table(self) -> Self {
        Self {
            depth: 1e-3 * (1e3 * self.depth),
            force: self.force.map(|force| 1e3 * (1e-3 * force)),
            pressure: self.pressure.map(|pressure| 1e6 * (1e-6 * pressure)),
            ..self
        }
    }

    /// Whether it is into a rigid wall, of which only the force is known.
    pub fn is_on_rigid(&self) -> bool {
        self.depth == 0.0
    }

    /// The push, and whether rock bears it, in a sentence.
    pub fn sentence(&self, units: Units) -> String {
        let breaks = match self.breaks {
            Some(true) => {
                "; its rock would break there, and the hole is no longer that of the model"
            }
            None if self.is_on_rigid() => {
                "; the wall is rigid, and what that does to its rock is not known"
            }
            _ => "",
        };
        format!("hardest push into a wall {}{breaks}", self.words(units))
    }

    /// How deep it is, where, with what force and pressure.
    pub fn words(&self, units: Units) -> String {
        let [width, length, force, stress] =
            [&WIDTH, &LENGTH, &FORCE, &STRESS].map(|twin| units.of(twin));
        let place = length.text(self.from_bit, 1);
        let depth = 1e3 * self.depth;
        let mut words = match depth {
            0.0 => format!("{place} from the bit"),
            SHALLOW.. => format!("{} deep, {place} from the bit", width.text(depth, 2)),
            _ => {
                let depth = short(width.number(depth));
                format!("{depth} {} deep, {place} from the bit", width.name)
            }
        };
        if let Some(newtons) = self.force {
            words += &format!(", under {}", force.text(1e-3 * newtons, 0));
        }
        if let Some(pressure) = self.pressure {
            let pressure = stress.text(1e-6 * pressure, 0);
            words += &format!(", {pressure} in the mean (by Hertz, on a round patch)");
        }
        words
    }
}

/// Strength of a rock (Pa): its intrinsic specific energy; where it has none, as by a table of torques,
/// or there is no rock, that of the program's sandstone.
pub fn strength(specific_energy: Option<f64>) -> f64 {
    specific_energy.unwrap_or_else(|| match Rock::sandstone() {
        Rock::Law(law) => law.specific_energy,
        _ => f64::INFINITY,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(clearance: f64, stiffness: f64) -> Wall {
        Wall {
            clearance,
            stiffness,
            friction: 0.3,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.1,
        }
    }

    /// By Hertz the mean pressure grows with the root of the depth, k √δ/πR: a string of 0.1 m in a wall
    /// of 1 GN/m^1.5 begins to make rock of 60 MPa yield at 0.43 mm, and all around at 3.2 mm.
    #[test]
    fn rock_yields_at_the_depths_of_hertz() {
        let depth_at = |times: f64| (times * 60e6 * PI * 0.1 / 1e9_f64).powi(2);
        for (clearance, times) in [(1e-4, 1.1), (0.05, 3.0)] {
            for (part, breaks) in [(0.99, false), (1.01, true)] {
                let depth = part * depth_at(times);
                let normal_force = 1e9 * depth.powf(1.5);
                let hardest = Push {
                    normal_force,
                    site: 0,
                };
                let push = WallPush::new(&hardest, 0.0, &wall(clearance, 1e9), 60e6);
                let pressure = 1e9 * depth.sqrt() / (PI * 0.1);
                assert!((push.pressure.unwrap() / pressure - 1.0).abs() < 1e-12);
                assert_eq!(push.breaks, Some(breaks), "{push:?}");
            }
        }
    }

    #[test]
    fn a_rigid_wall_says_nothing_of_rock() {
        let hardest = Push {
            normal_force: 3e4,
            site: 0,
        };
        let push = WallPush::new(&hardest, 0.0, &wall(0.05, f64::INFINITY), 60e6);
        assert_eq!((push.depth, push.force), (0.0, Some(3e4)));
        assert_eq!((push.pressure, push.breaks), (None, None));
        let words = push.sentence(Units::default());
        assert!(words.starts_with(
            "hardest push into a wall 0.0 m from the bit, under 30 kN; the wall is rigid"
        ));
    }
}
