//! `manifest.json`: what was run, with which settings and methods, and the counts of
//! what came out.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::tally::Tally;
use super::trace_summary::TraceSummary;
use crate::files::{Checksum, hexadecimal, refuse_irregular, write_atomically};
use crate::log::Header;
use campaign::dependence::Dependence;
use campaign::design::{Design, TraceDesign};
use campaign::engine::{MethodSystem, RunOptions, Shard};
use campaign::labels::CertifiedBy;
use campaign::plan::{Choice, Data, MapSettings, Sweep, steps_of_turn};
use campaign::quantities::Axis;
use campaign::sweep_file::{DesignKind, FileContent};
use campaign::text_file::unreadable;
use campaign::words::short;
use limits::ForwardContact;

/// What was run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// Name of the sweep.
    pub name: String,
    /// One line about it.
    pub title: String,
    /// The sweep file, as the command names it; not written by version 0.1.0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sweep_file: Option<PathBuf>,
    /// The program, with its version and commit.
    pub program: String,
    /// Version of the program.
    pub program_version: String,
    /// Processor architecture and operating system.
    pub platform: String,
    /// Hash of everything that the results depend on.
    pub meaning_sha256: String,
    /// Hash of the cases, where the design is a list.
    pub cases_sha256: Option<String>,
    /// Hash of a survey and of what was recorded, where the file names any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub data_sha256: Option<String>,
    /// Seed, where the design draws random cases.
    pub seed: Option<u64>,
    /// Sampling frequency, Hz; of the string as the file says it, where axes
    /// change the string.
    pub sampling_frequency_hz: f64,
    /// Whether that is the paper's rule or given in the file.
    pub sampling_frequency_by_rule: bool,
    /// What was chosen for the accuracy asked for, and why.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Choice>,
    /// Number of cases of the whole sweep.
    pub cases: usize,
    /// What differs between them, in the order of the columns.
    pub axes: Vec<Axis>,
    /// Number of distinct strings among them.
    pub strings: usize,
    /// The part of the sweep that is here, where that is not the whole.
    pub shard: Option<Shard>,
    /// The options that it was run with.
    #[serde(flatten)]
    pub options: RunOptions,
    /// What is known of each method; of the string as the file says it, where
    /// axes change the string.
    pub methods: Vec<MethodRecord>,
    /// What certifies its labels, where it does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certified_by: Option<CertifiedBy>,
    /// How many labels of a sample of cases change with the method, the sampling frequency and
    /// the start.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub depends_on: Vec<Dependence>,
    /// From which surface speed on an eccentric mass brings the string to its wall, where that is
    /// known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub forward_contact: Option<ForwardContact>,
    /// What came out.
    #[serde(flatten)]
    pub tally: Tally,
    /// The tables and pictures next to it; empty in a folder of version 0.1.0.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub files: BTreeMap<String, Checksum>,
    /// How its limits were traced, where the design is a trace.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trace: Option<TraceSummary>,
    /// Threads used.
    pub threads: usize,
    /// Time from start to end, s; of the last part, where it was stopped.
    pub wall_seconds: f64,
    /// How the map is drawn, where there is one.
    pub map: Option<MapSettings>,
    /// The sweep file, its bases merged in.
    #[serde(deserialize_with = "FileContent::from_json")]
    pub sweep: FileContent,
}

/// One method's linear system.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MethodRecord {
    /// Its name.
    pub method: String,
    /// Its sampling frequency, Hz, where whirl needs a higher one than that of all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sampling_frequency_hz: Option<f64>,
    /// Taps per response.
    pub taps: usize,
    /// Positive-real margin in torsion, where a torque acts.
    pub positive_real_margin: Option<f64>,
    /// Positive-real margin in bending, where it is modelled.
    pub bending_margin: Option<f64>,
    /// The same along the axis.
    #[serde(default)]
    pub axial_margin: Option<f64>,
    /// Δ of Eq. 75 by the method, where it was compared with the exact one.
    #[serde(default)]
    pub undershoot_rad_s_per_nm: Option<f64>,
    /// The exact one of this string.
    #[serde(default)]
    pub exact_undershoot_rad_s_per_nm: Option<f64>,
    /// I₀ of each impulse, N s.
    pub least_impulses_ns: Vec<f64>,
    /// Time to build, s; not known of a run that is not finished.
    pub build_seconds: Option<f64>,
}

