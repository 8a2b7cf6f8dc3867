//! What the command line asks of a run, beyond the sweep.

use serde::{Deserialize, Serialize};
use sim::Stopping;

/// One case in this number is followed to its end even if it settles, to count how
/// often that was wrong.
const CHECKED_PART: usize = 16;

/// What the command line asks of a run and its results depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct RunOptions {
    /// Simulate every case to its end.
    pub full: bool,
    /// Simulate by methods too whose margin says that a stuck site chatters.
    #[serde(default)]
    pub allow_unstable: bool,
}

impl RunOptions {
    /// Of the cases that may stop when they have settled, some are followed to
    /// the end.
    pub fn stopping(self, case: usize) -> Stopping {
        if self.full {
            Stopping::Full
        } else if case % CHECKED_PART == 0 {
            Stopping::Checked
        } else {
            Stopping::Early
        }
    }
}
