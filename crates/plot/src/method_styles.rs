//! The style of methods: one has the same colour in every picture.

use super::LineStyle;
use super::colours::{BLACK, BLUE, Colour, DARK_GREY, GREEN, ORANGE, PLUM, PURPLE, RED, SKY_BLUE};

/// The colours of methods, and of exact responses. Those of the four that draw limits on maps
/// differ from the colours of symbols.
const METHODS: [(&str, Colour); 9] = [
    ("held", BLACK),
    ("quadrature", GREEN),
    ("finite-element", RED),
    ("hilbert", PURPLE),
    ("poles", PLUM),
    ("trapezoidal", SKY_BLUE),
    ("direct-idft", ORANGE),
    ("radau-quadrature", BLUE),
    ("exact", DARK_GREY),
];

/// The style of a method, by what a name begins with up to a comma or a space. Of an unknown one it
/// follows from its place among the others of a picture.
pub fn method_style(name: &str) -> LineStyle {
    let method = name.split([',', ' ']).next();
    let known = METHODS
        .into_iter()
        .find(|(known, _)| Some(*known) == method);
    known.map_or_else(LineStyle::default, |(_, colour)| {
        LineStyle::coloured(colour)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_method_has_its_colour_with_any_suffix() {
        assert_eq!(method_style("hilbert, γ = 0.5"), method_style("hilbert"));
        assert_eq!(method_style("recorded"), LineStyle::default());
    }

    #[test]
    fn methods_differ_in_colour() {
        for (index, (_, colour)) in METHODS.iter().enumerate() {
            assert!(METHODS[..index].iter().all(|(_, other)| other != colour));
        }
    }
}
