//! One map of a page. Its drawing takes the available room; the words around it and on it are
//! separate elements of the page, which stay as large as other words.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::look::{LINES, class_of_fill, class_of_symbol, short, symbol_path};
use crate::report::escaping::{escaped, with_index};
use plot::{MapAxis, MapCell, MapPanel, Mark, Series, Symbol};

/// Size of the drawing in its own units.
const SIZE: [f64; 2] = [600.0, 450.0];

/// Places further away than this, in sizes of the drawing, are out of sight all the same.
const FURTHEST: f64 = 100.0;

/// From what is drawn on a map to its elements.
pub fn panel(axes: &[MapAxis; 2], marks: &[Mark], panel: &MapPanel, names: &[&str]) -> String {
    let [x, y] = axes;
    let title = match panel.title.as_str() {
        "" => String::new(),
        title => format!("<h4>{}</h4>\n", words(title)),
    };
    let label = match panel.title.as_str() {
        "" => format!("Map of {} over {}", y.title, x.title),
        title => format!("{title}: map of {} over {}", y.title, x.title),
    };
    format!(
        "<div class=\"panel\">\n{title}<div class=\"plot\">\n\
         <div class=\"title-y\"><span>{}</span></div>\n<div class=\"axis-y\">{}</div>\n\
         <div class=\"area\">\n<svg viewBox=\"0 0 {} {}\" preserveAspectRatio=\"none\" \
         role=\"img\" aria-label=\"{}\">\n{}</svg>\n{}</div>\n\
         <div class=\"axis-x\">{}</div>\n<div class=\"title-x\">{}</div>\n</div>\n</div>\n",
        words(&y.title),
        ticks(y, "bottom"),
        SIZE[0],
        SIZE[1],
        escaped(&label),
        drawn(axes, marks, panel, names),
        named(axes, marks.iter().chain(&panel.names)),
        ticks(x, "left"),
        words(&x.title),
    )
}

fn words(text: &str) -> String {
    with_index(&escaped(text))
}

/// The numbers along an axis; those of the map's widest one keep its room.
fn ticks(axis: &MapAxis, side: &str) -> String {
    let widest = axis.ticks.iter().map(|(_, number)| number);
    let widest = widest.max_by_key(|number| number.chars().count());
    let room = widest.map_or_else(String::new, |number| {
        format!("<i aria-hidden=\"true\">{}</i>", escaped(number))
    });
    let numbers = axis.ticks.iter().map(|(fraction, number)| {
        format!(
            "<span style=\"{side}:{}%\">{}</span>",
            short(100.0 * fraction),
            escaped(number)
        )
    });
    room + &numbers.collect::<String>()
}

/// Names next to their places; those on the right half stand to the left of it.
fn named<'a>(axes: &[MapAxis; 2], marks: impl Iterator<Item = &'a Mark>) -> String {
    let names = marks.filter_map(|mark| {
        let [x, y] = place(axes, mark.at)?;
        let (side, along) = if x <= 0.5 * SIZE[0] {
            ("left", x / SIZE[0])
        } else {
            ("right", 1.0 - x / SIZE[0])
        };
        Some(format!(
            "<span class=\"name\" style=\"{side}:{}%;top:{}%\">{}</span>\n",
            short(100.0 * along),
            short(100.0 * y / SIZE[1]),
            words(&mark.name)
        ))
    });
    names.collect()
}

/// Where a place is on the drawing; none where an end is no number.
fn place(axes: &[MapAxis; 2], (x, y): (f64, f64)) -> Option<[f64; 2]> {
    let within = |fraction: f64| fraction.clamp(-FURTHEST, FURTHEST);
    let (x, y) = axes[0].fraction(x).zip(axes[1].fraction(y))?;
    let is_there = x.is_finite() && y.is_finite();
    is_there.then(|| [within(x) * SIZE[0], (1.0 - within(y)) * SIZE[1]])
}

