//! What labels depend on that is no property of the well: the method, the sampling frequency, and
//! the start. A few cases of a sweep are simulated again, each with one of these changed; what a run has
//! simulated by the methods of its list is not.

mod costs;
mod variant;

pub use variant::Change;

use std::collections::BTreeMap;

use anyhow::Result;
use linear::{Method, parallel};
use serde::{Deserialize, Serialize};
use sim::Outcome;

use crate::engine::{
    Case, MethodSystem, Recipe, RunOptions, Shard, StringMemory, answer, has_case, setting_of,
};

use crate::records::{Record, Whirl};

use crate::plan::{Setting, Sweep};
use crate::sweep_file::FileContent;
use crate::words::counted;

use costs::Costs;
use variant::{Variant, variants};

/// One case in this number is simulated again,
const ONE_IN: usize = 25;

/// but no fewer than the first of these, where there are as many, and no more than the second.
const CASES: [usize; 2] = [12, 64];

/// A system is built to look at labels where its taps times the parts of the string are no more
/// than this, which takes some seconds,
const LIGHT: f64 = 5e7;

/// or its parts no more than this many a case of the sweep: stepping these takes longer.
const PARTS_PER_CASE: f64 = 0.25;

/// A part of the labels from which on their change is warned of,
const WARNED_PART: f64 = 0.1;

/// and the fewest labels.
const WARNED_CASES: usize = 2;

/// How many labels of the first method change with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Dependence {
    /// What is changed.
    pub change: Change,
    /// Cases that have an answer both ways; zero where it is not examined, as that would take
    /// more than a small part of the time of the sweep.
    pub cases: usize,
    /// Those of them with another label.
    pub changed: usize,
    /// Cases among them that whirl both ways, at another rate or with another force.
    #[serde(default)]
    pub other_whirl: usize,
}

impl Dependence {
    /// Whether it is worth a warning. Where the start decides, both labels are right.
    pub fn is_warned_of(&self) -> bool {
        let differing = self.changed + self.other_whirl;
        let part = differing as f64 / self.cases.max(1) as f64;
        differing >= WARNED_CASES && part >= WARNED_PART
    }

    /// What is to be said of it, in a sweep that the file says this of.
    pub fn words(&self, content: &FileContent) -> String {
        let Self {
            change,
            cases,
            changed,
            other_whirl,
        } = self;
        let how = change.words();
        let or_accuracy = match content.may_have_accuracy() && !content.certify {
            true => ", or set `accuracy` in place of method and frequency",
            false => "",
        };
        let what_to_do = match change {
            Change::Start(_) => ": `start = \"both\"` shows where".to_owned(),
            _ if content.accuracy.is_some() => ": ask for a smaller `accuracy`".to_owned(),
            Change::Method(method) => {
                format!(": add `{method}` to `methods`, and the map shows where{or_accuracy}")
            }
            Change::SamplingFrequencyHz(_) => {
                format!(": raise `sampling_frequency_hz`{or_accuracy}")
            }
        };
        let of = counted(*cases, "sampled case");
        let advice = if self.is_warned_of() { &what_to_do } else { "" };
        let whirl = match other_whirl {
            0 => String::new(),
            _ => format!(", and {other_whirl} whirl at another rate or with another force"),
        };
        let have = if *changed == 1 { "has" } else { "have" };
        format!("{how}, {changed} of {of} {have} another label{whirl}{advice}")
    }
}

/// What a run has of the cases that are examined, by case and method.
#[derive(Debug)]
pub struct Sample {
    cases: Vec<usize>,
    records: BTreeMap<(usize, usize), Record>,
    /// The changes that take too long to be examined.
    left_out: Vec<Change>,
}

/// Variants of a sweep that are examined, and cases of each.
struct Examination {
    variants: Vec<Variant>,
    /// Changes that are not examined, as that takes too long.
    left_out: Vec<Change>,
    /// Cases of each variant.
    cases: usize,
}

