//! All that is found of the linear system of a sweep.

use serde::Serialize;

use super::axial_force::InspectedForce;
use super::clearances::{InspectedClearance, describe_clearances};
use super::lying::InspectedLying;
use super::methods::InspectedMethod;
use super::modes::InspectedModes;
use super::motor::InspectedMotor;
use super::string::InspectedString;
use super::top_drive::InspectedDrive;
use super::well::InspectedWell;
use super::work::InspectedCost;
use campaign::quantities::Units;
use campaign::words::wrapped;
use limits::ForwardContact;

/// The linear system of a sweep: `sweep inspect --json` in SI units, or words in those of the file.
#[derive(Serialize)]
pub struct Inspection<'a> {
    /// Name of the sweep.
    pub name: &'a str,
    /// One line about it.
    pub title: &'a str,
    /// The string.
    pub string: InspectedString<'a>,
    /// How it lies in its well, where it rubs there.
    pub well: Option<InspectedWell>,
    /// What clearance the hole leaves, by site.
    pub clearances: Vec<InspectedClearance>,
    /// What pulls and pushes it, where that is modelled.
    pub axial_force: Option<InspectedForce>,
    /// How it lies in its hole at rest, where its course is known.
    pub lying: Option<InspectedLying>,
    /// From which speed on an eccentric mass brings it to its wall, where that is known.
    pub forward_contact: Option<ForwardContact>,
    /// What turns it, where that is a top drive.
    pub top_drive: Option<InspectedDrive>,
    /// What turns the bit against the string, where that is a mud motor.
    pub motor: Option<InspectedMotor>,
    /// Its modes, where they are asked for.
    pub modes: Option<InspectedModes>,
    /// The responses by each method.
    pub methods: Vec<InspectedMethod>,
    /// How often words of safety were wrong for such strings, a sentence each.
    pub how_often_wrong: Vec<String>,
    /// What the scene does not need.
    pub left_out: Vec<&'static str>,
    /// What a run takes.
    pub cost: InspectedCost,
    /// The folder with pictures and tables.
    pub folder: String,
    /// Pictures of the responses and of the drive.
    pub pictures: Vec<String>,
    /// Whether all tables of `--csv` are in the folder.
    pub has_tables: bool,
}

impl Inspection<'_> {
    /// In words and numbers.
    pub fn words(&self, units: Units) -> String {
        let optional = |text: Option<String>| text.unwrap_or_default();
        let methods = self.methods.iter().map(|method| method.words(units));
        let left_out = self.left_out.iter().map(|line| format!("  {line}\n"));
        let how_often = self.how_often_wrong.iter().map(|line| wrapped(line, 2, 4));
        [
            wrapped(&format!("{}: {}", self.name, self.title), 0, 2),
            self.string.words(units),
            optional(self.well.as_ref().map(|well| well.words(units))),
            describe_clearances(&self.clearances, units),
            optional(self.axial_force.as_ref().map(|force| force.words(units))),
            optional(self.lying.as_ref().map(|lying| lying.words(units))),
            optional(self.forward_contact.as_ref().map(|contact| {
                format!("\neccentric mass\n{}", wrapped(&contact.words(units), 2, 2))
            })),
            optional(self.top_drive.as_ref().map(|drive| drive.words(units))),
            optional(self.motor.as_ref().map(|motor| motor.words(units))),
            optional(self.modes.as_ref().map(|modes| modes.words(units))),
            "\nmethods\n".to_owned(),
            match self.methods.is_empty() {
                true => "  left out: their responses are too large\n".to_owned(),
                false => methods.collect(),
            },
            "\nleft out, because the scene does not need it\n".to_owned(),
            left_out.collect(),
            optional((!self.how_often_wrong.is_empty()).then(|| {
                let title = "\nhow often words of safety were wrong\n".to_owned();
                title + &how_often.collect::<String>()
            })),
            self.cost.words(),
            self.files(),
        ]
        .concat()
    }

    fn files(&self) -> String {
        let pictures = self.pictures.iter();
        let pictures = pictures.map(|path| format!("picture: {path}\n"));
        let tables = match self.has_tables {
            true => format!("tables: {}/*.csv\n", self.folder),
            false => String::new(),
        };
        format!("\n{}{tables}", pictures.collect::<String>())
    }
}
