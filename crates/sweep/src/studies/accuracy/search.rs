//! The search for the cheapest candidate.

use linear::Method;
use linear::estimates::sampling_frequency;
use sim::Stopping;

use super::answer::{Answer, Difference, largest_difference};
use super::candidates::{FREQUENCIES, candidate, methods};
use super::error::AccuracyError;
use super::probes::{Probes, Systems};
use super::rung::{Rung, memory_of, uncertainty_of};
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
    pub fn run(&self) -> Result<(Method, Choice), AccuracyError> {
        let asked = self.asked;
        let mut rungs = self.up_to_reference()?;
        let mut tried: Vec<Tried> = Vec::new();
        let mut next = 0;
        while let Some((reference, below)) = rungs.split_last() {
            let held = memory_of(&rungs);
            let uncertainty = uncertainty_of(&rungs, asked)
                .map_err(|reason| AccuracyError::Reference(Box::new(reason)))?
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
                AccuracyError::NothingDelivers { asked, best }
            })?);
        }
        let best = best_of(&tried);
        Err(AccuracyError::NothingDelivers { asked, best })
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
    ) -> Result<Option<(Method, Candidate, f64)>, AccuracyError> {
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
                fits.map_err(|why| AccuracyError::Untried(candidate.clone(), Box::new(why)))?;
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
    ) -> Result<Difference, AccuracyError> {
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
    fn up_to_reference(&self) -> Result<Vec<Rung>, AccuracyError> {
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
        let best = format!("certain to {} %, but {best}", per_cent(certain));
        Err(AccuracyError::Uncertain { asked, best })
    }

    /// Finer frequencies only take more memory: an error ends the search.
    fn build_rung(&self, frequency: f64, before: &[Rung]) -> Result<Rung, AccuracyError> {
        let probes = self.probes;
        let method = probes.reference();
        let fits = probes.fits(method, frequency, memory_of(before));
        let kept = fits.map_err(|why| AccuracyError::NoReference(frequency, Box::new(why)))?;
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
