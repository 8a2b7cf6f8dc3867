//! Which key of a sweep file makes a demand too large: the one that would make it
//! smallest, had it a usual value.

use anyhow::Error;
use linear::method::{FiniteElement, Transform};
use linear::{Drillstring, Method, Section, Sites};

use super::demand::{Cost, Demand};
use super::{Limit, Size};
use crate::design::Design;
use crate::engine::Survey;
use crate::plan::{Setting, Sweep};
use crate::quantities::Axis;
use crate::sweep_file::AutoOr;

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
        Some(taps) => format!("asks for responses of {taps:.1e} taps, more than any method gives"),
        None => format!(
            "would take {} of memory, more than {limit}; --memory changes that",
            Size(cost.bytes)
        ),
    };
    let suspects = suspects(demand.sweep).into_iter();
    let changed = suspects.map(|(key, change)| (change.usual(demand).cost(1), key, change));
    let least = changed.min_by(|(one, ..), (other, ..)| {
        let by_length = one.too_long.is_some().cmp(&other.too_long.is_some());
        by_length.then(one.bytes.total_cmp(&other.bytes))
    });
    let matters = |usual: &Cost| {
        cost.too_long.is_some() != usual.too_long.is_some()
            || usual.bytes < (1.0 - LEAST_PART) * cost.bytes
    };
    match least {
        Some((usual, key, change)) if matters(&usual) => {
            let why = match change {
                Change::Time => longest_case(demand.sweep, survey),
                _ => String::new(),
            };
            demand
                .sweep
                .source
                .error(&key, format!("{why}{what}"))
                .into()
        }
        _ => demand.sweep.source.error_of_file(what).into(),
    }
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

/// What a key changes.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Change {
    Time,
    Sites,
    SamplingFrequency,
    Transforms,
    Elements,
    Damping,
    Sections,
}

impl Change {
    /// The demand with a usual value.
    fn usual<'a>(self, demand: &Demand<'a>) -> Demand<'a> {
        let mut usual = demand.clone();
        for (setting, longest) in &mut usual.strings {
            if self == Change::Time {
                *longest = longest.min(TIME);
            } else {
                self.make_usual(setting);
            }
        }
        for method in &mut usual.methods {
            *method = match (self, *method) {
                (Change::Transforms, Method::Hilbert(_)) => Method::Hilbert(Transform::default()),
                (Change::Transforms, Method::DirectIdft(_)) => {
                    Method::DirectIdft(Transform::default())
                }
                (Change::Elements, Method::FiniteElement(_)) => {
                    Method::FiniteElement(FiniteElement::default())
                }
                (_, method) => method,
            };
        }
        usual
    }

    fn make_usual(self, setting: &mut Setting) {
        match self {
            Change::Sites => setting.sites = Sites::bit(),
            Change::SamplingFrequency => {
                let usual = linear::estimates::sampling_frequency(&setting.string);
                *setting = setting.sampled_at(setting.sampling_frequency.min(usual));
            }
            Change::Damping => {
                let sections = setting.string.sections().to_vec();
                change_string(setting, sections, DAMPING);
            }
            Change::Sections => {
                let mut sections = setting.string.sections().to_vec();
                for section in &mut sections {
                    section.repeat = section.repeat.min(CELLS);
                }
                change_string(setting, sections, setting.string.torsional_damping());
            }
            Change::Time | Change::Transforms | Change::Elements => {}
        }
    }
}

fn change_string(setting: &mut Setting, sections: Vec<Section>, damping: f64) {
    if let Ok(changed) = Drillstring::new(setting.string.material(), sections, damping) {
        setting.string = changed;
    }
}

/// Every key that a demand may grow with; where two matter alike, the first is to
/// blame.
fn suspects(sweep: &Sweep) -> Vec<(String, Change)> {
    let mut list = vec![(time_key(sweep), Change::Time)];
    if sweep.setting.sites.len() > 1 {
        list.push(("sites".to_owned(), Change::Sites));
    }
    let frequency = match sweep.choice {
        Some(_) => "accuracy",
        None => "sampling_frequency_hz",
    };
    list.push((frequency.to_owned(), Change::SamplingFrequency));
    for method in &sweep.methods {
        let key = |name: &str| format!("method.{}.{name}", method.name());
        match method {
            Method::Hilbert(_) | Method::DirectIdft(_) => {
                list.push((key("transform_s"), Change::Transforms));
            }
            Method::FiniteElement(_) => list.push((key("elements_per_cell"), Change::Elements)),
            Method::Quadrature | Method::Trapezoidal => {}
        }
    }
    for (begins, fixed, change) in [
        (
            "torsional_damping",
            "string.torsional_damping_nms_rad_m",
            Change::Damping,
        ),
        ("section", "string.sections", Change::Sections),
    ] {
        list.push((key_of(sweep, begins, fixed), change));
    }
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
