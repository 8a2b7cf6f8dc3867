//! What was found: how much of each regime, where it begins, and what fits a recording best.

use crate::report::lattice::{Column, Found, Lattice, Limit};
use crate::report::phrases::{
    capital, clauses, condition, every_without, listed, number, plain, range, share, value_of,
};
use crate::report::results::Results;
use campaign::quantities::{Axis, Units};
use campaign::words::short;
use results::analysis::{Counts, sensitivity};
use results::folder::column_words;
use sim::{Label, LateralRegime, Motion};

/// What came out, as sentences.
pub fn found(results: &Results) -> String {
    if results.cases == 0 {
        return "No case is in this part.".to_owned();
    }
    let mut sentences: Vec<String> = nearest(results).into_iter().collect();
    for (motion, _) in &results.agreement.shown {
        sentences.push(shares(results, *motion));
        // Further quantities that are drawn at random blur the limit on the map.
        let is_blurred = results.manifest.axes.len() > 2 && results.is_random();
        let lattice = results.lattice.as_ref().filter(|_| !is_blurred);
        sentences.extend(lattice.and_then(|lattice| limits(results, lattice, *motion)));
    }
    sentences.extend(results.manifest.tally.motor_sentence());
    sentences.extend(deciding(results));
    sentences.join(" ")
}

/// How much of each regime: of a traced design, of the area of its map.
fn shares(results: &Results, motion: Motion) -> String {
    let [subject, with, without] = clauses(motion);
    let shown = &results.agreement.shown;
    let Some((_, shown)) = shown.iter().find(|(other, _)| *other == motion) else {
        return String::new();
    };
    let traced = results
        .lattice
        .as_ref()
        .and_then(|lattice| lattice.traced(motion));
    let (whole, all, [circles, crosses, squares]) = match traced {
        Some(counts) => ("the map", counts.iter().sum(), counts),
        None => (
            "the cases",
            results.cases,
            [shown.circles, shown.crosses, shown.squares],
        ),
    };
    let either = format!("{with} or {without} depending on the start");
    let counts = [
        (circles, with.to_owned()),
        (shown.diamonds, either),
        (crosses, without.to_owned()),
    ];
    let some = counts.iter().filter(|(count, _)| *count > 0);
    let parts: Vec<String> = (some.enumerate())
        .map(|(place, (count, words))| {
            let of = match place {
                0 => format!(" of {whole}"),
                _ => String::new(),
            };
            format!("{words} in {}{of}", share(*count, all))
        })
        .collect();
    let by = match results.manifest.methods.len() {
        1 => capital(subject),
        _ => format!("By every method {subject}"),
    };
    let mut sentence = if circles == all {
        format!("{by} {with} in every case")
    } else if crosses == all {
        format!("{by} {without} in {} case", every_without(motion))
    } else if parts.is_empty() {
        format!("Of {whole}, none is decided by every method")
    } else {
        format!("{by} {}", listed(&parts))
    };
    if squares > 0 {
        sentence += &format!("; the methods differ in {}", share(squares, all));
    }
    if shown.undrawn > 0 && traced.is_none() {
        sentence += &format!("; {} is undetermined", share(shown.undrawn, all));
    }
    if motion == Motion::Lateral {
        sentence += &kinds_of_whirl(results);
    }
    sentence + "."
}

/// Which whirl it is, by the method that has most of it.
fn kinds_of_whirl(results: &Results) -> String {
    let count = |regime: LateralRegime| {
        let label = Label::from(regime);
        let methods = results.methods().into_iter();
        methods
            .map(|method| results.count(method, label))
            .max()
            .unwrap_or(0)
    };
    match [LateralRegime::BackwardWhirl, LateralRegime::ForwardWhirl].map(count) {
        [0, 0] => String::new(),
        [_, 0] => "; all whirl is backward".to_owned(),
        [0, _] => "; all whirl is forward".to_owned(),
        [backward, forward] => format!(
            "; {} is backward whirl, {} forward",
            share(backward, results.cases),
            share(forward, results.cases)
        ),
    }
}

/// Where the regime begins, at the least, a middle and the greatest value of what the limit
/// depends on.
fn limits(results: &Results, lattice: &Lattice, motion: Motion) -> Option<String> {
    let columns = lattice.columns(motion);
    let (first, last) = (columns.first()?, columns.last()?);
    let is_mixed = |column: &&Column| !matches!(column.found, Found::Always | Found::Never);
    columns.iter().find(is_mixed)?;
    let middle = &columns[columns.len() / 2];
    let mut shown: Vec<&Column> = vec![first, middle, last];
    shown.dedup_by_key(|column| column.at);
    let units = results.manifest.sweep.units;
    let step = match &columns[..] {
        [one, next, ..] if lattice.has_values() => (next.at - one.at).min(one.width),
        _ => first.width,
    };
    let [subject, ..] = clauses(motion);
    let mut clauses: Vec<String> = Vec::new();
    for (place, column) in shown.iter().enumerate() {
        let at = number(lattice.axes[1], column.at, step, units);
        let about = if lattice.has_values() { "" } else { "about " };
        let at = condition(lattice.axes[1], &format!("{about}{at}"), units);
        let subject = if place == 0 { subject } else { "it" };
        let words = column_text(column.found, motion, lattice.axes[0], units);
        clauses.push(format!("at {at} {subject} {words}"));
    }
    Some(format!("{}.", capital(&clauses.join("; "))))
}

