//! Campbell diagrams: natural frequencies across, multiples of the speed upwards, and a mark
//! wherever they meet.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::GREY;
use super::frame::{Frame, align_left};
use super::geometry::Rect;
use super::legend::{Key, Legend};
use super::lettering::Align;
use super::line_styles::{LineStyle, Series, distinct_styles, markers, place_among, strokes};
use super::look::{Look, is_narrow};
use super::picture::Picture;
use super::scale::{Axis, Scale, visible};
use super::shapes::Stroke;
use super::symbols::{Marker, draw_marker};
use super::text::{Block, LABEL_SIZE, SMALL_SIZE};

const WIDTH: f64 = 900.0;
const PANEL_HEIGHT: f64 = 380.0;
const MARGIN: f64 = 14.0;
const GAP: f64 = 14.0;
/// Room for the numbers of modes, to the right of a panel.
const NUMBERS: f64 = 40.0;
const MARKER_RADIUS: f64 = 3.2;
/// More natural frequencies than this, drawn across, are one grey area.
const MOST_ACROSS: usize = 60;
/// Length of the ticks that they are then.
const TICK: f64 = 8.0;
/// Across all speeds.
const NATURAL: Stroke = Stroke::solid(GREY, 0.9);

/// The diagram of one way to swing.
pub struct CampbellPanel {
    /// Title above it.
    pub title: String,
    /// Speed and frequency; all panels share the range of speeds.
    pub axes: [Axis; 2],
    /// Natural frequencies, numbered from 1; of many there are ticks alone.
    pub natural: Vec<f64>,
    /// Each multiple of the speed, as a line.
    pub orders: Vec<Series>,
    /// Where a multiple of the same name meets a natural frequency.
    pub crossings: Vec<Series>,
}

impl CampbellPanel {
    fn is_dense(&self) -> bool {
        self.natural.len() > MOST_ACROSS
    }

    fn titled(&self) -> String {
        if !self.is_dense() {
            return self.title.clone();
        }
        let count = self.natural.len();
        format!("{}: {count} natural frequencies, as ticks", self.title)
    }
}

/// Draws panels one below another, with one title and one legend, in which all natural
/// frequencies have a name, and crossings one before that of their multiple.
///
/// ```
/// use plot::{Axis, CampbellPanel, Look, Series, campbell};
///
/// // The speed in rpm and its multiples in Hz meet the natural frequencies 0.5 and 1.5 Hz.
/// let crossing = |order: f64| [0.5, 1.5].map(|frequency| (60.0 * frequency / order, frequency));
/// let panel = CampbellPanel {
///     title: "Torsion".to_owned(),
///     axes: ["Surface speed (rpm)", "Frequency (Hz)"].map(Axis::linear),
///     natural: vec![0.5, 1.5],
///     orders: vec![Series::new("once a turn", vec![(0.0, 0.0), (120.0, 2.0)])],
///     crossings: vec![Series::new("once a turn", crossing(1.0).to_vec())],
/// };
/// let picture = campbell(&Look::default(), "Resonance", ["natural", "crossing"], &[panel]);
/// assert!(picture.svg().contains("once a turn"));
/// ```
pub fn campbell(
    look: &Look,
    title: &str,
    [natural, crossing]: [&str; 2],
    panels: &[CampbellPanel],
) -> Picture {
    let styles = distinct_styles(panels.iter().flat_map(|panel| &panel.orders));
    let strokes: Vec<Stroke> = strokes(&styles).into_iter().map(of_order).collect();
    let lines = (styles.iter().zip(&strokes))
        .map(|((name, _), stroke)| (Key::Line(*stroke), (*name).to_owned()));
    let markers = markers(&styles);
    let marks = (styles.iter().zip(&markers))
        .map(|((name, _), marker)| (Key::Marker(*marker), format!("{crossing}, {name}")));
    let entries: Vec<_> = std::iter::once((Key::Line(NATURAL), natural.to_owned()))
        .chain(lines)
        .chain(marks)
        .collect();
    let texts: Vec<String> = entries.iter().map(|(_, text)| text.clone()).collect();
    let keys = entries.into_iter().map(|(key, _)| key);
    let legend = Legend::new(keys.zip(texts.iter().map(String::as_str)));
    let title = Title::new(look, title, WIDTH, MARGIN);
    let top = title.bottom();
    let stacked = panels.len() as f64 * PANEL_HEIGHT;
    let (legend, place, right, height) = if is_narrow(title.width) {
        let legend = legend.in_rows(title.width - 2.0 * MARGIN);
        let height = top + stacked + legend.height();
        (
            legend,
            (MARGIN, top + stacked),
            title.width - NUMBERS,
            height,
        )
    } else {
        let left = title.width - MARGIN - legend.width();
        let height = top + stacked.max(legend.height());
        (legend, (left, top), left - NUMBERS, height)
    };
    let height = height + MARGIN;
    let frames = frames(panels, top, right);
    draw_titled(&title, height, |canvas| {
        for (panel, frame) in panels.iter().zip(&frames) {
            draw_panel(canvas, panel, frame, (&styles, &strokes, &markers));
        }
        legend.draw(canvas, place.0, place.1)
    })
}

