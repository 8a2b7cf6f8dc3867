//! A look at every case before any is run: how many there are, how long they
//! take, and whether each makes sense.

use std::borrow::Cow;

use rayon::prelude::*;

use super::case::Case;
use crate::spec::{Setting, SpecError, Sweep};

/// Cases that a thread looks at before it asks for more.
const CASES_AT_ONCE: usize = 256;

/// What a sweep is going to be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Survey {
    /// Time simulated by each method, s.
    pub simulated: f64,
    /// The longest of it, s.
    pub longest: f64,
    /// Strings that cannot be; their cases will fail.
    pub impossible_strings: usize,
}

impl Survey {
    fn with(self, other: Survey) -> Survey {
        Survey {
            simulated: self.simulated + other.simulated,
            longest: self.longest.max(other.longest),
            impossible_strings: self.impossible_strings + other.impossible_strings,
        }
    }
}

/// Looks at every case of a sweep.
///
/// # Errors
/// Where a case has conditions that make no sense; a sentence that names it.
pub fn survey(sweep: &Sweep) -> Result<Survey, String> {
    first_error(sweep.design.strings(), |string| {
        match setting_of(sweep, string) {
            Ok(setting) => of_string(sweep, &setting, string),
            Err(_) => Ok(Survey {
                impossible_strings: 1,
                ..Survey::default()
            }),
        }
    })
}

/// The longest of the cases that share a string with case `index`, s: the time for
/// which a run builds the linear systems of that string.
///
/// # Errors
/// As [`survey`].
pub fn longest_beside(sweep: &Sweep, setting: &Setting, index: usize) -> Result<f64, String> {
    Ok(of_string(sweep, setting, sweep.design.string_of(index))?.longest)
}

/// Looks at the cases of one string.
///
/// # Errors
/// As [`survey`].
pub(super) fn of_string(sweep: &Sweep, setting: &Setting, string: usize) -> Result<Survey, String> {
    let cases = sweep.design.cases_of_string(string);
    first_error(cases.len(), |position| {
        let case = Case::of(sweep, setting, cases.get(position))?;
        let duration = case.scene.timing.duration;
        Ok(Survey {
            simulated: duration,
            longest: duration,
            impossible_strings: 0,
        })
    })
}

/// The setting of all cases of a string.
pub(super) fn setting_of(sweep: &Sweep, string: usize) -> Result<Cow<'_, Setting>, SpecError> {
    let case = sweep.design.cases_of_string(string).get(0);
    sweep.setting_at(&sweep.design.values(case))
}

/// The sum over `count` parts, or the error of the first part that has one,
/// whatever the number of threads.
fn first_error(
    count: usize,
    part: impl Fn(usize) -> Result<Survey, String> + Sync,
) -> Result<Survey, String> {
    (0..count)
        .into_par_iter()
        .with_min_len(CASES_AT_ONCE)
        .map(|index| part(index).map_err(|error| (index, error)))
        .reduce(
            || Ok(Survey::default()),
            |one, other| match (one, other) {
                (Ok(one), Ok(other)) => Ok(one.with(other)),
                (Err(one), Err(other)) => Err(if one.0 <= other.0 { one } else { other }),
                (Err(error), Ok(_)) | (Ok(_), Err(error)) => Err(error),
            },
        )
        .map_err(|(_, error)| error)
}