/// What is found along the limited quantity, after its subject.
pub fn column_text(found: Found, motion: Motion, limited: Axis, units: Units) -> String {
    let [_, with, without] = clauses(motion);
    match found {
        Found::Always => format!("{with} at every {}", value_of(limited, units)),
        Found::Never => {
            let every = every_without(motion);
            format!("{without} at {every} {}", value_of(limited, units))
        }
        Found::Scattered(part) => {
            format!("{with} in {:.0} % of the cases", 100.0 * part)
        }
        Found::Limit(limit) => format!("{with} {}", limit_text(limit, limited, units)),
    }
}

/// Where a limit is: `below about 98 rpm`.
pub fn limit_text(limit: Limit, axis: Axis, units: Units) -> String {
    let Limit {
        is_below,
        whole,
        none,
        step,
    } = limit;
    let [side, beyond, until] = match is_below {
        true => ["below", "above", "up to"],
        false => ["above", "below", "from"],
    };
    let at = |value: f64| number(axis, value, step, units);
    let about = |value: f64| condition(axis, &format!("about {}", at(value)), units);
    match (whole, none) {
        (Some(whole), Some(none)) if whole == none => format!("{side} {}", about(whole)),
        (Some(whole), Some(none)) => {
            let on = if is_below { "" } else { " on" };
            format!(
                "{side} {}, and partly {until} {}{on}",
                about(whole),
                at(none)
            )
        }
        (Some(whole), None) => format!("{side} {}, and partly {beyond}", about(whole)),
        (None, Some(none)) => format!("partly {side} {}", about(none)),
        (None, None) => "partly".to_owned(),
    }
}

/// Which quantity decides most, of random cases: what explains most of the variance alone, with
/// the shares at its two ends.
fn deciding(results: &Results) -> Option<String> {
    let analysed = results.analysed.as_ref()?;
    let axes = results.manifest.axes.len();
    if axes < 2 || analysed.counts.len() <= axes {
        return None;
    }
    let units = results.manifest.sweep.units;
    let of_axis = |counts: &'_ Counts| {
        let (_, _, group) = counts.groups.first()?;
        Some(sensitivity(&group.sustained())?.value)
    };
    let indices = analysed.counts[1..=axes].iter();
    let indices = indices.filter_map(|counts| Some((counts, of_axis(counts)?)));
    let (counts, most) = indices.max_by(|one, other| one.1.total_cmp(&other.1))?;
    if most <= 0.0 {
        return None;
    }
    let bins = &counts.bins[0];
    let (_, motion, group) = counts.groups.first()?;
    let [regime, _] = motion.regimes();
    let sustained = group.sustained();
    let end = |place: usize| {
        let [count, of] = sustained[place];
        let range = range(bins.axis, bins.ranges[place], units);
        format!("{} with {range}", share(count, of))
    };
    Some(format!(
        "The {} decides most, alone {:.0} % of the variance: {regime} in {}, in {}.",
        plain(bins.axis, units),
        100.0 * most,
        end(0),
        end(sustained.len() - 1)
    ))
}

/// The case that is nearest to the first recording, and how near others are to further ones.
fn nearest(results: &Results) -> Option<String> {
    let units = results.manifest.sweep.units;
    let ((first, best), others) = results.nearest.split_first()?;
    let of = |column: &str, misfit: f64| {
        let (words, unit) = column_words(column, units);
        let name = words.strip_prefix("Misfit, ").unwrap_or(&words).to_owned();
        (
            name,
            format!("{} {}", short(unit.number(misfit)), unit.name),
        )
    };
    let axes = results.manifest.axes.iter().zip(&best.values);
    let values: Vec<String> = axes
        .map(|(&axis, &value)| {
            let value = number(axis, value, 0.0, units);
            format!("{} {value}", plain(axis, units))
        })
        .collect();
    let with = match values.is_empty() {
        true => String::new(),
        false => format!(", with {}", listed(&values)),
    };
    let (name, misfit) = of(first, best.misfit);
    let mut sentence = format!(
        "Nearest to the recording “{name}” is case {} by {}, {misfit} off (root mean \
         square){with}.",
        best.case, best.method
    );
    let others: Vec<String> = (others.iter())
        .map(|(column, best)| {
            let (name, misfit) = of(column, best.misfit);
            format!("{misfit} off “{name}” (case {})", best.case)
        })
        .collect();
    if !others.is_empty() {
        sentence += &format!(" At best {}.", listed(&others));
    }
    Some(sentence)
}
