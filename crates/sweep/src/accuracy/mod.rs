//! `accuracy`: the cheapest method and sampling frequency whose error, estimated on
//! the sweep's own string and cases, is within what was asked for.
//!
//! What a case costs grows with f_s and hardly depends on the method, for all are
//! stepped alike; so the ladder goes up in f_s, and at each of its frequencies from
//! the method that is built the fastest to the slowest. Nothing is timed: the same
//! sweep chooses the same on any machine, or is refused where that has too little memory
//! for what is to be tried.
//!
//! The reference is one method ([`Probes::reference`]) at a frequency where the last
//! two doublings changed the answers by no more than a part of the accuracy; that
//! change is its uncertainty, and counts in full. The error of a candidate is the
//! largest of
//!
//! - that of its linear responses, on smooth motions, from the exact ones
//!   ([`linear::deviation`]), which share no time step with anything,
//! - the shift of the limit between regimes, by surface speed or by friction, near a
//!   few of the sweep's cases ([`probes`]),
//! - that of the numbers a person would quote of those cases ([`answer`]),
//!
//! the last two as root mean squares over these cases.

mod answer;
mod ladder;
mod probes;

use linear::Method;
use linear::estimates::sampling_frequency;
use sim::Stopping;

use crate::memory::Limit;
use crate::plan::{Candidate, Choice, Sweep, Tried};
use crate::sweep_file::{Accuracy, SweepFileError, per_cent};
use answer::{Answer, largest_error};
use ladder::{FREQUENCIES, candidates};
use probes::{Probes, Systems};

/// The reference's uncertainty is at most this part of the accuracy; it counts in full.
const REFERENCE_PART: f64 = 0.5;

/// What is about to be built and simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// Method and sampling frequency.
    pub candidate: Candidate,
    /// Whether it is to be the reference of the others.
    pub is_reference: bool,
}

/// Where the sweep asks for an accuracy, the method chosen for it and the choice, which
/// has the sampling frequency. `tell` hears of each attempt before it is made, which may
/// take minutes.
///
/// # Errors
/// Where nothing delivers the accuracy within the memory, or the sweep's cases cannot
/// be.
pub fn choose(
    sweep: &Sweep,
    full: bool,
    limit: &Limit,
    tell: &dyn Fn(Attempt),
) -> Result<Option<(Method, Choice)>, SweepFileError> {
    let Some(Accuracy(asked)) = sweep.content.accuracy else {
        return Ok(None);
    };
    let stopping = if full {
        Stopping::Full
    } else {
        Stopping::Early
    };
    let at_key = |reason: String| sweep.source.error("accuracy", reason);
    let search = Search {
        probes: &Probes::of(sweep, asked, limit).map_err(at_key)?,
        asked,
        stopping,
        tell,
    };
    search.run().map(Some).map_err(at_key)
}

/// A search for the cheapest candidate.
struct Search<'a> {
    probes: &'a Probes<'a>,
    asked: f64,
    /// When the cases of candidates end.
    stopping: Stopping,
    tell: &'a dyn Fn(Attempt),
}

