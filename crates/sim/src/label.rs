//! Regimes of any motion, as labels.

use std::cmp::Ordering;
use std::fmt;

use serde::{Deserialize, Serialize};

use crate::motion::{Motion, PerMotion};
use crate::watch::axial::AxialRegime;
use crate::watch::lateral::LateralRegime;
use crate::watch::torsion::TorsionRegime;

/// A regime of a motion, in the order of their words, which all differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Label {
    /// Of the bit's rotation.
    Torsion(TorsionRegime),
    /// Of lateral motion.
    Lateral(LateralRegime),
    /// Of axial motion.
    Axial(AxialRegime),
}

impl Label {
    /// All labels of a motion.
    pub fn all(motion: Motion) -> Vec<Self> {
        match motion {
            Motion::Torsion => TorsionRegime::ALL.map(Label::Torsion).to_vec(),
            Motion::Lateral => LateralRegime::ALL.map(Label::Lateral).to_vec(),
            Motion::Axial => AxialRegime::ALL.map(Label::Axial).to_vec(),
        }
    }

    /// What it is about.
    pub fn motion(self) -> Motion {
        match self {
            Label::Torsion(_) => Motion::Torsion,
            Label::Lateral(_) => Motion::Lateral,
            Label::Axial(_) => Motion::Axial,
        }
    }

    /// The label in result files.
    pub fn name(self) -> &'static str {
        match self {
            Label::Torsion(regime) => regime.name(),
            Label::Lateral(regime) => regime.name(),
            Label::Axial(regime) => regime.name(),
        }
    }

    /// The one that a word means.
    pub fn of_name(name: &str) -> Option<Self> {
        let mut all = Motion::ALL.into_iter().flat_map(Self::all);
        all.find(|label| label.name() == name)
    }

    /// Whether it is one of sustained vibration, which a map draws as a circle and one start of
    /// a bistable case has; `None` for a case too short to tell.
    pub fn is_sustained(self) -> Option<bool> {
        match self {
            Label::Torsion(TorsionRegime::Stuck | TorsionRegime::Undetermined)
            | Label::Lateral(LateralRegime::FadingSwing) => None,
            Label::Torsion(regime) => Some(regime != TorsionRegime::Smooth),
            Label::Axial(regime) => Some(regime != AxialRegime::Steady),
            Label::Lateral(regime) => Some(matches!(
                regime,
                LateralRegime::BackwardWhirl | LateralRegime::ForwardWhirl
            )),
        }
    }

    /// Whether it is snaking: less than sustained vibration, more than none ([`Motion::lesser_regime`]).
    pub fn is_snaking(self) -> bool {
        self == Label::Lateral(LateralRegime::Snaking)
    }
}

impl From<TorsionRegime> for Label {
    fn from(regime: TorsionRegime) -> Self {
        Label::Torsion(regime)
    }
}

impl From<AxialRegime> for Label {
    fn from(regime: AxialRegime) -> Self {
        Label::Axial(regime)
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

/// The labels of a case by a method, one for each motion that is modelled; none of a case
/// without an answer.
pub type Labels = PerMotion<Option<Label>>;

impl Labels {
    /// Each label.
    pub fn each(self) -> impl Iterator<Item = Label> {
        Motion::ALL
            .into_iter()
            .filter_map(move |motion| self[motion])
    }

    /// Whether any motion has one.
    pub fn is_answer(self) -> bool {
        self != Self::default()
    }

    /// Whether a motion is sustained vibration; `None` where it has no label, or that of a
    /// case too short to tell.
    pub fn is_sustained(self, motion: Motion) -> Option<bool> {
        self[motion]?.is_sustained()
    }
}

/// As a person reads them.
impl fmt::Display for Labels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = self.each().map(Label::name).collect();
        if names.is_empty() {
            f.write_str("no answer")
        } else {
            f.write_str(&names.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_label_has_a_word_and_a_motion() {
        for motion in Motion::ALL {
            for label in Label::all(motion) {
                assert_eq!(Label::of_name(label.name()), Some(label));
                assert_eq!(label.motion(), motion);
            }
        }
        assert_eq!(Label::of_name("sideways"), None);
    }

    #[test]
    fn labels_are_read_one_after_the_other() {
        let mut labels = Labels::default();
        assert_eq!(labels.to_string(), "no answer");
        labels[Motion::Lateral] = Some(LateralRegime::NoContact.into());
        labels[Motion::Torsion] = Some(TorsionRegime::Smooth.into());
        assert_eq!(labels.to_string(), "smooth, no_contact");
    }
}
