//! The colours of all pictures. Colour-blind readers can tell those of Okabe and Ito
//! apart; grounds are told apart by how light they are, so that neither colour vision
//! nor colour print is needed.

use std::fmt;

/// A colour in sRGB: red, green and blue.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Colour(pub u8, pub u8, pub u8);

/// What an area is filled with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Fill {
    pub colour: Colour,
    /// From 0, which shows all that is below, to 1.
    pub opacity: f64,
}

impl Colour {
    /// The colour through which what is below shows.
    pub const fn at(self, opacity: f64) -> Fill {
        Fill {
            colour: self,
            opacity,
        }
    }
}

impl From<Colour> for Fill {
    fn from(colour: Colour) -> Self {
        colour.at(1.0)
    }
}

/// As SVG has it.
impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(red, green, blue) = self;
        write!(f, "#{red:02X}{green:02X}{blue:02X}")
    }
}

pub(super) const BLACK: Colour = Colour(0x00, 0x00, 0x00);
pub(super) const WHITE: Colour = Colour(0xFF, 0xFF, 0xFF);

pub(super) const BLUE: Colour = Colour(0x00, 0x72, 0xB2);
pub(super) const ORANGE: Colour = Colour(0xE6, 0x9F, 0x00);
pub(super) const GREEN: Colour = Colour(0x00, 0x9E, 0x73);
pub(super) const PURPLE: Colour = Colour(0xCC, 0x79, 0xA7);
pub(super) const SKY_BLUE: Colour = Colour(0x56, 0xB4, 0xE9);
pub(super) const RED: Colour = Colour(0xD5, 0x5E, 0x00);
pub(super) const DARK_GREY: Colour = Colour(0x66, 0x66, 0x66);
pub(super) const GREY: Colour = Colour(0x77, 0x77, 0x77);
/// Darker than the purple of Okabe and Ito, for thin lines.
pub(super) const PLUM: Colour = Colour(0x9B, 0x3F, 0x75);
/// Darker than that of Okabe and Ito, for thin lines on a tinted ground.
pub(super) const VERMILION: Colour = Colour(0xB0, 0x3A, 0x00);

/// Of curves and markers, by Okabe and Ito, in the order in which they get them.
pub(super) const COLOURS: [Colour; 7] = [BLUE, ORANGE, GREEN, RED, PURPLE, SKY_BLUE, BLACK];

/// Grounds below the symbols of their colours.
pub(super) const BLUE_GROUND: Colour = Colour(0x9A, 0xCD, 0xEC);
pub(super) const GREY_GROUND: Colour = Colour(0xF3, 0xF3, 0xF3);
pub(super) const ORANGE_GROUND: Colour = Colour(0xB3, 0x50, 0x00);
pub(super) const PURPLE_GROUND: Colour = Colour(0xC9, 0x86, 0xAD);
/// Of cases that are certain, darker than those that are not.
pub(super) const CERTAIN_BLUE_GROUND: Colour = Colour(0x50, 0x97, 0xC8);
pub(super) const CERTAIN_GREY_GROUND: Colour = Colour(0xD0, 0xD0, 0xD0);
pub(super) const CERTAIN_PURPLE_GROUND: Colour = Colour(0x86, 0x3A, 0x66);
/// From what is safe to what is not: from light to dark.
pub(super) const SAFETY: [Colour; 4] = [
    Colour(0xEA, 0xF5, 0xFC),
    Colour(0x9A, 0xCD, 0xEC),
    Colour(0xC8, 0x92, 0x28),
    Colour(0x8F, 0x3D, 0x00),
];
/// Strokes through cells without a case.
pub(super) const NO_CASE: Colour = Colour(0x99, 0x99, 0x99);

/// Of parts of a whole, from none to all: from light to dark.
pub(super) const PARTS: [Colour; 6] = [
    GREY_GROUND,
    Colour(0xBF, 0xDA, 0xEE),
    Colour(0x8A, 0xBB, 0xDF),
    Colour(0x50, 0x97, 0xC8),
    Colour(0x24, 0x6A, 0xA8),
    Colour(0x0B, 0x35, 0x6B),
];

/// Of values in bands, from small to large: from light to dark, and none as light as paper.
pub(super) const BANDS: [Colour; 5] = [PARTS[1], PARTS[2], PARTS[3], PARTS[4], PARTS[5]];

// Tints of sky blue and orange, and of nothing.
pub(super) const SKY: Colour = Colour(0xD3, 0xEA, 0xF8);
pub(super) const SAND: Colour = Colour(0xF8, 0xDD, 0xA6);
pub(super) const PALE: Colour = Colour(0xEE, 0xEE, 0xEE);

// Lines that stay behind the curves.
pub(super) const GRID: Colour = Colour(0xE8, 0xE8, 0xE8);
pub(super) const REFERENCE: Colour = Colour(0x55, 0x55, 0x55);
pub(super) const CLEARANCE: Colour = Colour(0x44, 0x44, 0x44);
