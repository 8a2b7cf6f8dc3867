//! The symbols of maps.

use std::f64::consts::TAU;

use super::canvas::Canvas;
use super::colours::{BLACK, BLUE, Colour, GREEN, GREY, ORANGE, PLUM, WHITE};
use super::geometry::{Pixel, Rect};
use super::shapes::Stroke;

/// Distance of a mark's corners from its centre.
pub(crate) const MARK_RADIUS: f64 = 7.0;
/// Width of the white rim that sets a mark off from symbols below it.
pub(crate) const HALO: f64 = 3.0;

/// What stands at a point of a map.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Symbol {
    /// An open circle.
    Circle,
    /// A cross.
    Cross,
    /// An open square.
    Square,
    /// A filled circle.
    Disc,
    /// A heavy cross.
    HeavyCross,
    /// An open diamond.
    Diamond,
    /// A filled diamond.
    FilledDiamond,
    /// An open triangle.
    Triangle,
}

impl Symbol {
    /// Every one, in the order of their numbers.
    pub const ALL: [Symbol; 8] = [
        Symbol::Circle,
        Symbol::Cross,
        Symbol::Square,
        Symbol::Disc,
        Symbol::HeavyCross,
        Symbol::Diamond,
        Symbol::FilledDiamond,
        Symbol::Triangle,
    ];

    /// That of a case of which some of the methods find sustained vibration, some that the start
    /// decides, and some less than sustained vibration: as in the paper a circle where every method
    /// finds it, a cross where none finds anything, a square where they differ; a diamond where by
    /// every method the start decides, a triangle where by every method it is less.
    pub fn of_methods([sustained, bistable, lesser]: [usize; 3], methods: usize) -> Self {
        match [sustained, bistable, lesser] {
            [0, 0, 0] => Symbol::Cross,
            [all, 0, 0] if all == methods => Symbol::Circle,
            [_, all, 0] if all == methods => Symbol::Diamond,
            [0, 0, all] if all == methods => Symbol::Triangle,
            _ => Symbol::Square,
        }
    }

    /// What symbols mean of a motion with a sustained regime, one that is not and, of some, one that is
    /// less than sustained, `by_all` methods.
    pub fn meanings(
        ([regime, none], lesser): ([&str; 2], Option<&str>),
        by_all: &str,
    ) -> Vec<(Symbol, String)> {
        let comma = if by_all.is_empty() { "" } else { "," };
        let lesser = lesser.map(|regime| (Symbol::Triangle, format!("{regime}{by_all}")));
        [
            (Symbol::Circle, format!("{regime}{by_all}")),
            (
                Symbol::Diamond,
                format!("{regime} or {none}, depending on the start{comma}{by_all}"),
            ),
        ]
        .into_iter()
        .chain(lesser)
        .chain([
            (Symbol::Cross, format!("{none}{by_all}")),
            (Symbol::Square, "methods differ".to_owned()),
        ])
        .collect()
    }

    /// The same where certainty is known for each case.
    pub fn by_certainty(meanings: Vec<(Symbol, String)>) -> Vec<(Symbol, String)> {
        let of_symbol = |(symbol, meaning): (Symbol, String)| {
            let certain = symbol.filled();
            if certain == symbol {
                return vec![(symbol, meaning)];
            }
            vec![
                (certain, format!("{meaning}, certain")),
                (symbol, format!("{meaning}, not certain")),
            ]
        };
        meanings.into_iter().flat_map(of_symbol).collect()
    }

    /// Its colour.
    pub fn colour(self) -> Colour {
        match self {
            Symbol::Circle | Symbol::Disc => BLUE,
            Symbol::Cross | Symbol::HeavyCross => GREY,
            Symbol::Square => ORANGE,
            Symbol::Diamond | Symbol::FilledDiamond => PLUM,
            Symbol::Triangle => GREEN,
        }
    }

    /// The same filled, or heavy; a square or a triangle stays as it is.
    pub fn filled(self) -> Self {
        match self {
            Symbol::Circle => Symbol::Disc,
            Symbol::Cross => Symbol::HeavyCross,
            Symbol::Diamond => Symbol::FilledDiamond,
            other => other,
        }
    }
}

