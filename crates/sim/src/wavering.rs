//! A bit that does not settle within a step.

use crate::laws::torque::BitMotion;

/// A bit that wavers within a step between being held and turning: held, it is pushed by more than
/// it holds, and as soon as it turns its neighbours' friction leaves it less. As it cannot have been
/// held, it has broken loose.
#[derive(Debug)]
pub(crate) struct Wavering<S> {
    was_stuck: Option<bool>,
    changes: usize,
    /// What it remembers of having turned in this step.
    turning: Option<S>,
}

/// A bit that changes so often within a step does not settle by itself.
const MOST_CHANGES: usize = 16;

impl<S> Default for Wavering<S> {
    fn default() -> Self {
        Self {
            was_stuck: None,
            changes: 0,
            turning: None,
        }
    }
}

impl<S: Clone> Wavering<S> {
    /// What its law answered in one of the turns of a step.
    pub(crate) fn see(&mut self, motion: Option<BitMotion>, state: &S) {
        let is_stuck = motion == Some(BitMotion::Stuck);
        self.changes += usize::from(self.was_stuck.is_some_and(|was| was != is_stuck));
        self.was_stuck = Some(is_stuck);
        if !is_stuck && self.changes > 0 {
            self.turning = Some(state.clone());
        }
    }

    /// What it remembers, where it has changed too often.
    pub(crate) fn released(&self) -> Option<&S> {
        self.turning
            .as_ref()
            .filter(|_| self.changes > MOST_CHANGES)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_that_changes_too_often_has_broken_loose() {
        let mut wavering = Wavering::default();
        for turn in 0..MOST_CHANGES {
            assert!(wavering.released().is_none(), "{turn}");
            let motion = [BitMotion::Stuck, BitMotion::Forward][turn % 2];
            wavering.see(Some(motion), &motion);
        }
        for motion in [BitMotion::Stuck, BitMotion::Forward] {
            wavering.see(Some(motion), &motion);
        }
        assert_eq!(wavering.released(), Some(&BitMotion::Forward));
    }
}