impl MethodRecord {
    fn of(system: &MethodSystem, sweep: &Sweep) -> Self {
        let own = sweep.setting.frequency_by(&system.method);
        Self {
            method: system.method.name().to_owned(),
            sampling_frequency_hz: (own > sweep.setting.sampling_frequency).then_some(own),
            taps: system.torsion_taps(),
            positive_real_margin: system.torsion_margin,
            bending_margin: system.bending_margin,
            axial_margin: system.axial_margin,
            undershoot_rad_s_per_nm: system.front.map(|front| front.undershoot),
            exact_undershoot_rad_s_per_nm: system.front.map(|front| front.exact),
            least_impulses_ns: system.least_impulses.clone(),
            build_seconds: Some(system.build_seconds),
        }
    }
}

impl Manifest {
    /// The record of a run, without what came out and how long it took.
    ///
    /// # Errors
    /// None that a sweep that was read could cause.
    pub fn new(
        sweep: &Sweep,
        header: &Header,
        options: RunOptions,
        systems: &[MethodSystem],
    ) -> Result<Self> {
        Ok(Self {
            name: sweep.name.clone(),
            title: sweep.title.clone(),
            // As the user named it, in any encoding of its path.
            sweep_file: Some(sweep.source.file().to_string_lossy().into_owned().into()),
            program: header.program.clone(),
            program_version: env!("CARGO_PKG_VERSION").to_owned(),
            platform: format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS),
            meaning_sha256: fingerprint_hash(&header.fingerprint)?,
            cases_sha256: cases_hash(&sweep.design)?,
            data_sha256: data_hash(&sweep.data)?,
            seed: sweep.design.seed(),
            sampling_frequency_hz: sweep.setting.sampling_frequency,
            sampling_frequency_by_rule: sweep.setting.steps_per_travel.is_some(),
            accuracy: sweep.choice.clone(),
            cases: sweep.design.cases(),
            axes: sweep.design.axes().to_vec(),
            strings: sweep.design.strings(),
            shard: (!header.shard.is_whole()).then_some(header.shard),
            options,
            methods: (systems.iter())
                .map(|system| MethodRecord::of(system, sweep))
                .collect(),
            depends_on: Vec::new(),
            certified_by: CertifiedBy::of(sweep),
            forward_contact: ForwardContact::of(sweep)?,
            tally: Tally::default(),
            files: BTreeMap::new(),
            trace: None,
            threads: linear::parallel::threads(),
            wall_seconds: 0.0,
            map: sweep.map.clone(),
            sweep: sweep.content.clone(),
        })
    }

    /// Names of the methods.
    pub fn method_names(&self) -> Vec<&str> {
        let methods = self.methods.iter();
        methods.map(|method| method.method.as_str()).collect()
    }

    /// What tells the run that it records from others.
    ///
    /// # Errors
    /// None that a manifest that was read could cause.
    pub fn fingerprint(&self) -> Result<serde_json::Value> {
        let hashes = [&self.cases_sha256, &self.data_sha256].map(Option::as_deref);
        let by_rule = self.sampling_frequency_by_rule;
        let whirl = (self.methods.iter()).filter_map(|method| method.sampling_frequency_hz);
        let by_rule = by_rule.then(|| (self.sampling_frequency_hz, whirl.collect()));
        fingerprint_of(&self.sweep, hashes, by_rule, self.options)
    }

    /// Methods in whose steps the whirl that came out is too fast, each in a sentence. A tenth too few are
    /// no matter: so far off is the rate that was expected. The frequency that resolves it is the same for all.
    pub fn damped_whirl(&self) -> impl Iterator<Item = String> {
        let of_method = |record: &MethodRecord| {
            let rate = *self.tally.fastest_whirl_turns_per_s.get(&record.method)?;
            let own = record.sampling_frequency_hz;
            let frequency = own.unwrap_or(self.sampling_frequency_hz);
            let needed = steps_of_turn(&record.method);
            (frequency / rate < LEAST_OF_NEEDED * needed)
                .then(|| (record.method.clone(), rate, frequency, needed))
        };
        let all: Vec<_> = self.methods.iter().filter_map(of_method).collect();
        let resolving = all
            .iter()
            .map(|(_, rate, _, needed)| rate * needed)
            .fold(0.0, f64::max);
        let has_accuracy = self.accuracy.is_some();
        all.into_iter().map(move |(method, rate, frequency, needed)| {
            let steps = frequency / rate;
            let remedy = match has_accuracy {
                true => "a smaller `accuracy`".to_owned(),
                false => format!("`sampling_frequency_hz = {:.0}`", resolving.ceil()),
            };
            format!(
                "{method}: whirl at {rate:.0} turns/s has {steps:.1} steps in a turn at {} Hz, and \
                 needs {needed}: its force is too small, and whirl that lasts may be missed; \
                 {remedy} resolves it",
                short(frequency),
            )
        })
    }

    /// Whether there is a map of it: none of a part, nor of fewer than two axes.
    pub fn draws(&self) -> bool {
        self.shard().is_whole() && self.map.is_some()
    }

    /// Cases that it has rows of.
    pub fn cases_here(&self) -> usize {
        self.tally.rows / self.methods.len().max(1)
    }

    /// Whether its cases were chosen along limits.
    pub fn is_trace(&self) -> bool {
        let design = self.sweep.design.as_ref();
        design.is_some_and(|design| design.kind == DesignKind::Trace)
    }

    /// Its design, where limits were traced to their end.
    pub fn traced_design(&self) -> Option<TraceDesign> {
        self.trace.as_ref()?;
        let axes = self.axes.as_slice().try_into().ok()?;
        // Which axes change the string does not matter any more.
        TraceDesign::of(self.sweep.design.as_ref()?, axes, 0)
    }

    /// The part of the sweep it records.
    pub fn shard(&self) -> Shard {
        self.shard.unwrap_or(Shard::WHOLE)
    }

    /// Writes it into a results folder.
    ///
    /// # Errors
    /// Where that cannot be written.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let content = serde_json::to_vec_pretty(self)?;
        write_atomically(&folder.join("manifest.json"), &content)
    }

    /// Reads the manifest of a results folder.
    pub fn read(folder: &Path) -> Result<Self> {
        let path = folder.join("manifest.json");
        // Before it is opened: that alone waits for the other end of a pipe.
        let text = refuse_irregular(&path).and_then(|()| std::fs::read_to_string(&path));
        let text = text.with_context(|| unreadable(&path))?;
        serde_json::from_str(&text)
            .with_context(|| format!("{} is not a manifest of this program", path.display()))
    }
}

