//! The tables of simulated cases: their motion step by step, and the rows of a run.

use std::ops::Range;

use anyhow::Result;
use sim::laws::contact::Touch;

use super::known::{has_surface_speed, has_surface_torque, has_torque};
use crate::output::{Certainty, LabelTable};
use campaign::engine::Record;
use campaign::engine::Simulation;
use campaign::plan::{Sweep, to_rpm};

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

/// `contacts.csv`: a row for each time that a site touches the wall, from the first step of it
/// to the last, with the part of these steps in which it rolls.
pub fn contacts_csv(sweep: &Sweep, simulations: &[Simulation]) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "case",
        "method",
        "site_from_bit_m",
        "from_s",
        "to_s",
        "rolling_fraction",
        "mean_normal_force_n",
        "largest_normal_force_n",
    ])?;
    for simulation in simulations {
        let motion = &simulation.trajectory;
        let distances = sweep.setting.sites.distances_from_bit().iter();
        let sites = motion.touches.iter().zip(&motion.normal_forces);
        for (distance, (touches, forces)) in distances.zip(sites) {
            for contact in contacts(touches) {
                let count = contact.len() as f64;
                let own = touches[contact.clone()].iter();
                let rolling = own.filter(|touch| **touch == Touch::Rolling).count();
                let forces = &forces[contact.clone()];
                writer.write_record([
                    simulation.case.to_string(),
                    simulation.method.to_owned(),
                    distance.to_string(),
                    motion.times[contact.start].to_string(),
                    motion.times[contact.end - 1].to_string(),
                    (rolling as f64 / count).to_string(),
                    (forces.iter().sum::<f64>() / count).to_string(),
                    forces.iter().copied().fold(0.0, f64::max).to_string(),
                ])?;
            }
        }
    }
    Ok(writer.into_inner()?)
}

/// Runs of steps in which a site touches the wall.
fn contacts(touches: &[Touch]) -> Vec<Range<usize>> {
    let mut end = 0;
    let runs = touches.chunk_by(|one, other| (*one == Touch::Free) == (*other == Touch::Free));
    let placed = runs.map(|run| {
        let start = end;
        end += run.len();
        (run[0], start..end)
    });
    let touching = placed.filter(|(touch, _)| *touch != Touch::Free);
    touching.map(|(_, steps)| steps).collect()
}

/// `case.csv`: the rows that `labels.csv` has of these cases.
pub fn case_csv(sweep: &Sweep, rows: &[Record]) -> String {
    let table = LabelTable::of(sweep);
    let rows = rows.iter().map(|row| table.row(row, Certainty::default()));
    let lines = std::iter::once(table.header()).chain(rows);
    lines.map(|line| line + "\n").collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_contact_lasts_from_its_first_step_to_its_last() {
        use Touch::{Free, Rolling, Sliding};
        let touches = [
            Sliding, Free, Free, Rolling, Sliding, Rolling, Free, Rolling,
        ];
        assert_eq!(contacts(&touches), [0..1, 3..6, 7..8]);
        assert!(contacts(&[Free; 3]).is_empty() && contacts(&[]).is_empty());
    }
}
