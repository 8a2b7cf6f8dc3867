//! What an engine in a page opens: the sweep of a results folder.

use serde_json::{Value, json};

use campaign::sweep_file::DesignKind;
use results::folder::Manifest;

/// The sweep as its file was read, and the name of the list of its cases where they are one, for
/// the page to give back; or, where the sweep needs files that are not in the folder, their names.
pub fn opening(manifest: &Manifest) -> Value {
    let mut sweep = manifest.sweep.clone();
    // What cases are held against changes none of them, nor does a name, which engines of earlier
    // versions do not know.
    sweep.compare.clear();
    sweep.name = None;
    let survey = sweep.well.iter().flat_map(|well| &well.survey);
    let absent: Vec<&String> = survey.chain(&sweep.surface_speed_file).collect();
    if !absent.is_empty() {
        return json!({ "absent": absent });
    }
    let design = sweep.design.as_ref();
    let list = design.filter(|design| design.kind == DesignKind::List);
    let list = list.and_then(|design| design.file.as_ref());
    json!({ "path": format!("{}.toml", manifest.name), "list": list, "sweep": sweep })
}
