//! What pictures of motion have in common: levels, and whether the wall is shown.

use campaign::engine::{Case, Clearances, Simulation};
use campaign::plan::Sweep;
use campaign::quantities::Unit;
use plot::{Across, LineStyle, Reference, method_style};

/// The clearance is drawn where motion reaches this part of it.
pub const CLEARANCE_SHOWN: f64 = 0.2;

/// The clearances of cases (m) in a unit of widths, each once, where motion comes so near, by its
/// radii in that unit, that both are visible; of each case what `of` finds among those of its
/// sites.
pub fn shown_clearances(
    cases: &[Case],
    of: impl Fn(&[f64]) -> Option<f64>,
    width: &Unit,
    radii: impl Iterator<Item = f64>,
) -> Vec<f64> {
    let of_case = |case: &Case| {
        let walls = case.scene.lateral.iter().flat_map(|lateral| &lateral.walls);
        of(&walls.map(|wall| wall.clearance).collect::<Vec<_>>())
    };
    let furthest = radii.fold(0.0, f64::max);
    let clearances = cases.iter().filter_map(of_case);
    let shown = clearances.map(|clearance| width.number(1e3 * clearance));
    each_once(shown.filter(|clearance| furthest > CLEARANCE_SHOWN * clearance))
}

/// The clearances along the string of cases, each once.
pub fn each_clearance(sweep: &Sweep, cases: &[Case]) -> Vec<Clearances> {
    let mut each: Vec<Clearances> = Vec::new();
    let of_cases = cases.iter();
    for of_case in of_cases.filter_map(|case| Clearances::of(&sweep.setting, case)) {
        if !each.contains(&of_case) {
            each.push(of_case);
        }
    }
    each
}

/// Values in order, each once.
pub fn each_once(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// What a simulation is drawn in: of one case, the colour of its method; of several, a colour for
/// each case and dashes for each method.
pub fn style(of: &Simulation, all: &[Simulation]) -> LineStyle {
    let cases = each(all.iter().map(|simulation| simulation.case));
    let methods = each(all.iter().map(|simulation| simulation.method));
    match &cases[..] {
        [] | [_] => method_style(of.method),
        _ => LineStyle::numbered(place(of.case, &cases), place(of.method, &methods)),
    }
}

/// Values in order of appearance, each once.
fn each<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for value in values {
        if !found.contains(&value) {
            found.push(value);
        }
    }
    found
}

fn place<T: PartialEq>(value: T, among: &[T]) -> usize {
    among.iter().position(|other| *other == value).unwrap_or(0)
}

/// A level line.
pub fn level(at: f64, name: &str) -> Reference {
    Reference {
        across: Across::Y,
        at,
        name: name.to_owned(),
    }
}
