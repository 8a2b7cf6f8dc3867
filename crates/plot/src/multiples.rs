//! Small multiples: one curve a panel, in a grid.

use super::canvas::{Title, draw_titled};
use super::colours::{BLUE, REFERENCE};
use super::frame::{Frame, align_left};
use super::geometry::Rect;
use super::lettering::Align;
use super::look::Look;
use super::picture::Picture;
use super::scale::{Axis, Scale};
use super::shapes::Stroke;
use super::text::{Block, LABEL_SIZE};

const WIDTH: f64 = 1180.0;
const PANEL_HEIGHT: f64 = 190.0;
const COLUMNS: usize = 3;
/// The least width of one.
const LEAST_WIDTH: f64 = 220.0;
const MARGIN: f64 = 14.0;
/// Distance between panels.
const GAP: f64 = 16.0;
const CURVE: Stroke = Stroke::solid(BLUE, 1.8);
const AT_REST: Stroke = Stroke::solid(REFERENCE, 0.8);

/// One panel.
pub struct Multiple {
    /// Title above it.
    pub title: String,
    /// Its curve.
    pub points: Vec<(f64, f64)>,
}

/// Draws panels with the same vertical axis in a grid, row by row, each over its own range of the
/// horizontal one and with a line where the vertical one is zero.
///
/// ```
/// use plot::{Axis, Look, Multiple, multiples};
///
/// let shape = |mode: u32| Multiple {
///     title: format!("mode {mode}"),
///     points: (0..=50)
///         .map(|place| 0.02 * f64::from(place))
///         .map(|depth| (depth, (f64::from(2 * mode - 1) * 1.5708 * depth).sin()))
///         .collect(),
/// };
/// let axes = ["Depth over length", "Rotation"].map(Axis::linear);
/// let picture = multiples(&Look::default(), "Mode shapes", &axes, &[1, 2, 3].map(shape));
/// assert!(picture.svg().contains("mode 3"));
/// ```
pub fn multiples(look: &Look, title: &str, axes: &[Axis; 2], panels: &[Multiple]) -> Picture {
    let title = Title::new(look, title, WIDTH, MARGIN);
    let columns = ((title.width / LEAST_WIDTH) as usize).clamp(1, COLUMNS);
    let top = title.bottom();
    let rows = panels.len().div_ceil(columns);
    let frames = frames(axes, panels, top, (title.width, columns));
    draw_titled(
        &title,
        top + rows as f64 * PANEL_HEIGHT + MARGIN,
        |canvas| {
            for (panel, frame) in panels.iter().zip(&frames) {
                frame.draw(canvas);
                let title = Block::new(&panel.title, LABEL_SIZE, frame.area.width());
                let above = frame.area.top - GAP / 2.0 - 2.0;
                canvas.text(&title, frame.area.centre().0, above, Align::Centre);
                if let Some(y) = frame.pixel_y(0.0) {
                    let Rect { left, right, .. } = frame.area;
                    canvas.line(&[(left, y), (right, y)], AT_REST);
                }
                for piece in frame.curve(&panel.points) {
                    canvas.line(&piece, CURVE);
                }
            }
        },
    )
}

fn frames(
    axes: &[Axis; 2],
    panels: &[Multiple],
    top: f64,
    (full, columns): (f64, usize),
) -> Vec<Frame> {
    let points = panels.iter().flat_map(|panel| &panel.points);
    let y = Scale::new(axes[1].logarithmic, points.map(|point| point.1));
    let width = (full - 2.0 * MARGIN) / columns as f64;
    let mut frames = Vec::with_capacity(panels.len());
    for (index, panel) in panels.iter().enumerate() {
        let own = panel.points.iter().map(|point| point.0);
        let x = Scale::new(axes[0].logarithmic, own);
        let left = MARGIN + (index % columns) as f64 * width;
        let top = top + (index / columns) as f64 * PANEL_HEIGHT;
        let outer = Rect {
            left,
            top: top + LABEL_SIZE + GAP / 2.0,
            right: left + width - GAP,
            bottom: top + PANEL_HEIGHT - GAP,
        };
        frames.push(Frame::new(outer, axes, [x, y]));
    }
    align_left(&mut frames, columns);
    frames
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    #[test]
    fn every_panel_has_its_curve_and_its_line_of_rest() {
        let panel = |index: usize| Multiple {
            title: format!("Torsion {index}: 0.72 Hz"),
            points: vec![(0.0, 0.0), (4000.0, 1.0), (5000.0, -1.0)],
        };
        let panels: Vec<Multiple> = (0..5).map(panel).collect();
        let axes = ["Depth (m)", "Amplitude"].map(Axis::linear);
        let picture = multiples(&Look::default(), "Mode shapes", &axes, &panels);
        assert_text_inside(&picture);
        assert_eq!(picture.svg().matches("#0072B2").count(), 5);
        assert_eq!(picture.svg().matches("#555555").count(), 5);
    }
}
