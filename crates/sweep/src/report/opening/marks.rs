//! A verdict for each mark of the map, from the cases around it.

use super::found::column_text;
use crate::report::lattice::{Column, Found, Lattice, Limit};
use crate::report::phrases::{capital, clauses, condition, number};
use crate::report::results::Results;
use campaign::plan::MapMark;
use campaign::quantities::{Axis, Units};
use sim::Motion;

/// The marks by name, each with its place and its verdict.
pub fn verdicts(results: &Results) -> Vec<(String, String)> {
    let manifest = &results.manifest;
    let (Some(map), Some(lattice)) = (&manifest.map, &results.lattice) else {
        return Vec::new();
    };
    let units = manifest.sweep.units;
    let of_mark = |mark: &MapMark| {
        let place = [(map.x, mark.x), (map.y, mark.y)];
        let at = place.map(|(axis, value)| {
            let value = number(axis, value, 0.0, units);
            condition(axis, &value, units)
        });
        let value = |axis: Axis| {
            let mut place = place.iter();
            place
                .find(|(other, _)| *other == axis)
                .map(|(_, value)| *value)
        };
        let [limited, across] = lattice.axes.map(value);
        let verdicts = lattice.motions().filter_map(|motion| {
            let column = lattice.column_at(motion, across?)?;
            verdict(lattice, motion, (limited?, column), units)
        });
        let verdicts: Vec<String> = verdicts.collect();
        let verdict = match verdicts.is_empty() {
            true => "outside the cases of this map".to_owned(),
            false => verdicts.join("; "),
        };
        let name = format!("Mark {}", mark.name);
        (name, format!("{}: {verdict}.", capital(&at.join(", "))))
    };
    map.marks.iter().map(of_mark).collect()
}

/// What a motion is at a value, by its column of cases; none outside them.
fn verdict(
    lattice: &Lattice,
    motion: Motion,
    (value, column): (f64, Column),
    units: Units,
) -> Option<String> {
    let [subject, with, without] = clauses(motion);
    let axis = lattice.axes[0];
    if !lattice.holds(value) {
        return None;
    }
    let Found::Limit(limit) = column.found else {
        let words = column_text(column.found, motion, axis, units);
        return Some(format!("{subject} {words} here"));
    };
    let Limit {
        is_below,
        whole,
        none,
        step,
    } = limit;
    let at = |value: f64| number(axis, value, step, units);
    // On the side of the limit that has it.
    let is_inside = |end: f64| (value < end) == is_below;
    let side = |end: f64| if value < end { "below" } else { "above" };
    let near = |end: f64| (value - end).abs() < 0.5 * step;
    let by = |end: f64| {
        let off = number(axis, (value - end).abs(), step, units);
        format!("{off} {} the limit of about {}", side(end), at(end))
    };
    Some(match (whole, none) {
        (Some(end), Some(other)) if end == other && near(end) => {
            format!(
                "{subject} is at the limit of about {}: it may do either",
                at(end)
            )
        }
        (Some(end), _) if is_inside(end) => format!("{subject} {with}, {}", by(end)),
        (_, Some(end)) if !is_inside(end) => format!("{subject} {without}, {}", by(end)),
        _ => format!("{subject} partly {with}: cases or methods next to it differ"),
    })
}
