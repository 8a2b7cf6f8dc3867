//! Steady backward whirl as a balance of forces: what the wall must supply is
//! the dynamic stiffness of the string at the rate of whirl.
//!
//! A string of radius R₀ that rolls at a radius r of its centre goes around at
//! ω = ΩR₀/r against its rotation. The wall must push inward with
//! F_N = −Re K(iω) r and pull along with |Im K(iω)| r, where K is the string's
//! dynamic stiffness at the site. So no friction below |Im K / Re K| sustains
//! it (the receptance condition of H. F. Black, *Journal of Mechanical
//! Engineering Science*, 1968).

use crate::laws::wall::Wall;

/// The radius is found to this fraction of itself.
const TOLERANCE: f64 = 1e-12;

/// Steady rolling backward whirl at one site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyWhirl {
    /// Radius r of the centre, m.
    pub radius: f64,
    /// Rate of precession ω, against the rotation, rad/s.
    pub rate: f64,
    /// Normal force F_N, N.
    pub normal_force: f64,
    /// The least coefficient of friction that sustains it.
    pub least_friction: f64,
}

/// The steady backward whirl of a string that turns at `surface_speed` (rad/s)
/// and touches `wall` there alone; `dynamic_stiffness` gives the real and the
/// imaginary part of K (N/m) at a rate (rad/s). `None` where the string does
/// not press outwards at the rate of rolling along the wall, so that no whirl
/// is steady.
pub fn steady_backward_whirl(
    wall: &Wall,
    surface_speed: f64,
    dynamic_stiffness: impl Fn(f64) -> [f64; 2],
) -> Option<SteadyWhirl> {
    let rate = |radius: f64| surface_speed * wall.radius / radius;
    let outward = |radius: f64| -dynamic_stiffness(rate(radius))[0] * radius;
    if outward(wall.clearance) <= 0.0 {
        return None;
    }
    let inward = |radius: f64| wall.stiffness * (radius - wall.clearance).powf(1.5);
    let (mut low, mut high) = (wall.clearance, wall.clearance);
    if wall.stiffness.is_finite() {
        while inward(high) < outward(high) {
            high += high;
        }
    }
    while high - low > TOLERANCE * high {
        let middle = 0.5 * (low + high);
        if inward(middle) < outward(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let radius = high;
    let [real, imaginary] = dynamic_stiffness(rate(radius));
    Some(SteadyWhirl {
        radius,
        rate: rate(radius),
        normal_force: -real * radius,
        least_friction: (imaginary / real).abs(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A Jeffcott rotor has μ* = 2ζs/(s² − 1) at s = ω/ω_n > 1, and no whirl
    /// below its resonance.
    #[test]
    fn a_jeffcott_rotor_follows_its_closed_form() {
        let (mass, stiffness, ratio) = (50.0, 2e5, 0.1);
        let natural = f64::sqrt(stiffness / mass);
        let damping = 2.0 * ratio * natural * mass;
        let dynamic_stiffness = |rate: f64| [stiffness - mass * rate * rate, damping * rate];
        let wall = |stiffness| Wall {
            clearance: 0.01,
            stiffness,
            friction: 0.0,
            radius: 0.1,
        };
        for s in [1.5, 2.0, 5.0] {
            let speed = s * natural * 0.01 / 0.1;
            let rigid = wall(f64::INFINITY);
            let found = steady_backward_whirl(&rigid, speed, dynamic_stiffness).unwrap();
            assert!((found.rate - s * natural).abs() < 1e-9 * natural);
            let expected = 2.0 * ratio * s / (s * s - 1.0);
            assert!((found.least_friction - expected).abs() < 1e-9);
            // A softer wall gives way: the radius grows, the rate falls.
            let soft = steady_backward_whirl(&wall(1e7), speed, dynamic_stiffness).unwrap();
            assert!(soft.radius > found.radius && soft.rate < found.rate);
            let depth: f64 = soft.radius - 0.01;
            assert!((1e7 * depth.powf(1.5) / soft.normal_force - 1.0).abs() < 1e-6);
        }
        let slow = 0.5 * natural * 0.01 / 0.1;
        assert_eq!(
            steady_backward_whirl(&wall(1e7), slow, dynamic_stiffness),
            None
        );
    }
}