impl Examination {
    fn of(sweep: &Sweep) -> Self {
        let all = sweep.design.cases();
        let [fewest, most] = CASES.map(|count| count.min(all));
        let most = (all / ONE_IN).clamp(fewest, most);
        let costs = Costs::of(sweep, &spread(all, fewest));
        let (mut variants, mut left_out) = (variants(sweep), Vec::new());
        let cases = loop {
            let fits = |count: &usize| costs.allow(&variants, *count);
            if let Some(count) = (fewest..=most).rev().find(fits) {
                break count;
            }
            let cost = |variant: &Variant| costs.of_variant(variant, fewest);
            let places = 0..variants.len();
            let dearest = places
                .max_by(|one, other| cost(&variants[*one]).total_cmp(&cost(&variants[*other])));
            match dearest {
                Some(place) => left_out.push(variants.remove(place).change),
                None => break fewest,
            }
        };
        Self {
            variants,
            left_out,
            cases,
        }
    }
}

impl Sample {
    /// Cases of a sweep, without records yet.
    pub fn of(sweep: &Sweep) -> Self {
        let Examination {
            left_out, cases, ..
        } = Examination::of(sweep);
        Self {
            cases: spread(sweep.design.cases(), cases),
            records: BTreeMap::new(),
            left_out,
        }
    }

    /// Keeps a record of a run, if it is of a case that is examined.
    pub fn note(&mut self, record: &Record) {
        if self.cases.binary_search(&record.case).is_ok() {
            let key = (record.case, record.method);
            self.records.insert(key, record.clone());
        }
    }

    /// Of some cases, by the method at a place of the sweep's list.
    fn records(&self, cases: &[Sampled], method: usize) -> Records {
        let record = |it: &Sampled| self.records.get(&(it.case, method)).cloned();
        cases.iter().map(record).collect()
    }
}

/// How often labels by the first method of a part of a sweep change with the method, the sampling
/// frequency and the start. A variant that a method does not treat is left out. All parts together
/// have the cases of the whole. `built` are the systems of all methods of the list for all cases, of the
/// string as the file says it; `sample` has the records of the part.
pub fn dependences(
    sweep: &Sweep,
    shard: Shard,
    options: RunOptions,
    built: &[MethodSystem],
    sample: &Sample,
) -> Vec<Dependence> {
    let sampled = |&case: &usize| Sampled {
        case,
        is_own: has_case(shard, &sweep.design, case),
    };
    let cases: Vec<Sampled> = sample.cases.iter().map(sampled).collect();
    let variants = variants(sweep);
    let strings: Vec<Vec<Sampled>> = match sweep.design.varies_string() {
        true => cases.into_iter().map(|case| vec![case]).collect(),
        false => vec![cases],
    };
    let has_own = |cases: &&Vec<Sampled>| cases.iter().any(|it| it.is_own);
    // One string after the other, for their memory.
    let built = match sweep.design.varies_string() {
        true => &[],
        false => built,
    };
    // Labels of cases that are followed to their end are those of cases that are not.
    let options = RunOptions {
        full: false,
        ..options
    };
    let of_string = |cases: &Vec<Sampled>| match OfString::new(sweep, cases, options) {
        Ok(of_string) => of_string.counts(&variants, built, sample),
        Err(_) => vec![None; variants.len()],
    };
    let counts: Vec<Vec<Option<Counts>>> = strings.iter().filter(has_own).map(of_string).collect();
    let total = |place: usize| {
        let of_strings = counts.iter().filter_map(|counts| counts[place]);
        of_strings.reduce(|all, more| std::array::from_fn(|it| all[it] + more[it]))
    };
    (variants.iter().enumerate())
        .filter_map(|(place, variant)| {
            let [cases, changed, other_whirl] = total(place)?;
            Some(Dependence {
                change: variant.change.clone(),
                cases,
                changed,
                other_whirl,
            })
        })
        .collect()
}

/// Those of all parts of a sweep, of what each of them has.
pub fn together<'a>(parts: impl IntoIterator<Item = &'a [Dependence]>) -> Vec<Dependence> {
    let mut all: Vec<Dependence> = Vec::new();
    for part in parts.into_iter().flatten() {
        match all.iter_mut().find(|one| one.change == part.change) {
            Some(one) => {
                one.cases += part.cases;
                one.changed += part.changed;
                one.other_whirl += part.other_whirl;
            }
            None => all.push(part.clone()),
        }
    }
    all
}

