//! What a simulation may leave out, and what it answers.

use serde::{Deserialize, Serialize};

use crate::error::SimulationError;
use crate::label::{Label, Labels};
use crate::motion::{Motion, PerMotion};
use crate::watch::along::StringTorque;
use crate::watch::axial::AxialMeasures;
use crate::watch::lateral::{LateralMeasures, LateralRegime};
use crate::watch::stress::StressMeasures;
use crate::watch::surface::SurfaceMeasures;
use crate::watch::torsion::{TorsionMeasures, TorsionRegime};
use crate::words::with_words;

/// What a simulation may leave out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
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
    #[non_exhaustive]
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

/// What was measured of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Measures {
    /// Of the bit's rotation.
    Torsion(TorsionMeasures),
    /// Of lateral motion.
    Lateral(LateralMeasures),
    /// Of axial motion.
    Axial(AxialMeasures),
}

impl Measures {
    /// The regime.
    pub fn label(&self) -> Label {
        match self {
            Measures::Torsion(torsion) => torsion.regime.into(),
            Measures::Lateral(lateral) => lateral.regime.into(),
            Measures::Axial(axial) => axial.regime.into(),
        }
    }

    /// What may be no number, with its name.
    fn numbers(&self) -> Vec<(&'static str, f64)> {
        match self {
            Measures::Torsion(torsion) => torsion.numbers().to_vec(),
            Measures::Lateral(lateral) => lateral.numbers().to_vec(),
            Measures::Axial(axial) => axial.numbers().to_vec(),
        }
    }
}

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Outcome {
    /// Time stepped, s.
    pub simulated: f64,
    /// Why it ended.
    pub ended: Ended,
    /// The label predicted when motion settled, where it was followed to the end all the
    /// same.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub predicted: Option<Label>,
    /// Regime and measures of each motion that is modelled: of the bit, where it meets rock,
    /// of lateral motion, and of axial motion.
    #[serde(flatten)]
    pub measures: PerMotion<Option<Measures>>,
    /// What turns the surface, where that is followed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<SurfaceMeasures>,
    /// The greatest torque along the string, where that is followed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub string_torque: Option<StringTorque>,
    /// How the string was bent and stressed, where that is found.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stress: Option<StressMeasures>,
}

impl Outcome {
    /// What was measured of the bit, where it meets rock.
    pub fn torsion(&self) -> Option<TorsionMeasures> {
        match self.measures[Motion::Torsion] {
            Some(Measures::Torsion(torsion)) => Some(torsion),
            _ => None,
        }
    }

    /// What was measured of the lateral motion, where it is modelled.
    pub fn lateral(&self) -> Option<LateralMeasures> {
        match self.measures[Motion::Lateral] {
            Some(Measures::Lateral(lateral)) => Some(lateral),
            _ => None,
        }
    }

    /// What was measured of the axial motion, where the bit cuts.
    pub fn axial(&self) -> Option<AxialMeasures> {
        match self.measures[Motion::Axial] {
            Some(Measures::Axial(axial)) => Some(axial),
            _ => None,
        }
    }

    /// The regime of each motion.
    pub fn labels(&self) -> Labels {
        Labels::from_fn(|motion| self.measures[motion].as_ref().map(Measures::label))
    }

    /// Whether a motion was still fading when its time ended, so that its label may be another one
    /// later.
    pub fn fades(&self) -> bool {
        let torsion = self.torsion().is_some_and(|torsion| torsion.fades);
        let lying = self.lateral().and_then(|lateral| lateral.lying);
        torsion || lying.is_some_and(|lying| lying.fades)
    }

    /// Whether stick-slip was so irregular when its time ended that the bit may turn on later.
    pub fn is_irregular(&self) -> bool {
        self.torsion().is_some_and(|torsion| torsion.is_irregular)
    }

    /// The same outcome, in which motions that fade have undetermined labels.
    #[must_use]
    pub fn undetermined(mut self) -> Self {
        for motion in Motion::ALL {
            match &mut self.measures[motion] {
                Some(Measures::Torsion(torsion)) if torsion.fades => {
                    torsion.regime = TorsionRegime::Undetermined;
                }
                Some(Measures::Lateral(lateral)) if lateral.lying.is_some_and(|it| it.fades) => {
                    lateral.regime = LateralRegime::FadingSwing;
                }
                _ => {}
            }
        }
        self
    }

    /// Itself, unless what was measured is no number: squares and sums of finite
    /// motion may be none.
    pub(crate) fn finite(self) -> Result<Self, SimulationError> {
        let measures = self.measures.iter().filter_map(|(_, of)| of.as_ref());
        let mut all = measures.flat_map(Measures::numbers);
        match all.find(|(_, value)| !value.is_finite()) {
            Some((measure, _)) => Err(SimulationError::NotMeasured { measure }),
            None => Ok(self),
        }
    }
}
