//! Quantities as a driller says them: words without letters, numbers with their units in the
//! digits that are resolved.

use campaign::quantities::{Axis, Units};
use campaign::words::decimals;
use sim::Motion;

/// What a quantity is, in words within a sentence, without its letter.
pub fn plain(axis: Axis, units: Units) -> String {
    let words = axis.words(units);
    let mut kept: Vec<&str> = words.split(' ').collect();
    while kept.len() > 1 && kept.last().is_some_and(|word| is_letter(word)) {
        kept.pop();
    }
    let words = kept.join(" ");
    let first = words.chars().take(1).flat_map(char::to_lowercase);
    first.chain(words.chars().skip(1)).collect()
}

/// Whether a word of a title is the letter of the quantity.
fn is_letter(word: &str) -> bool {
    let is_word = |word: &str| {
        word.chars()
            .all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit())
    };
    word == "/" || word.contains('_') || (word.chars().count() <= 3 && !is_word(word))
}

/// A value of a quantity, whichever it is: `speed`.
pub fn value_of(axis: Axis, units: Units) -> String {
    match axis {
        Axis::SurfaceSpeedRpm => "speed".to_owned(),
        Axis::WeightOnBitKn => "weight".to_owned(),
        Axis::FRICTION => "friction".to_owned(),
        Axis::ImpulseRatio => "impulse".to_owned(),
        other => plain(other, units),
    }
}

/// The word before what is without vibration in all cases: the bit turns smoothly in every one, the
/// string does not whirl in any.
pub fn every_without(motion: Motion) -> &'static str {
    match motion {
        Motion::Torsion | Motion::Axial => "every",
        Motion::Lateral => "any",
    }
}

/// A value with its unit, in as many digits as a `step` resolves; none resolves four digits.
pub fn number(axis: Axis, value: f64, step: f64, units: Units) -> String {
    let unit = axis.unit(units);
    let (value, step) = (unit.number(value), unit.number(step).abs());
    let size = if step > 0.0 { step } else { value.abs() * 2e-3 };
    let count = match size {
        size if size > 0.0 => (-(0.5 * size).log10().floor()).clamp(0.0, 9.0) as usize,
        _ => 0,
    };
    let text = decimals(value, count);
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    format!("{text} {}", unit.name).trim_end().to_owned()
}

/// A value as the condition that it is: `120 kN`, `a friction of 1.2`.
pub fn condition(axis: Axis, value: &str, units: Units) -> String {
    match axis {
        Axis::SurfaceSpeedRpm | Axis::WeightOnBitKn => value.to_owned(),
        Axis::FRICTION => format!("a friction of {value}"),
        Axis::ImpulseRatio => format!("an impulse of {value} I₀"),
        other => format!("a {} of {value}", plain(other, units)),
    }
}

/// A range as the condition that it is, in digits that tell its ends apart and from zero.
pub fn range(axis: Axis, [from, to]: [f64; 2], units: Units) -> String {
    let ends = [from, to]
        .map(f64::abs)
        .into_iter()
        .filter(|end| *end > 0.0);
    let step = ends.map(|end| 0.5 * end).fold(0.1 * (to - from), f64::min);
    let name = plain(axis, units);
    if from == to {
        return format!("{name} {}", number(axis, to, 0.0, units));
    }
    let unit = axis.unit(units).name;
    let low = number(axis, from, step, units);
    let low = low.strip_suffix(&unit).unwrap_or(&low).trim_end();
    format!("{name} from {low} to {}", number(axis, to, step, units))
}

/// What moves, what it does in sustained vibration, and without.
pub fn clauses(motion: Motion) -> [&'static str; 3] {
    match motion {
        Motion::Torsion => ["the bit", "sticks and slips", "turns smoothly"],
        Motion::Lateral => ["the string", "whirls", "does not whirl"],
        Motion::Axial => ["the bit", "chatters or bounces", "drills steadily"],
    }
}

/// A count in parts of all, in whole per cent; few of many are less than one.
pub fn share(part: usize, whole: usize) -> String {
    if whole == 0 {
        return "0 %".to_owned();
    }
    let per_cent = 100.0 * part as f64 / whole as f64;
    match (part, per_cent) {
        (0, _) => "0 %".to_owned(),
        (_, few) if few < 0.5 => "less than 1 %".to_owned(),
        (part, most) if part < whole && most >= 99.5 => "more than 99 %".to_owned(),
        (_, per_cent) => format!("{per_cent:.0} %"),
    }
}

/// `a`, `a and b`, `a, b and c`.
pub fn listed<Text: AsRef<str>>(items: &[Text]) -> String {
    let items: Vec<&str> = items.iter().map(AsRef::as_ref).collect();
    match &items[..] {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// With a capital letter.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use campaign::quantities::StringAxis;

    #[test]
    fn a_quantity_is_said_without_its_letter() {
        for (axis, words) in [
            (Axis::SurfaceSpeedRpm, "surface speed"),
            (Axis::ImpulseRatio, "impulse"),
            (Axis::FRICTION, "coefficient of friction"),
            (Axis::TorqueStaticRatio, "static by dynamic torque"),
            (Axis::TorqueDecay, "speed over which the torque falls"),
            (
                Axis::String(StringAxis::Repeat { section: 0 }),
                "cells of section 0",
            ),
        ] {
            assert_eq!(plain(axis, Units::Si), words);
        }
    }

    /// A tenth of a step is not resolved.
    #[test]
    fn numbers_have_the_digits_that_are_resolved() {
        let speed = |value, step| number(Axis::SurfaceSpeedRpm, value, step, Units::Si);
        assert_eq!(speed(97.5, 5.0), "98 rpm");
        assert_eq!(speed(0.1316, 0.024), "0.13 rpm");
        assert_eq!(speed(60.0, 0.0), "60 rpm");
        let weight = number(Axis::WeightOnBitKn, 200.0, 10.0, Units::Field);
        assert_eq!(weight, "45 klbf");
        assert_eq!(
            range(Axis::SurfaceSpeedRpm, [60.0, 180.0], Units::Si),
            "surface speed from 60 to 180 rpm"
        );
        assert_eq!(
            range(Axis::FRICTION, [0.5; 2], Units::Si),
            "coefficient of friction 0.5"
        );
    }

    #[test]
    fn few_of_many_are_not_none_and_nearly_all_are_not_all() {
        let shares = [(0, 900), (1, 900), (450, 900), (899, 900), (900, 900)];
        let shares = shares.map(|(part, whole)| share(part, whole));
        assert_eq!(
            shares,
            ["0 %", "less than 1 %", "50 %", "more than 99 %", "100 %"]
        );
    }
}
