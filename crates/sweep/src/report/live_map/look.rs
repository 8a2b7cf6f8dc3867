//! What a style sheet colours, and the shapes of symbols.

use plot::{CellFill, Fraction, Symbol};

/// Dash patterns of lines in the style sheet, `l0` and on.
pub const LINES: usize = 6;

/// Patterns that maps fill areas with, once in a page.
pub const DEFINITIONS: &str = "<svg class=\"patterns\" aria-hidden=\"true\"><defs>\
    <pattern id=\"no-case\" width=\"8\" height=\"8\" patternUnits=\"userSpaceOnUse\">\
    <path d=\"M-2 2l4 -4M0 8l8 -8M6 10l4 -4\"></path></pattern>\
    <pattern id=\"range\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\">\
    <path d=\"M-2 7l4 4M0 0l9 9M7 -2l4 4\"></path></pattern></defs></svg>\n";

/// The class of a symbol.
pub fn class_of_symbol(symbol: Symbol) -> &'static str {
    match symbol {
        Symbol::Circle => "circle",
        Symbol::Cross => "cross",
        Symbol::Square => "square",
        Symbol::Disc => "disc",
        Symbol::HeavyCross => "heavy",
        Symbol::Diamond => "diamond",
        Symbol::FilledDiamond => "gem",
        Symbol::Triangle => "triangle",
    }
}

/// The class of a fill.
pub fn class_of_fill(fill: CellFill) -> String {
    match fill {
        CellFill::Symbol(symbol) => format!("g-{}", class_of_symbol(symbol)),
        CellFill::Fraction(part) => {
            let place = Fraction::EVERY.iter().position(|other| *other == part);
            format!("p{}", place.unwrap_or(0))
        }
        CellFill::Safety(safety) => format!("s{}", safety as usize),
        CellFill::NoCase => "no-case".to_owned(),
    }
}

/// A part of a path that draws a symbol of a radius around a place.
pub fn symbol_path(symbol: Symbol, (x, y): (f64, f64), radius: f64) -> String {
    let number = |value: f64| short(value);
    let (r, across) = (number(radius), number(2.0 * radius));
    match symbol {
        Symbol::Circle | Symbol::Disc => format!(
            "M{} {}a{r} {r} 0 1 0 {across} 0a{r} {r} 0 1 0 -{across} 0",
            number(x - radius),
            number(y)
        ),
        Symbol::Cross | Symbol::HeavyCross => {
            let (left, top) = (number(x - 0.85 * radius), number(y - 0.85 * radius));
            let arm = number(1.7 * radius);
            format!("M{left} {top}l{arm} {arm}m-{arm} 0l{arm} -{arm}")
        }
        Symbol::Square => format!(
            "M{} {}h{across}v{across}h-{across}z",
            number(x - radius),
            number(y - radius)
        ),
        Symbol::Diamond | Symbol::FilledDiamond => {
            let far = 1.3 * radius;
            let (top, side) = (number(y - far), number(far));
            format!(
                "M{} {top}l{side} {side}l-{side} {side}l-{side} -{side}z",
                number(x)
            )
        }
        Symbol::Triangle => {
            let (far, half) = (1.3 * radius, 1.3 * radius * 0.75f64.sqrt());
            let (down, across) = (number(1.5 * far), number(2.0 * half));
            format!(
                "M{} {}l{} {down}h-{across}z",
                number(x),
                number(y - far),
                number(half)
            )
        }
    }
}

/// A length of a drawing, to a tenth.
pub fn short(value: f64) -> String {
    let tenths = (10.0 * value).round() / 10.0;
    // Without a sign before zero.
    (tenths + 0.0).to_string()
}
