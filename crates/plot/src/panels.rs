//! Stacked panels of curves, such as time histories.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::BOUND;
use super::frame::{Frame, align_left};
use super::geometry::{Rect, thin};
use super::legend::{Key, Legend};
use super::line_styles::{LineStyle, Series, distinct_styles, place_among, strokes};
use super::look::{Look, is_narrow};
use super::numbers::in_two;
use super::overlaid::{Overlaid, overlaid};
use super::picture::Picture;
use super::references::{Across, Reference, draw_references, places};
use super::scale::{Axis, Scale, visible};
use super::shapes::{DASHES, Stroke};

const WIDTH: f64 = 900.0;
/// Height of a panel, as a part of the width of a narrow picture, and what it is between.
const PANEL_HEIGHTS: [f64; 2] = [170.0, 230.0];
const HEIGHT_PART: f64 = 0.46;
/// The part of it that a panel of differences has, where the picture is wide.
const SMALL_PART: f64 = 0.85;
const MARGIN: f64 = 14.0;
/// Distance between panels.
const PANEL_GAP: f64 = 12.0;
/// Distance between the plotting areas and the legend.
const LEGEND_GAP: f64 = 22.0;
/// Room for the half of a number below the right end of a narrow picture.
const LABEL_ROOM: f64 = 14.0;
/// Longer series are thinned.
const MOST_POINTS: usize = 4000;

const ALONE_WIDTH: f64 = 1.2;
/// Room for a name above the highest reference line, as a part of the range.
const NAME_ROOM: f64 = 0.13;

/// One of the stacked plots.
pub struct Panel {
    /// Horizontal and vertical axis; panels whose horizontal axes are alike share its range.
    pub axes: [Axis; 2],
    /// Curves.
    pub series: Vec<Series>,
    /// Reference lines; the axes are long enough to show them.
    pub references: Vec<Reference>,
    /// What curves may not pass; the vertical axis is long enough to show it.
    pub walls: Vec<Wall>,
    /// Whether it shows how the curves of another one differ: it is lower then.
    pub is_difference: bool,
}

/// A dashed line, with rings at the places where it is known.
pub struct Wall {
    /// Name in the legend; all have the first one's.
    pub name: String,
    /// The line.
    pub line: Vec<(f64, f64)>,
    /// Those places.
    pub known: Vec<(f64, f64)>,
}

const WALL: Stroke = Stroke {
    colour: BOUND,
    width: 1.2,
    dash: DASHES[1],
};
const KNOWN: Stroke = Stroke::solid(BOUND, 1.2);
const KNOWN_RADIUS: f64 = 3.5;

/// Draws stacked panels of the same width, top to bottom, with one title and one legend. Ends of
/// the horizontal axis are those of every panel with the first one's; ends of the vertical axis
/// those of every panel in the first one's unit, unless it shows differences.
pub fn panels(look: &Look, title: &str, panels: &[Panel]) -> Picture {
    let styles = distinct_styles(panels.iter().flat_map(|panel| &panel.series));
    let title = Title::new(look, title, WIDTH, MARGIN);
    let strokes = panel_strokes(panels, &styles);
    let top = title.bottom();
    let is_narrow = is_narrow(title.width);
    // Which curves are drawn once follows from the frames, and how wide these are from the legend.
    let full = legend(panels, &styles, &strokes, &vec![Vec::new(); panels.len()]);
    let right = if is_narrow {
        title.width - MARGIN - LABEL_ROOM
    } else {
        title.width - MARGIN - full.width() - LEGEND_GAP
    };
    let (frames, bottom) = frames(look, panels, top, [title.width, right]);
    let overlays: Vec<_> = (panels.iter().zip(&frames))
        .map(|(panel, frame)| overlaid(frame, &panel.series))
        .collect();
    let legend = legend(panels, &styles, &strokes, &overlays);
    let (legend, place, height) = if is_narrow {
        let legend = legend.in_rows(title.width - 2.0 * MARGIN);
        let height = bottom + legend.height() + MARGIN;
        (legend, (MARGIN, bottom), height)
    } else {
        let height = bottom.max(top + legend.height() + MARGIN);
        (legend, (right + LEGEND_GAP, top), height)
    };
    draw_titled(&title, height, |canvas| {
        for ((panel, frame), overlays) in panels.iter().zip(&frames).zip(&overlays) {
            let curves = Curves {
                styles: &styles,
                strokes: &strokes,
                overlays,
            };
            draw_panel(canvas, panel, frame, &curves);
        }
        legend.draw(canvas, place.0, place.1)
    })
}

