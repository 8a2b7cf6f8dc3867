//! `sweep simulate`: a case in full (Figs. 7, 8, 10–13, 15 and 16), or a few
//! beside each other. A case of the sweep is the case that `run` runs: the same
//! linear systems, built for as long, and the same row; its history is followed to the
//! end of its time.

use std::path::Path;

use anyhow::{Context, Result, bail};
use sim::{Outcome, Stopping, Trajectory};

use super::case_lines::case_lines;
use super::history::history_csv;
use super::motion::{along_string, history_panels, site_orbits};
use super::plot::save_picture;
use super::{
    Status, UsageError, build_systems, complain, make_folder, read_sweep, results_folder, say,
    use_threads, warn_of_string, warn_of_unstable,
};
use crate::cli::SimulateArguments;
use crate::engine::{Case, MethodSystem, Record, RunOptions, Survey, longest_beside};
use crate::memory::{Purpose, admit};
use crate::output::{LabelTable, write_atomically};
use crate::plot::{orbits, panels};
use crate::sweep_file::{Axis, Conditions, Setting, Sweep, check_setting};
use crate::words::short;

/// One method's answer to one case.
pub struct Simulation {
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: &'static str,
    /// What it is called in pictures.
    pub name: String,
    /// Its time history.
    pub trajectory: Trajectory,
    /// What a run answers.
    pub answer: Outcome,
    /// The site that decides the lateral label of that, m from the bit.
    pub site_from_bit_m: Option<f64>,
    /// What came out, followed to the end of the time.
    pub followed: Outcome,
}

/// Simulates the chosen cases with every method and keeps their time histories.
pub fn simulate(arguments: &SimulateArguments) -> Result<Status> {
    use_threads(arguments.work.jobs)?;
    let mut sweep = read_sweep(&arguments.file, &arguments.work, arguments.full, false)?;
    warn_of_string(&sweep);
    let choices = (unique(&arguments.case).into_iter())
        .map(|index| Choice::new(&sweep, arguments, index))
        .collect::<Result<Vec<_>>>()?;
    sweep.setting = match common_setting(&sweep, &choices)? {
        Ok(setting) => setting,
        Err(reason) => {
            return tell_of_failures(&sweep, &failed_rows(&sweep, &choices, &reason));
        }
    };
    let cases = (choices.into_iter())
        .map(|choice| choice.case(&sweep, &arguments.file))
        .collect::<Result<Vec<_>>>()?;
    let longest = cases
        .iter()
        .map(|chosen| chosen.longest)
        .fold(0.0, f64::max);
    let survey = Survey {
        longest,
        ..Survey::default()
    };
    let purpose = Purpose::Histories(cases.len());
    let limit = arguments.work.memory.limit();
    admit(&sweep, &sweep.setting, &survey, purpose, &limit)?;
    let (rows, simulations) = simulate_all(&sweep, arguments, &cases)?;
    let cases: Vec<Case> = cases.into_iter().map(|chosen| chosen.case).collect();
    if !simulations.is_empty() {
        let folder = results_folder(arguments.out.as_ref(), &sweep);
        make_folder(&folder)?;
        write_files(&sweep, &cases, &rows, &simulations, &folder)?;
        say(&case_lines(&sweep, &cases, &simulations, &folder)?)?;
    }
    tell_of_failures(&sweep, &rows)
}

/// The row of every case and method, as a run has it, and the motion of each that has
/// an answer.
fn simulate_all(
    sweep: &Sweep,
    arguments: &SimulateArguments,
    cases: &[ChosenCase],
) -> Result<(Vec<Record>, Vec<Simulation>)> {
    let options = RunOptions {
        full: arguments.full,
        // Where all cases share a string, a run refuses the method before any row:
        // what it would do can be looked at here.
        allow_unstable: arguments.allow_unstable || !sweep.design.varies_string(),
    };
    let mut built: Vec<Systems> = Vec::new();
    let (mut rows, mut simulations) = (Vec::new(), Vec::new());
    for ChosenCase { case, longest } in cases {
        let known = built.iter().position(|systems| systems.longest == *longest);
        let place = match known {
            Some(place) => place,
            None => {
                built.push(Systems::build(&arguments.file, sweep, options, *longest)?);
                built.len() - 1
            }
        };
        for (place, system) in built[place].methods.iter().enumerate() {
            let row = match system {
                Ok(systems) => systems.case.answer(case, place, options),
                Err(reason) => {
                    let values = case.values.clone();
                    Record::failed(case.index, place, values, reason)
                }
            };
            if let (Ok(systems), Ok(answer)) = (system, &row.outcome) {
                let method = sweep.methods[place].name();
                let (trajectory, followed) = systems.follow(case)?;
                simulations.push(Simulation {
                    case: case.index,
                    method,
                    name: name(sweep, case, method, cases.len()),
                    trajectory,
                    answer: *answer,
                    site_from_bit_m: row.site_from_bit_m,
                    followed,
                });
            }
            rows.push(row);
        }
    }
    Ok((rows, simulations))
}

