//! `sweep inspect`: the linear system of a sweep, in words, numbers and a
//! picture (Fig. 6).

mod axial_force;
mod clearances;
mod found;
mod lying;
mod methods;
mod modes;
mod motor;
mod responses;
mod rows;
mod string;
mod tables;
mod top_drive;
mod well;
mod work;

use std::path::Path;
use std::time::Instant;

use anyhow::{Error, Result};
use linear::BuildError;

use super::cost::{WallTime, of_built};
use super::document::say_document;
use super::drawing::{Drawing, panels_csv};
use super::folder::{make_folder, results_folder};
use super::prepare::{build_systems, open, survey_cases};
use super::static_string::{self, ShownString};
use super::status::{Status, UsageError};
use super::terminal::{Terminal, say};
use super::threads::use_threads;
use super::warnings::{warn_of_fronts, warn_of_limits, warn_of_sweep};
use crate::cli::InspectArguments;
use axial_force::InspectedForce;
use campaign::Campaign;
use campaign::engine::{MethodSystem, Survey, add_finer, compare_fronts};
use campaign::memory::{Demand, Limit, Purpose, admit};
use campaign::plan::Sweep;
use campaign::static_string::StaticString;
use clearances::clearances_of_hole;
use found::Inspection;
use limits::ForwardContact;
use lying::InspectedLying;
use methods::InspectedMethod;
use modes::{InspectedModes, write_modes};
use motor::InspectedMotor;
use responses::{response_panels, response_picture};
use results::files::write_atomically;
use results::window::how_often_wrong;
use string::InspectedString;
use tables::write_tables;
use top_drive::DriveView;
use well::InspectedWell;
use work::{InspectedCost, left_out};

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
    let limit = arguments.work.memory.limit();
    let bit = arguments.bit.map(Into::into);
    let at_rest = StaticString::of(&sweep.setting, &sweep.under_greatest_weight(), bit);
    let (systems, time) = match build_responses(&arguments.file, sweep, &survey, &limit) {
        Ok((systems, built)) => {
            let time = of_built(sweep, &survey, &systems, built);
            (systems, time)
        }
        // Modes and the string at rest need none.
        Err(Unbuilt::TooLarge(error)) if at_rest.is_some() || arguments.modes.is_some() => {
            terminal.complain(&format!("warning: responses are left out: {error:#}"));
            (Vec::new(), WallTime::Refused(error))
        }
        Err(Unbuilt::TooLarge(error) | Unbuilt::Other(error)) => return Err(error),
    };
    warn_of_fronts(sweep, &systems, terminal);
    let setting = sweep.setting.for_labels();
    let memory = Demand::of(sweep, &setting, &survey, Purpose::Labels)?.within(&limit);
    make_folder(&folder)?;
    let look = &drawing.look;
    let shown = |name: &str| folder.join(drawing.shown(name)).display().to_string();
    let mut pictures = Vec::new();
    if !systems.is_empty() {
        let responses = response_panels(sweep, &systems)?;
        let picture = response_picture(look, sweep, &responses);
        drawing.save(&folder, "inspect", &picture)?;
        write_atomically(&folder.join("inspect.csv"), &panels_csv(&responses)?)?;
        pictures.push(shown("inspect"));
    }
    let drive = DriveView::of(&sweep.setting.string, sweep.setting.drive_limit)?;
    if let Some(drive) = &drive {
        let panels = drive.panels();
        drawing.save(
            &folder,
            "top_drive",
            &drive.picture(look, &sweep.title, &panels),
        )?;
        write_atomically(&folder.join("top_drive.csv"), &panels_csv(&panels)?)?;
        pictures.push(shown("top_drive"));
    }
    let lying = match at_rest {
        None => None,
        Some(Err(error)) => Some(InspectedLying::Refused {
            error: error.to_string(),
        }),
        Some(Ok(string)) => {
            ShownString {
                string: &string,
                title: &sweep.title,
                units: sweep.content.units,
            }
            .write(&folder, &drawing)?;
            pictures.push(shown(static_string::NAME));
            Some(InspectedLying::at_rest(string.numbers()))
        }
    };
    if lying.is_none() && arguments.bit.is_some() {
        let message = "--bit: the string does not lie in its hole: needs a [wall] and a [well] with \
                       a survey or inclination_deg";
        return Err(UsageError(message.to_owned()).into());
    }
    let orders = &arguments.orders;
    let find = |count: u8| InspectedModes::find(sweep, count.into(), orders, &folder, &drawing);
    let modes = arguments.modes.map(find).transpose()?;
    if arguments.csv {
        if modes.is_none() {
            write_modes(sweep, MODES_IN_TABLES, orders, &folder)?;
        }
        if !systems.is_empty() {
            write_tables(sweep, &systems, &folder)?;
        }
    }
    let found = Inspection {
        name: &sweep.name,
        title: &sweep.title,
        string: InspectedString::of(sweep),
        well: InspectedWell::of(sweep),
        clearances: clearances_of_hole(sweep),
        axial_force: InspectedForce::of(sweep)?,
        lying,
        forward_contact: ForwardContact::of(sweep)?,
        top_drive: drive.as_ref().map(DriveView::numbers),
        motor: InspectedMotor::of(sweep),
        modes,
        methods: systems.iter().map(InspectedMethod::of).collect(),
        how_often_wrong: how_often_wrong(sweep),
        left_out: left_out(sweep),
        cost: InspectedCost::of(sweep, &survey, &systems, (&memory, &limit), &time),
        folder: folder.display().to_string(),
        pictures,
        has_tables: arguments.csv,
    };
    if arguments.document.json {
        say_document("inspect", &found)?;
    } else {
        say(&found.words(sweep.content.units))?;
    }
    Ok(Status::Complete)
}

/// Why there are no responses.
enum Unbuilt {
    /// They are too long, or would take more memory than is allowed.
    TooLarge(Error),
    /// The methods cannot treat the string.
    Other(Error),
}

/// The systems by which a run steps its cases, and how long building them took, s.
fn build_responses(
    file: &Path,
    sweep: &Sweep,
    survey: &Survey,
    limit: &Limit,
) -> Result<(Vec<MethodSystem>, f64), Unbuilt> {
    let setting = sweep.setting.for_labels();
    let look = admit(sweep, &setting, survey, Purpose::Look, limit).map_err(Unbuilt::TooLarge)?;
    let start = Instant::now();
    let systems = build_systems(file, sweep, &setting, survey.longest)
        .and_then(|systems| add_finer(systems, sweep, survey.longest));
    let mut systems = systems.map_err(|error| {
        let mut causes = error.chain().filter_map(|it| it.downcast_ref());
        let is_too_long = causes.any(|cause| {
            use BuildError::{TooManyImpulses, TooManyTaps};
            matches!(cause, TooManyTaps { .. } | TooManyImpulses { .. })
        });
        match is_too_long {
            true => Unbuilt::TooLarge(error),
            false => Unbuilt::Other(error),
        }
    })?;
    let built = start.elapsed().as_secs_f64();
    if look.compares_fronts {
        compare_fronts(&mut systems);
    }
    Ok((systems, built))
}
