//! Stacked panels of curves, such as time histories.

use super::canvas::{Canvas, DASHES, Stroke, Title, draw_titled};
use super::colours::{CLEARANCE, COLOURS};
use super::frame::{Frame, align_left};
use super::geometry::{Rect, thin};
use super::legend::{Key, Legend, Series, distinct, place_of};
use super::picture::Picture;
use super::references::{Across, Reference, draw_references, places};
use super::scale::{Axis, Scale, visible};
use anyhow::Result;

const WIDTH: f64 = 900.0;
const PANEL_HEIGHT: f64 = 230.0;
const MARGIN: f64 = 14.0;
/// Distance between panels.
const PANEL_GAP: f64 = 12.0;
/// Distance between the plotting areas and the legend.
const LEGEND_GAP: f64 = 22.0;
/// Longer series are thinned.
const MOST_POINTS: usize = 4000;

const FIRST_WIDTH: f64 = 2.4;
const LATER_WIDTH: f64 = 1.8;
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
}

/// A dashed line, with rings at the places where it is known.
pub struct Wall {
    /// The line.
    pub line: Vec<(f64, f64)>,
    /// Those places.
    pub known: Vec<(f64, f64)>,
}

const WALL: Stroke = Stroke {
    colour: CLEARANCE,
    width: 1.2,
    dash: DASHES[1],
};
const KNOWN: Stroke = Stroke::solid(CLEARANCE, 1.2);
const KNOWN_RADIUS: f64 = 3.5;

/// Draws stacked panels of the same width, top to bottom, with one title and one legend.
pub fn panels(title: &str, panels: &[Panel]) -> Result<Picture> {
    let series = panels.iter().flat_map(|panel| &panel.series);
    let names = distinct(series.map(|series| &series.name));
    let title = Title::new(title, WIDTH, MARGIN)?;
    let strokes = strokes(panels, &names);
    let keys = strokes.iter().map(|&stroke| Key::Line(stroke));
    let has_wall = panels.iter().any(|panel| !panel.walls.is_empty());
    let wall = has_wall.then_some((Key::Line(WALL), "clearance, sites as rings"));
    let legend = Legend::new(keys.zip(names.iter().copied()).chain(wall))?;
    let top = title.bottom();
    let stacked = panels.len() as f64 * PANEL_HEIGHT;
    let height = top + stacked.max(legend.height() + MARGIN);
    let legend_left = WIDTH - MARGIN - legend.width();
    let frames = frames(panels, top, legend_left - LEGEND_GAP)?;
    draw_titled(&title, height, |canvas| {
        for (panel, frame) in panels.iter().zip(&frames) {
            draw_panel(canvas, panel, frame, (&names, &strokes))?;
        }
        legend.draw(canvas, legend_left, top)
    })
}

/// The looks of all series. One that is always alone needs no dashes, which would
/// hide a curve that swings fast.
fn strokes(panels: &[Panel], names: &[&str]) -> Vec<Stroke> {
    let shares = |name: &str| {
        let mut shared = panels.iter().filter(|panel| panel.series.len() > 1);
        shared.any(|panel| panel.series.iter().any(|series| series.name == name))
    };
    let strokes = names.iter().enumerate().map(|(index, name)| {
        let stroke = series_stroke(index);
        if index == 0 || shares(name) {
            stroke
        } else {
            Stroke::solid(stroke.colour, ALONE_WIDTH)
        }
    });
    strokes.collect()
}

/// The look of the series with the name of this index. Only the first is
/// solid: where series coincide, it shows between the dashes of the others.
pub(super) fn series_stroke(index: usize) -> Stroke {
    let dash = match index {
        0 => DASHES[0],
        later => DASHES[1 + (later - 1) % (DASHES.len() - 1)],
    };
    Stroke {
        colour: COLOURS[index % COLOURS.len()],
        width: if index == 0 { FIRST_WIDTH } else { LATER_WIDTH },
        dash,
    }
}

/// The frames of all panels, one below another, their sides aligned.
fn frames(panels: &[Panel], top: f64, right: f64) -> Result<Vec<Frame>> {
    let mut frames = Vec::new();
    for (index, panel) in panels.iter().enumerate() {
        let top = top + index as f64 * PANEL_HEIGHT;
        let outer = Rect {
            left: MARGIN,
            top,
            right,
            bottom: top + PANEL_HEIGHT - PANEL_GAP,
        };
        let scales = [x_scale(panel, panels), y_scale(panel)];
        frames.push(Frame::new(outer, &panel.axes, scales)?);
    }
    align_left(&mut frames, 1);
    Ok(frames)
}

/// The scale of a horizontal axis, the same for all panels that share it.
fn x_scale(panel: &Panel, all: &[Panel]) -> Scale {
    let [axis, _] = &panel.axes;
    let sharing = all.iter().filter(|other| other.axes[0] == *axis);
    let values = sharing.flat_map(|other| {
        let shown = shown_points(other).map(|(x, _)| x);
        shown.chain(places(&other.references, Across::X))
    });
    Scale::new(axis.logarithmic, values)
}

fn y_scale(panel: &Panel) -> Scale {
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
    }
    Scale::new(axis.logarithmic, values.into_iter())
}

fn shown_points(panel: &Panel) -> impl Iterator<Item = (f64, f64)> {
    let points = panel.series.iter().flat_map(|series| &series.points);
    visible(&panel.axes, points.copied())
}

