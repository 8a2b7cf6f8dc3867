//! What was asked: of which string, over which quantities, in how many cases by which methods.

use super::equipment::length_of_string;
use crate::report::phrases::{capital, listed, plain, range};
use crate::report::results::Results;
use campaign::quantities::LENGTH;
use campaign::sweep_file::DesignKind;
use campaign::words::{counted, short};
use results::folder::Manifest;
use sim::Motion;

/// Quantities that are listed with their ranges; of more, the others are counted.
const MOST_RANGES: usize = 4;

/// The question, as a sentence or a few.
pub fn asked(results: &Results) -> String {
    let manifest = &results.manifest;
    let question = question(results);
    let methods = manifest.method_names();
    let by = match &methods[..] {
        [one] => format!("by one method, {one}"),
        many => format!("by {} methods: {}", many.len(), listed(many)),
    };
    let part = manifest.shard.map_or_else(String::new, |shard| {
        format!(" This is shard {shard}, a part of it.")
    });
    let so_far = results.tables.so_far.map_or_else(String::new, |so_far| {
        format!(" It is {so_far} are done; cases that every method has answered are shown.")
    });
    let cases = capital(&cases(manifest));
    format!("{question} {cases}, {by}.{part}{so_far}")
}

fn question(results: &Results) -> String {
    let manifest = &results.manifest;
    let units = manifest.sweep.units;
    let length = units.of(&LENGTH);
    let whole = length_of_string(&manifest.sweep);
    let whole = format!("{} {}", short(length.number(whole).round()), length.name);
    let design = manifest.sweep.design.as_ref();
    let ranges = manifest.axes.iter().zip(&results.ranges);
    let mut conditions: Vec<String> = (ranges.take(MOST_RANGES))
        .map(|(axis, &found)| {
            // As it was asked, where it was, not as far as random values reach.
            let asked = design.and_then(|design| design.axes.get(axis)?.ends());
            range(*axis, asked.unwrap_or(found), units)
        })
        .collect();
    let others = manifest.axes.len().saturating_sub(MOST_RANGES);
    if others > 0 {
        conditions.push(format!("{others} more that vary"));
    }
    let conditions = match conditions.is_empty() {
        true => String::new(),
        false => format!(", with {}", listed(&conditions)),
    };
    if !manifest.sweep.compare.is_empty() {
        let axes: Vec<String> = (manifest.axes.iter())
            .map(|&axis| plain(axis, units))
            .collect();
        return match axes.is_empty() {
            true => format!("How near is the motion of the {whole} string to what was recorded?"),
            false => format!(
                "Which {} bring the motion of the {whole} string nearest to what was \
                 recorded{conditions}?",
                listed(&axes)
            ),
        };
    }
    let motions = manifest.tally.motions();
    let does = match &motions[..] {
        [Motion::Lateral] => format!("Does the {whole} string whirl"),
        motions => {
            let mut does = vec![format!(
                "Does the bit below {whole} of string stick and slip"
            )];
            let has = |motion| motions.contains(&motion);
            does.extend(has(Motion::Axial).then(|| "does it chatter or bounce".to_owned()));
            does.extend(has(Motion::Lateral).then(|| "does the string whirl".to_owned()));
            match &does[..] {
                [only] => only.clone(),
                several => several.join(", and "),
            }
        }
    };
    format!("{does}{conditions}?")
}

/// How many cases, and how they were chosen.
fn cases(manifest: &Manifest) -> String {
    let cases = counted(manifest.cases, "case");
    let Some(design) = &manifest.sweep.design else {
        return cases;
    };
    match (design.kind, &manifest.trace) {
        (DesignKind::Grid, _) => format!("{cases} on a grid"),
        (DesignKind::MonteCarlo, _) => format!("{cases} drawn at random"),
        (DesignKind::List, _) => format!("{cases} of a list"),
        (DesignKind::Sensitivity, _) => {
            format!("{cases} in random blocks that show which quantity decides")
        }
        (DesignKind::Trace, None) => {
            format!("limits traced on a grid of {cases}")
        }
        (DesignKind::Trace, Some(trace)) => format!(
            "limits traced with {} of the {} of the equivalent grid",
            counted(trace.simulated, "case"),
            trace.cases_of_grid
        ),
    }
}
