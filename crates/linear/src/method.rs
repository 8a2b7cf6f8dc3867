//! The methods that turn a drillstring into discrete impulse responses.
//!
//! ```
//! use linear::Method;
//! use linear::method::FiniteElement;
//!
//! let newmark = FiniteElement::default();
//! assert!((newmark.beta() - 0.25 * (0.5 + 0.52f64).powi(2)).abs() < 1e-15);
//! assert!(newmark.check().is_ok());
//! // Below γ/2 a step can be too long to be stable.
//! assert!(FiniteElement { beta: Some(0.2), ..newmark }.check().is_err());
//! assert_eq!(Method::FiniteElement(newmark).name(), "finite-element");
//! ```

use serde::{Deserialize, Serialize};

use crate::error::BuildError;

/// A linear method with its parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// The paper's digital filter (Eqs. 39–40).
    Hilbert(Transform),
    /// Loads held over every step, answered exactly by the mean motion over it.
    Held,
    /// Convolution quadrature with BDF2.
    Quadrature,
    /// Convolution quadrature with the trapezoidal rule: a counterexample, which fails.
    Trapezoidal,
    /// Finite elements with Newmark's scheme (Section 3).
    FiniteElement(FiniteElement),
    /// As [`Method::Held`] in torsion and along the axis, and in bending by the poles of the string
    /// ([`crate::poles`]): for many sites.
    Poles,
    /// The plain inverse discrete Fourier transform: a counterexample, which fails.
    DirectIdft(Transform),
}

impl Method {
    /// The part of a step that is still to go when its loads and its motion are taken: 0
    /// where they are sampled, step k at k/f_s; ½ where loads are held over the step and
    /// motion is the mean over it, step k from k/f_s to (k + 1)/f_s.
    pub fn collocation_offset(&self) -> f64 {
        match self {
            Method::Held | Method::Poles => 0.5,
            _ => 0.0,
        }
    }

    /// Whether its responses are the same in both directions to the last digit. Those that are sampled
    /// at zero frequency are so but for the rounding of what they are there, and those of poles but for
    /// what loss the shapes leave out.
    pub fn is_reciprocal(&self) -> bool {
        !matches!(
            self,
            Method::Hilbert(_) | Method::DirectIdft(_) | Method::Poles
        )
    }

    /// The name used in files and on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            Method::Hilbert(_) => "hilbert",
            Method::Held => "held",
            Method::Quadrature => "quadrature",
            Method::Trapezoidal => "trapezoidal",
            Method::FiniteElement(_) => "finite-element",
            Method::Poles => "poles",
            Method::DirectIdft(_) => "direct-idft",
        }
    }
}

/// Length of the discrete Fourier transform behind a filter.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Transform {
    /// Length of the discrete Fourier transform; its inverse is the frequency resolution. Half of
    /// it becomes the impulse response by `hilbert`, all of it by `direct-idft`. Left out, as long
    /// as the response lasts.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.01, max = 1e5)))]
    #[serde(rename = "transform_s")]
    pub seconds: Option<f64>,
}

/// Parameters of the finite-element method.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct FiniteElement {
    /// Elements in a cell of drillpipe. The default, as in the paper, is for cells as the
    /// string has them, at most 12 m long, in any division of its lengths: a section of one
    /// part of 1000 m has 1667.
    #[cfg_attr(feature = "schema", schemars(range(min = 1, max = 10_000)))]
    pub elements_per_cell: usize,
    /// Newmark's γ; ½ has no numerical damping, and chatters. Left out above a bit that cuts, where
    /// there is no wall, a sweep has 0.502.
    #[cfg_attr(feature = "schema", schemars(range(min = 0.5, max = 1.0)))]
    pub gamma: f64,
    /// Newmark's β, at least γ/2. Left out it is ¼(½ + γ)², the least that is stable at any
    /// step with the strongest damping of the highest frequencies.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1.0)))]
    pub beta: Option<f64>,
}

impl Default for FiniteElement {
    fn default() -> Self {
        Self {
            elements_per_cell: 20,
            gamma: 0.52,
            beta: None,
        }
    }
}

impl FiniteElement {
    /// β as given or by its rule.
    pub fn beta(&self) -> f64 {
        self.beta
            .unwrap_or_else(|| 0.25 * (0.5 + self.gamma).powi(2))
    }

    /// Checks that the scheme is unconditionally stable for the string alone.
    ///
    /// # Errors
    /// Where γ < ½, β < γ/2 or there are no elements.
    pub fn check(&self) -> Result<(), BuildError> {
        let refuse = |name, value, expected| {
            Err(BuildError::Parameter {
                name,
                value,
                expected,
            })
        };
        if self.elements_per_cell == 0 {
            return refuse("elements_per_cell", 0.0, "at least 1");
        }
        if !(0.5..=1.0).contains(&self.gamma) {
            return refuse("gamma", self.gamma, "0.5 to 1");
        }
        if !(self.beta() >= self.gamma / 2.0 && self.beta() <= 1.0) {
            return refuse("beta", self.beta(), "gamma / 2 to 1");
        }
        Ok(())
    }
}
