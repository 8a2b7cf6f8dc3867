//! The drag of viscous mud on a tube in the middle of a round hole, from the exact flow of small
//! speeds (linearised Navier–Stokes equations in the plane, incompressible, without slip).
//!
//! With κ = √(ρs/μ), vorticity is a wave of I and K of κr. Over each speed of the tube the drag
//! is that of a passive fluid, so a positive-real function of s; its real part is what takes
//! energy, its imaginary part over the frequency the inertia of the mud that moves along. A hole
//! of one tube is its own: the flow along the string, through joints of another width, is left out,
//! and so are eccentricity, the steady rotation, and what mud does that is not linear.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::bessel::Bessel;
use super::narrow;
use crate::channel::Channel;

/// A tube full of mud within a hole full of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Annulus {
    /// Viscosity μ, Pa s.
    pub(crate) viscosity: f64,
    /// Density ρ, kg/m³.
    pub(crate) density: f64,
    /// Radius of the bore R_i, m; zero for a solid bar.
    pub(crate) inner: f64,
    /// Radius of the tube R, m.
    pub(crate) outer: f64,
    /// Radius of the hole R_h, m.
    pub(crate) hole: f64,
}

impl Annulus {
    /// κ, 1/m.
    fn wavenumber(&self, s: Complex64) -> Complex64 {
        (s * (self.density / self.viscosity)).sqrt()
    }

    /// Force per length and speed, or torque per length and rotation speed, on a tube that moves as in
    /// a channel, at the Laplace variable s (rad/s, off the negative real axis).
    pub(crate) fn drag(&self, channel: Channel, s: Complex64) -> Complex64 {
        match channel {
            Channel::Torsion => self.against_turning(s),
            Channel::Bending => self.against_moving(s),
            Channel::Axial => self.against_sliding(s),
        }
    }

    /// The same of a steady motion.
    pub(crate) fn steady_drag(&self, channel: Channel) -> f64 {
        match channel {
            Channel::Torsion => self.against_steady_turning(),
            Channel::Bending => self.against_moving(Complex64::ZERO).re,
            Channel::Axial => self.against_steady_sliding(),
        }
    }

    /// Torque per length and rotation speed on a tube that turns, N m s/rad per m, at the Laplace
    /// variable s (rad/s, off the negative real axis).
    pub(crate) fn against_turning(&self, s: Complex64) -> Complex64 {
        self.turning_outside(s) + self.turning_inside(s)
    }

    /// The same of a steady rotation: 4πμ R²R_h²/(R_h² − R²).
    pub(crate) fn against_steady_turning(&self) -> f64 {
        let [outer, hole] = [self.outer, self.hole].map(|radius| radius * radius);
        4.0 * PI * self.viscosity * outer * hole / (hole - outer)
    }

    /// v = A I₁(κr) + B K₁(κr), which is the tube's speed on it and nothing on the hole, and the
    /// moment of −μ r d(v/r)/dr.
    fn turning_outside(&self, s: Complex64) -> Complex64 {
        if s == Complex64::ZERO {
            return self.against_steady_turning().into();
        }
        let kappa = self.wavenumber(s);
        let [tube, hole] = [self.outer, self.hole].map(|radius| Bessel::at(kappa * radius));
        let passed = (kappa * (-2.0 * (self.hole - self.outer))).exp();
        // What the hole sends back of the wave from the tube.
        let returned = passed * hole.k[1] / (hole.i[1] * tube.k[1]);
        let slope = (tube.k[2] / tube.k[1] + returned * tube.i[2]) / (-returned * tube.i[1] + 1.0);
        kappa * slope * (2.0 * PI * self.viscosity * self.outer.powi(3))
    }

    /// 2πμ R_i² κR_i I₂/I₁.
    fn turning_inside(&self, s: Complex64) -> Complex64 {
        let at = self.wavenumber(s) * self.inner;
        if at == Complex64::ZERO {
            return at;
        }
        let bore = Bessel::at(at);
        at * bore.i[2] / bore.i[1] * (2.0 * PI * self.viscosity * self.inner.powi(2))
    }

