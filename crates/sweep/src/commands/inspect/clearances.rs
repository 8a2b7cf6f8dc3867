//! The clearances that the hole leaves, in words and numbers.

use serde::Serialize;

use super::rows::row;
use campaign::plan::{Sweep, WallSettings};
use campaign::quantities::{INCH, LENGTH, Unit, Units};
use campaign::words::counted;

/// Of more sites only this number, those next to the bit, have a line each.
const MOST_LINES: usize = 20;

/// The clearance at a site where the hole decides it.
#[derive(Serialize)]
pub struct InspectedClearance {
    site_from_bit_m: f64,
    hole_diameter_m: f64,
    string_diameter_m: f64,
    clearance_m: f64,
}

/// The clearance at each site where the hole decides it, from the bit up.
pub fn clearances_of_hole(sweep: &Sweep) -> Vec<InspectedClearance> {
    let (content, setting) = (&sweep.content, &sweep.setting);
    let Some(lateral) = &setting.lateral else {
        return Vec::new();
    };
    let has_own = |site: usize| content.sites[site].clearance_mm.is_some();
    let is_of_hole =
        |wall: &WallSettings| content.clearance_is_of_hole() && !wall.site.is_some_and(has_own);
    let sites = setting.sites.distances_from_bit().iter();
    let sites = sites.copied().zip(&lateral.walls).rev();
    let sites = sites.filter(|(_, wall)| is_of_hole(wall));
    let clearance = |(site_from_bit_m, wall): (f64, &WallSettings)| {
        let string_diameter_m = 2.0 * wall.radius;
        InspectedClearance {
            site_from_bit_m,
            hole_diameter_m: string_diameter_m + 2.0 * wall.clearance,
            string_diameter_m,
            clearance_m: wall.clearance,
        }
    };
    sites.map(clearance).collect()
}

/// They in words and numbers; nothing where there are none.
pub fn describe_clearances(sites: &[InspectedClearance], units: Units) -> String {
    let by_clearance = |one: &&InspectedClearance, other: &&InspectedClearance| {
        one.clearance_m.total_cmp(&other.clearance_m)
    };
    let ends = (sites.iter().min_by(by_clearance)).zip(sites.iter().max_by(by_clearance));
    let Some((least, greatest)) = ends else {
        return String::new();
    };
    let length = units.of(&LENGTH);
    let mut text = format!(
        "\nclearance that the hole leaves\n    \
         from the bit    hole                string              clearance\n    \
         {:<16}mm         in       mm         in       mm         in\n",
        length.name
    );
    let first = sites.iter().take(MOST_LINES);
    text.extend(first.map(|site| line(site, &length)));
    if sites.len() > MOST_LINES {
        let more = counted(sites.len() - MOST_LINES, "more site");
        text += &format!("    and {more} above\n");
    }
    for (title, site) in [("least", least), ("greatest", greatest)] {
        let clearance = site.clearance_m;
        let value = format!(
            "{:.2} mm ({:.4} in), {} from the bit",
            1e3 * clearance,
            clearance / INCH,
            length.text(site.site_from_bit_m, 3)
        );
        text += &row(2, title, &value);
    }
    text
}

fn line(site: &InspectedClearance, length: &Unit) -> String {
    let decimals = length.decimals(3);
    let mut text = format!("    {:<14.decimals$}", length.number(site.site_from_bit_m));
    for diameter in [site.hole_diameter_m, site.string_diameter_m] {
        text += &format!("  {:<9.1}{:<9.3}", 1e3 * diameter, diameter / INCH);
    }
    let clearance = site.clearance_m;
    text + &format!("  {:<9.2}{:.4}\n", 1e3 * clearance, clearance / INCH)
}