/// A key for each curve; of one that is drawn in no panel, as it looks like another in each,
/// how far it is from that.
fn legend(
    panels: &[Panel],
    styles: &[(&str, LineStyle)],
    strokes: &[Stroke],
    overlays: &[Vec<Option<Overlaid>>],
) -> Legend {
    let mut entries: Vec<(Key, String)> = Vec::new();
    let mut merged = Vec::new();
    for ((name, _), stroke) in styles.iter().zip(strokes) {
        match nowhere_drawn(name, panels, overlays) {
            None => entries.push((Key::Line(*stroke), (*name).to_owned())),
            Some(words) => merged.push((Key::Nothing, words)),
        }
    }
    let wall = panels.iter().find_map(|panel| panel.walls.first());
    let wall = wall.map(|wall| (Key::Line(WALL), wall.name.clone()));
    entries.extend(wall.into_iter().chain(merged));
    let texts: Vec<String> = entries.iter().map(|(_, text)| text.clone()).collect();
    let keys = entries.into_iter().map(|(key, _)| key);
    Legend::new(keys.zip(texts.iter().map(String::as_str)))
}

/// The words for a curve that looks like another one in every panel; none where it is drawn.
fn nowhere_drawn(
    name: &str,
    panels: &[Panel],
    overlays: &[Vec<Option<Overlaid>>],
) -> Option<String> {
    let mut like: Option<&str> = None;
    let mut within: Vec<(&str, f64)> = Vec::new();
    for (panel, overlays) in panels.iter().zip(overlays) {
        let own = panel.series.iter().position(|series| series.name == name);
        let Some(own) = own else { continue };
        let overlay = overlays.get(own).copied().flatten()?;
        let other = panel.series[overlay.like].name.as_str();
        if like.is_some_and(|like| like != other) {
            return None;
        }
        like = Some(other);
        let unit = panel.axes[1].unit();
        match within.iter_mut().find(|(known, _)| *known == unit) {
            Some((_, difference)) => *difference = difference.max(overlay.difference),
            None => within.push((unit, overlay.difference)),
        }
    }
    let within: Vec<String> = (within.iter())
        .map(|(unit, difference)| {
            format!("{} {unit}", in_two(*difference))
                .trim_end()
                .to_owned()
        })
        .collect();
    Some(format!(
        "{name}: drawn as {}, within {}",
        like?,
        within.join(", ")
    ))
}

/// The looks of all series. One that is always alone needs no dashes, which would
/// hide a curve that swings fast.
fn panel_strokes(panels: &[Panel], styles: &[(&str, LineStyle)]) -> Vec<Stroke> {
    let shares = |name: &str| {
        let mut shared = panels.iter().filter(|panel| panel.series.len() > 1);
        shared.any(|panel| panel.series.iter().any(|series| series.name == name))
    };
    let strokes = strokes(styles).into_iter().enumerate();
    let strokes = strokes.map(|(index, stroke)| {
        if index == 0 || shares(styles[index].0) {
            stroke
        } else {
            Stroke::solid(stroke.colour, ALONE_WIDTH)
        }
    });
    strokes.collect()
}

/// The frames of all panels, one below another, their sides aligned, and where the last ends.
fn frames(look: &Look, panels: &[Panel], top: f64, [width, right]: [f64; 2]) -> (Vec<Frame>, f64) {
    let [low, high] = PANEL_HEIGHTS;
    let full = (HEIGHT_PART * width).clamp(low, high);
    let mut frames = Vec::new();
    let mut top = top;
    for panel in panels {
        let height = if panel.is_difference && !is_narrow(width) {
            SMALL_PART * full
        } else {
            full
        };
        let outer = Rect {
            left: MARGIN,
            top,
            right,
            bottom: top + height - PANEL_GAP,
        };
        let scales = [x_scale(look, panel, panels), y_scale(look, panel, panels)];
        frames.push(Frame::new(outer, &panel.axes, scales));
        top += height;
    }
    align_left(&mut frames, 1);
    (frames, top)
}

