//! `history.csv`: the motion of simulated cases, step by step.

use anyhow::Result;
use linear::Sites;

use super::simulate::Simulation;
use crate::plan::to_rpm;

fn site_name(distance: f64) -> String {
    if distance == 0.0 {
        "bit".to_owned()
    } else {
        format!("{distance}m_above_bit")
    }
}

/// `history.csv`: a row a step, method and case. The torque on bit is counted
/// positive against the rotation, as drillers do.
pub fn history_csv(simulations: &[Simulation], sites: &Sites, step: f64) -> Result<Vec<u8>> {
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
