//! What a command builds, steps and keeps, and what that takes.

use anyhow::Result;
use linear::Method;
use linear::budget::Need;
use linear::deviation::undershoot_need_within;
use linear::elements::reconstruction::WholeString;
use linear::estimates::undershoot_time;
use linear::method::FiniteElement;
use linear::parallel::threads;
use linear::sampling::need_for_fronts;
use sim::Trajectory;
use sim::laws::cutting::CutStep;

use super::Limit;
use crate::dependence;
use crate::design::Design;
use crate::engine::{StringMemory, Survey, setting_of, whole_string};
use crate::plan::{Setting, Sweep};
use crate::sweep_file::AutoOr;

/// Bytes of a mebibyte.
const MIB: f64 = 1024.0 * 1024.0;

/// What the program takes for itself, bytes; for each of its threads; and to draw.
const PROGRAM: f64 = 32.0 * MIB;
const THREAD: f64 = 2.0 * MIB;
const PICTURE: f64 = 48.0 * MIB;

/// What a picture takes for each site of which it has a panel, for each case and method of
/// which it has one, and for each shape of the string: pixels.
const SITE_SHOWN: f64 = 4.0 * MIB;
const CASE_SHOWN: f64 = 12.0 * MIB;
const SHAPE_SHOWN: f64 = 1.5 * MIB;

/// Memory that reading a sweep file takes for each of its bytes: most for `[[sites]]`, which are short.
const READ: f64 = 75.0;

/// What the allocator takes for every byte, some of it freed and not yet given back.
const ALLOCATOR: f64 = 1.1;

/// For each case and method what is noted of it, and for each case in a list its
/// values.
const NOTED: f64 = 0.5;
const LISTED: f64 = 96.0;

/// For each step of a history that is kept its line of a table and the points of its
/// curves: of the case, of each site, and of each site that moves laterally too.
const LINE: f64 = 96.0;
const SPEED: f64 = 48.0;
const MOTION: f64 = 192.0;

/// The same of a bit that cuts, with what is recorded of it: torque, weight, depth of cut, angle, depth
/// and that of the rock.
const DRILLED: f64 = 6.0 * SPEED + size_of::<CutStep>() as f64;

/// Distinct strings that are built at once, for each thread, where memory allows. Fewer
/// would leave threads without work at the end of each batch.
const STRINGS_PER_THREAD: usize = 4;

/// What systems are built for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Purpose {
    /// To step cases for their labels, one on each thread.
    Labels,
    /// To step a number of cases for their histories, which are all kept and drawn; of the first
    /// one a number of shapes of the whole string.
    Histories {
        /// How many.
        cases: usize,
        /// How many shapes.
        shapes: usize,
    },
    /// To be inspected.
    Look,
}

/// What a command builds.
#[derive(Debug, Clone)]
pub struct Demand<'a> {
    /// The sweep.
    pub sweep: &'a Sweep,
    /// What for.
    pub purpose: Purpose,
    /// By which methods.
    pub methods: Vec<Method>,
    /// The string as the file says it and, where axes change the string, that of its
    /// cases which takes most.
    /// Each with the longest time of its cases, s.
    pub strings: Vec<(Setting, f64)>,
    /// The mesh of the whole string, where its shape is to be shown.
    pub mesh: FiniteElement,
    /// Bytes taken to choose the sampling frequency, where the file gives none.
    pub choosing: f64,
}

