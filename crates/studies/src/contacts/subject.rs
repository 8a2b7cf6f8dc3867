//! A string of the study, and what is asked of it.

use anyhow::{Context, Result};
use linear::Method;
use thiserror::Error;

use super::blow::Blow;
use super::places::Range;
use campaign::accuracy::trial;
use campaign::engine::{Case, Recipe, StringMemory};
use campaign::plan::{Conditions, ImpulseAmount, ImpulseSettings, LateralSettings, Setting, Sweep};
use campaign::quantities::Axis;
use campaign::sweep_file::SweepFileError;

/// A blow lasts as long as those of the paper, s.
const BLOW_DURATION: f64 = 0.02;

/// It begins so long after the surface has come to its speed, s.
const BLOW_START: f64 = 1.0;

/// Contacts are not nearer than this, m.
const LEAST_SPACING: f64 = 0.01;

/// More contacts than these are more than anybody waits for.
const MOST_CONTACTS: usize = 1000;

/// Where contacts go without being told, m from the bit: the collars and the lower pipe of both
/// strings.
const USUAL_END: f64 = 200.0;

/// A string of the study, and what is asked of it.
#[derive(Debug, Clone)]
pub struct Subject {
    /// Its name.
    pub name: String,
    /// The sweep whose string, wall and surface speed these are, and whose methods step it.
    pub sweep: Sweep,
    /// What is given besides the file, and by its first case.
    pub values: Vec<(Axis, f64)>,
    /// Where contacts are.
    pub range: Range,
    /// Numbers of contacts.
    pub counts: Vec<usize>,
    /// Where it is knocked, m from the bit.
    pub knocked_at: Vec<f64>,
    /// How hard, in multiples of I₀.
    pub knocks: Vec<f64>,
    /// How hard it is hit all along, N s per metre.
    pub blows: Vec<f64>,
    /// Time simulated, s, where it is not the file's.
    pub time: Option<f64>,
    /// Sampling frequency, Hz, where it is not the file's.
    pub sampling_frequency: Option<f64>,
}

/// What is not asked of a string.
#[derive(Debug, Error)]
pub enum SubjectError {
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
    /// A place to knock at is not on the string.
    #[error("a knock {at} m from the bit: the string has the places from 0 to {length} m")]
    KnockOffString {
        /// Where, m from the bit.
        at: f64,
        /// Its length, m.
        length: f64,
    },
    /// Steps are too long for a blow.
    #[error("{frequency} Hz: a blow of {BLOW_DURATION} s takes two samples at least")]
    Sampling {
        /// Sampling frequency, Hz.
        frequency: f64,
    },
    /// The case ends before the blow can have done anything.
    #[error("{time} s: the blow begins at {start} s, and the last {window} s are judged")]
    Time {
        /// Time simulated, s.
        time: f64,
        /// When the blow begins, s.
        start: f64,
        /// What is judged, s.
        window: f64,
    },
}

impl Subject {
    /// Where the range of contacts ends (m from the bit) without being told, on a sweep's string
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
            return Err(SubjectError::OffString { from, to, length }.into());
        }
        for &count in &self.counts {
            let most = MOST_CONTACTS;
            if !(1..=most).contains(&count) {
                return Err(SubjectError::Count { count, most }.into());
            }
            let length = self.range.length();
            if length / (count as f64) < LEAST_SPACING {
                return Err(SubjectError::TooNear { count, length }.into());
            }
        }
        for &at in &self.knocked_at {
            if !(0.0..length).contains(&at) {
                return Err(SubjectError::KnockOffString { at, length }.into());
            }
        }
        let setting = self.touching_at(&[from])?;
        let frequency = setting.sampling_frequency;
        if !frequency.is_finite() || frequency * BLOW_DURATION < 2.0 {
            return Err(SubjectError::Sampling { frequency }.into());
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
    /// Where that is too short for a blow to show what it does.
    pub fn duration(&self, setting: &Setting) -> Result<f64> {
        let timing = self.case(setting, 0.0)?.scene.timing;
        let (time, start) = (timing.duration, blow_start(setting));
        let window = timing.closing_window;
        if time.is_finite() && time >= start + window {
            return Ok(time);
        }
        let reason = SubjectError::Time {
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

    /// Where it is hit, m from the bit: by knocks, and by blows along the range.
    pub fn hit_places(&self) -> [Vec<f64>; 2] {
        [self.knocked_at.clone(), Blow::places_along(&self.range)]
    }

    /// All that it is hit with: knocks, by their places, and blows along the range.
    ///
    /// # Errors
    /// Where there is no I₀ to measure knocks by.
    pub fn blows(&self) -> Result<[Vec<Blow>; 2]> {
        let mut knocks = Vec::new();
        for &from_bit in &self.knocked_at {
            let least_impulse = self.least_impulse(from_bit)?;
            let knock = |ratio: &f64| Blow::knock(from_bit, *ratio, least_impulse);
            knocks.extend(self.knocks.iter().map(knock));
        }
        let range = self.range;
        let along = self
            .blows
            .iter()
            .map(|&per_metre| Blow::Along { per_metre, range });
        Ok([knocks, along.collect()])
    }

    /// I₀ of a place, N s: whatever else may touch, it is what brings a free string to the wall.
    fn least_impulse(&self, from_bit: f64) -> Result<f64> {
        let mut setting = self.touching_at(&[from_bit])?;
        let start = blow_start(&setting);
        if let Some(lateral) = &mut setting.lateral {
            lateral.impulses = vec![impulse(0, 0.0, start)];
        }
        let method = self.sweep.methods.first().context("a sweep has a method")?;
        // A free string swings out within seconds of the knock.
        let system = Recipe::alone(&setting, *method, false, start + 10.0).build()?;
        let least = system.least_impulses.first().copied();
        let least = least.filter(|least| least.is_finite());
        least.with_context(|| format!("no knock {from_bit} m from the bit brings it to the wall"))
    }

    /// Memory that a method takes with sites at these places on so many threads, bytes: an upper
    /// bound.
    ///
    /// # Errors
    /// As [`Subject::touching_at`].
    pub fn memory(&self, places: &[f64], method: Method, threads: usize) -> Result<f64> {
        let setting = self.touching_at(places)?;
        let time = self.duration(&setting)?;
        let of_system = StringMemory::of(&self.sweep, &setting, &[method], time);
        let steps = sim::plan::steps(time, setting.sampling_frequency);
        let recorded = sim::Trajectory::bytes(places.len(), true, steps);
        Ok(of_system.systems.peak + threads as f64 * of_system.case + recorded)
    }
}

/// When a blow begins, s.
pub fn blow_start(setting: &Setting) -> f64 {
    setting.profile.rise() + BLOW_START
}

/// An impulse on a site of this amount (N s) and beginning (s).
pub fn impulse(site: usize, amount: f64, start: f64) -> ImpulseSettings {
    ImpulseSettings {
        site,
        amount: ImpulseAmount::NewtonSeconds(amount),
        start,
        duration: BLOW_DURATION,
        direction: 0.0,
    }
}
