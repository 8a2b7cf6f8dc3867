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
//! (1 − r_a)(1 − r_t), which adds no zeros, has no poles.
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
//! let drive = TopDrive { inertia: 0.0, proportional_gain: damping, integral_gain: 0.0, delay: 0.0, late_inertia: 0.0 };
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

use std::collections::HashMap;
use std::sync::{Mutex, PoisonError};

use num_complex::Complex64;

use crate::assembly::lanes::Lanes;
use crate::assembly::number::Number;
use crate::drillstring::Drillstring;
use crate::error::DrillstringError;
use crate::estimates::{torsional_impedance, torsional_travel_time};
use crate::parallel;
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

/// What turns the bit against the end of the string: a motor whose rotor slips the more the more torque it
/// passes on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotor {
    /// σ, rad/s per N m.
    pub slip: f64,
    /// J, with what turns with it, bit included, kg m².
    pub inertia: f64,
}

/// A string above a bit that cuts.
#[derive(Debug)]
pub struct CuttingLoop<'a> {
    torsion: AtBit<'a>,
    axial: AtBit<'a>,
    samples: Samples,
    between: Between,
    /// Step of ω between samples, rad/s.
    step: f64,
    /// Roots count from this growth on, 1/s.
    growth: f64,
}

/// A motion of the string at its bit.
#[derive(Debug)]
struct AtBit<'a> {
    network: TorsionNetwork<'a>,
    /// Between the end of the string and the bit.
    rotor: Option<Rotor>,
    /// Of the lowest tube.
    impedance: f64,
    /// From the bit to the surface and back, s.
    round_trip: f64,
}

/// What does not depend on the cut, for steps of ω.
#[derive(Debug, Default)]
struct Samples {
    values: Vec<Sample>,
    /// From each on, the greatest size of each motion.
    greatest_from_here: Vec<[f64; 2]>,
}

/// What does not depend on the cut where steps are halved: sharp resonances, which are the same for every
/// cut.
#[derive(Debug, Default)]
struct Between {
    /// By the bits of ω, in parts that do not wait for one another.
    parts: [Mutex<HashMap<u64, Sample>>; PARTS_BETWEEN],
}

/// What does not depend on the cut at growth + iω.
#[derive(Debug, Clone, Copy)]
struct Sample {
    /// Speeds of the bit per load in torsion and along the axis.
    mobilities: [Complex64; 2],
    /// (1 − r_a)(1 − r_t)/4.
    parts: Complex64,
}

/// What is known at a place on the line of one growth.
#[derive(Debug, Clone, Copy)]
struct Place {
    omega: f64,
    /// D (1 − r_a)(1 − r_t)/4.
    product: Complex64,
}

/// Changes of an argument are followed in steps no larger than this, rad.
const LARGEST_TURN: f64 = 0.3;

/// Halvings of a step.
const MOST_HALVINGS: u32 = 40;

/// Where D differs from 1 by no more than this part for any phases, it turns no further.
const ENOUGH: f64 = 0.5;

/// By how much resonances beyond the samples may be sharper than those of the last octave. No bound is
/// known that holds for all strings: of 500 random ones 34 have one beyond, up to three times as far, that is
/// sharper still, up to 11 times. It matters the less the larger ω is: D came no further from 1 than
/// 0.6, and no count of 1500 changed with samples eight times as far (`val_roots_beyond_the_samples_do_not_grow`).
const SHARPER: f64 = 4.0;

/// Most steps along the axis: some seconds of work, and 32 MB.
const MOST_SAMPLES: usize = 1 << 19;

/// Parts of what is kept between samples, and how many places each keeps: 20 MB in all.
const PARTS_BETWEEN: usize = 32;
const MOST_BETWEEN: usize = 1 << 13;

/// Samples that are made at once, and groups of them that a core makes in one go.
const BLOCK: usize = 4096;
const GROUPS_AT_ONCE: usize = 64;

/// Samples along which e^(−iωt) is turned on by products: rounding adds up to as many units of it.
const TURNED_AT_ONCE: usize = 64;

/// The first sample, in steps: a motion that is held at rest has a pole there.
const FIRST: f64 = 1e-6;

/// By how much the delay between blades adds to the round trips of waves, at most.
const TURNS_OF_DELAY: f64 = 1.5;

