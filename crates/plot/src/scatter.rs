//! A grid of panels of points with their Pareto fronts, such as error over cost.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::BLACK;
use super::frame::{Frame, align_left};
use super::geometry::{Pixel, Rect};
use super::legend::{Key, Legend};
use super::lettering::Align;
use super::line_styles::{LineStyle, Series, distinct_styles, markers, place_among};
use super::look::Look;
use super::picture::Picture;
use super::references::REFERENCE;
use super::scale::{Axis, Scale, visible};
use super::shapes::Stroke;
use super::symbols::{Marker, draw_marker, draw_rim};
use super::text::{Block, LABEL_SIZE};

const WIDTH: f64 = 860.0;
const PANEL_HEIGHT: f64 = 270.0;
const COLUMNS: usize = 3;
const MARGIN: f64 = 14.0;
/// Distance between panels.
const GAP: f64 = 16.0;
/// Of one, with its numbers and titles.
const PANEL_WIDTH: f64 = (WIDTH - 2.0 * MARGIN) / COLUMNS as f64 - GAP;
const MARKER_RADIUS: f64 = 3.4;
/// Radius of the rim around a point that is pointed out.
const RIM_RADIUS: f64 = 7.5;
const FRONT: Stroke = Stroke::solid(BLACK, 1.4);

/// One panel.
pub struct ScatterPanel {
    /// Title above it.
    pub title: String,
    /// Horizontal and vertical axis; all panels share the range of the horizontal one.
    pub axes: [Axis; 2],
    /// Points, by kind.
    pub kinds: Vec<Series>,
    /// The Pareto front, from left to right: drawn as steps.
    pub front: Vec<(f64, f64)>,
    /// Points to point out with a rim.
    pub rims: Vec<(f64, f64)>,
    /// A height below which differences mean nothing.
    pub floor: Option<f64>,
}

/// Draws panels in a grid, row by row, with one title, and one legend in a row below,
/// which also says what fronts, floors and rims are.
///
/// ```
/// use plot::{Axis, ScatterPanel, Series, scatter_grid};
///
/// let panel = ScatterPanel {
///     title: "torsion".to_owned(),
///     axes: ["Time for a case (s)", "Error"].map(Axis::logarithmic),
///     kinds: vec![Series::new("quadrature", vec![(0.01, 0.1), (0.1, 0.01), (0.2, 0.05)])],
///     front: vec![(0.01, 0.1), (0.1, 0.01)],
///     rims: vec![(0.1, 0.01)],
///     floor: Some(1e-3),
/// };
/// let picture = scatter_grid("What accuracy costs", ["best", "rounding", "chosen"], &[panel]);
/// assert!(picture.svg().contains("quadrature"));
/// ```
pub fn scatter_grid(
    title: &str,
    [front, floor, rim]: [&str; 3],
    panels: &[ScatterPanel],
) -> Picture {
    let styles = distinct_styles(panels.iter().flat_map(|panel| &panel.kinds));
    let markers = markers(&styles);
    let title = Title::new(&Look::default(), title, WIDTH, MARGIN);
    let entries = (styles.iter().zip(&markers))
        .map(|((name, _), marker)| (Key::Marker(*marker), *name))
        .chain([
            (Key::Line(FRONT), front),
            (Key::Line(REFERENCE), floor),
            (Key::Rim, rim),
        ]);
    let legend = Legend::new(entries).in_rows(WIDTH - 2.0 * MARGIN);
    let top = title.bottom();
    let rows = panels.len().div_ceil(COLUMNS);
    let legend_top = top + rows as f64 * PANEL_HEIGHT;
    let height = legend_top + legend.height() + MARGIN;
    let frames = frames(panels, top);
    draw_titled(&title, height, |canvas| {
        for (panel, frame) in panels.iter().zip(&frames) {
            draw_panel(canvas, panel, frame, (&styles, &markers));
        }
        legend.draw(canvas, MARGIN, legend_top)
    })
}

