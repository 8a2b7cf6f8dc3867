//! The grounds of a map's cells: told apart by how light they are, so that neither
//! colour vision nor colour print is needed.

use super::canvas::{Canvas, Stroke};
use super::colours::{BLUE_GROUND, GREY_GROUND, NO_CASE, ORANGE_GROUND, PARTS};
use super::geometry::Rect;
use super::symbols::Symbol;
use anyhow::Result;
use plotters::style::RGBColor;

/// What the cases of a cell are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Ground {
    /// What most of them are.
    Symbol(Symbol),
    /// How large a part of them has the regime.
    Part(Part),
    /// There are none: a stroke across the cell.
    NoCase,
}

/// A class of parts of a whole.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Part {
    /// Not one.
    None,
    /// Up to a quarter.
    FirstQuarter,
    /// More, up to a half.
    SecondQuarter,
    /// More, up to three quarters.
    ThirdQuarter,
    /// More, but not all.
    LastQuarter,
    /// Every one.
    All,
}

impl Part {
    /// All classes, in ascending order.
    pub const EVERY: [Part; 6] = [
        Part::None,
        Part::FirstQuarter,
        Part::SecondQuarter,
        Part::ThirdQuarter,
        Part::LastQuarter,
        Part::All,
    ];

    /// The class of a part between 0 and 1.
    pub fn of(part: f64) -> Part {
        match part {
            part if part <= 0.0 => Part::None,
            part if part <= 0.25 => Part::FirstQuarter,
            part if part <= 0.5 => Part::SecondQuarter,
            part if part <= 0.75 => Part::ThirdQuarter,
            part if part < 1.0 => Part::LastQuarter,
            _ => Part::All,
        }
    }

    /// As a person reads it.
    pub fn text(self) -> &'static str {
        match self {
            Part::None => "none",
            Part::FirstQuarter => "up to 25 %",
            Part::SecondQuarter => "25 to 50 %",
            Part::ThirdQuarter => "50 to 75 %",
            Part::LastQuarter => "over 75 %",
            Part::All => "all",
        }
    }

    /// From light to dark.
    fn colour(self) -> RGBColor {
        PARTS[self as usize]
    }
}

/// Fills a part of a map.
pub(super) fn draw_ground(canvas: &mut Canvas, ground: Ground, area: Rect) -> Result<()> {
    let colour = match ground {
        Ground::Symbol(Symbol::Circle) => BLUE_GROUND,
        Ground::Symbol(Symbol::Cross) => GREY_GROUND,
        Ground::Symbol(Symbol::Square) => ORANGE_GROUND,
        Ground::Part(part) => part.colour(),
        Ground::NoCase => {
            let stroke = [(area.left, area.bottom), (area.right, area.top)];
            return canvas.line(&stroke, Stroke::solid(NO_CASE, 0.8));
        }
    };
    canvas.polygon(&area.corners(), colour)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_larger_part_is_darker() {
        // Relative luminance of sRGB, its gamma taken as 2.2: what is left without
        // colour.
        let luminance = |part: Part| {
            let RGBColor(red, green, blue) = part.colour();
            let linear = |value: u8| (f64::from(value) / 255.0).powf(2.2);
            0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue)
        };
        // Lightness of CIELAB: a difference of 9 is plain between neighbours.
        let lightness = |part| 116.0 * f64::cbrt(luminance(part)) - 16.0;
        for pair in Part::EVERY.windows(2) {
            let step = lightness(pair[0]) - lightness(pair[1]);
            assert!(step > 9.0, "{pair:?}: {step}");
        }
    }

    #[test]
    fn classes_take_their_upper_ends() {
        let classes = [0.0, 1e-6, 0.25, 0.5, 0.75, 0.999, 1.0].map(Part::of);
        let first = [Part::None, Part::FirstQuarter, Part::FirstQuarter];
        assert_eq!(classes[..3], first);
        assert_eq!(classes[3..], Part::EVERY[2..]);
    }
}
