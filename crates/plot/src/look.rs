//! How a picture is asked to look: its size on paper, its title and the ranges of its axes.
//!
//! Every picture is laid out in pixels in which small text is [`SMALL_SIZE`] high. From the width in
//! millimetres and the size of text in points follows its width in such pixels: it is laid out
//! for that width, and not a larger one made small.

use super::text::SMALL_SIZE;

/// Points and CSS pixels to a millimetre.
const POINTS: f64 = 72.0 / 25.4;

/// Below this width in pixels legends stand below what they are of, not at its side.
const NARROW: f64 = 640.0;

/// Widths, in pixels, for which there is a layout.
const WIDTHS: [f64; 2] = [260.0, 2400.0];

/// The size of a picture on paper.
///
/// ```
/// use plot::Paper;
///
/// assert!(Paper::new(90.0, 8.0).is_ok());
/// // Numbers of 8 points have no room in 20 mm.
/// let [least, _] = Paper::new(20.0, 8.0).expect_err("too narrow");
/// assert!(Paper::new(least + 0.1, 8.0).is_ok());
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Paper {
    /// Its width, mm.
    width_mm: f64,
    /// The size of its numbers and legends, points.
    font_pt: f64,
}

impl Paper {
    /// A picture of this width in mm, with numbers and legends of this size in points.
    ///
    /// # Errors
    /// The least and the greatest width in mm that text of this size has room in.
    pub fn new(width_mm: f64, font_pt: f64) -> Result<Self, [f64; 2]> {
        let paper = Self { width_mm, font_pt };
        let [least, greatest] = WIDTHS;
        if (least..=greatest).contains(&paper.pixels()) {
            Ok(paper)
        } else {
            Err(WIDTHS.map(|width| width * paper.pixel_mm()))
        }
    }

    /// A pixel, mm.
    pub(crate) fn pixel_mm(&self) -> f64 {
        self.font_pt / SMALL_SIZE / POINTS
    }

    fn pixels(&self) -> f64 {
        self.width_mm / self.pixel_mm()
    }
}

/// How a picture is asked to look; by default as on a screen.
#[derive(Debug, Clone, Default)]
pub struct Look {
    /// Its size; without it each kind of picture has its own, in pixels.
    pub paper: Option<Paper>,
    /// A title that replaces its own; empty for no title.
    pub title: Option<String>,
    /// Ends of its horizontal and its vertical axis, in the units that it shows.
    pub ranges: [Option<[f64; 2]>; 2],
}

impl Look {
    /// The same with the axes that follow from what is shown.
    pub fn with_own_ranges(&self) -> Self {
        Self {
            ranges: [None; 2],
            ..self.clone()
        }
    }

    /// The same with what follows from what is shown along the vertical axis.
    pub fn with_own_heights(&self) -> Self {
        let [x, _] = self.ranges;
        Self {
            ranges: [x, None],
            ..self.clone()
        }
    }

    /// The width to lay a picture out for, in pixels, whose own is this.
    pub(crate) fn width(&self, own: f64) -> f64 {
        self.paper.map_or(own, |paper| paper.pixels())
    }
}

/// Whether legends stand below.
pub(crate) fn is_narrow(width: f64) -> bool {
    width < NARROW
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_of_a_journal_is_laid_out_for_its_own_width() {
        let paper = Paper::new(90.0, 8.0).expect("room");
        // 255 pt, of which 8 are 14 pixels.
        assert!((paper.pixels() - 446.46).abs() < 0.01);
        assert!((paper.pixels() * paper.pixel_mm() - 90.0).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_room_is_refused_with_the_widths_that_have() {
        let [least, greatest] = Paper::new(20.0, 8.0).expect_err("too narrow");
        assert!((least - 52.4).abs() < 0.1, "{least}");
        assert!(Paper::new(greatest + 1.0, 8.0).is_err());
        assert!(Paper::new(least + 0.1, 8.0).is_ok());
        assert!(Paper::new(f64::NAN, 8.0).is_err());
    }
}
