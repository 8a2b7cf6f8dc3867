//! The places on the string that are looked at, or where the wall may be touched.

use linear::{Drillstring, Sites};

use crate::sweep_file::{FileContent, Source, SweepFileError};

/// The sites of the file, and the bit where there is no wall.
///
/// # Errors
/// Where one is not on the string, or there are none to touch the wall.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
) -> Result<Sites, SweepFileError> {
    // Without a wall, the bit is always looked at.
    let mut distances = vec![0.0];
    if content.wall.is_some() {
        distances.clear();
        let bit_is_site = (content.sites.iter()).any(|site| site.distance_from_bit_m == 0.0);
        if content.sites.is_empty() || (content.bit.is_some() && !bit_is_site) {
            let message = "a wall needs [[sites]] where it may be touched, \
                           the bit among them if it cuts";
            let is_empty = content.sites.is_empty();
            return Err(source.error(if is_empty { "wall" } else { "sites" }, message));
        }
    }
    // How many distances there are with each site.
    let mut counts = Vec::with_capacity(content.sites.len());
    for site in &content.sites {
        if content.wall.is_some() || site.distance_from_bit_m != 0.0 {
            distances.push(site.distance_from_bit_m);
        }
        counts.push(distances.len());
    }
    Sites::new(string, &distances).map_err(|error| {
        // The first site with which there is an error is to blame.
        let error_with = |count: usize| Sites::new(string, &distances[..count]).err();
        let index = counts.partition_point(|&count| error_with(count).is_none());
        let blamed = counts.get(index).and_then(|&count| error_with(count));
        let key = format!("sites[{index}].distance_from_bit_m");
        source.error(&key, blamed.unwrap_or(error).to_string())
    })
}

/// The number of the site that a disturbance is at.
///
/// # Errors
/// Where there is none.
pub fn site_of(
    source: &Source,
    key: &str,
    distance: f64,
    sites: &Sites,
) -> Result<usize, SweepFileError> {
    // They are in order, and may be many.
    let distances = sites.distances_from_bit();
    let index = distances.partition_point(|site| *site > distance);
    let found = distances.get(index).filter(|site| **site == distance);
    found.map(|_| index).ok_or_else(|| {
        let known: Vec<String> = distances.iter().map(f64::to_string).collect();
        let message = format!(
            "no site is {distance} m from the bit; there are sites at {} m",
            known.join(", ")
        );
        source.error(key, message)
    })
}
