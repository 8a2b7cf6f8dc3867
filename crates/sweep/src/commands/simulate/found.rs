//! Sites that are found, before cases are followed at them.

use anyhow::{Result, bail};

use super::systems::{build, run_options};
use crate::cli::SimulateArguments;
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;
use campaign::engine::ChosenCase;
use campaign::engine::answer;
use campaign::plan::Sweep;
use campaign::records::Record;

/// The row of every case and method of a sweep whose sites are found; none of another.
///
/// # Errors
/// Where a method cannot treat the string.
pub fn find_sites(
    sweep: &Sweep,
    arguments: &SimulateArguments,
    cases: &[ChosenCase],
    terminal: Terminal,
) -> Result<Option<Vec<Record>>> {
    let lateral = sweep.setting.lateral.as_ref();
    if lateral.is_none_or(|lateral| lateral.finding.is_none()) {
        return Ok(None);
    }
    let options = run_options(sweep, arguments);
    let mut rows = Vec::new();
    for ChosenCase { case, longest } in cases {
        let systems = build(&arguments.file, sweep, options, *longest, terminal)?;
        for (method, system) in systems.iter().enumerate() {
            rows.push(match system {
                Ok(system) => answer(system, case, method, options, sweep),
                Err(reason) => {
                    let values = case.values.clone();
                    Record::failed(case.index, method, values, reason.clone())
                }
            });
        }
    }
    Ok(Some(rows))
}

/// The sweep and its cases with the sites that were found.
///
/// # Errors
/// Where cases or methods have not all the same: they are drawn in one picture.
pub fn at_found_sites(
    sweep: Sweep,
    cases: Vec<ChosenCase>,
    rows: &[Record],
) -> Result<(Sweep, Vec<ChosenCase>)> {
    let sites_of = |row: &Record| row.found.as_ref().map(|found| found.sites.clone());
    let sites = rows.first().and_then(sites_of).unwrap_or_default();
    if rows
        .iter()
        .any(|row| sites_of(row).as_ref() != Some(&sites))
    {
        bail!(UsageError(
            "`sites = \"auto\"` finds other sites for other cases and methods, which cannot be \
             drawn together: simulate one --case by one of --methods at a time"
                .to_owned()
        ));
    }
    let setting = sweep.setting_with_sites(&sweep.setting, &sites)?;
    let cases = (cases.into_iter())
        .map(|chosen| {
            let case = chosen.case.at_sites_of(&setting);
            let case = case.map_err(|reason| UsageError(reason.to_string()))?;
            Ok(ChosenCase { case, ..chosen })
        })
        .collect::<Result<_>>()?;
    Ok((Sweep { setting, ..sweep }, cases))
}
