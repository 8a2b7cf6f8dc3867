//! What came out of a sweep: how its run ends, and in a few lines.

use sim::Motion;
use std::fmt::Write;
use std::path::Path;

use anyhow::Result;

use super::status::Status;
use campaign::dependence::Dependence;
use campaign::words::{counted, together, wrapped};
use results::folder::{Manifest, Tally, TraceSummary};

/// How a run that has these results ends.
pub fn status_of(manifest: &Manifest) -> Status {
    if manifest.tally.failed > 0 {
        Status::SomeFailed
    } else {
        Status::Complete
    }
}

/// The labels of each method, in a paragraph for each motion.
fn label_counts(tally: &Tally) -> String {
    let mut text = String::new();
    for method in tally.labels.keys() {
        let lists = tally.by_motion(method);
        let has_two = lists.len() > 1;
        for (motion, labels) in lists {
            let counts: Vec<String> = (labels.iter())
                .map(|(label, count)| together(&format!("{count} {label}")))
                .collect();
            let of = if has_two {
                format!(", {}", motion.adjective())
            } else {
                String::new()
            };
            text += &wrapped(&format!("{method}{of}: {}", counts.join(", ")), 2, 4);
        }
    }
    text
}

/// How many labels are certain, where that was asked for, in a paragraph for each motion.
fn certain(manifest: &Manifest) -> String {
    let Some(by) = &manifest.certified_by else {
        return String::new();
    };
    let cases = manifest.cases_here();
    let ([one, other], frequencies) = (&by.methods, by.frequencies());
    let words = |motion: Motion| {
        let certain = manifest.tally.certified(motion);
        let part = 100.0 * certain as f64 / cases.max(1) as f64;
        let words = format!(
            "certain, {}: {certain} of {} ({part:.1} %), of which {one} and {other} say the same \
             at {frequencies}, far enough from the limit",
            motion.adjective(),
            counted(cases, "case"),
        );
        wrapped(&words, 2, 4)
    };
    let mut text: String = manifest.tally.motions().into_iter().map(words).collect();
    if let Some(words) = manifest.tally.other_whirl_words() {
        text += &wrapped(&words, 2, 4);
    }
    text
}

/// Possible dependences of labels that were not examined.
fn not_examined(manifest: &Manifest) -> String {
    let left_out = manifest.depends_on.iter().filter(|it| it.cases == 0);
    let changes: Vec<String> = left_out.map(|it| it.change.words()).collect();
    if changes.is_empty() {
        return String::new();
    }
    let words = format!(
        "not examined, as it would take more than a tenth of the time of the run: labels {}",
        changes.join(", ")
    );
    wrapped(&words, 2, 4)
}

/// What labels depend on, by a sample of cases.
fn depends_on(manifest: &Manifest) -> String {
    let found = manifest
        .depends_on
        .iter()
        .filter(|it| it.changed + it.other_whirl > 0);
    let words: Vec<String> = found.map(|it| it.words(&manifest.sweep)).collect();
    if words.is_empty() {
        return String::new();
    }
    let is_warned_of = manifest.depends_on.iter().any(Dependence::is_warned_of);
    let severity = if is_warned_of {
        "warning: labels depend on more than the well: "
    } else {
        ""
    };
    let first = &manifest.methods[0].method;
    wrapped(
        &format!("{severity}compared with {first}, {}", words.join("; ")),
        2,
        4,
    )
}

/// How the limits were traced, and where they are no lines.
fn traced(trace: &TraceSummary) -> String {
    let percent = |part: f64| 100.0 * part;
    let part = percent(trace.simulated as f64 / trace.cases_of_grid as f64);
    let [x, y] = trace.steps.map(percent);
    let mut text = wrapped(
        &format!(
            "limits traced to {x:.2} % and {y:.2} % of the axes (limits.csv), with {part:.1} % of \
             the cases of the equivalent grid, {}",
            trace.cases_of_grid
        ),
        2,
        4,
    );
    for limit in trace.limits.iter().filter(|limit| limit.tiles > 0) {
        let (method, motion, tiles) = (&limit.method, &limit.motion, limit.tiles);
        let area = percent(limit.ragged_part);
        let words = format!(
            "{method}, {motion}: ragged in {tiles} tiles, {area:.1} % of the map, where there is \
             no line but a fraction with the regime (bands.csv)"
        );
        text += &wrapped(&words, 2, 4);
    }
    text
}

/// What came out, in a few lines.
pub fn summary(manifest: &Manifest, folder: &Path, drawn: bool) -> Result<String> {
    let mut text = String::new();
    let rows = manifest.tally.rows;
    writeln!(
        text,
        "{}: {} by {} in {:.2} s",
        manifest.name,
        counted(manifest.cases_here(), "case"),
        counted(manifest.methods.len(), "method"),
        manifest.wall_seconds
    )?;
    if let Some(choice) = &manifest.accuracy {
        text += &choice.lines(2);
    }
    text += &label_counts(&manifest.tally);
    for (method, words) in manifest.tally.estimate_words() {
        text += &wrapped(&format!("{method}: {words}"), 2, 4);
    }
    text += &certain(manifest);
    text += &depends_on(manifest);
    for words in manifest.damped_whirl() {
        text += &wrapped(&format!("warning: {words}"), 2, 4);
    }
    text += &not_examined(manifest);
    for words in manifest.tally.notes(manifest.sweep.units) {
        text += &wrapped(&words, 2, 4);
    }
    if let Some(trace) = &manifest.trace {
        text += &traced(trace);
    }
    if let Some(contact) = &manifest.forward_contact {
        text += &wrapped(&contact.words(manifest.sweep.units), 2, 4);
    }
    if manifest.tally.failed > 0 {
        let failed = manifest.tally.failed;
        let rows = counted(rows, "row");
        writeln!(text, "  {failed} of {rows} failed: see failures.csv")?;
    }
    if manifest.tally.settled_wrong > 0 {
        let (wrong, checked) = (manifest.tally.settled_wrong, manifest.tally.settled_checked);
        let checked = counted(checked, "settled case");
        let words =
            format!("{wrong} of {checked} followed to the end changed the label: use --full");
        text += &wrapped(&words, 2, 4);
    }
    if let Some(words) = manifest.tally.fading_words() {
        text += &wrapped(&words, 2, 4);
    }
    let map = if drawn { "map.svg, map.png, " } else { "" };
    writeln!(text, "{map}labels.csv and more are in {}", folder.display())?;
    Ok(text)
}
