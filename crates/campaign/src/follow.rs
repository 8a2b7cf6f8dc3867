//! Cases that are asked for, followed to the end of their time: the row that a run has of each, and
//! its motion. The command line, Python and the page follow cases by this.
//!
//! The motion of a case (`text` as in the example of the crate):
//!
//! ```
//! # let text = r#"
//! # methods = ["quadrature"]
//! # [string]
//! # shear_modulus_gpa = 80
//! # density_kg_m3 = 7840
//! # torsional_damping_nms_rad_m = 10
//! # [[string.sections]]
//! # name = "pipe"
//! # repeat = 50
//! # parts = [{ length_m = 10, inner_radius_m = 0.05, outer_radius_m = 0.1 }]
//! # [bit]
//! # rock = "sandstone"
//! # [design]
//! # kind = "grid"
//! # [design.axes]
//! # surface_speed_rpm = { values = [0.4, 60] }
//! # weight_on_bit_kn = { values = [50] }
//! # "#;
//! use campaign::Campaign;
//! use campaign::engine::RunOptions;
//! use campaign::follow::{Following, KeptSystems};
//! use campaign::quantities::Axis;
//!
//! let campaign = Campaign::open("my.toml".as_ref(), &[], &|_, _| Ok(text.to_owned()))?;
//! let set = [(Axis::SurfaceSpeedRpm, 30.0)];
//! let chosen = campaign.cases(&[1], &set, &[0])?.map_err(|_| "its string is possible")?;
//! let how = Following { options: RunOptions::default(), memory: None, warn: &|_| {} };
//! let followed = chosen.follow(&how, &mut KeptSystems::default())?;
//! let speeds = &followed.simulations[0].trajectory.speeds[0];
//! // In the end the bit turns at 30 rpm.
//! let last = speeds.last().ok_or("it was followed")?;
//! assert!((last / (std::f64::consts::PI * 30.0 / 30.0) - 1.0).abs() < 0.05, "{last}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use anyhow::Result;
use thiserror::Error;

use crate::engine::{
    Case, CaseChoice, CaseError, ChoiceError, ChosenCase, FollowedMethod, Instability,
    MethodSystem, Recipe, RunOptions, Simulation, Survey, answer, common_setting,
};
use crate::memory::{Limit, Purpose, admit};
use crate::plan::Sweep;
use crate::quantities::Axis;
use crate::records::{Failure, Record};
use crate::sweep_file::SweepFileError;

/// Cases that are followed together, for they have one string.
pub struct ChosenCases {
    /// The sweep with that string.
    pub sweep: Sweep,
    /// The cases.
    pub cases: Vec<ChosenCase>,
    /// Places of methods in the sweep's list.
    pub methods: Vec<usize>,
}

impl ChosenCases {
    /// Cases of a sweep by their numbers, with some quantities set to other values, and methods by
    /// their places in its list. Where the values make no string: rows that say so.
    ///
    /// # Errors
    /// Where there is no such case, what is set does not fit it, or strings differ.
    pub fn of(
        sweep: &Sweep,
        cases: &[usize],
        set: &[(Axis, f64)],
        methods: &[usize],
    ) -> Result<Result<Self, Vec<Record>>, ChoiceError> {
        let choices = cases
            .iter()
            .map(|&index| CaseChoice::new(sweep, index, set));
        let choices = choices.collect::<Result<Vec<_>, _>>()?;
        let setting = match common_setting(sweep, &choices)? {
            Ok(setting) => setting,
            Err(reason) => {
                let rows = choices.iter().flat_map(|choice| {
                    methods.iter().map(|&method| {
                        let values = choice.values.clone();
                        Record::failed(choice.index, method, values, Failure::new(&reason))
                    })
                });
                return Ok(Err(rows.collect()));
            }
        };
        let sweep = Sweep {
            setting,
            ..sweep.clone()
        };
        let cases = choices.into_iter().map(|choice| choice.case(&sweep));
        Ok(Ok(Self {
            cases: cases.collect::<Result<_, _>>()?,
            methods: methods.to_vec(),
            sweep,
        }))
    }

    /// The row of every case and method, as a run has it, and the motion of each that has an answer.
    ///
    /// # Errors
    /// Where it takes too much memory, a method cannot treat the string, or sites differ that are
    /// found.
    pub fn follow(self, how: &Following, kept: &mut KeptSystems) -> Result<Followed, FollowError> {
        how.admit(&self)?;
        if !self.finds_sites() {
            return to_the_end(self, how, kept);
        }
        let rows = find_sites(&self, how, kept)?;
        if rows.iter().any(|row| row.outcome.is_err()) {
            return Ok(Followed {
                sweep: self.sweep,
                cases: self.cases.into_iter().map(|chosen| chosen.case).collect(),
                rows,
                simulations: Vec::new(),
            });
        }
        let chosen = self.at_found_sites(&rows)?;
        how.admit(&chosen)?;
        // No other case has these sites.
        let followed = to_the_end(chosen, how, &mut KeptSystems::default())?;
        // The rows of a run say in how many rounds sites were found.
        Ok(Followed { rows, ..followed })
    }

