//! On which terms a sweep is run.

use serde::{Deserialize, Serialize};

/// What the command line asks of a run and its results depend on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Terms {
    /// Simulate every case to its end.
    pub full: bool,
    /// Simulate by methods too whose margin says that a stuck site chatters.
    #[serde(default)]
    pub allow_unstable: bool,
}
