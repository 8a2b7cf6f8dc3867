//! A string of the study, and what is asked of it.

use anyhow::{Context, Result};
use linear::Method;
use thiserror::Error;

use super::impulse::LateralImpulse;
use super::places::Range;
use campaign::accuracy::trial;
use campaign::engine::{Case, Recipe, StringMemory};
use campaign::plan::{Conditions, ImpulseAmount, ImpulseSettings, LateralSettings, Setting, Sweep};
use campaign::quantities::Axis;
use campaign::sweep_file::SweepFileError;

/// Duration of an impulse, that of the paper, s.
const IMPULSE_DURATION: f64 = 0.02;

/// Delay of the impulse after the surface has reached its speed, s.
const IMPULSE_START: f64 = 1.0;

/// Contacts are not nearer than this, m.
const LEAST_SPACING: f64 = 0.01;

/// More contacts would take too long.
const MOST_CONTACTS: usize = 1000;

/// Where contacts end by default, m from the bit: the collars and the lower pipe of both strings.
const USUAL_END: f64 = 200.0;

/// A string of the study, and what is asked of it.
#[derive(Debug, Clone)]
pub struct StudiedString {
    /// Its name.
    pub name: String,
    /// The sweep whose string, wall and surface speed these are, and whose methods step it.
    pub sweep: Sweep,
    /// Values given in addition to the file, and those of its first case.
    pub values: Vec<(Axis, f64)>,
    /// Where contacts are.
    pub range: Range,
    /// Numbers of contacts.
    pub counts: Vec<usize>,
    /// Places of local impulses, m from the bit.
    pub struck_at: Vec<f64>,
    /// Their amounts, in multiples of I₀.
    pub ratios: Vec<f64>,
    /// Amounts of distributed impulses, N s per metre.
    pub per_metre: Vec<f64>,
    /// Time simulated, s, where it is not the file's.
    pub time: Option<f64>,
    /// Sampling frequency, Hz, where it is not the file's.
    pub sampling_frequency: Option<f64>,
}

/// What is not asked of a string.
#[derive(Debug, Error)]
pub enum StudiedStringError {
    /// The range is not on the string.
    #[error("from {from} m to {to} m from the bit: the string has the places from 0 to {length} m")]
    OffString {
        /// Lower end, m.
        from: f64,
        /// Upper end, m.
        to: f64,
        /// Its length, m.
        length: f64,
    },
    /// It is no number of contacts that can be simulated.
    #[error("{count} contacts: at least one is needed, and {most} at most")]
    Count {
        /// How many were asked for.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// Contacts would be nearer than they can be.
    #[error("{count} contacts within {length} m are nearer than {LEAST_SPACING} m")]
    TooNear {
        /// How many were asked for.
        count: usize,
        /// Length of the range, m.
        length: f64,
    },
    /// The place of an impulse is not on the string.
    #[error("an impulse {at} m from the bit: the string has the places from 0 to {length} m")]
    ImpulseOffString {
        /// Where, m from the bit.
        at: f64,
        /// Its length, m.
        length: f64,
    },
    /// Steps are too long for an impulse.
    #[error("{frequency} Hz: an impulse of {IMPULSE_DURATION} s takes two samples at least")]
    Sampling {
        /// Sampling frequency, Hz.
        frequency: f64,
    },
    /// The case ends before the impulse can have done anything.
    #[error("{time} s: the impulse begins at {start} s, and the last {window} s are judged")]
    Time {
        /// Time simulated, s.
        time: f64,
        /// When the impulse begins, s.
        start: f64,
        /// What is judged, s.
        window: f64,
    },
}

impl StudiedString {
    /// Where the range of contacts ends by default (m from the bit), on a sweep's string
    /// with these values.
    ///
    /// # Errors
    /// Where they make no string.
    pub fn usual_end(sweep: &Sweep, values: &[(Axis, f64)]) -> Result<f64, SweepFileError> {
        let setting = sweep.setting_with(values.iter().copied())?;
        Ok(setting.string.length().min(USUAL_END))
    }

    /// What of its file's first case the study takes: sites are its own, and so are their walls.
    pub fn first_values(sweep: &Sweep) -> impl Iterator<Item = (Axis, f64)> {
        let values = sweep.design.values(0).into_iter();
        let axes = sweep.design.axes().iter().copied();
        let is_kept = |axis: &Axis| !matches!(axis, Axis::WallAtSite { .. } | Axis::ImpulseRatio);
        axes.zip(values).filter(move |(axis, _)| is_kept(axis))
    }

    /// Refuses what cannot be asked of the string.
    ///
    /// # Errors
    /// What it is.
    pub fn check(&self) -> Result<()> {
        let Range { from, to } = self.range;
        let values = self.values.iter().copied();
        let length = self.sweep.setting_with(values)?.string.length();
        if !(0.0 <= from && from < to && to <= length) {
            return Err(StudiedStringError::OffString { from, to, length }.into());
        }
        for &count in &self.counts {
            let most = MOST_CONTACTS;
            if !(1..=most).contains(&count) {
                return Err(StudiedStringError::Count { count, most }.into());
            }
            let length = self.range.length();
            if length / (count as f64) < LEAST_SPACING {
                return Err(StudiedStringError::TooNear { count, length }.into());
            }
        }
        for &at in &self.struck_at {
            if !(0.0..length).contains(&at) {
                return Err(StudiedStringError::ImpulseOffString { at, length }.into());
            }
        }
        let setting = self.touching_at(&[from])?;
        let frequency = setting.sampling_frequency;
        if !frequency.is_finite() || frequency * IMPULSE_DURATION < 2.0 {
            return Err(StudiedStringError::Sampling { frequency }.into());
        }
        self.lateral(&setting)?;
        self.duration(&setting)?;
        Ok(())
    }

