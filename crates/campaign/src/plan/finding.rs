//! `sites = "auto"`: how places where a string touches its wall are found, where the file does not
//! give them.

use super::contacts::StringInHole;
use crate::quantities::LONGEST_STRING;
use crate::sweep_file::{FileContent, SitesName, Source, SweepFileError};

/// Sites are looked for at every metre, until the string goes less than a millimetre farther
/// beyond the wall between them than at them, in a limited number of rounds.
const EVERY: f64 = 1.0;
const TOLERANCE_MM: f64 = 1.0;
const ROUNDS: usize = 20;

/// More rounds would take too long.
const MOST_ROUNDS: usize = 1000;

/// How sites are found.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// They are at multiples of this distance from the bit, m …
    pub every: f64,
    /// … up to this one, m.
    pub to: f64,
    /// How much farther than at its sites the string may go beyond the wall between them, m.
    pub tolerance: f64,
    /// How often a case is run again at most.
    pub rounds: usize,
    /// Those that were found so far, from the bit up, by their distances from it, m.
    pub found: Vec<f64>,
}

/// How sites are found, where the file asks for it; some were `found` already, by their distances
/// from the bit (m).
///
/// # Errors
/// Where a key is refused, or the clearance is not known all along.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    in_hole: &StringInHole,
    found: &[f64],
) -> Result<Option<Finding>, SweepFileError> {
    let wall = content.wall.unwrap_or_default();
    let is_found = wall.sites == SitesName::Auto;
    let tolerance = wall.sites_tolerance_mm.unwrap_or(TOLERANCE_MM);
    let tolerance = source.within(TOLERANCE_KEY, tolerance, 1e-3, 1e3, "mm")?;
    let rounds = wall.sites_rounds.unwrap_or(ROUNDS);
    let message = format!("{rounds} is not between 1 and {MOST_ROUNDS}");
    source.refuse_if(!(1..=MOST_ROUNDS).contains(&rounds), ROUNDS_KEY, message)?;
    let message = "says when sites are found: needs `sites = \"auto\"`";
    for (key, is_given) in [
        (TOLERANCE_KEY, wall.sites_tolerance_mm.is_some()),
        (ROUNDS_KEY, wall.sites_rounds.is_some()),
    ] {
        source.refuse_if(is_given && !is_found, key, message)?;
    }
    if !is_found {
        return Ok(None);
    }
    let message = "finds sites wherever the string goes through the wall: needs `clearance_mm` or \
                   `clearance = \"hole\"` in [wall]";
    let is_known = wall.clearance_mm.is_some() || content.clearance_is_of_hole();
    source.refuse_if(!is_known, "wall.sites", message)?;
    if content.clearance_is_of_hole() && wall.clearance_mm.is_none() {
        let (bit, end) = (in_hole.depth(0.0), in_hole.depth_of_hole());
        let message = format!(
            "finds sites down to the bit, at a depth of {bit} m, and the hole ends at {end} m"
        );
        let is_short = end < bit - in_hole.string.same_place();
        source.refuse_if(is_short, "wall.sites", message)?;
    }
    Ok(Some(Finding {
        every: wall.sites_every_m.unwrap_or(EVERY),
        to: wall.sites_to_m.unwrap_or(LONGEST_STRING),
        tolerance: 1e-3 * tolerance,
        rounds,
        found: found.to_vec(),
    }))
}

const TOLERANCE_KEY: &str = "wall.sites_tolerance_mm";
const ROUNDS_KEY: &str = "wall.sites_rounds";
