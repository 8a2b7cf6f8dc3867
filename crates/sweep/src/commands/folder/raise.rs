//! More random cases than a folder holds: a point depends on seed and number alone,
//! so that the cases that are done stay, and only the others are run.

use std::path::Path;

use anyhow::{Result, anyhow, bail};

use super::names::LOG;
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use crate::commands::warnings::warn_of_broken_lines;
use campaign::plan::Sweep;
use results::files::AtomicFile;
use results::folder::{Manifest, RECORDS, read_records};
use results::log::{Header, Log, checked, record_line};

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

/// Makes the log of a stopped run of the records of one that had fewer cases. The
/// results stay until the run is finished.
///
/// # Errors
/// Where the records are not those that the run has written.
pub fn log_of_results(folder: &Path, manifest: &Manifest, header: &Header) -> Result<()> {
    let not_written =
        |why: &str| anyhow!("{why}; begin anew with --fresh, or choose another --out");
    if !manifest.files.contains_key(RECORDS) {
        let why = format!(
            "{} holds no {RECORDS}, from which it could continue",
            folder.display()
        );
        bail!(not_written(&why));
    }
    if let Some(damage) = manifest.damage(folder, &[RECORDS])?.first() {
        bail!(not_written(&damage.words));
    }
    let mut log = AtomicFile::create(&folder.join(LOG))?;
    log.write(header.line()?.as_bytes())?;
    for line in read_records(folder)? {
        log.write(checked(&line?).as_bytes())?;
    }
    log.finish()?;
    Ok(())
}
