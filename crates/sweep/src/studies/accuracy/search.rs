//! The search for the cheapest candidate.

use std::cell::Cell;
use std::time::Instant;

use anyhow::{Error, Result, anyhow, bail};
use linear::Method;
use linear::method::Transform;
use sim::Stopping;

use super::answer::{Answer, Difference, largest_difference};
use super::candidates::{candidate, frequencies, methods, off_beat};
use super::probes::{Probes, Systems};
use crate::plan::{Candidate, Choice, Tried};
use crate::sweep_file::per_cent;
use crate::words::short;

/// The reference's uncertainty is at most this part of the accuracy; it counts in full.
const REFERENCE_PART: f64 = 0.5;

/// The method of the reference: nothing in it is approximate but the steps in which
/// forces are held.
const REFERENCE: Method = Method::Held;

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
    /// Δ of Eq. 75 of every string as it is ([`Probes::exact_undershoots`]).
    pub undershoots: Vec<f64>,
    /// Time that stepping the last reference took for each hertz, s: for telling, nothing is
    /// chosen by it.
    pub pace: Cell<Option<f64>>,
}

impl Search<'_> {
    /// The method chosen, and the choice.
    ///
    /// # Errors
    /// Where nothing delivers the accuracy within the memory.
    pub fn run(&self) -> Result<(Method, Choice)> {
        let mut tried = Vec::new();
        let mut rungs: Vec<Rung> = Vec::new();
        let mut next = 0;
        let mut unsure = "no two frequencies can be compared".to_owned();
        for frequency in frequencies(self.probes.travel()?) {
            match self.build_rung(frequency, &rungs) {
                Ok(rung) => rungs.push(rung),
                // Finer frequencies only take more memory.
                Err(reason) => {
                    unsure = reason.to_string();
                    break;
                }
            }
            let Some((reference, below)) = rungs.split_last() else {
                continue;
            };
            let uncertainty = match &reference.uncertainty {
                Ok(found) if found.part <= self.certain() => found.part,
                found => {
                    let of = match found {
                        Ok(found) => format!("{} is off by {} %", found.of, per_cent(found.part)),
                        Err(reason) => reason.to_string(),
                    };
                    unsure = format!("at {} Hz {of}", short(frequency));
                    if is_ragged(&rungs) {
                        break;
                    }
                    continue;
                }
            };
            let held = memory_of(&rungs);
            let allowed = self.asked - uncertainty;
            for rung in &below[next..] {
                let found = self.try_rung(rung, &reference.answers, held, allowed, &mut tried)?;
                if let Some((method, chosen, error)) = found {
                    let choice = Choice {
                        asked: self.asked,
                        delivered: error + uncertainty,
                        chosen,
                        reference_method: REFERENCE.name().to_owned(),
                        reference_hz: reference.frequency,
                        reference_uncertainty: uncertainty,
                        reference_seconded_by: reference.seconded_by.map(str::to_owned),
                        probes: self.probes.cases(),
                        tried,
                    };
                    return Ok((method, choice));
                }
            }
            // Finer than the reference has to be, but nothing coarser delivers.
            next = below.len();
        }
        Err(self.nothing_delivers(&tried, &unsure))
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
            self.tell_of(&method, rung.frequency, false);
            let built = if method == REFERENCE {
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
        let linear = self.linear_error(systems, reference)?;
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

    /// The reference at a frequency, after those at lower ones.
    ///
    /// # Errors
    /// Where it takes too much memory.
    fn build_rung(&self, frequency: f64, before: &[Rung]) -> Result<Rung> {
        let probes = self.probes;
        let held = memory_of(before);
        let fits = probes.fits(REFERENCE, frequency, held);
        let kept = fits.map_err(|why| {
            let frequency = short(frequency);
            anyhow!("at {frequency} Hz the reference {why}")
        })?;
        self.tell_of(&REFERENCE, frequency, true);
        let systems = probes.systems(REFERENCE, frequency);
        let start = Instant::now();
        let known = before.last().map_or(&[][..], |before| &before.answers);
        let answers = match &systems {
            Ok(systems) => probes.answers(systems, Stopping::Full, known),
            Err(_) => Vec::new(),
        };
        self.pace
            .set(Some(start.elapsed().as_secs_f64() / frequency));
        let mut rung = Rung {
            frequency,
            systems,
            kept,
            answers,
            uncertainty: Err(anyhow!("there is nothing to compare")),
            has_exact_responses: false,
            is_contested: false,
            seconded_by: None,
        };
        rung.uncertainty = self.uncertainty_of(&mut rung, before);
        if !rung.is_certain(self.certain()) {
            return Ok(rung);
        }
        for (method, frequency) in self.seconds(frequency)? {
            self.ask_another(&mut rung, method, frequency, held + kept);
            if !rung.is_certain(self.certain()) {
                rung.is_contested = true;
                return Ok(rung);
            }
        }
        if let Ok(systems) = &rung.systems
            && let Err(reason) = probes.check_for_islands(systems, &rung.answers)
        {
            rung.uncertainty = Err(reason);
            rung.is_contested = true;
        }
        Ok(rung)
    }

    /// Tells of an attempt before it is made, and about how long it will take: as much
    /// longer than the last as its steps are shorter.
    fn tell_of(&self, method: &Method, frequency: f64, is_reference: bool) {
        (self.tell)(Attempt {
            candidate: candidate(method, frequency),
            is_reference,
            seconds: self.pace.get().map(|pace| pace * frequency),
        });
    }

    /// Who else is asked at the frequency of a reference: another family, and the reference
    /// itself in steps that wave fronts are not in time with, but for fronts along a uniform
    /// string, which always are. On some strings a limit hangs on fronts that arrive
    /// together, and moves by per cents as soon as they do not quite.
    fn seconds(&self, frequency: f64) -> Result<Vec<(Method, f64)>> {
        let probes = self.probes;
        let mut seconds = vec![(self.other_family(), frequency)];
        if probes.sweep.setting.lateral.is_some() || !probes.are_uniform() {
            let off_beat = off_beat(frequency, probes.travel()?);
            seconds.extend(off_beat.map(|frequency| (REFERENCE, frequency)));
        }
        Ok(seconds)
    }

    /// The largest uncertainty of a reference.
    fn certain(&self) -> f64 {
        REFERENCE_PART * self.asked
    }

    /// By how much the answers of the reference may be wrong: by what they changed over
    /// the last doubling and over the last two, for over either they may agree by chance,
    /// and by what its linear responses are off from the exact ones, which share nothing
    /// with it.
    fn uncertainty_of(&self, rung: &mut Rung, before: &[Rung]) -> Result<Difference> {
        let [.., quarter, half] = before else {
            bail!("there is nothing to compare");
        };
        let systems = (rung.systems.as_ref()).map_err(|reason| anyhow!("{reason}"))?;
        let mut largest = self.linear_error(systems, &rung.answers)?;
        rung.has_exact_responses = largest.part <= self.certain();
        for coarser in [half, quarter] {
            let change = largest_difference(&coarser.answers, &rung.answers, self.asked)?;
            if change.part > largest.part {
                largest = change;
            }
        }
        Ok(largest)
    }

    /// Where another method's linear responses are near enough to the exact ones, what its
    /// answers differ by from the reference's counts too. (Where they are not, and with
    /// sharp fronts those of another family rarely are, its answers tell nothing.)
    fn ask_another(&self, rung: &mut Rung, method: Method, frequency: f64, held: f64) {
        if self.probes.fits(method, frequency, held).is_err() {
            return;
        }
        self.tell_of(&method, frequency, true);
        let Ok(systems) = self.probes.systems(method, frequency) else {
            return;
        };
        if method != REFERENCE {
            match self.linear_error(&systems, &rung.answers) {
                Ok(linear) if linear.part <= self.certain() => {}
                _ => return,
            }
            rung.seconded_by = Some(method.name());
        }
        let answers = self.probes.answers(&systems, Stopping::Full, &rung.answers);
        let difference = largest_difference(&answers, &rung.answers, self.asked);
        let is_larger = match (&difference, &rung.uncertainty) {
            (Ok(other), Ok(own)) => other.part > own.part,
            (Err(_), _) => true,
            (Ok(_), Err(_)) => false,
        };
        if is_larger {
            let candidate = candidate(&method, frequency);
            rung.uncertainty = difference
                .map(|found| Difference {
                    of: format!("{} by {candidate}", found.of),
                    ..found
                })
                .map_err(|reason| anyhow!("{candidate} differs: {reason}"));
        }
    }

    /// The method that comes nearest to the exact responses without being the reference:
    /// the digital filter has wave fronts within its band, but loses the slow tail in
    /// bending.
    fn other_family(&self) -> Method {
        match self.probes.sweep.setting.lateral {
            None => Method::Hilbert(Transform::default()),
            Some(_) => Method::Quadrature,
        }
    }

    /// The error of linear responses; where a limit is looked for, also that of what it
    /// hangs on.
    fn linear_error(&self, systems: &Systems, reference: &[Answer]) -> Result<Difference> {
        let has_limit = reference.iter().any(|answer| answer.limit.is_some());
        let undershoots = if has_limit {
            &self.undershoots[..]
        } else {
            &[]
        };
        self.probes.linear_error(systems, undershoots)
    }

    /// Everything tried is further from the reference than the accuracy asked for, or the
    /// reference is not certain enough, for the reason given.
    fn nothing_delivers(&self, tried: &[Tried], unsure: &str) -> Error {
        let (asked, certain) = (per_cent(self.asked), per_cent(self.certain()));
        match best_of(tried) {
            Some(best) => anyhow!("nothing delivers {asked} %; {best}; {unsure}"),
            None => anyhow!(
                "{asked} % cannot be told: the reference is to be certain to {certain} %, but \
                 {unsure}"
            ),
        }
    }
}

/// The reference's method at one sampling frequency.
struct Rung {
    /// Hz.
    frequency: f64,
    /// Its systems, or why it has none.
    systems: Result<Systems>,
    /// Memory that the systems take, bytes.
    kept: f64,
    /// Its answers; none without systems.
    answers: Vec<Answer>,
    /// By how much they may be wrong.
    uncertainty: Result<Difference>,
    /// Whether its linear responses are near enough to the exact ones.
    has_exact_responses: bool,
    /// Whether its answers would do, but for what another method says, or for islands.
    is_contested: bool,
    /// The method of another family whose answers count in that.
    seconded_by: Option<&'static str>,
}

impl Rung {
    fn is_certain(&self, certain: f64) -> bool {
        matches!(&self.uncertainty, Ok(found) if found.part <= certain)
    }
}

/// References whose responses are exact and whose answers are not certain, before limits
/// count as ragged; and of those that would do but for others, so many one after the other.
const PATIENCE: usize = 5;
const CONTESTED: usize = 2;

/// Whether finer steps will not make the last reference certain: the responses have been
/// exact enough for long, and the limits hang on something else.
fn is_ragged(rungs: &[Rung]) -> bool {
    let exact = rungs.iter().filter(|rung| rung.has_exact_responses).count();
    let last = rungs.iter().rev().take(CONTESTED);
    exact >= PATIENCE || last.filter(|rung| rung.is_contested).count() == CONTESTED
}

/// Memory that the systems of some frequencies take, bytes.
fn memory_of(rungs: &[Rung]) -> f64 {
    rungs.iter().map(|rung| rung.kept).sum()
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
