//! Charts of levels over two axes, such as amplitudes over time and frequency: the darker the
//! larger, in classes that a bar next to each panel explains. How light they are tells them apart, so
//! that neither colour vision nor colour print is needed.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::{BLACK, Colour, PARTS};
use super::frame::{Frame, align_left};
use super::geometry::Rect;
use super::lettering::Align;
use super::look::{Look, is_narrow};
use super::numbers::{in_two, nice_step, power};
use super::picture::Picture;
use super::scale::{Axis, Scale};
use super::shapes::Stroke;
use super::text::{Block, LABEL_SIZE, SMALL_SIZE};

const WIDTH: f64 = 900.0;
const MARGIN: f64 = 14.0;
const PANEL_HEIGHT: f64 = 215.0;
/// Distance between panels, and between a title, its panel and its bar.
const PANEL_GAP: f64 = 14.0;
const GAP: f64 = 8.0;
/// Room for the bar and its numbers, in a wide picture and in a narrow one.
const BAR_ROOM: [f64; 2] = [120.0, 84.0];
const BAR_WIDTH: f64 = 16.0;
/// Cells overlap by this, so that no light line is seen between them, pixels.
const OVERLAP: f64 = 0.5;

/// Classes of levels; what is below the last has the lightest colour, too.
const CLASSES: usize = 10;

/// Levels over two axes.
pub struct LevelPanel {
    /// What it shows.
    pub title: String,
    /// Horizontal and vertical axis.
    pub axes: [Axis; 2],
    /// The lines between cells along both, rising.
    pub edges: [Vec<f64>; 2],
    /// Levels of the cells, column by column from the left, each from below.
    pub levels: Vec<f64>,
    /// What levels are, with the unit.
    pub scale: String,
    /// How classes of them are apart.
    pub classes: LevelClasses,
}

/// How classes of levels are apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LevelClasses {
    /// By factors: what is a thousandth of the largest is seen, too.
    Factors,
    /// Evenly, from zero.
    Even,
}

/// Draws panels one below another with one title, each with its own bar; `note` is below all.
pub fn level_chart(look: &Look, title: &str, panels: &[LevelPanel], note: &str) -> Picture {
    let title = Title::new(look, title, WIDTH, MARGIN);
    let bar = BAR_ROOM[usize::from(is_narrow(title.width))];
    let right = title.width - MARGIN - bar;
    let heading = LABEL_SIZE + GAP;
    let mut frames: Vec<Frame> = (panels.iter().enumerate())
        .map(|(place, panel)| {
            let top = title.bottom() + place as f64 * PANEL_HEIGHT;
            let outer = Rect {
                left: MARGIN,
                top: top + heading,
                right,
                bottom: top + PANEL_HEIGHT - PANEL_GAP,
            };
            Frame::new(outer, &panel.axes, scales(look, panel))
        })
        .collect();
    align_left(&mut frames, 1);
    let note = Block::new(note, SMALL_SIZE, title.width - 2.0 * MARGIN);
    let bottom = title.bottom() + panels.len() as f64 * PANEL_HEIGHT;
    draw_titled(&title, bottom + note.height() + MARGIN, |canvas| {
        for (panel, frame) in panels.iter().zip(&frames) {
            draw_panel(canvas, panel, frame, right + GAP);
        }
        let first_row = bottom + 0.5 * note.line_height();
        canvas.text(&note, MARGIN, first_row, Align::Left);
    })
}

/// From the first line to the last, unless other ends of the horizontal axis are asked for.
fn scales(look: &Look, panel: &LevelPanel) -> [Scale; 2] {
    [0, 1].map(|axis| {
        let edges = &panel.edges[axis];
        let own = edges.first().copied().zip(edges.last().copied());
        let own = own.map(|(first, last)| [first, last]);
        let ends = look.ranges[0].filter(|_| axis == 0).or(own);
        let is_logarithmic = panel.axes[axis].logarithmic;
        Scale::with_ends(ends, is_logarithmic, edges.iter().copied())
    })
}

