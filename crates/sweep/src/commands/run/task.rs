//! A run that is asked for, and what its folder holds of it.

use std::path::PathBuf;

use anyhow::{Result, bail};

use crate::cli::RunArguments;
use crate::commands::folder::{FolderState, LOG, log_of_results, look, raise_log, results_folder};
use crate::commands::prepare::{open, survey_cases};
use crate::commands::status::UsageError;
use crate::commands::terminal::Terminal;

use crate::commands::warnings::{warn_of_few_sites, warn_of_limits, warn_of_sweep};
use crate::program::PROGRAM;
use campaign::design::Design;
use campaign::engine::{Shard, Survey};
use campaign::{Campaign, NoRun};
use results::folder::{Manifest, fingerprint};
use results::log::{Header, Log};

/// A run, as far as it is known before anything is built.
pub struct Task<'a> {
    /// What was asked for.
    pub arguments: &'a RunArguments,
    /// Where it is reported.
    pub terminal: Terminal,
    /// The sweep.
    pub campaign: Campaign,
    /// How long its cases take.
    pub survey: Survey,
    /// What a log of the run begins with, its part of the sweep too.
    pub header: Header,
    /// Where the results are, or will be.
    pub folder: PathBuf,
}

impl<'a> Task<'a> {
    /// Reads the sweep and looks at its cases.
    ///
    /// # Errors
    /// Where the sweep or a case does not make sense.
    pub fn read(arguments: &'a RunArguments, terminal: Terminal) -> Result<Self> {
        let RunArguments {
            file, work, quiet, ..
        } = arguments;
        let campaign = open(file, work, arguments.full, *quiet, terminal)?;
        let campaign = campaign.for_run(arguments.options());
        let campaign = campaign.map_err(|error| match error {
            NoRun::File(error) => error.into(),
            NoRun::CertifiesNothing => anyhow::Error::from(UsageError(error.to_string())),
        })?;
        let sweep = &campaign.sweep;
        if !quiet {
            warn_of_sweep(sweep, terminal);
            warn_of_limits(sweep, terminal);
            warn_of_few_sites(sweep, terminal);
        }
        let shard = arguments.shard.unwrap_or(Shard::WHOLE);
        if matches!(sweep.design, Design::Trace(_)) && !shard.is_whole() {
            bail!(UsageError(
                "--shard: a trace is not split, because its next cases depend on all that are done"
                    .to_owned()
            ));
        }
        let survey = survey_cases(file, &campaign)?;
        let mut folder = results_folder(arguments.out.as_ref(), sweep);
        if arguments.out.is_none() && !shard.is_whole() {
            folder.push(format!("shard-{}-of-{}", shard.index, shard.of));
        }
        Ok(Self {
            header: Header::new(
                PROGRAM.to_owned(),
                shard,
                fingerprint(sweep, arguments.options())?,
            ),
            arguments,
            terminal,
            campaign,
            survey,
            folder,
        })
    }

    /// Examines the folder; a `fresh` run ignores what is there.
    ///
    /// # Errors
    /// As [`look`].
    pub fn look(&self, fresh: bool) -> Result<FolderState> {
        look(&self.folder, &self.header, &self.campaign.sweep, fresh)
    }

    /// Makes the log of the run, in a folder that is held, from what is there; or gives
    /// the results that another run has finished there meanwhile.
    ///
    /// # Errors
    /// As [`look`], and where a file cannot be read or written.
    pub fn prepare_log(&self) -> Result<Option<Box<Manifest>>> {
        let (folder, header) = (&self.folder, &self.header);
        let sweep = &self.campaign.sweep;
        let log = folder.join(LOG);
        match self.look(self.arguments.fresh)? {
            FolderState::Nothing(owned) => {
                Log::begin(&log, header)?;
                owned.remove_results(folder)?;
            }
            FolderState::Unfinished { had_fewer: false } => {}
            FolderState::Unfinished { had_fewer: true } => {
                raise_log(&log, header, sweep, self.terminal)?;
            }
            FolderState::Fewer(manifest) => log_of_results(folder, &manifest, header)?,
            FolderState::Complete(manifest) => return Ok(Some(manifest)),
        }
        Ok(None)
    }
}
