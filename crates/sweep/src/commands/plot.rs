//! `sweep plot`: the regime map of a results folder.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Result, bail};

use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::output::{Boundary, LabelRow, Manifest, read_boundary, read_labels, write_atomically};
use crate::plot::{Axis, Line, MapPoint, Mark, Picture, RegimeMap, Symbol, regime_map};
use crate::spec::MapSettings;

/// The regimes that circles stand for: sustained vibration.
const SUSTAINED: [&str; 3] = ["stick_slip", "backward_whirl", "forward_whirl"];

/// Draws the map again.
pub fn plot(arguments: &PlotArguments) -> Result<Status> {
    if !draw_map(&arguments.folder)? {
        bail!(UsageError(format!(
            "{} has no map: its sweep varies fewer than two quantities",
            arguments.folder.display()
        )));
    }
    say(&format!("{}\n", arguments.folder.join("map.png").display()))?;
    Ok(Status::Complete)
}

/// Draws `map.svg` and `map.png` from the files of a results folder; false
/// where its design has no two axes.
pub fn draw_map(folder: &Path) -> Result<bool> {
    let manifest = Manifest::read(folder)?;
    let Some(settings) = &manifest.map else {
        return Ok(false);
    };
    let rows = read_labels(&folder.join("labels.csv"), &[settings.x, settings.y])?;
    let limit = read_boundary(&folder.join("boundary.csv"))?;
    let picture = regime_map(&RegimeMap {
        title: manifest.title.clone(),
        x: axis(settings.x.title()),
        y: axis(settings.y.title()),
        points: points(&rows),
        legend: legend(&manifest, &rows),
        lines: lines(&limit, settings, &rows),
        marks: settings
            .marks
            .iter()
            .map(|mark| Mark {
                name: mark.name.clone(),
                x: mark.x,
                y: mark.y,
            })
            .collect(),
    })?;
    save_picture(folder, "map", &picture)?;
    Ok(true)
}

/// Writes a picture in both formats.
pub fn save_picture(folder: &Path, name: &str, picture: &Picture) -> Result<()> {
    write_atomically(&folder.join(format!("{name}.svg")), picture.svg.as_bytes())?;
    write_atomically(&folder.join(format!("{name}.png")), &picture.png)
}

/// A linear axis.
pub fn axis(label: &str) -> Axis {
    Axis {
        label: label.to_owned(),
        logarithmic: false,
    }
}

/// What the map is about: the lateral label where there is one.
fn label(row: &LabelRow) -> &str {
    if row.lateral.is_empty() {
        &row.torsion
    } else {
        &row.lateral
    }
}

/// The paper's symbols: a circle where every method finds sustained vibration,
/// a cross where none does, a square where they differ. Cases without an answer
/// by some method are left out.
fn points(rows: &[LabelRow]) -> Vec<MapPoint> {
    let mut cases: BTreeMap<usize, Vec<&LabelRow>> = BTreeMap::new();
    for row in rows {
        cases.entry(row.case).or_default().push(row);
    }
    cases
        .values()
        .filter(|rows| rows.iter().all(|row| !label(row).is_empty()))
        .map(|rows| {
            let finds = rows
                .iter()
                .filter(|row| SUSTAINED.contains(&label(row)))
                .count();
            MapPoint {
                x: rows[0].values[0],
                y: rows[0].values[1],
                symbol: if finds == rows.len() {
                    Symbol::Circle
                } else if finds == 0 {
                    Symbol::Cross
                } else {
                    Symbol::Square
                },
            }
        })
        .collect()
}

fn legend(manifest: &Manifest, rows: &[LabelRow]) -> [String; 3] {
    let is_lateral = rows.iter().any(|row| !row.lateral.is_empty());
    let (circle, cross) = if is_lateral {
        ("sustained whirl", "no sustained whirl")
    } else {
        ("stick-slip", "smooth")
    };
    let names: Vec<&str> = manifest
        .methods
        .iter()
        .map(|method| method.method.as_str())
        .collect();
    let by_all = if names.len() == 1 {
        String::new()
    } else {
        " by all methods".to_owned()
    };
    [
        format!("{circle}{by_all} ({})", names.join(", ")),
        format!("{cross}{by_all}"),
        "methods differ".to_owned(),
    ]
}

/// The limit as lines of the map; one that does not depend on an axis crosses
/// the whole of it.
fn lines(limit: &Boundary, settings: &MapSettings, rows: &[LabelRow]) -> Vec<Line> {
    let range = |axis: usize| {
        let values = rows.iter().map(|row| row.values[axis]);
        values.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], value| {
            [from.min(value), to.max(value)]
        })
    };
    let mut lines: Vec<Line> = Vec::new();
    for (name, point) in limit.lines(settings.x, settings.y) {
        let points = match point {
            (Some(x), Some(y)) => vec![(x, y)],
            (None, Some(y)) => range(0).map(|x| (x, y)).to_vec(),
            (Some(x), None) => range(1).map(|y| (x, y)).to_vec(),
            (None, None) => continue,
        };
        match lines.last_mut() {
            Some(line) if line.name == name => line.points.extend(points),
            _ => lines.push(Line { name, points }),
        }
    }
    lines
}
