//! What is compared of a case: its regime, the limit near it, and the numbers a
//! person would quote.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail, ensure};
use sim::{LateralRegime, Outcome, TorsionRegime};

use crate::records::{Whirl, is_whirl, to_kn, to_turns};

/// What a method answers to one probe.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// Number of the case.
    pub case: usize,
    /// The regimes of each motion or why there are none, with the number of starts that end so.
    pub regimes: BTreeMap<String, usize>,
    /// Where the regime changes, in multiples of the case's own surface speed, or of
    /// its friction where there is a wall.
    pub limit: Option<f64>,
    /// Numbers that a person would quote.
    pub measures: Vec<Quoted>,
    /// Whirl of several sites, which beats: too chaotic for its numbers to be quoted, but not to tell
    /// it from another.
    pub whirl: Option<Whirl>,
}

/// A number of a case, or the mean of its starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quoted {
    /// Of what.
    pub name: &'static str,
    /// As large as this.
    pub value: f64,
    /// The standard error of a mean: by how much other starts would change it.
    pub chance: f64,
}

impl Quoted {
    /// Of one start, or of what does not depend on the start.
    pub fn alone((name, value): (&'static str, f64)) -> Self {
        let chance = 0.0;
        Self {
            name,
            value,
            chance,
        }
    }
}

/// Regimes of a case are different where no more than this part of its starts has the same by both.
const SHARED: f64 = 0.25;

/// A relative difference from the reference, and what it is of.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// A part of one.
    pub part: f64,
    /// In words.
    pub of: String,
}

/// Whether a case is in the regime that a limit bounds: whirl, where there is a wall,
/// else stick-slip.
pub fn is_inside(outcome: &Outcome) -> bool {
    match (outcome.lateral(), outcome.torsion()) {
        (Some(lateral), _) => is_whirl(lateral.regime),
        (None, Some(torsion)) => torsion.regime == TorsionRegime::StickSlip,
        (None, None) => false,
    }
}

/// The regimes of a case.
pub fn regimes(outcome: &Outcome) -> String {
    let torsion = outcome.torsion().map(|torsion| torsion.regime.name());
    let lateral = outcome.lateral().map(|lateral| lateral.regime.name());
    let axial = outcome.axial().map(|axial| axial.regime.name());
    let all: Vec<&str> = torsion.into_iter().chain(lateral).chain(axial).collect();
    all.join(" and ")
}

/// The answer to a case by what came of some starts of it, but for its limit.
pub fn answer_of(case: usize, outcomes: &[Result<Outcome>], sites: usize) -> Answer {
    let mut answer = Answer {
        case,
        ..Answer::default()
    };
    for outcome in outcomes {
        let regimes = match outcome {
            Ok(outcome) => regimes(outcome),
            Err(reason) => format!("without an answer ({reason})"),
        };
        *answer.regimes.entry(regimes).or_default() += 1;
    }
    if sites > 1 {
        let first = outcomes.first().and_then(|outcome| outcome.as_ref().ok());
        answer.whirl = first.and_then(Whirl::of);
    }
    let found: Vec<Vec<(&str, f64)>> = (outcomes.iter().flatten())
        .map(|outcome| measures(outcome, sites))
        .collect();
    if let Some(first) = found.first() {
        // Where starts end in several regimes, what all of them have.
        let shared = first.iter().map(|(name, _)| *name).filter_map(|name| {
            let of_start = |measures: &Vec<(&str, f64)>| {
                let known = measures.iter().find(|(other, _)| *other == name);
                known.map(|(_, value)| *value)
            };
            let values: Option<Vec<f64>> = found.iter().map(of_start).collect();
            Some(mean(name, &values?))
        });
        answer.measures.extend(shared);
    }
    answer
}

/// The mean of some starts, with its standard error.
fn mean(name: &'static str, values: &[f64]) -> Quoted {
    let count = values.len() as f64;
    let value = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|other| (other - value).powi(2)).sum();
    let chance = match values.len() {
        1 => 0.0,
        _ => (squares / (count - 1.0) / count).sqrt(),
    };
    Quoted {
        name,
        value,
        chance,
    }
}

