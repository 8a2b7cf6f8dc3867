//! Putting another value in the place of a quantity of the string: its damping, its
//! sections, the places of its sites.

use thiserror::Error;

use super::file::FileContent;
use super::lateral::EccentricMassTable;
use super::lateral::{BendingTable, SiteTable};
use super::string::SectionTable;
use super::top_drive::{ControllerName, TopDriveTable};
use crate::quantities::StringAxis;

/// Why a file has no place for a quantity of the string.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum NoPlace {
    /// Its string has no bending constants.
    #[error("needs a table [string.bending]")]
    Bending,
    /// Its string does not have this section.
    #[error("the string has {0} sections, from 0")]
    Section(usize),
    /// A section does not have this part.
    #[error("section {0} has {1} parts, from 0")]
    Part(usize, usize),
    /// The surface turns as prescribed.
    #[error("needs a table [top_drive]")]
    TopDrive,
    /// Its controller has its own gains.
    #[error("needs `controller = \"gains\"` in [top_drive]")]
    Gains,
    /// There is no fluid.
    #[error("needs a table [mud]")]
    Mud,
    /// It does not have this eccentric mass.
    #[error("the file has {0} [[eccentric_masses]], from 0")]
    EccentricMass(usize),
    /// It does not have this site.
    #[error("the file has {0} [[sites]], from 0")]
    Site(usize),
}

impl FileContent {
    /// Puts a value in the place of a quantity of the string. What is at a site that
    /// moves stays, until all have: see [`FileContent::take_along`].
    ///
    /// # Errors
    /// Where the file has no such place.
    pub fn set(&mut self, axis: StringAxis, value: f64) -> Result<(), NoPlace> {
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
                let nowhere = NoPlace::Part(section, parts.len());
                *parts.get_mut(part).ok_or(nowhere)?.measure(measure) = value;
            }
            StringAxis::SitePlace { site } => self.site(site)?.distance_from_bit_m = value,
            StringAxis::DriveInertia => self.drive()?.inertia_kg_m2 = value,
            StringAxis::ProportionalGain => {
                let drive = self.drive_with(&[ControllerName::Gains])?;
                drive.proportional_gain_knms_rad = Some(value);
            }
            StringAxis::IntegralGain => {
                let takes = [ControllerName::Gains, ControllerName::ImpedanceMatched];
                self.drive_with(&takes)?.integral_gain_knm_rad = Some(value);
            }
            StringAxis::MudDensity => {
                self.mud.as_mut().ok_or(NoPlace::Mud)?.density_kg_m3 = value;
            }
            StringAxis::MudViscosity => {
                self.mud.as_mut().ok_or(NoPlace::Mud)?.viscosity_cp = value;
            }
            StringAxis::LossFactor => self.string.loss_factor = value,
            StringAxis::EccentricMass { mass } => self.eccentric_mass(mass)?.mass_kg = value,
            StringAxis::EccentricOffset { mass } => self.eccentric_mass(mass)?.offset_m = value,
        }
        Ok(())
    }

    fn bending(&mut self) -> Result<&mut BendingTable, NoPlace> {
        self.string.bending.as_mut().ok_or(NoPlace::Bending)
    }

    fn section(&mut self, section: usize) -> Result<&mut SectionTable, NoPlace> {
        let nowhere = NoPlace::Section(self.string.sections.len());
        self.string.sections.get_mut(section).ok_or(nowhere)
    }

    fn drive(&mut self) -> Result<&mut TopDriveTable, NoPlace> {
        self.top_drive.as_mut().ok_or(NoPlace::TopDrive)
    }

    /// The drive, if its controller is one of those that take a gain.
    fn drive_with(&mut self, takes: &[ControllerName]) -> Result<&mut TopDriveTable, NoPlace> {
        let drive = self.drive()?;
        let is_taken = takes.contains(&drive.controller);
        is_taken.then_some(drive).ok_or(NoPlace::Gains)
    }

    fn eccentric_mass(&mut self, mass: usize) -> Result<&mut EccentricMassTable, NoPlace> {
        let nowhere = NoPlace::EccentricMass(self.eccentric_masses.len());
        self.eccentric_masses.get_mut(mass).ok_or(nowhere)
    }

    fn site(&mut self, site: usize) -> Result<&mut SiteTable, NoPlace> {
        let nowhere = NoPlace::Site(self.sites.len());
        self.sites.get_mut(site).ok_or(nowhere)
    }

    /// Impulses and masses go with the sites they were at `before` any was moved: a place
    /// that one site leaves may be where another goes.
    pub fn take_along(&mut self, before: &[SiteTable]) {
        let impulses = self.impulses.iter_mut();
        let masses = self.eccentric_masses.iter_mut();
        let places = (impulses.map(|impulse| &mut impulse.distance_from_bit_m))
            .chain(masses.map(|mass| &mut mass.distance_from_bit_m));
        for place in places {
            let mut sites = before.iter().zip(&self.sites);
            if let Some((_, now)) = sites.find(|(site, _)| site.distance_from_bit_m == *place) {
                *place = now.distance_from_bit_m;
            }
        }
    }
}
