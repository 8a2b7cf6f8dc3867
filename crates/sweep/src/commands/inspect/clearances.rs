//! The clearances that the hole leaves, in words and numbers.

use super::description::row;
use campaign::plan::{Sweep, WallSettings};
use campaign::quantities::{INCH, LENGTH};
use campaign::words::counted;

/// Of more sites only this number, those next to the bit, have a line each.
const MOST_LINES: usize = 20;

/// The clearance at each site where the hole decides it.
pub fn describe_clearances(sweep: &Sweep) -> String {
    let (content, setting) = (&sweep.content, &sweep.setting);
    let Some(lateral) = &setting.lateral else {
        return String::new();
    };
    let has_own = |site: usize| content.sites[site].clearance_mm.is_some();
    let is_of_hole =
        |wall: &WallSettings| content.clearance_is_of_hole() && !wall.site.is_some_and(has_own);
    // From the bit up.
    let sites = setting.sites.distances_from_bit().iter();
    let sites = sites.copied().zip(&lateral.walls).rev();
    let sites: Vec<(f64, &WallSettings)> = sites.filter(|(_, wall)| is_of_hole(wall)).collect();
    let by_clearance = |one: &&(f64, &WallSettings), other: &&(f64, &WallSettings)| {
        one.1.clearance.total_cmp(&other.1.clearance)
    };
    let ends = (sites.iter().min_by(by_clearance)).zip(sites.iter().max_by(by_clearance));
    let Some((least, greatest)) = ends else {
        return String::new();
    };
    let length = content.units.of(&LENGTH);
    let place = |distance: f64| length.text(distance, 3);
    let mut text = format!(
        "\nclearance that the hole leaves\n    \
         from the bit    hole                string              clearance\n    \
         {:<16}mm         in       mm         in       mm         in\n",
        length.name
    );
    for (distance, wall) in sites.iter().take(MOST_LINES) {
        let decimals = length.decimals(3);
        text += &format!("    {:<14.decimals$}", length.number(*distance));
        let string = 2.0 * wall.radius;
        for diameter in [string + 2.0 * wall.clearance, string] {
            text += &format!("  {:<9.1}{:<9.3}", 1e3 * diameter, diameter / INCH);
        }
        let clearance = wall.clearance;
        text += &format!("  {:<9.2}{:.4}\n", 1e3 * clearance, clearance / INCH);
    }
    if sites.len() > MOST_LINES {
        let more = counted(sites.len() - MOST_LINES, "more site");
        text += &format!("    and {more} above\n");
    }
    for (title, (distance, wall)) in [("least", least), ("greatest", greatest)] {
        let clearance = wall.clearance;
        let value = format!(
            "{:.2} mm ({:.4} in), {} from the bit",
            1e3 * clearance,
            clearance / INCH,
            place(*distance)
        );
        text += &row(2, title, &value);
    }
    text
}
