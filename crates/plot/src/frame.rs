//! The axes around a plotting area.

use super::canvas::Canvas;
use super::colours::{BLACK, GRID};
use super::geometry::{Pixel, Rect};
use super::lettering::Align;
use super::scale::{Axis, Scale, Tick};
use super::shapes::Stroke;
use super::text::{self, Block, LABEL_SIZE, SMALL_SIZE};

const MAJOR_TICK: f64 = 6.0;
const MINOR_TICK: f64 = 3.0;
/// Distance between ticks, tick labels and axis titles.
const GAP: f64 = 5.0;
/// Least distance between neighbouring tick labels.
const LABEL_GAP: f64 = 14.0;
/// Least distance between the names of rows.
const ROW_GAP: f64 = 3.0;
/// Most labelled ticks on an axis.
const MOST_TICKS: usize = 9;

/// A plotting area with its axes.
pub(crate) struct Frame {
    /// Where the data are drawn.
    pub area: Rect,
    scales: [Scale; 2],
    x_title: Block,
    y_title: Block,
    y_ticks: Vec<Tick>,
    /// Width of the widest label of those.
    y_labels: f64,
}

impl Frame {
    /// A frame that fills `outer` with its plotting area, ticks and titles.
    pub fn new(outer: Rect, axes: &[Axis; 2], scales: [Scale; 2]) -> Frame {
        Self::laid_out(outer, axes, scales, |height| {
            roomy_ticks(&scales[1], height, |_| SMALL_SIZE)
        })
    }

    /// The same to the right of one with the same vertical axis, which it shows without title and
    /// numbers.
    pub fn next_to(outer: Rect, x: &Axis, scales: [Scale; 2]) -> Frame {
        let axes = [Axis::linear(x.label.as_str()), Axis::linear("")];
        Self::laid_out(outer, &axes, scales, |height| {
            let ticks = roomy_ticks(&scales[1], height, |_| SMALL_SIZE).into_iter();
            let without_number = |tick: Tick| Tick {
                label: tick.label.map(|_| String::new()),
                ..tick
            };
            ticks.map(without_number).collect()
        })
    }

    /// The same over rows with names, from top to bottom: the last one is from 0 to 1 along the
    /// vertical axis, that above it from 1 to 2. Where not all names have room, the last one's
    /// and that of every n-th above it are written.
    pub fn of_rows(outer: Rect, axes: &[Axis; 2], x: Scale, names: &[String]) -> Frame {
        let rows = Scale::new(false, [0.0, names.len() as f64].into_iter());
        Self::laid_out(outer, axes, [x, rows], |height| {
            let needed = (SMALL_SIZE + ROW_GAP) * names.len() as f64;
            let every = (needed / height).ceil().max(1.0) as usize;
            let named = names.iter().rev().enumerate().step_by(every);
            let ticks = named.filter_map(|(row, name)| {
                Some(Tick {
                    fraction: rows.fraction(row as f64 + 0.5)?,
                    label: Some(name.clone()),
                })
            });
            ticks.collect()
        })
    }

    /// A frame whose vertical axis, of a height, has the given ticks.
    fn laid_out(
        outer: Rect,
        axes: &[Axis; 2],
        scales: [Scale; 2],
        y_ticks: impl FnOnce(f64) -> Vec<Tick>,
    ) -> Frame {
        // The left margin is not known yet; the title may be a bit narrower.
        let x_title = Block::new(&axes[0].label, LABEL_SIZE, 0.75 * outer.width());
        let below = MAJOR_TICK + SMALL_SIZE + 2.0 * GAP + x_title.height();
        let mut area = Rect {
            bottom: outer.bottom - below,
            ..outer
        };
        let y_title = Block::new(&axes[1].label, LABEL_SIZE, area.height());
        let y_ticks = y_ticks(area.height());
        let y_labels = y_ticks.iter().filter_map(|tick| tick.label.as_ref());
        let y_labels = text::widest(y_labels, SMALL_SIZE);
        area.left += y_title.height() + y_labels + MAJOR_TICK + 2.0 * GAP;
        Frame {
            area,
            scales,
            x_title,
            y_title,
            y_ticks,
            y_labels,
        }
    }

