//! The tables of simulated cases: their motion step by step, and the rows of a run.

use anyhow::Result;

use super::simulation::{Simulation, has_surface_speed, has_surface_torque, has_torque};
use crate::engine::Record;
use crate::output::{Certainty, LabelTable};
use crate::plan::{Sweep, to_rpm};

fn site_name(distance: f64) -> String {
    if distance == 0.0 {
        "bit".to_owned()
    } else {
        format!("{distance}m_above_bit")
    }
}

/// `history.csv`: a row a step, method and case. The torque on bit is counted
/// positive against the rotation, as drillers do.
pub fn history_csv(sweep: &Sweep, simulations: &[Simulation]) -> Result<Vec<u8>> {
    let sites = &sweep.setting.sites;
    let with_torque = has_torque(simulations);
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut header = ["case", "method", "time_s"].map(str::to_owned).to_vec();
    let distances = sites.distances_from_bit().iter();
    header.extend(distances.map(|&distance| format!("{}_speed_rpm", site_name(distance))));
    header.extend(with_torque.then(|| "torque_on_bit_nm".to_owned()));
    let at_surface = has_surface_torque(simulations);
    header.extend(at_surface.then(|| "motor_torque_nm".to_owned()));
    let with_surface_speed = has_surface_speed(simulations);
    header.extend(with_surface_speed.then(|| "surface_speed_rpm".to_owned()));
    let mut motions = simulations.iter().map(|simulation| &simulation.trajectory);
    let with_positions = motions.any(|motion| !motion.positions.is_empty());
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
        for (index, time) in trajectory.times.iter().enumerate() {
            let mut fields = vec![
                simulation.case.to_string(),
                simulation.method.to_owned(),
                time.to_string(),
            ];
            let speeds = trajectory.speeds.iter();
            fields.extend(speeds.map(|speeds| to_rpm(speeds[index]).to_string()));
            if with_torque {
                fields.push((-trajectory.bit_torque[index]).to_string());
            }
            if at_surface {
                fields.push(trajectory.surface_torque[index].to_string());
            }
            if with_surface_speed {
                fields.push(to_rpm(trajectory.surface_speed[index]).to_string());
            }
            if with_positions {
                let forces = &trajectory.wall_forces;
                for (positions, forces) in trajectory.positions.iter().zip(forces) {
                    fields.extend(positions[index].map(|value| (1e3 * value).to_string()));
                    fields.extend(forces[index].map(|value| value.to_string()));
                }
            }
            writer.write_record(&fields)?;
        }
    }
    Ok(writer.into_inner()?)
}

/// `case.csv`: the rows that `labels.csv` has of these cases.
pub fn case_csv(sweep: &Sweep, rows: &[Record]) -> String {
    let table = LabelTable::of(sweep);
    let rows = rows.iter().map(|row| table.row(row, Certainty::default()));
    let lines = std::iter::once(table.header()).chain(rows);
    lines.map(|line| line + "\n").collect()
}
