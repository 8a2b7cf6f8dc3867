//! `sweep plot`: the regime map of a results folder.

use std::path::Path;

use anyhow::{Result, bail};

use super::{Status, UsageError, say};
use crate::cli::PlotArguments;
use crate::output::{Boundary, Manifest, read_boundary, stream_labels, write_atomically};
use crate::plot::{Axis, Line, MapPoint, Mark, Picture, RegimeMap, Symbol, regime_map};
use crate::spec::MapSettings;

/// The regimes that circles stand for: sustained vibration.
const SUSTAINED: [&str; 3] = ["stick_slip", "backward_whirl", "forward_whirl"];

/// The label of a case that was too short to tell; it is not drawn.
const UNDETERMINED: &str = "stuck";

/// More cases than this are drawn by cells.
const MOST_SYMBOLS: usize = 4000;

/// Cells to the right and upwards.
const CELLS: [usize; 2] = [72, 54];

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
    let extent = MapExtent::of(&labels, settings)?;
    let picture = regime_map(&RegimeMap {
        title: manifest.title.clone(),
        x: axis(&settings.x.title()),
        y: axis(&settings.y.title()),
        points: points(&labels, settings, &extent)?,
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

/// What a map spans.
struct MapExtent {
    x: [f64; 2],
    y: [f64; 2],
    cases: usize,
    is_lateral: bool,
}

impl MapExtent {
    fn of(labels: &Path, settings: &MapSettings) -> Result<Self> {
        let empty = [f64::INFINITY, f64::NEG_INFINITY];
        let mut extent = Self {
            x: empty,
            y: empty,
            cases: 0,
            is_lateral: false,
        };
        for_each_case(labels, [settings.x, settings.y], |case| {
            let widen = |[from, to]: [f64; 2], value: f64| [from.min(value), to.max(value)];
            extent.x = widen(extent.x, case.values[0]);
            extent.y = widen(extent.y, case.values[1]);
            extent.cases += 1;
            extent.is_lateral |= case.is_lateral;
        })?;
        Ok(extent)
    }

    fn is_crowded(&self) -> bool {
        self.cases > MOST_SYMBOLS
    }
}

/// The paper's symbols: a circle where every method finds sustained vibration,
/// a cross where none does, a square where they differ. Cases without an answer
/// by some method, or with one that tells nothing, are left out. Where there are too many cases to see, those of a
/// cell share the symbol that most of them have.
fn points(labels: &Path, settings: &MapSettings, extent: &MapExtent) -> Result<Vec<MapPoint>> {
    let mut points = Vec::new();
    let mut cells = vec![[0usize; 3]; CELLS[0] * CELLS[1]];
    let place = |[from, to]: [f64; 2], value: f64, cells: usize| {
        let fraction = (value - from) / (to - from).max(f64::MIN_POSITIVE);
        ((fraction * cells as f64) as usize).min(cells - 1)
    };
    for_each_case(labels, [settings.x, settings.y], |case| {
        let Some(symbol) = case.symbol() else { return };
        let [x, y] = case.values;
        if extent.is_crowded() {
            let cell = [place(extent.x, x, CELLS[0]), place(extent.y, y, CELLS[1])];
            cells[cell[0] * CELLS[1] + cell[1]][symbol as usize] += 1;
        } else {
            points.push(MapPoint { x, y, symbol });
        }
    })?;
    let middle = |[from, to]: [f64; 2], index: usize, cells: usize| {
        from + (to - from) * (index as f64 + 0.5) / cells as f64
    };
    for (index, counts) in cells.iter().enumerate() {
        let symbols = [Symbol::Circle, Symbol::Cross, Symbol::Square];
        let most = symbols
            .into_iter()
            .max_by_key(|&symbol| counts[symbol as usize]);
        points.extend(
            most.filter(|&most| counts[most as usize] > 0)
                .map(|symbol| MapPoint {
                    x: middle(extent.x, index / CELLS[1], CELLS[0]),
                    y: middle(extent.y, index % CELLS[1], CELLS[1]),
                    symbol,
                }),
        );
    }
    Ok(points)
}

fn legend(manifest: &Manifest, extent: &MapExtent) -> Vec<String> {
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
    let crowd = if extent.is_crowded() {
        format!(
            "; a symbol for most of its cell, {} cases in all",
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

/// The rows of one case, as the map needs them.
struct MapCase {
    values: [f64; 2],
    is_lateral: bool,
    rows: usize,
    answered: usize,
    sustained: usize,
}

impl MapCase {
    fn symbol(&self) -> Option<Symbol> {
        if self.answered < self.rows {
            None
        } else if self.sustained == self.rows {
            Some(Symbol::Circle)
        } else if self.sustained == 0 {
            Some(Symbol::Cross)
        } else {
            Some(Symbol::Square)
        }
    }
}

/// Gives every case of `labels.csv` to `each`; only one is in memory at a time.
fn for_each_case(
    labels: &Path,
    axes: [crate::spec::Axis; 2],
    mut each: impl FnMut(&MapCase),
) -> Result<()> {
    let mut last: Option<(usize, MapCase)> = None;
    stream_labels(labels, &axes, |row| {
        // What the map is about: the lateral label where there is one.
        let label = if row.lateral.is_empty() {
            &row.torsion
        } else {
            &row.lateral
        };
        if last.as_ref().is_none_or(|(case, _)| *case != row.case) {
            let next = MapCase {
                values: [row.values[0], row.values[1]],
                is_lateral: false,
                rows: 0,
                answered: 0,
                sustained: 0,
            };
            if let Some((_, whole)) = last.replace((row.case, next)) {
                each(&whole);
            }
        }
        if let Some((_, case)) = &mut last {
            case.rows += 1;
            case.is_lateral |= !row.lateral.is_empty();
            case.answered += usize::from(!label.is_empty() && label != UNDETERMINED);
            case.sustained += usize::from(SUSTAINED.contains(&label.as_str()));
        }
    })?;
    if let Some((_, whole)) = last {
        each(&whole);
    }
    Ok(())
}

/// The limit as lines of the map; one that does not depend on an axis crosses
/// the whole of it.
fn lines(limit: &Boundary, settings: &MapSettings, extent: &MapExtent) -> Vec<Line> {
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
