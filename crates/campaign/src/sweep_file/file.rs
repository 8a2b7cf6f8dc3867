//! The keys of a sweep file. Every key carries its unit in its name; what is
//! optional says what happens without it.

use serde::{Deserialize, Serialize};

use super::bit::BitTable;
use super::compare::CompareTable;
use super::design::{AxisRange, DesignTable, PointsName, Spacing};
use super::lateral::{
    ClearanceName, EccentricMassTable, ImpulseTable, SiteTable, SitesName, WallTable,
};
use super::map::MapTable;
use super::methods::{MethodName, MethodTables};
use super::number_or::{Accuracy, AutoOr, is_false, is_zero};
use super::start::StartName;
use super::string::StringTable;
use super::top_drive::TopDriveTable;
use super::well::{AxialForceTable, MudTable, StringFrictionTable, WellTable};
use crate::quantities::{Axis, Units};

/// A sweep file, its bases merged in, as it is written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileContent {
    /// One line for pictures and reports; by default the file's name.
    pub title: Option<String>,
    /// What pictures, reports and words are in. Default: SI units.
    #[serde(default, skip_serializing_if = "Units::are_si")]
    pub units: Units,
    /// The drillstring.
    pub string: StringTable,
    /// Surface speed that is set, unless an axis gives it.
    pub surface_speed_rpm: Option<f64>,
    /// The motion that every case begins with. Default: `stuck` where a torque acts on the bit
    /// and nothing else decides, `ramp` otherwise and with `surface_speed_rise_s`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<StartName>,
    /// By what part of itself the torque on the bit rises at t = 0 of a smooth start.
    /// Default 0.01.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_disturbance: Option<f64>,
    /// Time in which the surface comes to it from rest at t = 0, s. Default 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub surface_speed_rise_s: f64,
    /// The speed that was recorded at the surface, or set there, instead: a CSV file or a
    /// workbook.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_speed_file: Option<String>,
    /// Its column of speeds, if there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_speed_column: Option<String>,
    /// Whether the torque that turns the surface is measured in every case.
    #[serde(default, skip_serializing_if = "is_false")]
    pub surface_torque: bool,
    /// What turns the string; without it the surface turns as prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub top_drive: Option<TopDriveTable>,
    /// The well that the string lies in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub well: Option<WellTable>,
    /// The fluid inside and around the string; without it there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mud: Option<MudTable>,
    /// The axial force along a string that bends; without it there is none but the
    /// pre-compression.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_force: Option<AxialForceTable>,
    /// Friction along the string; without it there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub string_friction: Option<StringFrictionTable>,
    /// Torque at the bit; without it the bit is free.
    pub bit: Option<BitTable>,
    /// Places on the string: with a wall, where it may touch; else, besides the
    /// bit, where it is looked at.
    #[serde(default)]
    pub sites: Vec<SiteTable>,
    /// The borehole wall; without it lateral motion is not modelled.
    pub wall: Option<WallTable>,
    /// Lateral impulses.
    #[serde(default)]
    pub impulses: Vec<ImpulseTable>,
    /// Eccentric masses.
    #[serde(default)]
    pub eccentric_masses: Vec<EccentricMassTable>,
    /// Largest error wanted, instead of methods and a sampling frequency: the
    /// cheapest that deliver it are chosen.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Linear methods, in the order of the results. Default: `held`.
    #[serde(default = "default_methods")]
    pub methods: Vec<MethodName>,
    /// Whether it is told of each label if it is certain.
    #[serde(default, skip_serializing_if = "is_false")]
    pub certify: bool,
    /// Parameters of the methods.
    #[serde(default)]
    pub method: MethodTables,
    /// Sampling frequency; `"auto"` (default) is four times the first torsional
    /// mode of one cell of the drillpipe.
    #[serde(default)]
    pub sampling_frequency_hz: AutoOr,
    /// Time simulated; `"auto"` (default) lets every case run until its regime
    /// can be told.
    #[serde(default)]
    pub time_s: AutoOr,
    /// The cases; without it there is one.
    pub design: Option<DesignTable>,
    /// What was recorded, to hold every case against.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub compare: Vec<CompareTable>,
    /// How the regime map is drawn.
    #[serde(default)]
    pub map: MapTable,
}

impl FileContent {
    /// Whether the hole decides the clearance where nothing else does.
    pub fn clearance_is_of_hole(&self) -> bool {
        let clearance = self.wall.and_then(|wall| wall.clearance);
        clearance == Some(ClearanceName::Hole)
    }

    /// The wall, where candidates are sites too.
    pub fn wall_with_candidates(&self) -> Option<&WallTable> {
        let wall = self.wall.as_ref();
        wall.filter(|wall| wall.sites == SitesName::All)
    }

    /// Whether the bit is one of the sites.
    pub fn bit_is_site(&self) -> bool {
        let is_given = (self.sites.iter()).any(|site| site.distance_from_bit_m == 0.0);
        // Candidates at every so many metres begin there.
        let candidates = self.wall_with_candidates();
        is_given || candidates.is_some_and(|wall| wall.sites_every_m.is_some())
    }

    /// In what the values of an axis are spread.
    pub fn spread(&self, axis: Axis) -> Spacing {
        let design = self.design.as_ref();
        let range = design.and_then(|design| design.axes.get(&axis));
        range.map_or(Spacing::Linear, AxisRange::spread)
    }

    /// Whether its cases are at points of Sobol's sequence.
    pub fn has_sobol_points(&self) -> bool {
        let points = self.design.as_ref().and_then(|design| design.points);
        points == Some(PointsName::Sobol)
    }
}

fn default_methods() -> Vec<MethodName> {
    vec![MethodName::Held]
}
