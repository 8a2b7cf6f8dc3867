//! From the keys of a sweep file to what the model needs, in SI; every value
//! checked against what it can be.

use std::path::Path;

use linear::method::{FiniteElement, Method};
use linear::{BuildError, Drillstring, Sites};
use serde::{Deserialize, Serialize};
use sim::laws::rock::RockError;
use sim::{BitTorque, Rock};

use super::file::{AutoOr, FileContent, MethodName};
use super::setting::Setting;
use super::source::{Source, SweepFileError, TextOf};
use crate::accuracy::Choice;
use crate::design::Design;
use crate::printable::steers;
use crate::quantities::{Axis, within};
use crate::text_file::read_text;

/// More elements in a cell resolve no more than rounding leaves.
const MOST_ELEMENTS_PER_CELL: usize = 10_000;

const RPM: f64 = std::f64::consts::TAU / 60.0;

/// A sweep, ready to run.
#[derive(Debug, Clone)]
pub struct Sweep {
    /// The file's name without its ending; names the results folder.
    pub name: String,
    /// One line for pictures.
    pub title: String,
    /// What the linear system is built from, but for axes of the string.
    pub setting: Setting,
    /// Linear methods.
    pub methods: Vec<Method>,
    /// What was chosen for the accuracy asked for.
    pub choice: Option<Choice>,
    /// Time simulated.
    pub time: Time,
    /// Torque at the bit, where it is modelled.
    pub bit: Option<Bit>,
    /// What the file says of the quantities that axes may change.
    pub conditions: Conditions,
    /// The cases.
    pub design: Design,
    /// How the map is drawn, where the design has two axes or more.
    pub map: Option<MapSettings>,
    /// The file as written, its bases merged in.
    pub content: FileContent,
    /// Where each of its keys stands.
    pub source: Source,
}

/// Time simulated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Time {
    /// Until the regime can be told.
    Auto,
    /// As given, s.
    Given(f64),
}

/// The bit's torque law, but for the quantities that axes may change.
#[derive(Debug, Clone, PartialEq)]
pub struct Bit {
    /// From weight on bit to T_d.
    pub rock: Option<Rock>,
    /// T_s / T_d.
    pub static_ratio: f64,
}

/// Operating conditions of a case, in the units of their names.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Conditions {
    /// Surface speed, rpm.
    pub surface_speed_rpm: Option<f64>,
    /// Weight on bit, kN.
    pub weight_on_bit_kn: Option<f64>,
    /// Dynamic torque, N m.
    pub torque_dynamic_nm: Option<f64>,
    /// Lateral impulse in multiples of I₀, by an axis.
    pub impulse_ratio: Option<f64>,
    /// Friction of the wall, by an axis.
    pub friction: Option<f64>,
}

impl Conditions {
    /// These conditions with one of them changed. Weight on bit and torque
    /// replace one another.
    pub fn with(mut self, axis: Axis, value: f64) -> Self {
        match axis {
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm = Some(value),
            Axis::WeightOnBitKn => {
                self.weight_on_bit_kn = Some(value);
                self.torque_dynamic_nm = None;
            }
            Axis::TorqueDynamicNm => {
                self.torque_dynamic_nm = Some(value);
                self.weight_on_bit_kn = None;
            }
            Axis::ImpulseRatio => self.impulse_ratio = Some(value),
            Axis::Friction => self.friction = Some(value),
            // Part of the setting.
            Axis::String(_) => {}
        }
        self
    }

    /// The value along an axis, where it is known.
    pub fn value(&self, axis: Axis) -> Option<f64> {
        match axis {
            Axis::SurfaceSpeedRpm => self.surface_speed_rpm,
            Axis::WeightOnBitKn => self.weight_on_bit_kn,
            Axis::TorqueDynamicNm => self.torque_dynamic_nm,
            Axis::ImpulseRatio => self.impulse_ratio,
            Axis::Friction => self.friction,
            Axis::String(_) => None,
        }
    }

    /// Surface speed, rad/s.
    pub fn surface_speed(&self) -> Option<f64> {
        self.surface_speed_rpm.map(|speed| speed * RPM)
    }
}

/// How the regime map is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapSettings {
    /// Axis to the right.
    pub x: Axis,
    /// Axis upwards.
    pub y: Axis,
    /// Cases pointed out.
    pub marks: Vec<MapMark>,
}

/// A case pointed out on the map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapMark {
    /// What is written beside it.
    pub name: String,
    /// Its value along the axis to the right.
    pub x: f64,
    /// Its value along the axis upwards.
    pub y: f64,
}

