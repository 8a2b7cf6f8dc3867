//! In torsion alone: a reference with exact fronts, and candidates from coarse to fine.

use anyhow::{Result, anyhow};
use linear::Method;

use super::answer::{Answer, Difference, largest_chance, largest_difference};
use super::candidates::frequencies;
use super::reference::{Reference, References};
use super::search::Search;
use super::strings::Steps;
use crate::plan::Choice;

/// Pieces of the lattice in a step of a first look.
const FIRST_PIECES: f64 = 16.0;

impl Search<'_> {
    /// In torsion alone: candidates from coarse to fine, held to exact fronts.
    ///
    /// # Errors
    /// Where nothing delivers the accuracy within the memory.
    pub fn by_fronts(&self) -> Result<(Method, Choice)> {
        let mut tried = Vec::new();
        let reference = (self.references.in_pieces())
            .map_err(|reason| self.nothing_delivers(&tried, &reason.to_string()))?;
        let uncertainty = self
            .uncertainty(&reference)
            .map_err(|unsure| self.nothing_delivers(&tried, &unsure))?;
        let frequencies = frequencies(self.references.probes.strings.travel()?);
        let is_coarser = |frequency: &f64| *frequency <= reference.frequency;
        for frequency in frequencies.into_iter().filter(is_coarser) {
            let (own, held) = (None, reference.kept);
            let found = self.try_at(frequency, own, &reference, uncertainty, held, &mut tried)?;
            if let Some(found) = found {
                return Ok(self.choice(found, &reference, uncertainty, tried));
            }
        }
        Err(self.nothing_delivers(&tried, "no finer steps are tried"))
    }
}

impl References<'_> {
    /// The reference in torsion: steps of one piece of the string's lattice, so short that
    /// each front arrives at every place in time, and none rises within a step. (On many strings a
    /// limit depends on that: a front that rises within a step sends a dip ahead of its echo, which
    /// stops a bit that has nearly stopped. Finer and finer steps that are not in time with all of
    /// the string may agree with one another on another limit.) What steps of half a piece change
    /// counts in its uncertainty.
    ///
    /// # Errors
    /// Where it takes too much memory.
    fn in_pieces(&self) -> Result<Reference> {
        let frequency = self.probes.strings.frequency_of_pieces()?;
        let stepped = |pieces: f64, held: f64, known: (&[Answer], usize)| {
            self.stepped(Steps::Pieces(pieces), frequency / pieces, held, known)
        };
        // No other is built before the lattice is tried, which may take long itself.
        self.first_look(Method::Quadrature, &[frequency / FIRST_PIECES]);
        self.tell_expected(frequency, |of| of.in_pieces(frequency, FIRST_PIECES));
        // What says where limits are about, and how much is chance.
        let first = stepped(FIRST_PIECES, 0.0, (&[], self.probes.starts()))?.answers;
        let starts = self.probes.starts_for(self.certain(), &first);
        self.has_starts(starts);
        let mut whole = stepped(1.0, 0.0, (&first, starts))?;
        let half = stepped(0.5, whole.kept, (&whole.answers, starts))?;
        if self.probes.cuts() {
            // Limits are held to where they are.
            let limits = self.probes.drilling_limits();
            for (answer, limit) in whole.answers.iter_mut().zip(limits) {
                answer.limit = limit;
            }
        }
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
        let chance = largest_chance(&whole.answers);
        let larger = |one: Difference, other: Difference| {
            if other.part > one.part { other } else { one }
        };
        Ok(larger(larger(linear, change), chance))
    }
}
