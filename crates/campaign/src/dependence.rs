//! What labels depend on that is no property of the well: the method, the sampling frequency, and
//! the start. A few cases of a sweep are simulated again, each with one of these changed.

use anyhow::Result;
use linear::{Method, parallel};
use serde::{Deserialize, Serialize};

use crate::engine::{
    Case, FINER, MethodSystem, Record, RunOptions, StringMemory, answer, setting_of,
};
use crate::labels::Labels;
use crate::plan::{Setting, Starts, Sweep};
use crate::sweep_file::StartName;
use crate::words::{counted, short};

/// One case in this number is simulated again,
const ONE_IN: usize = 25;

/// but no fewer than the first of these, where there are as many, and no more than the second.
const CASES: [usize; 2] = [12, 64];

/// A case with a wall, or with friction along the string, may take seconds: of a few cases no
/// more than one in this number is simulated again.
const ONE_IN_OF_FEW: usize = 4;

/// Where axes change the string, systems are built for every case: no more than for these.
const MOST_STRINGS: usize = 16;

/// A part of the labels from which on their change is warned of,
const WARNED_PART: f64 = 0.1;

/// and the fewest labels.
const WARNED_CASES: usize = 2;

/// What is changed of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// The linear method, to that of a name.
    Method(String),
    /// The sampling frequency, Hz, of the string as the file says it.
    SamplingFrequencyHz(f64),
    /// The start.
    Start(StartName),
}

/// How many labels of the first method change with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dependence {
    /// What is changed.
    pub change: Change,
    /// Cases that have an answer both ways.
    pub cases: usize,
    /// Those of them with another label.
    pub changed: usize,
}

impl Dependence {
    /// Whether it is worth a warning. Where the start decides, both labels are right.
    pub fn is_warned_of(&self) -> bool {
        let part = self.changed as f64 / self.cases.max(1) as f64;
        self.changed >= WARNED_CASES && part >= WARNED_PART
    }

    /// What is to be said of it.
    pub fn words(&self) -> String {
        let Self {
            change,
            cases,
            changed,
        } = self;
        let how = match change {
            Change::Method(method) => format!("by {method}"),
            Change::SamplingFrequencyHz(frequency) => format!("at {} Hz", short(*frequency)),
            Change::Start(StartName::Smooth) => "begun in smooth rotation".to_owned(),
            Change::Start(_) => "begun with the bit held".to_owned(),
        };
        let what_to_do = match change {
            Change::Method(method) => {
                format!(": add `{method}` to `methods`, and the map shows where, or set `accuracy`")
            }
            Change::SamplingFrequencyHz(_) => {
                ": raise `sampling_frequency_hz`, or set `accuracy`".to_owned()
            }
            Change::Start(_) => ": `start = \"both\"` shows where".to_owned(),
        };
        let of = counted(*cases, "sampled case");
        let advice = if self.is_warned_of() { &what_to_do } else { "" };
        format!("{how}, {changed} of {of} have another label{advice}")
    }
}

/// How often labels by the first method of a sweep change with the method, the sampling
/// frequency and the start. A variant that a method does not treat is left out.
pub fn dependences(sweep: &Sweep, options: RunOptions) -> Vec<Dependence> {
    let cases = sampled(sweep);
    let variants = variants(sweep);
    let strings: Vec<Vec<usize>> = match sweep.design.varies_string() {
        true => cases.into_iter().map(|case| vec![case]).collect(),
        false => vec![cases],
    };
    // One string after the other, for their memory.
    let of_string = |cases: &Vec<usize>| {
        let of_string = OfString::new(sweep, cases, options);
        let counted = |variant| of_string.as_ref().ok().and_then(|it| it.count(variant));
        variants.iter().map(counted).collect::<Vec<_>>()
    };
    let counts: Vec<Vec<Option<[usize; 2]>>> = strings.iter().map(of_string).collect();
    let total = |place: usize| {
        let of_strings = counts.iter().filter_map(|counts| counts[place]);
        of_strings.reduce(|[all, changed], [more, others]| [all + more, changed + others])
    };
    (variants.iter().enumerate())
        .filter_map(|(place, variant)| {
            let [cases, changed] = total(place)?;
            Some(Dependence {
                change: variant.change.clone(),
                cases,
                changed,
            })
        })
        .collect()
}

/// Memory, bytes, that this takes for cases of a setting up to the longest time (s), beside what a
/// run keeps: an upper bound.
pub fn bytes(sweep: &Sweep, setting: &Setting, longest_time: f64) -> f64 {
    let of_variant = |variant: Variant| {
        let setting = variant.setting(setting);
        let memory = StringMemory::of(sweep, &setting, &[variant.method], longest_time);
        memory.systems.peak + parallel::threads() as f64 * memory.case
    };
    variants(sweep)
        .into_iter()
        .map(of_variant)
        .fold(0.0, f64::max)
}

