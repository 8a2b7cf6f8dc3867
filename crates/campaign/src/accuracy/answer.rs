//! What is compared of a case: its regime, the limit near it, and the numbers a
//! person would quote.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail, ensure};
use sim::{LateralRegime, Outcome, TorsionRegime};

/// What a method answers to one probe.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// Number of the case.
    pub case: usize,
    /// Its regimes in torsion and bending, or why it has none.
    pub regimes: String,
    /// Where the regime changes, in multiples of the case's own surface speed, or of
    /// its friction where there is a wall.
    pub limit: Option<f64>,
    /// Numbers with their names.
    pub measures: Vec<(&'static str, f64)>,
}

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

fn is_whirl(regime: LateralRegime) -> bool {
    matches!(
        regime,
        LateralRegime::BackwardWhirl | LateralRegime::ForwardWhirl
    )
}

/// The regimes of a case.
pub fn regimes(outcome: &Outcome) -> String {
    let torsion = outcome.torsion().map(|torsion| torsion.regime.name());
    let lateral = outcome.lateral().map(|lateral| lateral.regime.name());
    let both: Vec<&str> = torsion.into_iter().chain(lateral).collect();
    both.join(" and ")
}

/// The numbers of a case that converge. After a contact that ends motion is chaotic,
/// and of it only the regime counts; whirl at several sites beats, and none of them
/// keeps its radius or force; the peak speed of a slipping bit is that of a
/// wave front, which every finer step sharpens; how long a slip lasts depends on which
/// echo ends it, and the mean speed of the closing window on where in a cycle that
/// begins.
pub fn measures(outcome: &Outcome, sites: usize) -> Vec<(&'static str, f64)> {
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
    // Sums of squares, and how many.
    let mut sums: BTreeMap<&str, (f64, f64)> = BTreeMap::new();
    for (found, expected) in found.iter().zip(reference) {
        for (name, part) in differences(found, expected, asked)? {
            let (sum, count) = sums.entry(name).or_default();
            *sum += part * part;
            *count += 1.0;
        }
    }
    let means = (sums.iter()).map(|(name, (sum, count))| ((sum / count).sqrt(), *name));
    let (part, of) = means.fold((0.0, "nothing"), |worst, mean| {
        if mean.0 > worst.0 { mean } else { worst }
    });
    Ok(Difference {
        part,
        of: format!("the {of}"),
    })
}

/// The relative differences of one probe, with what they are of.
fn differences(found: &Answer, expected: &Answer, asked: f64) -> Result<Vec<(&'static str, f64)>> {
    let case = expected.case;
    let relative = |found: f64, expected: f64| {
        (found - expected).abs() / expected.abs().max(f64::MIN_POSITIVE)
    };
    let mut differences = Vec::new();
    if let Some(expected) = expected.limit {
        let no_limit = || format!("the limit near case {case} is not found");
        let found = found.limit.with_context(no_limit)?;
        differences.push(("limit between regimes", relative(found, expected)));
    }
    let (regimes, others) = (&found.regimes, &expected.regimes);
    if regimes != others {
        if expected.limit.is_none_or(|limit| limit.ln().abs() > asked) {
            bail!("case {case} is {regimes} instead of {others}");
        }
        return Ok(differences);
    }
    let pairs = found.measures.iter().zip(&expected.measures);
    differences
        .extend(pairs.map(|((name, found), (_, expected))| (*name, relative(*found, *expected))));
    Ok(differences)
}
