//! Reference lines of panels.

use super::canvas::Canvas;
use super::colours;
use super::frame::Frame;
use super::geometry::{Pixel, Rect};
use super::names::Names;
use super::shapes::Stroke;

/// Distance between a reference line and its name.
const NAME_GAP: f64 = 3.0;
/// How a reference line looks.
pub(crate) const REFERENCE: Stroke = Stroke {
    colour: colours::REFERENCE,
    width: 1.0,
    dash: &[5.0, 4.0],
};

/// A thin dashed line across a panel, with its name next to it.
pub struct Reference {
    /// The axis with the value at which it stands.
    pub across: Across,
    /// Its place along that axis.
    pub at: f64,
    /// The name next to it.
    pub name: String,
}

/// The axis that a reference line crosses.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Across {
    /// The horizontal one: the line runs from top to bottom.
    X,
    /// The vertical one: the line runs from left to right.
    Y,
}

/// Where the reference lines across an axis stand.
pub(crate) fn places(references: &[Reference], across: Across) -> impl Iterator<Item = f64> {
    let lines = references.iter();
    lines
        .filter(move |line| line.across == across)
        .map(|line| line.at)
}

/// Draws reference lines, keeping their names off the given curves.
pub(crate) fn draw_references(
    canvas: &mut Canvas,
    frame: &Frame,
    curves: Vec<Vec<Pixel>>,
    references: &[Reference],
) {
    let mut names = Names::new(frame.area, Vec::new(), curves);
    let Rect {
        left,
        top,
        right,
        bottom,
    } = frame.area;
    for line in references {
        let name = names.block(&line.name);
        let [width, height] = [name.width, name.height()].map(|size| size / 2.0 + NAME_GAP);
        let (ends, centres): (_, Vec<Pixel>) = match line.across {
            Across::X => {
                let seen = frame
                    .pixel_x(line.at)
                    .filter(|x| (left..=right).contains(x));
                let Some(x) = seen else { continue };
                let along = spread(top + height, bottom - height);
                let near = along.flat_map(|y| [(x + width, y), (x - width, y)]);
                ([(x, top), (x, bottom)], near.collect())
            }
            Across::Y => {
                let seen = frame
                    .pixel_y(line.at)
                    .filter(|y| (top..=bottom).contains(y));
                let Some(y) = seen else { continue };
                let along = spread(right - width, left + width);
                let near = along.flat_map(|x| [(x, y - height), (x, y + height)]);
                ([(left, y), (right, y)], near.collect())
            }
        };
        canvas.line(&ends, REFERENCE);
        names.write(canvas, &name, &centres);
    }
}

/// Places to try along a reference line, the preferred end first.
fn spread(first: f64, last: f64) -> impl Iterator<Item = f64> {
    const STEPS: u8 = 8;
    (0..=STEPS).map(move |step| first + (last - first) * f64::from(step) / f64::from(STEPS))
}
