//! Which key of a sweep file makes a demand too large: the one that would make it
//! smallest, had it a usual value.

use anyhow::Error;
use linear::method::{FiniteElement, Transform};
use linear::sampling::FEWEST_STEPS;
use linear::{Drillstring, Method, Section, Sites};

use super::demand::{Cost, Demand};
use super::{Limit, Size};
use crate::design::Design;
use crate::engine::Survey;
use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::sweep_file::{AutoOr, SitesName};

/// A usual time simulated, s.
const TIME: f64 = 10.0;

/// A usual damping, N m s/rad per metre.
const DAMPING: f64 = 10.0;

/// Usual cells of a section.
const CELLS: usize = 100;

/// A key that changes less than this part of the whole is not to blame.
const LEAST_PART: f64 = 0.1;

/// One clear sentence about a demand that is too large.
pub fn refusal(demand: &Demand, survey: &Survey, cost: &Cost, limit: &Limit) -> Error {
    let what = match cost.too_long {
        Some(taps) => format!("asks for responses of {taps:.1e} steps, more than any method gives"),
        None => format!(
            "would take {} of memory, more than {limit}; --memory changes that",
            Size(cost.bytes)
        ),
    };
    let suspects = suspects(demand.sweep).into_iter().enumerate();
    let changed = suspects.map(|(index, (key, change))| {
        let mut usual = demand.clone();
        change(&mut usual);
        (usual.cost(1), key, index)
    });
    let least = changed.min_by(|(one, ..), (other, ..)| {
        let by_length = taps_too_long(one).total_cmp(&taps_too_long(other));
        by_length.then(one.bytes.total_cmp(&other.bytes))
    });
    let is_less = |usual: f64, asked: f64| usual < (1.0 - LEAST_PART) * asked;
    let matters = |usual: &Cost| match cost.too_long {
        Some(taps) => is_less(taps_too_long(usual), taps),
        None => is_less(usual.bytes, cost.bytes),
    };
    match least {
        Some((usual, key, index)) if matters(&usual) => {
            let why = match index {
                0 => longest_case(demand.sweep, survey),
                _ => String::new(),
            };
            let message = format!("{why}{what}");
            demand.sweep.source.error(&key, message).into()
        }
        _ => demand.sweep.source.error_of_file(what).into(),
    }
}

/// Taps of the longest response where no method gives it, or none.
fn taps_too_long(cost: &Cost) -> f64 {
    cost.too_long.unwrap_or(0.0)
}

/// The case that lasts longest, in words, where the file does not give its time.
fn longest_case(sweep: &Sweep, survey: &Survey) -> String {
    if sweep.time != AutoOr::Auto {
        return String::new();
    }
    let Some(case) = survey.longest_case else {
        let lasts = survey.longest;
        return format!("the longest case that the random ranges allow lasts {lasts:.3e} s and ");
    };
    let axes = sweep.design.axes().iter().zip(sweep.design.values(case));
    let values: Vec<String> = axes
        .map(|(axis, value)| format!("{} = {value}", axis.name()))
        .collect();
    let values = match values.len() {
        0 => String::new(),
        _ => format!(" ({})", values.join(", ")),
    };
    format!("case {case}{values} lasts {:.3e} s and ", survey.longest)
}

/// Gives a demand the usual value of what a key changes.
type Change = fn(&mut Demand);

fn usual_time(demand: &mut Demand) {
    for (_, longest) in &mut demand.strings {
        *longest = longest.min(TIME);
    }
}

fn usual_transforms(demand: &mut Demand) {
    for method in &mut demand.methods {
        if let Method::Hilbert(transform) | Method::DirectIdft(transform) = method {
            *transform = Transform::default();
        }
    }
}

fn usual_elements(demand: &mut Demand) {
    demand.mesh = FiniteElement::default();
}

fn usual_frequency(demand: &mut Demand) {
    for (setting, _) in &mut demand.strings {
        let usual = linear::sampling::frequency(&setting.string, FEWEST_STEPS);
        setting.sampling_frequency = setting.sampling_frequency.min(usual);
        setting.whirl_rate = None;
    }
    demand.choosing = 0.0;
}

fn usual_sites(demand: &mut Demand) {
    for (setting, _) in &mut demand.strings {
        setting.sites = Sites::bit();
        if let Some(lateral) = &mut setting.lateral {
            lateral.finding = None;
        }
    }
}

fn usual_damping(demand: &mut Demand) {
    change_strings(demand, |string| (string.sections().to_vec(), DAMPING));
}

fn usual_sections(demand: &mut Demand) {
    change_strings(demand, |string| {
        let mut sections = string.sections().to_vec();
        for section in &mut sections {
            section.repeat = section.repeat.min(CELLS);
        }
        (sections, string.torsional_damping())
    });
}

