//! The JSON Schema of sweep files, made from the types that read them: what `sweep schema`
//! prints, what the key reference of the guide is held to, and the list of known keys.

mod table;
mod types;
mod written;

use std::collections::BTreeSet;
use std::sync::LazyLock;

use serde_json::Value;

pub use types::of_types;

/// The schema (draft 2020-12) of a sweep file as a person writes it: over a base or without,
/// with keys in SI or in field units.
pub fn of_sweep_files() -> Value {
    written::as_written(of_types())
}

/// Whether any table of a sweep file has a key of this name, in SI units.
pub fn is_key(name: &str) -> bool {
    static KEYS: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
        let schema = of_types();
        let tables = table::all(&schema);
        tables.flat_map(table::keys).cloned().collect()
    });
    KEYS.contains(name)
}
