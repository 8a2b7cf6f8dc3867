//! The picture of how likely a regime is.

use std::path::Path;

use anyhow::{Result, bail};
use sim::{Label, Motion};

use crate::cli::{AnalyseArguments, PictureFile};
use crate::commands::status::UsageError;
use crate::map::{Probabilities, probability_picture};
use results::analysis::Counts;
use results::files::write_atomically;
use results::folder::Manifest;

/// A picture has the axes of one `--by`.
pub fn refuse_several(arguments: &AnalyseArguments) -> Result<()> {
    if arguments.picture.is_some() && arguments.by.len() > 1 {
        bail!(UsageError(
            "--picture draws over the axes of one --by: here are several".to_owned()
        ));
    }
    Ok(())
}

/// A regime of a motion that no case has a label of is not drawn.
pub fn refuse_absent(regime: Option<Label>, counts: &Counts) -> Result<()> {
    let has = |motion: Motion| counts.groups.iter().any(|(_, other, _)| *other == motion);
    match regime {
        Some(label) if !has(label.motion()) => bail!(UsageError(format!(
            "--regime {}: no case has a {} label",
            label.name(),
            label.motion().adjective()
        ))),
        _ if counts.groups.is_empty() => bail!(UsageError(
            "--picture: no case has an answer to draw yet".to_owned()
        )),
        _ => Ok(()),
    }
}

/// Draws what was counted over the axes of `--by`, into the file that is returned.
pub fn draw<'a>(
    file: &'a PictureFile,
    regime: Option<Label>,
    manifest: &Manifest,
    so_far: &str,
    counts: &Counts,
) -> Result<&'a Path> {
    let picture = probability_picture(&Probabilities {
        title: format!("{}{so_far}", manifest.title),
        counts,
        regime,
        units: manifest.sweep.units,
        map: manifest.map.as_ref(),
    });
    let (path, bytes) = match file {
        PictureFile::Svg(path) => (path, picture.svg().into_bytes()),
        PictureFile::Png(path) => (path, picture.png()?),
    };
    write_atomically(path, &bytes)?;
    Ok(path)
}
