//! The search for the cheapest candidate.

use anyhow::{Error, Result, anyhow};
use linear::Method;
use sim::Stopping;

use super::answer::{Difference, largest_difference};
use super::candidates::{candidate, methods};
use super::reference::{METHOD, Reference, References};
use super::strings::{Steps, Systems};
use crate::plan::{Candidate, Choice, Islands, Tried};
use crate::sweep_file::per_cent;
use crate::words::short;

/// A candidate within what was asked for.
pub struct Suitable {
    method: Method,
    candidate: Candidate,
    error: f64,
    islands: Option<Islands>,
}

/// A search for the cheapest candidate.
pub struct Search<'a> {
    /// What candidates are held to.
    pub references: References<'a>,
    /// When the cases of candidates end.
    pub stopping: Stopping,
}

impl Search<'_> {
    /// The uncertainty of a reference that is certain enough, a part of one; or why it is not.
    pub fn uncertainty(&self, reference: &Reference) -> Result<f64, String> {
        let of = match &reference.uncertainty {
            Ok(found) if found.part <= self.references.certain() => return Ok(found.part),
            Ok(found) => format!("{} is off by {} %", found.of, per_cent(found.part)),
            Err(reason) => reason.to_string(),
        };
        Err(format!("at {} Hz {of}", short(reference.frequency)))
    }

    /// A candidate found as what is chosen.
    pub fn choice(
        &self,
        found: Suitable,
        reference: &Reference,
        uncertainty: f64,
        tried: Vec<Tried>,
    ) -> (Method, Choice) {
        let choice = Choice {
            asked: self.references.asked,
            delivered: found.error + uncertainty,
            chosen: found.candidate,
            islands: found.islands,
            reference_method: METHOD.name().to_owned(),
            reference_hz: reference.frequency,
            reference_uncertainty: uncertainty,
            reference_seconded_by: reference.seconded_by.map(str::to_owned),
            probes: self.references.probes.cases(),
            tried,
        };
        (found.method, choice)
    }

    /// The first candidate at one frequency whose error is within what was asked for, with
    /// that; `held` bytes are taken already, and `own` systems by the reference's method may
    /// be there.
    ///
    /// # Errors
    /// Where a candidate takes too much memory to be tried.
    pub fn try_at(
        &self,
        frequency: f64,
        own: Option<&Result<Systems>>,
        reference: &Reference,
        uncertainty: f64,
        held: f64,
        tried: &mut Vec<Tried>,
    ) -> Result<Option<Suitable>> {
        let (strings, steps) = (&self.references.probes.strings, Steps::Frequency(frequency));
        let allowed = self.references.asked - uncertainty;
        for method in methods(self.references.probes.sweep) {
            let candidate = candidate(&method, frequency);
            self.references.tell_of(&method, frequency, false);
            let built;
            let systems = match own.filter(|_| method == METHOD) {
                Some(systems) => systems,
                None => {
                    let fits = strings.fits(method, steps, held);
                    fits.map_err(|why| anyhow!("{candidate} {why}"))?;
                    built = strings.systems(method, steps);
                    &built
                }
            };
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
                let systems = systems.as_ref().ok();
                let islands_of =
                    |systems| (self.references.probes).islands(systems, &reference.answers);
                return Ok(Some(Suitable {
                    method,
                    candidate,
                    error,
                    islands: systems.and_then(islands_of),
                }));
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
        reference: &Reference,
        allowed: f64,
    ) -> Result<Difference> {
        let linear = (self.references).linear_error(systems, &reference.answers)?;
        if linear.part > allowed {
            return Ok(linear);
        }
        let answers = self.references.probes.answers(
            systems,
            self.stopping,
            &reference.answers,
            reference.starts,
        );
        let simulated = largest_difference(&answers, &reference.answers, allowed)?;
        Ok(if linear.part > simulated.part {
            linear
        } else {
            simulated
        })
    }

    /// Everything tried is further from the reference than the accuracy asked for, or the
    /// reference is not certain enough, for the reason given.
    pub fn nothing_delivers(&self, tried: &[Tried], unsure: &str) -> Error {
        let (asked, certain) = (
            per_cent(self.references.asked),
            per_cent(self.references.certain()),
        );
        match best_of(tried) {
            Some(best) => anyhow!("nothing delivers {asked} %; {best}; {unsure}"),
            None => anyhow!(
                "{asked} % cannot be estimated: the reference is to be certain to {certain} %, but \
                 {unsure}"
            ),
        }
    }
}

/// The best of what was tried, in words.
fn best_of(tried: &[Tried]) -> Option<String> {
    let known = tried.iter().filter_map(|tried| Some((tried.error?, tried)));
    let (error, best) = known.min_by(|one, other| one.0.total_cmp(&other.0))?;
    let (percent, of) = (per_cent(error), &best.of);
    Some(format!(
        "the best, {}, has an error of {percent} % ({of})",
        best.candidate
    ))
}
