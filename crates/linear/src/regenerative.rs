//! Whether steady drilling lasts where each blade cuts what the one before has left: the linear
//! limit, exact for any string.
//!
//! The depth of cut of a blade is how far the bit has advanced since the blade before it passed, the
//! time t_n ago. With torque and weight that grow with it, by k_t and k_a (N m/m, N/m), and with g
//! the speed of the bit per load in torsion and along the axis, small motion about a steady rate
//! of penetration V at the speed Ω obeys
//!
//! D(s) = 1 + (1 − e^(−s t_n))/s · [k_a g_a(s) − (V/Ω) k_t g_t(s)] = 0.
//!
//! Both g are positive-real and D → 1 for fast s, so the number of roots that grow is −1/π times
//! the change of arg D(iω) from ω = 0 to ∞ (Cauchy). Near sharp resonances that is followed in the
//! coefficients r = (Zg − 1)/(Zg + 1) by which waves come back, whose phases turn evenly: D times
//! (1 − r_a)(1 − r_t), which has no zeros of its own, has no poles.
//!
//! In soft rock the axis of a plain string is stable when the bit turns fast enough:
//!
//! ```
//! use linear::regenerative::{CuttingLoop, SteadyCut};
//! use linear::{Axial, Drillstring, Hoist, Material, Section, TopDrive, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 2000.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! // Ends that send back 0.7 of a wave.
//! let damping = linear::estimates::torsional_impedance(&string, &pipe) * 1.7 / 0.3;
//! let drive = TopDrive { inertia: 0.0, proportional_gain: damping, integral_gain: 0.0 };
//! let string = string.with_top_drive(drive)?;
//! let hoist = Hoist { mass: 0.0, damping: 142_292.0 * 1.7 / 0.3, stiffness: 0.0 };
//! let rod = Axial { youngs_modulus: 210e9, damping: 0.0, hoist: Some(hoist) }.rod(&string)?;
//! let cutting = CuttingLoop::new(&string, &rod)?;
//! let at = |speed: f64| SteadyCut {
//!     delay: std::f64::consts::FRAC_PI_2 / speed,
//!     advance: 0.004 / speed,
//!     torque: 0.0,
//!     weight: 0.6 * 6e6 * 0.108 * 4.0,
//! };
//! assert_eq!(cutting.growing(&at(22.0)), Some(0));
//! assert!(cutting.growing(&at(16.0)) > Some(0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use num_complex::Complex64;

use crate::drillstring::{Drillstring, Tube};
use crate::error::DrillstringError;
use crate::estimates::{torsional_impedance, torsional_travel_time};
use crate::sites::Sites;
use crate::waves::network::TorsionNetwork;

/// Steady drilling, as small motion about it feels the rock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyCut {
    /// t_n: time from one blade to the next, s.
    pub delay: f64,
    /// V/Ω: advance per angle, m/rad.
    pub advance: f64,
    /// k_t: torque per depth of cut of a blade, N m/m; zero where torsion is left out.
    pub torque: f64,
    /// k_a: weight per depth of cut of a blade, N/m; zero where axial motion is left out.
    pub weight: f64,
}

/// A string above a bit that cuts.
#[derive(Debug)]
pub struct CuttingLoop<'a> {
    torsion: AtBit<'a>,
    axial: AtBit<'a>,
}

/// A motion of the string at its bit.
#[derive(Debug)]
struct AtBit<'a> {
    network: TorsionNetwork<'a>,
    /// Of the lowest tube.
    impedance: f64,
    /// From the bit to the surface and back, s.
    round_trip: f64,
}

/// What is known at a place on the imaginary axis.
#[derive(Debug, Clone, Copy)]
struct Place {
    omega: f64,
    /// D (1 − r_a)(1 − r_t).
    product: Complex64,
    /// Its argument less that of D: within half a turn.
    added: f64,
    /// The most that D can differ from 1 here, whatever the phase of the delay, times ω.
    reach: f64,
}

/// Changes of an argument are followed in steps no larger than this, rad.
const LARGEST_TURN: f64 = 0.3;

/// Halvings of a step.
const MOST_HALVINGS: u32 = 40;

/// Beyond the frequency at which D can differ from 1 by this part, by the sharpest resonance so far,
/// no root can grow; the rest is for sharper ones.
const NEGLIGIBLE: f64 = 0.25;