    fn finds_sites(&self) -> bool {
        let lateral = self.sweep.setting.lateral.as_ref();
        lateral.is_some_and(|lateral| lateral.finding.is_some())
    }

    /// The same at the sites that were found, as rows have them.
    fn at_found_sites(self, rows: &[Record]) -> Result<Self, FollowError> {
        let sites_of = |row: &Record| row.found.as_ref().map(|found| found.sites.clone());
        let sites = rows.first().and_then(sites_of).unwrap_or_default();
        let has_others = |row: &Record| sites_of(row).as_ref() != Some(&sites);
        if rows.iter().any(has_others) {
            return Err(FollowError::DifferentSites);
        }
        let setting = (self.sweep).setting_with_sites(&self.sweep.setting, &sites)?;
        let cases = self.cases.into_iter().map(|chosen| {
            let case = chosen.case.at_sites_of(&setting)?;
            Ok(ChosenCase { case, ..chosen })
        });
        Ok(Self {
            cases: cases.collect::<Result<_, CaseError>>()?,
            sweep: Sweep {
                setting,
                ..self.sweep
            },
            methods: self.methods,
        })
    }
}

/// How cases are followed.
pub struct Following<'a> {
    /// How a run steps them.
    pub options: RunOptions,
    /// The most memory that histories may take, with that of some shapes of the whole string; any
    /// where there is none.
    pub memory: Option<(&'a Limit, usize)>,
    /// Hears of each method that chatters where a site sticks, and is followed all the same.
    pub warn: &'a dyn Fn(&Instability),
}

impl Following<'_> {
    /// How a run steps cases of this sweep. Where all share a string, a run refuses a method that
    /// chatters before any row: what it would do can be seen here.
    fn options(&self, sweep: &Sweep) -> RunOptions {
        RunOptions {
            allow_unstable: self.options.allow_unstable || !sweep.design.varies_string(),
            ..self.options
        }
    }

    /// Refuses what would take more memory than is allowed.
    fn admit(&self, chosen: &ChosenCases) -> Result<(), FollowError> {
        let Some((limit, shapes)) = self.memory else {
            return Ok(());
        };
        let longest = chosen.cases.iter().map(|chosen| chosen.longest);
        let survey = Survey {
            longest: longest.fold(0.0, f64::max),
            ..Survey::default()
        };
        let purpose = Purpose::Histories {
            cases: chosen.cases.len(),
            shapes,
        };
        let sweep = &chosen.sweep;
        let admitted = admit(sweep, &sweep.setting, &survey, purpose, limit);
        admitted.map(drop).map_err(FollowError::Memory)
    }
}

/// What became of cases that were followed.
pub struct Followed {
    /// The sweep with the string of these cases, at the sites that were found.
    pub sweep: Sweep,
    /// The cases.
    pub cases: Vec<Case>,
    /// The row of each case and method as a run has it.
    pub rows: Vec<Record>,
    /// The motion of each that has an answer.
    pub simulations: Vec<Simulation>,
}

/// Why cases are not followed.
#[derive(Debug, Error)]
pub enum FollowError {
    /// It would take too much memory.
    #[error("{0:#}")]
    Memory(anyhow::Error),
    /// A method cannot treat the string that all cases of the sweep share: a run would not begin.
    #[error("{0:#}")]
    Systems(anyhow::Error),
    /// Cases or methods have not all the same sites, where these are found.
    #[error(
        "`sites = \"auto\"` finds other sites for other cases and methods, which cannot be drawn \
         together"
    )]
    DifferentSites,
    /// No wall can be at a site that was found.
    #[error(transparent)]
    Sites(#[from] SweepFileError),
    /// A case makes no sense at the sites that were found.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// A case has no answer after all, or a method does not have one at a place that is only
    /// observed.
    #[error("{0:#}")]
    Motion(anyhow::Error),
}

/// Linear systems that are kept from one case to the next that asks for the same.
#[derive(Default)]
pub struct KeptSystems {
    /// Whether those will do that were built for a longer time than a case asks for.
    pub accepts_longer: bool,
    last: Option<Built>,
}

/// The systems of a string.
struct Built {
    /// What tells the string from others of its sweep.
    changed: Vec<(Axis, f64)>,
    methods: Vec<usize>,
    /// For how long they were built, s.
    longest: f64,
    systems: Vec<Result<FollowedMethod, Failure>>,
}

