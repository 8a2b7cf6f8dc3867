//! A sweep, ready to run: read from a file, or made from another by a choice.

use std::borrow::Cow;
use std::path::Path;

use linear::Method;

use super::bit::{self, Bit};
use super::certify;
use super::choice::{self, Choice};
use super::conditions::{self, Conditions};
use super::data::Data;
use super::map::{self, MapSettings};
use super::methods;
use super::setting::{Circumstances, Setting};
use super::start::{self, Starts};
use super::string;
use super::texts;
use crate::design::Design;
use crate::quantities::Axis;
use crate::sweep_file::{
    AutoOr, FileContent, MethodName, SheetNotes, SiteTable, SitesName, Source, SweepFileError,
    TextOf, TraceName, put_sections,
};
use crate::text_file::read_text;
use crate::words::{in_words, short};

/// No case lasts longer, s.
const LONGEST_CASE: f64 = 1e6;

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
    /// The places among them of the two that certify labels, in a run that does.
    pub certifying: Option<[usize; 2]>,
    /// What was chosen for the accuracy asked for.
    pub choice: Option<Choice>,
    /// How cases begin.
    pub starts: Starts,
    /// Time simulated, s; by default until the regime is decided.
    pub time: AutoOr,
    /// Torque at the bit, where it is modelled.
    pub bit: Option<Bit>,
    /// What the file says of the quantities that axes may change.
    pub conditions: Conditions,
    /// The cases.
    pub design: Design,
    /// How the map is drawn, where the design has two axes or more.
    pub map: Option<MapSettings>,
    /// What was made of a BHA sheet, where the string comes from one.
    pub sheet: Option<SheetNotes>,
    /// What the files that it names say.
    pub data: Data,
    /// The file as written, its bases merged in.
    pub content: FileContent,
    /// Where each of its keys stands.
    pub source: Source,
}

impl Sweep {
    /// Reads and resolves a sweep file.
    ///
    /// # Errors
    /// Where the file, a base or a list of cases does not make sense.
    pub fn read(path: &Path) -> Result<Self, SweepFileError> {
        Self::read_from(path, &[], &read_text)
    }

    /// The same from any source of texts, with these methods, if there are any, instead of the
    /// file's.
    ///
    /// # Errors
    /// As [`Sweep::read`], and where the file asks for an accuracy, which chooses the
    /// method.
    pub fn read_from(
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
        let sheet = put_sections(&mut source, text_of)?;
        let mut content: FileContent = source.parse()?;
        texts::check(&source, &content)?;
        let table = content.bit.as_ref();
        let bit = table.map(|bit| bit::resolve(&source, bit)).transpose()?;
        let weight_pushes = content.axial_force.is_some();
        let starts = start::resolve(&source, &content)?;
        if bit.is_some() {
            // However it was found: what a run means includes it.
            content.start = Some(starts.name);
        }
        let design = Design::resolve(&source, content.design.as_ref(), weight_pushes, text_of)?;
        let data = Data::read(&source, &content, &design, text_of)?;
        let conditions = conditions::resolve(&source, &content, data.fastest_surface_rpm())?;
        conditions::are_complete(&source, &content, &conditions, &design)?;
        if !source.gives_itself("name") {
            content.name = None;
        }
        let name = texts::name(&source, &content)?;
        if let AutoOr::Given(time) = content.time_s {
            source.within("time_s", time, 1e-3, LONGEST_CASE, "s")?;
        }
        // What was recorded is followed as long as it is.
        let time = match (content.time_s, &data.surface_speed) {
            (AutoOr::Auto, Some(recording)) => {
                let message = "the recording lasts longer than any case: give `time_s`";
                source.refuse_if(
                    recording.end() > LONGEST_CASE,
                    "surface_speed_file",
                    message,
                )?;
                AutoOr::Given(recording.end())
            }
            (time, _) => time,
        };
        string::check_damping(&source, &content, &design)?;
        let circumstances = Circumstances {
            data: &data,
            bit: bit.as_ref(),
            conditions: &conditions,
            design: &design,
        };
        let setting = Setting::resolve(&source, &content, &circumstances, (&[], None))?;
        if let (Some(table), Some(friction)) = (&mut content.string_friction, &setting.friction) {
            // However it was found.
            table.pieces = friction.pieces();
        }
        if !source.gives_within(["method", "finite-element"], "elements_per_cell") {
            let elements = methods::usual_elements(&setting.string);
            content.method.finite_element.elements_per_cell = elements;
        }
        let has_elements = content.methods.contains(&MethodName::FiniteElement);
        if has_elements && !source.gives_within(["method", "finite-element"], "gamma") {
            content.method.finite_element.gamma = methods::usual_gamma(&content);
        }
        if !source.gives("methods") && methods::is_by_poles(&content, &design, &setting) {
            content.methods = vec![MethodName::Poles];
        }
        string::check_axes(&source, &content, &design)?;
        if let Some(accuracy) = content.accuracy {
            let message = "with a bit that cuts and [wall], whose motion is often chaotic, no limit of whirl \
                           is held to: give `methods` and `sampling_frequency_hz` instead";
            let is_both = setting.cutting.is_some() && setting.lateral.is_some();
            source.refuse_if(is_both, "accuracy", message)?;
            choice::check(&source, accuracy)?;
        }
        if methods.is_empty() {
            certify::resolve(&source, &content)?;
        }
        let methods = methods::resolve(&source, &content, &design)?;
        let map = map::resolve(&source, &content, &design, &setting, bit.as_ref())?;
        Ok(Self {
            title: (content.title.clone()).unwrap_or_else(|| in_words(&name)),
            setting,
            methods,
            certifying: None,
            choice: None,
            map,
            name,
            starts,
            time,
            bit,
            conditions,
            design,
            sheet,
            data,
            content,
            source,
        })
    }