    /// Force per length and speed on a tube that slides along its axis, N s/m per m, at the Laplace
    /// variable s (rad/s, off the negative real axis). The mud that a closed end would push along
    /// the hole is left out.
    pub(crate) fn against_sliding(&self, s: Complex64) -> Complex64 {
        self.sliding_outside(s) + self.sliding_inside(s)
    }

    /// The same of a steady motion: 2πμ/ln(R_h/R).
    fn against_steady_sliding(&self) -> f64 {
        2.0 * PI * self.viscosity / (self.hole / self.outer).ln()
    }

    /// w = A I₀(κr) + B K₀(κr), which is the tube's speed on it and nothing on the hole, and the
    /// shear −μ dw/dr.
    fn sliding_outside(&self, s: Complex64) -> Complex64 {
        if s == Complex64::ZERO {
            return self.against_steady_sliding().into();
        }
        let kappa = self.wavenumber(s);
        let [tube, hole] = [self.outer, self.hole].map(|radius| Bessel::at(kappa * radius));
        let passed = (kappa * (-2.0 * (self.hole - self.outer))).exp();
        // What the hole sends back of the wave from the tube.
        let returned = passed * hole.k[0] / (hole.i[0] * tube.k[0]);
        let slope = (tube.k[1] / tube.k[0] + returned * tube.i[1]) / (-returned * tube.i[0] + 1.0);
        kappa * slope * (2.0 * PI * self.viscosity * self.outer)
    }

    /// 2πμ κR_i I₁/I₀.
    fn sliding_inside(&self, s: Complex64) -> Complex64 {
        let at = self.wavenumber(s) * self.inner;
        if at == Complex64::ZERO {
            return at;
        }
        let bore = Bessel::at(at);
        at * bore.i[1] / bore.i[0] * (2.0 * PI * self.viscosity)
    }

    /// A rate, 1/s, slower than any at which vorticity around a tube at rest decays, where the drag
    /// has its poles. Those are no slower than the Laplacian's between both walls, which
    /// are no slower than those of a round hole without the tube (2.405²/R_h²) and of a gap between
    /// planes, but for its curvature (π²/(R_h − R)² − 1/4R²).
    pub(crate) fn least_decay_rate_of_vorticity(&self) -> f64 {
        let round = (2.404 / self.hole).powi(2);
        let gap = (PI / (self.hole - self.outer)).powi(2) - 0.25 / self.outer.powi(2);
        self.viscosity / self.density * round.max(gap)
    }

    /// Mass per length that moves along however fast a tube moves across the hole, the bore left out:
    /// πρR² (R_h² + R²)/(R_h² − R²), kg/m.
    pub(crate) fn moved_aside(&self) -> f64 {
        let [outer, hole] = [self.outer, self.hole].map(|radius| radius * radius);
        PI * self.density * outer * (hole + outer) / (hole - outer)
    }

