//! `methods` and `[method]`: the linear methods and their parameters.

use clap::ValueEnum;
use linear::Method;
use linear::method::{FiniteElement, Transform};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A linear method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum MethodName {
    /// Loads held over every step, answered exactly: the default but for strings that lie on more than 12 sites.
    Held,
    /// Convolution quadrature, BDF2.
    Quadrature,
    /// The paper's digital filter.
    Hilbert,
    /// Finite elements with Newmark's scheme.
    FiniteElement,
    /// As `held`, but in bending by the poles of the string: for walls at many sites, and the default there.
    Poles,
    /// Counterexample: the plain inverse DFT, by which a sticking bit chatters.
    DirectIdft,
    /// Counterexample: convolution quadrature by the trapezoidal rule, by which the highest
    /// frequencies ring on.
    Trapezoidal,
}

impl MethodName {
    /// That of a method; every method of a sweep has one.
    pub fn of(method: &Method) -> Option<Self> {
        let mut all = Self::value_variants().iter().copied();
        all.find(|name| name.name() == method.name())
    }

    /// The name used in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            MethodName::Held => "held",
            MethodName::Hilbert => "hilbert",
            MethodName::Quadrature => "quadrature",
            MethodName::FiniteElement => "finite-element",
            MethodName::Poles => "poles",
            MethodName::DirectIdft => "direct-idft",
            MethodName::Trapezoidal => "trapezoidal",
        }
    }
}

/// Parameters of the methods, one table each.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
pub struct MethodTables {
    /// Parameters of `hilbert`.
    pub hilbert: Transform,
    /// Parameters of `direct-idft`.
    pub direct_idft: Transform,
    /// Parameters of `finite-element`.
    pub finite_element: FiniteElement,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_is_found_by_its_name() {
        let methods = [
            Method::Held,
            Method::Quadrature,
            Method::Hilbert(Transform::default()),
            Method::FiniteElement(FiniteElement::default()),
            Method::Poles,
            Method::DirectIdft(Transform::default()),
            Method::Trapezoidal,
        ];
        assert_eq!(methods.len(), MethodName::value_variants().len());
        for method in methods {
            let name = MethodName::of(&method).map(MethodName::name);
            assert_eq!(name, Some(method.name()));
        }
    }
}