/// The numbers of a case that converge. After a contact that ends motion is chaotic,
/// and of it only the regime counts; whirl at several sites beats, and of its rate and
/// force only counts whether they are [alike](Whirl::is_like); a bit that cuts may slip
/// and stick many times where it rests; the peak speed of a slipping bit is that of a
/// wave front, which every finer step sharpens; how long a slip lasts depends on which
/// echo ends it, and the mean speed of the closing window on where in a cycle that
/// begins.
pub fn measures(outcome: &Outcome, sites: usize) -> Vec<(&'static str, f64)> {
    if let Some(axial) = outcome.axial() {
        return vec![
            ("rate of penetration", axial.rate_of_penetration),
            ("mean weight on bit", axial.mean_weight),
        ];
    }
    let mut found = Vec::new();
    if let Some(torsion) = outcome.torsion() {
        found.extend(torsion.first_slip.map(|time| ("first slip", time)));
        if torsion.regime == TorsionRegime::StickSlip && outcome.lateral().is_none() {
            found.extend(torsion.period.map(|period| ("period", period)));
        }
    }
    if let Some(lateral) = outcome.lateral() {
        if is_whirl(lateral.regime) && sites == 1 {
            found.extend([
                ("radius", lateral.mean_radius),
                ("precession rate", lateral.precession_rate),
                ("normal force", lateral.mean_normal_force),
                ("time in contact", lateral.contact_fraction),
            ]);
        } else if lateral.regime == LateralRegime::NoContact {
            found.push(("peak radius", lateral.peak_radius));
        }
    }
    found
}

/// The largest difference of some answers from those of a reference: of each quantity the
/// root mean square over the probes, for here and there a limit is ragged or a cycle
/// sits on the edge of another, and moves with anything. Where the regime differs, a
/// case within the accuracy of the reference's limit counts by the shift of that limit
/// alone.
///
/// # Errors
/// Where regimes differ, or a limit is not found.
pub fn largest_difference(
    found: &[Answer],
    reference: &[Answer],
    asked: f64,
) -> Result<Difference> {
    let is_comparable = !found.is_empty() && found.len() == reference.len();
    ensure!(is_comparable, "there is nothing to compare");
    let mut all = Vec::new();
    for (found, expected) in found.iter().zip(reference) {
        all.extend(differences(found, expected, asked)?);
    }
    check_whirl(found, reference, asked)?;
    let (part, of) = largest_mean(all);
    Ok(Difference {
        part,
        of: format!("the {of}"),
    })
}

/// Refuses whirl of several sites that in more than half of the probes with it has another rate or
/// force than that of a reference: one by one it may go either way, and the site that decides the
/// label with it.
fn check_whirl(found: &[Answer], reference: &[Answer], asked: f64) -> Result<()> {
    let of_both: Vec<(usize, [Whirl; 2])> = (found.iter().zip(reference))
        .filter(|(_, expected)| !is_by_limit(expected, asked))
        .filter_map(|(found, expected)| Some((expected.case, [found.whirl?, expected.whirl?])))
        .collect();
    let is_other = |(_, [found, expected]): &&(usize, [Whirl; 2])| !found.is_like(*expected);
    let others: Vec<_> = of_both.iter().filter(is_other).collect();
    let Some((case, whirl)) = others.first().filter(|_| 2 * others.len() > of_both.len()) else {
        return Ok(());
    };
    let [found, expected] = whirl.map(|whirl| {
        let (rate, force) = (
            to_turns(whirl.precession_rate),
            to_kn(whirl.mean_normal_force),
        );
        format!("at {rate:.1} turns/s with {force:.1} kN")
    });
    let more = match others.len() {
        1 => String::new(),
        count => format!(", one of {count} such cases of {}", of_both.len()),
    };
    bail!("case {case} whirls {found} instead of {expected}{more}")
}

/// Whether a probe is as near its limit as asked.
fn is_by_limit(answer: &Answer, asked: f64) -> bool {
    (answer.limit).is_some_and(|limit| limit.ln().abs() <= asked)
}

/// By how much chance may have changed the means of some answers.
pub fn largest_chance(answers: &[Answer]) -> Difference {
    let measures = answers.iter().flat_map(|answer| &answer.measures);
    let parts = measures.map(|of| (of.name, part_of(of.chance, of.value)));
    let (part, of) = largest_mean(parts.collect());
    Difference {
        part,
        of: format!("the {of}, by chance,"),
    }
}