/// The scale of a horizontal axis, the same for all panels that share it.
fn x_scale(look: &Look, panel: &Panel, all: &[Panel]) -> Scale {
    let [axis, _] = &panel.axes;
    let sharing = all.iter().filter(|other| other.axes[0] == *axis);
    let values = sharing.flat_map(|other| {
        let shown = shown_points(other).map(|(x, _)| x);
        shown.chain(places(&other.references, Across::X))
    });
    let is_first = all.first().is_some_and(|first| first.axes[0] == *axis);
    let ends = look.ranges[0].filter(|_| is_first);
    Scale::with_ends(ends, axis.logarithmic, values)
}

/// A logarithmic axis ends at this fraction of the greatest value: smaller values do not matter,
/// and a hundred decades cannot be read.
const LOWEST: f64 = 1e-6;

fn y_scale(look: &Look, panel: &Panel, all: &[Panel]) -> Scale {
    let [_, axis] = &panel.axes;
    let lines = || places(&panel.references, Across::Y);
    let shown = shown_points(panel).map(|(_, y)| y);
    let walls = panel.walls.iter().flat_map(|wall| &wall.line);
    let walls = walls.map(|point| point.1);
    let mut values: Vec<f64> = shown.chain(lines()).chain(walls).collect();
    if !axis.logarithmic {
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let room = NAME_ROOM * (high - low);
        values.extend(lines().map(|line| line + room));
    } else {
        let highest = values.iter().copied().fold(0.0, f64::max);
        values.retain(|value| *value >= LOWEST * highest);
    }
    let is_first = (all.first()).is_some_and(|first| first.axes[1].unit() == axis.unit());
    let ends = look.ranges[1].filter(|_| is_first && !panel.is_difference);
    Scale::with_ends(ends, axis.logarithmic, values.into_iter())
}

fn shown_points(panel: &Panel) -> impl Iterator<Item = (f64, f64)> {
    let points = panel.series.iter().flat_map(|series| &series.points);
    visible(&panel.axes, points.copied())
}

/// How the curves of a panel are drawn.
struct Curves<'a> {
    /// Every name in the legend.
    styles: &'a [(&'a str, LineStyle)],
    /// How each of them is drawn.
    strokes: &'a [Stroke],
    /// Which curves lie on another, and are not drawn again.
    overlays: &'a [Option<Overlaid>],
}

fn draw_panel(canvas: &mut Canvas, panel: &Panel, frame: &Frame, drawn: &Curves) {
    frame.draw(canvas);
    for (series, overlay) in panel.series.iter().zip(drawn.overlays) {
        if overlay.is_none() {
            let stroke = drawn.strokes[place_among(&series.name, drawn.styles)];
            draw_series(canvas, frame, series, stroke);
        }
    }
    for wall in &panel.walls {
        draw_wall(canvas, frame, wall);
    }
    let curves = panel.series.iter();
    let curves = curves.flat_map(|series| frame.curve(&series.points));
    draw_references(canvas, frame, curves.collect(), &panel.references)
}

/// Within the frame, for it may continue beyond what is shown.
fn draw_wall(canvas: &mut Canvas, frame: &Frame, wall: &Wall) {
    for piece in frame.curve(&wall.line) {
        for part in frame.area.clip(&piece) {
            canvas.line(&part, WALL);
        }
    }
    let known = wall.known.iter().filter_map(|&point| frame.pixel(point));
    let shown = known.filter(|(x, _)| (frame.area.left..=frame.area.right).contains(x));
    for point in shown {
        canvas.ring(point, KNOWN_RADIUS, KNOWN);
    }
}

