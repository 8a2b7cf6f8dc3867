//! Promises as a table, and in a few lines.

use std::fmt::Write;

use studies::promises::{Motion, Promise};

/// The columns of the table: their names, and what a promise has there.
pub fn columns(promise: &Promise) -> [(&'static str, String); 17] {
    let (problem, kept) = (&promise.problem, promise.kept.as_ref().ok());
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let truth = promise.truth.as_ref().ok();
    let reasons = [promise.truth.as_ref().err(), promise.kept.as_ref().err()];
    let reasons: Vec<&str> = reasons.into_iter().flatten().map(String::as_str).collect();
    [
        ("motion", problem.motion.name().to_owned()),
        ("string", problem.number.to_string()),
        ("shape", problem.shape.to_owned()),
        ("length_m", problem.length.to_string()),
        ("loss_of_wave", problem.loss.to_string()),
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
        ("limit", number(kept.and_then(|kept| kept.limit))),
        ("true_limit", number(truth.map(|truth| truth.limit))),
        (
            "true_uncertainty",
            number(truth.map(|truth| truth.uncertainty)),
        ),
        ("error", number(promise.error())),
        ("broken_by", number(promise.broken_by())),
        (
            "furthest_reported",
            number(kept.and_then(|kept| kept.furthest_reported)),
        ),
        ("furthest", number(kept.and_then(|kept| kept.furthest))),
        ("note", reasons.join("; ")),
    ]
}

/// How many were kept, by motion.
pub fn summary(promises: &[Promise]) -> String {
    let mut text = String::new();
    for motion in Motion::ALL {
        let of_motion = promises.iter().filter(|one| one.problem.motion == motion);
        let of_motion: Vec<&Promise> = of_motion.collect();
        if of_motion.is_empty() {
            continue;
        }
        let refused = of_motion.iter().filter(|one| one.kept.is_err()).count();
        let broken: Vec<f64> = of_motion.iter().filter_map(|one| one.broken_by()).collect();
        let unknown = of_motion.len() - refused - broken.len();
        let more = broken.iter().filter(|by| **by > 1.0).count();
        let worst = broken.iter().copied().fold(0.0, f64::max);
        let _ = writeln!(
            text,
            "{}: {} promises tested, {more} broken, the worst {worst:.2} of what was asked; {refused} \
             refused, {unknown} where the true limit is not known well enough",
            motion.name(),
            broken.len(),
        );
    }
    text
}
