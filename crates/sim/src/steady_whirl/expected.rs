//! The rate of whirl to expect at a wall, of a string that is known only next to it.

use super::Balance;
use crate::laws::wall::Wall;

/// A rate is found to this part of the fastest.
const TOLERANCE: f64 = 1e-6;

/// Rate of whirl to expect, rad/s, where a string rolls along a wall at a surface speed (rad/s). The
/// stiffness (N/m) at a rate is that of [`linear::estimates::bending_wave_stiffness`].
///
/// A string has many balances of rolling, one between any two of its resonances. The least friction
/// sustains the one at which the wall, κ = k_c (r − c)^(3/2)/r, is as stiff as the string is to waves that
/// do not come back: far below it a balance lies near a resonance, far above near an antiresonance, and
/// damping takes more. On one site it is 0.98 to 1.5 times the rate that lasts with a wall of
/// 1 GN/m^1.5, and 1.3 to 2.1 times with one of 100. At a rigid wall it is the rate at r = c.
pub fn expected_rate(wall: &Wall, surface_speed: f64, stiffness: impl Fn(f64) -> f64) -> f64 {
    let balance = Balance::new(wall, surface_speed);
    let fastest = surface_speed * wall.radius / wall.clearance;
    let (mut low, mut high) = (0.0, fastest);
    while high - low > TOLERANCE * fastest {
        let middle = 0.5 * (low + high);
        if balance.inward(middle) > stiffness(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

#[cfg(test)]
mod tests {
    use linear::estimates::bending_wave_stiffness;
    use linear::waves::lateral::BendingNetwork;
    use linear::{Bending, Drillstring, Material, Section, Sites, SurfaceSupport, Tube};

    use super::*;

    fn wall(stiffness: f64) -> Wall {
        Wall {
            clearance: 2e-3,
            stiffness,
            friction: 0.3,
            dynamic_ratio: 1.0,
            stribeck_speed: 0.0,
            radius: 0.15,
        }
    }

    #[test]
    fn a_rigid_wall_is_rolled_along_and_a_soft_one_gives_way_as_much_as_the_string() {
        let speed = 12.0;
        let rigid = expected_rate(&wall(f64::INFINITY), speed, |_| 1e8);
        assert!((rigid / (speed * 0.15 / 2e-3) - 1.0).abs() < 1e-5);
        let soft = expected_rate(&wall(1e9), speed, |_| 4e7);
        let radius = speed * 0.15 / soft;
        let force = 1e9 * (radius - 2e-3).powf(1.5);
        assert!((force / (4e7 * radius) - 1.0).abs() < 1e-4, "{soft}");
        assert_eq!(expected_rate(&wall(1e9), 0.0, |_| 4e7), 0.0);
    }

    /// Damped so much that no wave comes back from where it ends, and so little that it does not matter here.
    #[test]
    fn a_long_beam_yields_to_waves_as_its_exact_stiffness_says() {
        let tube = Tube {
            length: 400.0,
            inner_radius: 0.04,
            outer_radius: 0.1,
        };
        let steel = Material {
            shear_modulus: 80e9,
            density: 7850.0,
        };
        let parts = vec![tube];
        let string = Drillstring::new(steel, vec![Section { repeat: 1, parts }], 1.0).unwrap();
        let rate = 300.0;
        let bending = Bending {
            youngs_modulus: 206e9,
            damping: 0.05 * rate * steel.density * tube.area(),
            compression: 0.0,
        };
        for distance in [0.0, 200.0] {
            let sites = Sites::new(&string, &[distance]).unwrap();
            let support = SurfaceSupport::Clamped;
            let network = BendingNetwork::new(&string, bending, support, &sites).unwrap();
            let [real, imaginary] = network.dynamic_stiffness(0, rate);
            let found = bending_wave_stiffness(&string, &bending, distance, rate);
            assert!(
                (found / real.hypot(imaginary) - 1.0).abs() < 0.01,
                "{distance}: {found}"
            );
        }
    }
}
