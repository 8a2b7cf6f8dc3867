//! `sweep inspect`: the linear system of a sweep, in words, numbers and a
//! picture (Fig. 6).

mod axial_force;
mod clearances;
mod description;
mod modes;
mod responses;
mod tables;
mod top_drive;

use std::time::Instant;

use anyhow::Result;

use super::cost::{cost_lines, of_built};
use super::drawing::{Drawing, panels_csv};
use super::folder::{make_folder, results_folder};
use super::prepare::{build_systems, open, survey_cases};
use super::status::Status;
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::{warn_of_fronts, warn_of_limits, warn_of_sweep};
use crate::cli::InspectArguments;
use axial_force::describe_axial_force;
use campaign::Campaign;
use campaign::engine::{add_finer, compare_fronts};
use campaign::memory::{Demand, Purpose, admit};
use clearances::describe_clearances;
use description::{
    describe_forward_contact, describe_left_out, describe_methods, describe_string, describe_well,
    describe_work,
};
use modes::{show_modes, write_modes};
use responses::{response_panels, response_picture};
use results::files::write_atomically;
use tables::write_tables;
use top_drive::DriveView;

/// Modes whose shapes are in the tables, where it is not said of how many.
const MODES_IN_TABLES: usize = 6;

/// Shows the linear system.
pub fn inspect(arguments: &InspectArguments, terminal: Terminal) -> Result<Status> {
    let drawing = Drawing::of(&arguments.picture)?;
    use_threads(arguments.work.jobs, terminal)?;
    let Campaign { sweep } = open(&arguments.file, &arguments.work, false, false, terminal)?;
    // With other methods than a run may have, what it costs is that of one without certificates.
    let campaign = Campaign {
        sweep: sweep.clone().for_run().unwrap_or(sweep),
    };
    let sweep = &campaign.sweep;
    warn_of_sweep(sweep, terminal);
    warn_of_limits(sweep, terminal);
    let folder = results_folder(arguments.out.as_ref(), sweep);
    let survey = survey_cases(&arguments.file, &campaign)?;
    // Those that a run builds.
    let setting = sweep.setting.for_labels();
    let limit = arguments.work.memory.limit();
    admit(sweep, &setting, &survey, Purpose::Look, &limit)?;
    let start = Instant::now();
    let systems = build_systems(&arguments.file, sweep, &setting, survey.longest)?;
    let mut systems = add_finer(systems, sweep, survey.longest)?;
    let built = start.elapsed().as_secs_f64();
    compare_fronts(&mut systems);
    warn_of_fronts(sweep, &systems, terminal);
    let memory = Demand::of(sweep, &setting, &survey, Purpose::Labels)?.within(&limit);
    let time = of_built(sweep, &survey, &systems, built);
    let cost = cost_lines(&memory, &limit, &time);
    make_folder(&folder)?;
    let look = &drawing.look;
    let responses = response_panels(sweep, &systems)?;
    drawing.save(
        &folder,
        "inspect",
        &response_picture(look, sweep, &responses),
    )?;
    write_atomically(&folder.join("inspect.csv"), &panels_csv(&responses)?)?;
    let drive = DriveView::of(&sweep.setting.string)?;
    let mut pictures = format!(
        "\npicture: {}\n",
        folder.join(drawing.shown("inspect")).display()
    );
    if let Some(drive) = &drive {
        let panels = drive.panels();
        drawing.save(
            &folder,
            "top_drive",
            &drive.picture(look, &sweep.title, &panels),
        )?;
        write_atomically(&folder.join("top_drive.csv"), &panels_csv(&panels)?)?;
        let shown = folder.join(drawing.shown("top_drive"));
        pictures += &format!("picture: {}\n", shown.display());
    }
    let modes = match arguments.modes {
        Some(count) => show_modes(sweep, count.into(), &arguments.orders, &folder, &drawing)?,
        None if arguments.csv => {
            write_modes(sweep, MODES_IN_TABLES, &arguments.orders, &folder)?;
            String::new()
        }
        None => String::new(),
    };
    if arguments.csv {
        write_tables(sweep, &systems, &folder)?;
        pictures += &format!("tables: {}\n", folder.join("*.csv").display());
    }
    say(&[
        describe_string(sweep),
        describe_well(sweep),
        describe_clearances(sweep),
        describe_axial_force(sweep)?,
        describe_forward_contact(sweep)?,
        (drive.as_ref()).map_or_else(String::new, |drive| drive.words(sweep.content.units)),
        modes,
        describe_methods(&systems, sweep.content.units),
        describe_left_out(sweep),
        describe_work(sweep, &survey, &systems),
        (cost.lines().map(|line| format!("  {line}\n"))).collect(),
        pictures,
    ]
    .concat())?;
    Ok(Status::Complete)
}
