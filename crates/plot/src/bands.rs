//! Bands over time, one for each row of a panel: a bar is the darker the larger its value, and
//! its height shows of what kind it is. Panels stand one below another.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::BANDS;
use super::frame::{Frame, align_left};
use super::geometry::Rect;
use super::legend::{Key, Legend};
use super::lettering::Align;
use super::look::{Look, is_narrow};
use super::numbers::{linear_label, nice_step, power};
use super::picture::Picture;
use super::scale::{Axis, Scale};
use super::text::{Block, LABEL_SIZE};

/// The most bars side by side that all have their own pixel.
pub const COLUMNS: usize = 500;

const WIDTH: f64 = 1000.0;
const MARGIN: f64 = 14.0;
/// Distance between the plotting areas and the legend.
const LEGEND_GAP: f64 = 22.0;
/// Room for the half of a number below the right end of a narrow picture.
const LABEL_ROOM: f64 = 14.0;
/// Height of a row where there is room, and what that of all rows of a panel is between.
const ROW_HEIGHT: f64 = 26.0;
const HEIGHTS: [f64; 2] = [60.0, 600.0];
/// The areas of all panels are no higher than this, unless each is as low as it may be.
const ALL_HEIGHTS: f64 = 2400.0;
/// What a panel has above its area for its title, and below it for its axis.
const TITLE_HEIGHT: f64 = 28.0;
const AXIS_HEIGHT: f64 = 62.0;
/// The part of a row above and below its band.
const ROW_GAP: f64 = 0.12;
/// The part of a band that a low bar fills.
const LOW: f64 = 0.45;
/// Raster pixels per pixel of the picture, where it is not in vectors.
const FINER: f64 = 2.0;

/// A stretch of a band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bar {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// How dark it is.
    pub value: f64,
    /// Whether it fills the height of the band.
    pub is_full: bool,
}

/// Bands one below another.
pub struct BandPanel {
    /// Title above it.
    pub title: String,
    /// The bars of each row, from left to right.
    pub rows: Vec<Vec<Bar>>,
}

/// Panels with the same rows and axes.
pub struct BandChart {
    /// Title above all.
    pub title: String,
    /// The horizontal axis, and the vertical one along which rows have names.
    pub axes: [Axis; 2],
    /// Both ends of the horizontal axis.
    pub ends: [f64; 2],
    /// Names of the rows, from top to bottom.
    pub rows: Vec<String>,
    /// Unit of the values.
    pub unit: String,
    /// What a full bar and a low one mean.
    pub kinds: [String; 2],
    /// What else is to be said, below the legend.
    pub notes: Vec<String>,
    /// The panels.
    pub panels: Vec<BandPanel>,
}

/// Draws a chart of bands.
///
/// Which sites touch the wall when, and how hard.
///
/// ```
/// use plot::{Axis, BandChart, BandPanel, Bar, Look, band_chart};
///
/// let bar = |from: f64, to: f64, value: f64, is_full: bool| Bar { from, to, value, is_full };
/// let panel = BandPanel {
///     title: "20 rpm".to_owned(),
///     rows: vec![vec![bar(1.0, 2.0, 3.0, false)], vec![bar(1.5, 5.0, 9.0, true)]],
/// };
/// let chart = BandChart {
///     title: "Contact".to_owned(),
///     axes: ["Time t (s)", "Site"].map(Axis::linear),
///     ends: [0.0, 5.0],
///     rows: vec!["the bit".to_owned(), "10 m above".to_owned()],
///     unit: "kN".to_owned(),
///     kinds: ["rolling".to_owned(), "sliding".to_owned()],
///     notes: Vec::new(),
///     panels: vec![panel],
/// };
/// let svg = band_chart(&Look::default(), &chart).svg();
/// assert!(svg.contains("10 m above") && svg.contains("sliding"));
/// ```
pub fn band_chart(look: &Look, chart: &BandChart) -> Picture {
    let title = Title::new(look, &chart.title, WIDTH, MARGIN);
    let classes = Classes::of(chart);
    let legend = legend(chart, &classes);
    let top = title.bottom();
    let height = panel_height(chart);
    let stacked = chart.panels.len() as f64 * height;
    let (legend, place, right, bottom) = if is_narrow(title.width) {
        let legend = legend.in_rows(title.width - 2.0 * MARGIN);
        let (right, below) = (title.width - MARGIN - LABEL_ROOM, top + stacked);
        let bottom = below + legend.height();
        (legend, (MARGIN, below), right, bottom)
    } else {
        let left = title.width - MARGIN - legend.width();
        let bottom = top + stacked.max(legend.height());
        (legend, (left, top), left - LEGEND_GAP, bottom)
    };
    let frames = frames(look, chart, [top, height], right);
    draw_titled(&title, bottom + MARGIN, |canvas| {
        for (panel, frame) in chart.panels.iter().zip(&frames) {
            draw_panel(canvas, panel, frame, &classes);
        }
        legend.draw(canvas, place.0, place.1)
    })
}

