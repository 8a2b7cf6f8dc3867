//! The keys of a sweep file. Every key carries its unit in its name; what is
//! optional says what happens without it.

use schemars::JsonSchema;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};

use super::bit::BitTable;
use super::compare::CompareTable;
use super::design::{AxisRange, DesignTable, PointsName, Spacing};
use super::feed::FeedTable;
use super::lateral::{
    ClearanceName, EccentricMassTable, ImpulseTable, SiteTable, SitesName, ToolTable, WallTable,
};
use super::map::MapTable;
use super::methods::{MethodName, MethodTables};
use super::motor::MotorTable;
use super::number_or::{Accuracy, AutoOr, is_false, is_zero};
use super::start::StartName;
use super::string::StringTable;
use super::top_drive::TopDriveTable;
use super::well::{AxialForceTable, MudTable, StringFrictionTable, WellTable};
use crate::quantities::{Axis, Units};

/// A sweep file, its bases merged in, as it is written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FileContent {
    /// Names the results folder; it is not taken from a base. Left out, the file's name without its
    /// ending; of a file from standard input, `sweep`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// One line for pictures and reports; like all names without control characters. Left out,
    /// the words of the file's name.
    pub title: Option<String>,
    /// Units of pictures, reports and words. Tables and `manifest.json` stay in SI, and a run
    /// that is there is only drawn again.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "Units::are_si")]
    pub units: Units,
    /// The drillstring.
    pub string: StringTable,
    /// Speed of the surface, or the one its drive is set to; needed unless it is an axis.
    #[schemars(range(min = 1e-4, max = 1e4))]
    pub surface_speed_rpm: Option<f64>,
    /// The motion that every case begins with. Left out, `"stuck"` where a torque acts on the
    /// bit and nothing else decides, else `"ramp"`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start: Option<StartName>,
    /// With `"smooth"` or `"both"`: by what part of itself the torque on the turning bit rises
    /// at t = 0; left out, 0.01.
    #[schemars(range(min = 0.0, max = 1.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_disturbance: Option<f64>,
    /// Time in which the surface reaches its speed, evenly, from rest at t = 0; at once if it
    /// is 0, as in the paper. Below a `[top_drive]` that of the speed it is set to. Times of
    /// cases by rule are longer by it. A file that gives it begins its cases at rest (`start =
    /// "ramp"`).
    #[schemars(!skip_serializing_if, range(min = 0.0, max = 1e4))]
    #[serde(default, skip_serializing_if = "is_zero")]
    pub surface_speed_rise_s: f64,
    /// Instead of both: the speed that was recorded at the surface, or set there, over time. A
    /// CSV file or a workbook with a column of times (`time_s`, `Time (min)`) and one in rpm,
    /// rad/s, rev/s or deg/s. Straight between its samples; a gap, a time that runs back or a
    /// case that lasts longer is refused.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_speed_file: Option<String>,
    /// Its column of speeds, where there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub surface_speed_column: Option<String>,
    /// Whether the torque that turns the surface, below a `[top_drive]` that of its motor, is
    /// measured: `labels.csv` then has four more columns, its greatest in all the time, and
    /// least, mean and greatest in the closing window. Cases are followed to their end for it.
    /// With `[string_friction]` it always is.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "is_false")]
    pub surface_torque: bool,
    /// The motor that turns the string, under its controller; without it the surface turns
    /// exactly as prescribed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub top_drive: Option<TopDriveTable>,
    /// The well that the string is in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub well: Option<WellTable>,
    /// The fluid inside and around the string; it matters to `[string_friction]`, a `[wall]`
    /// and `[axial_force]`, and is noted where it does not.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mud: Option<MudTable>,
    /// The axial force of a string that bends; without it there is none but `compression_kn`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axial_force: Option<AxialForceTable>,
    /// Friction along the string; without it there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub string_friction: Option<StringFrictionTable>,
    /// Torque at the bit; without it the bit is free.
    pub bit: Option<BitTable>,
    /// A mud motor between string and bit; without it the bit turns as the end of the string.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motor: Option<MotorTable>,
    /// What lets the string down above a bit with `[bit.cutting]`; left out, a hook load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<FeedTable>,
    /// With a wall, where the string may touch it, together with the candidates of `[wall]`;
    /// without, what `simulate` draws in addition to the bit.
    #[serde(default)]
    pub sites: Vec<SiteTable>,
    /// The borehole wall; without it lateral motion is not modelled.
    pub wall: Option<WallTable>,
    /// Lateral impulses; need a wall.
    #[serde(default)]
    pub impulses: Vec<ImpulseTable>,
    /// Masses out of balance; need a wall.
    #[serde(default)]
    pub eccentric_masses: Vec<EccentricMassTable>,
    /// Where accelerations are measured, instead of at the sites and at a bit that cuts; need a wall, or such
    /// a bit.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub tools: Vec<ToolTable>,
    /// The largest error wanted, instead of `methods`, `method` and `sampling_frequency_hz`:
    /// the cheapest method and sampling frequency that meet it on this string and these cases,
    /// by the program's own estimate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// How the linear response is computed; every case is simulated by each, in this order.
    #[serde(default = "default_methods")]
    pub methods: Vec<MethodName>,
    /// Whether a run finds out of each label if it is certain: by `held` and `finite-element`,
    /// which `methods` has to name, each at this sampling frequency and at twice that, and at
    /// nearby surface speeds. `labels.csv` then has ten more columns at its end, and the map
    /// is filled where labels are certain.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "is_false")]
    pub certify: bool,
    /// Parameters of the methods.
    #[serde(default)]
    pub method: MethodTables,
    /// Steps a second. By rule, as many as the waves in the string need and, by each method, whirl at
    /// the walls. A frequency at which a
    /// wave takes fewer than two steps from the surface to the bit is refused where a torque
    /// acts there.
    #[schemars(extend("minimum" = 1.0, "maximum" = 1e6))]
    #[serde(default)]
    pub sampling_frequency_hz: AutoOr,
    /// Time simulated. By rule, a bit with torque is followed until its regime is known (Eqs.
    /// 72–73), one that cuts for a minute; with a wall at least 10 s, and until whirl has faded that
    /// friction does not sustain, which takes light damping up to a minute after the impulses (20 s at
    /// least where the string lies); without either it is 10 s. Where a bit then sticks for ever shorter, or a
    /// string that lies swings ever less, the case is followed up to nine times as long; three times where it
    /// sticks irregularly.
    #[schemars(extend("minimum" = 0.001, "maximum" = 1e6))]
    #[serde(default)]
    pub time_s: AutoOr,
    /// The cases; without it there is one.
    pub design: Option<DesignTable>,
    /// What was recorded, to hold every case against.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub compare: Vec<CompareTable>,
    /// How the map is drawn.
    #[serde(default)]
    pub map: MapTable,
}