/// Places to a step at which the root on the axis is looked for.
const PER_STEP: usize = 4;

/// A bracket of a limit is narrowed to this part before Newton's method takes over.
const CLOSE: f64 = 1e-4;

/// Of Newton's method.
const MOST_ITERATIONS: usize = 60;

impl AtBit<'_> {
    fn new(string: &Drillstring) -> Result<AtBit<'_>, DrillstringError> {
        let lowest = string
            .sections()
            .last()
            .and_then(|section| section.parts.last());
        Ok(AtBit {
            network: TorsionNetwork::new(string, &Sites::bit())?,
            rotor: None,
            impedance: lowest.map_or(1.0, |tube| torsional_impedance(string, tube)),
            round_trip: 2.0 * torsional_travel_time(string),
        })
    }

    /// Speed per load. Below a rotor g becomes 1/(sJ + 1/(g + σ)), which is positive-real, too.
    fn mobility<T: Number>(&self, s: T) -> T {
        let of_string = self.network.admittance(s).from_torque[(0, 0)];
        match self.rotor {
            None => of_string,
            Some(Rotor { slip, inertia }) => {
                let driven = of_string + slip;
                driven * (driven * s * inertia + 1.0).inverse()
            }
        }
    }

    /// (1 − r)/2 = 1/(1 + Zg), whose argument is within a quarter turn.
    fn part(&self, mobility: Complex64) -> Complex64 {
        (mobility * self.impedance + 1.0).inv()
    }
}

impl<'a> CuttingLoop<'a> {
    /// Of a string as it twists and as a rod that stretches ([`crate::Axial::rod`]).
    ///
    /// # Errors
    /// Where either cannot be cut up.
    pub fn new(string: &'a Drillstring, rod: &'a Drillstring) -> Result<Self, DrillstringError> {
        let (torsion, axial) = (AtBit::new(string)?, AtBit::new(rod)?);
        Ok(Self {
            step: LARGEST_TURN / (TURNS_OF_DELAY * (torsion.round_trip + axial.round_trip)),
            torsion,
            axial,
            samples: Samples::default(),
            between: Between::default(),
            growth: 0.0,
        })
    }

    /// The same, of which only roots count that grow faster than this, 1/s: what grows more slowly is not seen
    /// in a case that is soon over.
    #[must_use]
    pub fn faster_than(mut self, growth: f64) -> Self {
        self.growth = growth;
        self.samples = Samples::default();
        self.between = Between::default();
        self
    }

    /// The same with a motor between the end of the string and the bit, which does not stall.
    #[must_use]
    pub fn above_motor(mut self, rotor: Rotor) -> Self {
        self.torsion.rotor = Some(rotor);
        self.samples = Samples::default();
        self.between = Between::default();
        self
    }

    /// The same, with what does not depend on the cut at hand up to where the roots of one end: many
    /// cuts that are no stiffer then cost little each.
    #[must_use]
    pub fn sampled_for(mut self, cut: &SteadyCut) -> Self {
        self.samples = self.sample(cut);
        self
    }

    /// Samples up to where no root of a cut can grow, by the sharpest resonances of the last octave.
    fn sample(&self, cut: &SteadyCut) -> Samples {
        let mut values: Vec<Sample> = Vec::new();
        while values.len() < MOST_SAMPLES {
            let begun = values.len();
            let groups = parallel::map(BLOCK / Lanes::LANES, GROUPS_AT_ONCE, |group| {
                let first = begun + group * Lanes::LANES;
                let s = Lanes::of_lanes(|lane| self.place(self.omega(first + lane)));
                [&self.torsion, &self.axial].map(|motion| motion.mobility(s))
            });
            values.extend(groups.into_iter().flat_map(|motions| {
                (0..Lanes::LANES).map(move |lane| self.at(motions.map(|motion| motion.lane(lane))))
            }));
            let octave = &values[values.len() / 2..];
            let greatest = octave.iter().fold([0.0; 2], larger);
            if SHARPER * most_fed(cut, greatest) < ENOUGH * self.omega(values.len()) {
                break;
            }
        }
        Samples::of(values)
    }

    /// ω of a sample, rad/s.
    fn omega(&self, index: usize) -> f64 {
        (index as f64 + FIRST) * self.step
    }

    /// s at ω, 1/s.
    fn place(&self, omega: f64) -> Complex64 {
        Complex64::new(self.growth, omega)
    }

