//! How near the cases of each cell are to the recording: a map for each comparison.

use std::path::Path;

use anyhow::Result;

use super::extent::Extent;
use super::mesh::Mesh;
use campaign::words::short;
use plot::{CellFill, Fraction, MapGroup, MapPanel};
use results::folder::{column_words, misfit_columns, read_cases};

/// Cells to the right and upwards at most, and where cases lie anywhere.
const MOST_CELLS: [usize; 2] = [60, 45];

/// A cell shows the best of about this number of random cases.
const CASES_PER_CELL: f64 = 10.0;

/// Classes of a misfit in parts of the least on its map, by their upper ends, the nearest first:
/// beyond the last there is one more.
const ENDS: [f64; 5] = [1.1, 1.25, 1.5, 2.0, 3.0];

/// The maps of what cases were held against; none where they were not.
///
/// # Errors
/// Where labels cannot be read.
pub fn group(labels: &Path, extent: &Extent) -> Result<Option<MapGroup>> {
    let columns = misfit_columns(labels)?;
    if columns.is_empty() {
        return Ok(None);
    }
    let mesh = Mesh::of_cases(extent, MOST_CELLS, CASES_PER_CELL);
    let [across, upwards] = mesh.size();
    let mut least = vec![vec![f64::INFINITY; across * upwards]; columns.len()];
    for case in read_cases(labels, &extent.axes)? {
        let case = case?;
        let cell = mesh.cell_of([case.values[0], case.values[1]]);
        for row in &case.rows {
            for (least, misfit) in least.iter_mut().zip(&row.misfits) {
                least[cell] = misfit.map_or(least[cell], |misfit| misfit.min(least[cell]));
            }
        }
    }
    let panels = columns.iter().zip(&least).map(|(column, least)| {
        let best = least.iter().copied().fold(f64::INFINITY, f64::min);
        let (words, unit) = column_words(column, extent.units);
        MapPanel {
            title: format!(
                "{words}: at best {} {}",
                short(unit.number(best)),
                unit.name
            ),
            cells: mesh.joined(|cell| Some(fill(least[cell], best))),
            ..MapPanel::default()
        }
    });
    let mut keys: Vec<(CellFill, String)> = (0..=ENDS.len())
        .map(|class| (CellFill::Fraction(shade(class)), text(class)))
        .collect();
    keys.push((CellFill::NoCase, "no case".to_owned()));
    Ok(Some(MapGroup {
        heading: "Compared with the recording".to_owned(),
        scale: Some("Least misfit of a cell, relative to the least of all".to_owned()),
        keys,
        notes: Vec::new(),
        panels: panels.collect(),
        ..MapGroup::default()
    }))
}

fn fill(misfit: f64, best: f64) -> CellFill {
    if misfit.is_infinite() {
        return CellFill::NoCase;
    }
    let class = ENDS.iter().filter(|end| misfit > **end * best).count();
    CellFill::Fraction(shade(class))
}

/// The nearest are the darkest.
fn shade(class: usize) -> Fraction {
    Fraction::EVERY[ENDS.len() - class]
}

fn text(class: usize) -> String {
    match class.checked_sub(1).map(|below| ENDS[below]) {
        None => format!("up to {}", ENDS[0]),
        Some(below) => match ENDS.get(class) {
            Some(end) => format!("{below} to {end}"),
            None => format!("over {below}"),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_are_the_darkest() {
        let part = |misfit| fill(misfit, 2.0);
        let [darkest, lightest] = [5, 0].map(|part| CellFill::Fraction(Fraction::EVERY[part]));
        assert_eq!(part(2.0), darkest);
        assert_eq!(part(2.2), darkest);
        assert_eq!(part(2.3), CellFill::Fraction(Fraction::EVERY[4]));
        assert_eq!(part(6.1), lightest);
        assert_eq!(part(f64::INFINITY), CellFill::NoCase);
        let labels: Vec<String> = (0..6).map(text).collect();
        assert_eq!(labels[0], "up to 1.1");
        assert_eq!(labels[5], "over 3");
    }
}
