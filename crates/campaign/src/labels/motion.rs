//! The two motions of a string and the labels of each: a scene with a bit has a
//! torsion label, one with a wall a lateral label, one with both has two.

use std::fmt;

use sim::{Label, LateralRegime, Outcome, TorsionRegime};

/// What a label is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// How the bit turns.
    Torsion,
    /// How the string moves sideways.
    Lateral,
}

impl Motion {
    /// Both, in the order of their columns.
    pub const ALL: [Motion; 2] = [Motion::Torsion, Motion::Lateral];

    /// Its column in `labels.csv`.
    pub fn key(self) -> &'static str {
        match self {
            Motion::Torsion => "torsion",
            Motion::Lateral => "lateral",
        }
    }

    /// As a heading.
    pub fn title(self) -> &'static str {
        match self {
            Motion::Torsion => "Torsion",
            Motion::Lateral => "Lateral motion",
        }
    }

    /// As an adjective.
    pub fn adjective(self) -> &'static str {
        match self {
            Motion::Torsion => "torsional",
            Motion::Lateral => "lateral",
        }
    }

    /// Its labels.
    pub fn labels(self) -> Vec<Label> {
        match self {
            Motion::Torsion => TorsionRegime::ALL.map(Label::Torsion).to_vec(),
            Motion::Lateral => LateralRegime::ALL.map(Label::Lateral).to_vec(),
        }
    }

    /// What a label is about.
    pub fn of(label: Label) -> Self {
        match label {
            Label::Torsion(_) => Motion::Torsion,
            Label::Lateral(_) => Motion::Lateral,
        }
    }

    /// Sustained vibration, and its absence, as a person reads them.
    pub fn regimes(self) -> [&'static str; 2] {
        match self {
            Motion::Torsion => ["stick-slip", "smooth"],
            Motion::Lateral => ["sustained whirl", "no sustained whirl"],
        }
    }
}

/// The labels of a case by a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Labels {
    /// Of the bit's rotation.
    pub torsion: Option<TorsionRegime>,
    /// Of lateral motion.
    pub lateral: Option<LateralRegime>,
}

impl Labels {
    /// Those of an outcome.
    pub fn of(outcome: &Outcome) -> Self {
        Self {
            torsion: outcome.torsion.map(|torsion| torsion.regime),
            lateral: outcome.lateral.map(|lateral| lateral.regime),
        }
    }

    /// That of a motion.
    pub fn get(self, motion: Motion) -> Option<Label> {
        match motion {
            Motion::Torsion => self.torsion.map(Label::Torsion),
            Motion::Lateral => self.lateral.map(Label::Lateral),
        }
    }

    /// Every one.
    pub fn each(self) -> impl Iterator<Item = Label> {
        Motion::ALL
            .into_iter()
            .filter_map(move |motion| self.get(motion))
    }

    /// Whether there is any.
    pub fn is_answer(self) -> bool {
        self != Self::default()
    }

    /// Whether a motion is sustained vibration, which a map draws as a circle; none for
    /// the label of a case too short to tell, or none at all.
    pub fn is_sustained(self, motion: Motion) -> Option<bool> {
        is_sustained(self.get(motion)?)
    }
}

/// Whether a label is one of sustained vibration, which the other start of a bistable case has;
/// none for that of a case too short to tell.
pub fn is_sustained(label: Label) -> Option<bool> {
    match label {
        Label::Torsion(TorsionRegime::Stuck) => None,
        Label::Torsion(regime) => Some(regime != TorsionRegime::Smooth),
        Label::Lateral(regime) => Some(matches!(
            regime,
            LateralRegime::BackwardWhirl | LateralRegime::ForwardWhirl
        )),
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