fn drawn(axes: &[MapAxis; 2], marks: &[Mark], panel: &MapPanel, names: &[&str]) -> String {
    let mut svg = cells(axes, &panel.cells);
    svg += &grid(axes);
    for band in &panel.bands {
        let area = rectangle(axes, band.ends).unwrap_or_default();
        svg += &format!("<path class=\"range\" d=\"{area}\"></path>\n");
    }
    svg += &symbols(axes, panel);
    let curves: Vec<String> = (panel.lines.iter()).map(|line| curve(axes, line)).collect();
    // All rims below all lines: lines that coincide show one another between their dashes.
    for path in &curves {
        svg += &format!("<path class=\"rim\" d=\"{path}\"></path>\n");
    }
    for (line, path) in panel.lines.iter().zip(&curves) {
        let name = names.iter().position(|name| *name == line.name);
        let look = name.unwrap_or(0) % LINES;
        svg += &format!("<path class=\"line l{look}\" d=\"{path}\"></path>\n");
    }
    for [x, y] in marks.iter().filter_map(|mark| place(axes, mark.at)) {
        svg += &format!(
            "<path class=\"mark\" d=\"M{} {}l6 10h-12z\"></path>\n",
            short(x),
            short(y - 7.0)
        );
    }
    svg
}

fn grid(axes: &[MapAxis; 2]) -> String {
    let [width, height] = SIZE;
    let mut path = String::new();
    for (fraction, _) in &axes[0].ticks {
        path += &format!("M{} 0v{height}", short(fraction * width));
    }
    for (fraction, _) in &axes[1].ticks {
        path += &format!("M0 {}h{width}", short((1.0 - fraction) * height));
    }
    format!("<path class=\"grid\" d=\"{path}\"></path>\n")
}

/// Cells of a fill as one path.
fn cells(axes: &[MapAxis; 2], cells: &[MapCell]) -> String {
    let mut paths: BTreeMap<String, String> = BTreeMap::new();
    for cell in cells {
        let area = rectangle(axes, cell.ends).unwrap_or_default();
        *paths.entry(class_of_fill(cell.fill)).or_default() += &area;
    }
    let paths = paths
        .iter()
        .map(|(class, path)| format!("<path class=\"cell {class}\" d=\"{path}\"></path>\n"));
    paths.collect()
}

/// The path around two values to the right and two upwards.
fn rectangle(axes: &[MapAxis; 2], [x, y]: [[f64; 2]; 2]) -> Option<String> {
    let [left, bottom] = place(axes, (x[0], y[0]))?;
    let [right, top] = place(axes, (x[1], y[1]))?;
    let ([left, right], [top, bottom]) = ([left, right].map(short), [top, bottom].map(short));
    Some(format!("M{left} {top}H{right}V{bottom}H{left}z"))
}

/// Symbols of a kind as one path, as large as their mean distance allows.
fn symbols(axes: &[MapAxis; 2], panel: &MapPanel) -> String {
    let distance = (SIZE[0] * SIZE[1] / panel.points.len().max(1) as f64).sqrt();
    let radius = (0.28 * distance).clamp(2.0, 6.0);
    let kinds = Symbol::ALL.map(|symbol| {
        let points = (panel.points.iter()).filter(|point| point.symbol == symbol);
        let path: String = points
            .filter_map(|point| place(axes, point.at))
            .map(|[x, y]| symbol_path(symbol, (x, y), radius))
            .collect();
        if path.is_empty() {
            return path;
        }
        let class = class_of_symbol(symbol);
        format!("<path class=\"symbol {class}\" d=\"{path}\"></path>\n")
    });
    kinds.concat()
}

/// The path of a line.
fn curve(axes: &[MapAxis; 2], line: &Series) -> String {
    let mut path = String::new();
    let mut begins = true;
    for &point in &line.points {
        let Some([x, y]) = place(axes, point) else {
            begins = true;
            continue;
        };
        let command = if begins { 'M' } else { 'L' };
        // A string takes all that is written into it.
        let _ = write!(path, "{command}{} {}", short(x), short(y));
        begins = false;
    }
    path
}
