//! The limits of lateral motion that are known without a case: from which speed on backward whirl
//! can last, and lateral resonance.

use linear::Sites;
use linear::natural_frequencies::held_lateral_frequencies_below;

use super::analytic::{Resonance, above_speed, near_resonances};
use super::asked::WindowAsked;
use super::chart::{Drawn, Source};
use super::error::WindowError;
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
    let Some(lateral) = sweep.setting.hanging_sideways() else {
        if asked.held_at.is_some() {
            return Err(WindowError::NotBent);
        }
        return Ok(Vec::new());
    };
    let mut found = resonances(sweep, lateral, ranges[1], asked)?;
    if sweep.setting.whirling_with_string().is_some() {
        found.push(whirl(sweep, lateral, ranges, asked.margin)?);
    }
    Ok(found)
}

/// What may shake the string sideways or along itself, and has no limit on the chart.
pub fn not_examined(sweep: &Sweep, asked: &WindowAsked) -> Vec<String> {
    let axial = "vibration along the string, and a bit that bounces: they are not modelled";
    let axial = sweep.setting.cutting.is_none().then(|| axial.to_owned());
    let sideways = match &sweep.setting.lateral {
        None => Some("vibration sideways and whirl: the file has no [wall]".to_owned()),
        Some(lateral) => above_the_uppermost(sweep, lateral, asked),
    };
    let setting = &sweep.setting;
    let of_bit = setting.hanging_sideways().is_some() && setting.whirling_with_string().is_none();
    let whirl = of_bit.then(|| {
        "from which speed on whirl lasts: the bit, which is at a wall, turns faster than the string".to_owned()
    });
    sideways.into_iter().chain(whirl).chain(axial).collect()
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

/// The speed from which on backward whirl can last at a site, rolling or sliding.
fn whirl(
    sweep: &Sweep,
    lateral: &LateralSettings,
    [weights, speeds]: [[f64; 2]; 2],
    margin: f64,
) -> Result<Source<'static>, WindowError> {
    let frictions = friction(sweep, lateral, margin);
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
    Ok(Source {
        name: "backward whirl, if triggered, sustains itself".to_owned(),
        description: format!("{extent}; balance of forces at one site alone"),
        edges: [Vec::new(), soonest.into_iter().collect()],
        standing: Box::new(move |ends| above_speed(soonest_or_never, ends)),
        drawn: Drawn::Lines(lines.map(line).collect()),
    })
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
            .map(|omega| Resonance::of(order, omega / std::f64::consts::TAU, margin));
        let is_on_map = |it: &Resonance| it.range[1] > speeds[0] && it.range[0] < speeds[1];
        let all: Vec<Resonance> = all.filter(is_on_map).collect();
        let critical: Vec<String> = all.iter().map(|it| short(it.speed)).collect();
        let critical = match &critical[..] {
            [] => "none on the map".to_owned(),
            critical => format!("{} rpm", critical.join(", ")),
        };
        let ends = all.iter().flat_map(|it| it.range);
        Source {
            name: format!("lateral resonance {}×", short(order)),
            description: format!("{critical}, ± {} %; {held}", short(100.0 * margin)),
            edges: [Vec::new(), ends.collect()],
            drawn: Drawn::Bands(
                (all.iter())
                    .map(|it| {
                        (
                            it.range,
                            format!("{}×: {} rpm", short(order), short(it.speed)),
                        )
                    })
                    .collect(),
            ),
            standing: Box::new(move |ends| near_resonances(&all, ends)),
        }
    };
    Ok(asked.orders.iter().map(of_order).collect())
}
