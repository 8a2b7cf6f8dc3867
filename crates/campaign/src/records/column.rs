//! What a column of results is, and what a row has in it.

use std::f64::consts::TAU;

use sim::{
    AxialAcceleration, AxialMeasures, InBand, Label, LateralMeasures, LyingMeasures, Motion,
    Outcome, ShockMeasures, StressMeasures, StringTorque, SurfaceMeasures, TorsionMeasures,
};

use super::field::{Field, Kind};
use super::record::Record;
use super::verdict::{Certainty, MotionVerdict};
use super::wall_push::WallPush;
use crate::quantities::{RPM, Unit, Units};

/// Columns that a table has together, or not at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Group {
    /// In every table.
    Always,
    /// Of a bit that cuts what its blades leave.
    Cutting,
    /// How a string that lies in its hole swings there.
    Lying,
    /// Accelerations, where they are measured.
    Shocks,
    /// How the string is bent and stressed, where that is measured.
    Stress,
    /// Torque at the surface, where that is followed.
    Surface,
    /// The greatest torque along the string, where that is followed.
    String,
    /// A mud motor above the bit.
    Motor,
    /// How deep walls give way.
    Wall,
    /// What is certain, where labels are certified: what the method says by shorter steps, as far
    /// as it matters to that, and whether the labels of the row are certain.
    Certificate,
    /// How the bit turns from each start, where cases begin in both ways.
    Starts,
    /// The sites that were found for a case in addition to those of the file, with `;` between
    /// them, and how often it was run again for them.
    Found,
}

/// What has to be modelled for a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needs {
    /// A torque at the bit.
    Bit,
    /// A borehole wall.
    Wall,
    /// The torque at the surface.
    SurfaceTorque,
    /// The torque along the string.
    StringTorque,
    /// A bit that cuts what its blades leave.
    Cutting,
    /// A string that lies in its hole.
    Lying,
    /// Accelerations.
    Shocks,
    /// Bending and stress.
    Stress,
    /// A mud motor above the bit.
    Motor,
}

/// A column of results.
#[derive(Debug)]
pub struct ResultColumn {
    /// Its name, which ends in the unit of its numbers.
    pub name: &'static str,
    /// What it holds.
    pub kind: Kind,
    /// As a person reads it.
    pub words: &'static str,
    /// The motion that it is about, where it is about one.
    pub motion: Option<Motion>,
    /// Which columns it comes with.
    pub group: Group,
    /// Whether a map may have it as colour.
    pub is_measure: bool,
    /// Whether it says how severe its motion is.
    pub is_severity: bool,
    /// The unit of its numbers; empty where they have none.
    pub(super) unit: &'static str,
    field: fn(&RecordRow) -> Field<'static>,
}

/// A record, with what is certain of it.
pub struct RecordRow<'a> {
    pub(super) record: &'a Record,
    pub(super) outcome: Option<&'a Outcome>,
    pub(super) certainty: Certainty,
}

type FieldOf = fn(&RecordRow) -> Field<'static>;

const fn column(
    name: &'static str,
    (kind, unit): (Kind, &'static str),
    words: &'static str,
    field: FieldOf,
) -> ResultColumn {
    ResultColumn {
        name,
        kind,
        words,
        motion: None,
        group: Group::Always,
        is_measure: false,
        is_severity: false,
        unit,
        field,
    }
}

pub(super) const fn number(
    name: &'static str,
    unit: &'static str,
    words: &'static str,
    field: FieldOf,
) -> ResultColumn {
    column(name, (Kind::Number, unit), words, field)
}

pub(super) const fn count(name: &'static str, words: &'static str, field: FieldOf) -> ResultColumn {
    column(name, (Kind::Count, ""), words, field)
}

pub(super) const fn text(name: &'static str, words: &'static str, field: FieldOf) -> ResultColumn {
    column(name, (Kind::Text, ""), words, field)
}

pub(super) const fn flag(name: &'static str, words: &'static str, field: FieldOf) -> ResultColumn {
    column(name, (Kind::Flag, ""), words, field)
}

impl ResultColumn {
    pub(super) const fn of(mut self, motion: Motion) -> Self {
        self.motion = Some(motion);
        self
    }

    pub(super) const fn group(mut self, group: Group) -> Self {
        self.group = group;
        self
    }

    pub(super) const fn measure(mut self) -> Self {
        self.is_measure = true;
        self
    }

    pub(super) const fn severity(mut self) -> Self {
        self.is_severity = true;
        self
    }

    /// The column of a motion's label.
    pub fn label_of(motion: Motion) -> &'static str {
        motion.name()
    }

    /// What a row has in it.
    pub fn field(&self, row: &RecordRow) -> Field<'static> {
        (self.field)(row)
    }

    /// The unit in which its numbers are shown.
    pub fn unit(&self, units: Units) -> Unit {
        let twin = (units.twin_of(self.name)).filter(|twin| twin.units[0] == self.unit);
        twin.map_or_else(|| Unit::unchanged(self.unit), |twin| units.of(twin))
    }

    /// What has to be modelled for it.
    pub fn needs(&self) -> Option<Needs> {
        match (self.group, self.motion) {
            (Group::Surface, _) => Some(Needs::SurfaceTorque),
            (Group::String, _) => Some(Needs::StringTorque),
            (Group::Lying, _) => Some(Needs::Lying),
            (Group::Shocks, _) => Some(Needs::Shocks),
            (Group::Stress, _) => Some(Needs::Stress),
            (Group::Motor, _) => Some(Needs::Motor),
            (_, Some(Motion::Torsion)) => Some(Needs::Bit),
            (_, Some(Motion::Lateral)) => Some(Needs::Wall),
            (_, Some(Motion::Axial)) => Some(Needs::Cutting),
            (_, None) => None,
        }
    }
}