impl FileContent {
    /// Whether the blades of the bit cut what they leave.
    pub fn has_cutting(&self) -> bool {
        (self.bit.as_ref()).is_some_and(|bit| bit.cutting.is_some())
    }

    /// Whether cases follow what turns the surface, asked for or not: it acts on a string that rubs
    /// along its well, and is the law of a drive whose torque is limited.
    pub fn follows_surface(&self) -> bool {
        let saturates = self.top_drive.is_some_and(|drive| drive.saturates);
        self.string_friction.is_some() || saturates
    }

    /// Whether an `accuracy` can be asked for: nothing is known of the error of the other scenes.
    pub fn may_have_accuracy(&self) -> bool {
        let is_walled = self.has_cutting() && self.wall.is_some();
        !self.follows_surface() && self.motor.is_none() && !is_walled
    }

    /// Whether the string lies on the low side of its hole: of an inclined well, with a wall.
    pub fn lies_on_low_side(&self) -> bool {
        let is_inclined =
            |well: &WellTable| well.survey.is_some() || well.inclination_deg.is_some();
        let lies = |wall: &WallTable| wall.lies_on_low_side != Some(false);
        self.well.as_ref().is_some_and(is_inclined) && self.wall.as_ref().is_some_and(lies)
    }

    /// Whether accelerations are measured.
    pub fn measures_shocks(&self) -> bool {
        let by_wall = self.wall.is_some_and(|wall| wall.shock_g.is_some());
        let has_tools = self.wall.is_some() && !self.tools.is_empty();
        self.lies_on_low_side() || by_wall || has_tools
    }

    /// Whether bending and stress of the moving string are measured.
    pub fn measures_stress(&self) -> bool {
        (self.wall).is_some_and(|wall| wall.stress_every_m.is_some())
    }

    /// Whether the hole decides the clearance where nothing else does.
    pub fn clearance_is_of_hole(&self) -> bool {
        let clearance = self.wall.and_then(|wall| wall.clearance);
        clearance == Some(ClearanceName::Hole)
    }

    /// The wall, where candidates are sites too.
    pub fn wall_with_candidates(&self) -> Option<&WallTable> {
        let wall = self.wall.as_ref();
        wall.filter(|wall| matches!(wall.sites, SitesName::All | SitesName::Ends))
    }

    /// Whether the bit is one of the sites.
    pub fn bit_is_site(&self) -> bool {
        let is_given = (self.sites.iter()).any(|site| site.distance_from_bit_m == 0.0);
        // Candidates at even distances begin there, and it is one of those of a string that lies.
        let has_bit =
            |wall: &WallTable| wall.sites == SitesName::Ends || wall.sites_every_m.is_some();
        is_given || self.wall_with_candidates().is_some_and(has_bit)
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

/// As JSON within other JSON. Compiled here alone: for each reader and writer anew it takes seconds.
impl FileContent {
    /// What it is in JSON.
    ///
    /// # Errors
    /// None that a file that was read could cause.
    pub fn to_json(&self) -> serde_json::Result<serde_json::Value> {
        serde_json::to_value(self)
    }

    /// Reads what it is in JSON.
    ///
    /// # Errors
    /// Where that is no content of a sweep file.
    pub fn from_json<'de, D: Deserializer<'de>>(json: D) -> Result<Self, D::Error> {
        Self::from_value(serde_json::Value::deserialize(json)?).map_err(D::Error::custom)
    }

    fn from_value(json: serde_json::Value) -> serde_json::Result<Self> {
        serde_json::from_value(json)
    }
}

fn default_methods() -> Vec<MethodName> {
    vec![MethodName::Held]
}
