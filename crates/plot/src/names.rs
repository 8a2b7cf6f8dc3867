//! Names inside a plotting area.

use super::canvas::Canvas;
use super::colours::WHITE;
use super::geometry::{Pixel, Rect};
use super::lettering::Align;
use super::text::{Block, SMALL_SIZE};

/// Opacity of the fill that keeps a name legible above data.
const GROUND: f64 = 0.8;

/// Names inside a plotting area that overlap neither one another nor, where possible,
/// the data.
pub(crate) struct Names {
    within: Rect,
    taken: Vec<Rect>,
    data: Vec<Vec<Pixel>>,
}

impl Names {
    /// Names inside `within`, off rectangles that are `taken`, where the given polylines
    /// are drawn.
    pub fn new(within: Rect, taken: Vec<Rect>, data: Vec<Vec<Pixel>>) -> Names {
        Names {
            within,
            taken,
            data,
        }
    }

    /// Breaks a name so that it fits into the plotting area.
    pub fn block(&self, name: &str) -> Block {
        Block::new(name, SMALL_SIZE, 0.4 * self.within.width())
    }

    /// Writes a name centred at the best of `centres`, earlier ones first.
    pub fn write(&mut self, canvas: &mut Canvas, name: &Block, centres: &[Pixel]) {
        let Some(place) = self.best_place(name, centres) else {
            return;
        };
        self.taken.push(place);
        canvas.polygon(&place.corners(), WHITE.at(GROUND));
        let first_row = place.top + name.line_height() / 2.0;
        canvas.text(name, place.centre().0, first_row, Align::Centre)
    }

    /// The place with the fewest conflicts and then the least data below it.
    fn best_place(&self, name: &Block, centres: &[Pixel]) -> Option<Rect> {
        let places = centres.iter().map(|&centre| {
            let place = self.inside(name, centre);
            let moved = place.centre() != centre;
            let crowded = self.taken.iter().any(|rect| rect.overlaps(&place));
            let conflicts = u8::from(moved) + u8::from(crowded);
            (conflicts, self.hidden(&place), place)
        });
        let best = places.min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        best.map(|(_, _, place)| place)
    }

    /// The length of all data lines inside a rectangle.
    fn hidden(&self, place: &Rect) -> f64 {
        let parts = self.data.iter().flat_map(|line| place.clip(line));
        let length = |side: &[Pixel]| (side[1].0 - side[0].0).hypot(side[1].1 - side[0].1);
        parts
            .map(|part| part.windows(2).map(length).sum::<f64>())
            .sum()
    }

    /// The rectangle of a name near `centre`, moved into the plotting area.
    fn inside(&self, name: &Block, (x, y): Pixel) -> Rect {
        let (half_width, half_height) = (name.width / 2.0, name.height() / 2.0);
        let Rect {
            left,
            top,
            right,
            bottom,
        } = self.within;
        let x = x.min(right - half_width).max(left + half_width);
        let y = y.min(bottom - half_height).max(top + half_height);
        Rect::centred((x, y), name.width, name.height())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AREA: Rect = Rect {
        left: 0.0,
        top: 0.0,
        right: 400.0,
        bottom: 100.0,
    };
    const CENTRES: [Pixel; 2] = [(100.0, 50.0), (300.0, 50.0)];

    fn best(names: &Names, centres: &[Pixel]) -> Pixel {
        let name = names.block("8(a)");
        names.best_place(&name, centres).expect("a place").centre()
    }

    #[test]
    fn the_first_place_wins_unless_data_or_names_are_there() {
        let taken = vec![Rect::centred(CENTRES[0], 10.0, 10.0)];
        let data = vec![vec![(100.0, 0.0), (100.0, 100.0)]];
        for (taken, data, middle) in [
            (vec![], vec![], 100.0),
            (taken, vec![], 300.0),
            (vec![], data, 300.0),
        ] {
            let names = Names::new(AREA, taken, data);
            assert!((best(&names, &CENTRES).0 - middle).abs() < 1e-9);
        }
    }

    #[test]
    fn a_name_never_leaves_the_area() {
        let names = Names::new(AREA, Vec::new(), Vec::new());
        let name = names.block("8(a)");
        let place = names.best_place(&name, &[(399.0, -5.0)]).expect("a place");
        assert!(place.right <= 400.0 + 1e-9 && place.top >= -1e-9);
    }
}