/// Dashes and colours of multiples.
fn of_order(stroke: Stroke) -> Stroke {
    Stroke {
        width: 1.8,
        ..stroke
    }
}

fn frames(panels: &[CampbellPanel], top: f64, right: f64) -> Vec<Frame> {
    let all = panels.iter().flat_map(shown).map(|(x, _)| x);
    let x = Scale::new(false, all);
    let mut frames = Vec::with_capacity(panels.len());
    for (index, panel) in panels.iter().enumerate() {
        let top = top + index as f64 * PANEL_HEIGHT;
        let outer = Rect {
            left: MARGIN,
            top: top + LABEL_SIZE + GAP / 2.0,
            right,
            bottom: top + PANEL_HEIGHT - GAP,
        };
        let shown = shown(panel).map(|(_, y)| y);
        let y = Scale::new(
            false,
            shown.chain([0.0]).chain(panel.natural.iter().copied()),
        );
        frames.push(Frame::new(outer, &panel.axes, [x, y]));
    }
    align_left(&mut frames, 1);
    frames
}

fn shown(panel: &CampbellPanel) -> impl Iterator<Item = (f64, f64)> {
    let points = panel.orders.iter().flat_map(|order| &order.points);
    visible(&panel.axes, points.copied())
}

fn draw_panel(
    canvas: &mut Canvas,
    panel: &CampbellPanel,
    frame: &Frame,
    (styles, strokes, markers): (&[(&str, LineStyle)], &[Stroke], &[Marker]),
) {
    frame.draw(canvas);
    let title = Block::new(&panel.titled(), LABEL_SIZE, frame.area.width());
    let above = frame.area.top - GAP / 2.0 - 2.0;
    canvas.text(&title, frame.area.centre().0, above, Align::Centre);
    draw_natural(canvas, panel, frame);
    for order in &panel.orders {
        let stroke = strokes[place_among(&order.name, styles)];
        for piece in frame.curve(&order.points) {
            canvas.line(&piece, stroke);
        }
    }
    for order in panel.crossings.iter().filter(|_| !panel.is_dense()) {
        let marker = markers[place_among(&order.name, styles)];
        for pixel in order.points.iter().filter_map(|&point| frame.pixel(point)) {
            draw_marker(canvas, marker, pixel, MARKER_RADIUS);
        }
    }
}

/// Lines of natural frequencies, numbered where there is room.
fn draw_natural(canvas: &mut Canvas, panel: &CampbellPanel, frame: &Frame) {
    let Rect { left, right, .. } = frame.area;
    let left = if panel.is_dense() { right - TICK } else { left };
    let mut free_below = f64::INFINITY;
    for (index, &frequency) in panel.natural.iter().enumerate() {
        let Some(y) = frame.pixel_y(frequency) else {
            continue;
        };
        canvas.line(&[(left, y), (right, y)], NATURAL);
        if y <= free_below && !panel.is_dense() {
            let number = Block::new(&(index + 1).to_string(), SMALL_SIZE, NUMBERS);
            canvas.text(&number, right + GAP / 2.0, y, Align::Left);
            free_below = y - 1.2 * SMALL_SIZE;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    #[test]
    fn lines_are_numbered_only_where_there_is_room() {
        let series = |points| vec![Series::new("1×", points)];
        let panel = |natural: Vec<f64>| CampbellPanel {
            title: "Torsion".to_owned(),
            axes: ["Surface speed Ω (rpm)", "Frequency f (Hz)"].map(Axis::linear),
            crossings: series(natural.iter().map(|at| (60.0 * at, *at)).collect()),
            natural,
            orders: series(vec![(0.0, 0.0), (120.0, 2.0)]),
        };
        let dense = (1..=200).map(|index| 0.01 * f64::from(index)).collect();
        let panels = [panel(vec![0.4, 1.2]), panel(dense)];
        let picture = campbell(
            &Look::default(),
            "A string",
            ["natural frequency", "critical"],
            &panels,
        );
        assert_text_inside(&picture);
        // None in the dense panel, and one in the legend.
        assert_eq!(picture.svg().matches("<circle").count(), 2 + 1);
        let numbers = picture.svg().matches("<text").count();
        assert!((15..60).contains(&numbers), "{numbers}");
    }
}
