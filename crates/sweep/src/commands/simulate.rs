//! `sweep simulate`: a case in full (Figs. 7, 8, 10–13, 15 and 16), or a few
//! beside each other.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Result, bail};
use linear::elements::reconstruction::reconstruct;
use linear::estimates::stick_slip_times;
use linear::{BendingRequest, Sites};
use sim::{BitTorque, Outcome, Stopping, Trajectory};

use super::plot::{axis, save_picture};
use super::{
    Status, UsageError, build_systems, make_folder, read_sweep, results_folder, say, site_title,
    use_threads, warn_of_unstable,
};
use crate::cli::SimulateArguments;
use crate::engine::Case;
use crate::output::write_atomically;
use crate::plot::{Orbit, Orbits, Panel, Panels, Reference, Series, orbits, panels};
use crate::spec::{Axis, Conditions, LateralSettings, Setting, Sweep, check_setting, to_rpm};

/// The clearance is drawn where motion reaches this part of it.
const CLEARANCE_SHOWN: f64 = 0.2;

/// One method's answer to one case.
struct Simulation {
    case: usize,
    method: &'static str,
    /// What it is called in pictures.
    name: String,
    trajectory: Trajectory,
    outcome: Outcome,
}

/// Simulates the chosen cases with every method and keeps their time histories.
pub fn simulate(arguments: &SimulateArguments) -> Result<Status> {
    use_threads(arguments.work.jobs)?;
    let mut sweep = read_sweep(&arguments.file, &arguments.work)?;
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

fn has_torque(simulations: &[Simulation]) -> bool {
    simulations
        .iter()
        .any(|simulation| !simulation.trajectory.bit_torque.is_empty())
}

fn has_positions(simulations: &[Simulation]) -> bool {
    simulations
        .iter()
        .any(|simulation| !simulation.trajectory.positions.is_empty())
}

/// The way of every site's centre, with the circle of its clearance.
fn site_orbits(sweep: &Sweep, simulations: &[Simulation]) -> Orbits {
    let distances = sweep.setting.sites.distances_from_bit().iter().enumerate();
    let walls = sweep
        .setting
        .lateral
        .iter()
        .flat_map(|lateral| &lateral.walls);
    let orbits = distances.zip(walls).map(|((site, &distance), wall)| Orbit {
        x: axis(&format!("x at {} (mm)", site_title(distance))),
        y: axis("y (mm)"),
        series: simulations
            .iter()
            .map(|simulation| Series {
                name: simulation.name.clone(),
                points: simulation.trajectory.positions[site]
                    .iter()
                    .map(|[x, y]| (1e3 * x, 1e3 * y))
                    .collect(),
            })
            .collect(),
        circle: 1e3 * wall.clearance,
    });
    Orbits {
        title: sweep.title.clone(),
        orbits: orbits.collect(),
    }
}

/// Fig. 13: the peak displacement of the whole string, reconstructed by finite
/// elements from the forces at its sites, whatever method gave them.
fn along_string(
    sweep: &Sweep,
    lateral: &LateralSettings,
    simulations: &[Simulation],
) -> Result<Panels> {
    let request = BendingRequest {
        sites: sweep.setting.sites.clone(),
        support: lateral.support,
        sampling_frequency: sweep.setting.sampling_frequency,
        longest_time: 0.0,
    };
    let series = simulations
        .iter()
        .map(|simulation| {
            let whole = reconstruct(
                &sweep.setting.string,
                &lateral.bending,
                &request,
                &sweep.content.method.finite_element,
                &simulation.trajectory.forces,
                &[],
            )?;
            let peaks = whole.peaks.iter().map(|peak| 1e3 * peak);
            Ok(Series {
                name: simulation.name.clone(),
                points: whole.depths.iter().copied().zip(peaks).collect(),
            })
        })
        .collect::<Result<Vec<_>>>()?;
    let clearance = lateral.walls.iter().map(|wall| wall.clearance);
    Ok(Panels {
        title: format!("{}: the whole string", sweep.title),
        panels: vec![Panel {
            x: axis("Depth ξ (m)"),
            y: axis("Peak radius (mm)"),
            series,
            references: vec![level(
                1e3 * clearance.fold(f64::INFINITY, f64::min),
                "least clearance",
            )],
        }],
    })
}

/// With lateral motion, the radius of every site (Figs. 10 to 16); else its
/// speed, torque on the bit, and, as in the paper, the difference between the
/// first two methods beneath.
fn history_panels(sweep: &Sweep, cases: &[Case], simulations: &[Simulation], step: f64) -> Panels {
    let series = |name: &str, values: &dyn Fn(usize) -> f64, count: usize| Series {
        name: name.to_owned(),
        points: (0..count)
            .map(|index| (index as f64 * step, values(index)))
            .collect(),
    };
    let of_each = |values: &dyn Fn(&Trajectory, usize) -> f64| -> Vec<Series> {
        simulations
            .iter()
            .map(|simulation| {
                let trajectory = &simulation.trajectory;
                let count = trajectory.speeds[0].len();
                series(&simulation.name, &|index| values(trajectory, index), count)
            })
            .collect()
    };
    let panel = |label: &str, series, references| Panel {
        x: axis("Time t (s)"),
        y: axis(label),
        series,
        references,
    };
    let mut list: Vec<Panel> = Vec::new();
    if let Some(lateral) = &sweep.setting.lateral {
        let sites = sweep
            .setting
            .sites
            .distances_from_bit()
            .iter()
            .zip(&lateral.walls);
        for (site, (&distance, wall)) in sites.enumerate() {
            let radii = of_each(&|trajectory, index| {
                let [x, y] = trajectory.positions[site][index];
                1e3 * x.hypot(y)
            });
            let clearance = 1e3 * wall.clearance;
            let points = radii.iter().flat_map(|series| &series.points);
            let furthest = points.fold(0.0, |most: f64, point| most.max(point.1));
            // Motion far from the wall would not be seen beside it.
            let shows_wall = furthest > CLEARANCE_SHOWN * clearance;
            list.push(panel(
                &format!("Radius at {} (mm)", site_title(distance)),
                radii,
                shows_wall
                    .then(|| level(clearance, "clearance"))
                    .into_iter()
                    .collect(),
            ));
        }
        return Panels {
            title: sweep.title.clone(),
            panels: list,
        };
    }
    for (site, &distance) in sweep
        .setting
        .sites
        .distances_from_bit()
        .iter()
        .enumerate()
        .rev()
    {
        let label = if distance == 0.0 {
            "Bit speed (rpm)".to_owned()
        } else {
            format!("Speed {distance} m above the bit (rpm)")
        };
        list.push(panel(
            &label,
            of_each(&|trajectory, index| to_rpm(trajectory.speeds[site][index])),
            levels(cases, "Ω", |case| Some(to_rpm(case.scene.surface_speed))),
        ));
    }
    if let Some(bit_speed) = list.first_mut() {
        let first_slips = cases.iter().filter_map(|case| {
            let bit = case.scene.bit?;
            let speed = case.scene.surface_speed;
            let times = stick_slip_times(
                &sweep.setting.string,
                speed,
                bit.torque_static,
                bit.torque_dynamic,
            );
            Some(Reference::Vertical {
                x: times.first_slip,
                name: "τ₁".to_owned(),
            })
        });
        bit_speed.references.extend(first_slips);
    }
    if has_torque(simulations) {
        let limit = |of: fn(BitTorque) -> f64| move |case: &Case| Some(1e-3 * of(case.scene.bit?));
        let mut limits = levels(cases, "Tₛ", limit(|bit| bit.torque_static));
        limits.extend(levels(cases, "T_d", limit(|bit| bit.torque_dynamic)));
        list.push(panel(
            "Torque on bit (kN m)",
            of_each(&|trajectory, index| -1e-3 * trajectory.bit_torque[index]),
            limits,
        ));
    }
    if let ([_], [first, second, ..]) = (cases, simulations) {
        let bit = sweep.setting.sites.len() - 1;
        let (one, other) = (
            &first.trajectory.speeds[bit],
            &second.trajectory.speeds[bit],
        );
        let name = format!("{} − {}", first.name, second.name);
        let difference = series(&name, &|index| to_rpm(one[index] - other[index]), one.len());
        list.push(panel(
            "Difference in bit speed (rpm)",
            vec![difference],
            Vec::new(),
        ));
    }
    Panels {
        title: sweep.title.clone(),
        panels: list,
    }
}

/// A level of every case, each value once.
fn levels(cases: &[Case], name: &str, of: impl Fn(&Case) -> Option<f64>) -> Vec<Reference> {
    let mut values: Vec<f64> = cases.iter().filter_map(of).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values.into_iter().map(|value| level(value, name)).collect()
}

fn level(y: f64, name: &str) -> Reference {
    Reference::Horizontal {
        y,
        name: name.to_owned(),
    }
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
