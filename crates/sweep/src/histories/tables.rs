//! The tables of simulated cases: their motion step by step, and the rows of a run.

use std::ops::Range;

use anyhow::Result;
use sim::laws::contact::Touch;

use campaign::engine::Simulation;
use campaign::labels::LabelTable;
use campaign::labels::{HistoryColumn, history_columns};
use campaign::plan::Sweep;
use campaign::records::Certainty;
use campaign::records::Record;

/// `history.csv`: a row a step, method and case; of the torque and speed at the surface what is
/// known of all.
///
/// # Errors
/// None that a simulation could cause.
pub fn history_csv(sweep: &Sweep, simulations: &[Simulation]) -> Result<Vec<u8>> {
    let columns_of =
        |simulation: &Simulation| history_columns(&sweep.setting.sites, &simulation.trajectory);
    let tables: Vec<Vec<HistoryColumn>> = simulations.iter().map(columns_of).collect();
    let first = tables.first().into_iter().flatten();
    let has =
        |table: &Vec<HistoryColumn>, name: &str| table.iter().any(|column| column.name == name);
    let shared: Vec<&str> = (first.map(|column| column.name.as_str()))
        .filter(|name| tables.iter().all(|table| has(table, name)))
        .collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["case", "method"].iter().chain(&shared))?;
    for (simulation, table) in simulations.iter().zip(&tables) {
        let case = simulation.case.to_string();
        let columns = table
            .iter()
            .filter(|column| shared.contains(&column.name.as_str()));
        let columns: Vec<&HistoryColumn> = columns.collect();
        for step in 0..simulation.trajectory.times.len() {
            writer.write_field(&case)?;
            writer.write_field(simulation.method)?;
            for column in &columns {
                writer.write_field(column.values[step].to_string())?;
            }
            writer.write_record(None::<&[u8]>)?;
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
