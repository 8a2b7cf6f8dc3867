//! The heading of a column: a name and a unit, as people write them. `measured_depth_m`,
//! `Measured Depth (m)`, `MD [ft]`, `Weight, kN` and `O.D. (in)` are read by one rule.

use super::units::{Dimension, is_unit, plain};

/// Words after the name of a quantity that make another of it, or no quantity.
const NOT_UNITS: [&str; 22] = [
    "above",
    "below",
    "class",
    "code",
    "connection",
    "cum",
    "cumulative",
    "grade",
    "max",
    "maximum",
    "min",
    "minimum",
    "no",
    "number",
    "size",
    "status",
    "tag",
    "thread",
    "tolerance",
    "top",
    "total",
    "type",
];

/// A heading.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Heading {
    /// As the file has it.
    pub text: String,
    /// Its words in small letters, without a unit in brackets.
    words: Vec<String>,
    /// A unit in brackets, behind a comma or in a separate row, as [`plain`] has it.
    unit: Option<String>,
}

/// What a heading is to a quantity.
#[derive(Debug, Clone, PartialEq)]
pub enum Meaning {
    /// That quantity; what its numbers are multiplied by.
    Quantity(f64),
    /// That quantity, in a unit that it does not name.
    NoUnit,
    /// That quantity, in a unit that it has not.
    OtherUnit(String),
    /// Something else.
    Other,
}

impl Heading {
    /// By a text.
    pub fn new(text: &str) -> Self {
        let text = text.trim();
        let (name, unit) = divided(text);
        // "O.D.", "No. of Joints", "# of joints".
        let name = name.replace('.', "").replace('#', " no ");
        let name = plain(&name);
        let words = name.split('_').filter(|word| !word.is_empty());
        Self {
            text: text.to_owned(),
            words: words.map(|word| in_full(word).to_owned()).collect(),
            unit: unit.map(plain),
        }
    }

    /// The same with a unit from a separate row, where it does not have one.
    pub fn in_unit(&self, text: &str) -> Self {
        let bare = bare(text);
        let unit = plain(bare);
        let mut heading = self.clone();
        let names_one = self.unit.is_some() || self.divisions().any(|(_, unit)| is_unit(&unit));
        if !names_one && !unit.is_empty() {
            heading.unit = Some(unit);
            heading.text = format!("{} ({bare})", heading.text);
        }
        heading
    }

    /// Whether a text is nothing but a unit, perhaps in brackets.
    pub fn is_unit(text: &str) -> bool {
        is_unit(&plain(bare(text)))
    }

    /// Whether there is nothing in it.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// All of it as one name, such as `surface_speed_rpm`.
    pub fn snake(&self) -> String {
        let words = self.words.iter().chain(&self.unit);
        words.map(String::as_str).collect::<Vec<_>>().join("_")
    }

    /// What it is to a quantity of some names, in words with `_` between them. Where that has a
    /// dimension it has a unit.
    pub fn meaning(&self, names: &[&str], dimension: Option<Dimension>) -> Meaning {
        let all = self.words.join("_");
        let is_named = |name: &str| names.contains(&name);
        let Some(dimension) = dimension else {
            let name = match &self.unit {
                Some(unit) if !is_unit(unit) => format!("{all}_{unit}"),
                _ => all.clone(),
            };
            return match is_named(&all) || is_named(&name) {
                true => Meaning::Quantity(1.0),
                false => Meaning::Other,
            };
        };
        if let Some(unit) = &self.unit {
            return match (is_named(&all), dimension.factor(unit)) {
                (true, Some(factor)) => Meaning::Quantity(factor),
                (true, None) => Meaning::OtherUnit(unit.clone()),
                _ => Meaning::Other,
            };
        }
        for (name, unit) in self.divisions() {
            if let Some(factor) = dimension.factor(&unit).filter(|_| is_named(&name)) {
                return Meaning::Quantity(factor);
            }
        }
        if is_named(&all) && !all.is_empty() {
            return Meaning::NoUnit;
        }
        match self.words.split_last() {
            Some((last, before)) if !before.is_empty() && is_named(&before.join("_")) => {
                match NOT_UNITS.contains(&last.as_str()) {
                    true => Meaning::Other,
                    false => Meaning::OtherUnit(last.clone()),
                }
            }
            _ => Meaning::Other,
        }
    }

    /// What its numbers are multiplied by, for any name, where it has a unit of a dimension.
    pub fn factor(&self, dimension: Dimension) -> Option<f64> {
        match &self.unit {
            Some(unit) => dimension.factor(unit),
            None => (self.divisions()).find_map(|(_, unit)| dimension.factor(&unit)),
        }
    }

    /// Its words as a name and a unit of one to five words, the longest first.
    fn divisions(&self) -> impl Iterator<Item = (String, String)> {
        let count = self.words.len();
        (1..=count.min(5)).rev().map(move |of_unit| {
            let (name, unit) = self.words.split_at(count - of_unit);
            (name.join("_"), unit.join("_"))
        })
    }
}

/// Words as people shorten them in headings; names of quantities have them in full.
const SHORT: [(&str, &str); 18] = [
    ("wt", "weight"),
    ("wgt", "weight"),
    ("lin", "linear"),
    ("nom", "nominal"),
    ("adj", "adjusted"),
    ("approx", "approximate"),
    ("avg", "average"),
    ("ave", "average"),
    ("dia", "diameter"),
    ("diam", "diameter"),
    ("len", "length"),
    ("lgth", "length"),
    ("jt", "joint"),
    ("jts", "joints"),
    ("meas", "measured"),
    ("incl", "inclination"),
    ("azim", "azimuth"),
    ("corr", "corrected"),
];

fn in_full(word: &str) -> &str {
    let known = SHORT.iter().find(|(short, _)| *short == word);
    known.map_or(word, |(_, full)| full)
}

/// A text without brackets around it.
fn bare(text: &str) -> &str {
    text.trim().trim_matches(['(', ')', '[', ']', '{', '}'])
}

/// A name, and what stands in the last brackets or behind the last comma.
fn divided(text: &str) -> (String, Option<&str>) {
    for (open, close) in [('(', ')'), ('[', ']'), ('{', '}')] {
        let Some(inside) = text.strip_suffix(close) else {
            continue;
        };
        if let Some((name, unit)) = inside.rsplit_once(open) {
            return (name.to_owned(), Some(unit));
        }
    }
    match text.rsplit_once(',') {
        Some((name, unit)) if is_unit(&plain(unit)) => (name.to_owned(), Some(unit)),
        _ => (text.to_owned(), None),
    }
}