/// The linear systems of the chosen string, or why a method has none.
struct Systems {
    /// What they are built for, s.
    longest: f64,
    methods: Vec<Result<MethodSystems, String>>,
}

/// The linear systems of one method.
struct MethodSystems {
    /// What a run steps a case against.
    case: MethodSystem,
    /// The same with the places that are just looked at: they would change the mesh
    /// of finite elements, and so the case.
    watched: Option<MethodSystem>,
}

impl Systems {
    fn build(file: &Path, sweep: &Sweep, options: RunOptions, longest: f64) -> Result<Self> {
        let setting = sweep.setting.for_labels();
        let systems: Vec<Result<MethodSystem>> = if sweep.design.varies_string() {
            MethodSystem::build_each(sweep, &setting, longest)
        } else {
            // A run would not begin.
            let systems = build_systems(file, sweep, &setting, longest)?;
            systems.into_iter().map(Ok).collect()
        };
        if options.allow_unstable {
            warn_of_unstable(systems.iter().flatten());
        }
        let is_watched = sweep.setting.sites.len() > setting.sites.len();
        let watched = |method| {
            is_watched
                .then(|| MethodSystem::build(&sweep.setting, method, sweep.bit.is_some(), longest))
                .transpose()
        };
        let methods = systems
            .into_iter()
            .map(|system| match system {
                Ok(case) => Ok(Ok(MethodSystems {
                    watched: watched(case.method)?,
                    case,
                })),
                Err(error) => Ok(Err(format!("{error:#}"))),
            })
            .collect::<Result<_>>()?;
        Ok(Self { longest, methods })
    }
}

impl MethodSystems {
    /// The motion of a case to the end of its time.
    fn follow(&self, case: &Case) -> Result<(Trajectory, Outcome)> {
        let mut motion = Trajectory::default();
        let simulated = self.case.simulate(case, Stopping::Full, Some(&mut motion));
        let outcome = simulated.with_context(|| {
            let method = self.case.method.name();
            format!("case {} by {method}, followed to its end", case.index)
        })?;
        if let Some(watched) = &self.watched
            && let Some(mut speeds) = watched.driven_speeds(case, &motion)
        {
            // The bit, which is the last, has been simulated.
            speeds.pop();
            speeds.append(&mut motion.speeds);
            motion.speeds = speeds;
        }
        Ok((motion, outcome))
    }
}

/// `history.csv`, `case.csv` and the pictures.
fn write_files(
    sweep: &Sweep,
    cases: &[Case],
    rows: &[Record],
    simulations: &[Simulation],
    folder: &Path,
) -> Result<()> {
    let step = 1.0 / sweep.setting.sampling_frequency;
    let history = history_csv(simulations, &sweep.setting.sites, step)?;
    write_atomically(&folder.join("history.csv"), &history)?;
    write_atomically(&folder.join("case.csv"), case_csv(sweep, rows).as_bytes())?;
    let picture = panels(&history_panels(sweep, cases, simulations, step))?;
    save_picture(folder, "history", &picture)?;
    if let Some(lateral) = &sweep.setting.lateral {
        let orbits = orbits(&site_orbits(sweep, simulations))?;
        save_picture(folder, "orbit", &orbits)?;
        let along = along_string(sweep, lateral, simulations)?;
        save_picture(folder, "string", &panels(&along)?)?;
    }
    Ok(())
}

/// `case.csv`: the rows that `labels.csv` has of these cases.
fn case_csv(sweep: &Sweep, rows: &[Record]) -> String {
    let table = LabelTable::of(sweep);
    let rows = rows.iter().map(|row| table.row(row));
    let lines = std::iter::once(table.header()).chain(rows);
    lines.map(|line| line + "\n").collect()
}

/// Rows of cases whose string cannot be.
fn failed_rows(sweep: &Sweep, choices: &[Choice], reason: &str) -> Vec<Record> {
    let of_choice = |choice: &Choice| -> Vec<Record> {
        let row = |method| Record::failed(choice.index, method, choice.values.clone(), reason);
        (0..sweep.methods.len()).map(row).collect()
    };
    choices.iter().flat_map(of_choice).collect()
}

/// Says which cases have no answer, and why.
fn tell_of_failures(sweep: &Sweep, rows: &[Record]) -> Result<Status> {
    let mut status = Status::Complete;
    for row in rows {
        if let Some(reason) = row.reason() {
            let (case, method) = (row.case, sweep.methods[row.method].name());
            complain(&format!(
                "error: case {case} by {method} has no answer: {reason}"
            ));
            status = Status::SomeFailed;
        }
    }
    Ok(status)
}

