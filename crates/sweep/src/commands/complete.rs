//! `sweep run` over a folder that is complete: nothing to simulate, but a title or
//! a map may have changed, and what follows from the labels may be lost.

use std::path::Path;

use anyhow::{Result, bail};

use super::folder::{Found, MANIFEST, hold, in_words, look, tell_if_unverified, tidy};
use super::run::{status_of, summary};
use super::{Status, UsageError, build_systems, complain, say};
use crate::cli::RunArguments;
use crate::engine::{Header, Survey};
use crate::files::write_with_checksum;
use crate::output::{Damage, FAILURES_HEADER, Manifest, PICTURES, boundary, write_boundary};
use crate::plan::Sweep;

/// A run that finds its results there.
pub struct Again<'a> {
    /// What was asked for.
    pub arguments: &'a RunArguments,
    /// The sweep.
    pub sweep: &'a Sweep,
    /// How long its cases take.
    pub survey: &'a Survey,
    /// What a log of the run would begin with.
    pub header: &'a Header,
    /// Where the results are.
    pub folder: &'a Path,
}

impl Again<'_> {
    /// Shows the results again, in order.
    pub fn show(&self, manifest: Manifest) -> Result<Status> {
        tell_if_unverified(&manifest, self.folder);
        let is_in_order = !self.looks_different(&manifest) && self.damage(&manifest)?.is_empty();
        let manifest = if is_in_order {
            tidy(self.folder);
            manifest
        } else {
            self.put_in_order()?
        };
        if !self.arguments.quiet {
            let text = summary(&manifest, self.folder, manifest.map.is_some())?;
            say(&format!("complete already, nothing to run\n{text}"))?;
        }
        Ok(status_of(&manifest))
    }

    /// What is missing or damaged and can be made again; a folder of which more is
    /// lost was refused.
    pub fn damage(&self, manifest: &Manifest) -> Result<Vec<Damage>> {
        let mut damage = manifest.damage(self.folder, &["boundary.csv", "failures.csv"])?;
        if manifest.draws() {
            damage.extend(manifest.damage(self.folder, &PICTURES)?);
        }
        Ok(damage)
    }

    fn looks_different(&self, manifest: &Manifest) -> bool {
        let shown = (&manifest.title, &manifest.map, &manifest.sweep);
        shown != (&self.sweep.title, &self.sweep.map, &self.sweep.content)
    }

    fn put_in_order(&self) -> Result<Manifest> {
        let _lock = hold(self.folder, MANIFEST)?;
        // What was found before the folder was locked may be another's work under way.
        let Found::Complete(manifest) = look(self.folder, self.header, self.sweep, false)? else {
            bail!(
                "{} was changed by another command: give this one again",
                self.folder.display()
            );
        };
        let mut manifest = *manifest;
        let damage = self.damage(&manifest)?;
        if !damage.is_empty() {
            complain(&format!("warning: {}: made again", in_words(&damage)));
        }
        let is_damaged =
            |names: &[&str]| (damage.iter()).any(|damage| names.contains(&damage.name.as_str()));
        if is_damaged(&["boundary.csv"]) {
            self.replace(&mut manifest, "boundary.csv", &self.boundary()?)?;
        }
        if is_damaged(&["failures.csv"]) {
            let none = format!("{FAILURES_HEADER}\n");
            self.replace(&mut manifest, "failures.csv", none.as_bytes())?;
        }
        let draws = self.looks_different(&manifest) || is_damaged(&PICTURES);
        if draws {
            manifest.title.clone_from(&self.sweep.title);
            manifest.map.clone_from(&self.sweep.map);
            manifest.sweep = self.sweep.content.clone();
            // Until they are drawn, there are none.
            (PICTURES.iter()).for_each(|&name| drop(manifest.files.remove(name)));
        }
        if draws || !damage.is_empty() {
            manifest.write(self.folder)?;
        }
        if draws && manifest.draws() {
            super::plot::draw_and_note(self.folder, &mut manifest)?;
        }
        Ok(manifest)
    }

    fn replace(&self, manifest: &mut Manifest, name: &str, content: &[u8]) -> Result<()> {
        let checksum = write_with_checksum(&self.folder.join(name), content)?;
        if manifest.has_checksums() {
            manifest.files.insert(name.to_owned(), checksum);
        }
        Ok(())
    }

    fn boundary(&self) -> Result<Vec<u8>> {
        let (file, sweep) = (&self.arguments.file, self.sweep);
        let setting = sweep.setting.for_labels();
        let systems = build_systems(file, sweep, &setting, self.survey.longest)?;
        write_boundary(&boundary(sweep, &systems).map_err(UsageError)?)
    }
}