/// A radian per second in rpm.
pub fn to_rpm(speed: f64) -> f64 {
    speed / RPM
}

impl Bit {
    /// T_d (N m) under the given conditions, where they say enough; the error
    /// is a sentence.
    pub fn torque_dynamic(&self, conditions: &Conditions) -> Result<Option<f64>, String> {
        match (
            conditions.torque_dynamic_nm,
            conditions.weight_on_bit_kn,
            &self.rock,
        ) {
            (Some(torque), _, _) => Ok(Some(torque)),
            (None, Some(weight), Some(rock)) => rock
                .torque_dynamic(1e3 * weight)
                .map(Some)
                .map_err(|error| {
                    let RockError::OutsideTable {
                        value, from, to, ..
                    } = error
                    else {
                        return error.to_string();
                    };
                    let [value, from, to] = [value, from, to].map(|weight| weight / 1e3);
                    format!(
                        "{value} kN is outside the rock's table, {from} to {to} kN; \
                         it must reach as far as the weights"
                    )
                }),
            _ => Ok(None),
        }
    }

    /// Both torque limits for a dynamic torque.
    pub fn torques(&self, torque_dynamic: f64) -> BitTorque {
        BitTorque {
            torque_static: self.static_ratio * torque_dynamic,
            torque_dynamic,
        }
    }
}

impl Sweep {
    /// The conditions of a case with the given values along the design's axes.
    pub fn conditions_at(&self, values: &[f64]) -> Conditions {
        let axes = self.design.axes().iter().zip(values);
        axes.fold(self.conditions, |conditions, (&axis, &value)| {
            conditions.with(axis, value)
        })
    }

    /// Reads and resolves a sweep file.
    ///
    /// # Errors
    /// Where the file, a base or a list of cases does not make sense.
    pub fn read(path: &Path) -> Result<Self, SweepFileError> {
        Self::read_with_methods(path, &[])
    }

    /// As [`Sweep::read`], with these methods, if there are any, in place of the
    /// file's, whatever those are.
    ///
    /// # Errors
    /// As [`Sweep::read`], and where the file asks for an accuracy, which chooses the
    /// method.
    pub fn read_with_methods(path: &Path, methods: &[MethodName]) -> Result<Self, SweepFileError> {
        Self::resolve(path, methods, &read_text)
    }

    /// As [`Sweep::read`], from any source of texts.
    ///
    /// # Errors
    /// As [`Sweep::read`].
    pub fn read_from(path: &Path, text_of: TextOf) -> Result<Self, SweepFileError> {
        Self::resolve(path, &[], text_of)
    }

    fn resolve(
        path: &Path,
        methods: &[MethodName],
        text_of: TextOf,
    ) -> Result<Self, SweepFileError> {
        let mut source = Source::read(path, text_of)?;
        if !methods.is_empty() {
            if source.gives("accuracy") {
                let message = "asks for an accuracy, which chooses the method: leave out --methods";
                return Err(source.error("accuracy", message));
            }
            let names = methods.iter().map(|method| method.name().into());
            source.put("methods", toml::Value::Array(names.collect()));
        }
        let content: FileContent = source.parse()?;
        let check = Check { source: &source };
        check.texts(&content)?;
        let bit = content.bit.as_ref().map(|bit| check.bit(bit)).transpose()?;
        let conditions = check.conditions(&content)?;
        let design = Design::resolve(&source, content.design.as_ref(), text_of)?;
        check.conditions_are_complete(bit.as_ref(), &conditions, &design)?;
        let name = path.file_stem().map_or_else(
            || "sweep".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        );
        let time = match content.time_s {
            AutoOr::Auto => Time::Auto,
            AutoOr::Given(value) => {
                check.within("time_s", value, 1e-3, 1e6, "s")?;
                Time::Given(value)
            }
        };
        let setting = Setting::resolve(&source, &content, &conditions, &design)?;
        check.string_axes(&content, &design)?;
        if let Some(accuracy) = content.accuracy {
            check.accuracy(accuracy)?;
        }
        let methods = check.methods(&content, methods.is_empty())?;
        let map = check.map(&content, &design, bit.as_ref())?;
        Ok(Self {
            title: content.title.clone().unwrap_or_else(|| name.clone()),
            setting,
            methods,
            choice: None,
            map,
            name,
            time,
            bit,
            conditions,
            design,
            content,
            source,
        })
    }
}

