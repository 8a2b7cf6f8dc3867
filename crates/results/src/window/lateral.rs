//! The limits of lateral motion that are known without a case: from which speed on backward whirl
//! can last, and lateral resonance.

use linear::Sites;
use linear::natural_frequencies::held_lateral_frequencies_below;

use super::analytic::{Resonance, above_speed, resonance_limit};
use super::asked::WindowAsked;
use super::chart::{Drawn, Source};
use super::error::WindowError;
use super::standing::Standing;
use super::swings::Swings;
use campaign::plan::{LateralSettings, Sweep, WallSettings};
use campaign::quantities::{Axis, LENGTH, WallQuantity};
use campaign::words::short;
use limits::whirl_from;

/// The limits within ranges of weight on bit (kN) and surface speed (rpm); none where the string
/// does not bend.
///
/// # Errors
/// Where places that hold the string are not on it.
pub fn limits(
    sweep: &Sweep,
    ranges: [[f64; 2]; 2],
    asked: &WindowAsked,
) -> Result<Vec<Source<'static>>, WindowError> {
    let Some(lateral) = &sweep.setting.lateral else {
        return match asked.held_at {
            Some(_) => Err(WindowError::NotBent),
            None => Ok(Vec::new()),
        };
    };
    let mut found = match (&sweep.setting.lying, &asked.held_at) {
        (Some(_), Some(_)) => return Err(WindowError::Lies),
        (Some(_), None) => Swings::new(sweep, ranges, asked).limits(),
        (None, _) => resonances(sweep, lateral, ranges[1], asked)?,
    };
    found.extend(whirl(sweep, lateral, ranges, asked.margin)?);
    Ok(found)
}

/// What may shake the string sideways or along itself, and has no limit on the chart, within ranges of weight
/// on bit (kN) and surface speed (rpm).
pub fn not_examined(sweep: &Sweep, ranges: [[f64; 2]; 2], asked: &WindowAsked) -> Vec<String> {
    let axial = "vibration along the string, and a bit that bounces: they are not modelled";
    let axial = sweep.setting.cutting.is_none().then(|| axial.to_owned());
    let sideways = match &sweep.setting.lateral {
        None => vec!["vibration sideways and whirl: the file has no [wall]".to_owned()],
        Some(_) if sweep.setting.lying.is_some() => {
            Swings::new(sweep, ranges, asked).not_examined()
        }
        Some(lateral) => above_the_uppermost(sweep, lateral, asked)
            .into_iter()
            .collect(),
    };
    let whirl = (sweep.setting.lateral.as_ref()).and_then(|lateral| no_bound(sweep, lateral));
    let whirl =
        whirl.map(|reason| format!("from which speed on whirl lasts, once triggered: {reason}"));
    sideways.into_iter().chain(whirl).chain(axial).collect()
}

/// Why no bound says where whirl cannot last; none where one does.
fn no_bound(sweep: &Sweep, lateral: &LateralSettings) -> Option<String> {
    if sweep.setting.lying.is_some() {
        let reason = "no bound is known for a string on the low side of its hole";
        return Some(reason.to_owned());
    }
    if sweep.setting.whirling_with_string().is_none() {
        let reason = "the bit, which is at a wall, turns faster than the string";
        return Some(reason.to_owned());
    }
    let is_found = lateral.finding.is_some();
    is_found.then(|| "the sites that cases find differ from case to case".to_owned())
}

/// A part is wider than pipe if it is this much wider than the body of the uppermost section.
const WIDER: f64 = 1.2;

/// The string above all that holds it sideways.
fn above_the_uppermost(
    sweep: &Sweep,
    lateral: &LateralSettings,
    asked: &WindowAsked,
) -> Option<String> {
    let string = &sweep.setting.string;
    let places = held_places(sweep, lateral, asked);
    let uppermost = places.iter().copied().fold(0.0, f64::max);
    let above = string.length() - uppermost;
    let longest = string.sections()[0].parts.iter();
    let body = longest.max_by(|one, other| one.length.total_cmp(&other.length))?;
    // Joints of pipe are wide over a small part of it, and no collars.
    let mut depth = 0.0;
    let mut wide = 0.0;
    for section in string.sections() {
        let length: f64 = section.parts.iter().map(|part| part.length).sum();
        let is_wide = |part: &&linear::Tube| part.outer_radius > WIDER * body.outer_radius;
        let of_wide: f64 = (section.parts.iter().filter(is_wide))
            .map(|part| part.length)
            .sum();
        let whole = section.repeat as f64 * length;
        let within = (above - depth).clamp(0.0, whole);
        if of_wide > 0.5 * length {
            wide += within;
        }
        depth += whole;
    }
    let unit = sweep.content.units.of(&LENGTH);
    let [above, wide_text, place] = [above, wide, uppermost].map(|it| unit.text(it, 1));
    let collars = match wide > 0.0 {
        true => format!(", {wide_text} of it wider than pipe"),
        false => String::new(),
    };
    (string.length() > uppermost).then(|| {
        format!(
            "resonance sideways of the {above} of string above {place} from the bit, the uppermost \
             place that holds it{collars}"
        )
    })
}

