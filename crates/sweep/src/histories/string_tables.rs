//! The tables of the whole string: how far it goes to the side, and its shapes in a film.

use anyhow::Result;
use linear::elements::reconstruction::Reconstruction;

use campaign::engine::Simulation;
use campaign::engine::{Case, Clearances};
use campaign::plan::Sweep;

/// `string.csv`: a row for each node of the string, method and case, with the peak of its radius
/// and the clearance there, empty where there is none; `string.svg` shows both.
pub fn string_csv(
    sweep: &Sweep,
    cases: &[Case],
    simulations: &[Simulation],
    wholes: &[Reconstruction],
) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "case",
        "method",
        "depth_m",
        "peak_radius_mm",
        "clearance_mm",
    ])?;
    for (simulation, whole) in simulations.iter().zip(wholes) {
        let case = cases.iter().find(|case| case.index == simulation.case);
        let clearances = case.and_then(|case| Clearances::of(&sweep.setting, case));
        for (depth, peak) in whole.depths.iter().zip(&whole.peaks) {
            let clearance = clearances.as_ref().and_then(|all| all.at(*depth));
            writer.write_record([
                simulation.case.to_string(),
                simulation.method.to_owned(),
                depth.to_string(),
                (1e3 * peak).to_string(),
                clearance.map_or_else(String::new, |clearance| (1e3 * clearance).to_string()),
            ])?;
        }
    }
    Ok(writer.into_inner()?)
}

/// `film.csv`: a row for each node of the string in each frame of a film.
pub fn film_csv(
    simulation: &Simulation,
    whole: &Reconstruction,
    steps: &[usize],
) -> Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["case", "method", "time_s", "depth_m", "x_mm", "y_mm"])?;
    for (&step, [x, y]) in steps.iter().zip(&whole.shapes) {
        let time = simulation.trajectory.times[step].to_string();
        for ((depth, x), y) in whole.depths.iter().zip(x).zip(y) {
            writer.write_record([
                simulation.case.to_string(),
                simulation.method.to_owned(),
                time.clone(),
                depth.to_string(),
                (1e3 * x).to_string(),
                (1e3 * y).to_string(),
            ])?;
        }
    }
    Ok(writer.into_inner()?)
}