fn draw_panel(
    canvas: &mut Canvas,
    panel: &Panel,
    frame: &Frame,
    (names, strokes): (&[&str], &[Stroke]),
) -> Result<()> {
    frame.draw(canvas)?;
    for series in &panel.series {
        let stroke = strokes[place_of(&series.name, names)];
        draw_series(canvas, frame, series, stroke)?;
    }
    for wall in &panel.walls {
        draw_wall(canvas, frame, wall)?;
    }
    let curves = panel.series.iter();
    let curves = curves.flat_map(|series| frame.curve(&series.points));
    draw_references(canvas, frame, curves.collect(), &panel.references)
}

/// Within the frame, for it may go on beyond what is shown.
fn draw_wall(canvas: &mut Canvas, frame: &Frame, wall: &Wall) -> Result<()> {
    for piece in frame.curve(&wall.line) {
        for part in frame.area.clip(&piece) {
            canvas.line(&part, WALL)?;
        }
    }
    let known = wall.known.iter().filter_map(|&point| frame.pixel(point));
    let shown = known.filter(|(x, _)| (frame.area.left..=frame.area.right).contains(x));
    for point in shown {
        canvas.ring(point, KNOWN_RADIUS, KNOWN)?;
    }
    Ok(())
}

fn draw_series(canvas: &mut Canvas, frame: &Frame, series: &Series, stroke: Stroke) -> Result<()> {
    for piece in frame.curve(&series.points) {
        if let [point] = piece[..] {
            canvas.disc(point, stroke.width, stroke.colour)?;
        } else if series.points.len() > MOST_POINTS {
            canvas.line(&thin(&piece), stroke)?;
        } else {
            canvas.line(&piece, stroke)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::canvas::tests::assert_text_inside;
    use super::*;

    fn panel(name: &str, points: Vec<(f64, f64)>, logarithmic: bool) -> Panel {
        let difference = "Difference in the angular speed of the bit (rad/s)";
        let mut axes = ["Time t (s)", difference].map(Axis::linear);
        axes[1].logarithmic = logarithmic;
        Panel {
            axes,
            series: vec![Series {
                name: name.to_string(),
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
        }
    }

    fn draw(panels: Vec<Panel>) -> Picture {
        super::panels("Time histories", &panels).expect("drawn")
    }

    #[test]
    fn long_series_keep_their_spike_in_a_small_file() {
        let spike = |i: u32| if i == 123_457 { 7.0 } else { f64::from(i % 2) };
        let points = (0..300_000).map(|i| (f64::from(i) * 1e-3, spike(i)));
        let picture = draw(vec![panel("a", points.collect(), false)]);
        assert!(picture.svg.len() < 300_000);
        let curve = picture.svg.lines().find(|line| line.contains("#0072B2"));
        let heights = curve
            .expect("the curve")
            .split([' ', '"'])
            .filter_map(|pair| {
                let (_, y) = pair.split_once(',')?;
                y.parse::<i32>().ok()
            });
        // The spike is far above everything else.
        let mut heights: Vec<_> = heights.collect();
        heights.sort_unstable();
        assert!(heights[0] + 1000 < heights[1]);
    }

    #[test]
    fn the_legend_names_each_series_once() {
        let points = vec![(0.0, 1.0), (1.0, 2.0)];
        let both = ["exact", "exact"].map(|name| panel(name, points.clone(), false));
        let picture = draw(both.into());
        assert_eq!(picture.svg.matches("exact").count(), 1);
        // A curve in each panel and the key in the legend.
        assert_eq!(picture.svg.matches("#0072B2").count(), 3);
    }

    #[test]
    fn only_a_curve_that_shares_its_panel_is_dashed() {
        let points = vec![(0.0, 1.0), (1.0, 2.0)];
        let mut both = panel("a", points.clone(), false);
        both.series.extend(panel("b", points.clone(), false).series);
        both.references.clear();
        let mut difference = panel("a − b", points, false);
        difference.references.clear();
        let picture = draw(vec![both, difference]);
        // The second curve and its key.
        assert_eq!(picture.svg.matches("dasharray").count(), 2);
    }

    #[test]
    fn a_wall_is_seen_however_far_it_is_and_ringed_where_it_is_known() {
        let mut panel = panel("a", vec![(0.0, 1.0), (1.0, 2.0)], false);
        panel.references.clear();
        let line = vec![(0.0, 9.0), (0.4, 9.0), (0.8, 12.0), (5.0, 12.0)];
        let known = line[1..].to_vec();
        panel.walls = vec![Wall { line, known }];
        assert_eq!(
            y_scale(&panel).fraction(12.0).map(|at| at <= 1.0),
            Some(true)
        );
        let picture = draw(vec![panel]);
        assert_text_inside(&picture);
        // The third place is beyond the right end.
        assert_eq!(picture.svg.matches("<circle").count(), 2);
        assert!(picture.svg.contains("clearance, sites as"));
    }

    #[test]
    fn a_logarithmic_axis_skips_what_is_not_positive() {
        let points = vec![(0.0, 1.0), (1.0, 0.0), (2.0, -3.0), (3.0, 4.0)];
        let picture = draw(vec![panel("a", points, true)]);
        assert_eq!(picture.svg.matches("<circle").count(), 2);
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
        assert!(first.svg == second.svg && first.png == second.png);
    }
}
