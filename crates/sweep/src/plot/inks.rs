//! Curves, and which colour and dash each has. A method has one colour in every picture.

use super::colours::{
    BLACK, BLUE, COLOURS, Colour, DARK_GREY, GREEN, ORANGE, PURPLE, RED, SKY_BLUE,
};
use super::shapes::{DASHES, Stroke};
use super::symbols::Marker;

const FIRST_WIDTH: f64 = 2.4;
const LATER_WIDTH: f64 = 1.8;

/// The colours of methods, and of exact responses. Those of the four that draw limits on maps are
/// none of the colours of their symbols.
const METHODS: [(&str, Colour); 8] = [
    ("held", BLACK),
    ("quadrature", GREEN),
    ("finite-element", RED),
    ("hilbert", PURPLE),
    ("trapezoidal", SKY_BLUE),
    ("direct-idft", ORANGE),
    ("radau-quadrature", BLUE),
    ("exact", DARK_GREY),
];

/// Colour and dash of a curve; what is not given follows from its place among the others.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ink {
    colour: Option<Colour>,
    dash: Option<usize>,
}

impl Ink {
    /// Of a method, by what a name begins with up to a comma or a space.
    pub fn of_method(name: &str) -> Self {
        let method = name.split([',', ' ']).next();
        let known = METHODS
            .into_iter()
            .find(|(known, _)| Some(*known) == method);
        Self {
            colour: known.map(|(_, colour)| colour),
            dash: None,
        }
    }

    /// Of a case by a method, each by its number among those of a picture: a colour for the case,
    /// dashes for the method.
    pub fn of_case(case: usize, method: usize) -> Self {
        Self {
            colour: Some(COLOURS[case % COLOURS.len()]),
            dash: Some(method),
        }
    }

    /// Of a line that is there to compare with: grey, with the dashes of a number.
    pub fn grey(dash: usize) -> Self {
        Self {
            colour: Some(DARK_GREY),
            dash: Some(dash),
        }
    }

    /// The colour, if it is given.
    pub(super) fn colour(self) -> Option<Colour> {
        self.colour
    }
}

/// A named curve, or points of one kind.
pub struct Series {
    /// Name in the legend; what has the same name looks the same.
    pub name: String,
    /// How it looks.
    pub ink: Ink,
    /// Its points; a curve has a gap where one cannot be shown.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A series that looks as its place among the others says.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            ink: Ink::default(),
            points,
        }
    }

    /// The same in an ink.
    pub fn inked(self, ink: Ink) -> Self {
        Self { ink, ..self }
    }
}

/// Distinct names, in order of appearance, and their inks with every colour given: what has the
/// same name looks the same.
pub(super) fn distinct_inks<'a>(series: impl Iterator<Item = &'a Series>) -> Vec<(&'a str, Ink)> {
    let mut found: Vec<(&str, Ink)> = Vec::new();
    for series in series {
        if !found.iter().any(|(name, _)| *name == series.name) {
            found.push((&series.name, series.ink));
        }
    }
    let taken: Vec<Colour> = found.iter().filter_map(|(_, ink)| ink.colour).collect();
    let mut free = COLOURS
        .into_iter()
        .filter(|colour| !taken.contains(colour))
        .cycle();
    for (_, ink) in &mut found {
        ink.colour = ink.colour.or_else(|| free.next());
    }
    found
}

/// The looks of distinct names. Only the first is solid: where series coincide, it shows between
/// the dashes of the others.
pub(super) fn strokes(inks: &[(&str, Ink)]) -> Vec<Stroke> {
    let strokes = inks.iter().enumerate().map(|(index, (_, ink))| {
        let dash = match ink.dash.unwrap_or(index) {
            0 => DASHES[0],
            later => DASHES[1 + (later - 1) % (DASHES.len() - 1)],
        };
        Stroke {
            colour: ink.colour.unwrap_or(BLACK),
            width: if dash.is_empty() {
                FIRST_WIDTH
            } else {
                LATER_WIDTH
            },
            dash,
        }
    });
    strokes.collect()
}

/// The markers of distinct names.
pub(super) fn markers(inks: &[(&str, Ink)]) -> Vec<Marker> {
    let markers = inks.iter().enumerate().map(|(kind, (_, ink))| Marker {
        kind,
        colour: ink.colour.unwrap_or(BLACK),
    });
    markers.collect()
}

/// The place of a name among distinct ones.
pub(super) fn place_among(name: &str, inks: &[(&str, Ink)]) -> usize {
    let place = inks.iter().position(|(other, _)| *other == name);
    place.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> Series {
        Series::new(name, Vec::new()).inked(Ink::of_method(name))
    }

    #[test]
    fn a_method_has_the_same_colour_whatever_is_beside_it() {
        let [held, hilbert, recorded] = ["held", "hilbert, γ = 0.5", "recorded"].map(named);
        let alone = distinct_inks([&hilbert].into_iter());
        let beside = distinct_inks([&recorded, &held, &hilbert].into_iter());
        assert_eq!(alone[0].1.colour, beside[2].1.colour);
        let colours: Vec<_> = beside.iter().map(|(_, ink)| ink.colour).collect();
        assert!(colours[0] != colours[1] && colours[0] != colours[2]);
    }

    #[test]
    fn methods_differ_in_colour() {
        for (index, (_, colour)) in METHODS.iter().enumerate() {
            assert!(METHODS[..index].iter().all(|(_, other)| other != colour));
        }
    }

    #[test]
    fn cases_differ_in_colour_and_methods_in_dashes() {
        let list = [(0, 0), (0, 1), (1, 0)].map(|(case, method)| {
            Series::new(format!("{case} {method}"), Vec::new()).inked(Ink::of_case(case, method))
        });
        let strokes = strokes(&distinct_inks(list.iter()));
        assert!(strokes[0].colour == strokes[1].colour && strokes[0].dash != strokes[1].dash);
        assert!(strokes[0].colour != strokes[2].colour && strokes[0].dash == strokes[2].dash);
    }
}
