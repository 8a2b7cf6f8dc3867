//! A results folder in numbers.

use std::path::Path;

use anyhow::{Result, bail};
use sim::{Label, Motion};

use super::agreement::Agreement;
use super::character_map::character_map;
use super::failures::Failures;
use super::lattice::Lattice;
use super::limit::LimitChecks;
use super::live_map::{LiveMap, live_map};
use crate::map::{Cells, Extent, symbol_of};
use campaign::quantities::Axis;
use results::analysis::{Counts, MethodBlocks, blocks, count_cases};
use results::folder::{CaseRows, Manifest, ResultTables, misfit_columns, read_cases};
use results::traced::TracedLimits;

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
    /// Cases in its tables.
    pub cases: usize,
    /// The least and the greatest value along each axis.
    pub ranges: Vec<[f64; 2]>,
    /// How cases lie on the map, where the design has two axes and a case is here.
    pub lattice: Option<Lattice>,
    /// What is nearest to each recording, by the column of the misfit.
    pub nearest: Vec<(String, Nearest)>,
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

/// The simulation that is nearest to a recording.
pub struct Nearest {
    /// The misfit, in the unit of its column.
    pub misfit: f64,
    /// The case.
    pub case: usize,
    /// The method.
    pub method: String,
    /// Values along the axes.
    pub values: Vec<f64>,
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
        if !self.is_random() || self.manifest.tally.rows == 0 {
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
        let mut spread = Spread::new(manifest.axes.len(), misfit_columns(&labels)?);
        let mut rows = 0;
        for case in read_cases(&labels, &manifest.axes)? {
            let case = case?;
            rows += case.rows.len();
            spread.add(&case);
            agreement.add(&case);
            if let Some(limits) = &mut limits {
                limits.add(&case);
            }
            if let Some(map) = &mut map {
                map.add(&case);
            }
        }
        let failures = Failures::read(&tables.folder.join("failures.csv"))?;
        let mut lattice = None;
        let mut characters = None;
        if let Some(mut map) = map.filter(|map| map.extent.cases > 0) {
            characters = Some(map.characters());
            map.fill_traced(&labels, &manifest)?;
            lattice = Some(map.lattice);
        }
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
            cases: spread.cases,
            nearest: spread.nearest(),
            ranges: spread.ranges,
            lattice,
            characters,
            live: None,
            agreement,
            limits,
            failures,
            manifest,
        })
    }

    /// Whether its cases are random.
    pub fn is_random(&self) -> bool {
        let design = self.manifest.sweep.design.as_ref();
        design.is_some_and(|design| design.kind.is_random())
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

/// How far cases spread along their axes, and which are nearest to recordings.
struct Spread {
    cases: usize,
    ranges: Vec<[f64; 2]>,
    nearest: Vec<(String, Option<Nearest>)>,
}

impl Spread {
    fn new(axes: usize, misfits: Vec<String>) -> Self {
        Self {
            cases: 0,
            ranges: vec![[f64::INFINITY, f64::NEG_INFINITY]; axes],
            nearest: misfits.into_iter().map(|name| (name, None)).collect(),
        }
    }

    fn add(&mut self, case: &CaseRows) {
        self.cases += 1;
        for (range, &value) in self.ranges.iter_mut().zip(&case.values) {
            *range = [range[0].min(value), range[1].max(value)];
        }
        for row in &case.rows {
            for ((_, nearest), misfit) in self.nearest.iter_mut().zip(&row.misfits) {
                let least = nearest.as_ref().map_or(f64::INFINITY, |best| best.misfit);
                if let Some(misfit) = misfit.filter(|misfit| *misfit < least) {
                    *nearest = Some(Nearest {
                        misfit,
                        case: case.case,
                        method: row.method.clone(),
                        values: case.values.clone(),
                    });
                }
            }
        }
    }

    fn nearest(&mut self) -> Vec<(String, Nearest)> {
        let found = std::mem::take(&mut self.nearest).into_iter();
        found
            .filter_map(|(name, best)| Some((name, best?)))
            .collect()
    }
}

/// The cells of the maps of all motions, being counted.
struct MapCells {
    cells: Vec<(Motion, Cells)>,
    lattice: Lattice,
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
            lattice: Lattice::new(&extent),
            extent,
            axes,
            places: [x, y],
        }))
    }

    fn add(&mut self, case: &CaseRows) {
        let place = self.places.map(|place| case.values[place]);
        for (motion, cells) in &mut self.cells {
            if let Some(symbol) = symbol_of(case, *motion) {
                cells.add(place, symbol);
            }
        }
        self.lattice.add(place, case);
    }

    /// Of a traced design, the points that its cases imply.
    fn fill_traced(&mut self, labels: &Path, manifest: &Manifest) -> Result<()> {
        let Some(design) = manifest.traced_design() else {
            return Ok(());
        };
        let methods = manifest.method_names();
        if let Some(traced) = TracedLimits::read(labels, &design, &methods)? {
            let swapped = manifest.axes.first() != Some(&self.axes[0]);
            self.lattice
                .fill(&traced, methods.len(), swapped, &self.extent);
        }
        Ok(())
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
