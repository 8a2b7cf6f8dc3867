//! How sure the answer is: whether methods agree, what is certain, what failed, and how many cases
//! are on the side of the analytic line that it does not expect.

use crate::report::limit::{LimitCheck, Limited};
use crate::report::phrases::{capital, listed, share};
use crate::report::results::Results;
use campaign::engine::is_unstable;
use campaign::words::{counted, short};
use results::analysis::wilson;

/// What speaks for the answer and against it, as sentences.
pub fn sureness(results: &Results) -> String {
    let sentences = [
        Some(agreement(results)),
        certain(results),
        interval(results),
        margin(results),
        Some(answers(results)),
        settled(results),
        unstable(results),
        depends(results),
        damped(results),
    ];
    sentences
        .into_iter()
        .flatten()
        .collect::<Vec<_>>()
        .join(" ")
}

fn agreement(results: &Results) -> String {
    let agreement = &results.agreement;
    match (&agreement.pairs[..], results.cases) {
        (_, 0) => "There is no case yet.".to_owned(),
        ([], _) => "Only one method was used: no other checks it.".to_owned(),
        (_, cases) => {
            let same = cases - agreement.differing.min(cases);
            let of = match results.manifest.is_trace() {
                true => "the simulated cases, which lie along the limit",
                false => "the cases",
            };
            format!("The methods agree on {} of {of}.", share(same, cases))
        }
    }
}

fn certain(results: &Results) -> Option<String> {
    let manifest = &results.manifest;
    let by = manifest.certified_by.as_ref()?;
    let motions = manifest.tally.motions().into_iter();
    let shares: Vec<String> = motions
        .map(|motion| {
            let certain = manifest.tally.certified(motion);
            format!(
                "{} of the {} labels",
                share(certain, results.cases),
                motion.adjective()
            )
        })
        .collect();
    let differing = manifest.tally.other_whirl_words();
    let differing = differing.map_or_else(String::new, |words| format!(" {}.", capital(&words)));
    Some(format!(
        "By {} at two sampling frequencies {} are certain.{differing}",
        listed(&by.methods),
        listed(&shares)
    ))
}

/// Of random cases, the interval of the first method's share.
fn interval(results: &Results) -> Option<String> {
    let counts = results.analysed.as_ref()?.counts.first()?;
    let (_, motion, group) = counts.groups.first()?;
    let [count, of] = *group.sustained().first()?;
    let interval = wilson(count, of)?;
    let [low, high] = [interval.low, interval.high].map(|end| format!("{:.0}", 100.0 * end));
    let [regime, _] = motion.regimes();
    Some(format!(
        "With this number of random cases, the share of {regime} is between {low} and {high} % (95 % interval)."
    ))
}

/// Cases on either side of what is known of their motion without them.
fn margin(results: &Results) -> Option<String> {
    let tally = &results.manifest.tally;
    let counts = tally
        .estimate_words()
        .map(|(method, words)| format!("By {method} {words}."));
    let sentences: Vec<String> = counts.chain(furthest(results)).collect();
    (!sentences.is_empty()).then(|| sentences.join(" "))
}

/// How far the cases of either regime reach to the side that the analytic line does not expect.
fn furthest(results: &Results) -> Option<String> {
    let limits = results.limits.as_ref()?;
    let of = |place: fn(&LimitCheck) -> Option<f64>, further: fn(f64, f64) -> f64| {
        let furthest = limits.checks.iter().filter_map(place).reduce(further)?;
        Some(short((100.0 * furthest).round() / 100.0))
    };
    match limits.limited {
        Limited::StickSlip => {
            let stick_slip = of(|check| check.last_vibrating, f64::max)
                .map(|place| format!("stick-slip is found up to {place} times that estimate"));
            let smooth = of(|check| check.last_quiet, f64::min).map(|place| {
                format!("smooth rotation is found from {place} times that estimate on")
            });
            let found: Vec<String> = [stick_slip, smooth].into_iter().flatten().collect();
            (!found.is_empty()).then(|| format!("{}.", capital(&listed(&found))))
        }
        Limited::Whirl => {
            let whirl = of(|check| check.last_vibrating, f64::min)?;
            Some(format!(
                "Backward whirl is found from {whirl} times the least friction that sustains it at \
                 one site on."
            ))
        }
    }
}

fn answers(results: &Results) -> String {
    let failed = results.manifest.tally.failed;
    match failed {
        0 => "Every case has an answer.".to_owned(),
        failed => format!(
            "{} of {} failed and left no answer; the reasons are below.",
            counted(failed, "simulation"),
            results.manifest.tally.rows
        ),
    }
}

/// Labels given early that more time changed.
fn settled(results: &Results) -> Option<String> {
    let tally = &results.manifest.tally;
    (tally.settled_wrong > 0).then(|| {
        format!(
            "Of {} that had settled and were followed to the end, {} changed its label.",
            counted(tally.settled_checked, "simulation"),
            tally.settled_wrong
        )
    })
}

/// Methods that chatter.
fn unstable(results: &Results) -> Option<String> {
    let methods = results.manifest.methods.iter();
    let unstable: Vec<&str> = methods
        .filter(|method| {
            let margins = [
                method.positive_real_margin,
                method.bending_margin,
                method.axial_margin,
            ];
            margins.into_iter().flatten().any(is_unstable)
        })
        .map(|method| method.method.as_str())
        .collect();
    (!unstable.is_empty()).then(|| {
        format!(
            "The responses by {} are not positive-real: a stuck site chatters, and these labels \
             mean little.",
            listed(&unstable)
        )
    })
}

/// What changes labels that is no property of the well.
fn depends(results: &Results) -> Option<String> {
    let warned = results.manifest.depends_on.iter();
    let warned: Vec<String> = (warned.filter(|it| it.is_warned_of()))
        .map(|it| it.words(&results.manifest.sweep))
        .collect();
    (!warned.is_empty()).then(|| format!("{}.", capital(&warned.join("; "))))
}

/// Whirl that the methods damp.
fn damped(results: &Results) -> Option<String> {
    let words: Vec<String> = results.manifest.damped_whirl().collect();
    (!words.is_empty()).then(|| format!("{}.", capital(&words.join("; "))))
}
