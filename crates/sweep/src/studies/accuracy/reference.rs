//! What candidates are held to: one method in ever shorter steps, and how far its answers
//! may be trusted.

use std::cell::Cell;
use std::time::Instant;

use anyhow::{Result, anyhow, bail};
use linear::Method;
use sim::Stopping;

use super::answer::{Answer, Difference, largest_difference};
use super::candidates::{candidate, off_beat};
use super::probes::Probes;
use super::strings::{Steps, Systems};
use crate::plan::Candidate;
use crate::words::short;

/// The reference's uncertainty is at most this part of the accuracy; it counts in full.
const PART: f64 = 0.5;

/// The method of the reference: nothing in it is approximate but the steps in which
/// forces are held.
pub const METHOD: Method = Method::Held;

/// Another family is heard where its linear responses are within this part of what a
/// reference may be uncertain by: limits are off by more than the responses they hang on.
const TELLING: f64 = 0.2;

/// The family that comes nearest to the exact responses with a wall, without being the
/// reference's; the digital filter loses the slow tail in bending.
const OTHER_WITH_A_WALL: Method = Method::Quadrature;

/// Pieces of the lattice in a step of a first look.
const FIRST_PIECES: f64 = 16.0;

/// Linear responses whose error is no more than this are exact enough for any limit that is
/// not ragged.
const EXACT: f64 = 0.01;

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

