//! Motions of a string in which no speed changes: steady rotation, and the steady winding of a
//! string whose bit is held. A case may begin in either, without the waves of a start from rest.
//!
//! With θ(x, t) = a(x) + ω(x) t the wave equation leaves (GJ a′)′ + t (GJ ω′)′ = c_t ω, so that
//! GJ ω′ is the same all along the string: the speed falls from the surface to the bit by as
//! much of the flexibility 1/(GJ) as lies above, and the torque grows everywhere at the one
//! rate −GJ ω′. In steady rotation that rate is zero. Below a top drive with the gains K_p and
//! K_i the error e of its speed is constant, and K_i e is the rate at which its torque grows.
//!
//! ```
//! use linear::estimates::winding_stiffness;
//! use linear::steady::{rotation, winding};
//! use linear::{Drillstring, Material, Section, Sites, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 1000.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! // Without damping the surface bears the torque of the bit, and the bit turns as fast as it.
//! let turning = rotation(&string, &Sites::bit(), 6.0, 1000.0);
//! assert_eq!((turning.speeds[0], turning.at_surface.torque), (6.0, 1000.0));
//! // Where the bit is held, the torque of the surface grows at k_eff Ω.
//! let held = winding(&string, &Sites::bit(), 6.0, 1000.0);
//! assert!((held.at_surface.rate / (6.0 * winding_stiffness(&string)) - 1.0).abs() < 1e-9);
//! # Ok::<(), linear::DrillstringError>(())
//! ```

use crate::drillstring::Drillstring;
use crate::estimates::{torsional_resistance, torsional_stiffness, winding_stiffness};
use crate::in_mud::{self, Alike};
use crate::sites::Sites;

/// A motion in which no speed changes and torques grow evenly.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyMotion {
    /// Rotation speed of each site, from the surface down, rad/s.
    pub speeds: Vec<f64>,
    /// Torque on the bit.
    pub at_bit: GrowingTorque,
    /// Torque with which the surface is turned, below a top drive that of its motor.
    pub at_surface: GrowingTorque,
}

/// A torque that grows evenly, positive in the direction of rotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrowingTorque {
    /// At t = 0, N m.
    pub torque: f64,
    /// N m/s.
    pub rate: f64,
}

impl GrowingTorque {
    /// The torque at a time (s), N m.
    pub fn at(&self, time: f64) -> f64 {
        self.torque + self.rate * time
    }
}

/// Speed (rad/s) at which a string rotates as a whole whose surface is set to `surface_speed`
/// (rad/s), against a `torque` (N m) on its bit. Only a top drive without integral gain
/// falls behind its set speed; one that cannot turn the string leaves it at rest.
pub fn rotation_speed(string: &Drillstring, surface_speed: f64, torque: f64) -> f64 {
    let Some(drive) = string
        .top_drive()
        .filter(|drive| drive.integral_gain == 0.0)
    else {
        return surface_speed;
    };
    let damping = torsional_resistance(string);
    let speed = (drive.proportional_gain * surface_speed.abs() - torque)
        / (drive.proportional_gain + damping);
    speed.max(0.0).copysign(surface_speed)
}

/// Steady rotation against `torque` (N m) on the bit, the surface set to `surface_speed`, rad/s.
pub fn rotation(
    string: &Drillstring,
    sites: &Sites,
    surface_speed: f64,
    torque: f64,
) -> SteadyMotion {
    let speed = rotation_speed(string, surface_speed, torque);
    let damping = torsional_resistance(string);
    let against = -torque.copysign(surface_speed);
    SteadyMotion {
        speeds: vec![speed; sites.len()],
        at_bit: GrowingTorque {
            torque: against,
            rate: 0.0,
        },
        at_surface: GrowingTorque {
            torque: damping * speed - against,
            rate: 0.0,
        },
    }
}

