//! Single cases that are asked for, with what is changed of them.

use thiserror::Error;

use super::case::Case;
use super::case_error::CaseError;
use super::idle_axis::unused_reason;
use super::survey::longest_of_string;
use crate::plan::{Conditions, Setting, Sweep};
use crate::quantities::Axis;
use crate::sweep_file::SweepFileError;

/// A case, and for how long its linear systems are built, s.
#[derive(Debug, Clone)]
pub struct ChosenCase {
    /// The case.
    pub case: Case,
    /// That time.
    pub longest: f64,
}

/// Why a case cannot be chosen so.
#[derive(Debug, Error)]
pub enum ChoiceError {
    /// The sweep has no case of this number.
    #[error("case {index}: there are cases 0 to {last}")]
    NoCase {
        /// The number.
        index: usize,
        /// The last case.
        last: usize,
    },
    /// A quantity cannot have the value that is set.
    #[error("{}: {reason}", axis.name())]
    Set {
        /// The quantity.
        axis: Axis,
        /// What is wrong with the value.
        reason: String,
    },
    /// A weight on bit is set where nothing turns it into a torque.
    #[error("a weight on bit needs a rock to give a torque")]
    WeightWithoutRock,
    /// Cases that are shown together have different strings.
    #[error("cases of different strings cannot be drawn together")]
    DifferentStrings,
    /// The case makes no sense under what is set.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// One of the cases that share its string is invalid.
    #[error(transparent)]
    SharedString(CaseError),
    /// What is set makes no string, or an impulse is not felt.
    #[error(transparent)]
    File(#[from] SweepFileError),
}

/// A case with what is changed of it.
pub struct CaseChoice {
    /// Its number.
    pub index: usize,
    /// Its values on the axes.
    pub values: Vec<f64>,
    conditions: Conditions,
    /// Quantities of the string, by axes and as set.
    string: Vec<(Axis, f64)>,
    /// Whether one of them is set: no run has this string.
    sets_string: bool,
}

impl CaseChoice {
    /// A case of a sweep, with some quantities set to other values; of one set twice the last
    /// counts.
    ///
    /// # Errors
    /// Where the sweep has no such case, or what is set does not fit it.
    pub fn new(sweep: &Sweep, index: usize, set: &[(Axis, f64)]) -> Result<Self, ChoiceError> {
        let last = sweep.design.cases() - 1;
        if index > last {
            return Err(ChoiceError::NoCase { index, last });
        }
        let mut values = sweep.design.values(index);
        let mut conditions = sweep.conditions_at(&values);
        let axes = sweep.design.axes();
        for &(axis, value) in set {
            check_set(sweep, axis, value)?;
            conditions = conditions.with(axis, value);
            if let Some(place) = axes.iter().position(|own| *own == axis) {
                values[place] = value;
            }
        }
        let has_rock = sweep.bit.as_ref().is_some_and(|bit| bit.rock.is_some());
        if conditions.weight_on_bit_kn.is_some() && !has_rock {
            return Err(ChoiceError::WeightWithoutRock);
        }
        let of_axes = axes.iter().copied().zip(values.iter().copied());
        let all = of_axes.chain(set.iter().copied());
        let changes_string = |(axis, _): &(Axis, f64)| sweep.changes_string(*axis);
        Ok(Self {
            index,
            string: all.filter(changes_string).collect(),
            sets_string: set.iter().any(changes_string),
            values,
            conditions,
        })
    }

    /// The case under the setting of the sweep, which has its string by now.
    ///
    /// # Errors
    /// Where there is no such case, or an impulse of it is not felt.
    pub fn case(self, sweep: &Sweep) -> Result<ChosenCase, ChoiceError> {
        let longest = if self.sets_string {
            0.0
        } else {
            longest_of_string(sweep, &sweep.setting, self.index)
                .map_err(ChoiceError::SharedString)?
        };
        let (index, values) = (self.index, self.values);
        let case = Case::under(sweep, &sweep.setting, index, values, &self.conditions)?;
        sweep.impulses_are_felt(case.index, case.scene.timing.duration)?;
        Ok(ChosenCase {
            longest: longest.max(case.scene.timing.duration),
            case,
        })
    }
}

fn check_set(sweep: &Sweep, axis: Axis, value: f64) -> Result<(), ChoiceError> {
    let refused = |reason: String| ChoiceError::Set { axis, reason };
    axis.check(value)
        .map_err(|error| refused(error.to_string()))?;
    unused_reason(sweep, axis).map_or(Ok(()), |why| Err(refused(why.to_owned())))
}

/// The string of all chosen cases, which are shown together, or why they do not share one.
///
/// # Errors
/// Where they have not all the same, or what is set makes none.
pub fn common_setting(
    sweep: &Sweep,
    choices: &[CaseChoice],
) -> Result<Result<Setting, SweepFileError>, ChoiceError> {
    let string = choices.first().map_or(&[][..], |choice| &choice.string);
    if choices.iter().any(|choice| choice.string != string) {
        return Err(ChoiceError::DifferentStrings);
    }
    match sweep.setting_with(string.iter().copied()) {
        Ok(setting) => Ok(Ok(setting.into_owned())),
        Err(error) if choices.iter().any(|choice| choice.sets_string) => Err(error.into()),
        Err(error) => Ok(Err(error)),
    }
}