fn draw_panel(canvas: &mut Canvas, panel: &LevelPanel, frame: &Frame, bar_left: f64) {
    let ends = class_ends(&panel.levels, panel.classes);
    let [x, y] = &panel.edges;
    let [columns, rows] = [x, y].map(|edges| edges.len().saturating_sub(1));
    let colour = |class: usize| colour(class, ends.len());
    canvas.polygon(&frame.area.corners(), colour(0));
    for row in 0..rows {
        let class = |column: &usize| class_of(panel.levels[column * rows + row], &ends);
        let all: Vec<usize> = (0..columns).collect();
        // Neighbours in a class are one.
        for run in all.chunk_by(|one, next| class(one) == class(next)) {
            let [first, last] = [run[0], run[run.len() - 1]];
            let corners = [(x[first], y[row]), (x[last + 1], y[row + 1])];
            let corners = corners.map(|corner| frame.pixel(corner));
            let [Some((left, bottom)), Some((right, top))] = corners else {
                continue;
            };
            let cell = Rect {
                left,
                top: top - OVERLAP,
                right: right + OVERLAP,
                bottom,
            };
            if let (Some(seen), 1..) = (cell.within(frame.area), class(&first)) {
                canvas.polygon(&seen.corners(), colour(class(&first)));
            }
        }
    }
    frame.draw_around(canvas);
    let heading = Block::new(&panel.title, LABEL_SIZE, frame.area.width());
    let above = frame.area.top - GAP - 0.5 * LABEL_SIZE;
    canvas.text(&heading, frame.area.centre().0, above, Align::Centre);
    draw_bar(canvas, panel, &ends, (frame, bar_left));
}

/// The classes as a bar, the largest above, with the numbers between them.
fn draw_bar(canvas: &mut Canvas, panel: &LevelPanel, ends: &[f64], (frame, left): (&Frame, f64)) {
    let Rect { top, bottom, .. } = frame.area;
    let height = (bottom - top) / ends.len() as f64;
    for class in 0..ends.len() {
        let cell = Rect {
            left,
            top: bottom - (class + 1) as f64 * height,
            right: left + BAR_WIDTH,
            bottom: bottom - class as f64 * height,
        };
        canvas.polygon(&cell.corners(), colour(class, ends.len()));
        // Upper ends; that of every second where there is no room for all.
        let every = (1.2 * SMALL_SIZE / height).ceil().max(1.0) as usize;
        if (ends.len() - 1 - class) % every == 0 {
            let number = Block::new(&in_two(ends[class]), SMALL_SIZE, f64::INFINITY);
            let y = cell.top.max(top + 0.4 * SMALL_SIZE);
            canvas.text(&number, left + BAR_WIDTH + 5.0, y, Align::Left);
        }
    }
    let bar = Rect {
        left,
        top,
        right: left + BAR_WIDTH,
        bottom,
    };
    canvas.outline(bar, Stroke::solid(BLACK, 1.0));
    let scale = Block::new(&panel.scale, SMALL_SIZE, f64::INFINITY);
    let column = left + BAR_WIDTH + 5.0 + 6.2 * 0.6 * SMALL_SIZE + 0.5 * scale.line_height();
    canvas.upward_text(&scale, column, 0.5 * (top + bottom));
}

/// Upper ends of classes, rising: round numbers, the last at or above every level.
fn class_ends(levels: &[f64], classes: LevelClasses) -> Vec<f64> {
    let most = levels.iter().copied().filter(|level| level.is_finite());
    let most = most.fold(0.0, f64::max);
    if most <= 0.0 {
        return vec![1.0];
    }
    match classes {
        LevelClasses::Factors => by_factors(most),
        LevelClasses::Even => evenly(most),
    }
}

/// From zero on, the first of which all that is not above zero is, too.
fn evenly(most: f64) -> Vec<f64> {
    let (digit, decade) = nice_step(most / (CLASSES - 2) as f64);
    let step = power(digit, decade);
    let count = (most / step * (1.0 - 1e-9)).ceil() as usize;
    (0..=count.max(1)).map(|end| end as f64 * step).collect()
}

/// 1, 2 and 5 times powers of ten.
fn by_factors(most: f64) -> Vec<f64> {
    let decade = most.log10().floor() as i32;
    let steps = (decade - CLASSES as i32..=decade + 1)
        .flat_map(|decade| [1, 2, 5].map(|digit| power(digit, decade)));
    let steps: Vec<f64> = steps.collect();
    // Not above a level but for rounding.
    let last = steps.iter().position(|step| *step >= most * (1.0 - 1e-9));
    let last = last.unwrap_or(steps.len() - 1);
    steps[last.saturating_sub(CLASSES - 1)..=last].to_vec()
}