/// The frames of all panels, the sides of each column aligned.
fn frames(panels: &[ScatterPanel], top: f64) -> Vec<Frame> {
    let all = panels.iter().flat_map(shown_points).map(|(x, _)| x);
    let x = Scale::new(true, all);
    let mut frames = Vec::with_capacity(panels.len());
    for (index, panel) in panels.iter().enumerate() {
        let (row, column) = (index / COLUMNS, index % COLUMNS);
        let left = MARGIN + column as f64 * (PANEL_WIDTH + GAP);
        let top = top + row as f64 * PANEL_HEIGHT;
        let outer = Rect {
            left,
            top: top + LABEL_SIZE + GAP / 2.0,
            right: left + PANEL_WIDTH,
            bottom: top + PANEL_HEIGHT - GAP,
        };
        let shown = shown_points(panel).map(|(_, y)| y);
        let y = Scale::new(panel.axes[1].logarithmic, shown.chain(panel.floor));
        frames.push(Frame::new(outer, &panel.axes, [x, y]));
    }
    align_left(&mut frames, COLUMNS);
    frames
}

fn shown_points(panel: &ScatterPanel) -> impl Iterator<Item = (f64, f64)> {
    let points = panel.kinds.iter().flat_map(|kind| &kind.points);
    visible(&panel.axes, points.copied())
}

fn draw_panel(
    canvas: &mut Canvas,
    panel: &ScatterPanel,
    frame: &Frame,
    (styles, markers): (&[(&str, LineStyle)], &[Marker]),
) {
    frame.draw(canvas);
    let title = Block::new(&panel.title, LABEL_SIZE, PANEL_WIDTH);
    if let Some(y) = panel.floor.and_then(|floor| frame.pixel_y(floor)) {
        let Rect { left, right, .. } = frame.area;
        canvas.line(&[(left, y), (right, y)], REFERENCE);
    }
    let above = frame.area.top - GAP / 2.0 - 2.0;
    let middle = frame.area.right - PANEL_WIDTH / 2.0;
    canvas.text(&title, middle, above, Align::Centre);
    for kind in &panel.kinds {
        let marker = markers[place_among(&kind.name, styles)];
        for pixel in kind.points.iter().filter_map(|&point| frame.pixel(point)) {
            draw_marker(canvas, marker, pixel, MARKER_RADIUS);
        }
    }
    canvas.line(&steps(frame, &panel.front), FRONT);
    for pixel in panel.rims.iter().filter_map(|&point| frame.pixel(point)) {
        draw_rim(canvas, pixel, RIM_RADIUS);
    }
}

/// A front as steps: at each cost the least error so far, to the end of the frame.
fn steps(frame: &Frame, front: &[(f64, f64)]) -> Vec<Pixel> {
    let pixels: Vec<Pixel> = front.iter().filter_map(|&at| frame.pixel(at)).collect();
    let mut steps: Vec<Pixel> = Vec::with_capacity(2 * pixels.len() + 1);
    for (x, y) in pixels {
        if let Some((_, last)) = steps.last() {
            steps.push((x, *last));
        }
        steps.push((x, y));
    }
    if let Some((_, last)) = steps.last() {
        steps.push((frame.area.right, *last));
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    const LONGEST_TITLE: &str = "Limit of stick-slip, uniform tube";

    fn panel(points: Vec<(f64, f64)>) -> ScatterPanel {
        ScatterPanel {
            title: LONGEST_TITLE.to_string(),
            axes: ["Time for 1000 cases of 10 s (s)", "Relative error"].map(Axis::logarithmic),
            kinds: vec![Series::new("finite-element, γ = 0.52", points.clone())],
            front: points,
            rims: vec![(1.0, 0.1)],
            floor: Some(1e-3),
        }
    }

    #[test]
    fn a_grid_with_a_last_row_that_is_not_full_is_drawn() {
        let points = vec![(0.01, 0.2), (1.0, 0.1), (30.0, 1e-5)];
        let keys = [
            "no other is cheaper and better",
            "uncertainty of the reference",
            "the paper's own",
        ];
        let panels = [(); 4].map(|()| panel(points.clone()));
        let picture = scatter_grid("Accuracy against speed", keys, &panels);
        assert_text_inside(&picture);
        // There is room for one line above a panel.
        assert_eq!(picture.svg().matches(LONGEST_TITLE).count(), 4);
    }
}