/// What a command is going to take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The most at any time, bytes.
    pub bytes: f64,
    /// Distinct strings to build at once.
    pub strings_at_once: usize,
    /// Whether there is room to compare fronts with the exact ones.
    pub compares_fronts: bool,
    /// Whether there is room to simulate some cases again, to see what labels depend on.
    pub sees_dependences: bool,
}

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
    /// Where the values of the string that takes most make none.
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
            mesh: sweep.content.method.finite_element,
            choosing: match (sweep.content.sampling_frequency_hz, &setting.friction) {
                (AutoOr::Auto, None) if sweep.bit.is_some() => {
                    need_for_fronts(&sweep.setting.string).peak
                }
                _ => 0.0,
            },
        })
    }

    /// What it takes, with a number of the strings of its cases at once.
    pub fn cost(&self, strings_at_once: usize) -> Cost {
        let mut systems = Need::default();
        let mut case: f64 = 0.0;
        let mut times: f64 = 1.0;
        let mut too_long = None;
        for (index, (setting, longest)) in self.strings.iter().enumerate() {
            let string = StringMemory::of(self.sweep, setting, &self.methods, *longest);
            let count = if index == 0 { 1 } else { strings_at_once };
            systems = systems.then(string.systems.times(count));
            case = case.max(string.case);
            times = times.max(string.times);
            too_long = too_long.or(string.too_long);
        }
        let work = systems.then(self.use_of(case, times)).peak;
        let bytes = self.own() + ALLOCATOR * work.max(self.choosing);
        Cost { bytes, too_long }
    }

    /// What the program holds in any case.
    fn own(&self) -> f64 {
        let cases = self.sweep.design.cases() as f64;
        let noted = NOTED * self.simulations();
        let picture = match self.purpose {
            Purpose::Labels if self.sweep.map.is_none() => 0.0,
            Purpose::Labels | Purpose::Look => PICTURE,
            Purpose::Histories { cases, shapes } => PICTURE + self.largest_picture(cases, shapes),
        };
        let listed = match self.sweep.design {
            Design::List(_) => LISTED * cases,
            _ => 0.0,
        };
        let read = READ * self.sweep.source.bytes() as f64;
        PROGRAM + THREAD * threads() as f64 + picture + noted + listed + read
    }

    /// What the largest picture of histories takes, one part for each that it shows.
    fn largest_picture(&self, cases: usize, shapes: usize) -> f64 {
        let sites = self.strings[0].0.sites.len();
        let parts = [
            (SITE_SHOWN, sites),
            (CASE_SHOWN, cases * self.methods.len()),
            (SHAPE_SHOWN, shapes),
        ];
        let takes = parts.map(|(part, count)| part * count as f64);
        takes.into_iter().fold(0.0, f64::max)
    }

    fn simulations(&self) -> f64 {
        (self.sweep.design.cases() * self.methods.len()) as f64
    }

    /// Memory of the work with the systems, when a case takes `case` bytes and is followed up to a number of
    /// times as long.
    fn use_of(&self, case: f64, times: f64) -> Need {
        let (setting, longest) = &self.strings[0];
        let frequencies = self
            .methods
            .iter()
            .map(|method| setting.frequency_by(method));
        let steps = sim::plan::steps(times * longest, frequencies.fold(0.0, f64::max));
        let sites = setting.sites.len();
        let methods = self.methods.len() as f64;
        let of_site = match setting.lateral {
            Some(_) => SPEED + MOTION,
            None => SPEED,
        };
        let of_bit = match setting.cutting {
            Some(_) => DRILLED,
            None => 0.0,
        };
        let line = LINE + of_site * sites as f64 + of_bit;
        match self.purpose {
            Purpose::Labels => {
                let at_once = self.simulations().min(threads() as f64);
                Need::lasting(at_once * case)
            }
            Purpose::Histories { cases, shapes } => {
                let is_lateral = setting.lateral.is_some();
                let kept = Trajectory::bytes(sites, is_lateral, steps) + line * steps;
                let simulations = methods * cases as f64;
                if !is_lateral {
                    return Need::lasting(simulations * kept + case);
                }
                let whole = |shapes| {
                    let whole = whole_string(self.sweep, setting);
                    let parameters = self.mesh;
                    let meshed = whole.map(|whole| WholeString {
                        parameters,
                        ..whole
                    });
                    meshed.map_or(Need::default(), |whole| whole.need(shapes))
                };
                let (with_shapes, peaks) = (whole(shapes), whole(0).kept);
                let used = case.max(with_shapes.peak);
                Need::lasting(simulations * (kept + peaks) + used)
            }
            Purpose::Look => {
                let points = steps.max(setting.steps_shown() as f64);
                Need::lasting(methods * line * points)
            }
        }
    }

    /// With as many strings at once as a limit allows.
    pub fn within(&self, limit: &Limit) -> Estimate {
        let most = STRINGS_PER_THREAD * threads();
        let fits = |count: &usize| self.cost(*count).bytes <= limit.bytes;
        let strings_at_once = (1..=most).rev().find(fits).unwrap_or(1);
        let bytes = self.cost(strings_at_once).bytes;
        let fronts = self.bytes_with_fronts();
        let compares_fronts = fronts <= limit.bytes;
        let dependences = bytes + self.bytes_of_dependences();
        let sees_dependences = dependences <= limit.bytes;
        let optional = [(compares_fronts, fronts), (sees_dependences, dependences)];
        let taken = optional.into_iter().filter(|(fits, _)| *fits);
        Estimate {
            bytes: taken.map(|(_, bytes)| bytes).fold(bytes, f64::max),
            strings_at_once,
            compares_fronts,
            sees_dependences,
        }
    }

    /// Memory taken while fronts of the string are compared with the exact ones, next to its
    /// systems; nothing where no torque at the bit makes fronts.
    fn bytes_with_fronts(&self) -> f64 {
        let (setting, longest) = &self.strings[0];
        let compares = matches!(self.purpose, Purpose::Labels | Purpose::Look);
        if !compares || self.sweep.bit.is_none() || setting.friction.is_some() {
            return 0.0;
        }
        let string = StringMemory::of(self.sweep, setting, &self.methods, *longest);
        // A method may reach its undershoot as late as its response ends.
        let time = undershoot_time(&setting.string).max(*longest);
        let need = string
            .systems
            .then(undershoot_need_within(&setting.string, time));
        self.own() + ALLOCATOR * need.peak
    }

    /// What it takes in the end to see what labels depend on, in addition to what is there by then.
    fn bytes_of_dependences(&self) -> f64 {
        if self.purpose != Purpose::Labels {
            return 0.0;
        }
        let of_string =
            |(setting, longest): &(Setting, f64)| dependence::bytes(self.sweep, setting, *longest);
        ALLOCATOR * self.strings.iter().map(of_string).fold(0.0, f64::max)
    }
}
