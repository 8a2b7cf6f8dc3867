//! The places where a string touches its wall, found case by case: it is simulated with those that
//! are known, the whole string is reconstructed from the forces there, and where that goes through
//! the wall between them is a site the next time. Nothing is patched: a case is run again from its
//! beginning, until the string goes through the wall no farther than at its sites, but for a
//! tolerance.

use anyhow::Result;
use linear::Method;
use sim::Trajectory;

use super::case::Case;
use super::case_error::CaseError;
use super::clearances::{Beyond, Clearances};
use super::nearby::certify;
use super::run_options::RunOptions;
use super::stepped::{MOST_BY_TAPS, stepped_by};
use super::systems::{MethodSystem, Recipe};
use super::whole_string::reconstructed;
use crate::plan::{Finding, Setting, Sweep};
use crate::records::{Failure, Found, Record};

/// Sites are given to a millimetre: parts of a metre.
const GIVEN_TO: f64 = 1e3;

/// Sites nearer to each other than this, m, are one.
const LEAST_APART: f64 = 0.2;

/// Clearances that differ by less, m, are the same.
const SAME_CLEARANCE: f64 = 1e-6;

/// More sites than this no case is given: those of three hundred metres that lie on the wall.
const MOST_STEPPED: usize = 300;

/// The record of a case whose sites are found; arguments as of [`super::answer()`].
pub fn find_sites(
    given: &MethodSystem,
    finding: &Finding,
    case: &Case,
    method: usize,
    options: RunOptions,
    sweep: &Sweep,
) -> Record {
    let mut found = Found {
        sites: finding.found.clone(),
        rounds: 0,
    };
    let mut again: Option<(MethodSystem, Case)> = None;
    loop {
        let (system, case) =
            (again.as_ref()).map_or((given, case), |(system, case)| (system, case));
        let mut motion = Trajectory::default();
        let mut record = system.follow(case, method, options, sweep, Some(&mut motion));
        let next = match &record.outcome {
            Ok(_) => next_system(system, finding, case, (method, sweep), &motion, &mut found),
            Err(_) => Ok(None),
        };
        match next {
            Ok(Some(next)) => again = Some(next),
            Ok(None) => {
                if record.outcome.is_ok() {
                    certify(system, case, options, sweep, &mut record);
                }
                record.found = Some(found);
                return record;
            }
            Err(reason) => {
                record.outcome = Err(Failure::new(reason));
                record.found = Some(found);
                return record;
            }
        }
    }
}

/// The case with sites where it went through its wall; none where it did not.
fn next_system(
    system: &MethodSystem,
    finding: &Finding,
    case: &Case,
    (method, sweep): (usize, &Sweep),
    motion: &Trajectory,
    found: &mut Found,
) -> Result<Option<(MethodSystem, Case)>, CaseError> {
    let Some(clearances) = Clearances::of(&system.setting, case) else {
        return Ok(None);
    };
    let bulges = bulges((system, case), finding, &clearances, motion, sweep)?;
    let by = |one: &&Beyond, other: &&Beyond| one.by.total_cmp(&other.by);
    let Some(farthest) = bulges.iter().max_by(by) else {
        return Ok(None);
    };
    let (rounds, count) = (found.rounds, system.setting.sites.len());
    let gives_up = |why| {
        Err(CaseError::Beyond {
            by_mm: 1e3 * farthest.by,
            from_bit: clearances.length() - farthest.depth,
            rounds,
            sites: count,
            why,
        })
    };
    let known = system.setting.sites.distances_from_bit();
    let mut new = Vec::new();
    for bulge in &bulges {
        let places = [
            site_near(bulge, finding, &clearances),
            rounded(clearances.length() - bulge.depth.max(LEAST_APART)),
        ];
        let is_free = |place: &f64| {
            let mut others = known.iter().chain(&new);
            others.all(|other| (other - place).abs() >= LEAST_APART)
        };
        new.extend(places.into_iter().find(is_free));
    }
    if new.is_empty() {
        return gives_up("there is a site next to it already");
    }
    if rounds == finding.rounds {
        return gives_up("`sites_rounds` allows no more rounds");
    }
    if count + new.len() > most_sites(&system.setting, &system.method) {
        return gives_up("no more sites are made; finite-element has most");
    }
    found.rounds += 1;
    found.sites.extend(new);
    found.sites.sort_by(f64::total_cmp);
    let setting = sweep.setting_with_sites(&system.setting, &found.sites)?;
    let longest = system.responses.longest_time;
    let case = case.at_sites_of(&setting)?;
    let system = (Recipe::of(sweep, &setting, system.method, longest).build())
        .and_then(|system| system.with_finer(sweep, method, longest))
        .map_err(CaseError::Responses)?;
    Ok(Some((system, case)))
}

/// A distance as it is given.
fn rounded(distance: f64) -> f64 {
    (distance * GIVEN_TO).round() / GIVEN_TO
}

/// How many sites a case has at most, those of the file among them.
pub fn most_sites(setting: &Setting, method: &Method) -> usize {
    match stepped_by(setting, method) {
        Some(_) => MOST_STEPPED,
        None => MOST_BY_TAPS,
    }
}

/// Where the string goes beyond the wall by more than the tolerance and than the neighbouring
/// sites, which press into an elastic wall.
fn bulges(
    (system, case): (&MethodSystem, &Case),
    finding: &Finding,
    clearances: &Clearances,
    motion: &Trajectory,
    sweep: &Sweep,
) -> Result<Vec<Beyond>, CaseError> {
    let moved = (&system.method, motion);
    let whole = reconstructed(sweep, (&system.setting, case), moved, &[])?;
    let Some(whole) = whole else {
        return Ok(Vec::new());
    };
    let sites = clearances.at_sites(motion);
    let allowed = |depth: f64| {
        let neighbours = sites
            .iter()
            .filter(|site| (site.0 - depth).abs() <= finding.every);
        let into_wall = neighbours.map(|site| site.1).fold(0.0, f64::max);
        finding.tolerance + into_wall
    };
    let mut bulges = clearances.bulges_beyond(&whole, allowed);
    bulges.retain(|bulge| clearances.length() - bulge.depth <= finding.to);
    Ok(bulges)
}

/// The place for a site, as a distance from the bit (m), where the string goes beyond the wall:
/// the nearest of those at even distances or, where that has more clearance, the middle of what
/// has so little.
fn site_near(bulge: &Beyond, finding: &Finding, clearances: &Clearances) -> f64 {
    let length = clearances.length();
    let even = ((length - bulge.depth) / finding.every).round() * finding.every;
    let last = (finding.to.min(length - LEAST_APART) / finding.every).floor() * finding.every;
    let even = rounded(even.min(last));
    let is_as_narrow = |clearance: f64| clearance <= bulge.clearance + SAME_CLEARANCE;
    if clearances.at(length - even).is_some_and(is_as_narrow) {
        return even;
    }
    let [from, to] = clearances.stretch_around(bulge.depth);
    rounded(length - 0.5 * (from + to))
}