/// Height of a panel with its title and its axis.
fn panel_height(chart: &BandChart) -> f64 {
    let [low, high] = HEIGHTS;
    let share = ALL_HEIGHTS / chart.panels.len().max(1) as f64;
    let rows = ROW_HEIGHT * chart.rows.len() as f64;
    TITLE_HEIGHT + rows.min(share).clamp(low, high) + AXIS_HEIGHT
}

fn frames(look: &Look, chart: &BandChart, [top, height]: [f64; 2], right: f64) -> Vec<Frame> {
    let x = Scale::with_ends(
        look.ranges[0],
        chart.axes[0].logarithmic,
        chart.ends.into_iter(),
    );
    let mut frames = Vec::with_capacity(chart.panels.len());
    for index in 0..chart.panels.len() {
        let top = top + index as f64 * height;
        let outer = Rect {
            left: MARGIN,
            top: top + TITLE_HEIGHT,
            right,
            bottom: top + height,
        };
        frames.push(Frame::of_rows(outer, &chart.axes, x, &chart.rows));
    }
    align_left(&mut frames, 1);
    frames
}

fn draw_panel(canvas: &mut Canvas, panel: &BandPanel, frame: &Frame, classes: &Classes) {
    frame.draw(canvas);
    let title = Block::new(&panel.title, LABEL_SIZE, frame.area.width());
    let above = frame.area.top - 0.5 * TITLE_HEIGHT;
    canvas.text(&title, frame.area.centre().0, above, Align::Centre);
    let count = panel.rows.len();
    for (row, bars) in panel.rows.iter().enumerate() {
        let below = (count - 1 - row) as f64;
        let edges = [below + 1.0 - ROW_GAP, below + LOW, below + ROW_GAP];
        let Some([high, low, bottom]) = along(edges, |edge| frame.pixel_y(edge)) else {
            continue;
        };
        for bar in joined(bars, classes) {
            let Some(ends) = along([bar.from, bar.to], |edge| frame.pixel_x(edge)) else {
                continue;
            };
            let Rect { left, right, .. } = frame.area;
            let [left, right] = ends.map(|end| end.clamp(left, right));
            if left == right {
                continue;
            }
            let top = if bar.is_full { high } else { low };
            let area = Rect {
                left,
                top,
                right,
                bottom,
            };
            canvas.polygon(&area.corners(), BANDS[classes.of_value(bar.value)]);
        }
    }
}

/// Pixels of places, each whole in the finer picture, so that neighbours meet without a seam.
fn along<const N: usize>(places: [f64; N], pixel: impl Fn(f64) -> Option<f64>) -> Option<[f64; N]> {
    let mut pixels = [0.0; N];
    for (found, place) in pixels.iter_mut().zip(places) {
        *found = (FINER * pixel(place)?).round() / FINER;
    }
    Some(pixels)
}

/// Bars that look alike, joined where they meet.
fn joined(bars: &[Bar], classes: &Classes) -> Vec<Bar> {
    let mut found: Vec<Bar> = Vec::new();
    for bar in bars {
        match found.last_mut() {
            Some(last)
                if last.to == bar.from
                    && last.is_full == bar.is_full
                    && classes.of_value(last.value) == classes.of_value(bar.value) =>
            {
                last.to = bar.to;
            }
            _ => found.push(*bar),
        }
    }
    found
}

/// Classes of values by round upper ends, in ascending order: each about twice as large as the
/// one before, up to the largest value. Without values there are none.
struct Classes {
    /// Digit and power of ten of each upper end.
    ends: Vec<(i32, i32)>,
}

impl Classes {
    fn of(chart: &BandChart) -> Self {
        let rows = chart.panels.iter().flat_map(|panel| &panel.rows);
        let values = rows.flatten().map(|bar| bar.value);
        Self::up_to(values.fold(0.0, f64::max))
    }

    fn up_to(largest: f64) -> Self {
        let mut ends = Vec::new();
        if largest > 0.0 {
            let mut end = nice_step(largest);
            for _ in BANDS {
                ends.push(end);
                end = match end {
                    (5, exponent) => (2, exponent),
                    (2, exponent) => (1, exponent),
                    (_, exponent) => (5, exponent - 1),
                };
            }
            ends.reverse();
        }
        Self { ends }
    }

    fn of_value(&self, value: f64) -> usize {
        let passed = |(digit, exponent): &&(i32, i32)| value > power(*digit, *exponent);
        let passed = self.ends.iter().filter(passed).count();
        passed.min(BANDS.len() - 1)
    }

    /// The classes in words, in descending order.
    fn texts(&self, unit: &str) -> Vec<String> {
        let label = |&(digit, exponent): &(i32, i32)| {
            let end = power(digit, exponent);
            linear_label(end, end, exponent)
        };
        let labels: Vec<String> = self.ends.iter().map(label).collect();
        let from = |class: usize| match class {
            0 => String::new(),
            _ => format!("over {} ", labels[class - 1]),
        };
        let texts = labels.iter().enumerate();
        let texts = texts.map(|(class, end)| format!("{}to {end} {unit}", from(class)));
        texts.rev().collect()
    }
}