/// Draws one symbol as one SVG element.
pub(crate) fn draw_symbol(canvas: &mut Canvas, symbol: Symbol, (x, y): Pixel, r: f64) {
    let colour = symbol.colour();
    match symbol {
        Symbol::Circle => canvas.ring((x, y), r, Stroke::solid(colour, 0.28 * r)),
        Symbol::Cross => draw_cross(canvas, (x, y), 0.85 * r, Stroke::solid(colour, 0.26 * r)),
        Symbol::Square => {
            let (a, b, c, d) = (x - r, x + r, y - r, y + r);
            // Starting within a side leaves no notch at a corner.
            let path = [(x, c), (b, c), (b, d), (a, d), (a, c), (x, c)];
            canvas.line(&path, Stroke::solid(colour, 0.42 * r))
        }
        Symbol::Disc => canvas.disc((x, y), 1.1 * r, colour),
        Symbol::HeavyCross => draw_cross(canvas, (x, y), 0.85 * r, Stroke::solid(colour, 0.6 * r)),
        Symbol::Diamond => {
            let far = 1.25 * r;
            let (half, corners) = (0.5 * far, diamond((x, y), far));
            let [top, right, bottom, left] = corners;
            // Starting within a side leaves no notch at a corner.
            let start = (x + half, y - half);
            let path = [start, right, bottom, left, top, start];
            canvas.line(&path, Stroke::solid(colour, 0.3 * r))
        }
        Symbol::FilledDiamond => canvas.polygon(&diamond((x, y), 1.4 * r), colour),
        Symbol::Triangle => {
            let [top, right, left] = triangle((x, y), 1.3 * r);
            // Starting within a side leaves no notch at a corner.
            let path = [(x, right.1), left, top, right, (x, right.1)];
            canvas.line(&path, Stroke::solid(colour, 0.32 * r))
        }
    }
}

/// The marker of a kind of points: kinds differ in shape and in colour.
#[derive(Clone, Copy)]
pub(crate) struct Marker {
    pub kind: usize,
    pub colour: Colour,
}

/// Draws a marker.
pub(crate) fn draw_marker(
    canvas: &mut Canvas,
    Marker { kind, colour }: Marker,
    (x, y): Pixel,
    r: f64,
) {
    let far = 1.3 * r;
    match kind % 6 {
        0 => canvas.disc((x, y), r, colour),
        1 => canvas.polygon(&diamond((x, y), far), colour),
        2 => canvas.polygon(&triangle((x, y), far), colour),
        3 => canvas.polygon(&Rect::centred((x, y), 2.0 * r, 2.0 * r).corners(), colour),
        4 => draw_cross(canvas, (x, y), r, Stroke::solid(colour, 0.55 * r)),
        _ => canvas.polygon(&star((x, y), 1.7 * r), colour),
    }
}

/// Both diagonals of a square of side 2r, as one line.
pub(crate) fn draw_cross(canvas: &mut Canvas, centre: Pixel, r: f64, stroke: Stroke) {
    let [first, second, third, fourth] = Rect::centred(centre, 2.0 * r, 2.0 * r).corners();
    canvas.line(&[first, third, centre, second, fourth], stroke)
}

/// A black dot, filled or open.
pub(crate) fn draw_dot(canvas: &mut Canvas, filled: bool, centre: Pixel, radius: f64) {
    canvas.disc(centre, radius, BLACK);
    if filled {
        return;
    }
    canvas.disc(centre, 0.7 * radius, WHITE)
}

/// A ring around a point.
pub(crate) fn draw_rim(canvas: &mut Canvas, centre: Pixel, radius: f64) {
    canvas.ring(centre, radius, Stroke::solid(BLACK, 1.4))
}

/// A black triangle with a white halo.
pub(crate) fn draw_triangle(canvas: &mut Canvas, centre: Pixel) {
    // The halo is twice as far at the corners as along the sides.
    canvas.polygon(&triangle(centre, MARK_RADIUS + 2.0 * HALO), WHITE);
    canvas.polygon(&triangle(centre, MARK_RADIUS), BLACK)
}

/// Its corners from the top, clockwise.
fn diamond((x, y): Pixel, far: f64) -> [Pixel; 4] {
    [(x, y - far), (x + far, y), (x, y + far), (x - far, y)]
}

/// A star of five points, one of them up.
fn star((x, y): Pixel, radius: f64) -> [(f64, f64); 10] {
    std::array::from_fn(|corner| {
        let reach = if corner % 2 == 0 {
            radius
        } else {
            0.45 * radius
        };
        let (sine, cosine) = (0.1 * TAU * corner as f64).sin_cos();
        (x + reach * sine, y - reach * cosine)
    })
}

fn triangle((x, y): Pixel, radius: f64) -> [(f64, f64); 3] {
    let half_side = radius * 0.75f64.sqrt();
    let base = y + radius / 2.0;
    [
        (x, y - radius),
        (x + half_side, base),
        (x - half_side, base),
    ]
}
