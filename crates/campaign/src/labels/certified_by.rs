//! What certifies the labels of a run.

use linear::Method;
use serde::{Deserialize, Serialize};

use crate::engine::finer_frequency;
use crate::plan::Sweep;
use crate::records::FINER;
use crate::words::short;

/// What certifies the labels of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CertifiedBy {
    /// Two methods that share no equation.
    pub methods: [String; 2],
    /// The sampling frequencies of both, Hz, the lower of both methods and the higher where these differ; of
    /// the string as the file says it, where axes change the string.
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
        let settings = places.map(|place| sweep.setting.by(&sweep.methods[place]));
        let [one, other] = settings
            .each_ref()
            .map(|setting| setting.sampling_frequency);
        let (frequency, finer) = (one.min(other), FINER * one.max(other));
        let finest = [0, 1].map(|it| finer_frequency(&settings[it], &sweep.methods[places[it]]));
        let finest = finest.into_iter().fold(0.0, f64::max);
        Some(Self {
            methods: places.map(|place| sweep.methods[place].name().to_owned()),
            sampling_frequencies_hz: [frequency, finer],
            exact_fronts_hz: (finest > finer).then_some(finest),
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
