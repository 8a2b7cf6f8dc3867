//! A measure as the colour of a map, by each method, with the regimes as outlines.

use std::path::Path;

use anyhow::Result;

use super::extent::Extent;
use super::mesh::Mesh;
use super::scale::Classes;
use campaign::records::Measure;
use plot::{CellFill, LineStyle, MapGroup, MapPanel, Series};
use results::folder::{Manifest, label_rows};

/// Cells to the right and upwards at most.
const MOST_CELLS: [usize; 2] = [130, 100];

/// Cases that share a cell, on average, where they lie anywhere.
const CASES_PER_CELL: f64 = 2.0;

/// The maps of a measure, one for each method.
///
/// # Errors
/// Where labels cannot be read.
pub fn group(
    labels: &Path,
    extent: &Extent,
    manifest: &Manifest,
    measure: Measure,
) -> Result<MapGroup> {
    let mesh = if manifest.is_trace() {
        Mesh::around(&extent.values, extent.spacing, MOST_CELLS)
    } else {
        Mesh::of_cases(extent, MOST_CELLS, CASES_PER_CELL)
    };
    let methods = manifest.method_names();
    let motion = measure.motion().unwrap_or(extent.motions[0]);
    let [columns, rows] = mesh.size();
    let mut fields: Vec<Field> = (methods.iter())
        .map(|_| Field::empty(columns * rows))
        .collect();
    let mut unmeasured = 0;
    for row in label_rows(labels, &extent.axes, &[measure])? {
        let row = row?;
        let value = row.measures[0];
        let cell = mesh.cell_of([row.values[0], row.values[1]]);
        let place = methods.iter().position(|method| *method == row.method);
        let Some(field) = place.and_then(|place| fields.get_mut(place)) else {
            continue;
        };
        field.add(cell, value, row.labels.is_sustained(motion));
        unmeasured += usize::from(value.is_none());
    }
    if manifest.is_trace() {
        fields
            .iter_mut()
            .for_each(|field| field.spread([columns, rows]));
    }
    let unit = measure.unit(extent.units);
    let means = fields.iter().flat_map(|field| field.means());
    let classes = Classes::of(means.map(|mean| unit.number(mean)).collect());
    let name = format!("limit of {}", motion.regimes()[0]);
    let panels = methods.iter().zip(&fields).map(|(method, field)| MapPanel {
        title: (*method).to_owned(),
        cells: mesh.joined(|cell| {
            Some(match field.mean(cell) {
                Some(mean) => CellFill::Fraction(classes.shade(unit.number(mean))),
                None => CellFill::NoCase,
            })
        }),
        lines: vec![Series {
            name: name.clone(),
            style: LineStyle::default(),
            points: mesh.outlines(|cell| field.is_sustained(cell)),
        }],
        ..MapPanel::default()
    });
    let mut keys: Vec<(CellFill, String)> = (classes.words().into_iter())
        .map(|(shade, words)| (CellFill::Fraction(shade), words))
        .collect();
    keys.reverse();
    if fields.iter().any(|field| field.lacks_any()) {
        keys.push((CellFill::NoCase, "no case, or none of it".to_owned()));
    }
    let in_unit = match unit.name.as_str() {
        "" => String::new(),
        name => format!(" ({name})"),
    };
    let note = format!("not measured in {unmeasured} simulations");
    Ok(MapGroup {
        heading: format!("{}{in_unit}", measure.words()),
        scale: Some(about(manifest, extent)),
        keys,
        notes: (unmeasured > 0).then_some(note).into_iter().collect(),
        panels: panels.collect(),
        ..MapGroup::default()
    })
}

/// What a cell shows.
fn about(manifest: &Manifest, extent: &Extent) -> String {
    let over = if extent.others.is_empty() {
        ""
    } else {
        ", over all other axes"
    };
    let others = if manifest.is_trace() {
        "; of cells without a case, that of the nearest"
    } else {
        ""
    };
    format!("Mean of a cell{over}{others}")
}

/// What a method has in each cell.
struct Field {
    /// Sum and number of the values of a measure.
    values: Vec<(f64, usize)>,
    /// Simulations with and without sustained vibration.
    regimes: Vec<[usize; 2]>,
}

impl Field {
    fn empty(cells: usize) -> Self {
        Self {
            values: vec![(0.0, 0); cells],
            regimes: vec![[0; 2]; cells],
        }
    }

    fn add(&mut self, cell: usize, value: Option<f64>, is_sustained: Option<bool>) {
        if let Some(value) = value {
            let (sum, count) = &mut self.values[cell];
            *sum += value;
            *count += 1;
        }
        if let Some(is_sustained) = is_sustained {
            self.regimes[cell][usize::from(!is_sustained)] += 1;
        }
    }

    fn mean(&self, cell: usize) -> Option<f64> {
        let (sum, count) = self.values[cell];
        (count > 0).then(|| sum / count as f64)
    }

    fn means(&self) -> impl Iterator<Item = f64> {
        (0..self.values.len()).filter_map(|cell| self.mean(cell))
    }

    fn lacks_any(&self) -> bool {
        self.values.iter().any(|(_, count)| *count == 0)
    }

    /// What most simulations of a cell are.
    fn is_sustained(&self, cell: usize) -> Option<bool> {
        let [with, without] = self.regimes[cell];
        (with + without > 0).then_some(with >= without)
    }

    /// Cells without a case are as the nearest with one, step by step along both axes.
    fn spread(&mut self, [columns, rows]: [usize; 2]) {
        let has_case = |field: &Self, cell: usize| field.regimes[cell] != [0; 2];
        let mut edge: Vec<usize> = (0..columns * rows)
            .filter(|cell| has_case(self, *cell))
            .collect();
        while !edge.is_empty() {
            let mut next = Vec::new();
            for cell in edge {
                let (column, row) = (cell / rows, cell % rows);
                let around = [
                    (column > 0).then(|| cell - rows),
                    (column + 1 < columns).then(|| cell + rows),
                    (row > 0).then(|| cell - 1),
                    (row + 1 < rows).then(|| cell + 1),
                ];
                for other in around.into_iter().flatten() {
                    if !has_case(self, other) {
                        self.values[other] = self.values[cell];
                        self.regimes[other] = self.regimes[cell];
                        next.push(other);
                    }
                }
            }
            edge = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_shows_the_mean_and_an_empty_one_the_nearest() {
        let mut field = Field::empty(6);
        field.add(0, Some(1.0), Some(true));
        field.add(0, Some(3.0), Some(true));
        field.add(0, None, Some(false));
        field.add(5, Some(9.0), Some(false));
        assert_eq!(field.mean(0), Some(2.0));
        assert_eq!(field.is_sustained(0), Some(true));
        assert!(field.lacks_any());
        // Three columns of two.
        field.spread([3, 2]);
        let means: Vec<_> = field.means().collect();
        assert_eq!(means, [2.0, 2.0, 2.0, 9.0, 9.0, 9.0]);
    }
}
