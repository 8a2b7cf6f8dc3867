//! What a linear system is built from: the string, where it is looked at, and
//! how fast it is sampled. A sweep has one, or one for each value of the axes that
//! change the string.

use std::borrow::Cow;

use linear::{Drillstring, Method, Sites};

use super::file::{AutoOr, FileContent, MethodName};
use super::lateral::LateralSettings;
use super::resolve::{Check, Conditions, Sweep};
use super::source::{Source, SweepFileError};
use crate::accuracy::Choice;
use crate::design::Design;
use crate::quantities::{Axis, StringAxis};

/// A string, ready to be built.
#[derive(Debug, Clone)]
pub struct Setting {
    /// The drillstring.
    pub string: Drillstring,
    /// Sites from the surface down; the bit is always the last.
    pub sites: Sites,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// Whether that follows from the string by the paper's rule.
    pub sampling_by_rule: bool,
    /// Lateral motion, where it is modelled.
    pub lateral: Option<LateralSettings>,
}

impl Setting {
    /// What labels and measures need of this: without a wall only the bit has any, and
    /// places that are just looked at are left to whoever draws them.
    pub fn for_labels(&self) -> Cow<'_, Self> {
        if self.lateral.is_some() || self.sites.len() == 1 {
            return Cow::Borrowed(self);
        }
        Cow::Owned(Self {
            sites: Sites::bit(),
            ..self.clone()
        })
    }

    pub(super) fn resolve(
        source: &Source,
        content: &FileContent,
        conditions: &Conditions,
        design: &Design,
    ) -> Result<Self, SweepFileError> {
        let check = Check { source };
        let string = check.string(content)?;
        let (sampling_frequency, sampling_by_rule) = match content.sampling_frequency_hz {
            AutoOr::Auto => (linear::estimates::sampling_frequency(&string), true),
            AutoOr::Given(value) => {
                check.within("sampling_frequency_hz", value, 1.0, 1e6, "Hz")?;
                (value, false)
            }
        };
        let sites = check.sites(content, &string)?;
        let lateral = check.lateral(content, &string, &sites, conditions, design)?;
        check.impulses_are_sampled(lateral.as_ref(), sampling_frequency)?;
        Ok(Self {
            string,
            sites,
            sampling_frequency,
            sampling_by_rule,
            lateral,
        })
    }
}

impl Sweep {
    /// The setting of a case with the given values along the design's axes.
    ///
    /// # Errors
    /// Where these values make no string.
    pub fn setting_at(&self, values: &[f64]) -> Result<Cow<'_, Setting>, SweepFileError> {
        let axes = self
            .design
            .axes()
            .iter()
            .copied()
            .zip(values.iter().copied());
        self.setting_with(axes)
    }

    /// The setting with some quantities of the string changed; other axes do
    /// not matter here.
    ///
    /// # Errors
    /// As [`Sweep::setting_at`].
    pub fn setting_with(
        &self,
        values: impl Iterator<Item = (Axis, f64)>,
    ) -> Result<Cow<'_, Setting>, SweepFileError> {
        let changes: Vec<(StringAxis, f64)> = values
            .filter_map(|(axis, value)| match axis {
                Axis::String(axis) => Some((axis, value)),
                _ => None,
            })
            .collect();
        if changes.is_empty() {
            return Ok(Cow::Borrowed(&self.setting));
        }
        self.setting_of(self.content.clone(), changes)
            .map(Cow::Owned)
    }

    /// The setting of a case with the given values along the design's axes, sampled
    /// at another frequency (Hz).
    ///
    /// # Errors
    /// As [`Sweep::setting_at`], and where it samples an impulse too coarsely.
    pub fn setting_sampled(
        &self,
        values: &[f64],
        sampling_frequency: f64,
    ) -> Result<Setting, SweepFileError> {
        let mut content = self.content.clone();
        content.sampling_frequency_hz = AutoOr::Given(sampling_frequency);
        let axes = self.design.axes().iter().zip(values);
        let changes = axes.filter_map(|(axis, &value)| match axis {
            Axis::String(axis) => Some((*axis, value)),
            _ => None,
        });
        self.setting_of(content, changes.collect())
    }

    /// Uses the method and the sampling frequency chosen for the accuracy asked for.
    ///
    /// # Errors
    /// Where they do not suit the string as the file says it.
    pub fn choose(&mut self, method: Method, choice: Choice) -> Result<(), SweepFileError> {
        let content = &mut self.content;
        content.sampling_frequency_hz = AutoOr::Given(choice.chosen.sampling_frequency_hz);
        content.methods = vec![match method {
            Method::Hilbert(_) => MethodName::Hilbert,
            Method::Quadrature => MethodName::Quadrature,
            Method::Trapezoidal => MethodName::Trapezoidal,
            Method::FiniteElement(parameters) => {
                content.method.finite_element = parameters;
                MethodName::FiniteElement
            }
            Method::DirectIdft(_) => MethodName::DirectIdft,
        }];
        self.methods = vec![method];
        self.choice = Some(choice);
        self.setting = self.setting_of(self.content.clone(), Vec::new())?;
        Ok(())
    }

    fn setting_of(
        &self,
        mut content: FileContent,
        changes: Vec<(StringAxis, f64)>,
    ) -> Result<Setting, SweepFileError> {
        for (axis, value) in changes {
            let name = Axis::String(axis).name();
            self.source.checked(&name, content.set(axis, value))?;
        }
        Setting::resolve(&self.source, &content, &self.conditions, &self.design)
    }
}
