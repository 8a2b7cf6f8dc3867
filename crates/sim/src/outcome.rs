//! What a simulation may leave out, and what it answers.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use crate::error::SimulationError;
use crate::watch::along::StringTorque;
use crate::watch::lateral::{LateralMeasures, LateralRegime};
use crate::watch::surface::SurfaceMeasures;
use crate::watch::torsion::{TorsionMeasures, TorsionRegime};
use crate::words::with_words;

/// What a simulation may leave out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stopping {
    /// Nothing: every step to the end of the time.
    Full,
    /// What is certain is not stepped, and settled motion ends it.
    Early,
    /// As [`Stopping::Early`], but settled motion is followed to the end, to see
    /// whether it was settled.
    Checked,
}

with_words! {
    /// Why a simulation ended.
    pub enum Ended {
        /// At the end of its time.
        End = "end",
        /// The rest was known: out of contact the string is linear, and its future
        /// reaches no wall.
        Certain = "certain",
        /// Nothing changed any more ([`crate::watch::rules::Rules::settling_tolerance`]).
        Settled = "settled",
    }
}

/// A regime of either motion, in the order of their words, which all differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Label {
    /// Of the bit's rotation.
    Torsion(TorsionRegime),
    /// Of lateral motion.
    Lateral(LateralRegime),
}

impl Label {
    /// The label in result files.
    pub fn name(self) -> &'static str {
        match self {
            Label::Torsion(regime) => regime.name(),
            Label::Lateral(regime) => regime.name(),
        }
    }

    /// The one that a word means.
    pub fn of_name(name: &str) -> Option<Self> {
        let torsion = TorsionRegime::of_name(name).map(Label::Torsion);
        torsion.or_else(|| LateralRegime::of_name(name).map(Label::Lateral))
    }
}

impl From<TorsionRegime> for Label {
    fn from(regime: TorsionRegime) -> Self {
        Label::Torsion(regime)
    }
}

impl From<LateralRegime> for Label {
    fn from(regime: LateralRegime) -> Self {
        Label::Lateral(regime)
    }
}

impl Ord for Label {
    fn cmp(&self, other: &Self) -> Ordering {
        self.name().cmp(other.name())
    }
}

impl PartialOrd for Label {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Time stepped, s.
    pub simulated: f64,
    /// Why it ended.
    pub ended: Ended,
    /// The label predicted when motion settled, where it was followed to the end all the
    /// same.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub predicted: Option<Label>,
    /// Regime and measures of the bit, where it meets rock.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torsion: Option<TorsionMeasures>,
    /// What turns the surface, where that is followed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceMeasures>,
    /// The greatest torque along the string, where that is followed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub string_torque: Option<StringTorque>,
    /// Regime and measures of the lateral motion, where it is modelled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub lateral: Option<LateralMeasures>,
}

impl Outcome {
    /// Itself, unless what was measured is no number: squares and sums of finite
    /// motion may be none.
    pub(crate) fn finite(self) -> Result<Self, SimulationError> {
        let of_torsion = self.torsion.iter().flat_map(TorsionMeasures::numbers);
        let of_bending = self.lateral.iter().flat_map(LateralMeasures::numbers);
        let mut all = of_torsion.chain(of_bending);
        match all.find(|(_, value)| !value.is_finite()) {
            Some((measure, _)) => Err(SimulationError::NotMeasured { measure }),
            None => Ok(self),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_label_has_a_word_of_its_own() {
        let torsion = TorsionRegime::ALL.map(Label::Torsion).into_iter();
        for label in torsion.chain(LateralRegime::ALL.map(Label::Lateral)) {
            assert_eq!(Label::of_name(label.name()), Some(label));
        }
    }
}
