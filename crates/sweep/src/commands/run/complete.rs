//! `sweep run` over a folder that is complete: nothing to simulate, but a title or
//! a map may have changed, and what follows from the labels may be lost.

use anyhow::{Result, bail};

use super::systems::build_admitted;
use super::task::Task;
use crate::commands::drawing::{Drawing, draw_and_note};
use crate::commands::folder::{
    FolderState, MANIFEST, hold, in_words, remove_page, tell_if_unverified, tidy,
};
use crate::commands::outcome::{status_of, summary};
use crate::commands::status::{Status, UsageError};
use crate::commands::terminal::say;
use campaign::design::Design;
use limits::{boundary, boundary_csv};
use results::files::write_with_checksum;
use results::folder::{Damage, FAILURES_HEADER, Manifest, OF_TRACE, PICTURES};
use results::traced::write_traced;

/// Shows the results again, in order.
///
/// # Errors
/// Where they cannot be put in order.
pub fn show_again(task: &Task, manifest: Manifest) -> Result<Status> {
    tell_if_unverified(&manifest, &task.folder, task.terminal);
    let is_in_order = !looks_different(task, &manifest) && damage(task, &manifest)?.is_empty();
    let manifest = if is_in_order {
        tidy(&task.folder);
        manifest
    } else {
        put_in_order(task)?
    };
    if !task.arguments.quiet {
        let text = summary(&manifest, &task.folder, manifest.draws())?;
        say(&format!("complete already, nothing to run\n{text}"))?;
    }
    Ok(status_of(&manifest))
}

/// What is missing or damaged and can be made again; a folder of which more is
/// lost was refused.
///
/// # Errors
/// Where a file cannot be read.
pub fn damage(task: &Task, manifest: &Manifest) -> Result<Vec<Damage>> {
    let mut damage = manifest.damage(&task.folder, &["boundary.csv", "failures.csv"])?;
    if manifest.draws() {
        damage.extend(manifest.damage(&task.folder, &PICTURES)?);
    }
    if manifest.is_trace() {
        damage.extend(manifest.damage(&task.folder, &OF_TRACE)?);
    }
    Ok(damage)
}

fn looks_different(task: &Task, manifest: &Manifest) -> bool {
    let sweep = &task.campaign.sweep;
    let shown = (&manifest.title, &manifest.map, &manifest.sweep);
    shown != (&sweep.title, &sweep.map, &sweep.content)
}

fn put_in_order(task: &Task) -> Result<Manifest> {
    let folder = &task.folder;
    let _lock = hold(folder, MANIFEST, task.terminal)?;
    // What was found before the folder was locked may be another's work under way.
    let FolderState::Complete(mut manifest) = task.look(false)? else {
        bail!(
            "{} was changed by another command: give this one again",
            folder.display()
        );
    };
    let damage = damage(task, &manifest)?;
    if !damage.is_empty() {
        let words = in_words(&damage);
        (task.terminal).complain(&format!("warning: {words}: made again"));
    }
    let is_damaged =
        |names: &[&str]| (damage.iter()).any(|damage| names.contains(&damage.name.as_str()));
    for name in ["boundary.csv", "failures.csv"] {
        if is_damaged(&[name]) {
            let content = match name {
                "boundary.csv" => boundary_again(task)?,
                _ => format!("{FAILURES_HEADER}\n").into_bytes(),
            };
            let checksum = write_with_checksum(&folder.join(name), &content)?;
            if manifest.has_checksums() {
                manifest.files.insert(name.to_owned(), checksum);
            }
        }
    }
    if let (Design::Trace(design), true) = (&task.campaign.sweep.design, is_damaged(&OF_TRACE)) {
        write_traced(folder, design, &mut manifest)?;
    }
    let draws = looks_different(task, &manifest) || is_damaged(&PICTURES);
    if draws {
        manifest.title.clone_from(&task.campaign.sweep.title);
        manifest.map.clone_from(&task.campaign.sweep.map);
        manifest.sweep = task.campaign.sweep.content.clone();
        // Until they are drawn, there are none.
        (PICTURES.iter()).for_each(|&name| drop(manifest.files.remove(name)));
    }
    if draws || !damage.is_empty() {
        manifest.write(folder)?;
        remove_page(folder)?;
    }
    if draws && manifest.draws() {
        draw_and_note(folder, &mut manifest, &Drawing::default())?;
    }
    Ok(*manifest)
}

fn boundary_again(task: &Task) -> Result<Vec<u8>> {
    let systems = build_admitted(task)?;
    let limit =
        boundary(&task.campaign.sweep, &systems).map_err(|error| UsageError(error.to_string()))?;
    Ok(boundary_csv(&limit).into_bytes())
}
