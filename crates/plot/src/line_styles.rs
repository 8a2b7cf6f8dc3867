//! Curves, and which colour and dash each has.

use super::colours::{BLACK, COLOURS, Colour, DARK_GREY};
use super::shapes::{DASHES, Stroke};
use super::symbols::Marker;

const FIRST_WIDTH: f64 = 2.4;
const LATER_WIDTH: f64 = 1.8;

/// Colour and dash of a curve; what is not given follows from its place among the others.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LineStyle {
    colour: Option<Colour>,
    dash: Option<usize>,
}

impl LineStyle {
    /// In a colour; its dashes follow from its place among the others.
    pub fn coloured(colour: Colour) -> Self {
        Self {
            colour: Some(colour),
            dash: None,
        }
    }

    /// In the colour and with the dashes of these numbers, counted from 0.
    pub fn numbered(colour: usize, dash: usize) -> Self {
        Self {
            colour: Some(COLOURS[colour % COLOURS.len()]),
            dash: Some(dash),
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
    pub fn colour(self) -> Option<Colour> {
        self.colour
    }
}

/// A named curve, or points of one kind.
pub struct Series {
    /// Name in the legend; what has the same name looks the same.
    pub name: String,
    /// How it looks.
    pub style: LineStyle,
    /// Its points; a curve has a gap where one cannot be shown.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A series that looks as its place among the others says.
    pub fn new(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self {
            name: name.into(),
            style: LineStyle::default(),
            points,
        }
    }

    /// The same in an style.
    pub fn styled(self, style: LineStyle) -> Self {
        Self { style, ..self }
    }
}

/// Distinct names, in order of appearance, and their styles with every colour given: what has the
/// same name looks the same.
pub(crate) fn distinct_styles<'a>(
    series: impl Iterator<Item = &'a Series>,
) -> Vec<(&'a str, LineStyle)> {
    let mut found: Vec<(&str, LineStyle)> = Vec::new();
    for series in series {
        if !found.iter().any(|(name, _)| *name == series.name) {
            found.push((&series.name, series.style));
        }
    }
    let taken: Vec<Colour> = found.iter().filter_map(|(_, style)| style.colour).collect();
    let mut free = COLOURS
        .into_iter()
        .filter(|colour| !taken.contains(colour))
        .cycle();
    for (_, style) in &mut found {
        style.colour = style.colour.or_else(|| free.next());
    }
    found
}

/// The looks of distinct names. Only the first is solid: where series coincide, it shows between
/// the dashes of the others.
pub(crate) fn strokes(styles: &[(&str, LineStyle)]) -> Vec<Stroke> {
    let strokes = styles.iter().enumerate().map(|(index, (_, style))| {
        let dash = match style.dash.unwrap_or(index) {
            0 => DASHES[0],
            later => DASHES[1 + (later - 1) % (DASHES.len() - 1)],
        };
        Stroke {
            colour: style.colour.unwrap_or(BLACK),
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
pub(crate) fn markers(styles: &[(&str, LineStyle)]) -> Vec<Marker> {
    let markers = styles.iter().enumerate().map(|(kind, (_, style))| Marker {
        kind,
        colour: style.colour.unwrap_or(BLACK),
    });
    markers.collect()
}

/// The place of a name among distinct ones.
pub(crate) fn place_among(name: &str, styles: &[(&str, LineStyle)]) -> usize {
    let place = styles.iter().position(|(other, _)| *other == name);
    place.unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_that_is_given_is_given_to_no_other() {
        let given = Series::new("given", Vec::new()).styled(LineStyle::coloured(COLOURS[0]));
        let [first, second] = ["first", "second"].map(|name| Series::new(name, Vec::new()));
        let styles = distinct_styles([&first, &given, &second].into_iter());
        let colours: Vec<_> = styles.iter().map(|(_, style)| style.colour).collect();
        assert_eq!(colours, [COLOURS[1], COLOURS[0], COLOURS[2]].map(Some));
    }

    #[test]
    fn one_number_is_that_of_the_colour_and_one_that_of_the_dashes() {
        let list = [(0, 0), (0, 1), (1, 0)].map(|(colour, dash)| {
            let series = Series::new(format!("{colour} {dash}"), Vec::new());
            series.styled(LineStyle::numbered(colour, dash))
        });
        let strokes = strokes(&distinct_styles(list.iter()));
        assert!(strokes[0].colour == strokes[1].colour && strokes[0].dash != strokes[1].dash);
        assert!(strokes[0].colour != strokes[2].colour && strokes[0].dash == strokes[2].dash);
    }
}
