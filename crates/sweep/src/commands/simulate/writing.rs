//! The files of simulated cases, and what is printed of them.

use std::path::Path;

use anyhow::Result;
use linear::elements::reconstruction::Reconstruction;

use super::film::chosen_steps;
use crate::cli::FilmArguments;
use crate::commands::drawing::Drawing;
use crate::commands::folder::make_folder;
use crate::histories::{
    case_csv, case_lines, contact_picture, contacts_csv, film_csv, film_picture, history_csv,
    history_picture, orbit_picture, string_csv, string_picture, whole_strings,
};
use campaign::follow::Followed;
use plot::Picture;
use results::files::write_atomically;

/// Simulated cases, and where their files are written.
pub struct Written<'a> {
    /// The cases, of which at least one has an answer.
    pub followed: &'a Followed,
    /// Where the files go.
    pub folder: &'a Path,
    /// How pictures look, and in which formats.
    pub drawing: &'a Drawing,
}

impl Written<'_> {
    /// Writes tables and pictures, and returns what is to be said.
    ///
    /// # Errors
    /// Where a film has no steps to show, or a file cannot be made.
    pub fn write(&self, film: &FilmArguments) -> Result<String> {
        let Followed {
            sweep,
            cases,
            simulations,
            rows,
        } = self.followed;
        let steps = chosen_steps(film, &simulations[0].trajectory)?;
        let lateral = sweep.setting.lateral.as_ref();
        let wholes = match lateral {
            Some(lateral) => whole_strings(sweep, lateral, simulations, &steps)?,
            None => Vec::new(),
        };
        make_folder(self.folder)?;
        self.table("history.csv", &history_csv(sweep, simulations)?)?;
        self.table("case.csv", case_csv(sweep, rows).as_bytes())?;
        let look = &self.drawing.look;
        let history = history_picture(look, sweep, cases, simulations);
        self.picture("history", &history)?;
        if lateral.is_some() {
            self.lateral(&wholes)?;
        }
        if !steps.is_empty() {
            let look = look.with_own_ranges();
            let film = film_picture(&look, sweep, cases, &simulations[0], &wholes[0], &steps);
            self.picture("film", &film)?;
            self.table("film.csv", &film_csv(&simulations[0], &wholes[0], &steps)?)?;
        }
        let files = self.files(lateral.is_some(), !steps.is_empty());
        // All cases have the same.
        let found = rows.first().and_then(|row| row.found.as_ref());
        let written = (files.as_str(), self.folder);
        case_lines(sweep, found, cases, simulations, &wholes, written)
    }

    /// The files that were written, in words.
    fn files(&self, is_lateral: bool, has_film: bool) -> String {
        if !is_lateral {
            let pictures = self.drawing.files("history").join(", ");
            return format!("{pictures}, history.csv and case.csv");
        }
        let film = match has_film {
            false => String::new(),
            true => format!(", film (of {})", self.followed.simulations[0].name),
        };
        let film_table = if has_film { "film.csv, " } else { "" };
        format!(
            "history, orbit, string, contacts{film} as {}, history.csv, string.csv, contacts.csv, \
             {film_table}case.csv",
            self.drawing.words()
        )
    }

    fn table(&self, name: &str, content: &[u8]) -> Result<()> {
        write_atomically(&self.folder.join(name), content)
    }

    fn picture(&self, name: &str, picture: &Picture) -> Result<()> {
        self.drawing.save(self.folder, name, picture)
    }

    /// What there is of motion between walls alone. Ranges of axes are those of histories: contacts
    /// share their time.
    fn lateral(&self, wholes: &[Reconstruction]) -> Result<()> {
        let Followed {
            sweep,
            cases,
            simulations,
            ..
        } = self.followed;
        let over_time = self.drawing.look.with_own_heights();
        let look = self.drawing.look.with_own_ranges();
        self.table("contacts.csv", &contacts_csv(sweep, simulations)?)?;
        self.picture("contacts", &contact_picture(&over_time, sweep, simulations))?;
        self.picture("orbit", &orbit_picture(&look, sweep, cases, simulations))?;
        self.table(
            "string.csv",
            &string_csv(sweep, cases, simulations, wholes)?,
        )?;
        let string = string_picture(&look, sweep, cases, simulations, wholes);
        self.picture("string", &string)
    }
}
