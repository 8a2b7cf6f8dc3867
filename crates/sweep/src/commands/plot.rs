//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::folder::{hold, refuse_empty, tables_of};
use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::output::{
    Boundary, CaseReader, Cells, Extent, Manifest, PICTURES, ResultTables, write_atomically,
};
use crate::plot::{Axis, Line, MapCell, MapPoint, Mark, Picture, RegimeMap, regime_map};
use crate::spec::{self, MapSettings};

/// More cases than this are drawn by cells.
const MOST_SYMBOLS: usize = 4000;

/// Cells to the right and upwards at most: more would make the picture too large
/// a file where no two neighbours are alike.
const MOST_CELLS: [usize; 2] = [104, 78];

/// Random cases leave hardly a cell empty if it has so many on average.
const CASES_PER_CELL: f64 = 5.0;

/// Symbols drawn over cells, to the right and upwards.
const SYMBOLS_ACROSS: usize = 12;

/// Draws the map again.
pub fn plot(arguments: &PlotArguments) -> Result<Status> {
    let folder = &arguments.folder;
    refuse_empty(folder)?;
    let _lock = hold(folder, "map.svg")?;
    let mut tables = tables_of(folder)?;
    if tables.manifest.tally.rows == 0 {
        bail!(UsageError(format!(
            "{} has no case to draw yet",
            folder.display()
        )));
    }
    let drawn = match tables.so_far {
        None => draw_and_note(folder, &mut tables.manifest)?,
        Some(_) => draw_map(&tables, folder)?,
    };
    if !drawn {
        bail!(UsageError(format!(
            "{} has no map: its sweep varies fewer than two quantities",
            folder.display()
        )));
    }
    say(&format!("{}\n", folder.join("map.png").display()))?;
    Ok(Status::Complete)
}

/// Draws the map of a finished run in a folder that is held, and notes its checksums.
pub fn draw_and_note(folder: &Path, manifest: &mut Manifest) -> Result<bool> {
    let drawn = draw_map(&ResultTables::finished(folder)?, folder)?;
    if drawn && manifest.has_checksums() {
        manifest.note(folder, &PICTURES)?;
        manifest.write(folder)?;
    }
    Ok(drawn)
}

/// Draws `map.svg` and `map.png` of a results folder's tables into a folder; false
/// where its design has no two axes.
pub fn draw_map(tables: &ResultTables, folder: &Path) -> Result<bool> {
    let manifest = &tables.manifest;
    let Some(settings) = &manifest.map else {
        return Ok(false);
    };
    let labels = tables.labels();
    let limit = tables.boundary()?;
    let axes = [settings.x, settings.y];
    let extent = Extent::of(&labels, axes)?;
    let (cells, points) = if is_crowded(&extent) {
        let cells = count_cells(&labels, axes, &extent)?;
        (filled(&cells), sparse_symbols(&cells))
    } else {
        (Vec::new(), symbols(&labels, axes)?)
    };
    let picture = regime_map(&RegimeMap {
        title: match tables.so_far {
            None => manifest.title.clone(),
            Some(so_far) => format!("{} ({so_far})", manifest.title),
        },
        x: axis(&settings.x.title()),
        y: axis(&settings.y.title()),
        cells,
        points,
        legend: legend(manifest, &extent),
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

/// A symbol for every case that tells something.
fn symbols(labels: &Path, axes: [spec::Axis; 2]) -> Result<Vec<MapPoint>> {
    let mut points = Vec::new();
    for case in CaseReader::open(labels, &axes)? {
        let case = case?;
        let [x, y] = [case.values[0], case.values[1]];
        points.extend(case.symbol().map(|symbol| MapPoint { x, y, symbol }));
    }
    Ok(points)
}

/// Of too many cases to see each, those of a cell share what most of them are.
fn count_cells(labels: &Path, axes: [spec::Axis; 2], extent: &Extent) -> Result<Cells> {
    let mut cells = Cells::new(extent, most_cells(extent));
    for case in CaseReader::open(labels, &axes)? {
        let case = case?;
        if let Some(symbol) = case.symbol() {
            cells.add([case.values[0], case.values[1]], symbol);
        }
    }
    Ok(cells)
}

/// As many cells as have some cases each, in the shape of the picture; a grid has a
/// cell for each of its values.
fn most_cells(extent: &Extent) -> [usize; 2] {
    if extent.is_grid() {
        return MOST_CELLS;
    }
    let most = MOST_CELLS.map(|cells| cells as f64);
    let cells = extent.cases as f64 / CASES_PER_CELL;
    let scale = (cells / (most[0] * most[1])).sqrt().min(1.0);
    most.map(|most| (scale * most) as usize)
}

/// Neighbours that are alike as one.
fn filled(cells: &Cells) -> Vec<MapCell> {
    let runs = cells.runs().into_iter();
    runs.map(|(row, [first, end], symbol)| {
        let [left, bottom] = cells.place(first as f64, row as f64);
        let [right, top] = cells.place(end as f64, row as f64 + 1.0);
        MapCell {
            x: [left, right],
            y: [bottom, top],
            symbol,
        }
    })
    .collect()
}

/// A symbol here and there, for who cannot tell the colours.
fn sparse_symbols(cells: &Cells) -> Vec<MapPoint> {
    let [columns, rows] = cells.size();
    let [step_x, step_y] = [columns, rows].map(|cells| cells.div_ceil(SYMBOLS_ACROSS).max(1));
    let places = (step_x / 2..columns).step_by(step_x).flat_map(|column| {
        let rows = (step_y / 2..rows).step_by(step_y);
        rows.map(move |row| (column, row))
    });
    places
        .filter_map(|(column, row)| {
            let [x, y] = cells.place(column as f64 + 0.5, row as f64 + 0.5);
            let symbol = cells.symbol(column, row)?;
            Some(MapPoint { x, y, symbol })
        })
        .collect()
}

fn legend(manifest: &Manifest, extent: &Extent) -> Vec<String> {
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
            "; a cell shows what most of its cases are, {} in all",
            extent.cases
        )
    } else {
        String::new()
    };
    let mut legend = vec![
        format!("{circle}{by_all} ({}){crowd}", names.join(", ")),
        format!("{cross}{by_all}"),
    ];
    // One method cannot differ.
    if names.len() > 1 {
        legend.push("methods differ".to_owned());
    }
    legend
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
