//! The weight on bit under which a string leaves the low side of its hole.

use crate::equilibrium::Equilibrium;
use crate::error::StaticsError;
use crate::lying::LyingString;

/// Steps from no weight to that under which the string buckles between its contacts.
const STEPS: usize = 40;

/// A weight is known to this part of itself, or of the largest that is tried.
const SAME_WEIGHT: f64 = 1e-4;
const SMALLEST: f64 = 1e-6;

impl LyingString {
    /// The weight on bit, N, from which on the string does not stay as it lies at rest, as weight
    /// grows from zero, and snakes or buckles between its contacts: necessary and sufficient for
    /// contacts without friction. None up to a weight (N).
    ///
    /// In a hole that turns, a string that has left its place may lie still in another.
    ///
    /// # Errors
    /// Where no state is found under a weight on the way.
    pub fn snaking_weight(&self, most: f64) -> Result<Option<f64>, StaticsError> {
        let buckling = self.weight_that_buckles_between_contacts(most);
        let end = buckling.unwrap_or(most);
        let mut lying = self.lying(0.0);
        let (mut stays_under, step) = (0.0, end / STEPS as f64);
        // Under the last, a string that buckles there has no state.
        let steps = STEPS + usize::from(buckling.is_none());
        for count in 0..steps {
            let weight = step * count as f64;
            let before = lying.clone();
            if self.stays(&mut lying, weight)? {
                stays_under = weight;
                continue;
            }
            if count == 0 {
                return Ok(Some(0.0));
            }
            return self.between(&before, stays_under, weight).map(Some);
        }
        Ok(buckling)
    }

    /// Where between two weights a string that lay still under the lower leaves its place.
    fn between(
        &self,
        below: &Equilibrium,
        mut low: f64,
        mut high: f64,
    ) -> Result<f64, StaticsError> {
        while high - low > SAME_WEIGHT * high {
            let middle = 0.5 * (low + high);
            if self.stays(&mut below.clone(), middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }

    /// Whether a string that lay still stays where it lies under another weight.
    fn stays(&self, lying: &mut Equilibrium, weight: f64) -> Result<bool, StaticsError> {
        lying.weight_on_bit = weight;
        let is_found = lying.settle_rigid();
        let mut pressed_in = lying.clone();
        match is_found && pressed_in.settle_hertzian() {
            true => Ok(pressed_in.negative_pivots() == [0, 0]),
            false => Err(self.under(weight).not_found(0.0)),
        }
    }

    /// The least weight, up to one, under which it buckles even if held at all of its contacts, N.
    fn weight_that_buckles_between_contacts(&self, most: f64) -> Option<f64> {
        let buckles = |weight: f64| self.under(weight).buckles_between_contacts();
        let (mut low, mut high) = (0.0, most);
        if !buckles(high) {
            return None;
        }
        while high - low > SAME_WEIGHT * high && high > SMALLEST * most {
            let middle = 0.5 * (low + high);
            if buckles(middle) {
                high = middle;
            } else {
                low = middle;
            }
        }
        Some(low)
    }
}
