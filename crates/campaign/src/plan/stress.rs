//! `[wall] stress_every_m`: where bending and stress of the moving string are measured.

use linear::Sites;

use crate::quantities::LONGEST_STRING;
use crate::sweep_file::{FileContent, Source, SweepFileError};

/// More places than this are not measured: their responses would take more memory than those that
/// cases are stepped by.
const MOST_PLACES: usize = 500;

/// Places between sites are given to a millimetre: parts of a metre.
const GIVEN_TO: f64 = 1e3;

/// The key.
const KEY: &str = "wall.stress_every_m";

/// The places, m from the bit, from the surface down: the sites, and between them and the bit others
/// no further apart than the file says. Nothing at the bit, which nothing bends; empty where stress is
/// not measured.
///
/// # Errors
/// Where the key is refused, there are no such places, or too many.
pub fn places(
    source: &Source,
    content: &FileContent,
    sites: &Sites,
) -> Result<Vec<f64>, SweepFileError> {
    let Some(every) = content.wall.and_then(|wall| wall.stress_every_m) else {
        return Ok(Vec::new());
    };
    source.within(KEY, every, 0.1, LONGEST_STRING, "m")?;
    let message = "with [string_friction] only where the string lies in its hole: what friction takes \
                   between the sites of one that hangs is not known there";
    let rubs = content.string_friction.is_some() && !content.lies_on_low_side();
    source.refuse_if(rubs, KEY, message)?;
    let sites = sites.distances_from_bit();
    let ends = sites
        .iter()
        .chain(sites.last().filter(|last| **last > 0.0).map(|_| &0.0));
    let ends: Vec<f64> = ends.copied().collect();
    let parts = |upper: f64, lower: f64| ((upper - lower) / every - 1e-9).ceil().max(1.0);
    let count: f64 = ends.windows(2).map(|pair| parts(pair[0], pair[1])).sum();
    let message = "needs a site above the bit: the string is bent between sites";
    source.refuse_if(count == 0.0, KEY, message)?;
    let message = format!(
        "makes {count} places: at most {MOST_PLACES} are measured, and a larger distance makes fewer"
    );
    source.refuse_if(count > MOST_PLACES as f64, KEY, message)?;
    let between = ends.windows(2).flat_map(|pair| {
        let (upper, length, parts) = (pair[0], pair[0] - pair[1], parts(pair[0], pair[1]));
        let place = move |part: usize| match part {
            0 => upper,
            part => ((upper - length * part as f64 / parts) * GIVEN_TO).round() / GIVEN_TO,
        };
        (0..parts as usize).map(place)
    });
    Ok(between.collect())
}