fn legend(chart: &BandChart, classes: &Classes) -> Legend {
    let texts = classes.texts(&chart.unit);
    let colours = BANDS.iter().rev().map(|&colour| Key::Bar(colour, 1.0));
    let middle = BANDS[BANDS.len() / 2];
    let kinds = [1.0, LOW].map(|part| Key::Bar(middle, part));
    let entries = (colours.zip(texts.iter().map(String::as_str)))
        .chain(
            kinds
                .into_iter()
                .zip(chart.kinds.iter().map(String::as_str)),
        )
        .chain(chart.notes.iter().map(|note| (Key::Nothing, note.as_str())));
    Legend::new(entries)
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    fn bar(from: f64, value: f64, is_full: bool) -> Bar {
        Bar {
            from,
            to: from + 1.0,
            value,
            is_full,
        }
    }

    fn chart(rows: usize, panels: usize, bars: &[Bar]) -> BandChart {
        let panel = |index: usize| BandPanel {
            title: format!("quadrature, case {index}"),
            rows: vec![bars.to_vec(); rows],
        };
        BandChart {
            title: "Contact with the wall".to_owned(),
            axes: ["Time t (s)", "Site, above the bit (m)"].map(Axis::linear),
            ends: [0.0, 10.0],
            rows: (0..rows).rev().map(|row| format!("{}", 30 * row)).collect(),
            unit: "kN".to_owned(),
            kinds: ["full height: rolling", "lower half: sliding"].map(str::to_owned),
            notes: vec!["empty: no contact".to_owned()],
            panels: (0..panels).map(panel).collect(),
        }
    }

    #[test]
    fn classes_are_round_and_hold_their_upper_ends() {
        let classes = Classes::up_to(37.0);
        let texts = classes.texts("kN");
        assert_eq!(texts[0], "over 20 to 50 kN");
        assert_eq!(texts[4], "to 2 kN");
        let found = [0.1, 2.0, 2.1, 5.0, 19.0, 20.1, 37.0].map(|value| classes.of_value(value));
        assert_eq!(found, [0, 0, 1, 1, 3, 4, 4]);
        assert_eq!(Classes::up_to(0.7).texts("klbf")[0], "over 0.5 to 1 klbf");
        assert!(Classes::up_to(0.0).texts("kN").is_empty());
        assert_eq!(Classes::up_to(0.0).of_value(0.0), 0);
    }

    #[test]
    fn bars_that_look_alike_are_one() {
        let classes = Classes::up_to(40.0);
        let bars = [
            bar(0.0, 30.0, true),
            bar(1.0, 40.0, true),
            bar(2.0, 40.0, false),
            bar(3.0, 1.0, false),
            bar(5.0, 1.0, false),
        ];
        let ends: Vec<f64> = joined(&bars, &classes).iter().map(|bar| bar.to).collect();
        assert_eq!(ends, [2.0, 3.0, 4.0, 6.0]);
    }

    /// However many rows there are, each has its band and no label overlaps another.
    #[test]
    fn every_row_has_a_band_and_labels_keep_their_distance() {
        let bars = [bar(0.0, 30.0, true), bar(8.0, 3.0, false)];
        let keys = 7;
        for (rows, panels) in [(1, 1), (3, 2), (40, 1), (300, 2)] {
            let chart = chart(rows, panels, &bars);
            let picture = band_chart(&Look::default(), &chart);
            assert_text_inside(&picture);
            let polygons = picture.svg().matches("<polygon").count();
            assert_eq!(polygons, 2 * rows * panels + keys, "{rows} {panels}");
            let frame = &frames(&Look::default(), &chart, [0.0, panel_height(&chart)], 700.0)[0];
            let written =
                (0..rows).filter(|row| picture.svg().contains(&format!(">{}</text>", 30 * row)));
            let room = frame.area.height() / written.count() as f64;
            assert!(rows == 1 || room > 14.0, "{rows}: {room}");
        }
    }

    /// At 300 rows in a panel there is still a whole pixel of the finer picture between the
    /// heights of a full bar and a low one.
    #[test]
    fn a_low_bar_is_lower_however_many_rows_there_are() {
        let chart = chart(300, 1, &[]);
        let frame = &frames(&Look::default(), &chart, [0.0, panel_height(&chart)], 700.0)[0];
        for row in 0..300 {
            let edges = [1.0 - ROW_GAP, LOW, ROW_GAP].map(|edge| f64::from(row) + edge);
            let [high, low, bottom] = along(edges, |edge| frame.pixel_y(edge)).expect("seen");
            assert!(
                low - high >= 0.5 && bottom > low,
                "{row}: {high} {low} {bottom}"
            );
        }
    }

    #[test]
    fn a_chart_without_a_bar_is_drawn_and_the_same_data_give_the_same_bytes() {
        assert_text_inside(&band_chart(&Look::default(), &chart(2, 1, &[])));
        let draw = || band_chart(&Look::default(), &chart(3, 1, &[bar(1.0, 2.0, true)]));
        let (first, second) = (draw(), draw());
        assert!(first == second && first.png().ok() == second.png().ok());
    }
}
