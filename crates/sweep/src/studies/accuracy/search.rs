//! The search for the cheapest candidate.

use anyhow::{Error, Result, anyhow, bail};
use linear::Method;
use linear::estimates::sampling_frequency;
use sim::Stopping;

use super::answer::{Answer, Difference, largest_difference};
use super::candidates::{FREQUENCIES, candidate, methods};
use super::probes::{Probes, Systems};
use crate::plan::{Candidate, Choice, Tried};
use crate::sweep_file::per_cent;

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

/// A search for the cheapest candidate.
pub struct Search<'a> {
    /// The cases compared.
    pub probes: &'a Probes<'a>,
    /// The accuracy.
    pub asked: f64,
    /// When the cases of candidates end.
    pub stopping: Stopping,
    /// Hears of each attempt before it is made.
    pub tell: &'a dyn Fn(Attempt),
}

impl Search<'_> {
    /// The method chosen, and the choice.
    ///
    /// # Errors
    /// Where nothing delivers the accuracy within the memory.
    pub fn run(&self) -> Result<(Method, Choice)> {
        let asked = self.asked;
        let mut rungs = self.up_to_reference()?;
        let mut tried: Vec<Tried> = Vec::new();
        let mut next = 0;
        while let Some((reference, below)) = rungs.split_last() {
            let held = memory_of(&rungs);
            let uncertainty = uncertainty_of(&rungs, asked)
                .map_err(|reason| anyhow!("the reference: {reason}"))?
                .part;
            let allowed = asked - uncertainty;
            for rung in &below[next..] {
                let found = self.try_rung(rung, &reference.answers, held, allowed, &mut tried)?;
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
            next = below.len();
            // Finer than the reference has to be, but nothing coarser delivers.
            let Some(&frequency) = FREQUENCIES.get(rungs.len()) else {
                break;
            };
            let finer = self.build_rung(frequency, &rungs);
            rungs.push(finer.map_err(|reason| {
                let best = format!("{}; {reason}", best_of(&tried));
                nothing_delivers(asked, &best)
            })?);
        }
        Err(nothing_delivers(asked, &best_of(&tried)))
    }

    /// The first candidate at one frequency whose error is within `allowed`, with that;
    /// `held` bytes are taken already.
    ///
    /// # Errors
    /// Where a candidate takes too much memory to be tried.
    fn try_rung(
        &self,
        rung: &Rung,
        reference: &[Answer],
        held: f64,
        allowed: f64,
        tried: &mut Vec<Tried>,
    ) -> Result<Option<(Method, Candidate, f64)>> {
        for method in methods() {
            let candidate = candidate(&method, rung.frequency);
            (self.tell)(Attempt {
                candidate: candidate.clone(),
                is_reference: false,
            });
            let built = if method == rung.method {
                None
            } else {
                let fits = self.probes.fits(method, rung.frequency, held);
                fits.map_err(|why| anyhow!("{candidate} {why}"))?;
                Some(self.probes.systems(method, rung.frequency))
            };
            let systems = built.as_ref().unwrap_or(&rung.systems);
            let (error, of) = match systems {
                Ok(systems) => match self.error_of(systems, reference, allowed) {
                    Ok(error) => (Some(error.part), error.of),
                    Err(reason) => (None, reason.to_string()),
                },
                Err(reason) => (None, reason.to_string()),
            };
            tried.push(Tried {
                candidate: candidate.clone(),
                error,
                of,
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

    /// The error of a candidate, of its linear responses alone if that is more than
    /// `allowed`.
    fn error_of(
        &self,
        systems: &Systems,
        reference: &[Answer],
        allowed: f64,
    ) -> Result<Difference> {
        let linear = self.probes.linear_error(systems)?;
        if linear.part > allowed {
            return Ok(linear);
        }
        let answers = self.probes.answers(systems, self.stopping, reference);
        let simulated = largest_difference(&answers, reference, allowed)?;
        Ok(if linear.part > simulated.part {
            linear
        } else {
            simulated
        })
    }

    /// The reference's method at every frequency up to the first that can be the
    /// reference.
    fn up_to_reference(&self) -> Result<Vec<Rung>> {
        let asked = self.asked;
        let certain = REFERENCE_PART * asked;
        let least = sampling_frequency(&self.probes.sweep.setting.string);
        let mut rungs: Vec<Rung> = Vec::new();
        let mut best = "no two frequencies can be compared".to_owned();
        for frequency in FREQUENCIES {
            match self.build_rung(frequency, &rungs) {
                Ok(rung) => rungs.push(rung),
                Err(reason) => {
                    best = reason.to_string();
                    break;
                }
            }
            let change = match uncertainty_of(&rungs, asked) {
                Ok(error) if frequency >= least && error.part <= certain => return Ok(rungs),
                Ok(error) => format!("{} changes by {} %", error.of, per_cent(error.part)),
                Err(reason) => reason.to_string(),
            };
            best = format!("from a quarter of {frequency} Hz to that, {change}");
        }
        let (asked, certain) = (per_cent(asked), per_cent(certain));
        bail!("{asked} % cannot be told: the reference is to be certain to {certain} %, but {best}")
    }

    /// Finer frequencies only take more memory: an error ends the search.
    fn build_rung(&self, frequency: f64, before: &[Rung]) -> Result<Rung> {
        let probes = self.probes;
        let method = probes.reference();
        let fits = probes.fits(method, frequency, memory_of(before));
        let kept = fits.map_err(|why| anyhow!("at {frequency} Hz the reference {why}"))?;
        (self.tell)(Attempt {
            candidate: candidate(&method, frequency),
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

/// The reference's method at one sampling frequency.
struct Rung {
    method: Method,
    /// Hz.
    frequency: f64,
    /// Its systems, or why it has none.
    systems: Result<Systems>,
    /// Memory that the systems take, bytes.
    kept: f64,
    /// Its answers; none without systems.
    answers: Vec<Answer>,
}

/// Memory that the systems of some frequencies take, bytes.
fn memory_of(rungs: &[Rung]) -> f64 {
    rungs.iter().map(|rung| rung.kept).sum()
}

/// By how much the last answers may be wrong: by what they changed over two doublings,
/// for over one they may agree by chance.
fn uncertainty_of(rungs: &[Rung], asked: f64) -> Result<Difference> {
    let [.., quarter, _, whole] = rungs else {
        bail!("there is nothing to compare");
    };
    largest_difference(&quarter.answers, &whole.answers, asked)
}

/// Everything tried is further from the reference than the accuracy asked for.
fn nothing_delivers(asked: f64, best: &str) -> Error {
    anyhow!("nothing delivers {} %{best}", per_cent(asked))
}

/// The best of what was tried, in words.
fn best_of(tried: &[Tried]) -> String {
    let known = tried.iter().filter_map(|tried| Some((tried.error?, tried)));
    let best = known.min_by(|one, other| one.0.total_cmp(&other.0));
    best.map_or_else(String::new, |(error, tried)| {
        let (percent, of) = (per_cent(error), &tried.of);
        format!(
            "; the best, {}, has an error of {percent} % ({of})",
            tried.candidate
        )
    })
}
