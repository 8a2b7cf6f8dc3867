//! `manifest.json`: what was run, with what, and what came of it.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::design::Design;
use crate::engine::{MethodSystem, Row, RowOutcome};
use crate::spec::{FileContent, MapSettings, Sweep};

/// What was run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// Name of the sweep.
    pub name: String,
    /// One line about it.
    pub title: String,
    /// Version of this program.
    pub program_version: String,
    /// Processor architecture and operating system.
    pub platform: String,
    /// Hash of everything that the results depend on.
    pub meaning_sha256: String,
    /// Sampling frequency, Hz.
    pub sampling_frequency_hz: f64,
    /// Whether that is the paper's rule or given in the file.
    pub sampling_frequency_by_rule: bool,
    /// Number of cases.
    pub cases: usize,
    /// What is known of each method.
    pub methods: Vec<MethodRecord>,
    /// Rows per method and label.
    pub labels: BTreeMap<String, BTreeMap<String, usize>>,
    /// Rows without an answer.
    pub failed: usize,
    /// Threads used.
    pub threads: usize,
    /// Time from start to end, s.
    pub wall_seconds: f64,
    /// How the map is drawn, where there is one.
    pub map: Option<MapSettings>,
    /// The sweep file, its bases merged in.
    pub sweep: FileContent,
}

/// One method's linear system.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodRecord {
    /// Its name.
    pub method: String,
    /// Taps per response.
    pub taps: usize,
    /// Positive-real margin in torsion, where a torque acts.
    pub positive_real_margin: Option<f64>,
    /// Positive-real margin in bending, where it is modelled.
    pub bending_margin: Option<f64>,
    /// I₀ of each impulse, N s.
    pub least_impulses_ns: Vec<f64>,
    /// Time to build, s.
    pub build_seconds: f64,
}

impl Manifest {
    /// The record of a finished run.
    pub fn new(
        sweep: &Sweep,
        systems: &[MethodSystem],
        rows: &[Row],
        wall_seconds: f64,
    ) -> Result<Self> {
        Ok(Self {
            name: sweep.name.clone(),
            title: sweep.title.clone(),
            program_version: env!("CARGO_PKG_VERSION").to_owned(),
            platform: format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS),
            meaning_sha256: meaning_hash(sweep)?,
            sampling_frequency_hz: sweep.sampling_frequency,
            sampling_frequency_by_rule: sweep.sampling_by_rule,
            cases: sweep.design.cases(),
            methods: systems
                .iter()
                .map(|system| MethodRecord {
                    method: system.method.name().to_owned(),
                    taps: system.responses.taps(),
                    positive_real_margin: system.torsion_margin,
                    bending_margin: system.bending_margin,
                    least_impulses_ns: system.least_impulses.clone(),
                    build_seconds: system.build_seconds,
                })
                .collect(),
            labels: count_labels(rows),
            failed: rows
                .iter()
                .filter(|row| matches!(row.outcome, RowOutcome::Failed(_)))
                .count(),
            threads: rayon::current_num_threads(),
            wall_seconds,
            map: sweep.map.clone(),
            sweep: sweep.content.clone(),
        })
    }

    /// Reads the manifest of a results folder.
    pub fn read(folder: &Path) -> Result<Self> {
        let path = folder.join("manifest.json");
        let text = std::fs::read_to_string(&path)
            .with_context(|| format!("{} cannot be read", path.display()))?;
        serde_json::from_str(&text)
            .with_context(|| format!("{} is not a manifest of this program", path.display()))
    }
}

fn count_labels(rows: &[Row]) -> BTreeMap<String, BTreeMap<String, usize>> {
    let mut counts: BTreeMap<String, BTreeMap<String, usize>> = BTreeMap::new();
    for row in rows {
        let RowOutcome::Done(outcome) = &row.outcome else {
            continue;
        };
        let torsion = outcome.torsion.map(|torsion| torsion.regime.name());
        let lateral = outcome.lateral.map(|lateral| lateral.regime.name());
        for label in torsion.into_iter().chain(lateral) {
            let of_method = counts.entry(row.method.to_owned()).or_default();
            *of_method.entry(label.to_owned()).or_default() += 1;
        }
    }
    counts
}

/// Hash of what a sweep means: comments, key order, the spelling of numbers,
/// titles and how the map is drawn do not matter; the cases of a list do.
pub fn meaning_hash(sweep: &Sweep) -> Result<String> {
    let mut content = sweep.content.clone();
    content.title = None;
    content.map = Default::default();
    for section in &mut content.string.sections {
        section.name = None;
    }
    let mut hash = Sha256::new();
    hash.update(serde_json::to_vec(&content)?);
    if let Design::List(_) = &sweep.design {
        for case in 0..sweep.design.cases() {
            hash.update(serde_json::to_vec(&sweep.design.values(case))?);
        }
    }
    Ok(hash
        .finalize()
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect())
}
