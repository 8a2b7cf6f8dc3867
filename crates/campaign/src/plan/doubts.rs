//! What a person should know of a sweep before its work, though nothing is wrong with it.

use super::hole::idle_tables;
use super::string_friction::slow_methods_note;
use super::sweep::Sweep;
use crate::records::Measure;

impl Sweep {
    /// What is doubtful: parts of the string such as none are made, a drive that gives more than any
    /// can, a weight on bit or a rock that is another's, a well that no pipe goes through, bands
    /// of accelerations that the sampling frequency does not hold, rows of a sheet.
    pub fn doubts(&self) -> Vec<String> {
        let sheet = self.sheet.iter();
        [
            self.doubts_about_string(),
            self.doubts_about_drive(),
            self.doubts_about_bit(),
            self.doubts_about_bands(),
            self.doubts_about_well().into_iter().collect(),
            self.doubts_about_whirl().into_iter().collect(),
            self.data.doubts.clone(),
            sheet
                .flat_map(|sheet| sheet.doubts(self.content.units, self.content.motor.is_some()))
                .collect(),
        ]
        .concat()
    }

    /// How files other than the sweep file were read, and tables without effect; and methods
    /// that take long where others do not.
    pub fn notes(&self) -> Vec<String> {
        let friction = self.setting.friction.as_ref();
        let of_methods = friction.and_then(|friction| {
            slow_methods_note(&self.methods, friction, self.setting.drive_limit)
        });
        let of_sheet = self.sheet.iter().flat_map(|sheet| sheet.notes());
        of_sheet
            .chain(idle_tables(&self.content, &self.design))
            .chain(self.content.map.colour.and_then(renamed_note))
            .chain(self.data.notes.iter().cloned())
            .chain(of_methods)
            .collect()
    }
}

/// A colour of the map that is called otherwise now.
fn renamed_note(colour: Measure) -> Option<String> {
    let column = colour.column();
    let note = |old| format!("map.colour: the column `{old}` is called `{column}` now");
    colour.old_name().map(note)
}