/// Cases spread over a design: multiples of the golden ratio, modulo one, leave no gaps and
/// follow no row or column of a grid.
fn sampled(sweep: &Sweep) -> Vec<usize> {
    let all = sweep.design.cases();
    let [fewest, most] = CASES;
    let setting = &sweep.setting;
    let is_slow = setting.lateral.is_some() || setting.friction.is_some();
    let few = if is_slow {
        all.div_ceil(ONE_IN_OF_FEW)
    } else {
        all
    };
    let mut count = (all / ONE_IN).clamp(fewest, most).min(few);
    if sweep.design.varies_string() {
        count = count.min(MOST_STRINGS);
    }
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let place = |index: usize| ((index as f64 + 0.5) * golden).fract();
    let mut cases: Vec<usize> = (0..count)
        .map(|index| ((place(index) * all as f64) as usize).min(all - 1))
        .collect();
    cases.sort_unstable();
    cases.dedup();
    cases
}

/// A sweep with one thing changed.
struct Variant {
    change: Change,
    method: Method,
    starts: Starts,
}

impl Variant {
    /// A setting sampled as the variant is.
    fn setting(&self, setting: &Setting) -> Setting {
        match self.change {
            Change::SamplingFrequencyHz(_) => {
                setting.sampled_at(FINER * setting.sampling_frequency)
            }
            Change::Method(_) | Change::Start(_) => setting.clone(),
        }
    }
}

fn variants(sweep: &Sweep) -> Vec<Variant> {
    let (method, starts) = (sweep.methods[0], sweep.starts);
    let finer = FINER * sweep.setting.sampling_frequency;
    let parameters = sweep.content.method.finite_element;
    let others = [
        Method::Held,
        Method::Quadrature,
        Method::FiniteElement(parameters),
    ];
    // Where the string rubs it is in pieces, which waves held over a step are not.
    let is_in_pieces = sweep.setting.friction.is_some();
    let other = (others.into_iter())
        .find(|other| other.name() != method.name() && !(is_in_pieces && *other == Method::Held));
    let by_other = other.map(|other| Variant {
        change: Change::Method(other.name().to_owned()),
        method: other,
        starts,
    });
    let at_finer = Variant {
        change: Change::SamplingFrequencyHz(finer),
        method,
        starts,
    };
    let begun_otherwise = starts.otherwise(&sweep.content).map(|starts| Variant {
        change: Change::Start(starts.name),
        method,
        starts,
    });
    (by_other.into_iter())
        .chain([at_finer])
        .chain(begun_otherwise)
        .collect()
}

/// Cases of one string, and their records as a run has them.
struct OfString<'a> {
    sweep: &'a Sweep,
    setting: Setting,
    options: RunOptions,
    cases: &'a [usize],
    records: Vec<Option<Record>>,
}

impl<'a> OfString<'a> {
    fn new(sweep: &'a Sweep, cases: &'a [usize], options: RunOptions) -> Result<Self> {
        let string = sweep.design.string_of(cases[0]);
        let setting = setting_of(sweep, string)?.for_labels().into_owned();
        let mut of_string = Self {
            sweep,
            setting,
            options,
            cases,
            records: Vec::new(),
        };
        let (setting, method) = (of_string.setting.clone(), sweep.methods[0]);
        of_string.records = of_string.records(sweep, &setting, method)?;
        Ok(of_string)
    }

    /// Cases with an answer both ways, and those with another label; none where no method treats
    /// the variant.
    fn count(&self, variant: &Variant) -> Option<[usize; 2]> {
        let mut sweep = self.sweep.clone();
        sweep.starts = variant.starts;
        let setting = variant.setting(&self.setting);
        let others = self.records(&sweep, &setting, variant.method).ok()?;
        let labels = |record: &Option<Record>| {
            let outcome = record.as_ref()?.outcome.as_ref().ok()?;
            Some(Labels::of(outcome))
        };
        let pairs = self.records.iter().zip(&others);
        let both: Vec<_> = pairs
            .filter_map(|(one, other)| Some((labels(one)?, labels(other)?)))
            .collect();
        let differ = both.iter().filter(|(one, other)| one != other);
        Some([both.len(), differ.count()])
    }

    fn records(
        &self,
        sweep: &Sweep,
        setting: &Setting,
        method: Method,
    ) -> Result<Vec<Option<Record>>> {
        let cases: Vec<Option<Case>> = (self.cases.iter())
            .map(|&index| Case::of(sweep, setting, index).ok())
            .collect();
        let durations = cases
            .iter()
            .flatten()
            .map(|case| case.scene.timing.duration);
        let longest = durations.fold(0.0, f64::max);
        let system = MethodSystem::build_for(sweep, setting, method, longest)?;
        anyhow::ensure!(system.instability().is_none(), "it would chatter");
        Ok(parallel::map(cases.len(), 1, |place| {
            let case = cases[place].as_ref()?;
            Some(answer(&system, case, 0, self.options, sweep))
        }))
    }
}
