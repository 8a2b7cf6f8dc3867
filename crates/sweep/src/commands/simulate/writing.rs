//! The files of simulated cases, and what is printed of them.

use std::path::Path;

use anyhow::Result;
use linear::elements::reconstruction::Reconstruction;

use super::film::chosen_steps;
use crate::cli::FilmArguments;
use crate::commands::drawing::Drawing;
use crate::commands::folder::make_folder;
use crate::commands::static_string::{self, ShownString};
use crate::histories::{
    case_csv, case_lines, contact_picture, contacts_csv, cut_picture, film_csv, film_picture,
    history_csv, history_picture, orbit_picture, phase_picture, spectra_picture, string_csv,
    string_picture, surface_picture, whole_strings,
};
use campaign::follow::Followed;
use campaign::static_string::StaticString;
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
        let wholes = whole_strings(sweep, cases, simulations, &steps)?;
        make_folder(self.folder)?;
        self.table("history.csv", &history_csv(sweep, simulations)?)?;
        self.table("case.csv", case_csv(sweep, rows).as_bytes())?;
        let look = &self.drawing.look;
        let history = history_picture(look, sweep, cases, simulations);
        self.picture("history", &history)?;
        let drawn = self.drawn_where_there()?;
        if lateral.is_some() {
            self.lateral(&wholes)?;
        }
        let lies = self.static_string()?;
        if !steps.is_empty() {
            let look = look.with_own_ranges();
            let film = film_picture(&look, sweep, cases, &simulations[0], &wholes[0], &steps);
            self.picture("film", &film)?;
            self.table("film.csv", &film_csv(&simulations[0], &wholes[0], &steps)?)?;
        }
        let files = self.files([lateral.is_some(), lies], &drawn, !steps.is_empty());
        // All cases have the same.
        let found = rows.first().and_then(|row| row.found.as_ref());
        let written = (files.as_str(), self.folder);
        case_lines(sweep, found, cases, simulations, &wholes, written)
    }

    /// The files that were written, in words.
    fn files(
        &self,
        [is_lateral, lies]: [bool; 2],
        drawn: &[&'static str],
        has_film: bool,
    ) -> String {
        let of_walls: &[&str] = match is_lateral {
            true => &["orbit", "string", "contacts"],
            false => &[],
        };
        let at_rest: &[&str] = if lies { &[static_string::NAME] } else { &[] };
        let pictures = [&["history"], drawn, of_walls, at_rest].concat();
        let film = match has_film {
            false => String::new(),
            true => format!(", film (of {})", self.followed.simulations[0].name),
        };
        let tables = [
            ("history.csv", true),
            ("string.csv", is_lateral),
            ("contacts.csv", is_lateral),
            ("static_string.csv", lies),
            ("static_contacts.csv", lies),
            ("film.csv", has_film),
        ];
        let tables = tables.into_iter().filter(|(_, is_there)| *is_there);
        let tables: Vec<&str> = tables.map(|(name, _)| name).collect();
        format!(
            "{}{film} as {}, {} and case.csv",
            pictures.join(", "),
            self.drawing.words(),
            tables.join(", ")
        )
    }

    /// Pictures of torsional motion and of a bit that cuts: the names of those that were drawn.
    fn drawn_where_there(&self) -> Result<Vec<&'static str>> {
        let Followed {
            sweep,
            cases,
            simulations,
            ..
        } = self.followed;
        let own = self.drawing.look.with_own_ranges();
        let over_time = self.drawing.look.with_own_heights();
        let pictures = [
            ("phase", phase_picture(&own, sweep, cases, simulations)),
            ("spectrum", spectra_picture(&over_time, sweep, simulations)),
            ("cut", cut_picture(&own, sweep, simulations)),
            ("surface", surface_picture(&own, sweep, cases, simulations)),
        ];
        let mut drawn = Vec::new();
        for (name, picture) in pictures {
            if let Some(picture) = picture {
                self.picture(name, &picture)?;
                drawn.push(name);
            }
        }
        Ok(drawn)
    }

    fn table(&self, name: &str, content: &[u8]) -> Result<()> {
        write_atomically(&self.folder.join(name), content)
    }

    fn picture(&self, name: &str, picture: &Picture) -> Result<()> {
        self.drawing.save(self.folder, name, picture)
    }

    /// The string as it lies at rest, the same in all cases: whether it does.
    fn static_string(&self) -> Result<bool> {
        let Followed { sweep, cases, .. } = self.followed;
        let found = StaticString::of(&sweep.setting, &cases[0].conditions, None);
        let Some(Ok(string)) = found else {
            return Ok(false);
        };
        let shown = ShownString {
            string: &string,
            title: &sweep.title,
            units: sweep.content.units,
        };
        shown.write(self.folder, self.drawing)?;
        Ok(true)
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
