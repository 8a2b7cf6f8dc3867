//! A map of a traced design: regions up to its limits, and tiles with the fraction of the regime
//! where a limit is no line.

use sim::Motion;
use std::collections::{BTreeMap, BTreeSet};

use super::cells::Cells;
use super::content::{Content, SYMBOLS_ACROSS};
use super::mesh::{Mesh, around};
use results::traced::TracedLimits;

use campaign::sweep_file::Spacing;
use campaign::trace::{Band, Class, Tile};
use plot::{CellFill, Fraction, MapCell, MapPoint, Symbol};

/// Cells of a map to the right and upwards at most.
const MOST_CELLS: [usize; 2] = [400, 400];

/// A traced design on a map, of a number of methods.
pub struct TracedMap<'a> {
    /// What was found.
    pub limits: &'a TracedLimits<'a>,
    /// Number of methods.
    pub methods: usize,
    /// Which of the design's axes is to the right, and which upwards.
    pub places: [usize; 2],
    /// In what the map's axes are even.
    pub spacing: [Spacing; 2],
    /// Cases that were simulated.
    pub simulated: usize,
}

impl TracedMap<'_> {
    /// The map of a motion.
    pub fn content(&self, motion: Motion) -> Content {
        let values = self
            .places
            .map(|place| self.limits.values()[place].to_vec());
        let mut cells = Cells::of(Mesh::around(&values, self.spacing, MOST_CELLS));
        for (_, _, point) in self.points(motion) {
            cells.add(point.at.into(), point.symbol);
        }
        let edges = [0, 1].map(|axis| around(&values[axis], self.spacing[axis]));
        let tiles = self.tiles(motion).into_iter();
        let tiles = tiles.map(|(ends, part)| MapCell {
            ends: [0, 1].map(|axis| ends[self.places[axis]].map(|end| edges[axis][end])),
            fill: CellFill::Fraction(part),
        });
        let mut content = Content::of_cells(&cells, self.simulated);
        content.points = self.symbols(motion);
        let tiles: Vec<MapCell> = tiles.collect();
        if !tiles.is_empty() {
            // One scale for regions and tiles, which needs no symbols.
            content.points.clear();
            let fills = content.cells.iter_mut().map(|cell| &mut cell.fill);
            fills.for_each(|fill| *fill = as_part(*fill));
            content.cells.extend(tiles);
        }
        content
    }

    /// All points of the map that every method has answered: their place along the design's axes, that
    /// on the map, and their symbol.
    fn points(&self, motion: Motion) -> impl Iterator<Item = ([usize; 2], [usize; 2], MapPoint)> {
        let [x, y] = self.places.map(|place| self.limits.values()[place]);
        let all = (0..x.len()).flat_map(|right| (0..y.len()).map(move |up| [right, up]));
        all.filter_map(move |on_map| {
            let mut place = [0; 2];
            place[self.places[0]] = on_map[0];
            place[self.places[1]] = on_map[1];
            let symbol = self.symbol(motion, place)?;
            let at = (x[on_map[0]], y[on_map[1]]);
            Some((place, on_map, MapPoint { at, symbol }))
        })
    }

    /// The symbols of some simulated cases, evenly over the map, for readers without colours: points
    /// between them have none.
    fn symbols(&self, motion: Motion) -> Vec<MapPoint> {
        let counts = self.places.map(|place| self.limits.values()[place].len());
        // By part of the map: how far from its middle the nearest case is, and that.
        let mut nearest: BTreeMap<[usize; 2], (f64, MapPoint)> = BTreeMap::new();
        let points = self.points(motion);
        for (_, on_map, point) in points.filter(|(place, ..)| self.limits.was_simulated(*place)) {
            let parts = [0, 1].map(|axis| {
                (on_map[axis] as f64 + 0.5) / counts[axis] as f64 * SYMBOLS_ACROSS as f64
            });
            let off: f64 = parts.iter().map(|part| (part.fract() - 0.5).powi(2)).sum();
            let known = (nearest.entry(parts.map(|part| part as usize))).or_insert((off, point));
            if off < known.0 {
                *known = (off, point);
            }
        }
        nearest.into_values().map(|(_, point)| point).collect()
    }

    /// As of a case that every method has answered; none where one does not tell.
    fn symbol(&self, motion: Motion, place: [usize; 2]) -> Option<Symbol> {
        let classes = (0..self.methods).map(|method| self.limits.class(method, motion, place));
        let mut with = 0;
        for class in classes {
            match class {
                Class::With => with += 1,
                Class::Without => {}
                Class::Undetermined | Class::Unknown => return None,
            }
        }
        Some(Symbol::of_methods([with, 0, 0], self.methods))
    }

    /// The tiles of any method, by their ends along the design's axes, each with the mean
    /// over the methods; of tiles within one another the larger one.
    fn tiles(&self, motion: Motion) -> Vec<([[usize; 2]; 2], Fraction)> {
        let methods = 0..self.methods;
        let bands = methods
            .clone()
            .flat_map(|method| self.limits.bands(method, motion));
        let tiles: BTreeSet<Tile> = bands.map(|band| band.tile).collect();
        let is_within = |tile: &Tile| tiles.iter().any(|other| other != tile && other.holds(tile));
        let of_tile = |tile: Tile| {
            let bands = methods
                .clone()
                .map(|method| self.limits.band_of(method, motion, tile));
            let answered: Vec<Band> = bands.filter(|band| band.classified > 0).collect();
            let parts = answered
                .iter()
                .map(|band| band.with as f64 / band.classified as f64);
            let mean = parts.sum::<f64>() / answered.len() as f64;
            (!answered.is_empty()).then(|| (tile.ends(), Fraction::of(mean)))
        };
        let widest = tiles.iter().filter(|tile| !is_within(tile));
        widest.copied().filter_map(of_tile).collect()
    }
}

/// Regions where all methods agree are all or none of the cases.
fn as_part(fill: CellFill) -> CellFill {
    match fill {
        CellFill::Symbol(
            Symbol::Circle | Symbol::Disc | Symbol::Diamond | Symbol::FilledDiamond,
        ) => CellFill::Fraction(Fraction::of(1.0)),
        CellFill::Symbol(Symbol::Cross | Symbol::HeavyCross | Symbol::Triangle) => {
            CellFill::Fraction(Fraction::of(0.0))
        }
        CellFill::Symbol(Symbol::Square)
        | CellFill::Fraction(_)
        | CellFill::Safety(_)
        | CellFill::NoCase => fill,
    }
}