impl KeptSystems {
    /// The systems of the chosen string for a time (s), by method, or why a method has none.
    ///
    /// # Errors
    /// Where all cases of the sweep share the string, and a method cannot treat it.
    pub fn built_for(
        &mut self,
        chosen: &ChosenCases,
        longest: f64,
        how: &Following,
    ) -> Result<&[Result<FollowedMethod, Failure>], FollowError> {
        let sweep = &chosen.sweep;
        let will_do = |built: &Built| {
            let lasts = built.longest == longest || self.accepts_longer && built.longest > longest;
            lasts && built.changed == sweep.setting.changed && built.methods == chosen.methods
        };
        let built = match self.last.take() {
            Some(built) if will_do(&built) => built,
            last => {
                let earlier = last.as_ref().map_or(&[][..], |built| &built.systems);
                let systems = build(chosen, longest, how, earlier)?;
                let followed = systems.into_iter().map(|system| match system {
                    Ok(system) => FollowedMethod::new(sweep, system, longest).map(Ok),
                    Err(reason) => Ok(Err(reason)),
                });
                Built {
                    changed: sweep.setting.changed.clone(),
                    methods: chosen.methods.clone(),
                    longest,
                    systems: followed
                        .collect::<Result<_>>()
                        .map_err(FollowError::Motion)?,
                }
            }
        };
        Ok(&self.last.insert(built).systems)
    }
}

/// Builds the systems that a run has of the string; what it has in common with that of `earlier`
/// ones is not built again.
fn build(
    chosen: &ChosenCases,
    longest: f64,
    how: &Following,
    earlier: &[Result<FollowedMethod, Failure>],
) -> Result<Vec<Result<MethodSystem, Failure>>, FollowError> {
    let sweep = &chosen.sweep;
    let setting = sweep.setting.for_labels();
    let systems = linear::parallel::map(chosen.methods.len(), 1, |place| {
        let method = sweep.methods[chosen.methods[place]];
        let earlier = earlier.get(place).and_then(|earlier| earlier.as_ref().ok());
        let earlier = earlier.map(FollowedMethod::system);
        let recipe = Recipe::of(sweep, &setting, method, longest);
        recipe.after(earlier).build()
    });
    let systems = systems.into_iter().map(|system| match system {
        Err(reason) if sweep.design.varies_string() => {
            Ok(Err(Failure::new(format_args!("{reason:#}"))))
        }
        system => system.map(Ok),
    });
    let systems = systems.collect::<Result<Vec<_>>>();
    let systems = systems.map_err(FollowError::Systems)?;
    if how.options(sweep).allow_unstable {
        let instabilities = systems
            .iter()
            .flatten()
            .filter_map(MethodSystem::instability);
        instabilities.for_each(|instability| (how.warn)(&instability));
    }
    Ok(systems)
}

/// The row of every case and method of a sweep whose sites are found.
fn find_sites(
    chosen: &ChosenCases,
    how: &Following,
    kept: &mut KeptSystems,
) -> Result<Vec<Record>, FollowError> {
    let (sweep, options) = (&chosen.sweep, how.options(&chosen.sweep));
    let mut rows = Vec::new();
    for ChosenCase { case, longest } in &chosen.cases {
        let systems = kept.built_for(chosen, *longest, how)?;
        for (system, &method) in systems.iter().zip(&chosen.methods) {
            rows.push(match system {
                Ok(system) => answer(system.system(), case, method, options, sweep),
                Err(reason) => without_system(case, method, reason),
            });
        }
    }
    Ok(rows)
}

fn to_the_end(
    chosen: ChosenCases,
    how: &Following,
    kept: &mut KeptSystems,
) -> Result<Followed, FollowError> {
    let (sweep, options) = (&chosen.sweep, how.options(&chosen.sweep));
    let is_alone = chosen.cases.len() == 1;
    let (mut rows, mut simulations) = (Vec::new(), Vec::new());
    for ChosenCase { case, longest } in &chosen.cases {
        let systems = kept.built_for(&chosen, *longest, how)?;
        for (system, &method) in systems.iter().zip(&chosen.methods) {
            match system {
                Ok(system) => {
                    let followed = system.simulate(sweep, case, method, options, is_alone);
                    let (row, simulation) = followed.map_err(FollowError::Motion)?;
                    rows.push(row);
                    simulations.extend(simulation);
                }
                Err(reason) => rows.push(without_system(case, method, reason)),
            }
        }
    }
    Ok(Followed {
        cases: chosen.cases.into_iter().map(|chosen| chosen.case).collect(),
        sweep: chosen.sweep,
        rows,
        simulations,
    })
}

fn without_system(case: &Case, method: usize, reason: &Failure) -> Record {
    Record::failed(case.index, method, case.values.clone(), reason.clone())
}
