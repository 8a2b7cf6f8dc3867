//! `sweep run`: every case, every method, a results folder.

use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

use anyhow::{Result, bail};

use super::{
    Progress, Status, UsageError, all_cases, build_systems, make_folder, read_sweep,
    results_folder, say, use_threads, warn_of_unstable,
};
use crate::cli::RunArguments;
use crate::engine::{Case, RowOutcome, run_cases};
use crate::output::{
    Manifest, boundary, failures_csv, labels_csv, meaning_hash, write_atomically, write_boundary,
};
use crate::spec::Sweep;

/// Runs a sweep.
pub fn run(arguments: &RunArguments) -> Result<Status> {
    let start = Instant::now();
    let sweep = read_sweep(&arguments.file, &arguments.work)?;
    let cases = all_cases(&arguments.file, &sweep)?;
    let folder = results_folder(arguments.out.as_ref(), &sweep);
    if arguments.dry_run {
        say(&plan(&sweep, &cases, &folder)?)?;
        return Ok(Status::Complete);
    }
    refuse_other_results(&sweep, &folder, arguments.fresh)?;
    use_threads(arguments.work.jobs)?;
    let systems = build_systems(&arguments.file, &sweep, &cases)?;
    let limit = boundary(&sweep, &systems).map_err(UsageError)?;
    // A folder that cannot be written is found before the long work.
    make_folder(&folder)?;
    warn_of_unstable(&systems);
    let progress = Progress::new(cases.len() * systems.len(), arguments.quiet);
    let rows = run_cases(&systems, &cases, || progress.tick());
    progress.finish();

    let write = |name: &str, content: &[u8]| write_atomically(&folder.join(name), content);
    write("labels.csv", &labels_csv(&sweep, &rows)?)?;
    write("boundary.csv", &write_boundary(&limit)?)?;
    write("failures.csv", &failures_csv(&arguments.file, &rows)?)?;
    let manifest = Manifest::new(&sweep, &systems, &rows, start.elapsed().as_secs_f64())?;
    write("manifest.json", &serde_json::to_vec_pretty(&manifest)?)?;
    let drawn = super::plot::draw_map(&folder)?;
    if !arguments.quiet {
        say(&summary(&manifest, &folder, drawn)?)?;
    }
    let failed = rows
        .iter()
        .any(|row| matches!(row.outcome, RowOutcome::Failed(_)));
    Ok(if failed {
        Status::SomeFailed
    } else {
        Status::Complete
    })
}

/// Results of another sweep are not silently replaced.
fn refuse_other_results(sweep: &Sweep, folder: &Path, fresh: bool) -> Result<()> {
    if fresh || !folder.join("manifest.json").exists() {
        return Ok(());
    }
    let there = Manifest::read(folder)?;
    if there.meaning_sha256 == meaning_hash(sweep)? {
        return Ok(());
    }
    bail!(UsageError(format!(
        "{} holds the results of another sweep, `{}` with hash {}: \
         choose another --out, or replace them with --fresh",
        folder.display(),
        there.name,
        &there.meaning_sha256[..there.meaning_sha256.len().min(12)],
    )))
}

fn plan(sweep: &Sweep, cases: &[Case], folder: &Path) -> Result<String> {
    let mut text = String::new();
    let methods: Vec<&str> = sweep.methods.iter().map(|method| method.name()).collect();
    let simulated: f64 = cases.iter().map(|case| case.scene.timing.duration).sum();
    let longest = cases
        .iter()
        .map(|case| case.scene.timing.duration)
        .fold(0.0, f64::max);
    writeln!(text, "{}: {}", sweep.name, sweep.title)?;
    writeln!(
        text,
        "would run {} cases by {} ({}), into {}",
        cases.len(),
        methods.len(),
        methods.join(", "),
        folder.display()
    )?;
    writeln!(
        text,
        "simulated time {simulated:.1} s for each method, the longest case {longest:.1} s, \
         at {} Hz",
        sweep.sampling_frequency
    )?;
    Ok(text)
}

fn summary(manifest: &Manifest, folder: &Path, drawn: bool) -> Result<String> {
    let mut text = String::new();
    let rows = manifest.cases * manifest.methods.len();
    writeln!(
        text,
        "{}: {} cases by {} methods in {:.2} s",
        manifest.name,
        manifest.cases,
        manifest.methods.len(),
        manifest.wall_seconds
    )?;
    for (method, labels) in &manifest.labels {
        let counts: Vec<String> = labels
            .iter()
            .map(|(label, count)| format!("{count} {label}"))
            .collect();
        writeln!(text, "  {method}: {}", counts.join(", "))?;
    }
    if manifest.failed > 0 {
        writeln!(
            text,
            "  {} of {rows} rows failed: see failures.csv",
            manifest.failed
        )?;
    }
    let map = if drawn { "map.svg, map.png, " } else { "" };
    writeln!(text, "{map}labels.csv and more are in {}", folder.display())?;
    Ok(text)
}
