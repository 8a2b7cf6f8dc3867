//! Orbits: curves in a plane, side by side, each with the circles it may not leave where it comes
//! near those. Paths across a hole have the same scale both ways, those in a plane of phases not.

use super::canvas::{Canvas, Title, draw_titled};
use super::colours::{BLACK, BOUND, Colour};
use super::frame::Frame;
use super::geometry::{Pixel, Rect};
use super::legend::{Key, Legend};
use super::line_styles::{LineStyle, Series, distinct_styles, place_among, strokes};
use super::look::Look;
use super::picture::Picture;
use super::scale::{Axis, Scale};
use super::shapes::{DASHES, Stroke};

const MARGIN: f64 = 14.0;
/// Side of the square each orbit is drawn in, its labels included.
const SIDE: f64 = 420.0;
/// The least that it may be in a picture that has no room for all side by side.
const LEAST_SIDE: f64 = 280.0;
/// Distance between the last row and a legend below.
const ROW_GAP: f64 = 8.0;
/// Distance between the plotting areas and the legend.
const LEGEND_GAP: f64 = 22.0;
/// Distance between an orbit and the next one's labels.
const ORBIT_GAP: f64 = 18.0;
/// Corners of a circle that looks round.
const CIRCLE_CORNERS: usize = 180;
const CIRCLE: Stroke = Stroke {
    colour: BOUND,
    width: 1.2,
    dash: DASHES[1],
};
/// What marks the last points, in the legend.
const LAST: Stroke = Stroke::solid(BLACK, 1.8);
/// Length of an arrow head, how many there are at most on a path, and how far apart at most.
const ARROW: f64 = 11.0;
const ARROWS: usize = 3;
const MOST_APART: f64 = 260.0;

/// One orbit, seen along the axis it goes around, or in a plane of phases.
pub struct Orbit {
    /// Horizontal and vertical axis.
    pub axes: [Axis; 2],
    /// Whether both have the same unit, and so one scale around the origin.
    pub has_one_scale: bool,
    /// Curves.
    pub series: Vec<Series>,
    /// Radii of dashed circles around the origin.
    pub circles: Vec<f64>,
    /// How many points of each curve, the last ones, are marked.
    pub last: Vec<usize>,
}

/// Draws orbits side by side, in rows where the picture has no room for all, with one title and
/// one legend, which says what circles and marked ends are.
///
/// A centre that goes round along the wall of its hole.
///
/// ```
/// use plot::{Axis, Look, Orbit, Series, orbits};
///
/// let angles = (0..100).map(|index| 0.1 * f64::from(index));
/// let path = angles.map(|angle| (20.0 * angle.cos(), 20.0 * angle.sin()));
/// let orbit = Orbit {
///     axes: ["x (mm)", "y (mm)"].map(Axis::linear),
///     series: vec![Series::new("the bit", path.collect())],
///     circles: vec![20.0],
///     last: vec![10],
///     has_one_scale: true,
/// };
/// let picture = orbits(&Look::default(), "Whirl", ["clearance", "the end"], &[orbit]);
/// assert!(picture.svg().contains("clearance"));
/// ```
pub fn orbits(
    look: &Look,
    title: &str,
    [circle_words, last_words]: [&str; 2],
    orbits: &[Orbit],
) -> Picture {
    let styles = distinct_styles(orbits.iter().flat_map(|orbit| &orbit.series));
    let strokes = strokes(&styles);
    let curves = styles.iter().zip(&strokes);
    let curves = curves.map(|((name, _), stroke)| (Key::Line(on_orbit(*stroke)), *name));
    let has_circle = orbits.iter().any(|orbit| !orbit.circles.is_empty());
    let circle = has_circle.then_some((Key::Line(CIRCLE), circle_words));
    let has_last = orbits.iter().any(|orbit| !orbit.last.is_empty());
    let last = has_last.then_some((Key::Line(LAST), last_words));
    let legend = Legend::new(curves.chain(circle).chain(last));
    let in_one_row = MARGIN + orbits.len() as f64 * SIDE + LEGEND_GAP + legend.width() + MARGIN;
    let title = Title::new(look, title, in_one_row, MARGIN);
    let columns = if title.width < in_one_row {
        (((title.width - 2.0 * MARGIN) / LEAST_SIDE) as usize).clamp(1, orbits.len().max(1))
    } else {
        orbits.len().max(1)
    };
    let top = title.bottom();
    let (side, legend, place) = if title.width < in_one_row {
        let side = ((title.width - 2.0 * MARGIN) / columns as f64).min(SIDE);
        let rows = orbits.len().div_ceil(columns) as f64;
        let legend = legend.in_rows(title.width - 2.0 * MARGIN);
        (side, legend, (MARGIN, top + rows * side + ROW_GAP))
    } else {
        let left = title.width - MARGIN - legend.width();
        (SIDE, legend, (left, top))
    };
    let rows = orbits.len().div_ceil(columns) as f64;
    let height = (top + rows * side).max(place.1 + legend.height()) + MARGIN;
    let gap = 0.5 * (title.width.min(in_one_row) - 2.0 * MARGIN - columns as f64 * side);
    let left = if title.width < in_one_row {
        MARGIN + gap
    } else {
        MARGIN
    };
    draw_titled(&title, height, |canvas| {
        for (index, orbit) in orbits.iter().enumerate() {
            let left = left + (index % columns) as f64 * side;
            let top = top + (index / columns) as f64 * side;
            let outer = Rect {
                left,
                top,
                right: left + side - ORBIT_GAP,
                bottom: top + side,
            };
            draw_orbit(canvas, orbit, outer, (&styles, &strokes));
        }
        legend.draw(canvas, place.0, place.1)
    })
}