    /// Force per length and speed on a tube that moves across the hole, N s/m per m, at the
    /// Laplace variable s (rad/s, off the negative real axis). The mud in the bore moves along
    /// as if it were solid, and counts as mass in addition.
    ///
    /// From the stream function (A r + B/r + C I₁(κr) + D K₁(κr)) sin φ, of which pressure and
    /// shear leave πρs(2B/U − R²) (S. S. Chen, M. W. Wambsganss and J. A. Jendrzejczyk, "Added mass
    /// and damping of a vibrating rod in confined viscous fluids", *Journal of Applied Mechanics*
    /// 43, 1976, 325–329).
    pub(crate) fn against_moving(&self, s: Complex64) -> Complex64 {
        let displaced = PI * self.density * self.outer.powi(2);
        let kappa = self.wavenumber(s);
        if (kappa * self.hole).norm() < narrow::WIDEST {
            let radii = [self.outer, self.hole];
            return narrow::against_moving(kappa, radii) * self.viscosity;
        }
        let [alpha, beta] = [self.outer, self.hole].map(|radius| kappa * radius);
        let [tube, hole] = [alpha, beta].map(Bessel::at);
        let (alpha_squared, beta_squared) = (alpha * alpha, beta * beta);
        let passed = (alpha - beta).exp();
        // Differences of r²I₂ and I₀, over e^β, and of r²K₂ and K₀, over e^(−α).
        let grows = beta_squared * hole.i[2] - passed * alpha_squared * tube.i[2];
        let grows_along = hole.i[0] - passed * tube.i[0];
        let dies = alpha_squared * tube.k[2] - passed * beta_squared * hole.k[2];
        let dies_along = tube.k[0] - passed * hole.k[0];
        let doublet = (grows * tube.k[2] + passed * dies * tube.i[2])
            / (grows * dies_along - dies * grows_along);
        s * (2.0 * doublet - 1.0) * displaced
    }
}

#[cfg(test)]
mod tests {
    use super::super::reference;
    use super::*;

    /// A 5-inch pipe in an 8.5-inch hole.
    pub(super) const PIPE: Annulus = Annulus {
        viscosity: 0.03,
        density: 1200.0,
        inner: 0.054,
        outer: 0.0635,
        hole: 0.108,
    };

    fn assert_near(found: Complex64, exact: Complex64, part: f64) {
        let error = (found - exact).norm() / exact.norm();
        assert!(error < part, "{found} {exact}: {error:e}");
    }

    /// The flow from its boundary conditions, in 34 digits by mpmath (`scripts/mud-drag.py`).
    #[test]
    fn drag_is_that_of_the_flow_between_its_walls() {
        for row in reference::numbers(include_str!("reference/drag.csv"), 0) {
            let [viscosity, density, inner, outer, hole] = row[..5] else {
                unreachable!()
            };
            let annulus = Annulus {
                viscosity,
                density,
                inner,
                outer,
                hole,
            };
            let number = |column: usize| Complex64::new(row[column], row[column + 1]);
            let s = number(5);
            // Walls so close that only a small difference is left of the waves between them.
            let gap = hole / outer - 1.0;
            let rounding = 1e-13 / gap.min(0.5);
            assert_near(annulus.turning_inside(s), number(7), 1e-13);
            assert_near(annulus.turning_outside(s), number(9), rounding);
            assert_near(
                annulus.against_moving(s),
                number(11),
                rounding / gap.min(0.5),
            );
        }
    }

    /// 4πμ R²R_h²/(R_h² − R²) outside; inside the mud turns along as if it were solid.
    #[test]
    fn slow_turning_meets_couette_flow_and_solid_mud() {
        let s = Complex64::new(0.0, 1e-7);
        let outside = PIPE.turning_outside(s);
        assert_near(
            outside.re.into(),
            PIPE.against_steady_turning().into(),
            1e-6,
        );
        assert!((PIPE.against_steady_turning() / 2.323_282_09e-3 - 1.0).abs() < 1e-8);
        let inertia = PIPE.turning_inside(s) / s;
        let solid = 0.5 * PI * PIPE.density * PIPE.inner.powi(4);
        assert_near(inertia, solid.into(), 1e-6);
        assert!((solid / 1.602_788_30e-2 - 1.0).abs() < 1e-8);
        assert_eq!(
            PIPE.against_turning(Complex64::ZERO),
            PIPE.against_steady_turning().into()
        );
    }

    /// 2πR³ √(ρμs) on either wall.
    #[test]
    fn fast_turning_meets_the_drag_of_a_plane_wall() {
        let s = Complex64::new(0.0, 1e9);
        let plane = (s * PIPE.density * PIPE.viscosity).sqrt() * 2.0 * PI;
        assert_near(PIPE.turning_outside(s), plane * PIPE.outer.powi(3), 2e-4);
        assert_near(PIPE.turning_inside(s), plane * PIPE.inner.powi(3), 2e-4);
    }

