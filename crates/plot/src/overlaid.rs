//! Curves of a panel that look like another: they are drawn once, and what they differ by is
//! said.

use super::frame::Frame;
use super::geometry::{Pixel, thin};
use super::line_styles::Series;

/// Curves no farther apart than this, in pixels, look the same: it is less than half of what
/// either is wide.
const SAME: f64 = 0.7;

/// A curve that looks like an earlier one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Overlaid {
    /// Which of the panel it looks like.
    pub like: usize,
    /// The greatest difference between both, in the unit of the vertical axis.
    pub difference: f64,
}

/// Which curves of a panel look like an earlier one that is drawn.
pub(crate) fn overlaid(frame: &Frame, series: &[Series]) -> Vec<Option<Overlaid>> {
    let curves: Vec<Vec<Vec<Pixel>>> = (series.iter())
        .map(|series| {
            frame
                .curve(&series.points)
                .iter()
                .map(|piece| thin(piece))
                .collect()
        })
        .collect();
    let mut found: Vec<Option<Overlaid>> = Vec::with_capacity(series.len());
    for (index, curve) in curves.iter().enumerate() {
        let like = (0..index).find(|&other| {
            found[other].is_none() && !curve.is_empty() && look_alike(curve, &curves[other])
        });
        found.push(like.map(|like| Overlaid {
            like,
            difference: difference(&series[index].points, &series[like].points),
        }));
    }
    found
}

fn look_alike(one: &[Vec<Pixel>], other: &[Vec<Pixel>]) -> bool {
    one.len() == other.len()
        && one.iter().zip(other).all(|(one, other)| {
            let is_curve = one.len() > 1 && other.len() > 1;
            is_curve && lies_on(one, other) && lies_on(other, one)
        })
}

/// Whether every point of a curve is on another that goes from left to right.
fn lies_on(points: &[Pixel], curve: &[Pixel]) -> bool {
    points.iter().all(|&(x, y)| {
        let from = curve
            .partition_point(|point| point.0 < x - SAME)
            .saturating_sub(1);
        let near = curve[from..]
            .windows(2)
            .take_while(|side| side[0].0 <= x + SAME);
        near.into_iter()
            .any(|side| distance((x, y), [side[0], side[1]]) <= SAME)
    })
}

fn distance((x, y): Pixel, [from, to]: [Pixel; 2]) -> f64 {
    let (along, up) = (to.0 - from.0, to.1 - from.1);
    let squared = along * along + up * up;
    let part = if squared > 0.0 {
        (((x - from.0) * along + (y - from.1) * up) / squared).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (x - from.0 - part * along).hypot(y - from.1 - part * up)
}

/// The greatest difference between the points of a curve and another, straight between its own.
fn difference(points: &[(f64, f64)], other: &[(f64, f64)]) -> f64 {
    let differences = points.iter().filter_map(|&(x, y)| {
        let after = other.partition_point(|point| point.0 < x);
        let value = match other.get(after)? {
            point if point.0 == x => point.1,
            &(right, high) => {
                let &(left, low) = other.get(after.checked_sub(1)?)?;
                low + (high - low) * (x - left) / (right - left)
            }
        };
        Some((y - value).abs())
    });
    differences
        .filter(|difference| difference.is_finite())
        .fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::super::geometry::Rect;
    use super::super::scale::{Axis, Scale};
    use super::*;

    fn found(offset: f64) -> Option<Overlaid> {
        let outer = Rect {
            left: 0.0,
            top: 0.0,
            right: 500.0,
            bottom: 300.0,
        };
        let scales = [10.0, 1.0].map(|high| Scale::new(false, [0.0, high].into_iter()));
        let frame = Frame::new(outer, &["x", "y"].map(Axis::linear), scales);
        let wave = |offset: f64| {
            let points = (0..1000).map(|step| {
                let x = 0.01 * f64::from(step);
                (x, 0.5 + 0.4 * x.sin() + offset)
            });
            Series::new("", points.collect())
        };
        overlaid(&frame, &[wave(0.0), wave(offset)])[1]
    }

    /// A pixel is about 0.004 of the range.
    #[test]
    fn curves_closer_than_a_line_is_wide_are_one_and_their_difference_is_known() {
        let same = found(0.001).expect("the same");
        assert_eq!(same.like, 0);
        assert!((same.difference - 0.001).abs() < 1e-12);
        assert_eq!(found(0.01), None);
    }
}
