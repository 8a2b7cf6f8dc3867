//! The two motions of a string and the labels of each: a scene with a bit has a
//! torsion label, one with a wall a lateral label, one with both has two.

use sim::{LateralRegime, TorsionRegime};

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
    pub fn labels(self) -> &'static [&'static str] {
        const TORSION: [&str; 3] = [
            TorsionRegime::Stuck.name(),
            TorsionRegime::Smooth.name(),
            TorsionRegime::StickSlip.name(),
        ];
        const LATERAL: [&str; 4] = [
            LateralRegime::NoContact.name(),
            LateralRegime::TransientContact.name(),
            LateralRegime::BackwardWhirl.name(),
            LateralRegime::ForwardWhirl.name(),
        ];
        match self {
            Motion::Torsion => &TORSION,
            Motion::Lateral => &LATERAL,
        }
    }

    /// Whether a label says that vibration is sustained, which a map draws as a
    /// circle; none for the label of a case too short to tell, or none at all.
    pub fn is_sustained(self, label: &str) -> Option<bool> {
        let tells = !label.is_empty() && label != TorsionRegime::Stuck.name();
        let sustained = [
            TorsionRegime::StickSlip.name(),
            LateralRegime::BackwardWhirl.name(),
            LateralRegime::ForwardWhirl.name(),
        ];
        tells.then(|| sustained.contains(&label))
    }

    /// Sustained vibration, and its absence, as a person reads them.
    pub fn regimes(self) -> [&'static str; 2] {
        match self {
            Motion::Torsion => ["stick-slip", "smooth"],
            Motion::Lateral => ["sustained whirl", "no sustained whirl"],
        }
    }
}
