//! What a page may ask, in JSON.

use std::collections::BTreeMap;
use std::path::PathBuf;

use campaign::quantities::Axis;
use campaign::sweep_file::{FileContent, MethodName};
use serde::Deserialize;

/// A request: an object whose only key says what is asked.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Request {
    /// Opens a sweep, in place of the one before.
    Open(Box<Opening>),
    /// Simulates a case by a method.
    Simulate(CaseAsked),
    /// Tells the one-slip estimate of stick-slip (Eq. 74) along an axis.
    Limit(LimitAsked),
}

/// A sweep file, or what became of one.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Opening {
    /// The sweep file's path: names it in messages, and files in its folder are found by it.
    pub path: PathBuf,
    /// The sweep with its bases merged in, as `manifest.json` has it; without it, the sweep file
    /// is one of the texts.
    pub sweep: Option<Box<FileContent>>,
    /// Texts of files by their paths.
    #[serde(default)]
    pub texts: BTreeMap<PathBuf, String>,
    /// Methods in addition to the sweep's own.
    #[serde(default)]
    pub methods: Vec<MethodName>,
}

/// A case with what is changed of it.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CaseAsked {
    /// Its number.
    pub case: usize,
    /// Quantities set to other values, by their names.
    pub set: BTreeMap<Axis, f64>,
    /// The method; by default the sweep's first.
    pub method: Option<MethodName>,
    /// Whether its label too is that of the case followed to the end of its time.
    pub full: bool,
    /// Whether a linear system that is there may be used though it was built for a longer time
    /// than `sweep simulate` would build one for.
    pub quick: bool,
}

/// Where the limit is asked for.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LimitAsked {
    /// The case whose string and bit it is the limit of.
    #[serde(default)]
    pub of: CaseAsked,
    /// The axis, of torque or weight on bit.
    pub axis: Axis,
    /// Values along it.
    pub values: Vec<f64>,
}
