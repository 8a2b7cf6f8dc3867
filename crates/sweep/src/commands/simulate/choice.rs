//! The cases that are asked for, with what the command line changes of them.

use std::path::Path;

use anyhow::{Result, bail};

use crate::cli::SimulateArguments;
use crate::commands::idle_axis::refuse_idle_axis;
use crate::commands::prepare::unique;
use crate::commands::status::UsageError;
use campaign::engine::{Case, longest_beside};
use campaign::plan::{Conditions, Setting, Sweep};
use campaign::quantities::Axis;
use campaign::sweep_file::SweepFileError;

/// A case, and for how long its linear systems are built, s.
pub struct ChosenCase {
    /// The case.
    pub case: Case,
    /// That time.
    pub longest: f64,
}

/// A case with what the command line changes of it.
pub struct Choice {
    /// Its number.
    pub index: usize,
    /// Its values on the axes.
    pub values: Vec<f64>,
    conditions: Conditions,
    /// Quantities of the string, by axes and by `--set`.
    string: Vec<(Axis, f64)>,
    /// Whether `--set` gives one of them: no run has this string.
    sets_string: bool,
}

impl Choice {
    /// Every case that is asked for, once.
    ///
    /// # Errors
    /// Where the sweep has no such case, or what is set does not fit it.
    pub fn all(sweep: &Sweep, arguments: &SimulateArguments) -> Result<Vec<Self>> {
        (unique(&arguments.case).into_iter())
            .map(|index| Self::new(sweep, arguments, index))
            .collect()
    }

    fn new(sweep: &Sweep, arguments: &SimulateArguments, index: usize) -> Result<Self> {
        let cases = sweep.design.cases();
        if index >= cases {
            bail!(UsageError(format!(
                "--case {index}: {} has cases 0 to {}",
                arguments.file.display(),
                cases - 1
            )));
        }
        let mut values = sweep.design.values(index);
        let mut conditions = sweep.conditions_at(&values);
        let axes = sweep.design.axes();
        for &(axis, value) in &arguments.set {
            axis.check(value)
                .map_err(|reason| UsageError(format!("--set {}: {reason}", axis.name())))?;
            refuse_idle_axis(sweep, axis)?;
            conditions = conditions.with(axis, value);
            if let Some(place) = axes.iter().position(|own| *own == axis) {
                values[place] = value;
            }
        }
        refuse_weight_without_rock(sweep, &conditions)?;
        let of_axes = axes.iter().copied().zip(values.iter().copied());
        let all = of_axes.chain(arguments.set.iter().copied());
        let changes_string = |(axis, _): &(Axis, f64)| sweep.changes_string(*axis);
        Ok(Self {
            index,
            string: all.filter(changes_string).collect(),
            sets_string: arguments.set.iter().any(changes_string),
            values,
            conditions,
        })
    }

    /// The case under the setting of the sweep, which has its string by now.
    ///
    /// # Errors
    /// Where there is no such case, or an impulse of it is not felt.
    pub fn case(self, sweep: &Sweep, file: &Path) -> Result<ChosenCase> {
        let beside = if self.sets_string {
            0.0
        } else {
            longest_beside(sweep, &sweep.setting, self.index)
                .map_err(|reason| UsageError(format!("{}: {reason}", file.display())))?
        };
        let (index, values) = (self.index, self.values);
        let case = Case::under(sweep, &sweep.setting, index, values, &self.conditions)
            .map_err(|reason| UsageError(reason.to_string()))?;
        sweep.impulses_are_felt(case.index, case.scene.timing.duration)?;
        Ok(ChosenCase {
            longest: beside.max(case.scene.timing.duration),
            case,
        })
    }
}

/// The string of all chosen cases, which are drawn in one picture, or why they have
/// none.
///
/// # Errors
/// Where they have not all the same, or what is set makes none.
pub fn common_setting(
    sweep: &Sweep,
    choices: &[Choice],
) -> Result<Result<Setting, SweepFileError>> {
    let string = choices.first().map_or(&[][..], |choice| &choice.string);
    if choices.iter().any(|choice| choice.string != string) {
        bail!(UsageError(
            "--case: cases of different strings cannot be drawn beside each other".to_owned()
        ));
    }
    match sweep.setting_with(string.iter().copied()) {
        Ok(setting) => Ok(Ok(setting.into_owned())),
        Err(error) if choices.iter().any(|choice| choice.sets_string) => Err(error.into()),
        Err(error) => Ok(Err(error)),
    }
}

fn refuse_weight_without_rock(sweep: &Sweep, conditions: &Conditions) -> Result<()> {
    let has_rock = sweep.bit.as_ref().is_some_and(|bit| bit.rock.is_some());
    if conditions.weight_on_bit_kn.is_some() && !has_rock {
        bail!(UsageError(
            "a weight on bit needs a rock to give a torque".to_owned()
        ));
    }
    Ok(())
}
