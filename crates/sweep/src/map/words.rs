//! The words of a map: its legend, which names only what is on it, and its notes.

use super::content::Content;
use campaign::plan::MapMark;
use campaign::quantities::{Axis, Units};
use plot::{CellFill, Fraction, Symbol};
use results::folder::{Manifest, TraceSummary};
use sim::Motion;

/// Digits of a value that is one of a few, and exact but for rounding.
const EXACT: usize = 10;

/// A number in a number of significant digits, with a minus sign, not a hyphen.
fn in_digits(count: usize, value: f64) -> String {
    let rounded: f64 = format!("{value:.*e}", count - 1).parse().unwrap_or(value);
    rounded.to_string().replace('-', "−")
}

fn in_three(value: f64) -> String {
    in_digits(3, value)
}

/// A value with its unit.
pub fn quantity(axis: Axis, value: f64, units: Units) -> String {
    let unit = axis.unit(units);
    let number = in_three(unit.number(value));
    format!("{number} {}", unit.name).trim_end().to_owned()
}

/// A range with its unit, or the one value.
pub fn ends(axis: Axis, [low, high]: [f64; 2], units: Units) -> String {
    let unit = axis.unit(units);
    let [from, to] = [low, high].map(|end| in_three(unit.number(end)));
    let high = quantity(axis, high, units);
    if from == to {
        high
    } else {
        format!("{from} to {high}")
    }
}

/// An axis with one of its values.
pub fn equation(axis: Axis, value: f64, units: Units) -> String {
    let (name, unit) = (axis.words(units), axis.unit(units));
    let value = in_digits(EXACT, unit.rounded(value));
    let equation = format!("{name} = {value} {}", unit.name);
    equation.trim_end().to_owned()
}

/// An axis with its range, within a sentence.
pub fn range(axis: Axis, range: [f64; 2], units: Units) -> String {
    let name = axis.words(units);
    let first = name.chars().take(1).flat_map(char::to_lowercase);
    let name: String = first.chain(name.chars().skip(1)).collect();
    format!("{name} from {}", ends(axis, range, units))
}

/// The fills and symbols that are on any of the maps: parts from all to none of the
/// cases, then symbols.
pub fn keys(contents: &[Content], manifest: &Manifest, motion: Motion) -> Vec<(CellFill, String)> {
    let classes = Fraction::EVERY.into_iter().rev();
    let classes = classes.map(|part| (CellFill::Fraction(part), part.text().to_owned()));
    let mut keys: Vec<(CellFill, String)> = classes
        .chain([(CellFill::NoCase, "no case, or undetermined".to_owned())])
        .filter(|(fill, _)| {
            let is_fill = |other| other == *fill;
            contents.iter().any(|content| content.has_fill(is_fill))
        })
        .collect();
    keys.extend(symbols(contents, manifest, motion));
    keys
}

fn symbols(contents: &[Content], manifest: &Manifest, motion: Motion) -> Vec<(CellFill, String)> {
    let methods = manifest.method_names();
    let by_all = if methods.len() == 1 {
        ""
    } else {
        " by all methods"
    };
    let is_there = |symbol| contents.iter().any(|content| content.has(symbol));
    let meanings = Symbol::meanings((motion.regimes(), motion.lesser_regime()), by_all);
    let meanings = match manifest.certified_by {
        Some(_) => Symbol::by_certainty(meanings),
        None => meanings,
    };
    let mut found: Vec<_> = (meanings.into_iter())
        .filter(|(symbol, _)| is_there(*symbol))
        .map(|(symbol, meaning)| (CellFill::Symbol(symbol), meaning))
        .collect();
    if let (Some((_, first)), false) =
        (found.first_mut(), contents.iter().any(Content::is_of_parts))
    {
        *first += &format!(" ({})", methods.join(", "));
        if contents.iter().any(|content| !content.cells.is_empty()) {
            *first += &match &manifest.trace {
                Some(trace) => format!("; {}", of_grid(trace)),
                None => {
                    let cases: usize = contents.iter().map(|content| content.cases).sum();
                    format!("; a cell shows what most of its cases are, {cases} in all")
                }
            };
        }
    }
    found
}

/// What the fills of cells tell.
pub fn scale(
    motion: Motion,
    manifest: &Manifest,
    cases: usize,
    over: impl Iterator<Item = String>,
) -> String {
    let [regime, _] = motion.regimes();
    let methods = manifest.method_names();
    let mean = if methods.len() == 1 { "" } else { "mean of " };
    format!(
        "Cases with {regime} in each cell ({mean}{}), of {cases} cases over {}:",
        methods.join(", "),
        over.collect::<Vec<String>>().join(" and ")
    )
}

