//! Reference lines of panels.

use super::canvas::{Canvas, Stroke};
use super::colours;
use super::frame::Frame;
use super::geometry::{Pixel, Rect};
use super::names::Names;
use anyhow::Result;

/// Distance between a reference line and its name.
const NAME_GAP: f64 = 3.0;
/// How a reference line looks.
pub(super) const REFERENCE: Stroke = Stroke {
    colour: colours::REFERENCE,
    width: 1.0,
    dash: &[5.0, 4.0],
};

/// A thin dashed line across a panel, with its name beside it.
pub enum Reference {
    /// A line at one height.
    Horizontal {
        /// Its place along the vertical axis.
        y: f64,
        /// The name beside it.
        name: String,
    },
    /// A line from top to bottom.
    Vertical {
        /// Its place along the horizontal axis.
        x: f64,
        /// The name beside it.
        name: String,
    },
}

/// Draws reference lines, keeping their names off the given curves.
pub(super) fn draw_references(
    canvas: &mut Canvas,
    frame: &Frame,
    curves: Vec<Vec<Pixel>>,
    references: &[Reference],
) -> Result<()> {
    let mut names = Names::new(frame.area, curves);
    for reference in references {
        match reference {
            Reference::Horizontal { y, name } => {
                draw_horizontal(canvas, frame, &mut names, *y, name)?;
            }
            Reference::Vertical { x, name } => {
                draw_vertical(canvas, frame, &mut names, *x, name)?;
            }
        }
    }
    Ok(())
}

/// A horizontal line with its name above or below it.
fn draw_horizontal(
    canvas: &mut Canvas,
    frame: &Frame,
    names: &mut Names,
    y: f64,
    name: &str,
) -> Result<()> {
    let Some(y) = frame.pixel_y(y) else {
        return Ok(());
    };
    let Rect { left, right, .. } = frame.area;
    canvas.line(&[(left, y), (right, y)], REFERENCE)?;
    let name = names.block(name)?;
    let aside = name.height() / 2.0 + NAME_GAP;
    let inset = name.width / 2.0 + NAME_GAP;
    let along = spread(right - inset, left + inset);
    let centres: Vec<_> = along
        .flat_map(|x| [(x, y - aside), (x, y + aside)])
        .collect();
    names.write(canvas, &name, &centres)
}

/// A vertical line with its name right or left of it.
fn draw_vertical(
    canvas: &mut Canvas,
    frame: &Frame,
    names: &mut Names,
    x: f64,
    name: &str,
) -> Result<()> {
    let Some(x) = frame.pixel_x(x) else {
        return Ok(());
    };
    let Rect { top, bottom, .. } = frame.area;
    canvas.line(&[(x, top), (x, bottom)], REFERENCE)?;
    let name = names.block(name)?;
    let aside = name.width / 2.0 + NAME_GAP;
    let inset = name.height() / 2.0 + NAME_GAP;
    let along = spread(top + inset, bottom - inset);
    let centres: Vec<_> = along
        .flat_map(|y| [(x + aside, y), (x - aside, y)])
        .collect();
    names.write(canvas, &name, &centres)
}

/// Places to try along a reference line, the preferred end first.
fn spread(first: f64, last: f64) -> impl Iterator<Item = f64> {
    const STEPS: u8 = 8;
    (0..=STEPS).map(move |step| first + (last - first) * f64::from(step) / f64::from(STEPS))
}