/// Within the frame, whose axes may be asked for.
fn draw_series(canvas: &mut Canvas, frame: &Frame, series: &Series, stroke: Stroke) {
    for piece in frame.curve(&series.points) {
        if let [point] = piece[..] {
            if frame.area.holds(point) {
                canvas.disc(point, stroke.width, stroke.colour);
            }
            continue;
        }
        let thinned = series.points.len() > MOST_POINTS;
        let piece = if thinned { thin(&piece) } else { piece };
        for part in frame.area.clip(&piece) {
            canvas.line(&part, stroke);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    fn panel(name: &str, points: Vec<(f64, f64)>, logarithmic: bool) -> Panel {
        let difference = "Difference in the angular speed of the bit (rad/s)";
        let mut axes = ["Time t (s)", difference].map(Axis::linear);
        axes[1].logarithmic = logarithmic;
        Panel {
            axes,
            series: vec![Series {
                name: name.to_string(),
                style: LineStyle::default(),
                points,
            }],
            references: [(Across::Y, 2.0, "set point"), (Across::X, 9.0, "onset")]
                .map(|(across, at, name)| Reference {
                    across,
                    at,
                    name: name.to_string(),
                })
                .into(),
            walls: Vec::new(),
            is_difference: false,
        }
    }

    fn draw(panels: Vec<Panel>) -> Picture {
        super::panels(&Look::default(), "Time histories", &panels)
    }

    #[test]
    fn long_series_keep_their_spike_in_a_small_file() {
        let spike = |i: u32| if i == 123_457 { 7.0 } else { f64::from(i % 2) };
        let points = (0..300_000).map(|i| (f64::from(i) * 1e-3, spike(i)));
        let picture = draw(vec![panel("a", points.collect(), false)]);
        let svg = picture.svg();
        assert!(svg.len() < 300_000);
        let curve = svg.lines().find(|line| line.contains("#0072B2"));
        let heights = curve
            .expect("the curve")
            .split([' ', '"'])
            .filter_map(|pair| {
                let (_, y) = pair.split_once(',')?;
                y.parse::<f64>().ok()
            });
        // The spike is far above everything else.
        let mut heights: Vec<_> = heights.collect();
        heights.sort_by(f64::total_cmp);
        assert!(heights[0] + 100.0 < heights[1]);
    }

    #[test]
    fn the_legend_names_each_series_once() {
        let points = vec![(0.0, 1.0), (1.0, 2.0)];
        let both = ["exact", "exact"].map(|name| panel(name, points.clone(), false));
        let picture = draw(both.into());
        assert_eq!(picture.svg().matches("exact").count(), 1);
        // A curve in each panel and the key in the legend.
        assert_eq!(picture.svg().matches("#0072B2").count(), 3);
    }

    #[test]
    fn only_a_curve_that_shares_its_panel_is_dashed() {
        let points = vec![(0.0, 1.0), (1.0, 2.0)];
        let mut both = panel("a", points.clone(), false);
        let other = vec![(0.0, 2.0), (1.0, 1.0)];
        both.series.extend(panel("b", other, false).series);
        both.references.clear();
        let mut difference = panel("a − b", points, false);
        difference.references.clear();
        let picture = draw(vec![both, difference]);
        // The second curve and its key.
        assert_eq!(picture.svg().matches("dasharray").count(), 2);
    }

    #[test]
    fn a_wall_is_seen_however_far_it_is_and_ringed_where_it_is_known() {
        let mut panel = panel("a", vec![(0.0, 1.0), (1.0, 2.0)], false);
        panel.references.clear();
        let line = vec![(0.0, 9.0), (0.4, 9.0), (0.8, 12.0), (5.0, 12.0)];
        let known = line[1..].to_vec();
        panel.walls = vec![Wall {
            name: "wall, with rings".to_owned(),
            line,
            known,
        }];
        assert_eq!(
            y_scale(&Look::default(), &panel, &[])
                .fraction(12.0)
                .map(|at| at <= 1.0),
            Some(true)
        );
        let picture = draw(vec![panel]);
        assert_text_inside(&picture);
        // The third place is beyond the right end.
        assert_eq!(picture.svg().matches("<circle").count(), 2);
        assert!(picture.svg().contains("wall, with rings"));
    }

    #[test]
    fn a_logarithmic_axis_skips_what_is_not_positive() {
        let points = vec![(0.0, 1.0), (1.0, 0.0), (2.0, -3.0), (3.0, 4.0)];
        let picture = draw(vec![panel("a", points, true)]);
        assert_eq!(picture.svg().matches("<circle").count(), 2);
        assert_text_inside(&picture);
    }

    #[test]
    fn empty_panels_are_drawn() {
        assert_text_inside(&draw(Vec::new()));
        assert_text_inside(&draw(vec![panel("a", Vec::new(), false)]));
    }

    #[test]
    fn the_same_data_give_the_same_bytes() {
        let picture = || draw(vec![panel("a", vec![(0.0, 1.0), (1.0, 2.0)], false)]);
        let (first, second) = (picture(), picture());
        assert!(first == second && first.png().ok() == second.png().ok());
    }
}
