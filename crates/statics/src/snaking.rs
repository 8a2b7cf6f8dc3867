//! The weight on bit under which a string leaves the place where it lies: by a bifurcation, or, in a hole
//! that turns, where every weight moves it and none is one, by a moment that runs away.

use crate::equilibrium::Equilibrium;
use crate::error::StaticsError;
use crate::lying::LyingString;

/// Weight grows by this part of itself in a step, and at first by one of this number of parts of that under
/// which the string buckles between its contacts.
const STEP: f64 = 0.05;
const FIRST_STEPS: f64 = 4000.0;

/// A weight is known to this part of itself, or of the largest that is tried.
const SAME_WEIGHT: f64 = 1e-4;
const SMALLEST: f64 = 1e-6;

/// The power of the weight with which the moment grows that it adds, from which on that runs away: at
/// 0.6 W₀ where it grows as W/(1 − W/W₀).
const RUNS_AWAY: f64 = 2.5;

/// Up to this part of what is modelled a string is judged: above it is as it is cut.
const JUDGED_TO: f64 = 0.85;

/// Less than this part of the greatest moment that the string has without weight is not judged.
const JUDGED: f64 = 0.05;

/// The weight on bit from which on a string does not stay as it lies at rest, as weight grows from zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leaving {
    /// N.
    pub weight_on_bit: f64,
    /// How it leaves its place there.
    pub way: LeavingWay,
}

/// How a string leaves its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LeavingWay {
    /// Bifurcation or fold: it snakes, or buckles between its contacts.
    Buckles,
    /// Without a bifurcation: the greatest moment that weight adds begins to grow by more than 2.5 % with
    /// each 1 % of weight.
    RunsAway,
    /// Without a bifurcation before: it jumps to another place.
    Jumps,
}

/// Bending moments along a string, N m.
type Moments = Vec<[f64; 2]>;

/// A string that moves by more than this part of its greatest clearance jumps, if it does so within a
/// thousandth of the weight.
const JUMP: f64 = 0.25;
const AT_ONCE: f64 = 1e-3;

impl LyingString {
    /// The weight on bit, N, from which on the string does not stay as it lies at rest, as weight
    /// grows from zero: necessary and sufficient for contacts without friction in a hole that does not
    /// turn. None up to a weight (N).
    ///
    /// # Errors
    /// Where no state is found under a weight on the way.
    pub fn snaking_weight(&self, most: f64) -> Result<Option<f64>, StaticsError> {
        Ok(self.leaving(most)?.map(|it| it.weight_on_bit))
    }

    /// Weight up to one (N), and way, with which the string leaves its place.
    ///
    /// # Errors
    /// As [`Self::snaking_weight`].
    pub fn leaving(&self, most: f64) -> Result<Option<Leaving>, StaticsError> {
        let found = |weight_on_bit, way| Ok(Some(Leaving { weight_on_bit, way }));
        let buckling = self.weight_that_buckles_between_contacts(most);
        let end = buckling.unwrap_or(most);
        let mut lying = self.lying(0.0);
        let Some(unmoved) = self.resting_under(&mut lying, 0.0)? else {
            return found(0.0, LeavingWay::Buckles);
        };
        let judged = JUDGED * greatest(&unmoved, None);
        let (mut weight, mut added) = (0.0, 0.0);
        let mut last = (0.0, 0.0);
        while weight < end {
            let next = (weight + (STEP * weight).max(end / FIRST_STEPS)).min(end);
            // Under the last, a string that buckles there has no state.
            if next == end && buckling.is_some() {
                break;
            }
            let before = lying.clone();
            let Some(moments) = self.resting_under(&mut lying, next)? else {
                return found(self.between(&before, weight, next)?, LeavingWay::Buckles);
            };
            let more = greatest(&moments, Some(&unmoved));
            // Over two steps: contacts come and go.
            let power = (more / last.1).ln() / (next / last.0).ln();
            if !self.beam.hole_is_plane && more > judged && power > RUNS_AWAY {
                return found(weight, LeavingWay::RunsAway);
            }
            if !self.beam.hole_is_plane && self.has_moved(&before, &lying) {
                if let Some(weight) = self.jump(before, &lying)? {
                    return found(weight, LeavingWay::Jumps);
                }
            }
            last = (weight, added);
            (weight, added) = (next, more);
        }
        Ok(buckling.map(|weight_on_bit| Leaving {
            weight_on_bit,
            way: LeavingWay::Buckles,
        }))
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
            if self.resting_under(&mut below.clone(), middle)?.is_some() {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }

    /// The weight under which a string jumps on its way from one state to another, if it does.
    fn jump(
        &self,
        mut below: Equilibrium,
        above: &Equilibrium,
    ) -> Result<Option<f64>, StaticsError> {
        let mut above = above.clone();
        while above.weight_on_bit - below.weight_on_bit > AT_ONCE * above.weight_on_bit {
            let middle = 0.5 * (below.weight_on_bit + above.weight_on_bit);
            let mut between = below.clone();
            if self.resting_under(&mut between, middle)?.is_none()
                || self.has_moved(&below, &between)
            {
                above = between;
            } else if self.has_moved(&between, &above) {
                below = between;
            } else {
                return Ok(None);
            }
        }
        Ok(Some(below.weight_on_bit))
    }

    /// Whether a string is in another place in one state than in another.
    fn has_moved(&self, one: &Equilibrium, other: &Equilibrium) -> bool {
        let contacts = self.contacts();
        let to = JUDGED_TO * self.beam.distances[0];
        let judged = (0..contacts.len()).filter(|it| contacts[*it].distance_from_bit <= to);
        let moves = judged.map(|contact| {
            let ([x, y], [other_x, other_y]) = (one.place(contact), other.place(contact));
            (x - other_x).hypot(y - other_y)
        });
        let clearance = contacts
            .iter()
            .fold(0.0, |most: f64, it| most.max(it.clearance));
        moves.fold(0.0, f64::max) > JUMP * clearance
    }

    /// The moments under another weight of a string that lay still, if it stays where it lies.
    fn resting_under(
        &self,
        lying: &mut Equilibrium,
        weight: f64,
    ) -> Result<Option<Moments>, StaticsError> {
        lying.weight_on_bit = weight;
        let is_found = lying.settle_rigid();
        let mut pressed_in = lying.clone();
        if !(is_found && pressed_in.settle_hertzian()) {
            return Err(self.under(weight).not_found(0.0));
        }
        let state = self.state(&pressed_in);
        let to = JUDGED_TO * state.top();
        let below = state.along().filter(|it| it.distance_from_bit <= to);
        let moments = || below.map(|it| it.moment).collect();
        Ok(state.is_stable().then(moments))
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

/// The greatest of moments, or of what they have more than others at the same places, N m.
fn greatest(moments: &Moments, less: Option<&Moments>) -> f64 {
    let amount = |(place, [x, y]): (usize, &[f64; 2])| {
        let [less_x, less_y] = less.map_or([0.0; 2], |less| less[place]);
        (x - less_x).hypot(y - less_y)
    };
    moments.iter().enumerate().map(amount).fold(0.0, f64::max)
}
