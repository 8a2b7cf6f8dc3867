//! The hatching of a range, and lines that may lie on a dark fill.

use super::canvas::Canvas;
use super::colours::{BLACK, WHITE};
use super::geometry::{Pixel, Rect};
use super::shapes::Stroke;

/// Distance between the strokes of a hatching.
const STEP: f64 = 9.0;
const WIDTH: f64 = 0.7;
/// Width of the line around it.
const OUTLINE: f64 = 1.2;
/// How much wider the white line is below a black one that may be on a dark fill.
pub(crate) const RIM: f64 = 1.5;

/// Hatches an area and draws a line around it, clipped to `within`.
pub(crate) fn draw_hatching(canvas: &mut Canvas, area: Rect, within: Rect) {
    let shown = Rect {
        left: area.left.max(within.left),
        top: area.top.max(within.top),
        right: area.right.min(within.right),
        bottom: area.bottom.min(within.bottom),
    };
    if shown.left >= shown.right || shown.top > shown.bottom {
        return;
    }
    let strokes = (shown.width() + shown.height()) / STEP;
    for stroke in 1..=strokes as usize {
        let along = shown.left + stroke as f64 * STEP;
        let across = [(along - shown.height(), shown.bottom), (along, shown.top)];
        for part in shown.clip(&across) {
            draw_rimmed(canvas, &part, WIDTH);
        }
    }
    for part in within.clip(&area.outline()) {
        draw_rimmed(canvas, &part, OUTLINE);
    }
}

fn draw_rimmed(canvas: &mut Canvas, line: &[Pixel], width: f64) {
    canvas.line(line, Stroke::solid(WHITE, width + RIM));
    canvas.line(line, Stroke::solid(BLACK, width))
}
