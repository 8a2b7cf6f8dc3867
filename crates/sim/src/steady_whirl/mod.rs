//! Steady whirl as a balance of forces: what the wall must supply is
//! the dynamic stiffness of the string at the rate of whirl.
//!
//! Where the centre goes around at a rate ω against the rotation, at a radius r,
//! the wall must push inward with F_N = −Re K(iω) r and pull along with
//! |Im K(iω)| r, where K is the string's dynamic stiffness at the site. So no
//! friction below |Im K / Re K| sustains it (the receptance condition of H. F.
//! Black, *Journal of Mechanical Engineering Science*, 1968). A wall that yields
//! by F_N = k_c (r − c)^(3/2) meets that force at one radius r(ω) ≥ c, wherever
//! the string presses outwards (Re K < 0). A string of radius R₀ rolls there if it
//! turns at Ω = ωr/R₀; if it turns faster it slides, with its friction fully used.
//! What it needs it needs of the friction there is: of μ_s where it rolls, and where it slides of
//! less, if friction falls with the speed. So no whirl lasts where μ_s is less than that, however
//! friction falls.
//!
//! So over the rate of whirl the steady whirls of a site are curves, one for each
//! range of rates at which the string presses: [`WhirlingSite::branches`]. Near
//! resonances one surface speed has several: [`WhirlingSite::rolling_at`]. Whirl that
//! slides may need less friction than any that rolls:
//! [`WhirlingSite::least_friction`]. Several sites together may need less than any of them:
//! [`WhirlingSites::least_friction`] is a lower bound of that, and
//! [`WhirlingSites::least_together`] an upper one.
//!
//! An eccentric mass takes the string round with the rotation: [`EccentricString`].
//!
//! A mass on a spring with a damper, K = k − mω² + icω, that rolls round its hole:
//!
//! ```
//! use linear::bending_decay::BendingDecay;
//! use sim::steady_whirl::WhirlingSite;
//! use sim::Wall;
//!
//! let (mass, damping, stiffness) = (100.0, 100.0, 1e4);
//! let site = WhirlingSite {
//!     wall: Wall {
//!         clearance: 0.02,
//!         stiffness: 1e9,
//!         friction: 0.2,
//!         dynamic_ratio: 1.0,
//!         stribeck_speed: 0.0,
//!         radius: 0.1,
//!     },
//!     dynamic_stiffness: |rate: f64| [stiffness - mass * rate * rate, damping * rate],
//!     decay: BendingDecay::constant(0.5 * damping / mass),
//! };
//! let whirls = site.rolling_at(6.0);
//! assert_eq!(whirls.len(), 1);
//! let rate = whirls[0].rate;
//! // It rolls without sliding, ωr = ΩR₀, and friction makes up for what the damper takes.
//! assert!((rate * whirls[0].radius / (6.0 * 0.1) - 1.0).abs() < 1e-9);
//! let least_friction = damping * rate / (mass * rate * rate - stiffness);
//! assert!((whirls[0].least_friction / least_friction - 1.0).abs() < 1e-9);
//! ```

mod balance;
mod branches;
mod contacts;
mod expected;
mod forward;
mod forward_contacts;
mod many_sites;
mod newton;
mod pencil;
mod rolling;
mod together;
mod variation;

use linear::bending_decay::BendingDecay;

use crate::laws::wall::Wall;
use balance::Balance;
pub use branches::MOST_FRICTION;
pub use expected::expected_rate;
pub use forward::{EccentricString, ForwardWhirl, LowestTouch};
pub use forward_contacts::ForwardContacts;
pub use many_sites::{SitesWhirl, WhirlingSites};
pub use together::{WhirlContact, WhirlTogether};
use variation::{Sample, Variation};

/// Whirl is looked for up to a radius of this number of clearances.
const MOST_CLEARANCES: f64 = 1e3;

/// A string whose oscillations decay by a smaller part than this in the time of one
/// radian of whirl counts as undamped: the bounds would be worth nothing, and no
/// string rings so long.
const LEAST_DECAY: f64 = 1e-6;

/// A place where the string touches the wall, and touches it there alone.
#[derive(Debug, Clone)]
pub struct WhirlingSite<K> {
    /// The wall; its friction plays no part.
    pub wall: Wall,
    /// The real and the imaginary part of the string's dynamic stiffness K (N/m) at
    /// a rate (rad/s).
    pub dynamic_stiffness: K,
    /// How fast all oscillations of the string decay at least. Where that is less than a millionth
    /// of the fastest rate no whirl is reported: a string without damping needs no friction to
    /// whirl.
    pub decay: BendingDecay,
}

/// Steady backward whirl at one site.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyWhirl {
    /// Surface speed at which the string rolls along the wall, rad/s; at a higher
    /// one it slides.
    pub surface_speed: f64,
    /// Radius r of the centre, m.
    pub radius: f64,
    /// Rate of precession ω, against the rotation, rad/s.
    pub rate: f64,
    /// Normal force F_N, N.
    pub normal_force: f64,
    /// The least coefficient of friction that sustains it; at the speed at which it slides, where
    /// friction falls with that.
    pub least_friction: f64,
}

fn is_damped(decay: &BendingDecay, fastest: f64) -> bool {
    decay.least() > 0.0 && decay.corner_below(fastest).decay_rate > LEAST_DECAY * fastest
}

impl<K: Fn(f64) -> [f64; 2]> WhirlingSite<K> {
    /// The slowest and the fastest rate of whirl that are looked for where the string
    /// turns at a speed (rad/s); none where it stands still or is not damped.
    fn rates(&self, surface_speed: f64) -> Option<[f64; 2]> {
        let fastest = surface_speed * self.wall.radius / self.wall.clearance;
        let is_damped = is_damped(&self.decay, fastest);
        (is_damped && fastest > 0.0).then_some([fastest / MOST_CLEARANCES, fastest])
    }

    /// Between a rate (rad/s) and faster ones.
    fn variation_above(&self, rate: f64) -> Variation {
        Variation::above(&self.decay, rate)
    }

    fn sample(&self, rate: f64) -> Sample {
        let [real, imaginary] = (self.dynamic_stiffness)(rate);
        Sample {
            rate,
            real,
            imaginary,
        }
    }

    /// The whirl at a rate, where the string presses.
    fn whirl(&self, sample: &Sample) -> SteadyWhirl {
        let radius = radius(&self.wall, -sample.real);
        SteadyWhirl {
            surface_speed: sample.rate * radius / self.wall.radius,
            radius,
            rate: sample.rate,
            normal_force: -sample.real * radius,
            least_friction: (sample.imaginary / sample.real).abs(),
        }
    }
}

/// The radius at which the wall answers a force of `outward` > 0 (N/m) times that
/// radius: the one root of k_c u³ = outward (c + u²), u = √(r − c).
fn radius(wall: &Wall, outward: f64) -> f64 {
    let depth = outward / wall.stiffness;
    if depth == 0.0 {
        return wall.clearance;
    }
    // Above the root, from where Newton's method descends to it.
    let mut root = depth + libm::cbrt(depth * wall.clearance);
    loop {
        let value = root * root * (root - depth) - depth * wall.clearance;
        let next = root - value / (root * (3.0 * root - 2.0 * depth));
        if next >= root || next.is_nan() {
            return wall.clearance + root * root;
        }
        root = next;
    }
}

#[cfg(test)]
mod tests;