    /// The same sweep as a run has it, which certifies labels where it is asked to; other commands
    /// do not.
    ///
    /// # Errors
    /// Where the methods that it is left with cannot.
    pub fn for_run(self) -> Result<Self, SweepFileError> {
        Ok(Self {
            certifying: certify::resolve(&self.source, &self.content)?,
            ..self
        })
    }

    /// The same sweep with the method and the sampling frequency chosen for the
    /// accuracy asked for.
    ///
    /// # Errors
    /// Where they do not suit the string as the file says it.
    pub fn with_choice(self, method: Method, choice: Choice) -> Result<Self, SweepFileError> {
        let sampling_frequency = choice.chosen.sampling_frequency_hz;
        let mut content = self.content.clone();
        content.sampling_frequency_hz = AutoOr::Given(sampling_frequency);
        methods::put(&mut content, method);
        Ok(Self {
            setting: self.setting_sampled(&[], sampling_frequency)?,
            methods: vec![method],
            choice: Some(choice),
            content,
            ..self
        })
    }

    fn circumstances(&self) -> Circumstances<'_> {
        Circumstances {
            data: &self.data,
            bit: self.bit.as_ref(),
            conditions: &self.conditions,
            design: &self.design,
        }
    }

    /// Newmark's γ of elements in this scene.
    pub fn usual_gamma(&self) -> f64 {
        methods::usual_gamma(&self.content)
    }

    /// The sampling frequency (Hz) without one in the file.
    pub fn frequency_by_rule(&self) -> f64 {
        self.setting.frequency_by_rule(&self.circumstances())
    }

    /// The highest sampling frequency of its methods, Hz.
    pub fn highest_frequency(&self) -> f64 {
        let of_each = self.methods.iter();
        let of_each = of_each.map(|method| self.setting.frequency_by(method));
        of_each.fold(0.0, f64::max)
    }

    /// The sampling frequencies of its methods in words.
    pub fn frequencies_in_words(&self) -> String {
        let base = self.setting.sampling_frequency;
        let others = self.methods.iter().filter_map(|method| {
            let own = self.setting.frequency_by(method);
            (own > base).then(|| format!("{} Hz by {}", short(own), method.name()))
        });
        let all = std::iter::once(format!("{} Hz", short(base))).chain(others);
        all.collect::<Vec<_>>().join(", ")
    }

    /// The conditions of a case with the given values along the design's axes.
    pub fn conditions_at(&self, values: &[f64]) -> Conditions {
        self.conditions.along(self.design.axes(), values)
    }

    /// The conditions of the file, under the greatest weight on bit of the design where that is an axis.
    pub fn under_greatest_weight(&self) -> Conditions {
        let axis = Axis::WeightOnBitKn;
        match self.design.ends(axis) {
            Some([_, most]) => self.conditions.with(axis, most),
            None => self.conditions.clone(),
        }
    }

    /// The setting of a case with the given values along the design's axes.
    ///
    /// # Errors
    /// Where these values make no string.
    pub fn setting_at(&self, values: &[f64]) -> Result<Cow<'_, Setting>, SweepFileError> {
        let axes = self.design.axes().iter().copied();
        self.setting_with(axes.zip(values.iter().copied()))
    }

    /// Whether the torque that turns the surface is measured after each case; where the string
    /// rubs along its well, or its drive's torque is limited, it is followed anyway.
    pub fn measures_surface_torque(&self) -> bool {
        self.content.surface_torque && !self.content.follows_surface()
    }

    /// Whether the motion of every case is kept until its row is known.
    pub fn keeps_motion(&self) -> bool {
        let compares = !self.data.comparisons.is_empty();
        let measures_places = self.content.measures_stress() || !self.content.tools.is_empty();
        self.measures_surface_torque() || measures_places || compares
    }

    /// Whether the torque that turns the surface is to be found of motions that are kept.
    pub fn finds_surface_torque(&self) -> bool {
        let mut comparisons = self.data.comparisons.iter();
        let is_compared = comparisons.any(|it| it.trace == TraceName::SurfaceTorqueNm);
        let is_followed = self.content.follows_surface();
        self.measures_surface_torque() || is_compared && !is_followed
    }

    /// Whether an axis changes the string.
    pub fn changes_string(&self, axis: Axis) -> bool {
        axis.changes_string(self.content.axial_force.is_some())
    }

    /// The setting with some quantities that change the string given, all at once; of one given
    /// twice the last value counts. Other axes do not matter here.
    ///
    /// # Errors
    /// As [`Sweep::setting_at`].
    pub fn setting_with(
        &self,
        values: impl Iterator<Item = (Axis, f64)>,
    ) -> Result<Cow<'_, Setting>, SweepFileError> {
        let changing = values.filter(|(axis, _)| self.changes_string(*axis));
        let changed: Vec<(Axis, f64)> = changing.collect();
        if changed.is_empty() {
            return Ok(Cow::Borrowed(&self.setting));
        }
        self.changed_setting(changed, &[]).map(Cow::Owned)
    }

    /// A setting with sites that were `found`, by their distances from the bit (m), in place of
    /// those that it was found with.
    ///
    /// # Errors
    /// Where no wall can be at one of them.
    pub fn setting_with_sites(
        &self,
        setting: &Setting,
        found: &[f64],
    ) -> Result<Setting, SweepFileError> {
        let resolved = self.changed_setting(setting.changed.clone(), found)?;
        Ok(Setting {
            steps_per_travel: setting.steps_per_travel,
            whirl_rate: setting.whirl_rate,
            ..resolved.sampled_at(setting.sampling_frequency)
        })
    }

    /// The setting with quantities of the string changed, and with sites that were `found`.
    fn changed_setting(
        &self,
        changed: Vec<(Axis, f64)>,
        found: &[f64],
    ) -> Result<Setting, SweepFileError> {
        let (content, conditions) = self.changed(&changed)?;
        let circumstances = Circumstances {
            conditions: &conditions,
            ..self.circumstances()
        };
        let place = (found, self.setting.steps_per_travel);
        let setting = Setting::resolve(&self.source, &content, &circumstances, place)?;
        Ok(Setting { changed, ..setting })
    }

    /// What the file says, with some quantities that change the string given.
    fn changed(&self, values: &[(Axis, f64)]) -> Result<(FileContent, Conditions), SweepFileError> {
        let (mut content, mut conditions) = (self.content.clone(), self.conditions.clone());
        for &(axis, value) in values {
            if let Axis::String(of_string) = axis {
                let changed = content.set(of_string, value);
                self.source.checked(&axis.name(), changed)?;
            } else {
                conditions = conditions.with(axis, value);
            }
        }
        content.take_along(&self.content.sites);
        Ok((content, conditions))
    }

    /// The setting with some quantities given, of a string that nothing disturbs and that has its
    /// sites at these distances from the bit (m), instead of those of the file: the wall at each is
    /// that of all sites.
    ///
    /// # Errors
    /// As [`Sweep::setting_at`], and where a place is not on the string, or has no wall.
    pub fn setting_touching_at(
        &self,
        distances_from_bit: &[f64],
        values: &[(Axis, f64)],
    ) -> Result<Setting, SweepFileError> {
        // Friction is part of every case.
        let values = [values, &[(Axis::FRICTION, 0.0)]].concat();
        let (mut content, conditions) = self.changed(&values)?;
        content.impulses.clear();
        content.eccentric_masses.clear();
        content.tools.clear();
        let sites = distances_from_bit.iter().copied();
        content.sites = sites.map(SiteTable::at).collect();
        if let Some(wall) = &mut content.wall {
            wall.sites = SitesName::Given;
            (wall.sites_every_m, wall.sites_to_m) = (None, None);
            (wall.sites_tolerance_mm, wall.sites_rounds) = (None, None);
        }
        let circumstances = Circumstances {
            conditions: &conditions,
            design: &Design::one_case(),
            ..self.circumstances()
        };
        let place: (&[f64], _) = (&[], self.setting.steps_per_travel);
        Setting::resolve(&self.source, &content, &circumstances, place)
    }

    /// The setting of a case with the given values along the design's axes, sampled
    /// at another frequency (Hz).
    ///
    /// # Errors
    /// As [`Sweep::setting_at`], and where it samples an impulse too coarsely.
    pub fn setting_sampled(
        &self,
        values: &[f64],
        sampling_frequency: f64,
    ) -> Result<Setting, SweepFileError> {
        let setting = self.setting_at(values)?.sampled_at(sampling_frequency);
        setting.check_sampling(&self.source, self.bit.is_some())?;
        Ok(setting)
    }

    /// Refuses an impulse that begins when a case is over: its label would say
    /// nothing of the impulse.
    ///
    /// # Errors
    /// Names the impulse.
    pub fn impulses_are_felt(&self, case: usize, duration: f64) -> Result<(), SweepFileError> {
        for (index, impulse) in self.content.impulses.iter().enumerate() {
            let (key, start) = (format!("impulses[{index}].start_s"), impulse.start_s);
            let message = format!("{start} s is not before the end of case {case}, {duration} s");
            self.source.refuse_if(start >= duration, &key, message)?;
        }
        Ok(())
    }
}
