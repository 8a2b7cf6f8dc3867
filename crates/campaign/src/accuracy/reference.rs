//! What candidates are held to: one method in short steps, and how far its answers may be
//! trusted.

use std::cell::OnceCell;
use std::time::Instant;

use anyhow::{Result, anyhow};
use linear::Method;
use sim::Stopping;

use super::answer::{Answer, Difference};
use super::candidates::candidate;
use super::forecast::{Forecast, ON_LATTICE};
use super::probes::Probes;
use super::strings::{Steps, Systems};
use crate::plan::Candidate;
use crate::words::short;

/// The reference's uncertainty is at most this part of the accuracy; it counts in full.
const PART: f64 = 0.5;

/// The method of the reference: nothing in it is approximate but the steps in which
/// forces are held.
pub const METHOD: Method = Method::Held;

/// What is reported of a choice in progress.
#[derive(Debug, Clone, PartialEq)]
pub enum SearchProgress {
    /// About how long it will take from here on.
    Expected(Expected),
    /// What is about to be built and simulated.
    Attempt(Attempt),
}

/// About how long choosing will take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// Time from here on, s.
    pub seconds: f64,
    /// Sampling frequency (Hz) of a reference that would be certain enough.
    pub reference_hz: f64,
}

/// What is about to be built and simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// Method and sampling frequency.
    pub candidate: Candidate,
    /// Whether it is to be the reference of the others.
    pub is_reference: bool,
    /// Time that it will take, about, s, where that is known.
    pub seconds: Option<f64>,
}

/// The references of a search.
pub struct References<'a> {
    /// The cases compared.
    pub probes: &'a Probes<'a>,
    /// The accuracy.
    pub asked: f64,
    /// Δ of Eq. 75 of every string as it is ([`super::strings::Strings::exact_undershoots`]).
    undershoots: Vec<f64>,
    /// Hears of all that is to be done before it is.
    tell: &'a dyn Fn(SearchProgress),
    /// How long it all takes, for telling.
    forecast: OnceCell<Forecast>,
}

impl<'a> References<'a> {
    /// None yet.
    ///
    /// # Errors
    /// Where a string cannot be cut into a lattice.
    pub fn new(
        probes: &'a Probes<'a>,
        asked: f64,
        tell: &'a dyn Fn(SearchProgress),
    ) -> Result<Self> {
        Ok(Self {
            probes,
            asked,
            undershoots: probes.strings.exact_undershoots()?,
            tell,
            forecast: OnceCell::new(),
        })
    }

    /// The answers in some steps, `frequency` of the first string's, each by a number of starts; others keep
    /// `held` bytes.
    pub fn stepped(
        &self,
        steps: Steps,
        frequency: f64,
        held: f64,
        (known, starts): (&[Answer], usize),
    ) -> Result<Reference> {
        let probes = self.probes;
        let fits = probes.strings.fits(METHOD, steps, held);
        let kept = fits.map_err(|why| {
            let frequency = short(frequency);
            anyhow!("at {frequency} Hz the reference {why}")
        })?;
        self.tell_of(&METHOD, frequency, true);
        let systems = probes.strings.systems(METHOD, steps);
        let start = Instant::now();
        let answers = match &systems {
            Ok(systems) => probes.answers(systems, Stopping::Full, known, starts),
            Err(_) => Vec::new(),
        };
        if let (Some(forecast), Ok(_)) = (self.forecast.get(), &systems) {
            forecast.took(frequency, start.elapsed().as_secs_f64());
        }
        Ok(Reference {
            frequency,
            systems,
            kept,
            answers,
            starts,
            uncertainty: Err(anyhow!("there is nothing to compare")),
            has_exact_responses: false,
            is_contested: false,
            seconded_by: None,
        })
    }

    /// A limit with others near is contested.
    pub fn look_for_islands(&self, reference: &mut Reference) {
        let Ok(systems) = &reference.systems else {
            return;
        };
        if let Err(reason) = (self.probes).check_for_islands(systems, &reference.answers) {
            reference.uncertainty = Err(reason);
            reference.is_contested = true;
        }
    }

    /// The systems by a method of the lowest of some sampling frequencies (Hz) that suits these
    /// cases, and it; from then on times can be estimated.
    pub fn first_look(&self, method: Method, frequencies: &[f64]) -> Option<(Systems, f64)> {
        let strings = &self.probes.strings;
        let (systems, steps, frequency) = frequencies.iter().find_map(|&frequency| {
            let steps = Steps::Frequency(frequency);
            strings.fits(method, steps, 0.0).ok()?;
            Some((strings.systems(method, steps).ok()?, steps, frequency))
        })?;
        // Again, with what serves all frequencies there.
        let start = Instant::now();
        let systems = strings.systems(method, steps).unwrap_or(systems);
        let building = start.elapsed().as_secs_f64();
        let part = if method == METHOD { 1.0 } else { ON_LATTICE };
        let building = part * building / frequency;
        (self.forecast).get_or_init(|| Forecast::of(self.probes, &systems, building));
        Some((systems, frequency))
    }

    /// Tells how long it will take from here on, with a reference at some frequency, Hz.
    pub fn tell_expected(&self, reference_hz: f64, seconds: impl Fn(&Forecast) -> f64) {
        if let Some(forecast) = self.forecast.get() {
            let seconds = seconds(forecast);
            (self.tell)(SearchProgress::Expected(Expected {
                seconds,
                reference_hz,
            }));
        }
    }

    /// Tells of an attempt before it is made, and about how long it will take.
    pub fn tell_of(&self, method: &Method, frequency: f64, is_reference: bool) {
        (self.tell)(SearchProgress::Attempt(Attempt {
            candidate: candidate(method, frequency),
            is_reference,
            seconds: self
                .forecast
                .get()
                .map(|forecast| forecast.round(frequency)),
        }));
    }

    /// Hears how many starts cases have from here on.
    pub fn has_starts(&self, starts: usize) {
        if let Some(forecast) = self.forecast.get() {
            forecast.has_starts(starts);
        }
    }

    /// The largest uncertainty of a reference.
    pub fn certain(&self) -> f64 {
        PART * self.asked
    }

    /// The error of linear responses; where a limit is looked for, also that of what it depends on.
    pub fn linear_error(&self, systems: &Systems, reference: &[Answer]) -> Result<Difference> {
        let has_limit = reference.iter().any(|answer| answer.limit.is_some());
        let undershoots = if has_limit {
            &self.undershoots[..]
        } else {
            &[]
        };
        self.probes.strings.linear_error(systems, undershoots)
    }
}

/// The reference's method at one sampling frequency.
pub struct Reference {
    /// Hz.
    pub frequency: f64,
    /// Its systems, or why it has none.
    pub systems: Result<Systems>,
    /// Memory that the systems take, bytes.
    pub kept: f64,
    /// Its answers; none without systems.
    pub answers: Vec<Answer>,
    /// Of each of them.
    pub starts: usize,
    /// By how much they may be wrong.
    pub uncertainty: Result<Difference>,
    /// Whether its linear responses are near enough to the exact ones.
    pub has_exact_responses: bool,
    /// Whether its answers would do, but for what another method says, or for islands.
    pub is_contested: bool,
    /// The method of another family whose answers count in that.
    pub seconded_by: Option<&'static str>,
}

impl Reference {
    /// Whether its uncertainty is known, and no more than this.
    pub fn is_certain(&self, certain: f64) -> bool {
        matches!(&self.uncertainty, Ok(found) if found.part <= certain)
    }
}
