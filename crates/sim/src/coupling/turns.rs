//! The turns: one site after the other.

use super::newton;
use super::sites::{Coupling, Free, Solved, Unloaded};

/// A site is solved again if the others' loads have changed since by what changes its own
/// force by more than this fraction of the largest: ten thousand times rounding, and a
/// thousandth of what a wall's law is held to (`laws::obeyed`).
pub(super) const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which each is begun with a step of Newton's method.
const PLAIN_TURNS: usize = 30;

/// Turns after which sites that do not settle are given up.
pub(super) const MOST_TURNS: usize = 200;

impl Coupling<'_> {
    /// Solves a step by solving one site after the other, from the loads of the last
    /// step on. Gives whether they settled.
    #[inline]
    pub(crate) fn settle<E>(
        &mut self,
        free: Free,
        mut solve: impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<bool, E> {
        if self.pending.len() == 1 {
            // There are no others to agree with.
            self.solve_site(0, free, &mut solve)?;
            return Ok(true);
        }
        self.pending.fill(f64::INFINITY);
        for turn in 0..MOST_TURNS {
            let largest = self.normal_forces.iter().copied().fold(0.0, f64::max);
            let matters = COUPLING_TOLERANCE * largest;
            if !self.is_open(matters) {
                // The others are told what has become of those that touch.
                for site in 0..self.pending.len() {
                    if self.pending[site] > matters {
                        self.solve_site(site, free, &mut solve)?;
                    }
                }
                return Ok(true);
            }
            if turn >= PLAIN_TURNS {
                newton::step(self, free, &mut solve);
            }
            for site in 0..self.pending.len() {
                if self.pending[site] > self.slack[site].max(matters) {
                    self.solve_site(site, free, &mut solve)?;
                }
            }
        }
        Ok(false)
    }

    /// Whether some site has to be solved again.
    fn is_open(&self, matters: f64) -> bool {
        let mut sites = self.pending.iter().zip(&self.slack);
        sites.any(|(pending, slack)| *pending > slack.max(matters))
    }

    #[inline]
    fn solve_site<E>(
        &mut self,
        site: usize,
        free: Free,
        solve: &mut impl FnMut(usize, Unloaded) -> Result<Solved, E>,
    ) -> Result<(), E> {
        let solved = solve(site, self.unloaded(site, free))?;
        self.normal_forces[site] = solved.normal_force;
        self.slack[site] = solved.slack;
        self.replace(site, solved.load);
        Ok(())
    }
}
