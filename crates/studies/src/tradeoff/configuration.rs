//! The ways to compute responses that are compared.

use linear::Method;
use linear::method::FiniteElement;

use campaign::accuracy::methods::{Parameters, hilbert};
use campaign::words::counted;

/// Transforms behind the digital filter, s. The paper's filters last 10 s, from
/// transforms of 20.
const TRANSFORMS: [f64; 4] = [8.0, 20.0, 40.0, 160.0];

/// The transform behind the paper's filters, s.
pub const PAPER_TRANSFORM: f64 = 20.0;

/// Elements in one cell of the drillpipe.
const ELEMENTS: [usize; 5] = [1, 2, 5, 10, 20];

/// Newmark's γ: without numerical damping, and the paper's choice.
const GAMMAS: [f64; 2] = [0.5, 0.52];

/// The paper's sampling frequency, Hz: 638.9 by its rule, "about 640".
pub const PAPER_FREQUENCY: f64 = 640.0;

/// A sampling frequency this close to it is the paper's.
const ABOUT: f64 = 0.005;

/// What makes the taps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scheme {
    /// A method that simulations can use.
    Method(Method),
    /// Two-stage Radau quadrature, for linear responses alone.
    Radau,
}

/// One way to compute responses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Configuration {
    /// What makes the taps.
    pub scheme: Scheme,
    /// f_s, Hz; of Radau quadrature, whole steps a second.
    pub sampling_frequency: f64,
}

/// Every configuration over a ladder of sampling frequencies (Hz).
pub fn configurations(ladder: &[f64]) -> Vec<Configuration> {
    let elements = GAMMAS.into_iter().flat_map(|gamma| {
        ELEMENTS.map(|elements_per_cell| {
            Method::FiniteElement(FiniteElement {
                elements_per_cell,
                gamma,
                ..FiniteElement::default()
            })
        })
    });
    std::iter::once(Method::Quadrature)
        .chain(TRANSFORMS.map(hilbert))
        .chain(elements)
        .map(Scheme::Method)
        .chain([Scheme::Radau, Scheme::Method(Method::Held)])
        .flat_map(|scheme| {
            ladder.iter().map(move |&sampling_frequency| Configuration {
                scheme,
                sampling_frequency,
            })
        })
        .collect()
}

impl Configuration {
    /// The kind of method: a colour and a symbol of the chart.
    pub fn family(&self) -> &'static str {
        match self.scheme {
            Scheme::Method(Method::FiniteElement(parameters)) if parameters.gamma == GAMMAS[0] => {
                "finite-element, γ = 0.5"
            }
            Scheme::Method(Method::FiniteElement(_)) => "finite-element, γ = 0.52",
            _ => self.method(),
        }
    }

    /// The method's name.
    pub fn method(&self) -> &'static str {
        match self.scheme {
            Scheme::Radau => "radau-quadrature",
            Scheme::Method(method) => method.name(),
        }
    }

    /// The parameters of its method.
    pub fn parameters(&self) -> Parameters {
        match self.scheme {
            Scheme::Radau => Parameters::default(),
            Scheme::Method(method) => Parameters::of(&method),
        }
    }

    /// Method and parameters, without f_s.
    pub fn title(&self) -> String {
        let (family, parameters) = (self.family(), self.parameters());
        match (parameters.elements_per_cell, parameters.transform_s) {
            (Some(elements), _) => format!("{family}, {}", counted(elements, "element")),
            (_, Some(seconds)) => format!("{family} of {seconds} s"),
            _ => family.to_owned(),
        }
    }

    /// Which of the paper's two own ways this is.
    pub fn paper(&self) -> Option<Paper> {
        if (self.sampling_frequency / PAPER_FREQUENCY - 1.0).abs() > ABOUT {
            return None;
        }
        match self.scheme {
            Scheme::Method(method) if method == hilbert(PAPER_TRANSFORM) => Some(Paper::Filter),
            // Those by default are the paper's.
            Scheme::Method(Method::FiniteElement(elements)) => {
                (elements == FiniteElement::default()).then_some(Paper::Elements)
            }
            _ => None,
        }
    }
}

/// The ways of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paper {
    /// Digital filters of ten seconds at 640 Hz.
    Filter,
    /// Twenty elements a section at 640 Hz.
    Elements,
}
