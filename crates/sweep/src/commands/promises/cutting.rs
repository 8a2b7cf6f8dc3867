//! Limits and labels of bits that cut as tables, and in a few lines.

use std::collections::BTreeMap;

use campaign::words::{counted, wrapped};
use studies::promises::{
    ASKED_ABOVE_CUTTING, CuttingLabel, CuttingLimit, CuttingProblem, CuttingPromise, Small,
};

/// A number of decimal megabytes.
const MB: f64 = 1e6;

/// The columns of both tables about the string and its bit.
fn of_problem(drawn: &CuttingProblem) -> [(&'static str, String); 10] {
    let (problem, exact) = (&drawn.problem, drawn.exact.as_ref().ok());
    [
        ("string", problem.number.to_string()),
        ("family", problem.shape.to_owned()),
        ("surface", problem.surface.to_owned()),
        ("length_m", problem.length.to_string()),
        ("loss_of_wave", problem.loss.to_string()),
        ("feed", drawn.fed.name().to_owned()),
        ("blades", drawn.blades.to_string()),
        ("surface_speed_rpm", drawn.speed.to_string()),
        ("depth_of_cut_mm", (1e3 * drawn.depth).to_string()),
        ("exact_limit_mpa", number(exact.map(|exact| exact.energy))),
    ]
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

/// The columns of the table of limits: their names, and what a limit has there.
pub fn columns(limit: &CuttingLimit) -> Vec<(&'static str, String)> {
    let exact = limit.problem.exact.as_ref();
    let lengths = limit.lengths;
    let own = [
        (
            "frequency_hz",
            number(exact.ok().map(|exact| exact.frequency)),
        ),
        (
            "growth_beyond_1_s",
            number(exact.ok().map(|exact| exact.growth)),
        ),
        ("method", limit.method.to_owned()),
        (
            "sampling_frequency_hz",
            number(lengths.map(|_| limit.sampling_frequency)),
        ),
        ("limit_mpa", number(limit.energy)),
        ("error", number(limit.error())),
        ("taps", number(lengths.map(|it| it.taps as f64))),
        (
            "estimated_taps",
            number(lengths.map(|it| it.estimated_taps as f64)),
        ),
        ("last_tap", number(lengths.map(|it| it.left))),
        ("taps_mb", number(lengths.map(|it| it.bytes / MB))),
        (
            "estimated_kept_mb",
            number(lengths.map(|it| it.estimated_bytes[0] / MB)),
        ),
        (
            "estimated_peak_mb",
            number(lengths.map(|it| it.estimated_bytes[1] / MB)),
        ),
        ("note", exact.err().cloned().unwrap_or_default()),
    ];
    of_problem(&limit.problem).into_iter().chain(own).collect()
}

/// How far off the limits are, by method.
pub fn summary(limits: &[CuttingLimit]) -> String {
    let mut groups: BTreeMap<&str, Vec<&CuttingLimit>> = BTreeMap::new();
    for limit in limits {
        groups.entry(limit.method).or_default().push(limit);
    }
    let line = |(method, limits): (&&str, &Vec<&CuttingLimit>)| {
        let errors: Vec<f64> = limits.iter().filter_map(|limit| limit.error()).collect();
        let near = errors.iter().map(|error| error.abs());
        let near: Vec<f64> = near.filter(|error| error.is_finite()).collect();
        let worst = near.iter().copied().fold(0.0, f64::max);
        let longer = limits.iter().filter_map(|limit| limit.lengths);
        let longer = longer.filter(|it| it.taps > it.estimated_taps).count();
        let words = format!(
            "{method}: the hardest rock of steady drilling on {}: {} near the exact one, the worst \
             {:.2} % off; {} without one, or too long; responses longer than estimated on {longer}",
            counted(errors.len(), "string"),
            near.len(),
            100.0 * worst,
            limits.len() - errors.len(),
        );
        wrapped(&words, 0, 2)
    };
    groups.iter().map(line).collect()
}

/// The columns of the table of labels: their names, and what a case has there.
pub fn label_columns(case: &CuttingLabel) -> Vec<(&'static str, String)> {
    let word = |value: Option<bool>| value.map_or_else(String::new, |value| value.to_string());
    let name = |method: usize, motion: usize| {
        let label = case.labels[method][motion];
        label.map_or_else(String::new, |label| label.name().to_owned())
    };
    let own = [
        ("sampling_frequency_hz", case.sampling_frequency.to_string()),
        ("energy_mpa", case.energy.to_string()),
        (
            "growing_roots",
            number(case.growing.map(|roots| roots as f64)),
        ),
        ("folds", number(case.folds)),
        ("axial_held", name(0, 0)),
        ("torsion_held", name(0, 1)),
        ("axial_finite_element", name(1, 0)),
        ("torsion_finite_element", name(1, 1)),
        ("agree", word(case.agree())),
        ("is_wrong", word(case.is_wrong())),
    ];
    of_problem(&case.problem).into_iter().chain(own).collect()
}

/// How many labels are wrong where both methods agree, and of the others, by what small motion does.
pub fn label_summary(cases: &[CuttingLabel]) -> String {
    let line = |(small, in_words): (Small, &str)| {
        let of_side = cases.iter().filter(|case| case.small() == Some(small));
        let of_side: Vec<&CuttingLabel> = of_side.collect();
        let wrong = |agree: bool| {
            let cases = of_side.iter().filter(|case| case.agree() == Some(agree));
            let known: Vec<bool> = cases.filter_map(|case| case.is_wrong()).collect();
            let wrong = known.iter().filter(|is_wrong| **is_wrong).count();
            format!("{wrong} of {} wrong", known.len())
        };
        let words = format!(
            "where small motion {in_words}: {}; both methods agree: {}; they differ: {}",
            counted(of_side.len(), "case"),
            wrong(true),
            wrong(false)
        );
        wrapped(&words, 0, 2)
    };
    let all = [
        (Small::DiesAway, "dies away"),
        (
            Small::GrowsSlowly,
            "grows too slowly for the time of a case",
        ),
        (Small::Grows, "grows"),
    ];
    all.map(line).concat()
}

/// The columns of the table of promises: their names, and what one has there.
pub fn promise_columns(promise: &CuttingPromise) -> Vec<(&'static str, String)> {
    let kept = promise.kept.as_ref().ok();
    let own = [
        ("asked", promise.asked.to_string()),
        (
            "chosen",
            kept.map_or_else(String::new, |kept| kept.method.clone()),
        ),
        (
            "sampling_frequency_hz",
            number(kept.map(|kept| kept.sampling_frequency)),
        ),
        ("estimated", number(kept.map(|kept| kept.estimated))),
        ("exact_limit_rpm", number(promise.exact)),
        ("limit_rpm", number(kept.and_then(|kept| kept.limit))),
        ("limit_error", number(promise.limit_error())),
        (
            "rate_of_penetration_error",
            number(kept.map(|kept| kept.rates.error)),
        ),
        (
            "rate_of_penetration_chance",
            number(kept.map(|kept| kept.rates.chance)),
        ),
        ("broken_by", number(promise.broken_by())),
        (
            "note",
            promise.kept.as_ref().err().cloned().unwrap_or_default(),
        ),
    ];
    of_problem(&promise.problem)
        .into_iter()
        .chain(own)
        .collect()
}

/// How many were kept, by what was asked for.
pub fn promise_summary(promises: &[CuttingPromise]) -> String {
    let line = |asked: f64| {
        let of_asked = promises.iter().filter(|promise| promise.asked == asked);
        let of_asked: Vec<&CuttingPromise> = of_asked.collect();
        let refused = of_asked.iter().filter(|one| one.kept.is_err()).count();
        let broken: Vec<f64> = of_asked.iter().filter_map(|one| one.broken_by()).collect();
        let more = broken.iter().filter(|by| **by > 1.0).count();
        let with_limit = of_asked.iter().filter_map(|one| one.limit_error()).count();
        let worst = broken.iter().copied().fold(0.0, f64::max);
        let words = format!(
            "{} %: {} tested, {with_limit} of them by a limit, too; {more} broken, the worst {worst:.2} of what was \
             asked; {refused} refused",
            100.0 * asked,
            counted(broken.len(), "promise"),
        );
        wrapped(&words, 0, 2)
    };
    ASKED_ABOVE_CUTTING.map(line).concat()
}
