//! The colours of all pictures. Colour-blind readers can tell those of Okabe and Ito
//! apart; grounds are told apart by how light they are, so that neither colour vision
//! nor colour print is needed.

use plotters::style::RGBColor;

pub(super) const BLUE: RGBColor = RGBColor(0x00, 0x72, 0xB2);
pub(super) const ORANGE: RGBColor = RGBColor(0xE6, 0x9F, 0x00);
pub(super) const GREEN: RGBColor = RGBColor(0x00, 0x9E, 0x73);
pub(super) const PURPLE: RGBColor = RGBColor(0xCC, 0x79, 0xA7);
pub(super) const SKY_BLUE: RGBColor = RGBColor(0x56, 0xB4, 0xE9);
pub(super) const RED: RGBColor = RGBColor(0xD5, 0x5E, 0x00);
pub(super) const DARK_GREY: RGBColor = RGBColor(0x66, 0x66, 0x66);
pub(super) const GREY: RGBColor = RGBColor(0x77, 0x77, 0x77);
/// Darker than the purple of Okabe and Ito, for thin lines.
pub(super) const PLUM: RGBColor = RGBColor(0x9B, 0x3F, 0x75);
/// Darker than that of Okabe and Ito, for thin lines on a tinted ground.
pub(super) const VERMILION: RGBColor = RGBColor(0xB0, 0x3A, 0x00);

/// Of curves and markers, by Okabe and Ito, in the order in which they get them.
pub(super) const COLOURS: [RGBColor; 7] = [
    BLUE,
    ORANGE,
    GREEN,
    RED,
    PURPLE,
    SKY_BLUE,
    RGBColor(0x00, 0x00, 0x00),
];

/// Grounds below the symbols of their colours.
pub(super) const BLUE_GROUND: RGBColor = RGBColor(0x9A, 0xCD, 0xEC);
pub(super) const GREY_GROUND: RGBColor = RGBColor(0xF3, 0xF3, 0xF3);
pub(super) const ORANGE_GROUND: RGBColor = RGBColor(0xB3, 0x50, 0x00);
pub(super) const PURPLE_GROUND: RGBColor = RGBColor(0xC9, 0x86, 0xAD);
/// Of cases that are certain, darker than those that are not.
pub(super) const CERTAIN_BLUE_GROUND: RGBColor = RGBColor(0x50, 0x97, 0xC8);
pub(super) const CERTAIN_GREY_GROUND: RGBColor = RGBColor(0xD0, 0xD0, 0xD0);
pub(super) const CERTAIN_PURPLE_GROUND: RGBColor = RGBColor(0x86, 0x3A, 0x66);
/// From what is safe to what is not: from light to dark.
pub(super) const SAFETY: [RGBColor; 4] = [
    RGBColor(0xEA, 0xF5, 0xFC),
    RGBColor(0x9A, 0xCD, 0xEC),
    RGBColor(0xC8, 0x92, 0x28),
    RGBColor(0x8F, 0x3D, 0x00),
];
/// Strokes through cells without a case.
pub(super) const NO_CASE: RGBColor = RGBColor(0x99, 0x99, 0x99);

/// Of parts of a whole, from none to all: from light to dark.
pub(super) const PARTS: [RGBColor; 6] = [
    GREY_GROUND,
    RGBColor(0xBF, 0xDA, 0xEE),
    RGBColor(0x8A, 0xBB, 0xDF),
    RGBColor(0x50, 0x97, 0xC8),
    RGBColor(0x24, 0x6A, 0xA8),
    RGBColor(0x0B, 0x35, 0x6B),
];

/// Of values in bands, from small to large: from light to dark, and none as light as paper.
pub(super) const BANDS: [RGBColor; 5] = [PARTS[1], PARTS[2], PARTS[3], PARTS[4], PARTS[5]];

// Tints of sky blue and orange, and of nothing.
pub(super) const SKY: RGBColor = RGBColor(0xD3, 0xEA, 0xF8);
pub(super) const SAND: RGBColor = RGBColor(0xF8, 0xDD, 0xA6);
pub(super) const PALE: RGBColor = RGBColor(0xEE, 0xEE, 0xEE);

// Lines that stay behind the curves.
pub(super) const GRID: RGBColor = RGBColor(0xE8, 0xE8, 0xE8);
pub(super) const REFERENCE: RGBColor = RGBColor(0x55, 0x55, 0x55);
pub(super) const CLEARANCE: RGBColor = RGBColor(0x44, 0x44, 0x44);
