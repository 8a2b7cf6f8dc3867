//! What a command builds, steps and keeps, and what that takes.

use anyhow::Result;
use linear::Method;
use linear::cost::{self, Memory};
use rayon::current_num_threads;

use super::Limit;
use crate::design::Design;
use crate::engine::{StringMemory, Survey, setting_of};
use crate::spec::{Setting, Sweep};

/// Bytes of a mebibyte.
const MIB: f64 = 1024.0 * 1024.0;

/// What the program takes for itself: its code, fonts and pictures, tables being
/// written, bytes; and for each of its threads.
const PROGRAM: f64 = 64.0 * MIB;
const THREAD: f64 = 2.0 * MIB;

/// For each case and method what is noted of it, and for each case in a list its
/// values.
const NOTED: f64 = 0.5;
const LISTED: f64 = 96.0;

/// For each step of a history that is kept its line of a table and the points of its
/// curves, and the same for each site.
const LINE: f64 = 128.0;
const LINE_OF_SITE: f64 = 256.0;

/// Distinct strings that are built at once, for each thread, where memory allows. Fewer
/// would leave threads without work at the end of each batch.
const STRINGS_PER_THREAD: usize = 4;

/// What systems are built for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Purpose {
    /// To step cases for their labels, one on each thread.
    Labels,
    /// To step so many cases for their histories, which are all kept and drawn.
    Histories(usize),
    /// To be looked at.
    Look,
}

/// What a command builds.
#[derive(Debug, Clone)]
pub struct Demand<'a> {
    pub sweep: &'a Sweep,
    pub purpose: Purpose,
    pub methods: Vec<Method>,
    /// The string as the file says it and, where axes change the string, that of its
    /// cases which takes most.
    pub strings: Vec<(Setting, Longest)>,
}

/// The longest time of a string's cases, s.
pub type Longest = f64;

/// What a demand takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cost {
    /// Bytes at most.
    pub bytes: f64,
    /// The longest response, where no method gives one so long.
    pub too_long: Option<f64>,
}

impl<'a> Demand<'a> {
    /// Of a command that builds `setting`.
    ///
    /// # Errors
    /// Never but where a string that was surveyed cannot be.
    pub fn of(
        sweep: &'a Sweep,
        setting: &Setting,
        survey: &Survey,
        purpose: Purpose,
    ) -> Result<Self> {
        let mut strings = vec![(setting.clone(), survey.longest)];
        if let (Purpose::Labels, Some(heaviest)) = (purpose, survey.heaviest) {
            let setting = setting_of(sweep, heaviest.string)?;
            strings.push((setting.for_labels().into_owned(), heaviest.longest));
        }
        Ok(Self {
            sweep,
            purpose,
            methods: sweep.methods.clone(),
            strings,
        })
    }

    /// What it takes, with so many of the strings of its cases at once.
    pub fn cost(&self, strings_at_once: usize) -> Cost {
        let mut systems = Memory::default();
        let mut case: f64 = 0.0;
        let mut too_long = None;
        for (index, (setting, longest)) in self.strings.iter().enumerate() {
            let string = self.memory_of(setting, *longest);
            let count = if index == 0 { 1 } else { strings_at_once };
            for _ in 0..count {
                systems = systems.beside(string.systems);
            }
            case = case.max(string.case);
            too_long = too_long.or(string.too_long);
        }
        let bytes = self.own() + systems.then(self.use_of(case)).peak;
        Cost { bytes, too_long }
    }

    fn memory_of(&self, setting: &Setting, longest: f64) -> StringMemory {
        StringMemory::of(setting, &self.methods, self.sweep.bit.is_some(), longest)
    }

    /// What the program holds whatever it builds.
    fn own(&self) -> f64 {
        let cases = self.sweep.design.cases() as f64;
        let noted = NOTED * cases * self.methods.len() as f64;
        let listed = match self.sweep.design {
            Design::List(_) => LISTED * cases,
            _ => 0.0,
        };
        PROGRAM + THREAD * current_num_threads() as f64 + noted + listed
    }

    /// What is done with the systems, when a case takes `case` bytes.
    fn use_of(&self, case: f64) -> Memory {
        let (setting, longest) = &self.strings[0];
        let steps = sim::cost::steps(*longest, setting.sampling_frequency);
        let sites = setting.sites.len();
        let methods = self.methods.len() as f64;
        let line = LINE + LINE_OF_SITE * sites as f64;
        match self.purpose {
            Purpose::Labels => Memory::lasting(current_num_threads() as f64 * case),
            Purpose::Histories(cases) => {
                let kept = sim::cost::trajectory(sites, steps) + line * steps;
                let parameters = &self.sweep.content.method.finite_element;
                let whole = cost::reconstruction(&setting.string, &setting.sites, parameters);
                let whole = if setting.lateral.is_some() { whole } else { 0.0 };
                Memory::lasting(methods * cases as f64 * kept + case.max(whole))
            }
            Purpose::Look => Memory::lasting(methods * line * steps),
        }
    }
}

/// How many of the strings of its cases may be built at once, within a limit.
pub fn strings_at_once(demand: &Demand, limit: &Limit) -> usize {
    let most = STRINGS_PER_THREAD * current_num_threads();
    let fits = |count: &usize| demand.cost(*count).bytes <= limit.bytes;
    (1..=most).rev().find(fits).unwrap_or(1)
}
