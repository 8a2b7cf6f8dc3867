//! The operating window of a sweep, from results folders of its string and what is known without a
//! case.

use std::path::{Path, PathBuf};

use super::asked::WindowAsked;
use super::chart::Chart;
use super::error::WindowError;
use super::how_often_wrong::how_often_wrong;
use super::lateral;
use super::motor;
use super::of_folders;
use super::rates::Rates;
use super::simulated::AXES;
use crate::folder::{ResultTables, differences};
use campaign::plan::Sweep;
use campaign::sweep_file::FileContent;

/// An operating window.
#[derive(Debug, Clone, PartialEq)]
pub struct OperatingWindow {
    /// The limits over one another.
    pub chart: Chart,
    /// What may shake the string and has no limit here.
    pub not_examined: Vec<String>,
    /// How often words of safety were wrong for such strings, a sentence each.
    pub how_often_wrong: Vec<String>,
}

impl OperatingWindow {
    /// Of a sweep, by the tables of at least one results folder of its string.
    ///
    /// # Errors
    /// Where results are of another string or say nothing of limits, or places that hold the string
    /// are not on it.
    pub fn of(
        sweep: &Sweep,
        all: &[(PathBuf, ResultTables)],
        asked: &WindowAsked,
    ) -> Result<Self, WindowError> {
        for (folder, tables) in all {
            reject_foreign_folders(sweep, folder, tables)?;
        }
        let (ranges, mut sources) = of_folders::limits(sweep, all, asked)?;
        sources.extend(lateral::limits(sweep, ranges, asked)?);
        sources.extend(motor::limit(sweep, ranges, asked));
        let rates = all.iter().map(|(_, tables)| Rates::of(tables, asked.bins));
        let rates = rates.collect::<Result<Vec<_>, _>>();
        let rates = rates
            .map_err(WindowError::Results)?
            .into_iter()
            .flatten()
            .next();
        let chart = Chart::new(ranges, sources);
        Ok(Self {
            chart: match rates {
                Some(rates) => chart.with_rates(|place| rates.at(place)),
                None => chart,
            },
            not_examined: lateral::not_examined(sweep, ranges, asked),
            how_often_wrong: how_often_wrong(sweep),
        })
    }
}

/// Keys of what turns, bends and surrounds the string: limits for other values do not apply.
const OF_STRING: [&str; 9] = [
    "string",
    "motor",
    "top_drive",
    "well",
    "mud",
    "axial_force",
    "string_friction",
    "bit",
    "wall",
];

/// Refuses results of another string, and those that say nothing over weight and speed.
fn reject_foreign_folders(
    sweep: &Sweep,
    folder: &Path,
    tables: &ResultTables,
) -> Result<(), WindowError> {
    let folder = folder.to_owned();
    let manifest = &tables.manifest;
    let json =
        |content: &FileContent| (content.to_json()).map_err(|it| WindowError::Results(it.into()));
    let (mut own, mut its) = (json(&sweep.content)?, json(&manifest.sweep)?);
    // A part that the other has not is not modelled there.
    for content in [&mut own, &mut its] {
        if let Some(sections) = content["string"]["sections"].as_array_mut() {
            for section in sections.iter_mut().filter_map(|it| it.as_object_mut()) {
                section.remove("name");
            }
        }
    }
    for key in OF_STRING {
        let (one, other) = (&its[key], &own[key]);
        if one.is_null() || other.is_null() {
            continue;
        }
        if let Some(difference) = differences(one, other).first() {
            return Err(WindowError::OtherString {
                folder,
                file: sweep.source.file().to_owned(),
                difference: format!("{key}.{difference}"),
            });
        }
    }
    for (missing, other) in [(AXES[0], AXES[1]), (AXES[1], AXES[0])] {
        if !manifest.axes.contains(&missing) {
            return Err(WindowError::NotOver {
                folder,
                missing,
                other,
            });
        }
    }
    if manifest.tally.rows == 0 {
        return Err(WindowError::NoCase(folder));
    }
    Ok(())
}
