//! The fills of a map's cells: distinguished by how light they are, so that neither
//! colour vision nor colour print is needed.

use super::canvas::Canvas;
use super::colours::{
    BLUE_GROUND, CERTAIN_BLUE_GROUND, CERTAIN_GREY_GROUND, CERTAIN_PURPLE_GROUND, Colour,
    GREEN_GROUND, GREY_GROUND, NO_CASE, ORANGE_GROUND, PARTS, PURPLE_GROUND, SAFETY,
};
use super::geometry::Rect;
use super::shapes::Stroke;
use super::symbols::Symbol;

/// Distance of strokes through an empty cell, along either axis.
const STEP: f64 = 8.0;

/// What a cell shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CellFill {
    /// What stands for most of what is in it.
    Symbol(Symbol),
    /// How large a fraction of what is in it has a property.
    Fraction(Fraction),
    /// How far it is from limits.
    Safety(Safety),
    /// Nothing is in it: slanted strokes.
    NoCase,
}

/// How far a part of a map is from limits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Safety {
    /// Beyond the margin of each.
    Safe,
    /// The same, unless something is begun.
    Conditional,
    /// Within the margin of one.
    Near,
    /// On the wrong side of one.
    Unsafe,
}

/// A class of parts of a whole: none of it, each quarter with its upper end, and all.
///
/// ```
/// use plot::Fraction;
///
/// let texts = [0.0, 0.1, 0.6, 1.0].map(|part| Fraction::of(part).text());
/// assert_eq!(texts, ["none", "up to 25 %", "50 to 75 %", "all"]);
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fraction(usize);

/// The upper ends of the classes up to the third quarter; the whole is a separate class.
const ENDS: [f64; 4] = [0.0, 0.25, 0.5, 0.75];

impl Fraction {
    /// All classes, in ascending order.
    pub const EVERY: [Fraction; 6] = [
        Fraction(0),
        Fraction(1),
        Fraction(2),
        Fraction(3),
        Fraction(4),
        Fraction(5),
    ];

    /// The class of a part between 0 and 1.
    pub fn of(part: f64) -> Fraction {
        let passed = ENDS.iter().filter(|end| part > **end).count();
        Fraction(passed + usize::from(part >= 1.0))
    }

    /// As a person reads it.
    pub fn text(self) -> &'static str {
        [
            "none",
            "up to 25 %",
            "25 to 50 %",
            "50 to 75 %",
            "over 75 %",
            "all",
        ][self.0]
    }

    /// From light to dark.
    fn colour(self) -> Colour {
        PARTS[self.0]
    }
}

/// Fills a part of a map.
pub(crate) fn draw_fill(canvas: &mut Canvas, fill: CellFill, area: Rect) {
    let colour = match fill {
        CellFill::Symbol(Symbol::Circle) => BLUE_GROUND,
        CellFill::Symbol(Symbol::Cross) => GREY_GROUND,
        CellFill::Symbol(Symbol::Square) => ORANGE_GROUND,
        CellFill::Symbol(Symbol::Triangle) => GREEN_GROUND,
        CellFill::Symbol(Symbol::Disc) => CERTAIN_BLUE_GROUND,
        CellFill::Symbol(Symbol::HeavyCross) => CERTAIN_GREY_GROUND,
        CellFill::Symbol(Symbol::Diamond) => PURPLE_GROUND,
        CellFill::Symbol(Symbol::FilledDiamond) => CERTAIN_PURPLE_GROUND,
        CellFill::Fraction(part) => part.colour(),
        CellFill::Safety(safety) => SAFETY[safety as usize],
        CellFill::NoCase => return draw_strokes(canvas, area),
    };
    canvas.polygon(&area.corners(), colour)
}

/// Slanted strokes that continue from one cell to the next; a cell that none of them crosses gets
/// its own.
fn draw_strokes(canvas: &mut Canvas, area: Rect) {
    let stroke = Stroke::solid(NO_CASE, 0.8);
    // Places whose right and down add up to a whole number of steps.
    let [first, last] = [area.left + area.top, area.right + area.bottom];
    let numbers = (first / STEP).ceil() as i64..(last / STEP).ceil() as i64;
    let along = |number: i64| {
        let sum = STEP * number as f64;
        [(sum - area.bottom, area.bottom), (sum - area.top, area.top)]
    };
    let mut parts: Vec<_> = numbers
        .flat_map(|number| area.clip(&along(number)))
        .collect();
    if parts.is_empty() {
        parts.push(vec![(area.left, area.bottom), (area.right, area.top)]);
    }
    parts.iter().for_each(|part| canvas.line(part, stroke))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lightness of CIELAB, the gamma of sRGB taken as 2.2: what is left without colour. A
    /// difference of 9 is plain between neighbours.
    fn lightness(Colour(red, green, blue): Colour) -> f64 {
        let linear = |value: u8| (f64::from(value) / 255.0).powf(2.2);
        let luminance = 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
        116.0 * luminance.powf(1.0 / 3.0) - 16.0
    }

    #[test]
    fn a_larger_part_is_darker() {
        for pair in Fraction::EVERY.windows(2) {
            let step = lightness(pair[0].colour()) - lightness(pair[1].colour());
            assert!(step > 9.0, "{pair:?}: {step}");
        }
    }

    #[test]
    fn what_is_less_safe_is_darker() {
        for pair in SAFETY.windows(2) {
            let step = lightness(pair[0]) - lightness(pair[1]);
            assert!(step > 14.0, "{pair:?}: {step}");
        }
    }

    #[test]
    fn classes_take_their_upper_ends() {
        let classes = [0.0, 1e-6, 0.25, 0.5, 0.75, 0.999, 1.0].map(Fraction::of);
        assert_eq!(
            classes,
            [0, 1, 1, 2, 3, 4, 5].map(|class| Fraction::EVERY[class])
        );
    }
}