/// Checks of meaning, each naming the key it is about.
pub(super) struct Check<'a> {
    pub(super) source: &'a Source,
}

impl Check<'_> {
    pub(super) fn within(
        &self,
        key: &str,
        value: f64,
        least: f64,
        most: f64,
        unit: &str,
    ) -> Result<(), SweepFileError> {
        self.source.checked(key, within(value, least, most, unit))
    }

    /// What people read in pictures and in a terminal.
    fn texts(&self, content: &FileContent) -> Result<(), SweepFileError> {
        let sections = content
            .string
            .sections
            .iter()
            .enumerate()
            .map(|(index, section)| {
                (
                    format!("string.sections[{index}].name"),
                    section.name.as_deref(),
                )
            });
        let marks = content.map.marks.iter().enumerate();
        let marks = marks
            .map(|(index, mark)| (format!("map.marks[{index}].name"), Some(mark.name.as_str())));
        let title = ("title".to_owned(), content.title.as_deref());
        for (key, text) in std::iter::once(title).chain(sections).chain(marks) {
            if let Some(letter) = text.and_then(|text| text.chars().find(|&letter| steers(letter)))
            {
                let code = u32::from(letter);
                let message = format!("has the control character U+{code:04X}: leave it out");
                return Err(self.source.error(&key, message));
            }
        }
        Ok(())
    }

    pub(super) fn sites(
        &self,
        content: &FileContent,
        string: &Drillstring,
    ) -> Result<Sites, SweepFileError> {
        // Without a wall, the bit is always looked at.
        let mut distances = vec![0.0];
        if content.wall.is_some() {
            distances.clear();
            let bit_is_site = (content.sites.iter()).any(|site| site.distance_from_bit_m == 0.0);
            if content.sites.is_empty() || (content.bit.is_some() && !bit_is_site) {
                let message = "a wall needs [[sites]] where it may be touched, \
                               the bit among them if it cuts";
                let key = if content.sites.is_empty() {
                    "wall"
                } else {
                    "sites"
                };
                return Err(self.source.error(key, message));
            }
        }
        // How many distances there are with each site.
        let mut counts = Vec::with_capacity(content.sites.len());
        for site in &content.sites {
            if content.wall.is_some() || site.distance_from_bit_m != 0.0 {
                distances.push(site.distance_from_bit_m);
            }
            counts.push(distances.len());
        }
        Sites::new(string, &distances).map_err(|error| {
            // The first site with which there is an error is to blame.
            let error_with = |count: usize| Sites::new(string, &distances[..count]).err();
            let index = counts.partition_point(|&count| error_with(count).is_none());
            let blamed = counts.get(index).and_then(|&count| error_with(count));
            let key = format!("sites[{index}].distance_from_bit_m");
            self.source.error(&key, blamed.unwrap_or(error).to_string())
        })
    }

    /// The methods. Parameters of the others are looked at too where the file names
    /// its methods itself.
    fn methods(&self, content: &FileContent, by_file: bool) -> Result<Vec<Method>, SweepFileError> {
        if content.methods.is_empty() {
            return Err(self.source.error("methods", "names no method"));
        }
        let counts = |name: MethodName| by_file || content.methods.contains(&name);
        if counts(MethodName::FiniteElement) {
            self.finite_element(&content.method.finite_element)?;
        }
        for (name, transform) in [
            (MethodName::Hilbert, content.method.hilbert),
            (MethodName::DirectIdft, content.method.direct_idft),
        ] {
            if let Some(seconds) = transform.seconds.filter(|_| counts(name)) {
                let key = name.name();
                self.within(
                    &format!("method.{key}.transform_s"),
                    seconds,
                    1e-2,
                    1e5,
                    "s",
                )?;
            }
        }
        for (index, name) in content.methods.iter().enumerate() {
            if content.methods[..index].contains(name) {
                return Err(self
                    .source
                    .error(&format!("methods[{index}]"), "is named twice"));
            }
            let needs_damping = matches!(name, MethodName::Hilbert | MethodName::DirectIdft);
            if needs_damping && content.string.torsional_damping_nms_rad_m == 0.0 {
                let error = BuildError::NeedsDamping {
                    method: name.name(),
                };
                let key = "string.torsional_damping_nms_rad_m";
                return Err(self.source.error(key, error.to_string()));
            }
        }
        Ok(content
            .methods
            .iter()
            .map(|&name| content.method(name))
            .collect())
    }

    fn finite_element(&self, parameters: &FiniteElement) -> Result<(), SweepFileError> {
        parameters.check().map_err(|error| {
            let key = match &error {
                BuildError::Parameter { name, .. } => format!("method.finite-element.{name}"),
                _ => "method.finite-element".to_owned(),
            };
            self.source.error(&key, error.to_string())
        })?;
        let elements = parameters.elements_per_cell;
        if elements > MOST_ELEMENTS_PER_CELL {
            let message = format!("{elements} are more than {MOST_ELEMENTS_PER_CELL}");
            let key = "method.finite-element.elements_per_cell";
            return Err(self.source.error(key, message));
        }
        Ok(())
    }

    /// An axis of the string must have something to change.
    fn string_axes(&self, content: &FileContent, design: &Design) -> Result<(), SweepFileError> {
        for &axis in design.axes() {
            if let Axis::String(string_axis) = axis {
                let key = format!("design.axes.{}", axis.name());
                let changed = content.clone().set(string_axis, axis.most());
                self.source.checked(&key, changed)?;
            }
        }
        Ok(())
    }

    fn conditions(&self, content: &FileContent) -> Result<Conditions, SweepFileError> {
        let bit = content.bit.as_ref();
        let conditions = Conditions {
            surface_speed_rpm: content.surface_speed_rpm,
            weight_on_bit_kn: bit.and_then(|bit| bit.weight_on_bit_kn),
            torque_dynamic_nm: bit.and_then(|bit| bit.torque_dynamic_nm),
            ..Conditions::default()
        };
        for (key, axis) in [
            ("surface_speed_rpm", Axis::SurfaceSpeedRpm),
            ("bit.weight_on_bit_kn", Axis::WeightOnBitKn),
            ("bit.torque_dynamic_nm", Axis::TorqueDynamicNm),
        ] {
            if let Some(value) = conditions.value(axis) {
                self.source.check_axis(key, axis, value)?;
            }
        }
        if conditions.weight_on_bit_kn.is_some() && conditions.torque_dynamic_nm.is_some() {
            let message = "give the torque itself or a weight on bit, not both";
            return Err(self.source.error("bit.torque_dynamic_nm", message));
        }
        Ok(conditions)
    }

    /// Every case must know its surface speed and, with a bit, its torque.
    fn conditions_are_complete(
        &self,
        bit: Option<&Bit>,
        conditions: &Conditions,
        design: &Design,
    ) -> Result<(), SweepFileError> {
        let has = |axis| conditions.value(axis).is_some() || design.axes().contains(&axis);
        if !has(Axis::SurfaceSpeedRpm) {
            let message = "is needed: give a number, or make it an axis of the design";
            return Err(self.source.error("surface_speed_rpm", message));
        }
        let torque = design
            .axes()
            .iter()
            .find(|axis| matches!(axis, Axis::WeightOnBitKn | Axis::TorqueDynamicNm));
        let Some(bit) = bit else {
            return torque.map_or(Ok(()), |axis| {
                let message = format!("the axis {} needs a table [bit]", axis.name());
                Err(self.source.error("design", message))
            });
        };
        if has(Axis::WeightOnBitKn) && bit.rock.is_none() {
            let message = "a weight on bit needs a rock to give a torque: \
                           `sandstone`, `shale`, `law` or `table`";
            return Err(self.source.error("bit.rock", message));
        }
        if design.axes().contains(&Axis::WeightOnBitKn)
            && design.axes().contains(&Axis::TorqueDynamicNm)
        {
            let message = "weight on bit and torque cannot both be axes: one gives the other";
            return Err(self.source.error("design", message));
        }
        if !has(Axis::WeightOnBitKn) && !has(Axis::TorqueDynamicNm) {
            let message = "needs `torque_dynamic_nm`, or a rock and `weight_on_bit_kn`, \
                           or one of them as an axis of the design";
            return Err(self.source.error("bit", message));
        }
        Ok(())
    }
}

impl FileContent {
    /// A method with the parameters this file gives it.
    pub fn method(&self, name: MethodName) -> Method {
        match name {
            MethodName::Hilbert => Method::Hilbert(self.method.hilbert),
            MethodName::Quadrature => Method::Quadrature,
            MethodName::FiniteElement => Method::FiniteElement(self.method.finite_element),
            MethodName::DirectIdft => Method::DirectIdft(self.method.direct_idft),
            MethodName::Trapezoidal => Method::Trapezoidal,
        }
    }
}