    /// The pixel of a data point, which may lie outside the plotting area;
    /// none if an axis cannot show the point.
    pub fn pixel(&self, (x, y): (f64, f64)) -> Option<Pixel> {
        Some((self.pixel_x(x)?, self.pixel_y(y)?))
    }

    /// The pixel of a data point inside the plotting area.
    pub fn pixel_inside(&self, point: (f64, f64)) -> Option<Pixel> {
        self.pixel(point).filter(|pixel| self.area.holds(*pixel))
    }

    /// The horizontal place of a value, as [`Frame::pixel`] gives it.
    pub fn pixel_x(&self, value: f64) -> Option<f64> {
        Some(self.along_x(self.scales[0].fraction(value)?))
    }

    /// The vertical place of a value, as [`Frame::pixel`] gives it.
    pub fn pixel_y(&self, value: f64) -> Option<f64> {
        Some(self.along_y(self.scales[1].fraction(value)?))
    }

    /// The pixels of a curve, cut into pieces where points cannot be shown.
    pub fn curve(&self, points: &[(f64, f64)]) -> Vec<Vec<Pixel>> {
        let pixels: Vec<_> = points.iter().map(|&point| self.pixel(point)).collect();
        let pieces = pixels.split(Option::is_none);
        pieces
            .filter(|piece| !piece.is_empty())
            .map(|piece| piece.iter().copied().flatten().collect())
            .collect()
    }

    /// Draws the grid, the border, the ticks and the titles.
    pub fn draw(&self, canvas: &mut Canvas) {
        self.draw_with(canvas, true)
    }

    /// The same without the grid, over an area that is filled.
    pub fn draw_around(&self, canvas: &mut Canvas) {
        self.draw_with(canvas, false)
    }

    fn draw_with(&self, canvas: &mut Canvas, has_grid: bool) {
        let Rect {
            left,
            top,
            right,
            bottom,
        } = self.area;
        let x_ticks = roomy_ticks(&self.scales[0], self.area.width(), |label| {
            text::width(label, SMALL_SIZE)
        });
        // The line across the area, the tick outwards from it and where its label is.
        let upright = x_ticks.iter().map(|tick| {
            let x = self.along_x(tick.fraction);
            let outwards = [(x, bottom), (x, bottom + tick_length(tick))];
            let below = (x, bottom + MAJOR_TICK + GAP + SMALL_SIZE / 2.0);
            let across = [(x, top), (x, bottom)];
            (tick, across, outwards, (below, Align::Centre))
        });
        let level = self.y_ticks.iter().map(|tick| {
            let y = self.along_y(tick.fraction);
            let outwards = [(left, y), (left - tick_length(tick), y)];
            let number_at = (left - MAJOR_TICK - GAP, y);
            let across = [(left, y), (right, y)];
            (tick, across, outwards, (number_at, Align::Right))
        });
        let ticks: Vec<_> = upright.chain(level).collect();
        let lines = ticks
            .iter()
            .filter(|(tick, ..)| has_grid && tick.label.is_some());
        for (_, across, ..) in lines {
            canvas.line(across, Stroke::solid(GRID, 1.0));
        }
        canvas.outline(self.area, Stroke::solid(BLACK, 1.0));
        for (tick, _, outwards, ((x, y), align)) in ticks {
            canvas.line(&outwards, Stroke::solid(BLACK, 1.0));
            if let Some(label) = &tick.label {
                let label = Block::new(label, SMALL_SIZE, f64::INFINITY);
                canvas.text(&label, x, y, align);
            }
        }
        self.draw_titles(canvas)
    }