    fn at(&self, mobilities: [Complex64; 2]) -> Sample {
        let [torsion, axial] = self.parts(mobilities);
        Sample {
            mobilities,
            parts: torsion * axial,
        }
    }

    fn parts(&self, [torsion, axial]: [Complex64; 2]) -> [Complex64; 2] {
        [self.torsion.part(torsion), self.axial.part(axial)]
    }

    /// D(s).
    pub fn characteristic(&self, cut: &SteadyCut, s: Complex64) -> Complex64 {
        delayed(s, cut.delay) * fed(cut, self.mobilities(s)) + 1.0
    }

    /// Of torsion and of the axis.
    fn mobilities(&self, s: Complex64) -> [Complex64; 2] {
        [&self.torsion, &self.axial].map(|motion| motion.mobility(s))
    }

    /// The number of roots that grow, or grow [faster than](Self::faster_than) asked; `None` where resonances are too sharp to be followed, as
    /// those of a string that loses nothing.
    pub fn growing(&self, cut: &SteadyCut) -> Option<usize> {
        let own;
        let samples = match self.end(&self.samples, cut) {
            Some(_) => &self.samples,
            // As many as are made at all have not been enough.
            None if self.samples.values.len() >= MOST_SAMPLES => return None,
            None => {
                own = self.sample(cut);
                &own
            }
        };
        let end = self.end(samples, cut)?;
        let place = |index: usize, delayed: Complex64| {
            Place::of(cut, self.omega(index), &samples.values[index], delayed)
        };
        let delayed_at = |index: usize| delayed(self.place(self.omega(index)), cut.delay);
        let kept = (-self.growth * cut.delay).exp();
        let first = place(0, delayed_at(0));
        let turn = Complex64::cis(-self.step * cut.delay);
        let mut phase = Complex64::ONE;
        let mut here = first;
        let mut turns = 0;
        for index in 1..=end {
            let omega = self.omega(index);
            phase = match index % TURNED_AT_ONCE {
                1 => Complex64::cis(-omega * cut.delay),
                _ => phase * turn,
            };
            // (1 − e^(−st))/s.
            let next = place(index, (1.0 - phase * kept) / self.place(omega));
            turns += match passed(&here, &next) {
                Some(turns) => turns,
                None => self.turns(cut, here, next, MOST_HALVINGS)?,
            };
            here = next;
        }
        let whole = f64::from(turns) * std::f64::consts::TAU;
        let turned = whole + here.product.arg() - first.product.arg();
        let parts = self.parts(samples.values[end].mobilities);
        let added: f64 = parts.iter().map(|part| part.arg()).sum();
        let roots = ((added - turned) / std::f64::consts::PI).round();
        (roots >= 0.0).then_some(roots as usize)
    }