    /// Slowly 2πμ/ln(R_h/R) outside, and solid mud inside, πρR_i²; fast 2πR √(ρμs) on either wall.
    #[test]
    fn sliding_meets_its_limits() {
        let slow = Complex64::new(0.0, 1e-7);
        let steady = 2.0 * PI * PIPE.viscosity / (PIPE.hole / PIPE.outer).ln();
        assert_near(PIPE.sliding_outside(slow).re.into(), steady.into(), 1e-6);
        assert_eq!(PIPE.against_sliding(Complex64::ZERO), steady.into());
        let solid = PI * PIPE.density * PIPE.inner.powi(2);
        assert_near(PIPE.sliding_inside(slow) / slow, solid.into(), 2e-6);
        let fast = Complex64::new(0.0, 1e9);
        let plane = (fast * PIPE.density * PIPE.viscosity).sqrt() * 2.0 * PI;
        assert_near(PIPE.sliding_outside(fast), plane * PIPE.outer, 2e-4);
        assert_near(PIPE.sliding_inside(fast), plane * PIPE.inner, 2e-4);
    }

    /// The flow between the walls by finite differences: w″ + w′/r = κ² w.
    #[test]
    fn sliding_is_the_flow_between_its_walls() {
        const POINTS: usize = 4000;
        let h = (PIPE.hole - PIPE.outer) / POINTS as f64;
        for frequency in [0.2, 2.0, 20.0] {
            let s = Complex64::new(0.3, 2.0 * PI * frequency);
            let squared = s * PIPE.density / PIPE.viscosity;
            // From the hole inwards by elimination: each speed is a part of the next one's.
            let mut part = Complex64::ZERO;
            for point in (1..POINTS).rev() {
                let r = PIPE.outer + point as f64 * h;
                let [inner, outer] = [-0.5, 0.5].map(|side| (r + side * h) / r);
                part = inner / (squared * h * h + inner + outer - part * outer);
            }
            // The shear on the tube, of the mud of half a step as well.
            let mid = PIPE.outer + 0.5 * h;
            let shear = mid * (Complex64::ONE - part) / h + 0.5 * h * squared * PIPE.outer;
            let expected = shear * 2.0 * PI * PIPE.viscosity;
            assert_near(PIPE.sliding_outside(s), expected, 1e-4);
        }
    }

    /// Figures that were known beforehand.
    #[test]
    fn drag_of_a_pipe_at_three_frequencies() {
        for (frequency, re, im) in [
            (0.1, 6.569_606e-3, 5.392_740e-3),
            (1.0, 1.825_552e-2, 1.710_304e-2),
            (100.0, 0.172_231_8, 0.171_090_4),
        ] {
            let s = Complex64::new(0.0, 2.0 * PI * frequency);
            assert_near(PIPE.turning_outside(s), Complex64::new(re, im), 5e-7);
        }
        let inside = PIPE.turning_inside(Complex64::new(0.0, 2.0 * PI));
        assert_near(inside, Complex64::new(9.702_628e-3, 1.051_606e-2), 5e-8);
    }

    /// Slowly: the drag of creeping flow between two cylinders. Fast: the mud that is pushed aside,
    /// πρR² (R_h² + R²)/(R_h² − R²), as without viscosity.
    #[test]
    fn moving_across_meets_creeping_flow_and_added_mass() {
        let ratio = (PIPE.hole / PIPE.outer).powi(2);
        let creeping = 0.5 * ratio.ln() - (ratio - 1.0) / (ratio + 1.0);
        let creeping = 4.0 * PI * PIPE.viscosity / creeping;
        let steady = PIPE.against_moving(Complex64::ZERO).re;
        assert!((steady / creeping - 1.0).abs() < 1e-13);
        let slow = PIPE.against_moving(Complex64::new(1e-9, 0.0));
        assert_near(slow, creeping.into(), 1e-8);
        let s = Complex64::new(0.0, 1e10);
        let added = PI * PIPE.density * PIPE.outer.powi(2) * (ratio + 1.0) / (ratio - 1.0);
        assert_near(PIPE.against_moving(s) / s, added.into(), 1e-3);
        assert!((PIPE.moved_aside() / added - 1.0).abs() < 1e-14);
    }

