//! A results folder in numbers.

use std::path::Path;

use anyhow::{Result, bail};
use sim::{Label, Motion};

use super::agreement::Agreement;
use super::character_map::character_map;
use super::failures::Failures;
use super::limit::LimitChecks;
use super::live_map::{LiveMap, live_map};
use crate::map::{Cells, Extent, symbol_of};
use campaign::quantities::Axis;
use results::analysis::{Counts, MethodBlocks, blocks, count_cases};
use results::folder::{CaseRows, Manifest, ResultTables, read_cases};

/// Cells of the map in characters, to the right and upwards: it fits a terminal.
const CHARACTERS: [usize; 2] = [64, 25];

/// Ranges of an axis of random cases, as `sweep analyse` takes them by default.
const RANGES: usize = 10;

/// What a results folder says.
pub struct Results {
    /// The folder, as it was given.
    pub name: String,
    /// Its tables.
    pub tables: ResultTables,
    /// What was run.
    pub manifest: Manifest,
    /// Whether the methods agree.
    pub agreement: Agreement,
    /// The boundary against the analytic limit, where there is one.
    pub limits: Option<LimitChecks>,
    /// Cases without an answer.
    pub failures: Failures,
    /// How often each regime occurs, of random cases, where that was counted.
    pub analysed: Option<Analysed>,
    /// The regimes in characters, where the design has two axes and a case is here.
    pub characters: Option<String>,
    /// The map as a page draws it, where that was asked for.
    pub live: Option<LiveMap>,
}

/// Counts of random cases.
pub struct Analysed {
    /// In all, then over each axis.
    pub counts: Vec<Counts>,
    /// The blocks of each method, where cases are in such.
    pub blocks: Vec<MethodBlocks>,
}

impl Results {
    /// Counts the cases, where they are random: of others, parts tell nothing.
    ///
    /// # Errors
    /// Where the tables cannot be read.
    pub fn analyse(&mut self) -> Result<()> {
        let design = self.manifest.sweep.design.as_ref();
        if !design.is_some_and(|design| design.kind.is_random()) || self.manifest.tally.rows == 0 {
            return Ok(());
        }
        let each = self.manifest.axes.iter().map(|&axis| vec![axis]);
        let sets: Vec<_> = std::iter::once(Vec::new()).chain(each).collect();
        let tables = std::slice::from_ref(&self.tables);
        self.analysed = Some(Analysed {
            counts: count_cases(tables, &sets, RANGES)?,
            blocks: blocks(tables)?,
        });
        Ok(())
    }

    /// Draws the map for a page of a number of folders, where it is of a whole sweep.
    ///
    /// # Errors
    /// Where the tables cannot be read.
    pub fn draw(&mut self, folders: usize) -> Result<()> {
        if self.manifest.draws() && self.manifest.tally.rows > 0 {
            self.live = live_map(&self.tables, folders)?;
        }
        Ok(())
    }

    /// Reads the tables of a folder.
    ///
    /// # Errors
    /// Where a file cannot be read, or the files are not of one run.
    pub fn read(folder: &Path, tables: ResultTables) -> Result<Self> {
        let manifest = tables.manifest.clone();
        let labels = tables.folder.join("labels.csv");
        let methods = manifest.method_names();
        let boundary = tables.boundary()?;
        let mut limits = LimitChecks::new(&boundary, &manifest.axes, &methods);
        let motions = manifest.tally.motions();
        let mut agreement = Agreement::new(&methods, &motions);
        let mut map = MapCells::new(folder, &manifest, &labels)?;
        let mut rows = 0;
        for case in read_cases(&labels, &manifest.axes)? {
            let case = case?;
            rows += case.rows.len();
            agreement.add(&case);
            if let Some(limits) = &mut limits {
                limits.add(&case);
            }
            if let Some(map) = &mut map {
                map.add(&case);
            }
        }
        let failures = Failures::read(&tables.folder.join("failures.csv"))?;
        let tally = &manifest.tally;
        if (rows, failures.count()) != (tally.rows, tally.failed) {
            bail!(
                "{} holds {rows} rows, {} of them failed, but manifest.json speaks of {} and {}: \
                 its files are not of one run",
                folder.display(),
                failures.count(),
                tally.rows,
                tally.failed
            );
        }
        Ok(Self {
            name: folder.display().to_string(),
            tables,
            analysed: None,
            characters: map
                .filter(|map| map.extent.cases > 0)
                .map(|map| map.characters()),
            live: None,
            agreement,
            limits,
            failures,
            manifest,
        })
    }

    /// Names of the methods.
    pub fn methods(&self) -> Vec<&str> {
        self.manifest.method_names()
    }

    /// Rows of a method with a label.
    pub fn count(&self, method: &str, label: Label) -> usize {
        let labels = self.manifest.tally.labels.get(method);
        let count = labels.and_then(|labels| labels.get(&label));
        count.copied().unwrap_or(0)
    }
}

/// The cells of the maps of all motions, being counted.
struct MapCells {
    cells: Vec<(Motion, Cells)>,
    extent: Extent,
    axes: [Axis; 2],
    /// Places of the map's axes among the values of a case.
    places: [usize; 2],
}

impl MapCells {
    fn new(folder: &Path, manifest: &Manifest, labels: &Path) -> Result<Option<Self>> {
        let Some(map) = &manifest.map else {
            return Ok(None);
        };
        let axes = [map.x, map.y];
        let place = |axis| manifest.axes.iter().position(|&other| other == axis);
        let (Some(x), Some(y)) = (place(map.x), place(map.y)) else {
            bail!(
                "{}: the map of manifest.json has an axis that its cases do not have",
                folder.display()
            );
        };
        let extent = Extent::of(labels, axes, Vec::new(), &manifest.sweep)?;
        let motions = extent.motions.iter();
        Ok(Some(Self {
            cells: motions
                .map(|&motion| (motion, Cells::new(&extent, CHARACTERS)))
                .collect(),
            extent,
            axes,
            places: [x, y],
        }))
    }

    fn add(&mut self, case: &CaseRows) {
        for (motion, cells) in &mut self.cells {
            if let Some(symbol) = symbol_of(case, *motion) {
                cells.add(self.places.map(|place| case.values[place]), symbol);
            }
        }
    }

    /// One map below the other, each with its heading where there are two.
    fn characters(&self) -> String {
        let maps = self.cells.iter().map(|(motion, cells)| {
            let map = character_map(cells, &self.extent, *motion, self.axes);
            if self.cells.len() == 1 {
                map
            } else {
                format!("{}\n\n{map}", motion.title())
            }
        });
        maps.collect::<Vec<String>>().join("\n")
    }
}
