//! `sweep simulate`: a case in full (Figs. 7, 8, 10–13, 15 and 16), or a few
//! beside each other.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Result, bail};
use linear::Sites;
use sim::{Outcome, Stopping, Trajectory};

use super::motion::{along_string, history_panels, site_orbits};
use super::plot::save_picture;
use super::{
    Status, UsageError, build_systems, make_folder, read_sweep, results_folder, say, site_title,
    use_threads, warn_of_unstable,
};
use crate::cli::SimulateArguments;
use crate::engine::Case;
use crate::output::write_atomically;
use crate::plot::{orbits, panels};
use crate::spec::{Axis, Conditions, Setting, Sweep, check_setting, to_rpm};

/// One method's answer to one case.
pub struct Simulation {
    case: usize,
    method: &'static str,
    /// What it is called in pictures.
    pub name: String,
    /// Its time history.
    pub trajectory: Trajectory,
    outcome: Outcome,
}

/// Simulates the chosen cases with every method and keeps their time histories.
pub fn simulate(arguments: &SimulateArguments) -> Result<Status> {
    use_threads(arguments.work.jobs)?;
    let mut sweep = read_sweep(&arguments.file, &arguments.work, false, false)?;
    let choices = (unique(&arguments.case).into_iter())
        .map(|index| Choice::new(&sweep, arguments, index))
        .collect::<Result<Vec<_>>>()?;
    sweep.setting = common_setting(&sweep, &choices)?;
    let cases = (choices.into_iter())
        .map(|choice| choice.case(&sweep))
        .collect::<Result<Vec<_>>>()?;
    let folder = results_folder(arguments.out.as_ref(), &sweep);
    let durations = cases.iter().map(|case| case.scene.timing.duration);
    let longest = durations.fold(0.0, f64::max);
    let systems = build_systems(&arguments.file, &sweep, &sweep.setting, longest)?;
    make_folder(&folder)?;
    warn_of_unstable(&systems);
    let pairs = cases
        .iter()
        .flat_map(|case| systems.iter().map(move |system| (case, system)));
    let simulations = pairs
        .map(|(case, system)| {
            let mut trajectory = Trajectory::default();
            let outcome = system.simulate(case, Stopping::Full, Some(&mut trajectory))?;
            Ok(Simulation {
                case: case.index,
                method: system.method.name(),
                name: name(&sweep, case, system.method.name(), cases.len()),
                trajectory,
                outcome,
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let step = 1.0 / sweep.setting.sampling_frequency;
    write_atomically(
        &folder.join("history.csv"),
        &history_csv(&simulations, &sweep.setting.sites, step)?,
    )?;
    let picture = panels(&history_panels(&sweep, &cases, &simulations, step))?;
    save_picture(&folder, "history", &picture)?;
    if let Some(lateral) = &sweep.setting.lateral {
        let orbits = orbits(&site_orbits(&sweep, &simulations))?;
        save_picture(&folder, "orbit", &orbits)?;
        let along = along_string(&sweep, lateral, &simulations)?;
        save_picture(&folder, "string", &panels(&along)?)?;
    }
    say(&summary(&sweep, &cases, &simulations, &folder)?)?;
    Ok(Status::Complete)
}

/// The method, and what sets the case apart where there are several.
fn name(sweep: &Sweep, case: &Case, method: &str, cases: usize) -> String {
    if cases == 1 {
        return method.to_owned();
    }
    let axes = sweep.design.axes().iter().zip(&case.values);
    let values = axes.map(|(axis, value)| format!("{} = {}", axis.symbol(), shortened(*value)));
    format!("{}, {method}", values.collect::<Vec<_>>().join(", "))
}

/// A number in four digits.
fn shortened(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
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

/// A case with what the command line changes of it.
struct Choice {
    index: usize,
    values: Vec<f64>,
    conditions: Conditions,
    /// Quantities of the string, by axes and by `--set`.
    string: Vec<(Axis, f64)>,
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
            if matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm) && sweep.bit.is_none() {
                bail!(UsageError(format!(
                    "--set {}: the bit is free in this sweep",
                    axis.name()
                )));
            }
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
        let string = all.filter(|(axis, _)| matches!(axis, Axis::String(_)));
        Ok(Self {
            index,
            string: string.collect(),
            values,
            conditions,
        })
    }

    fn case(self, sweep: &Sweep) -> Result<Case> {
        Case::under(
            sweep,
            &sweep.setting,
            self.index,
            self.values,
            &self.conditions,
        )
        .map_err(|reason| UsageError(reason).into())
    }
}

/// The string of all chosen cases, which are drawn in one picture.
fn common_setting(sweep: &Sweep, choices: &[Choice]) -> Result<Setting> {
    let string = choices.first().map_or(&[][..], |choice| &choice.string);
    if choices.iter().any(|choice| choice.string != string) {
        bail!(UsageError(
            "--case: cases of different strings cannot be drawn beside each other".to_owned()
        ));
    }
    Ok(sweep.setting_with(string.iter().copied())?.into_owned())
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

fn site_name(distance: f64) -> String {
    if distance == 0.0 {
        "bit".to_owned()
    } else {
        format!("{distance}m_above_bit")
    }
}

/// `history.csv`: a row a step, method and case. The torque on bit is counted
/// positive against the rotation, as drillers do.
fn history_csv(simulations: &[Simulation], sites: &Sites, step: f64) -> Result<Vec<u8>> {
    let with_torque = has_torque(simulations);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = ["case", "method", "time_s"].map(str::to_owned).to_vec();
    let distances = sites.distances_from_bit().iter();
    header.extend(distances.map(|&distance| format!("{}_speed_rpm", site_name(distance))));
    header.extend(with_torque.then(|| "torque_on_bit_nm".to_owned()));
    let with_positions = has_positions(simulations);
    if with_positions {
        for &distance in sites.distances_from_bit() {
            let site = site_name(distance);
            let columns = ["x_mm", "y_mm", "wall_force_x_n", "wall_force_y_n"];
            header.extend(columns.map(|column| format!("{site}_{column}")));
        }
    }
    writer.write_record(&header)?;
    for simulation in simulations {
        let trajectory = &simulation.trajectory;
        for index in 0..trajectory.speeds[0].len() {
            let mut fields = vec![
                simulation.case.to_string(),
                simulation.method.to_owned(),
                (index as f64 * step).to_string(),
            ];
            let speeds = trajectory.speeds.iter();
            fields.extend(speeds.map(|speeds| to_rpm(speeds[index]).to_string()));
            if with_torque {
                fields.push((-trajectory.bit_torque[index]).to_string());
            }
            if with_positions {
                for (positions, forces) in trajectory.positions.iter().zip(&trajectory.wall_forces)
                {
                    fields.extend(positions[index].map(|value| (1e3 * value).to_string()));
                    fields.extend(forces[index].map(|value| value.to_string()));
                }
            }
            writer.write_record(&fields)?;
        }
    }
    Ok(writer.into_inner()?)
}

/// Whether there is a torque at the bit.
pub fn has_torque(simulations: &[Simulation]) -> bool {
    simulations
        .iter()
        .any(|simulation| !simulation.trajectory.bit_torque.is_empty())
}

fn has_positions(simulations: &[Simulation]) -> bool {
    simulations
        .iter()
        .any(|simulation| !simulation.trajectory.positions.is_empty())
}

fn summary(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    folder: &Path,
) -> Result<String> {
    let mut text = String::new();
    for case in cases {
        let rpm = to_rpm(case.scene.surface_speed);
        let torque = case
            .torque_dynamic_nm
            .map_or_else(String::new, |torque| format!(", T_d = {torque:.1} N m"));
        writeln!(text, "Ω = {rpm:.4} rpm{torque}")?;
        let own = simulations
            .iter()
            .filter(|simulation| simulation.case == case.index);
        for simulation in own {
            write_outcome(&mut text, sweep, simulation)?;
        }
    }
    writeln!(
        text,
        "history.svg, history.png and history.csv are in {}",
        folder.display()
    )?;
    Ok(text)
}

/// What came out, in bending and in torsion.
fn write_outcome(
    text: &mut String,
    sweep: &Sweep,
    simulation: &Simulation,
) -> Result<(), std::fmt::Error> {
    if let Some(lateral) = simulation.outcome.lateral {
        let distance = sweep.setting.sites.distances_from_bit()[lateral.site];
        writeln!(
            text,
            "  {}: {}, at {} in contact {:.0} % of the closing window, r = {:.2} mm, \
             {:.2} turns/s, F_N = {:.2} kN",
            simulation.name,
            lateral.regime.name(),
            site_title(distance),
            100.0 * lateral.contact_fraction,
            1e3 * lateral.mean_radius,
            lateral.precession_rate / std::f64::consts::TAU,
            1e-3 * lateral.mean_normal_force,
        )?;
    }
    if let Some(torsion) = simulation.outcome.torsion {
        let seconds = |value: Option<f64>| {
            value.map_or_else(|| "–".to_owned(), |value| format!("{value:.3} s"))
        };
        writeln!(
            text,
            "  {}: {}, first slip {}, period {}, slipping {}, {} sticks, peak {:.4} rpm",
            simulation.name,
            torsion.regime.name(),
            seconds(torsion.first_slip),
            seconds(torsion.period),
            seconds(torsion.slip_time),
            torsion.sticks,
            to_rpm(torsion.peak_speed),
        )?;
    } else if simulation.outcome.lateral.is_none() {
        writeln!(text, "  {}: the bit is free", simulation.name)?;
    }
    Ok(())
}