    /// A thin annulus: lubrication, 12πμ (R/h)³ at a gap h, to the first order in h/R.
    #[test]
    fn a_thin_annulus_is_a_squeezed_film() {
        let drag = |gap: f64| {
            let thin = Annulus {
                hole: PIPE.outer * (1.0 + gap),
                ..PIPE
            };
            let film = 12.0 * PI * thin.viscosity / gap.powi(3);
            thin.against_moving(Complex64::new(0.0, 0.1)) / film
        };
        let [thin, thinner] = [0.02, 0.01].map(drag);
        assert!((thinner - 1.0).norm() < 0.02, "{thinner}");
        assert!(
            (2.0 * thinner - thin - 1.0).norm() < 5e-4,
            "{thin} {thinner}"
        );
    }

    /// A wide one: Stokes' cylinder in mud without end, πρR²s (1 + 4K₁/(αK₀)).
    #[test]
    fn a_wide_annulus_is_mud_without_end() {
        let wide = Annulus { hole: 5.0, ..PIPE };
        for frequency in [0.5, 5.0, 50.0] {
            let s = Complex64::new(0.0, 2.0 * PI * frequency);
            let alpha = wide.wavenumber(s) * wide.outer;
            let Bessel { k, .. } = Bessel::at(alpha);
            let endless = s * (1.0 + 4.0 * k[1] / (alpha * k[0]));
            let endless = endless * PI * wide.density * wide.outer.powi(2);
            // What the wall adds to the mass that is pushed aside.
            assert_near(wide.against_moving(s), endless, 2e-3);
        }
    }

    /// Sums and power series, where both serve.
    #[test]
    fn slow_and_fast_formulas_meet() {
        let at = |size: f64, angle: f64| {
            let kappa = Complex64::from_polar(size / PIPE.hole, angle);
            PIPE.against_moving(kappa * kappa * PIPE.viscosity / PIPE.density)
        };
        for angle in [-0.8, -0.3, 0.0, 0.5, 0.785] {
            let [below, above] =
                [1.0 - 1e-12, 1.0 + 1e-12].map(|it| at(it * narrow::WIDEST, angle));
            assert_near(below, above, 2e-11);
        }
    }

    /// No fluid gives energy back: on the imaginary axis the drag has a positive real part, and
    /// within the right half plane it is positive-real.
    #[test]
    fn mud_takes_energy_at_every_frequency() {
        for (viscosity, hole) in [(1e-3, 0.07), (0.03, 0.108), (0.5, 0.5)] {
            let annulus = Annulus {
                viscosity,
                hole,
                ..PIPE
            };
            for size in -40..60 {
                for turn in -10..=10 {
                    let angle = 0.05 * PI * f64::from(turn);
                    let s = Complex64::from_polar((0.25 * f64::from(size)).exp(), angle);
                    for channel in [Channel::Torsion, Channel::Axial] {
                        let drag = annulus.drag(channel, s);
                        // Mud in the bore that slides along is all mass where it is slow.
                        let least = match channel {
                            Channel::Torsion => 0.7,
                            _ => 0.0,
                        };
                        assert!(drag.re > least * drag.norm(), "{channel} {s} {drag}");
                    }
                    let moving = annulus.against_moving(s);
                    assert!(moving.re > 0.0, "{s} {moving}");
                }
            }
        }
    }
}
