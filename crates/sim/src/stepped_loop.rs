//! Whether steady drilling lasts as it is stepped: the linear limit of [`linear::regenerative`], with the
//! responses of a method, in its steps.
//!
//! With speeds held over steps of h, the law met in their middle and the rock between two ends of steps
//! straight, small motion that grows by z from step to step obeys
//!
//! D_h(z) = 1 + h [(1 + z⁻¹)/2 − z⁻ᵐ (1 − f + f z)]/(1 − z⁻¹) · [k_a A(z) − (V/Ω) k_t G(z)] = 0,
//! m − f = t_n/h + ½,
//!
//! with A and G the sums of taps times z⁻ᵏ. All of that is a power series in z⁻¹: the number of roots
//! outside a circle is how often D_h turns round zero along it.
//!
//! ```
//! use linear::regenerative::{CuttingLoop, SteadyCut};
//! use linear::{Axial, ChannelRequest, Drillstring, Hoist, Material, Method, Request, Section};
//! use linear::{Sites, TopDrive, Tube};
//! use sim::SteppedLoop;
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 2000.0, inner_radius: 0.054, outer_radius: 0.0635 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![pipe] }], 0.0)?;
//! let damping = linear::estimates::torsional_impedance(&string, &pipe) * 1.7 / 0.3;
//! let drive = TopDrive { inertia: 0.0, proportional_gain: damping, integral_gain: 0.0, delay: 0.0, late_inertia: 0.0 };
//! let string = string.with_top_drive(drive)?;
//! let hoist = Hoist { mass: 0.0, damping: 142_292.0 * 1.7 / 0.3, stiffness: 0.0 };
//! let rod = Axial { youngs_modulus: 210e9, damping: 0.0, hoist: Some(hoist) }.rod(&string)?;
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![
//!         ChannelRequest::Torsion { torques: vec![0] },
//!         ChannelRequest::Axial { rod: Box::new(rod.clone()), forces: vec![0] },
//!     ],
//!     sampling_frequency: 1000.0,
//!     longest_time: 60.0,
//! };
//! let responses = linear::responses(&string, &Method::Held, &request)?;
//! // What grows by less than a hundredfold in the minute does not count.
//! let growth = 100f64.ln() / 60.0;
//! let stepped = SteppedLoop::new(&responses, growth, 1.0).ok_or("there is a bit to be turned")?;
//! let exact = CuttingLoop::new(&string, &rod)?.faster_than(growth);
//! for speed in [6.0, 9.0, 22.0] {
//!     let cut = SteadyCut {
//!         delay: std::f64::consts::FRAC_PI_2 / speed,
//!         advance: 0.004 / speed,
//!         torque: 0.0,
//!         weight: 0.6 * 6e6 * 0.108 * 4.0,
//!     };
//!     assert_eq!(Some(stepped.growing(&cut)), exact.growing(&cut));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use std::f64::consts::{PI, TAU};

use linear::regenerative::SteadyCut;
use linear::{Complex64, Responses};
use numerics::fft;

/// Places on a circle for each step that responses or the delay between blades last: what turns there turns by
/// a small part of a turn from one to the next. Next to a limit a root adds nearly half a turn to that, so a limit
/// is off by a part of the distance of places: of 2 ten-thousandths with half as many.
const PLACES_A_STEP: f64 = 4.0;

/// More places are not tried: most of a gigabyte.
const MOST_PLACES: f64 = (1 << 25) as f64;

/// A string above a bit that cuts, in steps of one method.
#[derive(Debug, Clone)]
pub struct SteppedLoop {
    /// Time of a step, s.
    step: f64,
    /// By how much in a step small motion grows on the circle.
    radius: f64,
    /// Speeds per load in torsion and along the axis, from z = radius on its upper half to −radius.
    mobilities: [Vec<Complex64>; 2],
}

impl SteppedLoop {
    /// Of responses of the bit in torsion and along the axis; roots count that grow faster than this (1/s), of
    /// cuts whose blades pass after no longer than a delay, s. `None` without both responses, or where they last
    /// for too many steps.
    pub fn new(responses: &Responses, growth: f64, longest_delay: f64) -> Option<Self> {
        let step = responses.sampling_frequency.recip();
        let at_bit = [responses.torsion()?, responses.axial()?].map(|channel| {
            let bit = responses.sites.len() - 1;
            channel.taps_between(bit, bit)
        });
        let [torsion, axial] = [at_bit[0]?, at_bit[1]?];
        let lasts = torsion.len().max(axial.len()) as f64;
        let places = PLACES_A_STEP * lasts.max(longest_delay / step + 1.0);
        if places > MOST_PLACES {
            return None;
        }
        let places = (places.ceil() as usize).next_power_of_two();
        let radius = (growth * step).exp();
        Some(Self {
            step,
            radius,
            mobilities: [torsion, axial].map(|taps| on_circle(taps, radius, places)),
        })
    }

    /// Bytes that one takes while it is made, of responses of a number of steps at most.
    pub fn bytes(steps: f64) -> f64 {
        // Places are a power of two; samples and spectrum of the second motion next to the spectrum of the
        // first, each spectrum of half as many complex numbers.
        let places = 2.0 * (PLACES_A_STEP * steps).min(MOST_PLACES);
        4.0 * linear::budget::REAL * places
    }

    /// The number of roots that grow faster than that.
    pub fn growing(&self, cut: &SteadyCut) -> usize {
        let [torsion, axial] = &self.mobilities;
        let half = torsion.len() - 1;
        let behind = cut.delay / self.step + 0.5;
        let (back, part) = (behind.ceil(), behind.ceil() - behind);
        let of_back = self.radius.powf(-back);
        let characteristic = |place: usize| {
            let angle = PI * place as f64 / half as f64;
            let z = Complex64::from_polar(self.radius, angle);
            // Not by a product of turns, which rounding adds up in.
            let before = Complex64::from_polar(of_back, -(angle * back) % TAU);
            let inverse = z.inv();
            let cut_so_far = 0.5 * (inverse + 1.0) - before * (z * part + (1.0 - part));
            let apart = 1.0 - inverse;
            // Of what neither grows nor turns, all of the delay.
            let delayed = match apart == Complex64::ZERO {
                true => Complex64::from(cut.delay),
                false => cut_so_far * self.step / apart,
            };
            let fed = axial[place] * cut.weight - torsion[place] * (cut.advance * cut.torque);
            delayed * fed + 1.0
        };
        let mut turned = 0.0;
        let mut here = characteristic(0);
        for place in 1..=half {
            let next = characteristic(place);
            turned += (next * here.conj()).arg();
            here = next;
        }
        // Of both halves of the circle, by whole turns.
        (-turned / PI).round().max(0.0) as usize
    }
}

/// The sums of taps times z⁻ᵏ on the upper half of a circle, which has a number of places as a whole.
fn on_circle(taps: &[f64], radius: f64, places: usize) -> Vec<Complex64> {
    let mut samples = vec![0.0; places];
    for (index, (sample, tap)) in samples.iter_mut().zip(taps).enumerate() {
        *sample = tap * radius.powf(-(index as f64));
    }
    let plan = fft::forward(places);
    let mut spectrum = plan.make_output_vec();
    // Lengths are those of the plan.
    let _ = plan.process(&mut samples, &mut spectrum);
    spectrum
}
