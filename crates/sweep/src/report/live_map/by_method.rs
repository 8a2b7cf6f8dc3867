//! The maps of each method, side by side with one scale.

use anyhow::Result;
use sim::Motion;

use crate::map::{Extent, Fractions, MapDrawing};
use campaign::quantities::Unit;
use plot::{CellFill, Fraction, LineStyle, MapCell, MapGroup, MapPanel, Series};
use results::folder::{ResultTables, read_cases};

/// A group for each motion; none where there is one method, or maps are of single values of
/// further axes.
///
/// # Errors
/// Where the labels cannot be read.
pub fn groups(tables: &ResultTables, drawing: &MapDrawing) -> Result<Vec<MapGroup>> {
    let manifest = &tables.manifest;
    let methods = manifest.method_names();
    if methods.len() < 2 || drawing.combinations.len() > 1 || manifest.trace.is_some() {
        return Ok(Vec::new());
    }
    let labels = tables.folder.join("labels.csv");
    let extent = Extent::of(&labels, drawing.axes, Vec::new(), &manifest.sweep)?;
    let mut counts: Vec<Vec<Fractions>> = (drawing.motions.iter())
        .map(|_| methods.iter().map(|_| Fractions::new(&extent)).collect())
        .collect();
    for case in read_cases(&labels, &drawing.axes)? {
        let case = case?;
        let place = [case.values[0], case.values[1]];
        for (motion, counts) in drawing.motions.iter().zip(&mut counts) {
            for row in &case.rows {
                let method = methods.iter().position(|method| *method == row.method);
                let decided = row.labels.is_sustained(*motion);
                if let Some((method, is_sustained)) = method.zip(decided) {
                    counts[method].add(place, [usize::from(is_sustained), 1]);
                }
            }
        }
    }
    let units = drawing.axes.map(|axis| axis.unit(manifest.sweep.units));
    let motions = drawing.motions.iter().zip(counts).enumerate();
    let groups = motions.map(|(index, (motion, counts))| {
        let lines = &drawing.chart.groups[index].panels[0].lines;
        let panels = methods.iter().zip(counts).map(|(method, counts)| MapPanel {
            title: (*method).to_owned(),
            cells: shown(counts.joined(), &units),
            lines: own_lines(lines, method, &methods),
            ..MapPanel::default()
        });
        group(*motion, panels.collect(), drawing)
    });
    Ok(groups.collect())
}

/// Cells in the units of the axes, as the lines of the drawing are.
fn shown(mut cells: Vec<MapCell>, units: &[Unit; 2]) -> Vec<MapCell> {
    for cell in &mut cells {
        for (ends, unit) in cell.ends.iter_mut().zip(units) {
            *ends = ends.map(|end| unit.number(end));
        }
    }
    cells
}

/// Maps with the keys of the fills that are on them.
fn group(motion: Motion, panels: Vec<MapPanel>, drawing: &MapDrawing) -> MapGroup {
    let [regime, none] = motion.regimes();
    let has = |fill: CellFill| {
        let cells = |panel: &MapPanel| panel.cells.iter().any(|cell: &MapCell| cell.fill == fill);
        panels.iter().any(cells)
    };
    let classes = Fraction::EVERY.into_iter().rev();
    let keys = classes.map(|class| (CellFill::Fraction(class), class));
    let keys: Vec<(CellFill, String)> = keys
        .filter(|(fill, _)| has(*fill))
        .map(|(fill, class)| match class {
            all if all == Fraction::of(1.0) => (fill, regime.to_owned()),
            nothing if nothing == Fraction::of(0.0) => (fill, none.to_owned()),
            part => (fill, format!("{regime} in {}", part.text())),
        })
        .chain(has(CellFill::NoCase).then(|| {
            let text = "no case, or undetermined".to_owned();
            (CellFill::NoCase, text)
        }))
        .collect();
    let heading = match drawing.motions.len() {
        1 => "Each method by itself".to_owned(),
        _ => format!("{}: each method by itself", motion.title()),
    };
    MapGroup {
        heading,
        keys,
        panels,
        ..MapGroup::default()
    }
}

/// The limits of a method, and those that are of none.
fn own_lines(lines: &[Series], method: &str, methods: &[&str]) -> Vec<Series> {
    let is_of = |line: &Series, method: &str| line.name.ends_with(&format!(", {method}"));
    let is_own =
        |line: &&Series| is_of(line, method) || !methods.iter().any(|other| is_of(line, other));
    let own = lines.iter().filter(is_own).map(|line| Series {
        name: (line.name.strip_suffix(&format!(", {method}")))
            .unwrap_or(&line.name)
            .to_owned(),
        style: LineStyle::default(),
        points: line.points.clone(),
    });
    own.collect()
}
