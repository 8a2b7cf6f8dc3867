//! What results folders are counted by: which of their cases, and in which blocks.

use std::path::PathBuf;

use anyhow::Result;
use thiserror::Error;

use super::bins::Bins;
use super::blocks::{MethodBlocks, blocks_of};
use super::counts::Counts;
use crate::folder::{Manifest, ResultTables};
use campaign::design::{Member, cases_of_block};
use campaign::quantities::Axis;
use campaign::sweep_file::DesignKind;

/// What results folders, parts of one sweep, say in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// The axes that cases differ in.
    pub axes: Vec<Axis>,
    /// How often each regime occurs: in all, over each axis, then over those that were asked for.
    pub counts: Vec<Counts>,
    /// The blocks of each method, where the cases are in blocks that tell the axes apart.
    pub blocks: Vec<MethodBlocks>,
}

/// Why there is no analysis.
#[derive(Debug, Error)]
pub enum NoAnalysis {
    /// Cases of a trace.
    #[error(
        "{} holds a trace: its cases lie along limits, and their fractions say nothing of the map; \
         limits.csv and bands.csv do",
        .0.display()
    )]
    Trace(PathBuf),
    /// No case at all.
    #[error("{} has no case to count yet", .0.display())]
    NoCase(PathBuf),
    /// Folders that are no parts of one sweep.
    #[error("{} and {} {why}: they are not counted together", one.display(), other.display())]
    Foreign {
        /// One folder.
        one: PathBuf,
        /// The other.
        other: PathBuf,
        /// Why not.
        why: &'static str,
    },
    /// An axis that cases do not differ in.
    #[error("the cases do not differ in {}; they do in {}", axis.name(), names(known))]
    NoAxis {
        /// The axis.
        axis: Axis,
        /// Those that they differ in.
        known: Vec<Axis>,
    },
    /// Tables that cannot be read.
    #[error("{0:#}")]
    Unreadable(anyhow::Error),
}

fn names(axes: &[Axis]) -> String {
    let names: Vec<String> = axes.iter().map(|axis| axis.name()).collect();
    names.join(", ")
}

impl Analysis {
    /// Of the tables of at least one of these folders, with counts over each set of axes in `by`,
    /// an axis of more than a few values in this number of `ranges`.
    ///
    /// # Errors
    /// Where the folders are no parts of one sweep, or their cases cannot be counted so.
    pub fn of(
        folders: &[PathBuf],
        tables: &[ResultTables],
        by: &[Vec<Axis>],
        ranges: usize,
    ) -> Result<Self, NoAnalysis> {
        reject_foreign_folders(folders, tables)?;
        let manifest = &tables[0].manifest;
        if manifest.is_trace() {
            return Err(NoAnalysis::Trace(folders[0].clone()));
        }
        if tables.iter().all(|tables| tables.manifest.tally.rows == 0) {
            return Err(NoAnalysis::NoCase(folders[0].clone()));
        }
        let known = &manifest.axes;
        if let Some(&axis) = by.iter().flatten().find(|axis| !known.contains(axis)) {
            let known = known.clone();
            return Err(NoAnalysis::NoAxis { axis, known });
        }
        let mut sets = vec![Vec::new()];
        sets.extend(known.iter().map(|&axis| vec![axis]));
        sets.extend(by.iter().cloned());
        let counts = count_cases(tables, &sets, ranges);
        Ok(Self {
            axes: known.clone(),
            counts: counts.map_err(NoAnalysis::Unreadable)?,
            blocks: blocks(tables).map_err(NoAnalysis::Unreadable)?,
        })
    }
}

/// Folders are counted together if they are different parts of one sweep.
fn reject_foreign_folders(folders: &[PathBuf], tables: &[ResultTables]) -> Result<(), NoAnalysis> {
    let all = || folders.iter().zip(tables);
    for (index, (folder, tables)) in all().enumerate() {
        let manifest = &tables.manifest;
        for (other, its_tables) in all().take(index) {
            let its = &its_tables.manifest;
            let why = if its.meaning_sha256 != manifest.meaning_sha256 || its.seed != manifest.seed
            {
                "are not of one sweep"
            } else if its.shard.is_none() || its.shard == manifest.shard {
                "hold the same cases"
            } else {
                continue;
            };
            let (one, other) = (other.clone(), folder.clone());
            return Err(NoAnalysis::Foreign { one, other, why });
        }
    }
    Ok(())
}

/// The counts over each set of axes, in the given number of ranges of an axis that has more than a
/// few values. The tables are shards of one sweep.
///
/// # Errors
/// Where the tables cannot be read.
pub fn count_cases(
    tables: &[ResultTables],
    sets: &[Vec<Axis>],
    ranges: usize,
) -> Result<Vec<Counts>> {
    let manifest = &tables[0].manifest;
    let bins = Bins::along(tables, &manifest.sweep, &manifest.axes, ranges)?;
    let of_axis = |axis: &Axis| bins.iter().find(|bins| bins.axis == *axis).cloned();
    let sets = sets
        .iter()
        .map(|axes| axes.iter().filter_map(of_axis).collect());
    let size = size_of_blocks(manifest);
    let is_counted = |case: usize| {
        // Of a block, those that are independent.
        size.is_none_or(|size| matches!(Member::at(case % size), Member::A | Member::B))
    };
    Counts::of_each(tables, &manifest.method_names(), sets.collect(), is_counted)
}

/// The cases of a block, where the cases are in blocks that tell the axes apart.
pub fn size_of_blocks(manifest: &Manifest) -> Option<usize> {
    let design = manifest.sweep.design.as_ref()?;
    let has_blocks = design.kind == DesignKind::Sensitivity;
    has_blocks.then(|| cases_of_block(manifest.axes.len()))
}

/// The blocks of each method, where there are any.
///
/// # Errors
/// Where the tables cannot be read.
pub fn blocks(tables: &[ResultTables]) -> Result<Vec<MethodBlocks>> {
    let manifest = &tables[0].manifest;
    match size_of_blocks(manifest) {
        Some(_) => blocks_of(tables, &manifest.method_names(), manifest.axes.len()),
        None => Ok(Vec::new()),
    }
}