impl Search<'_> {
    fn run(&self) -> Result<(Method, Choice), String> {
        let asked = self.asked;
        let mut rungs = self.up_to_reference()?;
        let mut tried: Vec<Tried> = Vec::new();
        let mut next = 0;
        loop {
            let [below @ .., before, reference] = &rungs[..] else {
                return Err("the ladder of sampling frequencies is too short".to_owned());
            };
            let held = memory_of(&rungs);
            let uncertainty = uncertainty_of(&rungs, asked)
                .map_err(|reason| format!("the reference: {reason}"))?
                .part;
            for rung in below.iter().chain([before]).skip(next) {
                let found =
                    self.try_rung(rung, reference, held, asked - uncertainty, &mut tried)?;
                if let Some((method, chosen, error)) = found {
                    let choice = Choice {
                        asked,
                        delivered: error + uncertainty,
                        chosen,
                        reference_method: reference.method.name().to_owned(),
                        reference_hz: reference.frequency,
                        reference_uncertainty: uncertainty,
                        probes: self.probes.cases(),
                        tried,
                    };
                    return Ok((method, choice));
                }
            }
            next = rungs.len() - 1;
            // Finer than the reference has to be, but nothing coarser delivers.
            match FREQUENCIES.get(rungs.len()) {
                Some(&frequency) => {
                    let rung = self
                        .build_rung(frequency, &rungs)
                        .map_err(|reason| format!("{}; {reason}", none_delivers(asked, &tried)))?;
                    rungs.push(rung);
                }
                None => return Err(none_delivers(asked, &tried)),
            }
        }
    }

    /// The first candidate at one frequency whose error is within `allowed`, with that;
    /// `held` bytes are taken already.
    ///
    /// # Errors
    /// Where a candidate takes too much memory to be tried; a sentence.
    fn try_rung(
        &self,
        rung: &Rung,
        reference: &Rung,
        held: f64,
        allowed: f64,
        tried: &mut Vec<Tried>,
    ) -> Result<Option<(Method, Candidate, f64)>, String> {
        let probes = self.probes;
        for method in candidates() {
            let candidate = ladder::candidate(&method, rung.frequency);
            (self.tell)(Attempt {
                candidate: candidate.clone(),
                is_reference: false,
            });
            let is_built = method == rung.method;
            if !is_built {
                (probes.fits(method, rung.frequency, held))
                    .map_err(|reason| format!("{candidate} {reason}"))?;
            }
            let built = (!is_built).then(|| probes.systems(method, rung.frequency));
            let systems = built.as_ref().unwrap_or(&rung.systems);
            let found = error_of(probes, systems, &reference.answers, allowed, self.stopping);
            let error = found.as_ref().ok().map(|error| error.part);
            tried.push(Tried {
                candidate: candidate.clone(),
                error,
                of: found.map_or_else(|reason| reason, |error| error.of),
            });
            if let Some(error) = error.filter(|error| *error <= allowed) {
                return Ok(Some((method, candidate, error)));
            }
            // What the quadrature cannot treat, no other method can.
            if method == Method::Quadrature && systems.is_err() {
                break;
            }
        }
        Ok(None)
    }

    /// The reference's method at every frequency up to the first that can be the
    /// reference.
    fn up_to_reference(&self) -> Result<Vec<Rung>, String> {
        let asked = self.asked;
        let least = sampling_frequency(&self.probes.sweep.setting.string);
        let mut rungs: Vec<Rung> = Vec::new();
        let mut best = "no two frequencies can be compared".to_owned();
        for frequency in FREQUENCIES {
            match self.build_rung(frequency, &rungs) {
                Ok(rung) => rungs.push(rung),
                Err(reason) => {
                    best = reason;
                    break;
                }
            }
            match uncertainty_of(&rungs, asked) {
                Ok(error) if frequency >= least && error.part <= REFERENCE_PART * asked => {
                    return Ok(rungs);
                }
                Ok(error) => {
                    let percent = per_cent(error.part);
                    best = format!(
                        "from a quarter of {frequency} Hz to that, {} changes by {percent} %",
                        error.of
                    );
                }
                Err(reason) => best = format!("from a quarter of {frequency} Hz to that, {reason}"),
            }
        }
        let (asked, part) = (per_cent(asked), per_cent(REFERENCE_PART * asked));
        Err(format!(
            "{asked} % cannot be told: the reference is to be certain to {part} %, but {best}"
        ))
    }

    /// Finer frequencies only take more memory: an error ends the search.
    fn build_rung(&self, frequency: f64, before: &[Rung]) -> Result<Rung, String> {
        let probes = self.probes;
        let method = probes.reference();
        let held = memory_of(before);
        let kept = (probes.fits(method, frequency, held))
            .map_err(|reason| format!("at {frequency} Hz the reference {reason}"))?;
        (self.tell)(Attempt {
            candidate: ladder::candidate(&method, frequency),
            is_reference: true,
        });
        let systems = probes.systems(method, frequency);
        let known = before.last().map_or(&[][..], |before| &before.answers);
        let answers = match &systems {
            Ok(systems) => probes.answers(systems, Stopping::Full, known),
            Err(_) => Vec::new(),
        };
        Ok(Rung {
            method,
            frequency,
            systems,
            kept,
            answers,
        })
    }
}

fn none_delivers(asked: f64, tried: &[Tried]) -> String {
    let known = tried.iter().filter_map(|tried| Some((tried.error?, tried)));
    let best = known.min_by(|one, other| one.0.total_cmp(&other.0));
    let best = best.map_or_else(String::new, |(error, tried)| {
        let (percent, of) = (per_cent(error), &tried.of);
        format!(
            "; the best, {}, has an error of {percent} % ({of})",
            tried.candidate
        )
    });
    format!("nothing delivers {} %{best}", per_cent(asked))
}

/// The reference's method at one frequency.
struct Rung {
    method: Method,
    frequency: f64,
    systems: Result<Systems, String>,
    /// Memory that the systems take, bytes.
    kept: f64,
    answers: Vec<Answer>,
}

/// Memory that the systems of some frequencies take, bytes.
fn memory_of(rungs: &[Rung]) -> f64 {
    rungs.iter().map(|rung| rung.kept).sum()
}

/// By how much the last answers may be wrong: by what they changed over two doublings,
/// for over one they may agree by chance.
fn uncertainty_of(rungs: &[Rung], asked: f64) -> Result<answer::Error, String> {
    match rungs {
        [.., quarter, _, whole] => largest_error(&quarter.answers, &whole.answers, asked),
        _ => Err("there are not three frequencies to compare".to_owned()),
    }
}

/// The error of a candidate, of its linear responses alone if that is more than
/// `allowed`, or why it has none.
fn error_of(
    probes: &Probes,
    systems: &Result<Systems, String>,
    reference: &[Answer],
    allowed: f64,
    stopping: Stopping,
) -> Result<answer::Error, String> {
    let systems = systems.as_ref().map_err(String::clone)?;
    let linear = probes.linear_error(systems)?;
    if linear.part > allowed {
        return Ok(linear);
    }
    let answers = probes.answers(systems, stopping, reference);
    let simulated = largest_error(&answers, reference, allowed)?;
    Ok(if linear.part > simulated.part {
        linear
    } else {
        simulated
    })
}