/// Distances from the bit of what holds the string sideways, m.
fn held_places(sweep: &Sweep, lateral: &LateralSettings, asked: &WindowAsked) -> Vec<f64> {
    let unit = sweep.content.units.of(&LENGTH);
    let given = asked.held_at.as_ref();
    let given = given.map(|places| places.iter().map(|place| unit.in_si(*place)).collect());
    given.unwrap_or_else(|| lateral.held_places(&sweep.setting.sites))
}

const WHIRL: &str = "backward whirl, if triggered, sustains itself";

/// The speed from which on backward whirl can last at a site, rolling or sliding; without a bound it may at
/// every speed, but on walls without friction, which drive none.
fn whirl(
    sweep: &Sweep,
    lateral: &LateralSettings,
    [weights, speeds]: [[f64; 2]; 2],
    margin: f64,
) -> Result<Option<Source<'static>>, WindowError> {
    let frictions = friction(sweep, lateral, margin);
    if no_bound(sweep, lateral).is_some() {
        return Ok((frictions[1] > 0.0).then(|| Source {
            name: WHIRL.to_owned(),
            description: "no bound excludes it anywhere".to_owned(),
            edges: Default::default(),
            standing: Box::new(|_| Standing::Possible),
            drawn: Drawn::Lines(Vec::new()),
        }));
    }
    let [latest, soonest] = whirl_from(&sweep.setting, lateral, speeds, frictions)?;
    let [least, most] = frictions.map(short);
    let extent = match soonest {
        None => format!("nowhere on the map, with friction up to {most}"),
        Some(from) if latest == Some(from) => {
            format!("on the whole map, with friction {least} to {most}")
        }
        Some(from) => {
            let to = latest.map_or_else(
                || format!("not at all with {least}"),
                |to| format!("{} rpm on with {least}", short(to)),
            );
            format!(
                "from {} rpm on with friction {most}, from {to}",
                short(from)
            )
        }
    };
    let line = |from: f64| weights.map(|weight| [weight, from]).to_vec();
    // None along the edge of the map.
    let lines = soonest
        .into_iter()
        .chain(latest)
        .filter(|from| *from > speeds[0]);
    let soonest_or_never = soonest.unwrap_or(f64::INFINITY);
    Ok(Some(Source {
        name: WHIRL.to_owned(),
        description: format!("{extent}; balance of forces at one site alone"),
        edges: [Vec::new(), soonest.into_iter().collect()],
        standing: Box::new(move |ends| above_speed(soonest_or_never, ends)),
        drawn: Drawn::Lines(lines.map(line).collect()),
    }))
}

/// The least and the greatest coefficient of friction of the site that has most: the ends of its
/// axis, or a number that may be off by a part.
fn friction(sweep: &Sweep, lateral: &LateralSettings, margin: f64) -> [f64; 2] {
    let of_site = |wall: &WallSettings| {
        let quantity = WallQuantity::Friction;
        let own = (wall.site).map(|site| Axis::WallAtSite { site, quantity });
        let ends = own.and_then(|own| sweep.design.ends(own));
        let ends = ends.or_else(|| sweep.design.ends(Axis::FRICTION));
        ends.unwrap_or_else(|| {
            let friction = wall.friction.unwrap_or_default();
            [friction * (1.0 - margin), friction * (1.0 + margin)]
        })
    };
    let all = lateral.walls.iter().map(of_site);
    all.fold([0.0; 2], |[least, most], own| {
        [least.max(own[0]), most.max(own[1])]
    })
}

/// Where a multiple of the speed meets a lateral natural frequency of the string between the
/// places that hold it.
fn resonances(
    sweep: &Sweep,
    lateral: &LateralSettings,
    speeds: [f64; 2],
    asked: &WindowAsked,
) -> Result<Vec<Source<'static>>, WindowError> {
    let string = &sweep.setting.string;
    let length = sweep.content.units.of(&LENGTH);
    let places = held_places(sweep, lateral, asked);
    if places.is_empty() {
        return Err(WindowError::NotHeld);
    }
    let held = Sites::new(string, &places).map_err(WindowError::HeldAt)?;
    let margin = asked.margin;
    let most = asked.orders.iter().copied().fold(0.0, f64::max);
    // Also those whose margin reaches into the map.
    let highest = most * speeds[1] / (1.0 - margin) * std::f64::consts::TAU / 60.0;
    let frequencies = held_lateral_frequencies_below(string, &lateral.bending, &held, highest)?;
    let places: Vec<String> = (held.distances_from_bit().iter().rev())
        .map(|place| short(length.number(*place)))
        .collect();
    let held = format!("held at {} {} from the bit", places.join(", "), length.name);
    let of_order = |&order: &f64| {
        let all = frequencies
            .iter()
            .map(|omega| Resonance::new(order, [omega / std::f64::consts::TAU; 2], margin));
        let all = all.filter(|it| it.range[1] > speeds[0] && it.range[0] < speeds[1]);
        resonance_limit("lateral resonance", order, (all.collect(), margin), &held)
    };
    Ok(asked.orders.iter().map(of_order).collect())
}
