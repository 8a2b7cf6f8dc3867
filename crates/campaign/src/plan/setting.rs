//! What a linear system is built from: the string, where it is observed, and how fast it is
//! sampled. A sweep has one, or one for each value of the axes that change the string.

use std::borrow::Cow;

use linear::estimates::torsional_travel_time;
use linear::{Drillstring, Method, Sites};
use sim::{MudMotor, SurfaceProfile};
use statics::{LyingString, StaticsError};

use super::axial_force::Hanging;
use super::bit::{Bit, Cut};
use super::conditions::Conditions;
use super::contacts::StringInHole;
use super::cutting::{self, CuttingSettings};
use super::data::Data;
use super::lateral::{self, LateralSettings};
use super::lying::{self, Lying};
use super::motor;
use super::string_friction::{self, StringFriction};
use super::{axial_force, drive_limit, hole, sampling, sites, string, tools, top_drive, whirl};
use crate::design::Design;
use crate::quantities::Axis;
use crate::sweep_file::{AutoOr, FileContent, Source, SweepFileError};

/// Time for which a response to a step at the surface is shown, in round trips of a wave.
const ROUND_TRIPS_SHOWN: f64 = 5.0;

/// What was recorded is known for this time after the last step of a case, s: its acceleration is
/// taken around that.
const AFTER_THE_LAST: f64 = 1.0;

/// What a setting depends on besides its string.
#[derive(Clone, Copy)]
pub(super) struct Circumstances<'a> {
    pub data: &'a Data,
    pub bit: Option<&'a Bit>,
    pub conditions: &'a Conditions,
    pub design: &'a Design,
}

impl<'a> Circumstances<'a> {
    /// The bit with all conditions under which it turns.
    fn cut(&self) -> Option<Cut<'a>> {
        let (conditions, design) = (self.conditions, self.design);
        self.bit.map(|bit| Cut {
            bit,
            conditions,
            design,
        })
    }
}

/// A string, ready to be built.
#[derive(Debug, Clone)]
pub struct Setting {
    /// The drillstring.
    pub string: Drillstring,
    /// Sites from the surface down; the bit, where it is one, is the last.
    pub sites: Sites,
    /// Sampling frequency, Hz.
    pub sampling_frequency: f64,
    /// Its steps per travel time of a wave, where it follows from them; `None` where it is
    /// given.
    pub steps_per_travel: Option<f64>,
    /// The greatest rate of whirl to expect in any case, turns a second; `None` without a wall.
    pub whirl_rate: Option<f64>,
    /// How the surface turns, in parts of the speed of a case.
    pub profile: SurfaceProfile,
    /// Inertia of a rotor that is held at that speed at any torque, kg m².
    pub rotor_inertia: f64,
    /// The greatest torque of its drive, where that is a law, N m.
    pub drive_limit: Option<f64>,
    /// Friction along the string, where that is modelled.
    pub friction: Option<StringFriction>,
    /// How it hangs, where its axial force is modelled.
    pub hanging: Option<Hanging>,
    /// What it lies in, where the course of the well is known and it may touch its wall.
    pub lying: Option<Lying>,
    /// Lateral motion, where it is modelled.
    pub lateral: Option<LateralSettings>,
    /// Axial motion above a bit that cuts, where it is modelled.
    pub cutting: Option<CuttingSettings>,
    /// What turns the bit against the end of the string, where that has a motor.
    pub motor: Option<MudMotor>,
    /// Where tools feel accelerations, m from the bit, from the surface down; nothing where these are
    /// measured at the sites, and at the bit.
    pub tools: Vec<f64>,
    /// The bands of these tools, Hz.
    pub tool_bands: Vec<f64>,
    /// What axes or a command line change of the string in the file.
    pub changed: Vec<(Axis, f64)>,
}

