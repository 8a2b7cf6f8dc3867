//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::output::{
    Boundary, CaseReader, Cells, Extent, Manifest, read_boundary, write_atomically,
};
use crate::plot::{Axis, Line, MapPoint, Mark, Picture, RegimeMap, regime_map};
use crate::spec::{self, MapSettings};

/// More cases than this are drawn by cells.
const MOST_SYMBOLS: usize = 4000;

/// Cells to the right and upwards at most.
const MOST_CELLS: [usize; 2] = [72, 54];

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
    let labels = folder.join("labels.csv");
    let limit = read_boundary(&folder.join("boundary.csv"))?;
    let axes = [settings.x, settings.y];
    let extent = Extent::of(&labels, axes)?;
    let picture = regime_map(&RegimeMap {
        title: manifest.title.clone(),
        x: axis(&settings.x.title()),
        y: axis(&settings.y.title()),
        points: points(&labels, axes, &extent)?,
        legend: legend(&manifest, &extent),
        lines: lines(&limit, settings, &extent),
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

/// Whether there are too many cases to see each.
fn is_crowded(extent: &Extent) -> bool {
    extent.cases > MOST_SYMBOLS
}

/// A symbol for every case that tells something; where there are too many to see,
/// those of a cell share the symbol that most of them have.
fn points(labels: &Path, axes: [spec::Axis; 2], extent: &Extent) -> Result<Vec<MapPoint>> {
    let mut points = Vec::new();
    let mut cells = Cells::new(extent, MOST_CELLS);
    for case in CaseReader::open(labels, &axes)? {
        let case = case?;
        let Some(symbol) = case.symbol() else {
            continue;
        };
        let [x, y] = [case.values[0], case.values[1]];
        if is_crowded(extent) {
            cells.add([x, y], symbol);
        } else {
            points.push(MapPoint { x, y, symbol });
        }
    }
    let [columns, rows] = cells.size();
    for (column, row) in (0..columns).flat_map(|column| (0..rows).map(move |row| (column, row))) {
        let [x, y] = cells.middle(column, row);
        let symbol = cells.symbol(column, row);
        points.extend(symbol.map(|symbol| MapPoint { x, y, symbol }));
    }
    Ok(points)
}

fn legend(manifest: &Manifest, extent: &Extent) -> [String; 3] {
    let (circle, cross) = if extent.is_lateral {
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
    let crowd = if is_crowded(extent) {
        format!(
            "; a symbol for most of its cell, {} cases in all",
            extent.cases
        )
    } else {
        String::new()
    };
    [
        format!("{circle}{by_all} ({}){crowd}", names.join(", ")),
        format!("{cross}{by_all}"),
        "methods differ".to_owned(),
    ]
}

/// The limit as lines of the map; one that does not depend on an axis crosses
/// the whole of it.
fn lines(limit: &Boundary, settings: &MapSettings, extent: &Extent) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for (name, point) in limit.lines(settings.x, settings.y) {
        let points = match point {
            (Some(x), Some(y)) => vec![(x, y)],
            (None, Some(y)) => extent.x.map(|x| (x, y)).to_vec(),
            (Some(x), None) => extent.y.map(|y| (x, y)).to_vec(),
            (None, None) => continue,
        };
        match lines.last_mut() {
            Some(line) if line.name == name => line.points.extend(points),
            _ => lines.push(Line { name, points }),
        }
    }
    lines
}
