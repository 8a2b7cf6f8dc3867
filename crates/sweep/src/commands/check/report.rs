//! What a check says: lines for people, annotations for GitHub, JUnit XML for everything else
//! that shows tests, JSON for all other programs.

use std::path::Path;

use anyhow::Result;
use serde::Serialize;

use super::comparison::ComparedLabel;
use super::junit::junit;
use crate::cli::CheckFormat;
use crate::commands::document::document;
use campaign::words::counted;

/// The labels of a reference, compared.
pub struct CheckReport<'a> {
    /// The reference file, as the command names it.
    pub reference: &'a Path,
    /// How far its cases are from where their labels change, where it says so.
    pub margin: Option<String>,
    /// Every label that it has.
    pub compared: &'a [ComparedLabel],
}

/// The labels of a reference, counted and one by one.
#[derive(Serialize)]
struct CheckFound<'a> {
    reference: String,
    margin: Option<&'a str>,
    labels: usize,
    different: usize,
    compared: &'a [ComparedLabel],
}

impl CheckReport<'_> {
    /// In a format.
    ///
    /// # Errors
    /// Where memory does not take it.
    pub fn in_format(&self, format: CheckFormat) -> Result<String> {
        Ok(match format {
            CheckFormat::Human => self.for_people(),
            CheckFormat::Github => self.annotations() + &plain_line(&self.count()),
            CheckFormat::Junit => junit(self.reference, self.compared)?,
            CheckFormat::Json => document("check", &self.found())?,
        })
    }

    /// A line for each label that differs, and how many do not.
    pub fn for_people(&self) -> String {
        let lines = self.different().map(|(label, difference)| {
            let ComparedLabel { case, method, .. } = label;
            let place = label.place();
            format!("case {case} by {method}: {place}: {difference}\n")
        });
        lines.collect::<String>() + &self.count()
    }

    /// Each label that differs, with what is said of it.
    pub fn different(&self) -> impl Iterator<Item = (&ComparedLabel, String)> {
        let labels = self.compared.iter();
        labels.filter_map(|label| Some((label, label.difference()?)))
    }

    /// What was compared, as a document has it.
    fn found(&self) -> CheckFound<'_> {
        CheckFound {
            reference: self.reference.display().to_string(),
            margin: self.margin.as_deref(),
            labels: self.compared.len(),
            different: self.different().count(),
            compared: self.compared,
        }
    }

    fn count(&self) -> String {
        let margin = self.margin.as_ref().map_or_else(String::new, |margin| {
            format!("; its cases keep {margin} from where a label changes")
        });
        format!(
            "{}: {} of {} as expected{margin}\n",
            self.reference.display(),
            self.compared.len() - self.different().count(),
            counted(self.compared.len(), "label")
        )
    }

    /// An error at its line of the reference for each label that differs, in GitHub's commands
    /// of a workflow.
    fn annotations(&self) -> String {
        let file = property(&self.reference.display().to_string());
        let commands = self.different().map(|(label, difference)| {
            let ComparedLabel { case, method, .. } = label;
            let title = property(&format!("{} label differs", label.motion.adjective()));
            let place = label.place();
            let message = format!("case {case} by {method}: {place}: {difference}");
            let message = data(&message);
            format!(
                "::error file={file},line={},title={title}::{message}\n",
                label.line
            )
        });
        commands.collect()
    }
}

/// An error of the check itself, in GitHub's commands of a workflow.
pub fn annotation(file: &Path, error: &str) -> String {
    let file = property(&file.display().to_string());
    format!(
        "::error file={file},title=labels not checked::{}\n",
        data(error)
    )
}

/// A line that is no command of a workflow, for any text.
fn plain_line(text: &str) -> String {
    let text = text.trim_end().replace(['\r', '\n'], " ");
    let begins_one = text.trim_start().starts_with("::");
    format!("{}{text}\n", if begins_one { "labels: " } else { "" })
}

/// What follows `::` in a command of a workflow: one line, for any text.
fn data(text: &str) -> String {
    let text = text.replace('%', "%25");
    text.replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property of such a command.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}
