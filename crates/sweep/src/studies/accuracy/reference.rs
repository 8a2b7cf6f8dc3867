//! What candidates are held to: one method in short steps, and how far its answers may be
//! trusted.

use std::cell::Cell;
use std::time::Instant;

use anyhow::{Result, anyhow};
use linear::Method;
use sim::Stopping;

use super::answer::{Answer, Difference};
use super::candidates::candidate;
use super::probes::Probes;
use super::strings::{Steps, Systems};
use crate::plan::Candidate;
use crate::words::short;

/// The reference's uncertainty is at most this part of the accuracy; it counts in full.
const PART: f64 = 0.5;

/// The method of the reference: nothing in it is approximate but the steps in which
/// forces are held.
pub const METHOD: Method = Method::Held;

/// What is about to be built and simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// Method and sampling frequency.
    pub candidate: Candidate,
    /// Whether it is to be the reference of the others.
    pub is_reference: bool,
    /// Time that it will take, about, s, where something has been tried already.
    pub seconds: Option<f64>,
}

/// The references of a search.
pub struct References<'a> {
    /// The cases compared.
    pub probes: &'a Probes<'a>,
    /// The accuracy.
    pub asked: f64,
    /// Δ of Eq. 75 of every string as it is ([`Probes::exact_undershoots`]).
    undershoots: Vec<f64>,
    /// Hears of each attempt before it is made.
    tell: &'a dyn Fn(Attempt),
    /// Time that stepping the last reference took for each hertz, s: for telling, nothing is
    /// chosen by it.
    pace: Cell<Option<f64>>,
}

impl<'a> References<'a> {
    /// None yet.
    ///
    /// # Errors
    /// Where a string cannot be cut into a lattice.
    pub fn new(probes: &'a Probes<'a>, asked: f64, tell: &'a dyn Fn(Attempt)) -> Result<Self> {
        Ok(Self {
            probes,
            asked,
            undershoots: probes.strings.exact_undershoots()?,
            tell,
            pace: Cell::new(None),
        })
    }

    /// The answers in some steps, `frequency` of the first string's; others keep `held`
    /// bytes.
    pub fn stepped(
        &self,
        steps: Steps,
        frequency: f64,
        held: f64,
        known: &[Answer],
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
            Ok(systems) => probes.answers(systems, Stopping::Full, known),
            Err(_) => Vec::new(),
        };
        self.pace
            .set(Some(start.elapsed().as_secs_f64() / frequency));
        Ok(Reference {
            frequency,
            systems,
            kept,
            answers,
            uncertainty: Err(anyhow!("there is nothing to compare")),
            has_exact_responses: false,
            is_contested: false,
            seconded_by: None,
        })
    }

    /// A limit with others near is contested.
    pub fn look_for_islands(&self, reference: &mut Reference) {
        if let Ok(systems) = &reference.systems
            && let Err(reason) = (self.probes).check_for_islands(systems, &reference.answers)
        {
            reference.uncertainty = Err(reason);
            reference.is_contested = true;
        }
    }

    /// Tells of an attempt before it is made, and about how long it will take: as much
    /// longer than the last as its steps are shorter.
    pub fn tell_of(&self, method: &Method, frequency: f64, is_reference: bool) {
        (self.tell)(Attempt {
            candidate: candidate(method, frequency),
            is_reference,
            seconds: self.pace.get().map(|pace| pace * frequency),
        });
    }

    /// The largest uncertainty of a reference.
    pub fn certain(&self) -> f64 {
        PART * self.asked
    }

    /// The error of linear responses; where a limit is looked for, also that of what it
    /// hangs on.
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
