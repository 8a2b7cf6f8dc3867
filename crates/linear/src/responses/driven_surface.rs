//! The surface below a top drive as a place where a further torque may act: what a drive that gives
//! less torque than its controller asks for differs by from the linear one, which is part of the
//! string's responses.
//!
//! ```
//! use linear::{ChannelRequest, DrivenSurfacePlan, Drillstring, Material, Method, Request, Section};
//! use linear::{Budget, Sites, TopDrive, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let drive = TopDrive { inertia: 2000.0, proportional_gain: 3e3, integral_gain: 1e3, delay: 0.0, late_inertia: 0.0 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 100, parts: vec![pipe] }], 0.02)?
//!     .with_top_drive(drive)?;
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: 200.0,
//!     longest_time: 60.0,
//! };
//! let surface = DrivenSurfacePlan::new(&string, &Method::Quadrature, &request)?
//!     .build(&Budget::unlimited())?;
//! // In a minute it turns as it is set to, and its integral makes up for any torque.
//! assert!((surface.speed_by_set.iter().sum::<f64>() - 1.0).abs() < 1e-5);
//! let first = surface.speed_by_torque[0];
//! assert!(surface.speed_by_torque.iter().sum::<f64>().abs() < 1e-3 * first);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::request::Request;
use super::torsion::TorsionPlan;
use super::wanted::Wanted;
use crate::budget::{Budget, OutOfBudget, What};
use crate::drillstring::Drillstring;
use crate::elements::newmark::Weights;
use crate::error::BuildError;
use crate::method::Method;
use crate::responses::length::all_finite;
use crate::top_drive::TopDrive;

/// How a string below its drive moves at the surface, with a torque there. Taps have those of
/// [`crate::Responses`] as their model.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct DrivenSurface {
    /// The drive.
    pub drive: TopDrive,
    /// By which method.
    pub method: Method,
    /// Sampling frequency f_s, Hz.
    pub sampling_frequency: f64,
    /// Speed of the surface from the speed that its drive is set to.
    pub speed_by_set: Vec<f64>,
    /// Speed of the surface from a torque there, rad/s per N m.
    pub speed_by_torque: Vec<f64>,
    /// Speed of each site from a torque at the surface, rad/s per N m; by reciprocity that of the
    /// surface from a torque at the site.
    pub sites_by_torque: Vec<Vec<f64>>,
    /// How the drive integrates its error by this method.
    pub integral: IntegralRule,
}

/// How a method integrates over its steps: I(k) = Σ b(n) e(k − n) + Σ a(n) I(k − 1 − n).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IntegralRule {
    /// b, s.
    pub of_values: [f64; 3],
    /// a.
    pub of_integrals: [f64; 2],
}

impl IntegralRule {
    /// That of a method, in the steps of a sampling frequency (Hz); `None` of one that makes its
    /// taps in the frequency domain.
    fn of(method: &Method, sampling_frequency: f64) -> Result<Option<Self>, BuildError> {
        let step = sampling_frequency.recip();
        Ok(Some(match method {
            // Means over a step, and exact at its ends.
            Method::Held | Method::Poles | Method::Trapezoidal => Self {
                of_values: [0.5 * step, 0.5 * step, 0.0],
                of_integrals: [1.0, 0.0],
            },
            Method::Quadrature => Self {
                of_values: [2.0 * step / 3.0, 0.0, 0.0],
                of_integrals: [4.0 / 3.0, -1.0 / 3.0],
            },
            // Eqs. 64 and 65, the acceleration eliminated.
            Method::FiniteElement(parameters) => {
                let Weights { gamma, beta, step } = Weights::new(parameters, sampling_frequency)?;
                let weights = [beta, 0.5 + gamma - 2.0 * beta, 0.5 - gamma + beta];
                Self {
                    of_values: weights.map(|weight| weight * step / gamma),
                    of_integrals: [(2.0 * gamma - 1.0) / gamma, (1.0 - gamma) / gamma],
                }
            }
            Method::Hilbert(_) | Method::DirectIdft(_) => return Ok(None),
        }))
    }
}

/// The same before its taps are built.
#[derive(Debug)]
pub struct DrivenSurfacePlan<'a> {
    torsion: TorsionPlan<'a>,
    drive: TopDrive,
    method: Method,
    sampling_frequency: f64,
    integral: IntegralRule,
}

impl<'a> DrivenSurfacePlan<'a> {
    /// By one method, for the string, sites, time and sampling frequency of a request.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::new`], and where the string has no drive, one with a delay, or the
    /// method does not integrate step by step.
    pub fn new(
        string: &'a Drillstring,
        method: &'a Method,
        request: &'a Request,
    ) -> Result<Self, BuildError> {
        request.check(string)?;
        let drive = string.top_drive().filter(|drive| drive.delay == 0.0);
        let drive = drive.ok_or(BuildError::NoPromptDrive)?;
        let sampling_frequency = request.sampling_frequency;
        let integral = IntegralRule::of(method, sampling_frequency)?;
        let name = method.name();
        Ok(Self {
            torsion: TorsionPlan::new(string, method, request, Wanted::AtSurface, None)?,
            drive,
            method: *method,
            sampling_frequency,
            integral: integral.ok_or(BuildError::NotStepByStep { method: name })?,
        })
    }

    /// Number of taps, at most.
    pub fn taps(&self) -> usize {
        self.torsion.taps()
    }

    /// What building takes of a budget.
    ///
    /// # Errors
    /// Where that is more than is left.
    pub fn ask(&self, budget: &Budget) -> Result<(), OutOfBudget> {
        budget.pass(self.torsion.need(), What::Responses)
    }

    /// Builds the taps.
    ///
    /// # Errors
    /// As [`crate::ResponsePlan::build`].
    pub fn build(&self, budget: &Budget) -> Result<DrivenSurface, BuildError> {
        let built = self.torsion.taps_of_all(budget)?;
        all_finite(&built.taps, &self.method)?;
        built.memory.keep();
        let mut taps = built.taps.into_iter();
        let mut next = || taps.next().unwrap_or_default();
        Ok(DrivenSurface {
            drive: self.drive,
            method: self.method,
            sampling_frequency: self.sampling_frequency,
            speed_by_set: next(),
            speed_by_torque: next(),
            sites_by_torque: taps.collect(),
            integral: self.integral,
        })
    }
}