/// What tells a run with these options from others: comments, key order, the spelling of
/// numbers, titles, units that are shown and how the map is drawn do not matter; the cases of a
/// list do.
///
/// # Errors
/// None that a sweep that was read could cause.
pub fn fingerprint(sweep: &Sweep, options: RunOptions) -> Result<serde_json::Value> {
    let hashes = [cases_hash(&sweep.design)?, data_hash(&sweep.data)?];
    let setting = &sweep.setting;
    let base = setting.sampling_frequency;
    let of_methods = sweep
        .methods
        .iter()
        .map(|method| setting.frequency_by(method));
    let whirl = of_methods.filter(|own| *own > base).collect();
    let by_rule = setting.steps_per_travel.map(|_| (base, whirl));
    fingerprint_of(
        &sweep.content,
        hashes.each_ref().map(Option::as_deref),
        by_rule,
        options,
    )
}

fn fingerprint_of(
    content: &FileContent,
    hashes: [Option<&str>; 2],
    frequencies_by_rule: Option<(f64, Vec<f64>)>,
    options: RunOptions,
) -> Result<serde_json::Value> {
    let mut content = content.clone();
    content.name = None;
    content.title = None;
    content.units = Default::default();
    content.map = Default::default();
    for section in &mut content.string.sections {
        section.name = None;
    }
    let mut fingerprint = content.to_json()?;
    if let Some(table) = fingerprint.as_object_mut() {
        for (name, hash) in ["cases of the list", "survey and recordings"]
            .iter()
            .zip(hashes)
        {
            if let Some(hash) = hash {
                table.insert((*name).to_owned(), hash.into());
            }
        }
        // An accuracy chooses another.
        if let (Some((frequency, whirl)), None) = (frequencies_by_rule, content.accuracy) {
            // Another rule makes another run of the same file.
            let key = "sampling frequency by rule, Hz";
            table.insert(key.to_owned(), frequency.into());
            if !whirl.is_empty() {
                let key = "sampling frequencies by whirl, Hz";
                table.insert(key.to_owned(), whirl.into());
            }
        }
        for (option, is_given) in [
            ("--full", options.full),
            ("--allow-unstable", options.allow_unstable),
        ] {
            if is_given {
                table.insert(option.to_owned(), true.into());
            }
        }
    }
    Ok(fingerprint)
}