impl<'a> RecordRow<'a> {
    /// Of a record.
    pub fn new(record: &'a Record, certainty: Certainty) -> Self {
        Self {
            record,
            outcome: record.outcome.as_ref().ok(),
            certainty,
        }
    }

    pub(super) fn label(&self, motion: Motion) -> Field<'static> {
        let label = self.outcome.and_then(|outcome| outcome.labels()[motion]);
        label.map(Label::name).into()
    }

    pub(super) fn torsion(&self) -> Option<TorsionMeasures> {
        self.outcome.and_then(Outcome::torsion)
    }

    pub(super) fn motor_stalled_fraction(&self) -> Option<f64> {
        self.torsion()
            .and_then(|torsion| torsion.motor_stalled_fraction)
    }

    /// The hardest push into a wall, where there was one.
    pub fn wall_push(&self) -> Option<WallPush> {
        self.record.wall_push
    }

    /// Whether the mud motor stalls in the closing window, where there is one.
    pub fn motor_stalled(&self) -> Option<bool> {
        self.motor_stalled_fraction().map(|part| part > 0.0)
    }

    pub(super) fn lateral(&self) -> Option<LateralMeasures> {
        self.outcome.and_then(Outcome::lateral)
    }

    pub(super) fn lying(&self) -> Option<LyingMeasures> {
        self.lateral().and_then(|lateral| lateral.lying)
    }

    pub(super) fn shocks(&self) -> Option<ShockMeasures> {
        self.lateral().and_then(|lateral| lateral.shocks)
    }

    pub(super) fn sideways(&self) -> Option<InBand> {
        self.shocks().and_then(|shocks| shocks.sideways)
    }

    pub(super) fn tangential(&self) -> Option<InBand> {
        self.shocks().and_then(|shocks| shocks.tangential)
    }

    pub(super) fn axial_in_band(&self) -> Option<InBand> {
        (self.axial_acceleration()).and_then(|acceleration| acceleration.in_band)
    }

    pub(super) fn stress(&self) -> Option<StressMeasures> {
        self.outcome.and_then(|outcome| outcome.stress)
    }

    pub(super) fn axial(&self) -> Option<AxialMeasures> {
        self.outcome.and_then(Outcome::axial)
    }

    pub(super) fn axial_acceleration(&self) -> Option<AxialAcceleration> {
        self.axial().and_then(|axial| axial.acceleration)
    }

    pub(super) fn surface(&self) -> Option<SurfaceMeasures> {
        self.outcome.and_then(|outcome| outcome.surface)
    }

    pub(super) fn string_torque(&self) -> Option<StringTorque> {
        self.outcome.and_then(|outcome| outcome.string_torque)
    }

    pub(super) fn finer(&self, motion: Motion) -> Option<MotionVerdict> {
        self.record.finer.and_then(|finer| finer[motion])
    }

    pub(super) fn finer_label(&self, motion: Motion) -> Field<'static> {
        self.finer(motion).map(|it| it.label().name()).into()
    }

    pub(super) fn found_sites(&self) -> Field<'static> {
        let found = self.record.found.as_ref();
        let sites = found.map(|found| found.sites.iter().map(f64::to_string));
        let sites: Vec<String> = sites.into_iter().flatten().collect();
        sites.join(";").into()
    }
}

/// A metre in mm.
pub fn to_mm(length: f64) -> f64 {
    1e3 * length
}

/// A metre per second in metres per hour.
pub fn to_m_h(speed: f64) -> f64 {
    3600.0 * speed
}

/// An acceleration, m/s², in g.
pub fn to_g(acceleration: f64) -> f64 {
    acceleration / linear::well::GRAVITY
}

/// A newton in kN.
pub fn to_kn(force: f64) -> f64 {
    1e-3 * force
}

/// A newton metre in kN m.
pub fn to_kn_m(moment: f64) -> f64 {
    1e-3 * moment
}

/// A pascal in MPa.
pub fn to_mpa(stress: f64) -> f64 {
    1e-6 * stress
}

/// A radian per second in turns per second.
pub fn to_turns(rate: f64) -> f64 {
    rate / TAU
}

/// A radian per second in rpm.
pub fn to_rpm(speed: f64) -> f64 {
    speed / RPM
}
