//! `[[tools]]`: where accelerations are measured instead of at the sites.

use linear::{Drillstring, Sites};
use sim::USUAL_BAND;

use crate::sweep_file::{FileContent, SitesName, Source, SweepFileError};

/// More tools than this are not measured: their responses would take as much memory as those that cases
/// are stepped by.
const MOST_TOOLS: usize = 40;

/// The places of all tools, m from the bit, from the surface down, and their bands, Hz.
///
/// # Errors
/// Where nothing moves but the rotation, a tool is not on the string, two are at one place, there are too
/// many, one is where the string is taken to be at rest, or a band is out of its range.
pub fn resolve(
    source: &Source,
    content: &FileContent,
    string: &Drillstring,
    sites: &Sites,
) -> Result<(Vec<f64>, Vec<f64>), SweepFileError> {
    let mut tools: Vec<(f64, f64)> = Vec::with_capacity(content.tools.len());
    let moves = content.wall.is_some() || content.has_cutting();
    let message = "needs a table [wall], or a bit with [bit.cutting]";
    source.refuse_if(!moves && !content.tools.is_empty(), "tools", message)?;
    let are_many = content.tools.len() > MOST_TOOLS;
    source.refuse_if(
        are_many,
        "tools",
        format!("of these there may be at most {MOST_TOOLS}"),
    )?;
    let finds = content
        .wall
        .is_some_and(|wall| wall.sites == SitesName::Auto);
    let moves_to = match sites.distances_from_bit().first() {
        Some(highest) if content.lies_on_low_side() && !finds => *highest,
        _ => f64::INFINITY,
    };
    for (index, tool) in content.tools.iter().enumerate() {
        let key = format!("tools[{index}].distance_from_bit_m");
        let place = tool.distance_from_bit_m;
        source.checked(&key, Sites::new(string, &[place]))?;
        let message = format!(
            "is above the highest site, {moves_to} m from the bit, where a string that lies in its hole is \
             taken to be at rest: more sites, such as by `wall.sites_to_m`, let it move there"
        );
        source.refuse_if(place > moves_to, &key, message)?;
        let is_there = |(other, _): &(f64, f64)| (other - place).abs() <= string.same_place();
        let message = "is where another tool is";
        source.refuse_if(tools.iter().any(is_there), &key, message)?;
        let (key, band) = (format!("tools[{index}].band_hz"), tool.band_hz);
        let band = band.map(|band| source.within(&key, band, 0.1, 1e5, "Hz"));
        tools.push((place, band.transpose()?.unwrap_or(USUAL_BAND)));
    }
    tools.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    Ok(tools.into_iter().unzip())
}
