//! What friction steady backward whirl needs at least where a string may touch at several
//! sites, whichever of them touch, and however they roll or slide.
//!
//! Let all of it go round at one rate ω against the rotation, K(iω) be the dynamic stiffness at
//! the sites and r their displacements, complex as they have phases. A site that touches feels
//! f = −(N + iT) r/|r| with N ≥ 0 and |T| ≤ μN, any other none. Summed over the sites,
//!
//! −Re r*Kr = Σ N|r| and Im r*Kr = −Σ T|r| ≤ μ Σ N|r|,
//!
//! so that μ ≥ Im r*Kr / (−Re r*Kr) ≥ 1/λ, with λ the greatest that −Re r*Kr / Im r*Kr is for any
//! r. It holds for each choice of the sites that touch, for it asks for none. The forces to the
//! displacements r are Kr, and K⁻¹ is the receptance, by which λ is found ([`super::pencil`]). So
//! radii, phases and the law of the wall play no part, nor that a wall cannot pull where another
//! pushes: it is a lower bound, and what whirls may need more.
//!
//! What makes the search over the rates certain, and short, is that for any r the function r*K(s)r
//! of the Laplace variable s maps the quarter plane Re s > −σ, Im s > 0 into the upper half plane,
//! just as the stiffness of one site does ([`super::variation`]), x now being the shape with the
//! displacements r. So ψ = π − arg r*Kr is harmonic there, and positive. It is arccot of what is
//! pressed over what is lost, and the least ψ is arccot λ.
//!
//! More is known. With x*Cx = 2σ x*Mx + c and c ≥ 0, and x*Sx ≥ 0 as long as the string does not
//! buckle,
//!
//! x*(s²M + sC + S)x = (s² + 2σs) x*Mx + sc + x*Sx,
//!
//! of which no term has a greater argument than s² + 2σs. So ψ exceeds π − arg(s² + 2σs), which is
//! arccot(ω/2σ) at s = iω, by a function that is harmonic and not negative either. In other words
//! λ ≤ ω/2σ, which is all that a string needs which its wall carries everywhere, friction against
//! its damping; and where sites come near that, little can happen between two rates. The **excess**
//! at two rates bounds that between them ([`Variation::least_harmonic`]). In viscous mud σ is here the
//! σ' of a corner, in which no part has a greater argument than that either
//! ([`linear::bending_decay::Corner`]).

use linear::Complex64;
use linear::bending_decay::BendingDecay;

use super::pencil::Pencil;
use super::variation::Variation;
use super::{MOST_FRICTION, is_damped};
use crate::laws::wall::Wall;

/// Between the rates examined no λ exceeds the greatest found by more than this fraction of it …
const TOLERANCE: f64 = 0.008;

/// … and only those are reported that exceed the last by this fraction.
const STEP: f64 = 0.002;

/// Rates that differ by a smaller part need the same friction up to rounding: over that distance,
/// at the lightest damping considered, it changes by a thousandth.
const NEAREST: f64 = 1e-9;

/// Any wall has this friction: less is not looked for.
const LITTLE_FRICTION: f64 = 0.02;

/// Places where the string may touch the wall.
#[derive(Debug, Clone)]
pub struct WhirlingSites<H> {
    /// The walls; their friction plays no part.
    pub walls: Vec<Wall>,
    /// The receptance H at the sites, row by row (m/N), at a rate (rad/s).
    pub receptance: H,
    /// How fast oscillations decay at least, as of [`super::WhirlingSite`].
    pub decay: BendingDecay,
}

/// The least friction that steady backward whirl needs, at any of several sites, alone or
/// together.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct SitesWhirl {
    /// The surface speed from which on it is so, rad/s: at slower ones no site goes round as
    /// fast.
    pub surface_speed: f64,
    /// Rate of precession ω, against the rotation, rad/s.
    pub rate: f64,
    /// The least coefficient of friction.
    pub least_friction: f64,
    /// What each site does of the work of the normal forces, which adds up to one. Less than
    /// nothing where the wall would have to pull.
    pub shares: Vec<f64>,
}