/// The class of a level, from below.
fn class_of(level: f64, ends: &[f64]) -> usize {
    let above = ends.partition_point(|end| *end < level);
    above.min(ends.len() - 1)
}

/// From light to dark, evenly along the colours of parts of a whole.
fn colour(class: usize, classes: usize) -> Colour {
    let along = class as f64 / (classes - 1).max(1) as f64 * (PARTS.len() - 1) as f64;
    let below = (along as usize).min(PARTS.len() - 2);
    let part = along - below as f64;
    let [from, to] = [below, below + 1].map(|place| {
        let Colour(red, green, blue) = PARTS[place];
        [red, green, blue].map(f64::from)
    });
    let mixed = [0, 1, 2].map(|of| (from[of] + part * (to[of] - from[of])).round() as u8);
    Colour(mixed[0], mixed[1], mixed[2])
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    fn panel(levels: Vec<f64>) -> LevelPanel {
        LevelPanel {
            title: "Bit speed by quadrature".to_owned(),
            axes: [
                Axis::linear("Time t (s)"),
                Axis::logarithmic("Frequency (Hz)"),
            ],
            edges: [vec![0.0, 1.0, 2.0, 3.0], vec![0.1, 1.0, 10.0]],
            levels,
            scale: "Amplitude (rpm)".to_owned(),
            classes: LevelClasses::Factors,
        }
    }

    #[test]
    fn classes_end_at_round_numbers_at_or_above_the_largest() {
        let class_ends = |levels: &[f64]| class_ends(levels, LevelClasses::Factors);
        let ends = class_ends(&[0.0, 130.0, f64::NAN]);
        assert_eq!(ends.len(), CLASSES);
        assert_eq!(ends[CLASSES - 3..], [50.0, 100.0, 200.0]);
        assert!((ends[0] - 0.2).abs() < 1e-12, "{ends:?}");
        assert_eq!(class_ends(&[200.0]).last(), Some(&200.0));
        assert_eq!(class_ends(&[0.0]), [1.0]);
        let class = |level| class_of(level, &ends);
        assert_eq!([0.0, 0.1, 0.3, 100.0, 130.0].map(class), [0, 0, 1, 8, 9]);
    }

    #[test]
    fn even_classes_begin_with_what_is_not_above_zero() {
        let ends = class_ends(&[-3.0, 5.36, f64::NAN], LevelClasses::Even);
        assert_eq!(ends, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let class = |level| class_of(level, &ends);
        assert_eq!([-3.0, 0.0, 0.1, 5.36, 6.0].map(class), [0, 0, 1, 6, 6]);
        for most in [1e-3, 0.8, 1.0, 3.3, 8.0, 79.0] {
            let ends = class_ends(&[most], LevelClasses::Even);
            assert!(
                ends.len() <= CLASSES && ends.last() >= Some(&most),
                "{most}: {ends:?}"
            );
        }
    }

    /// Readers without colour vision see the order by lightness alone.
    #[test]
    fn each_class_is_darker_than_the_one_below() {
        let luminance = |class| {
            let Colour(red, green, blue) = colour(class, CLASSES);
            0.2126 * f64::from(red) + 0.7152 * f64::from(green) + 0.0722 * f64::from(blue)
        };
        for class in 1..CLASSES {
            assert!(luminance(class) < luminance(class - 1) - 8.0, "{class}");
        }
    }

    /// Cells: of the first row two alike and one, of the second none above the ground.
    #[test]
    fn neighbours_in_a_class_are_one_and_words_lie_inside() {
        let levels = vec![90.0, 0.0, 90.0, 0.0, 5.0, 0.0];
        let polygons = |panels: &[LevelPanel]| {
            let picture = level_chart(&Look::default(), "A case", panels, "Windows of 3 s");
            assert_text_inside(&picture);
            picture.svg().matches("<polygon").count()
        };
        assert_eq!(polygons(&[panel(levels)]), 1 + 2 + CLASSES);
    }
}
