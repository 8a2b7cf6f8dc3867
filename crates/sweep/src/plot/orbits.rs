//! Orbits: curves in a plane with the same scale both ways, side by side, each
//! with the circles it may not leave where it comes near those.

use super::canvas::{Canvas, DASHES, Stroke, Title, draw_titled};
use super::colours::CLEARANCE;
use super::frame::Frame;
use super::geometry::Rect;
use super::legend::{Key, Legend, Series, distinct, place_of};
use super::panels::series_stroke;
use super::picture::Picture;
use super::scale::{Axis, Scale};
use anyhow::Result;

const MARGIN: f64 = 14.0;
/// Side of the square each orbit is drawn in, its labels included.
const SIDE: f64 = 420.0;
/// Distance between the plotting areas and the legend.
const LEGEND_GAP: f64 = 22.0;
/// Distance between an orbit and the next one's labels.
const ORBIT_GAP: f64 = 18.0;
/// Corners of a circle that looks round.
const CIRCLE_CORNERS: usize = 180;
const CIRCLE: Stroke = Stroke {
    colour: CLEARANCE,
    width: 1.2,
    dash: DASHES[1],
};

/// One orbit, seen along the axis it goes around.
pub struct Orbit {
    /// Horizontal and vertical axis, in the same unit.
    pub axes: [Axis; 2],
    /// Curves.
    pub series: Vec<Series>,
    /// Radii of dashed circles around the origin, the clearances.
    pub circles: Vec<f64>,
}

/// Draws orbits side by side, from left to right, with one title and one legend.
pub fn orbits(title: &str, orbits: &[Orbit]) -> Result<Picture> {
    let series = orbits.iter().flat_map(|orbit| &orbit.series);
    let names = distinct(series.map(|series| &series.name));
    let keys = names.iter().enumerate();
    let curves = keys.map(|(index, &name)| (Key::Line(series_stroke(index)), name));
    let has_circle = orbits.iter().any(|orbit| !orbit.circles.is_empty());
    let circle = has_circle.then_some((Key::Line(CIRCLE), "clearance"));
    let legend = Legend::new(curves.chain(circle))?;
    let plots = orbits.len() as f64 * SIDE;
    let width = MARGIN + plots + LEGEND_GAP + legend.width() + MARGIN;
    let title = Title::new(title, width, MARGIN)?;
    let top = title.bottom();
    let height = top + SIDE.max(legend.height()) + MARGIN;
    draw_titled(&title, height, |canvas| {
        for (index, orbit) in orbits.iter().enumerate() {
            let left = MARGIN + index as f64 * SIDE;
            draw_orbit(canvas, orbit, (left, top), &names)?;
        }
        legend.draw(canvas, MARGIN + plots + LEGEND_GAP, top)
    })
}

fn draw_orbit(
    canvas: &mut Canvas,
    orbit: &Orbit,
    (left, top): (f64, f64),
    names: &[&str],
) -> Result<()> {
    let outer = Rect {
        left,
        top,
        right: left + SIDE - ORBIT_GAP,
        bottom: top + SIDE,
    };
    let reach = reach(orbit);
    let scale = Scale::new(false, [-reach, reach].into_iter());
    let mut frame = Frame::new(outer, &orbit.axes, [scale; 2])?;
    let side = frame.area.width().min(frame.area.height());
    frame.area.right = frame.area.left + side;
    frame.area.top = frame.area.bottom - side;
    frame.draw(canvas)?;
    for radius in &orbit.circles {
        for piece in frame.curve(&circle(*radius)) {
            canvas.line(&piece, CIRCLE)?;
        }
    }
    for series in &orbit.series {
        let stroke = Stroke {
            width: 1.2,
            ..series_stroke(place_of(&series.name, names))
        };
        for piece in frame.curve(&series.points) {
            canvas.line(&piece, stroke)?;
        }
    }
    Ok(())
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
    use super::super::canvas::tests::assert_text_inside;
    use super::*;

    #[test]
    fn an_orbit_has_one_scale_both_ways_and_its_labels_inside() {
        let orbit = || Orbit {
            axes: ["x (mm)", "y (mm)"].map(Axis::linear),
            series: vec![Series {
                name: "hilbert".to_owned(),
                points: vec![(0.0, 0.0), (3.0, f64::NAN), (20.0, -1.0)],
            }],
            circles: vec![15.0],
        };
        assert_eq!(reach(&orbit()), 20.0);
        let picture = orbits("Orbits", &[orbit(), orbit()]);
        assert_text_inside(&picture.expect("drawn"));
    }
}
