//! A look at every case before any is run: how many there are, how long they
//! take, and whether each makes sense.

use std::borrow::Cow;

use linear::parallel;

use super::case::Case;
use super::case_error::CaseError;
use super::memory::StringMemory;
use crate::plan::{Setting, Sweep};
use crate::sweep_file::SweepFileError;

/// Cases that a thread looks at before it asks for more.
const CASES_AT_ONCE: usize = 256;

/// What a sweep is going to be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Survey {
    /// Time simulated by each method, s.
    pub simulated: f64,
    /// The longest that a case takes, s: of random cases, any within their ranges.
    pub longest: f64,
    /// The first case that lasts as long; none of random cases, whose ranges allow more
    /// than is drawn.
    pub longest_case: Option<usize>,
    /// The case that ends first, and when, s; none where no string can be.
    pub first_end: Option<(usize, f64)>,
    /// The string that takes most memory, where axes change the string.
    pub heaviest: Option<Heaviest>,
    /// Values that make no string; their cases will fail.
    pub impossible_strings: usize,
}

/// The string that takes most memory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Heaviest {
    /// Its number.
    pub string: usize,
    /// The longest of its cases, s.
    pub longest: f64,
    /// What building its systems takes, bytes.
    bytes: f64,
}

impl Survey {
    /// Both parts of a sweep, the first being earlier.
    fn with(self, other: Survey) -> Survey {
        let longer = if other.longest > self.longest {
            other
        } else {
            self
        };
        let strings = self.heaviest.into_iter().chain(other.heaviest);
        let ends = self.first_end.into_iter().chain(other.first_end);
        Survey {
            simulated: self.simulated + other.simulated,
            longest: longer.longest,
            longest_case: longer.longest_case,
            // The first of equals.
            heaviest: strings
                .reduce(|one, other| if one.bytes >= other.bytes { one } else { other }),
            first_end: ends.reduce(|one, other| if other.1 < one.1 { other } else { one }),
            impossible_strings: self.impossible_strings + other.impossible_strings,
        }
    }
}

/// Looks at every case of a sweep.
///
/// # Errors
/// Where a case has conditions that make no sense.
pub fn survey(sweep: &Sweep) -> Result<Survey, CaseError> {
    sum_of(sweep.design.strings(), |string| {
        let Ok(setting) = setting_of(sweep, string) else {
            return Ok(Survey {
                impossible_strings: 1,
                ..Survey::default()
            });
        };
        let mut found = of_string(sweep, &setting, string)?;
        if sweep.design.varies_string() {
            let longest = found.longest;
            let memory = StringMemory::of(sweep, &setting.for_labels(), &sweep.methods, longest);
            found.heaviest = Some(Heaviest {
                string,
                longest,
                bytes: memory.systems.peak,
            });
        }
        Ok(found)
    })
}

/// The longest of the cases that share a string with case `index`, s: the time for
/// which a run builds the linear systems of that string.
///
/// # Errors
/// As [`survey`].
pub fn longest_of_string(sweep: &Sweep, setting: &Setting, index: usize) -> Result<f64, CaseError> {
    Ok(of_string(sweep, setting, sweep.design.string_of(index))?.longest)
}

/// Looks at the cases of one string.
///
/// # Errors
/// As [`survey`].
pub(super) fn of_string(
    sweep: &Sweep,
    setting: &Setting,
    string: usize,
) -> Result<Survey, CaseError> {
    let cases = sweep.design.cases_of_string(string);
    let mut survey = sum_of(cases, |position| {
        let index = sweep.design.case_of_string(string, position);
        let case = Case::of(sweep, setting, index)?;
        let duration = case.scene.timing.duration;
        Ok(Survey {
            simulated: duration,
            longest: duration,
            longest_case: Some(case.index),
            first_end: Some((case.index, duration)),
            ..Survey::default()
        })
    })?;
    if !sweep.design.varies_string() {
        // The responses that all cases share do not depend on how many are drawn.
        for corner in sweep.design.corners() {
            let conditions = sweep.conditions_at(&corner);
            let case = Case::under(sweep, setting, 0, corner, &conditions)
                .map_err(|reason| CaseError::AtAnEnd(Box::new(reason)))?;
            let duration = case.scene.timing.duration;
            if duration > survey.longest {
                survey.longest = duration;
                survey.longest_case = None;
            }
        }
    }
    Ok(survey)
}

/// The setting of all cases of a string.
///
/// # Errors
/// Where it makes no string.
pub fn setting_of(sweep: &Sweep, string: usize) -> Result<Cow<'_, Setting>, SweepFileError> {
    let case = sweep.design.case_of_string(string, 0);
    sweep.setting_at(&sweep.design.values(case))
}

/// The sum over `count` parts, or the error of the first part that has one, for any number of
/// threads.
fn sum_of(
    count: usize,
    part: impl Fn(usize) -> Result<Survey, CaseError> + Sync + Send,
) -> Result<Survey, CaseError> {
    // Neighbours are joined, the earlier being the first.
    let nothing = || Ok(Survey::default());
    parallel::reduce(count, CASES_AT_ONCE, part, nothing, |one, other| {
        Ok(one?.with(other?))
    })
}