/// How many cases of a trace were simulated, and what the others are.
fn of_grid(trace: &TraceSummary) -> String {
    let (cases, all) = (trace.simulated, trace.cases_of_grid);
    format!("{cases} simulated cases (of {all} on the equivalent grid); the rest is filled in")
}

/// What the fills of a traced map tell that has tiles where its limit is no line.
pub fn ragged(motion: Motion, manifest: &Manifest, trace: &TraceSummary) -> String {
    let [regime, _] = motion.regimes();
    let methods = manifest.method_names();
    let mean = if methods.len() == 1 { "" } else { "mean of " };
    format!(
        "Cases with {regime} ({mean}{}): all or none of a region, a fraction of a tile where the \
         limit is ragged; {}:",
        methods.join(", "),
        of_grid(trace)
    )
}

/// How many cases a map does not show, and why.
pub fn undetermined(contents: &[Content], motion: Motion) -> Option<String> {
    let undetermined: usize = contents.iter().map(|content| content.undetermined).sum();
    let cases: usize = contents.iter().map(|content| content.cases).sum();
    let why = match motion {
        Motion::Torsion => "no answer, stuck to the end, or fading",
        Motion::Lateral => "no answer, or fading",
        Motion::Axial => "no answer",
    };
    (undetermined > 0).then(|| {
        format!(
            "not shown: {undetermined} of {cases} cases, undetermined \
                                        ({why})"
        )
    })
}

/// The marks that are outside of the map.
pub fn left_out(marks: &[&MapMark], [x, y]: [Axis; 2], units: Units) -> Option<String> {
    let marks: Vec<String> = (marks.iter())
        .map(|mark| {
            let place = [(x, mark.x), (y, mark.y)];
            let place = place
                .map(|(axis, value)| quantity(axis, value, units))
                .join(", ");
            format!("{} ({place})", mark.name)
        })
        .collect();
    (!marks.is_empty()).then(|| format!("marks outside this map: {}", marks.join("; ")))
}

/// Notes with the titles of their maps before them; without, where all of several
/// maps have the same.
pub fn once_if_the_same(notes: Vec<(String, String)>, maps: usize) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    for (title, note) in &notes {
        let same = notes.iter().filter(|(_, other)| other == note).count();
        let text = if title.is_empty() || same == maps {
            note.clone()
        } else {
            format!("{title}: {note}")
        };
        if !said.contains(&text) {
            said.push(text);
        }
    }
    said
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_carry_their_units() {
        let in_si = |axis, value| quantity(axis, value, Units::Si);
        assert_eq!(in_si(Axis::WeightOnBitKn, 123.456), "123 kN");
        assert_eq!(in_si(Axis::FRICTION, -0.054321), "−0.0543");
        let torques = ends(Axis::TorqueDynamicNm, [1.0, 2e3], Units::Si);
        assert_eq!(torques, "1 to 2000 N m");
        let speeds = ends(Axis::SurfaceSpeedRpm, [40.0; 2], Units::Si);
        assert_eq!(speeds, "40 rpm");
        let speed = equation(Axis::SurfaceSpeedRpm, 62.5, Units::Si);
        assert_eq!(speed, "Surface speed Ω = 62.5 rpm");
        let noisy = equation(Axis::FRICTION, -(0.1 + 0.2), Units::Si);
        assert!(noisy.ends_with(" = −0.3"), "{noisy}");
    }

    #[test]
    fn values_are_in_field_units() {
        let units = Units::Field;
        let weights = ends(Axis::WeightOnBitKn, [50.0, 200.0], units);
        assert_eq!(weights, "11.2 to 45 klbf");
        let weight = equation(Axis::WeightOnBitKn, 200.0, units);
        assert_eq!(weight, "Weight on bit W = 44.962 klbf");
        // As it may have been given, and what has no other unit.
        let given = equation(Axis::WeightOnBitKn, 45.0 * 4.4482216152605, units);
        assert_eq!(given, "Weight on bit W = 45 klbf");
        let speed = equation(Axis::SurfaceSpeedRpm, 62.512345, units);
        assert_eq!(speed, "Surface speed Ω = 62.512345 rpm");
        let torques = range(Axis::TorqueDynamicNm, [0.0, 2e3], units);
        assert_eq!(torques, "dynamic torque T_d from 0 to 1480 lbf ft");
    }

    #[test]
    fn a_note_of_every_map_is_made_once() {
        let note = |map: &str, note: &str| (map.to_owned(), note.to_owned());
        let notes = vec![note("a", "x"), note("a", "y"), note("b", "x")];
        assert_eq!(once_if_the_same(notes, 2), ["x", "a: y"]);
    }
}
