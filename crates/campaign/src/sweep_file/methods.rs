//! `methods` and `[method]`: the linear methods and their parameters.

use clap::ValueEnum;
use linear::method::{FiniteElement, Transform};
use serde::{Deserialize, Serialize};

/// A linear method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum MethodName {
    /// Held loads, answered exactly.
    #[value(help = "loads held over every step, answered exactly: the default")]
    Held,
    /// Convolution quadrature, BDF2.
    #[value(help = "convolution quadrature, BDF2")]
    Quadrature,
    /// The paper's digital filter.
    #[value(help = "the paper's digital filter")]
    Hilbert,
    /// Finite elements, Newmark.
    #[value(help = "finite elements with Newmark's scheme")]
    FiniteElement,
    /// Plain inverse DFT, which fails.
    #[value(help = "plain inverse DFT, kept to show that it fails")]
    DirectIdft,
    /// Convolution quadrature, trapezoidal rule, which fails.
    #[value(help = "convolution quadrature, trapezoidal rule, kept to show that it chatters")]
    Trapezoidal,
}

impl MethodName {
    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            MethodName::Held => "held",
            MethodName::Hilbert => "hilbert",
            MethodName::Quadrature => "quadrature",
            MethodName::FiniteElement => "finite-element",
            MethodName::DirectIdft => "direct-idft",
            MethodName::Trapezoidal => "trapezoidal",
        }
    }
}

/// Parameters of the methods, one table each.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct MethodTables {
    /// `[method.hilbert]`
    pub hilbert: Transform,
    /// `[method.direct-idft]`
    pub direct_idft: Transform,
    /// `[method.finite-element]`
    pub finite_element: FiniteElement,
}
