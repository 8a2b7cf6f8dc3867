//! The scenes that cells are tried in: shipped sweep files, held in the program.

use crate::plan::Sweep;
use crate::study::scenes::shipped;
use crate::sweep_file::SweepFileError;

/// As the shipped files, each changed by a cell afterwards.
pub struct Scenes {
    /// Fig. 8(b): stick-slip.
    pub stick_slip: Sweep,
    /// Fig. 12: backward whirl at the bit.
    pub whirl: Sweep,
    /// The same with another site above the bit.
    pub two_sites: Sweep,
}

impl Scenes {
    /// Reads them.
    ///
    /// # Errors
    /// Where a shipped file does not make sense.
    pub fn read() -> Result<Self, SweepFileError> {
        Ok(Self {
            stick_slip: shipped("fig08b.toml")?,
            whirl: shipped("fig12.toml")?,
            two_sites: shipped("two_sites.toml")?,
        })
    }
}
