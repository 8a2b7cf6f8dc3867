//! How the cases of one map are drawn: as symbols, as cells of what most of them are, or as cells
//! of the fraction with the regime.

use sim::Motion;
use std::path::Path;

use anyhow::Result;

use super::cells::Cells;
use super::extent::Extent;
use super::fractions::Fractions;
use super::symbol::drawn_symbol_of;
use plot::{CellFill, MapCell, MapPoint, Symbol};
use results::folder::{CaseRows, read_cases};

/// Where a chart would have more symbols than this, cells are drawn.
const MOST_SYMBOLS: usize = 4000;

/// Cells to the right and upwards at most, on the one map of a chart: more would make
/// the picture too large a file where no two neighbours are alike.
const MOST_CELLS: [usize; 2] = [104, 78];

/// With this many random cases per cell on average, hardly any is empty.
const CASES_PER_CELL: f64 = 5.0;

/// Symbols drawn over cells, to the right and upwards.
pub const SYMBOLS_ACROSS: usize = 12;

/// The cases of one map.
#[derive(Default)]
pub struct Content {
    /// Its cells; neighbours that are alike are one.
    pub cells: Vec<MapCell>,
    /// Its symbols.
    pub points: Vec<MapPoint>,
    /// Cases without a label of the motion, or whose label is undetermined.
    pub undetermined: usize,
    /// Cases.
    pub cases: usize,
    counted: Counted,
}

/// Cases that become cells when all are counted.
#[derive(Default)]
enum Counted {
    #[default]
    None,
    Crowd(Cells),
    Parts(Fractions),
}

impl Content {
    /// The cases of a `labels.csv` on all maps of a motion.
    ///
    /// # Errors
    /// Where labels cannot be read.
    pub fn read(labels: &Path, extent: &Extent, motion: Motion) -> Result<Vec<Content>> {
        let combinations = extent.combinations();
        let count = combinations.map_or(1, |combinations| combinations.len().max(1));
        let empty = || Content {
            counted: match combinations {
                None => Counted::Parts(Fractions::new(extent)),
                Some(_) if extent.has_starts => Counted::Parts(Fractions::new(extent)),
                Some(_) => Counted::of_cases(extent, count),
            },
            ..Content::default()
        };
        let mut contents: Vec<Content> = (0..count).map(|_| empty()).collect();
        let axes: Vec<_> = extent.axes.iter().chain(&extent.others).copied().collect();
        for case in read_cases(labels, &axes)? {
            let case = case?;
            let of_case = |combinations: &[Vec<f64>]| {
                let values = &case.values[2..];
                combinations.iter().position(|other| other == values)
            };
            let index = combinations.and_then(of_case).unwrap_or(0);
            contents[index].add(&case, motion);
        }
        contents.iter_mut().for_each(Content::finish);
        Ok(contents)
    }

    /// What counted cells show, of a number of cases.
    pub fn of_cells(cells: &Cells, cases: usize) -> Self {
        Self {
            cells: cells.joined(),
            points: sparse_symbols(cells),
            cases,
            ..Self::default()
        }
    }

    /// Whether a symbol, or its fill, is anywhere on the map.
    pub fn has(&self, symbol: Symbol) -> bool {
        self.points.iter().any(|point| point.symbol == symbol)
            || self.has_fill(|fill| fill == CellFill::Symbol(symbol))
    }

    /// Whether a cell has a fill of some kind.
    pub fn has_fill(&self, is_of_kind: impl Fn(CellFill) -> bool) -> bool {
        self.cells.iter().any(|cell| is_of_kind(cell.fill))
    }

    /// Whether its cells show the fraction of the cases with the regime.
    pub fn is_of_parts(&self) -> bool {
        self.has_fill(|fill| !matches!(fill, CellFill::Symbol(_)))
    }

    fn add(&mut self, case: &CaseRows, motion: Motion) {
        self.cases += 1;
        let place @ [x, y] = [case.values[0], case.values[1]];
        let symbol = drawn_symbol_of(case, motion);
        let is_classified = match &mut self.counted {
            Counted::Parts(fractions) => {
                let rows = case.rows.iter();
                let classified = rows.filter_map(|row| row.labels.is_sustained(motion));
                let classified: Vec<bool> = classified.collect();
                let sustained = classified.iter().filter(|sustained| **sustained).count();
                fractions.add(place, [sustained, classified.len()]);
                !classified.is_empty()
            }
            Counted::Crowd(cells) => symbol.inspect(|symbol| cells.add(place, *symbol)).is_some(),
            Counted::None => {
                let point = symbol.map(|symbol| MapPoint { at: (x, y), symbol });
                self.points.extend(point);
                symbol.is_some()
            }
        };
        self.undetermined += usize::from(!is_classified);
    }

    /// Makes cells, and symbols on them, of what was counted.
    fn finish(&mut self) {
        match &self.counted {
            Counted::None => {}
            Counted::Crowd(cells) => {
                self.cells = cells.joined();
                self.points = sparse_symbols(cells);
            }
            Counted::Parts(fractions) => self.cells = fractions.joined(),
        }
    }
}

impl Counted {
    /// Of the cases of one of `count` maps of a motion, before there are any.
    fn of_cases(extent: &Extent, count: usize) -> Self {
        let motions = extent.motions.len();
        if extent.cases * motions > MOST_SYMBOLS {
            Counted::Crowd(Cells::new(extent, most_cells(extent, count, motions)))
        } else {
            Counted::None
        }
    }
}

/// As many cells as have some cases each, in the shape of the picture; a grid has cells of
/// its values. The maps of a chart have no more than one alone.
fn most_cells(extent: &Extent, count: usize, motions: usize) -> [usize; 2] {
    let share = ((count * motions) as f64).sqrt();
    let most = MOST_CELLS.map(|cells| cells as f64 / share);
    if extent.is_grid() {
        return most.map(|most| most as usize);
    }
    let cells = (extent.cases / count) as f64 / CASES_PER_CELL;
    let scale = (cells / (most[0] * most[1])).sqrt().min(1.0);
    most.map(|most| (scale * most) as usize)
}

/// A symbol in some of the cells, for readers who cannot tell the colours apart.
fn sparse_symbols(cells: &Cells) -> Vec<MapPoint> {
    let [columns, rows] = cells.size();
    let [step_x, step_y] = [columns, rows].map(|cells| cells.div_ceil(SYMBOLS_ACROSS).max(1));
    let places = (step_x / 2..columns).step_by(step_x).flat_map(|column| {
        let rows = (step_y / 2..rows).step_by(step_y);
        rows.map(move |row| (column, row))
    });
    places
        .filter_map(|(column, row)| {
            let symbol = cells.symbol(column, row)?;
            let at = cells.centre(column, row);
            Some(MapPoint { at, symbol })
        })
        .collect()
}
