//! The colours of all pictures. Colour-blind readers can distinguish those of Okabe
//! and Ito; fills differ in how light they are, so that neither colour vision
//! nor colour print is needed.
//!
//! ```
//! use plot::colours::{BLUE, ORANGE};
//!
//! assert_eq!(BLUE.to_string(), "#0072B2");
//! assert_ne!(BLUE, ORANGE);
//! ```

use std::fmt;

/// A colour in sRGB: red, green and blue.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Colour(pub u8, pub u8, pub u8);

/// What an area is filled with.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Fill {
    pub colour: Colour,
    /// From 0, which shows all that is below, to 1.
    pub opacity: f64,
}

impl Colour {
    /// The colour through which what is below shows.
    pub(crate) const fn at(self, opacity: f64) -> Fill {
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

/// Black.
pub const BLACK: Colour = Colour(0x00, 0x00, 0x00);
pub(crate) const WHITE: Colour = Colour(0xFF, 0xFF, 0xFF);

/// Blue, by Okabe and Ito.
pub const BLUE: Colour = Colour(0x00, 0x72, 0xB2);
/// Orange, by Okabe and Ito.
pub const ORANGE: Colour = Colour(0xE6, 0x9F, 0x00);
/// Bluish green, by Okabe and Ito.
pub const GREEN: Colour = Colour(0x00, 0x9E, 0x73);
/// Reddish purple, by Okabe and Ito.
pub const PURPLE: Colour = Colour(0xCC, 0x79, 0xA7);
/// Sky blue, by Okabe and Ito.
pub const SKY_BLUE: Colour = Colour(0x56, 0xB4, 0xE9);
/// Vermilion, by Okabe and Ito.
pub const RED: Colour = Colour(0xD5, 0x5E, 0x00);
/// A dark grey.
pub const DARK_GREY: Colour = Colour(0x66, 0x66, 0x66);
pub(crate) const GREY: Colour = Colour(0x77, 0x77, 0x77);
/// Darker than the purple of Okabe and Ito, for thin lines.
pub(crate) const PLUM: Colour = Colour(0x9B, 0x3F, 0x75);
/// Darker than that of Okabe and Ito, for thin lines on a tinted fill.
pub(crate) const VERMILION: Colour = Colour(0xB0, 0x3A, 0x00);

/// Of curves and markers, by Okabe and Ito, in the order in which they get them.
pub(crate) const COLOURS: [Colour; 7] = [BLUE, ORANGE, GREEN, RED, PURPLE, SKY_BLUE, BLACK];

/// Fills below the symbols of their colours.
pub(crate) const BLUE_GROUND: Colour = Colour(0x9A, 0xCD, 0xEC);
pub(crate) const GREEN_GROUND: Colour = Colour(0x8F, 0xC9, 0xB3);
pub(crate) const GREY_GROUND: Colour = Colour(0xF3, 0xF3, 0xF3);
pub(crate) const ORANGE_GROUND: Colour = Colour(0xB3, 0x50, 0x00);
pub(crate) const PURPLE_GROUND: Colour = Colour(0xC9, 0x86, 0xAD);
/// The same below filled and heavy symbols: darker.
pub(crate) const CERTAIN_BLUE_GROUND: Colour = Colour(0x50, 0x97, 0xC8);
pub(crate) const CERTAIN_GREY_GROUND: Colour = Colour(0xD0, 0xD0, 0xD0);
pub(crate) const CERTAIN_PURPLE_GROUND: Colour = Colour(0x86, 0x3A, 0x66);
/// From what is safe to what is not: from light to dark.
pub(crate) const SAFETY: [Colour; 4] = [
    Colour(0xEA, 0xF5, 0xFC),
    Colour(0x9A, 0xCD, 0xEC),
    Colour(0xC8, 0x92, 0x28),
    Colour(0x8F, 0x3D, 0x00),
];
/// Strokes through empty cells.
pub(crate) const NO_CASE: Colour = Colour(0x99, 0x99, 0x99);

/// Of parts of a whole, from none to all: from light to dark.
pub(crate) const PARTS: [Colour; 6] = [
    GREY_GROUND,
    Colour(0xBF, 0xDA, 0xEE),
    Colour(0x8A, 0xBB, 0xDF),
    Colour(0x50, 0x97, 0xC8),
    Colour(0x24, 0x6A, 0xA8),
    Colour(0x0B, 0x35, 0x6B),
];

/// Of values in bands, from small to large: from light to dark, and none as light as paper.
pub(crate) const BANDS: [Colour; 5] = [PARTS[1], PARTS[2], PARTS[3], PARTS[4], PARTS[5]];

// Tints of sky blue and orange, and of nothing.
pub(crate) const SKY: Colour = Colour(0xD3, 0xEA, 0xF8);
pub(crate) const SAND: Colour = Colour(0xF8, 0xDD, 0xA6);
pub(crate) const PALE: Colour = Colour(0xEE, 0xEE, 0xEE);

// Lines that stay behind the curves.
pub(crate) const GRID: Colour = Colour(0xE8, 0xE8, 0xE8);
pub(crate) const REFERENCE: Colour = Colour(0x55, 0x55, 0x55);
pub(crate) const BOUND: Colour = Colour(0x44, 0x44, 0x44);