/// Gives the strings other sections and another damping.
fn change_strings(demand: &mut Demand, change: fn(&Drillstring) -> (Vec<Section>, f64)) {
    for (setting, _) in &mut demand.strings {
        let (sections, damping) = change(&setting.string);
        let before = &setting.string;
        let changed = Drillstring::new(before.material(), sections, damping)
            .and_then(|string| string.with_loss_of(before));
        let Ok(changed) = changed else {
            continue;
        };
        let part = changed.length() / setting.string.length();
        move_to(&mut setting.sites, &changed, part);
        if let Some(friction) = &mut setting.friction {
            move_to(&mut friction.nodes, &changed, part);
        }
        setting.string = changed;
    }
}

/// Gives as many sites their places on a string that is a part as long.
fn move_to(sites: &mut Sites, string: &Drillstring, part: f64) {
    if part == 1.0 {
        return;
    }
    let places: Vec<f64> = (sites.distances_from_bit().iter())
        .map(|distance| part * distance)
        .collect();
    if let Ok(moved) = Sites::new(string, &places) {
        *sites = moved;
    }
}

/// Every key that a demand may grow with, that of the time first; where two matter alike,
/// the first is to blame.
fn suspects(sweep: &Sweep) -> Vec<(String, Change)> {
    let mut list: Vec<(String, Change)> = vec![(time_key(sweep), usual_time)];
    let which = sweep.content.wall.unwrap_or_default().sites;
    if sweep.setting.sites.len() > 1 || which == SitesName::Auto {
        let key = match which {
            SitesName::Given => "sites",
            SitesName::All | SitesName::Ends | SitesName::Auto => "wall.sites",
        };
        list.push((key.to_owned(), usual_sites));
    }
    let frequency = match sweep.choice {
        Some(_) => "accuracy",
        None => "sampling_frequency_hz",
    };
    list.push((frequency.to_owned(), usual_frequency));
    for method in &sweep.methods {
        let key = |name: &str| format!("method.{}.{name}", method.name());
        if let Method::Hilbert(_) | Method::DirectIdft(_) = method {
            list.push((key("transform_s"), usual_transforms));
        }
    }
    let elements = "method.finite-element.elements_per_cell";
    list.push((elements.to_owned(), usual_elements));
    let damping = "string.torsional_damping_nms_rad_m";
    list.push((key_of(sweep, "torsional_damping", damping), usual_damping));
    list.push((key_of(sweep, "section", "string.sections"), usual_sections));
    list
}

/// What makes cases long: their time or, where that follows from them, their speed.
fn time_key(sweep: &Sweep) -> String {
    if sweep.time != AutoOr::Auto {
        return "time_s".to_owned();
    }
    key_of(sweep, &Axis::SurfaceSpeedRpm.name(), "surface_speed_rpm")
}

/// The key of a quantity: of the axis whose name begins so, if there is one, or else
/// `fixed`.
fn key_of(sweep: &Sweep, begins: &str, fixed: &str) -> String {
    let names = sweep.design.axes().iter().map(|axis| axis.name());
    let Some(axis) = names.into_iter().find(|name| name.starts_with(begins)) else {
        return fixed.to_owned();
    };
    match sweep.design {
        Design::List(_) => "design.file".to_owned(),
        _ => format!("design.axes.{axis}"),
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::memory::Purpose;

    const JOINTED: &str = r#"
        sampling_frequency_hz = 660
        surface_speed_rpm = 60
        time_s = 30
        methods = ["finite-element"]
        [string]
        shear_modulus_gpa = 80
        density_kg_m3 = 7840
        loss_factor = 0.001
        [[string.sections]]
        repeat = 300
        parts = [
            { length_m = 9, inner_radius_m = 0.054, outer_radius_m = 0.0635 },
            { length_m = 0.5, inner_radius_m = 0.041, outer_radius_m = 0.084 },
        ]
        [mud]
        density_kg_m3 = 1200
        viscosity_cp = 30
        [well]
        hole_diameter_mm = 216
        [bit]
        rock = "sandstone"
        weight_on_bit_kn = 50
    "#;

    /// Else a key that changes something else of the string would be to blame for the memory that
    /// its loss takes.
    #[test]
    fn a_string_that_is_changed_keeps_its_loss() {
        let read = |_: &Path, _: u64| Ok(JOINTED.to_owned());
        let sweep = Sweep::read_from(Path::new("sweep.toml"), &[], &read).unwrap();
        let demand = Demand {
            sweep: &sweep,
            purpose: Purpose::Labels,
            methods: sweep.methods.clone(),
            strings: vec![(sweep.setting.clone(), 30.0)],
            mesh: FiniteElement::default(),
            choosing: 0.0,
        };
        let before = &sweep.setting.string;
        for (change, cells, damping) in [
            (usual_damping as Change, 300, DAMPING),
            (usual_sections, CELLS, 0.0),
        ] {
            let mut usual = demand.clone();
            change(&mut usual);
            let string = &usual.strings[0].0.string;
            assert_eq!(string.sections()[0].repeat, cells);
            assert_eq!(string.torsional_damping(), damping);
            assert_eq!(string.loss().loss_factor(), 0.001);
            assert_eq!(string.loss().viscous_mud(), before.loss().viscous_mud());
            assert!(before.loss().viscous_mud().is_some());
        }
    }
}
