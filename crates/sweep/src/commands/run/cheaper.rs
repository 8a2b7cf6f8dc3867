//! What would make a long sweep cheaper.

use crate::commands::cost::WallTime;
use campaign::design::TraceDesign;
use campaign::plan::Sweep;
use campaign::sweep_file::AutoOr;
use campaign::words::{counted, short, wrapped};

/// Nothing is said of what takes less, s.
const LONG: f64 = 60.0;

/// Steps, or cases, fewer by this factor are worth a line.
const FEWER: f64 = 1.5;

/// Lines on what the file may leave out or say otherwise; empty for a sweep that is soon done.
pub fn cheaper(sweep: &Sweep, time: &WallTime) -> String {
    let is_long = match time {
        WallTime::About(seconds) => *seconds >= LONG,
        WallTime::Unknown => true,
        WallTime::Refused(_) => false,
    };
    let all = [
        frequency(sweep),
        trace(sweep),
        methods(sweep),
        early_end(sweep),
        accuracy(sweep),
    ];
    let lines: Vec<String> = all.into_iter().flatten().collect();
    if !is_long || lines.is_empty() {
        return String::new();
    }
    let lines = lines.iter().map(|line| wrapped(line, 2, 4));
    "what would make it cheaper:\n".to_owned() + &lines.collect::<String>()
}

/// A frequency above that of the rule.
fn frequency(sweep: &Sweep) -> Option<String> {
    let AutoOr::Given(given) = sweep.content.sampling_frequency_hz else {
        return None;
    };
    let by_rule = sweep.frequency_by_rule();
    (given > FEWER * by_rule).then(|| {
        format!(
            "without `sampling_frequency_hz` it is {} Hz, by rule: {:.1} times fewer steps",
            short(by_rule),
            given / by_rule
        )
    })
}

/// A grid far finer than what its limits need.
fn trace(sweep: &Sweep) -> Option<String> {
    let trace = TraceDesign::equivalent_to_grid(sweep.content.design.as_ref()?)?;
    let (likely, all) = (trace.likely_cases(), sweep.design.cases());
    (all as f64 > FEWER * likely as f64).then(|| {
        format!("`kind = \"trace\"` goes along the limits alone: perhaps {likely} of {all} cases")
    })
}

/// Methods compared with one another.
fn methods(sweep: &Sweep) -> Option<String> {
    let count = sweep.methods.len();
    if sweep.certifying.is_some() {
        return Some("without `certify` a label is of one simulation, not of four".to_owned());
    }
    (count > 1).then(|| {
        let methods = counted(count, "method");
        format!("{methods}: each simulates every case, and one is enough for a map")
    })
}

/// Cases of a given length.
fn early_end(sweep: &Sweep) -> Option<String> {
    let is_given = matches!(sweep.content.time_s, AutoOr::Given(_));
    let may_end = is_given && sweep.setting.friction.is_none();
    may_end.then(|| "`time_s = \"auto\"` ends a case once its regime is determined".to_owned())
}

/// Methods and frequencies that are as near as is wanted.
fn accuracy(sweep: &Sweep) -> Option<String> {
    let is_chosen = sweep.choice.is_some() || sweep.content.accuracy.is_some();
    let has_none = is_chosen || sweep.certifying.is_some() || sweep.setting.friction.is_some();
    (!has_none).then(|| {
        "`accuracy = \"1 %\"` instead of methods and a frequency takes the cheapest that are \
         as near"
            .to_owned()
    })
}