/// Memory, bytes, that this takes for cases of a setting up to the longest time (s), in addition to
/// what a run keeps: an upper bound.
pub fn bytes(sweep: &Sweep, setting: &Setting, longest_time: f64) -> f64 {
    let of_variant = |variant: Variant| {
        let setting = variant.setting(setting);
        let memory = StringMemory::of(sweep, &setting, &[variant.method], longest_time);
        memory.systems.peak + parallel::threads() as f64 * memory.case
    };
    let examined = Examination::of(sweep).variants.into_iter();
    let built = examined.filter(|variant| !variant.is_of_list(sweep));
    built.map(of_variant).fold(0.0, f64::max)
}

/// A number of cases spread over all of a design: multiples of the golden ratio, modulo one, leave no
/// gaps and follow no row or column of a grid.
fn spread(all: usize, count: usize) -> Vec<usize> {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let place = |index: usize| ((index as f64 + 0.5) * golden).fract();
    let mut cases: Vec<usize> = (0..count)
        .map(|index| ((place(index) * all as f64) as usize).min(all - 1))
        .collect();
    cases.sort_unstable();
    cases.dedup();
    cases
}

/// A case that is examined.
#[derive(Debug, Clone, Copy)]
struct Sampled {
    case: usize,
    /// Whether by this part of the sweep: what is worth building does not depend on the parts.
    is_own: bool,
}

/// Cases of one string.
struct OfString<'a> {
    sweep: &'a Sweep,
    setting: Setting,
    options: RunOptions,
    cases: &'a [Sampled],
}

/// Of each case, with an answer or without; `None` for a case of other shards, or an invalid one.
type Records = Vec<Option<Record>>;

impl<'a> OfString<'a> {
    fn new(sweep: &'a Sweep, cases: &'a [Sampled], options: RunOptions) -> Result<Self> {
        let string = sweep.design.string_of(cases[0].case);
        Ok(Self {
            sweep,
            setting: setting_of(sweep, string)?.for_labels().into_owned(),
            options,
            cases,
        })
    }

    /// Cases with an answer both ways, and those with another label, by variant; none where no
    /// method treats it. `built` are its systems as the sweep has them, where these are there.
    fn counts(
        &self,
        variants: &[Variant],
        built: &[MethodSystem],
        sample: &Sample,
    ) -> Vec<Option<Counts>> {
        let methods = &self.sweep.methods;
        let in_list = |method: &Method| methods.iter().position(|it| it.name() == method.name());
        let records = |variant: &Variant| {
            let place = match variant.change {
                Change::SamplingFrequencyHz(_) => None,
                Change::Method(_) | Change::Start(_) => in_list(&variant.method),
            };
            let known = match variant.change {
                Change::Method(_) => place.map(|place| sample.records(self.cases, place)),
                Change::Start(_) | Change::SamplingFrequencyHz(_) => None,
            };
            let system = place.and_then(|place| built.get(place));
            self.records(variant, system, known.unwrap_or_default())
        };
        let first = Variant::of_run(self.sweep);
        let as_run = records(&first).unwrap_or_default();
        let count = |variant: &Variant| match sample.left_out.contains(&variant.change) {
            true => Some([0; 3]),
            false => Some(differing(&as_run, &records(variant)?)),
        };
        variants.iter().map(count).collect()
    }