/// The references of a search, at one frequency after the other.
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

    /// The reference with a wall: that at a frequency, after those at lower ones.
    ///
    /// # Errors
    /// Where it takes too much memory.
    pub fn next(&self, frequency: f64, before: &[Reference]) -> Result<Reference> {
        let held = memory_of(before);
        let known = before.last().map_or(&[][..], |before| &before.answers);
        let steps = Steps::Frequency(frequency);
        let mut reference = self.stepped(steps, frequency, held, known)?;
        reference.uncertainty = self.uncertainty_of(&mut reference, before);
        if !reference.is_certain(self.certain()) {
            return Ok(reference);
        }
        let travel = self.probes.strings.travel()?;
        let off_beat = off_beat(frequency, travel).map(|frequency| (METHOD, frequency));
        for (method, frequency) in std::iter::once((OTHER_WITH_A_WALL, frequency)).chain(off_beat) {
            let steps = Steps::Frequency(frequency);
            self.ask_another(&mut reference, method, steps, frequency, held);
            if !reference.is_certain(self.certain()) {
                reference.is_contested = true;
                return Ok(reference);
            }
        }
        self.look_for_islands(&mut reference);
        Ok(reference)
    }

    /// The reference in torsion: steps of one piece of the string's lattice, so short that
    /// each front arrives at every place in time, and none rises within a step. (On many
    /// strings a limit hangs on that: a front that rises within a step sends a dip ahead of
    /// its echo, which stops a bit that has nearly stopped. Finer and finer steps that are
    /// not in time with all of the string may agree with one another on another limit.)
    /// Steps of two pieces, and the digital filter, count in its uncertainty.
    ///
    /// # Errors
    /// Where it takes too much memory.
    pub fn in_pieces(&self) -> Result<Reference> {
        let frequency = self.probes.strings.frequency_of_pieces()?;
        let stepped = |pieces: f64, held: f64, known: &[Answer]| {
            self.stepped(Steps::Pieces(pieces), frequency / pieces, held, known)
        };
        // What says how long it will take, and where limits are about.
        let first = stepped(FIRST_PIECES, 0.0, &[])?;
        let mut whole = stepped(1.0, 0.0, &first.answers)?;
        let half = stepped(0.5, whole.kept, &whole.answers)?;
        whole.uncertainty = self.uncertainty_in_pieces(&whole, &half);
        if whole.is_certain(self.certain()) {
            self.look_for_islands(&mut whole);
        }
        Ok(whole)
    }

    fn uncertainty_in_pieces(&self, whole: &Reference, half: &Reference) -> Result<Difference> {
        let systems = (whole.systems.as_ref()).map_err(|reason| anyhow!("{reason}"))?;
        let linear = self.linear_error(systems, &whole.answers)?;
        let change = largest_difference(&half.answers, &whole.answers, self.asked)?;
        Ok(if change.part > linear.part {
            change
        } else {
            linear
        })
    }

    /// The answers in some steps, `frequency` of the first string's; others keep `held`
    /// bytes.
    fn stepped(
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
    fn look_for_islands(&self, reference: &mut Reference) {
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

    /// By how much the answers of the reference may be wrong: by what they changed over
    /// the last doubling and over the last two, for over either they may agree by chance,
    /// and by what its linear responses are off from the exact ones, which share nothing
    /// with it.
    fn uncertainty_of(
        &self,
        reference: &mut Reference,
        before: &[Reference],
    ) -> Result<Difference> {
        let [.., quarter, half] = before else {
            bail!("there is nothing to compare");
        };
        let systems = (reference.systems.as_ref()).map_err(|reason| anyhow!("{reason}"))?;
        let mut largest = self.linear_error(systems, &reference.answers)?;
        reference.has_exact_responses = largest.part <= EXACT.min(self.certain());
        for coarser in [half, quarter] {
            let change = largest_difference(&coarser.answers, &reference.answers, self.asked)?;
            if change.part > largest.part {
                largest = change;
            }
        }
        Ok(largest)
    }

    /// Where another method's linear responses are near enough to the exact ones, what its
    /// answers differ by from the reference's counts too. (Where they are not, and with
    /// sharp fronts those of another family rarely are, its answers tell nothing.)
    fn ask_another(
        &self,
        reference: &mut Reference,
        method: Method,
        steps: Steps,
        frequency: f64,
        held: f64,
    ) {
        let held = held + reference.kept;
        if self.probes.strings.fits(method, steps, held).is_err() {
            return;
        }
        self.tell_of(&method, frequency, true);
        let Ok(systems) = self.probes.strings.systems(method, steps) else {
            return;
        };
        if method != METHOD {
            match self.linear_error(&systems, &reference.answers) {
                Ok(linear) if linear.part <= TELLING * self.certain() => {}
                _ => return,
            }
            reference.seconded_by = Some(method.name());
        }
        let answers = self
            .probes
            .answers(&systems, Stopping::Full, &reference.answers);
        let difference = largest_difference(&answers, &reference.answers, self.asked);
        let is_larger = match (&difference, &reference.uncertainty) {
            (Ok(other), Ok(own)) => other.part > own.part,
            (Err(_), _) => true,
            (Ok(_), Err(_)) => false,
        };
        if is_larger {
            let candidate = candidate(&method, frequency);
            reference.uncertainty = difference
                .map(|found| Difference {
                    of: format!("{} by {candidate}", found.of),
                    ..found
                })
                .map_err(|reason| anyhow!("{candidate} differs: {reason}"));
        }
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
    has_exact_responses: bool,
    /// Whether its answers would do, but for what another method says, or for islands.
    is_contested: bool,
    /// The method of another family whose answers count in that.
    pub seconded_by: Option<&'static str>,
}

impl Reference {
    /// Whether its uncertainty is known, and no more than this.
    pub fn is_certain(&self, certain: f64) -> bool {
        matches!(&self.uncertainty, Ok(found) if found.part <= certain)
    }
}

/// References whose responses are exact and whose answers are not certain, before limits
/// count as ragged; and of those that would do but for others, so many one after the other.
const PATIENCE: usize = 5;
const CONTESTED: usize = 2;

/// Whether finer steps will not make the last reference certain: the responses have been
/// exact enough for long, and the limits hang on something else.
pub fn is_ragged(references: &[Reference]) -> bool {
    let exact = references
        .iter()
        .filter(|reference| reference.has_exact_responses)
        .count();
    let last = references.iter().rev().take(CONTESTED);
    exact >= PATIENCE || last.filter(|reference| reference.is_contested).count() == CONTESTED
}

/// Memory that the systems of some frequencies take, bytes.
pub fn memory_of(references: &[Reference]) -> f64 {
    references.iter().map(|reference| reference.kept).sum()
}
