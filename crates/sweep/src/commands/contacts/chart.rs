//! Limits and bounds over the number of contacts, a panel for each string.

use super::table::impulse_name;
use crate::commands::prepare::unique;
use plot::{Axis, LineStyle, Look, Panel, Picture, Series, method_style, panels};
use studies::contacts::{Bounds, LimitRow};

/// A bound by its name.
type Bound = (&'static str, fn(&Bounds) -> Option<f64>);

const BOUNDS: [Bound; 3] = [
    ("bound: one contact alone", |bounds| bounds.one_site),
    ("bound: any contacts", |bounds| bounds.any_sites),
    ("bound: carried everywhere", |bounds| Some(bounds.carried)),
];

/// Draws the limits that were found: by several methods, those of each.
pub fn chart(rows: &[LimitRow], lowest: f64) -> Picture {
    let names: Vec<&str> = rows.iter().map(|row| row.string.as_str()).collect();
    let methods: Vec<&str> = rows.iter().map(|row| row.method.name()).collect();
    let several = unique(&methods).len() > 1;
    let panels_of: Vec<Panel> = (unique(&names).into_iter())
        .map(|name| {
            let of_string = rows.iter().filter(|row| row.string == name);
            panel(name, &of_string.collect::<Vec<_>>(), lowest, several)
        })
        .collect();
    panels(
        &Look::default(),
        "Friction from which backward whirl lasts, over the number of contacts",
        &panels_of,
    )
}

fn panel(string: &str, rows: &[&LimitRow], lowest: f64, several: bool) -> Panel {
    let mut series: Vec<Series> = Vec::new();
    let mut add = |name: String, style: LineStyle, row: &LimitRow, friction: Option<f64>| {
        let known = series.iter().position(|series| series.name == name);
        let place = known.unwrap_or_else(|| {
            series.push(Series::new(name, Vec::new()).styled(style));
            series.len() - 1
        });
        let point = (row.contacts as f64, friction.unwrap_or(f64::NAN));
        // Rows of one number of contacts have the same bounds.
        if series[place]
            .points
            .last()
            .is_none_or(|last| last.0 != point.0)
        {
            series[place].points.push(point);
        }
    };
    for row in rows {
        let mut name = impulse_name(&row.impulse, lowest);
        let mut style = LineStyle::default();
        if several {
            let method = row.method.name();
            name += &format!(", {method}");
            style = method_style(method);
        }
        let lasts = row.limit.as_ref().ok().and_then(|limit| limit.lasts);
        add(name, style, row, lasts.map(|(friction, _)| friction));
    }
    for (dash, (name, bound)) in BOUNDS.into_iter().enumerate() {
        for row in rows {
            add(
                name.to_owned(),
                LineStyle::grey(dash),
                row,
                bound(&row.bounds),
            );
        }
    }
    Panel {
        axes: [
            Axis::logarithmic("Contacts"),
            Axis::logarithmic(format!("Friction μ₀, {string}")),
        ],
        series,
        references: Vec::new(),
        walls: Vec::new(),
        is_difference: false,
    }
}