impl<H: Fn(f64) -> Vec<Complex64>> WhirlingSites<H> {
    /// The least friction of steady whirl over a range of surface speeds (rad/s), which may be one:
    /// first that up to the slowest of them, then each less from its own speed to that of the next.
    /// No whirl needs less than 1 % less, and none at speeds below the first less than 1 % less than
    /// [`MOST_FRICTION`]. Once it is less than 0.02, which any wall has, lesser ones are not looked
    /// for. Empty without damping, as [`super::WhirlingSite`] has it.
    pub fn least_friction(&self, surface_speeds: [f64; 2]) -> Vec<SitesWhirl> {
        let ratios = self.walls.iter().map(|wall| wall.radius / wall.clearance);
        let ratio = ratios.fold(0.0, f64::max);
        // At slower rates damping alone needs more.
        let slowest = 2.0 * self.decay.least() / MOST_FRICTION;
        let [middle, fastest] = surface_speeds.map(|speed| (speed * ratio).max(slowest));
        if !is_damped(&self.decay, fastest) || slowest >= fastest {
            return Vec::new();
        }
        let mut search = Search {
            sites: self,
            ratio,
            most: MOST_FRICTION.recip(),
            found: Vec::new(),
        };
        let [low, middle] = [slowest, middle].map(|rate| search.point(rate));
        search.keep(&low);
        search.keep(&middle);
        search.of_slower([&low, &middle]);
        if middle.rate < fastest {
            let high = search.point(fastest);
            search.of_faster([&middle, &high]);
        }
        search.found
    }
}

/// The hardest that is pressed at a rate.
struct Point {
    rate: f64,
    pencil: Pencil,
    /// λ.
    ratio: f64,
}

struct Search<'a, H> {
    sites: &'a WhirlingSites<H>,
    /// The fastest rate over the surface speed.
    ratio: f64,
    /// The greatest λ so far.
    most: f64,
    found: Vec<SitesWhirl>,
}

impl<H: Fn(f64) -> Vec<Complex64>> Search<'_, H> {
    fn point(&self, rate: f64) -> Point {
        let receptance = (self.sites.receptance)(rate);
        let most = most_of_any(
            rate,
            self.sites.decay.corner_below(rate).decay_rate_if_carried,
        );
        let pencil = Pencil::new(&receptance, most);
        let ratio = pencil.ratio();
        Point {
            rate,
            pencil,
            ratio,
        }
    }

    /// Whether it is certain that no rate between two points presses harder than what is found, but
    /// for the tolerance, or what is found is enough. As what is found presses as hard as the first
    /// of them, that is so of any two that are close.
    fn is_settled(&self, [low, high]: [&Point; 2]) -> bool {
        if self.most * LITTLE_FRICTION >= 1.0 || high.rate - low.rate < NEAREST * high.rate {
            return true;
        }
        let decay = &self.sites.decay;
        let variation = Variation::above(decay, low.rate);
        let carried = variation.corner.decay_rate_if_carried;
        let excess = variation.least_harmonic([low, high].map(|point| {
            let of_any = arccot(most_of_any(point.rate, carried));
            (point.rate, arccot(point.ratio) - of_any)
        }));
        let least = arccot(most_of_any(high.rate, carried)) + excess;
        least >= arccot((1.0 + TOLERANCE) * self.most)
    }

    /// The hardest between two points, if it is harder than what is found. Mostly it is among the
    /// fastest.
    fn of_slower(&mut self, [low, high]: [&Point; 2]) {
        if self.is_settled([low, high]) {
            return;
        }
        let middle = self.point(0.5 * (low.rate + high.rate));
        self.keep(&middle);
        self.of_slower([&middle, high]);
        self.of_slower([low, &middle]);
    }

    /// Instead of what is found, if it is harder.
    fn keep(&mut self, point: &Point) {
        if point.ratio > self.most {
            self.most = point.ratio;
            self.found = vec![self.whirl(point)];
        }
    }

    /// Adds what lies above the first of two points, up to the second, one harder than the other.
    fn of_faster(&mut self, [low, high]: [&Point; 2]) {
        if self.is_settled([low, high]) {
            return self.add(high);
        }
        let middle = self.point(0.5 * (low.rate + high.rate));
        self.of_faster([low, &middle]);
        self.of_faster([&middle, high]);
    }

    /// After what is found, if it is harder by a step.
    fn add(&mut self, point: &Point) {
        self.most = self.most.max(point.ratio);
        let reported = (self.found.last()).map_or(MOST_FRICTION, |whirl| whirl.least_friction);
        if point.ratio * reported > 1.0 + STEP {
            self.found.push(self.whirl(point));
        }
    }

    fn whirl(&self, point: &Point) -> SitesWhirl {
        SitesWhirl {
            surface_speed: point.rate / self.ratio,
            rate: point.rate,
            least_friction: point.ratio.recip(),
            shares: point.pencil.shares(),
        }
    }
}

/// ω/2σ.
fn most_of_any(rate: f64, carried: f64) -> f64 {
    0.5 * rate / carried
}

fn arccot(value: f64) -> f64 {
    1.0_f64.atan2(value)
}
