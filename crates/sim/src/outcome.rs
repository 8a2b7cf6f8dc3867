//! What a simulation may leave out, and what it answers.

use crate::error::SimulationError;
use crate::watch::lateral::{LateralMeasures, LateralRegime};
use crate::watch::torsion::{TorsionMeasures, TorsionRegime};

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

/// Why a simulation ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// At the end of its time.
    End,
    /// The rest was known: out of contact the string is linear, and its future
    /// reaches no wall.
    Certain,
    /// Nothing changed any more ([`crate::watch::rules::Rules::settling_tolerance`]).
    Settled,
}

impl Ended {
    /// The word in result files.
    pub fn name(self) -> &'static str {
        match self {
            Ended::End => "end",
            Ended::Certain => "certain",
            Ended::Settled => "settled",
        }
    }
}

/// A regime of either motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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
}

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// Time stepped, s.
    pub simulated: f64,
    /// Why it ended.
    pub ended: Ended,
    /// The label predicted when motion settled, where it was followed to the end all the
    /// same.
    pub predicted: Option<Label>,
    /// Regime and measures of the bit, where it meets rock.
    pub torsion: Option<TorsionMeasures>,
    /// Regime and measures of the lateral motion, where it is modelled.
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