/// The method, and what sets the case apart where there are several.
fn name(sweep: &Sweep, case: &Case, method: &str, cases: usize) -> String {
    if cases == 1 {
        return method.to_owned();
    }
    let axes = sweep.design.axes().iter().zip(&case.values);
    let values = axes.map(|(axis, value)| format!("{} = {}", axis.symbol(), short(*value)));
    format!("{}, {method}", values.collect::<Vec<_>>().join(", "))
}

fn unique(indices: &[usize]) -> Vec<usize> {
    let mut unique: Vec<usize> = Vec::new();
    for &index in indices {
        if !unique.contains(&index) {
            unique.push(index);
        }
    }
    unique
}

/// A case, and for how long its linear systems are built, s.
struct ChosenCase {
    case: Case,
    longest: f64,
}

/// A case with what the command line changes of it.
struct Choice {
    index: usize,
    values: Vec<f64>,
    conditions: Conditions,
    /// Quantities of the string, by axes and by `--set`.
    string: Vec<(Axis, f64)>,
    /// Whether `--set` gives one of them: no run has this string.
    sets_string: bool,
}

impl Choice {
    fn new(sweep: &Sweep, arguments: &SimulateArguments, index: usize) -> Result<Self> {
        let cases = sweep.design.cases();
        if index >= cases {
            bail!(UsageError(format!(
                "--case {index}: {} has cases 0 to {}",
                arguments.file.display(),
                cases - 1
            )));
        }
        let mut values = sweep.design.values(index);
        let mut conditions = sweep.conditions_at(&values);
        let axes = sweep.design.axes();
        for &(axis, value) in &arguments.set {
            check_setting(axis, value)
                .map_err(|reason| UsageError(format!("--set {}: {reason}", axis.name())))?;
            refuse_idle(sweep, axis)?;
            conditions = conditions.with(axis, value);
            for (own, slot) in axes.iter().zip(&mut values) {
                if *own == axis {
                    *slot = value;
                }
            }
        }
        refuse_weight_without_rock(sweep, &conditions)?;
        let of_axes = axes.iter().copied().zip(values.iter().copied());
        let all = of_axes.chain(arguments.set.iter().copied());
        let is_of_string = |(axis, _): &(Axis, f64)| matches!(axis, Axis::String(_));
        Ok(Self {
            index,
            string: all.filter(is_of_string).collect(),
            sets_string: arguments.set.iter().any(is_of_string),
            values,
            conditions,
        })
    }

    fn case(self, sweep: &Sweep, file: &Path) -> Result<ChosenCase> {
        let beside = if self.sets_string {
            0.0
        } else {
            longest_beside(sweep, &sweep.setting, self.index)
                .map_err(|reason| UsageError(format!("{}: {reason}", file.display())))?
        };
        let case = Case::under(
            sweep,
            &sweep.setting,
            self.index,
            self.values,
            &self.conditions,
        )
        .map_err(UsageError)?;
        sweep.impulses_are_felt(case.index, case.scene.timing.duration)?;
        Ok(ChosenCase {
            longest: beside.max(case.scene.timing.duration),
            case,
        })
    }
}

/// Refuses to set what nothing in the sweep depends on.
fn refuse_idle(sweep: &Sweep, axis: Axis) -> Result<()> {
    let lateral = sweep.setting.lateral.as_ref();
    let has_ratio =
        lateral.is_some_and(|lateral| lateral.impulses.iter().any(|impulse| impulse.relative));
    let why = match axis {
        Axis::WeightOnBitKn | Axis::TorqueDynamicNm if sweep.bit.is_none() => {
            "the bit is free in this sweep"
        }
        Axis::Friction if lateral.is_none() => "there is no wall in this sweep",
        Axis::ImpulseRatio if !has_ratio => "no impulse of this sweep is in multiples of I₀",
        _ => return Ok(()),
    };
    bail!(UsageError(format!("--set {}: {why}", axis.name())))
}

/// The string of all chosen cases, which are drawn in one picture, or why they have
/// none.
fn common_setting(sweep: &Sweep, choices: &[Choice]) -> Result<Result<Setting, String>> {
    let string = choices.first().map_or(&[][..], |choice| &choice.string);
    if choices.iter().any(|choice| choice.string != string) {
        bail!(UsageError(
            "--case: cases of different strings cannot be drawn beside each other".to_owned()
        ));
    }
    match sweep.setting_with(string.iter().copied()) {
        Ok(setting) => Ok(Ok(setting.into_owned())),
        Err(error) if choices.iter().any(|choice| choice.sets_string) => Err(error.into()),
        Err(error) => Ok(Err(error.to_string())),
    }
}

fn refuse_weight_without_rock(sweep: &Sweep, conditions: &Conditions) -> Result<()> {
    let has_rock = sweep.bit.as_ref().is_some_and(|bit| bit.rock.is_some());
    if conditions.weight_on_bit_kn.is_some() && !has_rock {
        bail!(UsageError(
            "a weight on bit needs a rock to give a torque".to_owned()
        ));
    }
    Ok(())
}
