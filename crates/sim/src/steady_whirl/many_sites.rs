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
//! Two properties of λ make the search over the rates certain.
//!
//! - For any r the function r*K(s)r of the Laplace variable s maps the quarter plane Re s > −σ,
//!   Im s > 0 into the upper half plane, just as the stiffness of one site does
//!   ([`super::variation`]), x now being the shape with the displacements r. So
//!   asinh(−Re r*Kr / Im r*Kr) varies no faster than the hyperbolic distance of the rates, and
//!   neither does the greatest for any r, asinh λ.
//! - λ ≤ ω/2σ: of what x*(S + iωC − ω²M)x is, −Re ≤ ω² x*Mx, and Im = ω x*Cx ≥ 2σω x*Mx. That
//!   is all that a string needs which its wall carries everywhere: friction against its damping.

use linear::Complex64;

use super::pencil::{Hardest, hardest};
use super::variation::Variation;
use super::{LEAST_DECAY, MOST_FRICTION};
use crate::laws::wall::Wall;

/// Between the rates that are looked at no λ is greater than the greatest found by more than
/// this part of it …
const TOLERANCE: f64 = 0.005;

/// … and none is told that is not greater by this part than the last.
const STEP: f64 = 0.005;

/// Any wall has this friction: less is not looked for.
const LITTLE_FRICTION: f64 = 0.02;

/// Places where the string may touch the wall.
#[derive(Debug, Clone)]
pub struct WhirlingSites<H> {
    /// The walls; their friction plays no part.
    pub walls: Vec<Wall>,
    /// The receptance H at the sites, row by row (m/N), at a rate (rad/s).
    pub receptance: H,
    /// σ, 1/s, as of [`super::WhirlingSite`].
    pub decay_rate: f64,
}

/// The least friction that steady backward whirl needs, at any of several sites, alone or
/// together.
#[derive(Debug, Clone, PartialEq)]
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
    /// The least friction of steady whirl over all surface speeds up to one (rad/s), each from its
    /// own speed to that of the next. No whirl needs less than 1 % less, and none at speeds below
    /// the first less than 1 % less than [`MOST_FRICTION`]. Once it is less than 0.02, which any
    /// wall has, lesser ones are not looked for. Empty without damping, as
    /// [`super::WhirlingSite`] has it.
    pub fn least_friction(&self, fastest_surface_speed: f64) -> Vec<SitesWhirl> {
        let ratios = self.walls.iter().map(|wall| wall.radius / wall.clearance);
        let ratio = ratios.fold(0.0, f64::max);
        let fastest = fastest_surface_speed * ratio;
        // At slower rates damping alone needs more.
        let slowest = 2.0 * self.decay_rate / MOST_FRICTION;
        if self.decay_rate <= LEAST_DECAY * fastest || slowest >= fastest {
            return Vec::new();
        }
        let mut search = Search {
            sites: self,
            ratio,
            most: MOST_FRICTION.recip(),
            found: Vec::new(),
        };
        let ends = [slowest, fastest].map(|rate| search.point(rate));
        search.add(&ends[0]);
        search.between([&ends[0], &ends[1]]);
        search.found
    }
}

/// The hardest that is pressed at a rate.
struct Point {
    rate: f64,
    /// asinh λ.
    pressing: f64,
    hardest: Hardest,
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
        let hardest = hardest(&receptance, 0.5 * rate / self.sites.decay_rate);
        Point {
            rate,
            pressing: hardest.ratio.asinh(),
            hardest,
        }
    }

    /// Points come from the slowest rate to the fastest.
    fn add(&mut self, point: &Point) {
        let ratio = point.hardest.ratio;
        self.most = self.most.max(ratio);
        let told = (self.found.last()).map_or(MOST_FRICTION, |whirl| whirl.least_friction);
        if ratio * told > 1.0 + STEP {
            self.found.push(SitesWhirl {
                surface_speed: point.rate / self.ratio,
                rate: point.rate,
                least_friction: ratio.recip(),
                shares: point.hardest.shares.clone(),
            });
        }
    }

    /// Adds what lies above the first of two points, up to the second, unless it is certain
    /// that it presses no harder than what is found, but for the tolerance.
    fn between(&mut self, [low, high]: [&Point; 2]) {
        let variation = Variation {
            decay_rate: self.sites.decay_rate,
        };
        let places = [low, high].map(|point| (point.rate, point.pressing));
        let [_, greatest] = variation.pressing_range(places);
        let enough = ((1.0 + TOLERANCE) * self.most).asinh();
        if greatest <= enough || self.most * LITTLE_FRICTION >= 1.0 {
            return self.add(high);
        }
        // As what is found presses as hard as the first, that is so of any two points that are
        // close.
        let middle = self.point(0.5 * (low.rate + high.rate));
        self.between([low, &middle]);
        self.between([&middle, high]);
    }
}