    fn draw_titles(&self, canvas: &mut Canvas) {
        let (x, y) = self.area.centre();
        let below = self.area.bottom + MAJOR_TICK + SMALL_SIZE + 2.0 * GAP;
        let first_row = below + self.x_title.line_height() / 2.0;
        // Not beyond the right end, where a long title upwards leaves little width.
        let middle = x.min(self.area.right - self.x_title.width / 2.0);
        canvas.text(&self.x_title, middle, first_row, Align::Centre);
        let labels = MAJOR_TICK + 2.0 * GAP + self.y_labels;
        let first_column =
            self.area.left - labels - self.y_title.height() + self.y_title.line_height() / 2.0;
        canvas.upward_text(&self.y_title, first_column, y)
    }

    fn along_x(&self, fraction: f64) -> f64 {
        self.area.left + fraction * self.area.width()
    }

    fn along_y(&self, fraction: f64) -> f64 {
        self.area.bottom - fraction * self.area.height()
    }
}

/// Aligns the left sides of frames in each of some columns, filled row by row, with
/// the one furthest to the right.
pub(crate) fn align_left(frames: &mut [Frame], columns: usize) {
    for column in 0..columns {
        let lefts = frames.iter().skip(column).step_by(columns);
        let left = lefts.map(|frame| frame.area.left).fold(0.0, f64::max);
        for frame in frames.iter_mut().skip(column).step_by(columns) {
            frame.area.left = left;
        }
    }
}

fn tick_length(tick: &Tick) -> f64 {
    if tick.label.is_some() {
        MAJOR_TICK
    } else {
        MINOR_TICK
    }
}

/// The most ticks whose labels, of the given extents along an axis of `length`
/// pixels, do not run into one another.
fn roomy_ticks(scale: &Scale, length: f64, extent: impl Fn(&str) -> f64) -> Vec<Tick> {
    for most in (2..=MOST_TICKS).rev() {
        let ticks = scale.ticks(most);
        if have_room(&ticks, length, &extent) {
            return ticks;
        }
    }
    scale.ticks(1)
}

fn have_room(ticks: &[Tick], length: f64, extent: impl Fn(&str) -> f64) -> bool {
    let mut free_from = f64::NEG_INFINITY;
    for tick in ticks {
        let Some(label) = &tick.label else { continue };
        let middle = tick.fraction * length;
        let half = extent(label) / 2.0;
        if middle - half < free_from {
            return false;
        }
        free_from = middle + half + LABEL_GAP;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame(label: &str) -> Frame {
        let outer = Rect {
            left: 10.0,
            top: 10.0,
            right: 500.0,
            bottom: 240.0,
        };
        let scale = |high| Scale::new(false, [0.0, high].into_iter());
        let axes = ["Time t (s)", label].map(Axis::linear);
        Frame::new(outer, &axes, [50.0, 0.5].map(scale))
    }

    #[test]
    fn a_long_title_is_broken_and_takes_its_room() {
        let (short, long) = (
            frame("ω (rad/s)"),
            frame("Angular speed of the bit ω (rad/s)"),
        );
        assert_eq!(
            (short.y_title.lines.len(), long.y_title.lines.len()),
            (1, 2)
        );
        assert!(long.area.left > short.area.left + 15.0);
    }

    #[test]
    fn curves_are_cut_at_points_that_cannot_be_shown() {
        let points = [(0.0, 0.1), (1.0, 0.2), (2.0, f64::NAN), (3.0, 0.3)];
        let pieces = frame("y").curve(&points);
        let lengths: Vec<_> = pieces.iter().map(Vec::len).collect();
        assert_eq!(lengths, [2, 1]);
    }

    #[test]
    fn tick_labels_keep_their_distance() {
        let scale = Scale::new(false, [0.0, 0.001_234].into_iter());
        let extent = |label: &str| text::width(label, SMALL_SIZE);
        let wide = roomy_ticks(&scale, 600.0, extent);
        let narrow = roomy_ticks(&scale, 200.0, extent);
        assert!(have_room(&wide, 600.0, extent));
        assert!(narrow.len() < wide.len() && narrow.len() >= 2);
    }
}
