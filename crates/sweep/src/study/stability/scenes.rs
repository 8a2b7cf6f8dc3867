//! The scenes that cells are tried in: shipped sweep files, held in the program.

use std::path::Path;

use anyhow::Result;

use crate::spec::{SpecError, Sweep};

/// As the shipped files, each changed by a cell afterwards.
pub struct Scenes {
    /// Fig. 8(b): stick-slip.
    pub stick_slip: Sweep,
    /// Fig. 12: backward whirl at the bit.
    pub whirl: Sweep,
    /// The same with another site above the bit.
    pub two_sites: Sweep,
}

/// Fig. 12 with a second site.
const TWO_SITES: &str = r#"base = "fig12.toml"
sites = [{ distance_from_bit_m = 10 }, { distance_from_bit_m = 0 }]
"#;

impl Scenes {
    /// Reads them.
    ///
    /// # Errors
    /// Where a shipped file does not make sense.
    pub fn read() -> Result<Self, SpecError> {
        Ok(Self {
            stick_slip: read("fig08b.toml")?,
            whirl: read("fig12.toml")?,
            two_sites: read("two_sites.toml")?,
        })
    }
}

fn read(name: &str) -> Result<Sweep, SpecError> {
    Sweep::read_from(Path::new(name), &|path| {
        let text = match path.to_str() {
            Some("academic.toml") => include_str!("../../../../../sweeps/academic.toml"),
            Some("fig08a.toml") => include_str!("../../../../../sweeps/fig08a.toml"),
            Some("fig08b.toml") => include_str!("../../../../../sweeps/fig08b.toml"),
            Some("fig10.toml") => include_str!("../../../../../sweeps/fig10.toml"),
            Some("fig12.toml") => include_str!("../../../../../sweeps/fig12.toml"),
            Some("two_sites.toml") => TWO_SITES,
            _ => return Err(std::io::ErrorKind::NotFound.into()),
        };
        Ok(text.to_owned())
    })
}