/// Steps along the axis: about a second of work.
const MOST_STEPS: usize = 3_000_000;

/// Of Newton's method, and of bisection.
const MOST_ITERATIONS: usize = 60;

impl AtBit<'_> {
    fn new(string: &Drillstring) -> Result<AtBit<'_>, DrillstringError> {
        let lowest = |string: &Drillstring| -> Option<Tube> {
            string.sections().last()?.parts.last().copied()
        };
        let impedance = lowest(string).map_or(1.0, |tube| torsional_impedance(string, &tube));
        Ok(AtBit {
            network: TorsionNetwork::new(string, &Sites::bit())?,
            impedance,
            round_trip: 2.0 * torsional_travel_time(string),
        })
    }

    /// Speed per load.
    fn mobility(&self, s: Complex64) -> Complex64 {
        self.network.admittance(s).from_torque[(0, 0)]
    }
}

impl<'a> CuttingLoop<'a> {
    /// Of a string as it twists and as a rod that stretches ([`crate::Axial::rod`]).
    ///
    /// # Errors
    /// Where either cannot be cut up.
    pub fn new(string: &'a Drillstring, rod: &'a Drillstring) -> Result<Self, DrillstringError> {
        Ok(Self {
            torsion: AtBit::new(string)?,
            axial: AtBit::new(rod)?,
        })
    }

    /// D(s).
    pub fn characteristic(&self, cut: &SteadyCut, s: Complex64) -> Complex64 {
        let [torsion, axial] = self.mobilities(cut, s);
        let fed = axial * cut.weight - torsion * (cut.advance * cut.torque);
        delayed(s, cut.delay) * fed + 1.0
    }

    /// Of torsion and of the axis; zero where the cut does not feel it.
    fn mobilities(&self, cut: &SteadyCut, s: Complex64) -> [Complex64; 2] {
        let at = |motion: &AtBit, felt: f64| match felt {
            0.0 => Complex64::ZERO,
            _ => motion.mobility(s),
        };
        [at(&self.torsion, cut.torque), at(&self.axial, cut.weight)]
    }

    /// The number of roots that grow; `None` where resonances are too sharp to be followed, as
    /// those of a string that loses nothing.
    pub fn growing(&self, cut: &SteadyCut) -> Option<usize> {
        let rate = self.torsion.round_trip + self.axial.round_trip + cut.delay;
        let step = LARGEST_TURN / rate;
        let mut here = self.at(cut, 1e-6 * step);
        let (mut turned, mut reach) = (0.0, 0.0_f64);
        for _ in 0..MOST_STEPS {
            reach = reach.max(here.reach);
            if reach < NEGLIGIBLE * here.omega {
                let of_d = turned - here.added;
                let roots = (-of_d / std::f64::consts::PI).round();
                return (roots >= 0.0).then_some(roots as usize);
            }
            let next = self.at(cut, here.omega + step);
            turned += self.turn(cut, here, next, MOST_HALVINGS)?;
            here = next;
        }
        None
    }

    fn at(&self, cut: &SteadyCut, omega: f64) -> Place {
        let s = Complex64::new(0.0, omega);
        let [torsion, axial] = self.mobilities(cut, s);
        // 1 − r = 2/(1 + Zg).
        let [twists, stretches] = [
            (torsion * self.torsion.impedance + 1.0).inv(),
            (axial * self.axial.impedance + 1.0).inv(),
        ];
        let both = twists * stretches;
        let fed = axial * cut.weight - torsion * (cut.advance * cut.torque);
        Place {
            omega,
            product: both * (delayed(s, cut.delay) * fed + 1.0),
            added: twists.arg() + stretches.arg(),
            reach: 2.0 * fed.norm(),
        }
    }

    /// How far the argument turns between two places.
    fn turn(&self, cut: &SteadyCut, from: Place, to: Place, halvings: u32) -> Option<f64> {
        let turn = (to.product / from.product).arg();
        if turn.abs() <= LARGEST_TURN {
            return Some(turn);
        }
        let middle = self.at(cut, 0.5 * (from.omega + to.omega));
        let left = halvings.checked_sub(1)?;
        Some(self.turn(cut, from, middle, left)? + self.turn(cut, middle, to, left)?)
    }

