//! Which labels of a case are certain, where a run certifies them.

use linear::Method;
use serde::{Deserialize, Serialize};

use super::motion::{Labels, Motion};
use crate::engine::{Certified, FINER, finer_frequency};
use crate::plan::Sweep;
use crate::words::short;

/// What certifies the labels of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CertifiedBy {
    /// Two methods that share no equation.
    pub methods: [String; 2],
    /// The sampling frequencies of both, Hz; of the string as the file says it, where axes
    /// change the string.
    pub sampling_frequencies_hz: [f64; 2],
    /// The sampling frequency in place of the second, Hz, at which `held` takes steps of one piece
    /// of the lattice, where those are shorter; of the string as the file says it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exact_fronts_hz: Option<f64>,
}

impl CertifiedBy {
    /// Of a sweep that does.
    pub fn of(sweep: &Sweep) -> Option<Self> {
        let places = sweep.certifying?;
        let frequency = sweep.setting.sampling_frequency;
        let finest = places.map(|place| finer_frequency(&sweep.setting, &sweep.methods[place]));
        let finest = finest.into_iter().fold(0.0, f64::max);
        Some(Self {
            methods: places.map(|place| sweep.methods[place].name().to_owned()),
            sampling_frequencies_hz: [frequency, FINER * frequency],
            exact_fronts_hz: (finest > FINER * frequency).then_some(finest),
        })
    }

    /// The sampling frequencies in words.
    pub fn frequencies(&self) -> String {
        let [first, second] = self.sampling_frequencies_hz.map(short);
        let finest = (self.exact_fronts_hz).map_or_else(String::new, |finest| {
            let held = Method::Held.name();
            format!(" ({held}: {} Hz)", short(finest))
        });
        format!("{first} and {second} Hz{finest}")
    }
}

/// Whether the labels of a row are certain: none of a motion without a label, and none where
/// a run does not certify.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Certainty {
    /// That of the bit's rotation.
    pub torsion: Option<bool>,
    /// That of lateral motion.
    pub lateral: Option<bool>,
}

impl Certainty {
    /// Of a row with these labels: those that the case is certain to have.
    pub fn of(labels: Labels, certified: Certified) -> Self {
        Self {
            torsion: (labels.torsion).map(|label| certified.torsion == Some(label)),
            lateral: (labels.lateral).map(|label| certified.lateral == Some(label)),
        }
    }

    /// Of the label of a motion.
    pub fn get(self, motion: Motion) -> Option<bool> {
        match motion {
            Motion::Torsion => self.torsion,
            Motion::Lateral => self.lateral,
        }
    }
}

#[cfg(test)]
mod tests {
    use sim::TorsionRegime;

    use super::*;

    const SMOOTH: TorsionRegime = TorsionRegime::Smooth;

    #[test]
    fn a_row_is_certain_where_its_own_label_is() {
        let certified = Certified {
            torsion: Some(SMOOTH),
            lateral: None,
        };
        let of = |regime| {
            let labels = Labels {
                torsion: regime,
                lateral: None,
            };
            Certainty::of(labels, certified)
        };
        assert_eq!(of(Some(SMOOTH)).torsion, Some(true));
        assert_eq!(of(Some(TorsionRegime::StickSlip)).torsion, Some(false));
        assert_eq!(of(None), Certainty::default());
    }
}
