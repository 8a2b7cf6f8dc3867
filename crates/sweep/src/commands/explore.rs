//! `sweep explore`: a page to play with, in which a case is simulated anew as its sliders move.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result, bail};

use super::choosing::choose;
use super::input::read_text;
use super::outputs::{Output, refuse_to_lose};
use super::simulate::not_followed;
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::warn_of_memory;
use crate::cli::ExploreArguments;
use crate::explore::{Explored, controls, methods_of_page, page, whirl_lines};
use crate::histories::history_picture;
use campaign::Campaign;
use campaign::engine::RunOptions;
use campaign::follow::{Following, KeptSystems};
use plot::Look;
use results::files::write_atomically;

/// Simulates a case and writes the page that begins with it.
pub fn explore(arguments: &ExploreArguments, terminal: Terminal) -> Result<Status> {
    let ExploreArguments { file, memory, .. } = arguments;
    refuse_to_lose(&arguments.out, Output::Page, arguments.overwrite.force)?;
    use_threads(None, terminal)?;
    warn_of_memory(memory, terminal);
    let limit = memory.limit();
    let (campaign, texts) = read(file)?;
    let campaign = choose(campaign, false, &limit, false, terminal)?;
    let lateral = campaign.sweep.setting.lateral.as_ref();
    if lateral.is_some_and(|lateral| lateral.finding.is_some()) {
        bail!(UsageError(format!(
            "{}: sites that are found case by case take too long to follow a slider: name the \
             sites, or look at a case with `sweep simulate`",
            file.display()
        )));
    }
    let refused = |words: String| UsageError(format!("{}: {words}", file.display()));
    let (method, slow) = methods_of_page(&campaign.sweep);
    let chosen = campaign.cases(&[arguments.case], &[], &[method]);
    let name = |place: usize| campaign.sweep.methods[place].name();
    let (method, slow) = (name(method), slow.map(name));
    let chosen = match chosen.map_err(|error| refused(error.to_string()))? {
        Ok(chosen) => chosen,
        Err(rows) => {
            let reason = rows.into_iter().find_map(|row| row.outcome.err());
            let reason = reason.context("there is no string")?;
            bail!(UsageError(reason.to_string()));
        }
    };
    let following = Following {
        options: RunOptions::default(),
        memory: Some((&limit, 0)),
        warn: &|_| (),
    };
    let followed = chosen.follow(&following, &mut KeptSystems::default());
    let followed = followed.map_err(|error| not_followed(error, file))?;
    let sweep = followed.sweep;
    let (row, case) = (followed.rows.into_iter().next())
        .zip(followed.cases.into_iter().next())
        .context("there is no case")?;
    let Some(simulation) = followed.simulations.into_iter().next() else {
        let reason = row.outcome.err().context("there is no motion")?;
        let case = case.index;
        terminal.complain(&format!(
            "error: case {case} by {method} has no answer: {reason}"
        ));
        return Ok(Status::SomeFailed);
    };
    let controls = controls(&sweep, &case);
    let duration = case.scene.timing.duration;
    let picture = history_picture(&Look::default(), &sweep, &[case], &[simulation]);
    let html = page(&Explored {
        file,
        sweep: &sweep,
        method,
        slow,
        texts,
        duration,
        controls: &controls,
        whirl: whirl_lines(&sweep, &controls)?,
        row: &row,
        picture: &picture.png()?,
    })?;
    write_atomically(&arguments.out, html.as_bytes())?;
    say(&format!("{}\n", arguments.out.display()))?;
    Ok(Status::Complete)
}

/// A sweep, and every text that was read for it, by its path.
fn read(file: &Path) -> Result<(Campaign, BTreeMap<String, String>)> {
    let texts = RefCell::new(BTreeMap::new());
    let campaign = Campaign::open(file, &[], &|path, most| {
        let text = read_text(path, most)?;
        let name = path.display().to_string();
        texts.borrow_mut().insert(name, text.clone());
        Ok(text)
    })?;
    Ok((campaign, texts.into_inner()))
}