    /// Records of a variant: those that are not known by a system that is there or is built; none of
    /// them where that would take longer than the sweep. `None` where no method treats it.
    fn records(
        &self,
        variant: &Variant,
        built: Option<&MethodSystem>,
        mut known: Records,
    ) -> Option<Records> {
        known.resize(self.cases.len(), None);
        let is_missing = |(it, known): (&Sampled, &Option<Record>)| it.is_own && known.is_none();
        if !std::iter::zip(self.cases, &known).any(is_missing) {
            return Some(known);
        }
        let setting = variant.setting(&self.setting);
        let sweep = Sweep {
            starts: variant.starts,
            ..self.sweep.clone()
        };
        let case = |it: &Sampled| Case::of(&sweep, &setting, it.case).ok();
        let cases: Vec<Option<Case>> = self.cases.iter().map(case).collect();
        let durations = cases
            .iter()
            .flatten()
            .map(|case| case.scene.timing.duration);
        let longest = durations.fold(0.0, f64::max);
        if !is_worth_building(self.sweep, &setting, longest) {
            return Some(Records::new());
        }
        let alone;
        let system = match built {
            Some(built) => built,
            None => {
                let recipe = Recipe::of(self.sweep, &setting, variant.method, longest).for_labels();
                alone = recipe.build().ok()?;
                &alone
            }
        };
        if system.instability().is_some() {
            return None;
        }
        Some(parallel::map(cases.len(), 1, |place| {
            let case = cases[place].as_ref().filter(|_| self.cases[place].is_own)?;
            let known = known[place].clone();
            Some(known.unwrap_or_else(|| answer(system, case, 0, self.options, &sweep)))
        }))
    }
}

/// Whether a system for cases up to a time (s) is built as fast as the cases of a sweep are stepped,
/// or in some seconds.
fn is_worth_building(sweep: &Sweep, setting: &Setting, longest: f64) -> bool {
    let sections = setting.string.sections().iter();
    let parts: usize = sections.map(|section| section.parts.len()).sum();
    let parts = parts as f64;
    let taps = setting.sampling_frequency * longest;
    parts * taps <= LIGHT || parts <= PARTS_PER_CASE * sweep.design.cases() as f64
}

/// Cases with an answer both ways, those of them with another label, and those with another whirl.
type Counts = [usize; 3];

fn differing(some: &Records, others: &Records) -> Counts {
    let mut counts = [0; 3];
    for (one, other) in some.iter().zip(others) {
        let outcomes = [one, other].map(|record| record.as_ref()?.outcome.as_ref().ok());
        let [Some(one), Some(other)] = outcomes else {
            continue;
        };
        let differs = one.labels() != other.labels();
        counts[0] += 1;
        counts[1] += usize::from(differs);
        counts[2] += usize::from(!differs && whirls_otherwise(one, other));
    }
    counts
}

/// Whether two outcomes are whirl at rates or with forces that are not alike.
fn whirls_otherwise(one: &Outcome, other: &Outcome) -> bool {
    let both = Whirl::of(one).zip(Whirl::of(other));
    both.is_some_and(|(one, other)| !one.is_like(other))
}

#[cfg(test)]
mod tests {
    use std::io::{Error, ErrorKind};
    use std::path::Path;

    use super::*;
    use crate::sweep_file::SweepFileError;

    /// A string of a number of parts, all different, under the speeds of a number of cases.
    fn sweep(parts: usize, cases: usize) -> Sweep {
        let part = |index: usize| {
            let radius = 0.06 + 1e-5 * index as f64;
            format!(
                "{{ repeat = 1, parts = [{{ length_m = 3, inner_radius_m = 0.05, outer_radius_m = {radius} }}] }}"
            )
        };
        let parts: Vec<String> = (0..parts).map(part).collect();
        let text = format!(
            "sampling_frequency_hz = 4000\n[bit]\ntorque_dynamic_nm = 4000\ntorque_static_ratio = 1.2\n\
             [design]\nkind = \"grid\"\n[design.axes]\n\
             surface_speed_rpm = {{ from = 10, to = 50, count = {cases} }}\n[string]\n\
             shear_modulus_gpa = 80\ndensity_kg_m3 = 7840\ntorsional_damping_nms_rad_m = 0.3\n\
             sections = [{}]\n",
            parts.join(", ")
        );
        let read = |path: &Path, _| match path.to_str() {
            Some("sweep.toml") => Ok(text.clone()),
            _ => Err(Error::from(ErrorKind::NotFound)),
        };
        Sweep::read_from(Path::new("sweep.toml"), &[], &read).unwrap()
    }

    /// As a run of all cases has it.
    fn system(sweep: &Sweep) -> MethodSystem {
        let longest = crate::engine::survey(sweep).unwrap().longest;
        Recipe::of(sweep, &sweep.setting, sweep.methods[0], longest)
            .build()
            .unwrap()
    }