/// Steady winding of a string whose bit is held, the surface set to `surface_speed` (rad/s): at
/// t = 0 the bit is held by `torque`, N m. Below a top drive without integral gain, whose torque
/// does not grow, the string is wound up and at rest.
pub fn winding(
    string: &Drillstring,
    sites: &Sites,
    surface_speed: f64,
    torque: f64,
) -> SteadyMotion {
    let stiffness = torsional_stiffness(string);
    let rate = winding_stiffness(string) * surface_speed;
    let speed_of_surface = rate / stiffness;
    let below = |distance: f64| flexibility_below(string, distance);
    let speeds = (sites.distances_from_bit().iter())
        .map(|&distance| speed_of_surface * stiffness * below(distance).flexibility)
        .collect();
    // c_t ∫ω dx, the speed growing with the flexibility below.
    let mut dragged = string.torsional_damping() * rate * below(string.length()).moment;
    if string.loss().viscous_mud().is_some() {
        dragged += rate * held_back_by_mud(string);
    }
    let held = torque.copysign(surface_speed);
    SteadyMotion {
        speeds,
        at_bit: GrowingTorque {
            torque: -held,
            rate: -rate,
        },
        at_surface: GrowingTorque {
            torque: held + dragged,
            rate,
        },
    }
}

/// The flexibility between the bit and a place, and its integral up to there.
struct Below {
    /// ∫ dx/(GJ), rad per N m.
    flexibility: f64,
    /// ∬ dx dx/(GJ), rad m per N m.
    moment: f64,
}

fn flexibility_below(string: &Drillstring, distance: f64) -> Below {
    let modulus = string.modulus();
    let (mut flexibility, mut moment, mut left) = (0.0, 0.0, distance);
    for section in string.sections().iter().rev() {
        for tube in (0..section.repeat).flat_map(|_| section.parts.iter().rev()) {
            let length = tube.length.min(left);
            if length <= 0.0 {
                return Below {
                    flexibility,
                    moment,
                };
            }
            let per_length = 1.0 / (modulus * string.section_constant(tube));
            moment += length * (flexibility + 0.5 * length * per_length);
            flexibility += length * per_length;
            left -= length;
        }
    }
    Below {
        flexibility,
        moment,
    }
}