    /// The setting with sites at these places, m from the bit.
    ///
    /// # Errors
    /// Where one is not on the string or has no wall.
    pub fn touching_at(&self, places: &[f64]) -> Result<Setting, SweepFileError> {
        let mut setting = self.sweep.setting_touching_at(places, &self.values)?;
        if let Some(frequency) = self.sampling_frequency {
            setting = setting.sampled_at(frequency);
        }
        if let Some(lateral) = &mut setting.lateral {
            let conditions = self.conditions();
            for wall in &mut lateral.walls {
                // The study's own site, and not that of the file with its number.
                wall.site = None;
                *wall = wall.in_case(&conditions);
            }
        }
        Ok(setting)
    }

    /// The lateral part of a setting.
    ///
    /// # Errors
    /// Where the file has none.
    pub fn lateral<'a>(&self, setting: &'a Setting) -> Result<&'a LateralSettings, SweepFileError> {
        setting.lateral.as_ref().ok_or_else(|| {
            let message = "is needed: a string without a wall, or a table [string.bending], \
                           touches nothing";
            self.sweep.source.error("wall", message)
        })
    }

    /// What is simulated of each case, s.
    ///
    /// # Errors
    /// Where that is too short to show the effect of an impulse.
    pub fn duration(&self, setting: &Setting) -> Result<f64> {
        let timing = self.case(setting, 0.0)?.scene.timing;
        let (time, start) = (timing.duration, impulse_start(setting));
        let window = timing.closing_window;
        if time.is_finite() && time >= start + window {
            return Ok(time);
        }
        let reason = StudiedStringError::Time {
            time,
            start,
            window,
        };
        Err(reason.into())
    }

    /// The case at a friction, before anything hits the string.
    ///
    /// # Errors
    /// Where the file says too little of it.
    pub fn case(&self, setting: &Setting, friction: f64) -> Result<Case> {
        let conditions = self.conditions().with(Axis::FRICTION, friction);
        let mut case = trial::case(&self.sweep, setting, &conditions)?;
        let timing = &mut case.scene.timing;
        timing.duration = self.time.unwrap_or(timing.duration);
        Ok(case)
    }

    /// What the cases have in common.
    pub fn conditions(&self) -> Conditions {
        let conditions = self.sweep.conditions.clone();
        (self.values.iter()).fold(conditions, |all, (axis, value)| all.with(*axis, *value))
    }

    /// Places of impulses, m from the bit: of local ones, and of those along the range.
    pub fn hit_places(&self) -> [Vec<f64>; 2] {
        [
            self.struck_at.clone(),
            LateralImpulse::places_along(&self.range),
        ]
    }

    /// All impulses: local ones, by their places, and those along the range.
    ///
    /// # Errors
    /// Where I₀, the unit of local impulses, is unknown.
    pub fn impulses(&self) -> Result<[Vec<LateralImpulse>; 2]> {
        let mut local = Vec::new();
        for &from_bit in &self.struck_at {
            let least_impulse = self.least_impulse(from_bit)?;
            let of_ratio = |ratio: &f64| LateralImpulse::local(from_bit, *ratio, least_impulse);
            local.extend(self.ratios.iter().map(of_ratio));
        }
        let range = self.range;
        let along = self
            .per_metre
            .iter()
            .map(|&per_metre| LateralImpulse::Distributed { per_metre, range });
        Ok([local, along.collect()])
    }

    /// I₀ of a place, N s: what brings a string that touches nowhere else to the wall.
    fn least_impulse(&self, from_bit: f64) -> Result<f64> {
        let mut setting = self.touching_at(&[from_bit])?;
        let start = impulse_start(&setting);
        if let Some(lateral) = &mut setting.lateral {
            lateral.impulses = vec![impulse_settings(0, 0.0, start)];
        }
        let method = self.sweep.methods.first().context("a sweep has a method")?;
        // A free string reaches its largest displacement within seconds of the impulse.
        let system = Recipe::alone(&setting, *method, false, start + 10.0).build()?;
        let least = system.least_impulses.first().copied();
        let least = least.filter(|least| least.is_finite());
        least.with_context(|| format!("no impulse {from_bit} m from the bit brings it to the wall"))
    }

    /// Memory that a method takes with sites at these places on a number of threads, bytes: an
    /// upper bound.
    ///
    /// # Errors
    /// As [`StudiedString::touching_at`].
    pub fn memory(&self, places: &[f64], method: Method, threads: usize) -> Result<f64> {
        let setting = self.touching_at(places)?;
        let time = self.duration(&setting)?;
        let of_system = StringMemory::of(&self.sweep, &setting, &[method], time);
        let steps = sim::plan::steps(time, setting.sampling_frequency);
        let recorded = sim::Trajectory::bytes(places.len(), true, steps);
        Ok(of_system.systems.peak + threads as f64 * of_system.case + recorded)
    }
}

/// When an impulse begins, s.
pub fn impulse_start(setting: &Setting) -> f64 {
    setting.profile.rise() + IMPULSE_START
}

/// An impulse on a site of this amount (N s) and beginning (s).
pub fn impulse_settings(site: usize, amount: f64, start: f64) -> ImpulseSettings {
    ImpulseSettings {
        site,
        amount: ImpulseAmount::NewtonSeconds(amount),
        start,
        duration: IMPULSE_DURATION,
        direction: 0.0,
    }
}