/// The largest root mean square of the parts of one quantity, and of which.
fn largest_mean(parts: Vec<(&'static str, f64)>) -> (f64, &'static str) {
    // Sums of squares, and how many.
    let mut sums: BTreeMap<&str, (f64, f64)> = BTreeMap::new();
    for (name, part) in parts {
        let (sum, count) = sums.entry(name).or_default();
        *sum += part * part;
        *count += 1.0;
    }
    let means = (sums.iter()).map(|(name, (sum, count))| ((sum / count).sqrt(), *name));
    means.fold((0.0, "nothing"), |worst, mean| {
        if mean.0 > worst.0 { mean } else { worst }
    })
}

fn part_of(difference: f64, whole: f64) -> f64 {
    difference.abs() / whole.abs().max(f64::MIN_POSITIVE)
}

/// The relative differences of one probe, with what they are of.
fn differences(found: &Answer, expected: &Answer, asked: f64) -> Result<Vec<(&'static str, f64)>> {
    let case = expected.case;
    let mut differences = Vec::new();
    if let Some(expected) = expected.limit {
        let no_limit = || format!("the limit near case {case} is not found");
        let found = found.limit.with_context(no_limit)?;
        differences.push(("limit between regimes", part_of(found - expected, expected)));
    }
    if is_of_others(&found.regimes, &expected.regimes) {
        if !is_by_limit(expected, asked) {
            let [found, expected] = [found, expected].map(|answer| most_of(&answer.regimes));
            bail!("case {case} is {found} instead of {expected}");
        }
        return Ok(differences);
    }
    let of_both = expected.measures.iter().filter_map(|expected| {
        let found = (found.measures.iter()).find(|found| found.name == expected.name)?;
        let part = part_of(found.value - expected.value, expected.value);
        Some((expected.name, part))
    });
    differences.extend(of_both);
    Ok(differences)
}

/// Whether hardly any start ends in the same regimes by both.
fn is_of_others(found: &BTreeMap<String, usize>, expected: &BTreeMap<String, usize>) -> bool {
    let shared: usize = (expected.iter())
        .map(|(regimes, count)| *found.get(regimes).unwrap_or(&0).min(count))
        .sum();
    let starts: usize = expected.values().sum();
    shared as f64 <= SHARED * starts as f64
}

/// The regimes of most starts.
fn most_of(regimes: &BTreeMap<String, usize>) -> &str {
    let most = regimes.iter().max_by_key(|(_, count)| **count);
    most.map_or("nothing", |(regimes, _)| regimes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of_starts(rates: &[f64], regimes: &[(&str, usize)]) -> Answer {
        Answer {
            case: 3,
            regimes: regimes
                .iter()
                .map(|(name, count)| ((*name).to_owned(), *count))
                .collect(),
            measures: vec![mean("rate of penetration", rates)],
            ..Answer::default()
        }
    }

    /// Of a mean of n the chance is the spread over the root of n.
    #[test]
    fn chance_is_that_of_a_mean() {
        let answer = of_starts(&[9.0, 11.0, 9.0, 11.0], &[("smooth", 4)]);
        let expected = (4.0_f64 / 3.0 / 4.0).sqrt() / 10.0;
        assert!((largest_chance(&[answer]).part / expected - 1.0).abs() < 1e-12);
        assert_eq!(
            largest_chance(&[of_starts(&[9.0], &[("smooth", 1)])]).part,
            0.0
        );
    }

    #[test]
    fn regimes_differ_where_hardly_a_start_has_the_same() {
        let rates = [10.0; 8];
        let of = |sticking: usize| {
            of_starts(
                &rates,
                &[("stick_slip", sticking), ("smooth", 8 - sticking)],
            )
        };
        let part =
            |found: usize, expected: usize| largest_difference(&[of(found)], &[of(expected)], 0.05);
        assert_eq!(part(4, 8).unwrap().part, 0.0);
        let reason = part(2, 8).unwrap_err().to_string();
        assert_eq!(reason, "case 3 is smooth instead of stick_slip");
    }

    /// Whirl of several sites with a third of the force is another, but next to a limit.
    #[test]
    fn whirl_of_several_sites_has_a_rate_and_a_force() {
        let whirling = |mean_normal_force: f64, limit: f64| Answer {
            case: 3,
            regimes: BTreeMap::from([("backward_whirl".to_owned(), 1)]),
            limit: Some(limit),
            whirl: Some(Whirl {
                precession_rate: -20.0 * std::f64::consts::TAU,
                mean_normal_force,
            }),
            ..Answer::default()
        };
        let part = |force: f64, limit: f64| {
            largest_difference(&[whirling(force, limit)], &[whirling(9e4, limit)], 0.05)
        };
        assert_eq!(part(6e4, 0.5).unwrap().part, 0.0);
        assert_eq!(part(3e4, 0.98).unwrap().part, 0.0);
        let reason = part(3e4, 0.5).unwrap_err().to_string();
        assert_eq!(
            reason,
            "case 3 whirls at -20.0 turns/s with 30.0 kN instead of at -20.0 turns/s with 90.0 kN"
        );
        let of = |forces: [f64; 3]| forces.map(|force| whirling(force, 0.5));
        let reference = of([9e4; 3]);
        let one_of_three = of([3e4, 8e4, 9e4]);
        assert!(largest_difference(&one_of_three, &reference, 0.05).is_ok());
        let reason = largest_difference(&of([3e4, 8e4, 4e4]), &reference, 0.05).unwrap_err();
        assert!(
            reason.to_string().ends_with(", one of 2 such cases of 3"),
            "{reason}"
        );
    }
}