impl Setting {
    /// What labels and measures need of this: without a wall only the bit has any, and places that
    /// are only observed are left to drawings.
    pub fn for_labels(&self) -> Cow<'_, Self> {
        // Friction has its own nodes, independent of those observed.
        if self.lateral.is_some() || self.friction.is_some() || self.sites.len() == 1 {
            return Cow::Borrowed(self);
        }
        Cow::Owned(Self {
            sites: Sites::bit(),
            ..self.clone()
        })
    }

    /// Samples of a response to a step that are shown, even for short cases.
    pub fn steps_shown(&self) -> usize {
        let shown = ROUND_TRIPS_SHOWN * 2.0 * torsional_travel_time(&self.string);
        (shown * self.sampling_frequency).ceil() as usize
    }

    /// The string as it lies in its hole under the conditions of a case, where the course of its well
    /// is known; its bit held as is said, or else as in a case.
    ///
    /// # Errors
    /// Where sites are too close to each other.
    pub fn lying_string(
        &self,
        conditions: &Conditions,
        bit: Option<statics::Bit>,
    ) -> Option<Result<LyingString, StaticsError>> {
        let (lying, lateral) = (self.lying.as_ref()?, self.lateral.as_ref()?);
        Some(lying.string((&self.string, &self.sites), lateral, (conditions, bit)))
    }

    /// String as it lies at rest, which may touch between its sites, too.
    ///
    /// # Errors
    /// As [`Self::lying_string`].
    pub fn resting_string(
        &self,
        conditions: &Conditions,
        bit: Option<statics::Bit>,
    ) -> Option<Result<LyingString, StaticsError>> {
        let (lying, lateral) = (self.lying.as_ref()?, self.lateral.as_ref()?);
        Some(lying.resting_string((&self.string, &self.sites), lateral, (conditions, bit)))
    }

    /// The dynamic coefficients of friction of its walls, from the surface down, where it has walls
    /// and all are known.
    pub fn sliding_frictions(&self, conditions: &Conditions) -> Option<Vec<f64>> {
        lying::frictions(self.lateral.as_ref()?, conditions)
    }

    /// What a string without stiffness in bending presses on its hole with up to a distance from the
    /// bit (m), shared out to the nearest of some places (m from the bit, from the surface down), N;
    /// none where the course of the well is not known.
    pub fn soft_forces(&self, conditions: &Conditions, places: (&[f64], f64)) -> Option<Vec<f64>> {
        let (lying, lateral) = (self.lying.as_ref()?, self.lateral.as_ref()?);
        Some(lying.soft_forces(&self.string, (lateral, conditions), places))
    }

    /// The same, sampled at another frequency, Hz.
    pub fn sampled_at(&self, sampling_frequency: f64) -> Self {
        Self {
            sampling_frequency,
            steps_per_travel: None,
            ..self.clone()
        }
    }

    /// The setting that a file describes, with sites that were `found`, by their distances from
    /// the bit (m), and with steps per travel time that were `counted` on another string.
    ///
    /// # Errors
    /// Where a key of it is refused.
    pub(super) fn resolve(
        source: &Source,
        content: &FileContent,
        circumstances: &Circumstances,
        (found, counted): (&[f64], Option<f64>),
    ) -> Result<Self, SweepFileError> {
        let &Circumstances {
            data,
            conditions,
            design,
            ..
        } = circumstances;
        let string = string::resolve(source, content)?;
        let (string, mud, hole) = hole::resolve(source, content, string)?;
        let (string, rotor_inertia) = top_drive::resolve(source, content, string)?;
        let drive_limit = drive_limit::resolve(source, content)?;
        let (key, rise) = ("surface_speed_rise_s", content.surface_speed_rise_s);
        let rise = source.within(key, rise, 0.0, 1e4, "s")?;
        let profile = match (&data.surface_speed, conditions.surface_speed_rpm) {
            (Some(recorded), Some(fastest)) => {
                let part = |speed: f64| speed / fastest;
                let needed = match content.time_s {
                    AutoOr::Given(time) => recorded.until(time + AFTER_THE_LAST),
                    AutoOr::Auto => recorded.clone(),
                };
                SurfaceProfile::Recorded(needed.map(part))
            }
            _ => SurfaceProfile::Rise(rise),
        };
        let in_hole = StringInHole {
            string: &string,
            sections: &content.string.sections,
            hole: &hole,
            drills: content.bit.is_some(),
        };
        let places = sites::resolve(source, content, &in_hole, found)?;
        let lateral = lateral::resolve(
            source,
            content,
            &in_hole,
            (&places, found),
            conditions,
            design,
        )?;
        let sites = match &lateral {
            Some(lateral) => lateral::carrying(source, content, lateral, places.sites)?,
            None => places.sites,
        };
        let (tools, tool_bands) = tools::resolve(source, content, &string, &sites)?;
        let ends = lying::finds_sites(content).then(|| sites::ends(content, &in_hole));
        let (string, hanging) = axial_force::resolve(
            source,
            content,
            (data, mud),
            (conditions, design),
            string,
            lateral.as_ref(),
        )?;
        if let (Some(ends), Some(lateral)) = (ends, &lateral) {
            // Where sites are to be found and it buckles between those that it has, it needs some to lie on.
            let has_ends = ends.iter().all(|end| found.contains(end));
            if !has_ends && lying::buckles_between(&string, lateral, &sites) {
                let mut found = [found, &ends].concat();
                found.sort_by(f64::total_cmp);
                found.dedup();
                return Self::resolve(source, content, circumstances, (&found, counted));
            }
        }
        let (string, lateral, sites) = lying::held(source, content, (string, lateral, sites))?;
        let lying = lying::resolve(source, content, (data, mud), &string, lateral.as_ref())?;
        let friction = string_friction::resolve(
            source,
            content,
            (data, mud),
            (conditions, design),
            &string,
            &sites,
        )?;
        let cutting = cutting::resolve(source, content, &string)?;
        let motor = motor::resolve(source, content)?;
        let needs = sampling::Needs {
            cut: circumstances.cut(),
            lateral: lateral.as_ref(),
            friction: friction.as_ref(),
            blades: cutting.as_ref().map(|cutting| cutting.blades()),
            motor,
        };
        let (sampling_frequency, steps_per_travel) =
            sampling::resolve(source, content, &string, &needs, counted)?;
        if let (Some(cutting), Some(cut)) = (&cutting, circumstances.cut()) {
            let fastest = sampling::fastest_bit(&cut, motor);
            cutting.check_sampling(source, fastest, sampling_frequency)?;
        }
        let whirl_rate = lateral.as_ref().map(|lateral| {
            whirl::greatest_rate((&string, &sites, lateral), motor, (conditions, design))
        });
        let setting = Self {
            string,
            sites,
            sampling_frequency,
            steps_per_travel,
            whirl_rate,
            profile,
            rotor_inertia,
            drive_limit,
            friction,
            hanging,
            lying,
            lateral,
            cutting,
            motor,
            tools,
            tool_bands,
            changed: Vec::new(),
        };
        // For an accuracy another frequency is chosen.
        if content.accuracy.is_none() {
            setting.check_sampling(source, content.bit.is_some())?;
        }
        Ok(setting)
    }

    /// The sampling frequency of a method, Hz: that of all, or more where the file gives none and whirl needs it.
    pub fn frequency_by(&self, method: &Method) -> f64 {
        let rate = self.whirl_rate.filter(|_| self.steps_per_travel.is_some());
        let needed = rate.map_or(0.0, |rate| {
            (whirl::steps_of_turn(method.name()) * rate).min(whirl::MOST_HZ)
        });
        self.sampling_frequency.max(needed)
    }

    /// The setting as a method is sampled.
    pub fn by(&self, method: &Method) -> Cow<'_, Self> {
        let frequency = self.frequency_by(method);
        match frequency > self.sampling_frequency {
            true => Cow::Owned(self.sampled_at(frequency)),
            false => Cow::Borrowed(self),
        }
    }

    /// Steps in a turn of the fastest whirl to expect, as a method is sampled; `None` where there is none.
    pub fn steps_of_whirl(&self, method: &Method) -> Option<f64> {
        let rate = self.whirl_rate.filter(|rate| *rate > 0.0)?;
        Some(self.frequency_by(method) / rate)
    }

    /// Whether Eq. 74 may say where the bit sticks: of one whose law gives its torque, and that turns
    /// with the end of a string that is linear.
    pub fn has_stick_slip_limit(&self) -> bool {
        self.cutting.is_none() && self.motor.is_none() && self.drive_limit.is_none()
    }

    /// The lateral part of a string that hangs in the middle of its hole: limits of whirl are those
    /// of such a string.
    pub fn hanging_sideways(&self) -> Option<&LateralSettings> {
        self.lateral.as_ref().filter(|_| self.lying.is_none())
    }

    /// The same where all that may touch turns with the string, as those limits take it: a bit below a
    /// motor turns faster.
    pub fn whirling_with_string(&self) -> Option<&LateralSettings> {
        let bit_is_faster = self.motor.is_some() && self.sites.bit_site().is_some();
        self.hanging_sideways().filter(|_| !bit_is_faster)
    }

    /// How late the controller of its drive answers, s.
    pub fn drive_delay(&self) -> f64 {
        self.string.top_drive().map_or(0.0, |drive| drive.delay)
    }

    /// Refuses a frequency at which nothing is felt of an impulse, or of a wave on its way; `cuts`
    /// says whether a torque acts on the bit.
    pub(super) fn check_sampling(&self, source: &Source, cuts: bool) -> Result<(), SweepFileError> {
        sampling::check(
            source,
            (&self.string, self.lateral.as_ref()),
            cuts || self.friction.is_some(),
            self.sampling_frequency,
        )
    }

    /// The sampling frequency, Hz, of a file that does not give one.
    pub(super) fn frequency_by_rule(&self, circumstances: &Circumstances) -> f64 {
        let needs = sampling::Needs {
            cut: circumstances.cut(),
            lateral: self.lateral.as_ref(),
            friction: self.friction.as_ref(),
            blades: self.cutting.as_ref().map(|cutting| cutting.blades()),
            motor: self.motor,
        };
        sampling::by_rule(&self.string, &needs)
    }
}
