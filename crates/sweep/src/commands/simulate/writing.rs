//! The files of simulated cases, and what is printed of them.

use std::path::Path;

use anyhow::Result;
use linear::elements::reconstruction::Reconstruction;

use super::film::chosen_steps;
use crate::cli::FilmArguments;
use crate::commands::drawing::save_picture;
use crate::commands::folder::make_folder;
use crate::engine::{Case, Record};
use crate::histories::{
    Simulation, case_csv, case_lines, contact_picture, contacts_csv, film_picture, history_csv,
    history_picture, orbit_picture, string_picture, whole_strings,
};
use crate::output::write_atomically;
use crate::plan::Sweep;

/// Simulated cases, and where their files are written.
pub struct Written<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// Its cases that were asked for.
    pub cases: &'a [Case],
    /// The rows that a run has of them.
    pub rows: &'a [Record],
    /// The motion of each case and method that has an answer; at least one.
    pub simulations: &'a [Simulation],
    /// Where the files go.
    pub folder: &'a Path,
}

impl Written<'_> {
    /// Writes tables and pictures, and returns what is to be said.
    ///
    /// # Errors
    /// Where a film has no steps to show, or a file cannot be made.
    pub fn write(&self, film: &FilmArguments) -> Result<String> {
        let &Self {
            sweep,
            cases,
            simulations,
            ..
        } = self;
        let steps = chosen_steps(film, &simulations[0].trajectory)?;
        let lateral = sweep.setting.lateral.as_ref();
        let wholes = match lateral {
            Some(lateral) => whole_strings(sweep, lateral, simulations, &steps)?,
            None => Vec::new(),
        };
        make_folder(self.folder)?;
        self.table("history.csv", &history_csv(sweep, simulations)?)?;
        self.table("case.csv", case_csv(sweep, self.rows).as_bytes())?;
        let history = history_picture(sweep, cases, simulations)?;
        save_picture(self.folder, "history", &history)?;
        if lateral.is_some() {
            self.lateral(&wholes)?;
        }
        let mut files = "history.svg, history.png, history.csv and case.csv".to_owned();
        if lateral.is_some() {
            let film = match &steps[..] {
                [] => String::new(),
                _ => format!(", film (of {})", simulations[0].name),
            };
            files = format!(
                "history, orbit, string, contacts{film} as svg and png, history.csv, contacts.csv \
                 and case.csv"
            );
        }
        if !steps.is_empty() {
            let film = film_picture(sweep, cases, &simulations[0], &wholes[0], &steps)?;
            save_picture(self.folder, "film", &film)?;
        }
        // All cases have the same.
        let found = self.rows.first().and_then(|row| row.found.as_ref());
        let written = (files.as_str(), self.folder);
        case_lines(sweep, found, cases, simulations, &wholes, written)
    }

    fn table(&self, name: &str, content: &[u8]) -> Result<()> {
        write_atomically(&self.folder.join(name), content)
    }

    /// What there is of motion between walls alone.
    fn lateral(&self, wholes: &[Reconstruction]) -> Result<()> {
        let &Self {
            sweep,
            cases,
            simulations,
            folder,
            ..
        } = self;
        self.table("contacts.csv", &contacts_csv(sweep, simulations)?)?;
        save_picture(folder, "contacts", &contact_picture(sweep, simulations)?)?;
        save_picture(folder, "orbit", &orbit_picture(sweep, cases, simulations)?)?;
        let string = string_picture(sweep, cases, simulations, wholes)?;
        save_picture(folder, "string", &string)
    }
}
