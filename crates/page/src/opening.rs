//! The sweep that a page opens, read from texts in memory.

use std::collections::BTreeMap;
use std::io::{Error, ErrorKind, Result as IoResult};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use campaign::Campaign;
use campaign::sweep_file::{FileContent, MethodName};

use crate::request::Opening;

/// What no sweep that was read could cause.
const NO_TABLE: &str = "the sweep cannot be written as TOML";

/// Reads it, with the methods that are asked for in addition to its own.
///
/// # Errors
/// Where it does not make sense, or a file that it names is not among the texts.
pub fn opened(opening: Opening) -> Result<Campaign> {
    let Opening {
        path,
        sweep,
        mut texts,
        methods,
    } = opening;
    if let Some(content) = sweep {
        texts.insert(path.clone(), text_of_resolved(*content)?);
    }
    let read =
        |methods: &[MethodName]| Campaign::open(&path, methods, &|path, _| text_of(&texts, path));
    let campaign = read(&[])?;
    let mut all = campaign.sweep.content.methods.clone();
    for method in methods {
        if !all.contains(&method) {
            all.push(method);
        }
    }
    if all.len() == campaign.sweep.content.methods.len() {
        return Ok(campaign);
    }
    Ok(read(&all)?)
}

/// A text by the path of its file, or by its name where one file alone has it: a results folder
/// does not say where the files were that its sweep names.
fn text_of(texts: &BTreeMap<PathBuf, String>, path: &Path) -> IoResult<String> {
    let mut namesakes = (texts.iter()).filter(|(other, _)| other.file_name() == path.file_name());
    let text = texts.get(path).or_else(|| {
        let (_, text) = namesakes.next()?;
        namesakes.next().is_none().then_some(text)
    });
    text.cloned()
        .ok_or_else(|| Error::new(ErrorKind::NotFound, "the page does not hold it"))
}

/// What became of a sweep file, as a file: of keys that say the same in another way it has the
/// one that came of the other.
fn text_of_resolved(mut content: FileContent) -> Result<String> {
    if content.accuracy.is_some() {
        content.accuracy = None;
        content.certify = false;
    }
    if !content.string.sections.is_empty() {
        (content.string.file, content.string.order) = (None, None);
    }
    if let Some(friction) = &mut content.string_friction {
        friction.tolerance = None;
    }
    let cuts = content.has_cutting();
    let mut table = toml::Table::try_from(&content).context(NO_TABLE)?;
    if let Some(bit) = table.get_mut("bit").and_then(toml::Value::as_table_mut) {
        // What a law of torque has by default, a bit that cuts may not give.
        for key in ["torque_static_ratio", "torque_decay_rpm"] {
            if cuts {
                bit.remove(key);
            }
        }
    }
    toml::to_string(&table).context(NO_TABLE)
}