    /// The sample beyond which D does not leave the neighbourhood of 1, if there is one.
    fn end(&self, samples: &Samples, cut: &SteadyCut) -> Option<usize> {
        let count = samples.values.len();
        // Sizes from here on fall, and ω grows.
        let (mut low, mut high) = (0, count);
        while low < high {
            let middle = (low + high) / 2;
            let most = most_fed(cut, samples.greatest_from_here[middle]);
            if most < ENOUGH * self.omega(middle) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        Some(low).filter(|end| *end < count)
    }

    /// How often the product passes the negative real axis between two places, counted where its
    /// argument grows.
    fn turns(&self, cut: &SteadyCut, from: Place, to: Place, halvings: u32) -> Option<i32> {
        if let Some(turns) = passed(&from, &to) {
            return Some(turns);
        }
        let omega = 0.5 * (from.omega + to.omega);
        let s = self.place(omega);
        let middle = self.between.at(omega, || self.at(self.mobilities(s)));
        let middle = Place::of(cut, omega, &middle, delayed(s, cut.delay));
        let left = halvings.checked_sub(1)?;
        Some(self.turns(cut, from, middle, left)? + self.turns(cut, middle, to, left)?)
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
        // What grows on one side and dies away on the other is where D is least on the axis; the root of
        // a sharp resonance next to it may lead to a limit that is another's.
        let middle = 0.5 * (low + high);
        let is_of_bracket =
            |(parameter, _): &(f64, f64)| (parameter - middle).abs() <= 2.0 * CLOSE * middle.abs();
        let nearest = self.nearest(&at(middle))?.into_iter();
        let limits = nearest.filter_map(|omega| self.on_axis(&at, (middle, omega)));
        limits.filter(|limit| limit.1 > 0.0).find(is_of_bracket)
    }

    /// The frequencies, rad/s, at which roots are near the imaginary axis, from the nearest on.
    fn nearest(&self, cut: &SteadyCut) -> Option<Vec<f64>> {
        let samples = self.sample(cut);
        let end = PER_STEP * self.end(&samples, cut)?;
        let omega = |index: usize| self.step * index as f64 / PER_STEP as f64;
        let away: Vec<f64> = (1..=end)
            .map(|index| self.root_from(cut, self.place(omega(index))))
            .collect();
        let is_least = |place: &usize| {
            let around = place.saturating_sub(1)..(place + 2).min(end);
            away[around].iter().all(|other| away[*place] <= *other)
        };
        let mut places: Vec<usize> = (0..end).filter(is_least).collect();
        places.sort_by(|one, other| away[*one].total_cmp(&away[*other]));
        Some(places.into_iter().map(|place| omega(place + 1)).collect())
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
        let value =
            |parameter: f64, omega: f64| self.characteristic(&at(parameter), self.place(omega));
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

/// The same of a product that turns by no more than may be followed; `None` of any other.
#[inline(always)]
fn passed(from: &Place, to: &Place) -> Option<i32> {
    let (one, other) = (from.product, to.product);
    let between = other * one.conj();
    // In place of the tangent of the largest turn.
    let is_followed = between.im.abs() <= LARGEST_TURN * between.re;
    let (was_below, is_below) = (one.im.is_sign_negative(), other.im.is_sign_negative());
    is_followed.then_some(match (was_below != is_below && one.re < 0.0, is_below) {
        (false, _) => 0,
        (true, true) => 1,
        (true, false) => -1,
    })
}

/// What the cut feeds back of a depth of cut that grows at a rate.
fn fed(cut: &SteadyCut, [torsion, axial]: [Complex64; 2]) -> Complex64 {
    axial * cut.weight - torsion * (cut.advance * cut.torque)
}

/// The most that it is with the delay, for responses of these sizes and any phases.
fn most_fed(cut: &SteadyCut, [torsion, axial]: [f64; 2]) -> f64 {
    2.0 * (axial * cut.weight + torsion * cut.advance * cut.torque)
}

/// The larger sizes of each motion.
fn larger(greatest: [f64; 2], sample: &Sample) -> [f64; 2] {
    std::array::from_fn(|motion| greatest[motion].max(sample.mobilities[motion].norm()))
}

impl Place {
    /// With (1 − e^(−st))/s, `delayed`.
    fn of(cut: &SteadyCut, omega: f64, sample: &Sample, delayed: Complex64) -> Self {
        Self {
            omega,
            product: sample.parts * (delayed * fed(cut, sample.mobilities) + 1.0),
        }
    }
}

impl Between {
    /// What is known at ω, rad/s, or is found now.
    fn at(&self, omega: f64, find: impl FnOnce() -> Sample) -> Sample {
        let bits = omega.to_bits();
        // Halvings change the first bits of what comes after the leading one; products mix them.
        let mixed = bits.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        let part = &self.parts[mixed as usize % PARTS_BETWEEN];
        let kept = || part.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = kept().get(&bits) {
            return *known;
        }
        let found = find();
        let mut kept = kept();
        if kept.len() < MOST_BETWEEN {
            kept.insert(bits, found);
        }
        found
    }
}

impl Samples {
    fn of(values: Vec<Sample>) -> Self {
        let sizes = values.iter().rev().scan([0.0; 2], |greatest, sample| {
            *greatest = larger(*greatest, sample);
            Some(*greatest)
        });
        let mut greatest_from_here: Vec<[f64; 2]> = sizes.collect();
        greatest_from_here.reverse();
        Self {
            values,
            greatest_from_here,
        }
    }
}

/// (1 − e^(−st))/s.
fn delayed(s: Complex64, time: f64) -> Complex64 {
    let x = s * time;
    if x.norm() < 1e-4 {
        return (1.0 - 0.5 * x + x * x / 6.0) * time;
    }
    (1.0 - (-x).exp()) / s
}
