//! What results folders are counted by: which of their cases, and in which blocks.

use anyhow::Result;

use super::bins::Bins;
use super::blocks::{MethodBlocks, blocks_of};
use super::counts::Counts;
use crate::folder::{Manifest, ResultTables};
use campaign::design::{Member, cases_of_block};
use campaign::quantities::Axis;
use campaign::sweep_file::DesignKind;

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