    /// As a run of a part of a sweep finds it.
    fn depends(sweep: &Sweep, shard: Shard, system: &MethodSystem) -> Vec<Dependence> {
        let mut sample = Sample::of(sweep);
        let of_part = |case: &usize| has_case(shard, &sweep.design, *case);
        for case in (0..sweep.design.cases()).filter(of_part) {
            let case = Case::of(sweep, &sweep.setting, case).unwrap();
            sample.note(&answer(system, &case, 0, RunOptions::default(), sweep));
        }
        dependences(
            sweep,
            shard,
            RunOptions::default(),
            std::slice::from_ref(system),
            &sample,
        )
    }

    /// Labels are examined, and where that would take longer than the sweep the output says that
    /// they are not.
    #[test]
    fn what_takes_longer_than_a_sweep_is_left_out() {
        let examined = |sweep: &Sweep| -> Vec<usize> {
            let found = depends(sweep, Shard::WHOLE, &system(sweep));
            found.iter().map(|dependence| dependence.cases).collect()
        };
        assert_eq!(examined(&sweep(2, 8)), [8, 8, 8]);
        assert_eq!(examined(&sweep(1000, 8)), [0, 0, 0]);
    }

    #[test]
    fn parts_of_a_sweep_have_together_what_the_whole_has() {
        let sweep = sweep(2, 30);
        let system = system(&sweep);
        let of = |shard| depends(&sweep, shard, &system);
        let parts: Vec<Vec<Dependence>> = (0..7).map(|index| of(Shard { index, of: 7 })).collect();
        assert_eq!(together(parts.iter().map(Vec::as_slice)), of(Shard::WHOLE));
        assert!(parts.iter().all(|part| part.iter().all(|it| it.cases < 12)));
    }

    /// A file on top of the paper's drillstring.
    fn read(text: &str) -> Result<Sweep, SweepFileError> {
        let text = format!("base = \"academic.toml\"\n{text}");
        Sweep::read_from(Path::new("sweep.toml"), &[], &|path, _| {
            Ok(match path.to_str() {
                Some("sweep.toml") => text.clone(),
                _ => include_str!("../../../../sweeps/academic.toml").to_owned(),
            })
        })
    }

    /// What is said of the labels of a sweep advises an accuracy where one can be asked for, and nowhere else.
    #[test]
    fn an_accuracy_is_advised_where_it_can_be_asked_for() {
        let depends = Dependence {
            change: Change::SamplingFrequencyHz(640.0),
            cases: 10,
            changed: 5,
            other_whirl: 0,
        };
        let bit = "[bit]\ntorque_dynamic_nm = 4000\n";
        let methods = "methods = [\"held\"]\n";
        let cutting = "surface_speed_rpm = 120\n[bit]\nrock = \"sandstone\"\nweight_on_bit_kn = 60\n[bit.cutting]\n";
        let walled =
            "[wall]\nclearance_mm = 20\nfriction = 0.3\n[[sites]]\ndistance_from_bit_m = 0\n";
        let speed = "surface_speed_rpm = 120\n";
        for (rest, is_known) in [
            (format!("{speed}{bit}"), true),
            (cutting.to_owned(), true),
            (format!("{cutting}{walled}"), false),
            (
                format!("{speed}{bit}[motor]\nspeed_rpm = 100\nstall_torque_kn_m = 12\n"),
                false,
            ),
            (
                format!(
                    "{speed}{bit}[top_drive]\ncontroller = \"stiff\"\ninertia_kg_m2 = 2000\ntorque_limit_kn_m = 30\nsaturates = true\n"
                ),
                false,
            ),
        ] {
            let words = depends.words(&read(&format!("{methods}{rest}")).unwrap().content);
            assert_eq!(words.contains("or set `accuracy`"), is_known, "{words}");
            let asked = read(&format!("accuracy = 0.1\n{rest}"));
            match asked {
                Ok(asked) => {
                    let words = depends.words(&asked.content);
                    assert!(
                        is_known && words.ends_with(": ask for a smaller `accuracy`"),
                        "{words}"
                    );
                }
                Err(error) => {
                    assert!(
                        !is_known && error.to_string().contains("`accuracy`"),
                        "{error}"
                    );
                }
            }
        }
    }
}