    /// The root near a guess, by Newton's method; `None` where that does not converge.
    pub fn root(&self, cut: &SteadyCut, guess: Complex64) -> Option<Complex64> {
        let mut s = guess;
        for _ in 0..MOST_ITERATIONS {
            let h = 1e-6 * s.norm();
            let value = self.characteristic(cut, s);
            let slope =
                (self.characteristic(cut, s + h) - self.characteristic(cut, s - h)) / (2.0 * h);
            let step = value / slope;
            s -= step;
            if step.norm() <= 1e-12 * s.norm() {
                return Some(s);
            }
        }
        None
    }

    /// The parameter between two at which steady drilling is about to grow, and at which frequency,
    /// rad/s: `at` gives the cut at a parameter. `None` where the same number of roots grows at
    /// both ends, or resonances are too sharp.
    pub fn limit(
        &self,
        at: impl Fn(f64) -> SteadyCut,
        [low, high]: [f64; 2],
    ) -> Option<(f64, f64)> {
        let is_steady = |parameter: f64| Some(self.growing(&at(parameter))? == 0);
        let below = is_steady(low)?;
        if below == is_steady(high)? {
            return None;
        }
        let (mut low, mut high) = (low, high);
        while (high - low).abs() > CLOSE * high.abs() {
            let middle = 0.5 * (low + high);
            if is_steady(middle)? == below {
                low = middle;
            } else {
                high = middle;
            }
        }
        // What grows on one side and dies away on the other is where D is least on the axis.
        let cut = at(0.5 * (low + high));
        let omega = self.least(&cut)?;
        self.on_axis(&at, (0.5 * (low + high), omega))
    }

    /// The frequency, rad/s, at which D is least on the imaginary axis.
    fn least(&self, cut: &SteadyCut) -> Option<f64> {
        let step =
            LARGEST_TURN / (4.0 * (self.torsion.round_trip + self.axial.round_trip + cut.delay));
        let (mut omega, mut reach) = (step, 0.0_f64);
        let mut least = (f64::INFINITY, 0.0);
        for _ in 0..MOST_STEPS {
            let s = Complex64::new(0.0, omega);
            // By how far a root is from the axis.
            let away = self.root_from(cut, s);
            if away < least.0 {
                least = (away, omega);
            }
            reach = reach.max(self.at(cut, omega).reach);
            if reach < NEGLIGIBLE * omega {
                return Some(least.1);
            }
            omega += step;
        }
        None
    }

    /// About how far the nearest root is from a place: |D/D′|.
    fn root_from(&self, cut: &SteadyCut, s: Complex64) -> f64 {
        let h = 1e-6 * s.norm();
        let slope = (self.characteristic(cut, s + h) - self.characteristic(cut, s - h)) / (2.0 * h);
        (self.characteristic(cut, s) / slope).norm()
    }

    /// Where D(iω) is zero, near a parameter and a frequency, by Newton's method in both.
    fn on_axis(
        &self,
        at: &impl Fn(f64) -> SteadyCut,
        (mut parameter, mut omega): (f64, f64),
    ) -> Option<(f64, f64)> {
        let value = |parameter: f64, omega: f64| {
            self.characteristic(&at(parameter), Complex64::new(0.0, omega))
        };
        for _ in 0..MOST_ITERATIONS {
            let (dp, dw) = (1e-6 * parameter, 1e-6 * omega);
            let now = value(parameter, omega);
            let by_parameter =
                (value(parameter + dp, omega) - value(parameter - dp, omega)) / (2.0 * dp);
            let by_omega =
                (value(parameter, omega + dw) - value(parameter, omega - dw)) / (2.0 * dw);
            let determinant = by_parameter.re * by_omega.im - by_parameter.im * by_omega.re;
            let step = (now.re * by_omega.im - now.im * by_omega.re) / determinant;
            let turn = (by_parameter.re * now.im - by_parameter.im * now.re) / determinant;
            parameter -= step;
            omega -= turn;
            if step.abs() <= 1e-12 * parameter.abs() && turn.abs() <= 1e-12 * omega.abs() {
                return Some((parameter, omega));
            }
        }
        None
    }
}

/// A bracket of a limit is narrowed to this part before Newton's method takes over.
const CLOSE: f64 = 1e-4;

/// (1 − e^(−st))/s.
fn delayed(s: Complex64, time: f64) -> Complex64 {
    let x = s * time;
    if x.norm() < 1e-4 {
        return (1.0 - 0.5 * x + x * x / 6.0) * time;
    }
    (1.0 - (-x).exp()) / s
}
