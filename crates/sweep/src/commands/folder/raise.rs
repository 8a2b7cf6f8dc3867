//! More random cases than a folder holds: a point depends on seed and number alone,
//! so that the cases that are done stay, and only the others are run.

use std::collections::HashMap;
use std::io::{BufRead, BufReader};
use std::path::Path;

use anyhow::{Context, Result, anyhow, bail};

use super::names::LOG;
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use crate::commands::warnings::warn_of_broken_lines;
use crate::files::AtomicFile;
use crate::log::{Header, Log, record_line};
use crate::output::{LabelTable, Manifest, record_of};
use campaign::plan::Sweep;
use campaign::text_file::unreadable;

/// A header of the same sweep with more or fewer random cases, as if it had as many as
/// ours; any other is returned as it is.
///
/// # Errors
/// Where ours has fewer.
pub fn with_our_number(what: &str, there: &Header, ours: &Header) -> Result<Header> {
    let mut there = there.clone();
    let (Some(before), Some(now)) = (random_cases(&there), random_cases(ours)) else {
        return Ok(there);
    };
    let mut fingerprint = there.fingerprint.clone();
    fingerprint["design"]["cases"] = now.into();
    if fingerprint == ours.fingerprint {
        if now < before {
            let of_cases = match fingerprint["design"]["kind"] == "sensitivity" {
                true => " blocks of",
                false => "",
            };
            bail!(UsageError(format!(
                "{what} {before}{of_cases} cases of this sweep, and {now} are fewer: `design.cases` may be \
                 raised, not lowered; choose another --out, or begin anew with --fresh"
            )));
        }
        there.fingerprint = fingerprint;
    }
    Ok(there)
}

/// Number of cases, or of blocks of them, of a sweep that draws them at random.
fn random_cases(header: &Header) -> Option<u64> {
    let design = &header.fingerprint["design"];
    let is_random = design["kind"] == "monte-carlo" || design["kind"] == "sensitivity";
    is_random.then(|| design["cases"].as_u64())?
}

/// Puts our header before the records of a stopped run that had fewer cases. The log
/// is there as it was or as it is to be.
///
/// # Errors
/// Where it cannot be read or written.
pub fn raise_log(path: &Path, header: &Header, sweep: &Sweep, terminal: Terminal) -> Result<()> {
    let log = Log::open(path, sweep.design.cases(), sweep.methods.len())?;
    let mut raised = AtomicFile::create(path)?;
    raised.write(header.line()?.as_bytes())?;
    warn_of_broken_lines(&log, terminal);
    log.in_order(|records| {
        let mut records = records.iter();
        records.try_for_each(|record| raised.write(record_line(record)?.as_bytes()))
    })?;
    raised.finish()?;
    Ok(())
}

/// Makes the log of a stopped run of the results of one that had fewer cases. The
/// results stay until the run is finished.
///
/// # Errors
/// Where the results are not what such a run has written.
pub fn log_of_results(
    folder: &Path,
    manifest: &Manifest,
    header: &Header,
    sweep: &Sweep,
) -> Result<()> {
    let path = folder.join("labels.csv");
    let reasons = read_reasons(&folder.join("failures.csv"))?;
    let not_written = |why: String| {
        let path = path.display();
        anyhow!("{path} is not what the run has written: {why}; begin anew with --fresh")
    };
    let mut log = AtomicFile::create(&folder.join(LOG))?;
    log.write(header.line()?.as_bytes())?;
    let file = std::fs::File::open(&path).with_context(|| unreadable(&path))?;
    let mut lines = BufReader::new(file).lines();
    let table = LabelTable::of(sweep);
    if lines
        .next()
        .transpose()
        .with_context(|| unreadable(&path))?
        != Some(table.header())
    {
        bail!(not_written("it has other columns".to_owned()));
    }
    let mut rows = 0;
    for line in lines {
        let row = line.with_context(|| unreadable(&path))?;
        let reason = |case, method: &str| reasons.get(&(case, method.to_owned())).cloned();
        let record = record_of(sweep, &table, &row, reason)
            .ok_or_else(|| not_written(format!("line {} is no row of it", rows + 2)))?;
        log.write(record_line(&record)?.as_bytes())?;
        rows += 1;
    }
    let expected = manifest.tally.rows;
    if rows != expected {
        bail!(not_written(format!("it has {rows} rows, not {expected}")));
    }
    log.finish()?;
    Ok(())
}

/// Why a case has no answer by a method.
type Reasons = HashMap<(usize, String), String>;

fn read_reasons(path: &Path) -> Result<Reasons> {
    let read = || -> csv::Result<Reasons> {
        let mut reader = csv::Reader::from_path(path)?;
        let rows = reader.deserialize::<(usize, String, String, String)>();
        rows.map(|row| row.map(|(case, method, reason, _)| ((case, method), reason)))
            .collect()
    };
    read().with_context(|| unreadable(path))
}
