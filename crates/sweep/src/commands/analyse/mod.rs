//! `sweep analyse`: how often each regime occurs in a results folder, how sure that is, and which
//! axis decides.

mod found;
mod picture;
mod table;

use std::path::Path;

use anyhow::{Result, bail};

use super::document::say_document;
use super::folder::tables_of;
use super::outputs::{Output, refuse_to_lose};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use crate::cli::{AnalyseArguments, PictureFile};
use crate::report::{analysed_sections, text};
use campaign::quantities::Axis;
use found::AnalysisFound;
use picture::{draw, refuse_absent, refuse_several};
use results::analysis::{Analysis, NoAnalysis, size_of_blocks};
use results::files::write_atomically;
use table::{counts_csv, counts_header, indices_csv, indices_header};

/// Refuses to write over what this command has not written.
fn refuse_to_lose_any(arguments: &AnalyseArguments) -> Result<()> {
    let force = arguments.overwrite.force;
    let picture = arguments.picture.as_ref().map(|picture| match picture {
        PictureFile::Svg(path) => (path, Output::Beginning(&[b"<svg"])),
        PictureFile::Png(path) => (path, Output::Beginning(&[b"\x89PNG"])),
    });
    let counts = arguments.out.as_ref();
    let indices = arguments.indices.as_ref();
    let headers = [counts_header(), indices_header()];
    let [of_counts, of_indices] = headers.each_ref().map(|header| [header.as_bytes()]);
    let files = [
        counts.map(|path| (path, Output::Beginning(&of_counts))),
        indices.map(|path| (path, Output::Beginning(&of_indices))),
        picture,
    ];
    for (path, output) in files.into_iter().flatten() {
        refuse_to_lose(path, output, force)?;
    }
    Ok(())
}

/// Counts, and says what came out.
pub fn analyse(arguments: &AnalyseArguments, terminal: Terminal) -> Result<Status> {
    refuse_to_lose_any(arguments)?;
    let tables = (arguments.folders.iter())
        .map(|folder| tables_of(folder, terminal))
        .collect::<Result<Vec<_>>>()?;
    let manifest = &tables[0].manifest;
    if arguments.indices.is_some() && size_of_blocks(manifest).is_none() {
        bail!(UsageError(
            "--indices: they need cases in blocks; `kind = \"sensitivity\"` makes \
             such"
                .to_owned()
        ));
    }
    refuse_several(arguments)?;
    let by: Vec<Vec<Axis>> = arguments.by.iter().map(|axes| axes.0.clone()).collect();
    let analysis = Analysis::of(
        &arguments.folders,
        &tables,
        &by,
        usize::from(arguments.bins),
    );
    let analysis = analysis.map_err(in_words)?;
    let Analysis {
        counts: counted,
        blocks,
        axes,
    } = &analysis;
    let width = arguments.width;
    let so_far = tables.iter().find_map(|tables| tables.so_far);
    let so_far = so_far.map_or_else(String::new, |so_far| format!(" ({so_far})"));
    let title = format!("{}: {}{so_far}", manifest.name, manifest.title);
    // Counts over the axes of `--by` are the last.
    let drawn = arguments.picture.as_ref().zip(counted.last());
    if let Some((_, counts)) = drawn {
        refuse_absent(arguments.regime, counts)?;
    }
    let lines = !arguments.document.json;
    if lines {
        let sections = analysed_sections(manifest, counted, blocks, width);
        say(&text(&title, &sections))?;
    }
    let mut files = Vec::new();
    let mut is_written = |path: &Path| {
        let name = path.display().to_string();
        let said = if lines {
            say(&format!("{name}\n"))
        } else {
            Ok(())
        };
        files.push(name);
        said
    };
    if let Some(path) = &arguments.out {
        write_atomically(path, counts_csv(counted).as_bytes())?;
        is_written(path)?;
    }
    if let Some(path) = &arguments.indices {
        write_atomically(path, indices_csv(axes, blocks).as_bytes())?;
        is_written(path)?;
    }
    if let Some((file, counts)) = drawn {
        is_written(draw(file, arguments.regime, manifest, &so_far, counts)?)?;
    }
    if !lines {
        say_document(
            "analyse",
            &AnalysisFound::new(&tables, &analysis, width, files),
        )?;
    }
    Ok(Status::Complete)
}

/// Why there is no analysis, in the words of the command line.
fn in_words(error: NoAnalysis) -> anyhow::Error {
    let message = match error {
        NoAnalysis::Unreadable(error) => return error,
        NoAnalysis::NoAxis { .. } => format!("--by: {error}"),
        _ => error.to_string(),
    };
    UsageError(message).into()
}