/// Hash of the cases of a list.
fn cases_hash(design: &Design) -> Result<Option<String>> {
    let Design::List(_) = design else {
        return Ok(None);
    };
    let mut hash = Sha256::new();
    for case in 0..design.cases() {
        hash.update(serde_json::to_vec(&design.values(case))?);
    }
    Ok(Some(hexadecimal(hash)))
}

/// Hash of what the files say that a sweep file names, where it names any.
fn data_hash(data: &Data) -> Result<Option<String>> {
    let Some(meaning) = data.meaning() else {
        return Ok(None);
    };
    let mut hash = Sha256::new();
    hash.update(serde_json::to_vec(&meaning)?);
    Ok(Some(hexadecimal(hash)))
}

fn fingerprint_hash(fingerprint: &serde_json::Value) -> Result<String> {
    let mut hash = Sha256::new();
    hash.update(serde_json::to_vec(fingerprint)?);
    Ok(hexadecimal(hash))
}

/// Longest value that is shown of a key that differs, in letters.
const LONGEST_SHOWN: usize = 60;

/// Whirl with fewer than this part of the steps in a turn that it needs is warned of.
const LEAST_OF_NEEDED: f64 = 0.9;

/// Where two fingerprints differ, each as `key: before → now`, or `key: changed` where that is long.
pub fn differences(before: &serde_json::Value, now: &serde_json::Value) -> Vec<String> {
    let mut found = Vec::new();
    compare("", before, now, &mut found);
    found
}

fn compare(
    path: &str,
    before: &serde_json::Value,
    now: &serde_json::Value,
    found: &mut Vec<String>,
) {
    use serde_json::Value::{Array, Null, Object};
    match (before, now) {
        _ if before == now => {}
        (Object(one), Object(other)) => {
            let keys: BTreeSet<&String> = one.keys().chain(other.keys()).collect();
            for key in keys {
                let path = if path.is_empty() {
                    key.clone()
                } else {
                    format!("{path}.{key}")
                };
                let value = |table: &serde_json::Map<_, _>| table.get(key).cloned().unwrap_or(Null);
                compare(&path, &value(one), &value(other), found);
            }
        }
        (Array(one), Array(other)) if one.len() == other.len() => {
            for (index, (one, other)) in one.iter().zip(other).enumerate() {
                compare(&format!("{path}[{index}]"), one, other, found);
            }
        }
        _ => {
            let [before, now] = [before, now].map(|value| value.to_string());
            // Hashes, and tables of tubes, say nothing to a reader.
            found.push(match before.len().max(now.len()) <= LONGEST_SHOWN {
                true => format!("{path}: {before} → {now}"),
                false => format!("{path}: changed"),
            });
        }
    }
}