/// A path goes over itself many times: it is thin.
fn on_orbit(stroke: Stroke) -> Stroke {
    Stroke {
        width: 1.2,
        ..stroke
    }
}

fn draw_orbit(
    canvas: &mut Canvas,
    orbit: &Orbit,
    outer: Rect,
    (styles, strokes): (&[(&str, LineStyle)], &[Stroke]),
) {
    let mut frame = Frame::new(outer, &orbit.axes, scales(orbit));
    let side = frame.area.width().min(frame.area.height());
    frame.area.right = frame.area.left + side;
    frame.area.top = frame.area.bottom - side;
    frame.draw(canvas);
    for radius in &orbit.circles {
        for piece in frame.curve(&circle(*radius)) {
            canvas.line(&piece, CIRCLE);
        }
    }
    let curves = orbit.series.iter().enumerate().map(|(index, series)| {
        let stroke = on_orbit(strokes[place_among(&series.name, styles)]);
        let last = orbit.last.get(index).copied().unwrap_or(0);
        (series, stroke, series.points.len().saturating_sub(last))
    });
    for (series, stroke, begins) in curves.clone() {
        let is_marked = begins < series.points.len();
        let colour = if is_marked {
            faint(stroke.colour)
        } else {
            stroke.colour
        };
        let before = series.points.len().min(begins + 1);
        for piece in frame.curve(&series.points[..before]) {
            canvas.line(&piece, Stroke { colour, ..stroke });
        }
    }
    for (series, stroke, begins) in curves {
        let end = frame.curve(&series.points[begins..]);
        for piece in &end {
            canvas.line(
                piece,
                Stroke {
                    width: 1.8,
                    ..stroke
                },
            );
        }
        draw_arrows(canvas, &end.concat(), stroke.colour);
    }
}

/// The colour of what was before the last points.
fn faint(Colour(red, green, blue): Colour) -> Colour {
    let [red, green, blue] = [red, green, blue].map(|part| 255 - (255 - part) / 5 * 2);
    Colour(red, green, blue)
}

/// Arrow heads along the end of a path, where it is long enough to see which way it goes.
fn draw_arrows(canvas: &mut Canvas, path: &[Pixel], colour: Colour) {
    let steps = path
        .windows(2)
        .map(|side| (side[1].0 - side[0].0).hypot(side[1].1 - side[0].1));
    let length: f64 = steps.clone().sum();
    // A path of a few pixels, of what rests, has no direction that can be seen.
    if length < 4.0 * ARROW {
        return;
    }
    let each = (length / ARROWS as f64).min(MOST_APART);
    let mut next = 0.5 * each;
    let (mut gone, mut drawn) = (0.0, 0);
    for (side, step) in path.windows(2).zip(steps) {
        gone += step;
        if gone < next || step == 0.0 || drawn == ARROWS {
            continue;
        }
        let along = (
            (side[1].0 - side[0].0) / step,
            (side[1].1 - side[0].1) / step,
        );
        let corner = |forth: f64, across: f64| {
            let (x, y) = side[1];
            let (forth, across) = (ARROW * forth, ARROW * across);
            (
                x + forth * along.0 - across * along.1,
                y + forth * along.1 + across * along.0,
            )
        };
        let head = [corner(0.6, 0.0), corner(-0.6, 0.5), corner(-0.6, -0.5)];
        canvas.polygon(&head, colour);
        next = gone + each;
        drawn += 1;
    }
}

fn scales(orbit: &Orbit) -> [Scale; 2] {
    if orbit.has_one_scale {
        let reach = reach(orbit);
        return [Scale::new(false, [-reach, reach].into_iter()); 2];
    }
    let points = || orbit.series.iter().flat_map(|series| &series.points);
    [
        Scale::new(false, points().map(|point| point.0)),
        Scale::new(false, points().map(|point| point.1)),
    ]
}

/// The furthest that anything drawn is from the origin, along either axis.
fn reach(orbit: &Orbit) -> f64 {
    let points = orbit.series.iter().flat_map(|series| &series.points);
    let furthest = orbit.circles.iter().copied().fold(0.0, f64::max);
    points
        .filter(|(x, y)| x.is_finite() && y.is_finite())
        .fold(furthest, |reach, (x, y)| reach.max(x.abs()).max(y.abs()))
}

fn circle(radius: f64) -> Vec<(f64, f64)> {
    (0..=CIRCLE_CORNERS)
        .map(|corner| {
            let angle = std::f64::consts::TAU * corner as f64 / CIRCLE_CORNERS as f64;
            (radius * angle.cos(), radius * angle.sin())
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::picture::tests::assert_text_inside;
    use super::*;

    #[test]
    fn an_orbit_has_one_scale_both_ways_and_its_labels_inside() {
        let orbit = || Orbit {
            axes: ["x (mm)", "y (mm)"].map(Axis::linear),
            has_one_scale: true,
            series: vec![Series {
                name: "a".to_owned(),
                style: LineStyle::default(),
                points: vec![(0.0, 0.0), (3.0, f64::NAN), (20.0, -1.0)],
            }],
            circles: vec![15.0],
            last: vec![1],
        };
        assert_eq!(reach(&orbit()), 20.0);
        let picture = orbits(
            &Look::default(),
            "Orbits",
            ["circle", "the end, dark"],
            &[orbit(), orbit()],
        );
        assert_text_inside(&picture);
    }
}
