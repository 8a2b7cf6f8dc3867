//! With a wall: a reference whose steps are halved until it is certain.

use anyhow::{Result, anyhow, bail};
use linear::Method;
use sim::Stopping;

use super::answer::{Difference, largest_difference};
use super::candidates::{candidate, frequencies, off_beat};
use super::reference::{METHOD, Reference, References};
use super::search::Search;
use super::strings::Steps;
use crate::plan::Choice;

/// Another family counts where its linear responses are within this fraction of the allowed
/// uncertainty of a reference: limits are off by more than the responses that they depend on.
const TELLING: f64 = 0.2;

/// The family that comes nearest to the exact responses with a wall, without being the
/// reference's; the digital filter loses the slow tail in bending.
const OTHER_WITH_A_WALL: Method = Method::Quadrature;

/// Linear responses whose error is no more than this are exact enough for any limit that is
/// not ragged.
const EXACT: f64 = 0.01;

/// References whose responses are exact and whose answers are not certain, before limits count as
/// ragged; and in a row of those that only other methods contradict.
const PATIENCE: usize = 5;
const CONTESTED: usize = 2;

impl Search<'_> {
    /// With a wall: the reference's steps are halved until it is certain, candidates are
    /// what was passed on the way.
    ///
    /// # Errors
    /// Where nothing delivers the accuracy within the memory.
    pub fn by_doubling(&self) -> Result<(Method, Choice)> {
        let mut tried = Vec::new();
        let mut references: Vec<Reference> = Vec::new();
        let mut next = 0;
        let mut unsure = "no two frequencies can be compared".to_owned();
        let frequencies = frequencies(self.references.probes.strings.travel()?);
        let mut expected = self.references.expect(&frequencies);
        for frequency in frequencies {
            if expected.is_some_and(|expected| frequency > expected) {
                expected = Some(frequency);
                self.references
                    .tell_expected(frequency, |of| of.by_doubling(frequency, frequency));
            }
            match self.references.next(frequency, &references) {
                Ok(found) => references.push(found),
                // Finer frequencies only take more memory.
                Err(reason) => {
                    unsure = reason.to_string();
                    break;
                }
            }
            let Some((reference, below)) = references.split_last() else {
                continue;
            };
            let uncertainty = match self.uncertainty(reference) {
                Ok(found) => found,
                Err(reason) => {
                    unsure = reason;
                    if is_ragged(&references) {
                        break;
                    }
                    continue;
                }
            };
            let held = memory_of(&references);
            for coarser in &below[next..] {
                let (frequency, own) = (coarser.frequency, Some(&coarser.systems));
                let found =
                    self.try_at(frequency, own, reference, uncertainty, held, &mut tried)?;
                if let Some(found) = found {
                    return Ok(self.choice(found, reference, uncertainty, tried));
                }
            }
            // Finer than the reference has to be, but nothing coarser delivers.
            next = below.len();
        }
        Err(self.nothing_delivers(&tried, &unsure))
    }
}

impl References<'_> {
    /// Tells how long the references will take, and the frequency (Hz) of that which is expected
    /// to be certain: its linear responses are of second order, and one halving of the steps
    /// more shows that the answers hold still.
    fn expect(&self, frequencies: &[f64]) -> Option<f64> {
        let (systems, first) = self.first_look(METHOD, frequencies)?;
        let error = self.linear_error(&systems, &[]).ok()?.part;
        let halvings = (0.5 * (error / self.certain()).log2()).ceil().max(0.0) + 1.0;
        let last = first * halvings.exp2();
        self.tell_expected(last, |of| of.by_doubling(first, last));
        Some(last)
    }

    /// The reference with a wall: that at a frequency, after those at lower ones.
    ///
    /// # Errors
    /// Where it takes too much memory.
    fn next(&self, frequency: f64, before: &[Reference]) -> Result<Reference> {
        let held = memory_of(before);
        let known = before.last().map_or(&[][..], |before| &before.answers);
        let steps = Steps::Frequency(frequency);
        let mut reference = self.stepped(steps, frequency, held, (known, self.probes.starts()))?;
        reference.uncertainty = self.uncertainty_of(&mut reference, before);
        if !reference.is_certain(self.certain()) {
            return Ok(reference);
        }
        let travel = self.probes.strings.travel()?;
        let off_beat = off_beat(frequency, travel).map(|frequency| (METHOD, frequency));
        for (method, frequency) in std::iter::once((OTHER_WITH_A_WALL, frequency)).chain(off_beat) {
            self.ask_another(&mut reference, method, frequency, held);
            if !reference.is_certain(self.certain()) {
                reference.is_contested = true;
                return Ok(reference);
            }
        }
        self.look_for_islands(&mut reference);
        Ok(reference)
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
    fn ask_another(&self, reference: &mut Reference, method: Method, frequency: f64, held: f64) {
        let (held, steps) = (held + reference.kept, Steps::Frequency(frequency));
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
        let answers = self.probes.answers(
            &systems,
            Stopping::Full,
            &reference.answers,
            reference.starts,
        );
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
}

/// Whether finer steps will not make the last reference certain: the responses have been
/// exact enough for long, and the limits depend on something else.
fn is_ragged(references: &[Reference]) -> bool {
    let exact = references
        .iter()
        .filter(|reference| reference.has_exact_responses)
        .count();
    let last = references.iter().rev().take(CONTESTED);
    exact >= PATIENCE || last.filter(|reference| reference.is_contested).count() == CONTESTED
}

/// Memory that the systems of some frequencies take, bytes.
fn memory_of(references: &[Reference]) -> f64 {
    references.iter().map(|reference| reference.kept).sum()
}
