//! Putting another value in the place of a quantity of the string: its damping, its
//! sections, the places of its sites.

use super::file::FileContent;
use super::lateral::BendingTable;
use super::string::SectionTable;
use crate::quantities::StringAxis;

impl FileContent {
    /// Puts a value in the place of a quantity of the string.
    ///
    /// # Errors
    /// Where the file has no such place; a sentence.
    pub fn set(&mut self, axis: StringAxis, value: f64) -> Result<(), String> {
        match axis {
            StringAxis::TorsionalDamping => self.string.torsional_damping_nms_rad_m = value,
            StringAxis::BendingDamping => self.bending()?.damping_ns_m2 = value,
            StringAxis::Compression => self.bending()?.compression_kn = value,
            StringAxis::Repeat { section } => self.section(section)?.repeat = value as usize,
            StringAxis::Tube {
                section,
                part,
                measure,
            } => {
                let parts = &mut self.section(section)?.parts;
                let count = parts.len();
                let tube = parts
                    .get_mut(part)
                    .ok_or_else(|| format!("section {section} has {count} parts, from 0"))?;
                *tube.measure(measure) = value;
            }
            StringAxis::SitePlace { site } => self.move_site(site, value)?,
        }
        Ok(())
    }

    fn bending(&mut self) -> Result<&mut BendingTable, String> {
        let bending = self.string.bending.as_mut();
        bending.ok_or_else(|| "needs a table [string.bending]".to_owned())
    }

    fn section(&mut self, section: usize) -> Result<&mut SectionTable, String> {
        let sections = &mut self.string.sections;
        let count = sections.len();
        let section = sections.get_mut(section);
        section.ok_or_else(|| format!("the string has {count} sections, from 0"))
    }

    /// Impulses and masses at a site go with it.
    fn move_site(&mut self, site: usize, distance: f64) -> Result<(), String> {
        let count = self.sites.len();
        let table = (self.sites.get_mut(site))
            .ok_or_else(|| format!("the file has {count} [[sites]], from 0"))?;
        let before = std::mem::replace(&mut table.distance_from_bit_m, distance);
        let impulses = self.impulses.iter_mut();
        let masses = self.eccentric_masses.iter_mut();
        (impulses.map(|impulse| &mut impulse.distance_from_bit_m))
            .chain(masses.map(|mass| &mut mass.distance_from_bit_m))
            .filter(|place| **place == before)
            .for_each(|place| *place = distance);
        Ok(())
    }
}