/// What viscous mud takes of the torque per rate at which it grows, s: ∫ c(0) ∫ dx dx/(GJ).
fn held_back_by_mud(string: &Drillstring) -> f64 {
    let modulus = string.modulus();
    let (mut held_back, mut flexibility) = (0.0, 0.0);
    for Alike {
        length, tube, mud, ..
    } in in_mud::one_by_one(string).into_iter().rev()
    {
        let per_length = 1.0 / (modulus * string.section_constant(&tube));
        let drag = mud.map_or(0.0, |mud| mud.steady_drag(string.channel()));
        held_back += drag * length * (flexibility + 0.5 * length * per_length);
        flexibility += length * per_length;
    }
    held_back
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Hole, HoleSection, Material, Mud, Section, TopDrive, Tube};

    const STEEL: Material = Material {
        shear_modulus: 80e9,
        density: 7840.0,
    };

    fn tube(length: f64, outer_radius: f64) -> Tube {
        Tube {
            length,
            inner_radius: 0.05,
            outer_radius,
        }
    }

    fn string() -> Drillstring {
        let pipe = Section {
            repeat: 90,
            parts: vec![tube(9.5, 0.07), tube(0.5, 0.09)],
        };
        let collar = Section {
            repeat: 1,
            parts: vec![tube(100.0, 0.1)],
        };
        Drillstring::new(STEEL, vec![pipe, collar], 3.0).unwrap()
    }

    const DRIVE: TopDrive = TopDrive {
        inertia: 2000.0,
        proportional_gain: 4000.0,
        integral_gain: 1500.0,
        delay: 0.0,
        late_inertia: 0.0,
    };

    /// A uniform tube: ω grows linearly from the bit, and damping takes c_t L Ω/2.
    #[test]
    fn a_uniform_tube_winds_up_along_a_straight_line() {
        let uniform = Section {
            repeat: 1,
            parts: vec![tube(800.0, 0.08)],
        };
        let string = Drillstring::new(STEEL, vec![uniform], 3.0).unwrap();
        let sites = Sites::new(&string, &[200.0, 0.0]).unwrap();
        let motion = winding(&string, &sites, 2.0, 5000.0);
        assert!((motion.speeds[0] - 0.5).abs() < 1e-12);
        assert_eq!(motion.speeds[1], 0.0);
        let dragged = motion.at_surface.torque - 5000.0;
        assert!((dragged - 3.0 * 800.0).abs() < 1e-8, "{dragged}");
        let rate = 2.0 * torsional_stiffness(&string);
        assert!((motion.at_surface.rate / rate - 1.0).abs() < 1e-12);
        assert_eq!(motion.at_bit.rate, -motion.at_surface.rate);
    }

    /// Power in, by surface and bit, is what damping takes and the string stores.
    #[test]
    fn no_energy_is_lost_or_made() {
        let string = string();
        // The surface itself is no site.
        let place = |index: i32| (0.5 * f64::from(2000 - index)).min(999.99);
        let places: Vec<f64> = (0..=2000).map(place).collect();
        let sites = Sites::new(&string, &places).unwrap();
        let motion = winding(&string, &sites, 1.3, 4000.0);
        let squares: Vec<f64> = motion.speeds.iter().map(|speed| speed * speed).collect();
        let taken: f64 = squares
            .windows(2)
            .map(|ends| 0.5 * 0.5 * (ends[0] + ends[1]) * string.torsional_damping())
            .sum();
        // ∫ T ω′ dx with T = T_bit + c_t ∫ω from the bit up.
        let mut torque = 4000.0;
        let mut stored = 0.0;
        for ends in motion.speeds.windows(2).rev() {
            let dragged = 0.5 * 0.5 * (ends[0] + ends[1]) * string.torsional_damping();
            stored += (torque + 0.5 * dragged) * (ends[0] - ends[1]);
            torque += dragged;
        }
        let power = motion.at_surface.torque * 1.3;
        assert!(
            (power / (taken + stored) - 1.0).abs() < 1e-4,
            "{power} {taken} {stored}"
        );
    }

    /// K_i e is the rate at which the torque grows, for the error e of the speed.
    #[test]
    fn a_top_drive_winds_up_with_a_constant_error_of_its_speed() {
        let string = string().with_top_drive(DRIVE).unwrap();
        let top = Sites::new(&string, &[string.length() - 1e-3, 0.0]).unwrap();
        let motion = winding(&string, &top, 6.0, 4000.0);
        let error = 6.0 - motion.speeds[0];
        assert!((DRIVE.integral_gain * error / motion.at_surface.rate - 1.0).abs() < 1e-5);
    }

    #[test]
    fn a_drive_without_integral_gain_falls_behind_its_speed() {
        let weak = TopDrive {
            integral_gain: 0.0,
            ..DRIVE
        };
        let string = string().with_top_drive(weak).unwrap();
        let motion = rotation(&string, &Sites::bit(), 6.0, 5000.0);
        let speed = motion.speeds[0];
        let pulled = weak.proportional_gain * (6.0 - speed);
        assert!((pulled / motion.at_surface.torque - 1.0).abs() < 1e-12);
        assert_eq!(rotation_speed(&string, 1.0, 5000.0), 0.0);
        assert_eq!(
            winding(&string, &Sites::bit(), 6.0, 5000.0).at_bit.rate,
            0.0
        );
    }

    /// As much constant damping, where mud is alike everywhere.
    #[test]
    fn mud_holds_steady_motions_back_as_its_couette_flow_does() {
        let uniform = Section {
            repeat: 3,
            parts: vec![tube(300.0, 0.08)],
        };
        let plain = |damping| Drillstring::new(STEEL, vec![uniform.clone()], damping).unwrap();
        let sections = [500.0, 500.0].map(|length| HoleSection {
            length,
            radius: 0.11,
        });
        let hole = Hole {
            sections: sections.to_vec(),
            mud: Mud {
                density: 1200.0,
                viscosity: 40.0,
            },
        };
        let in_mud = plain(1.0).in_hole(hole).unwrap();
        let [own, wall] = [0.08_f64, 0.11].map(|radius| radius * radius);
        let couette = 4.0 * std::f64::consts::PI * 40.0 * own * wall / (wall - own);
        let damped = plain(1.0 + couette);
        let sites = Sites::bit();
        for motion in [rotation, winding] {
            let [one, other] =
                [&in_mud, &damped].map(|it| motion(it, &sites, 2.0, 5000.0).at_surface.torque);
            assert!((one / other - 1.0).abs() < 1e-12, "{one} {other}");
        }
    }
}
