//! `Sweep.simulate`: a case in full, as `sweep simulate` has it.

use std::collections::BTreeMap;
use std::sync::Arc;

use campaign::engine::{
    Choice, ChoiceError, ChosenCase, FollowedMethod, MethodSystem, RunOptions, Survey, answer,
    common_setting,
};

use campaign::labels::LabelTable;
use campaign::memory::{Limit, Purpose, admit};
use campaign::plan::Sweep as Plan;
use campaign::records::{Failure, Record};
use campaign::sweep_file::axis_in_units;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::{refused, warn};
use crate::motion::Motion;
use crate::read::ReadSweep;
use crate::table::put_row;
use crate::wait::wait_for;

/// A case by a method, followed to the end of its time.
#[pyclass(frozen, module = "drillstring")]
pub struct Simulation {
    /// What a run has of it, by column.
    #[pyo3(get)]
    row: Py<PyDict>,
    /// Its motion; none where it has no answer.
    #[pyo3(get)]
    motion: Option<Py<Motion>>,
    /// Why it has none.
    #[pyo3(get)]
    failure: Option<String>,
}

#[pymethods]
impl Simulation {
    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let row = self.row.bind(py);
        let word = |column| {
            row.get_item(column)?
                .map_or(Ok(String::new()), |it| it.extract())
        };
        let (method, case): (String, usize) = (word("method")?, case_of(row)?);
        Ok(format!("<Simulation of case {case} by {method}>"))
    }
}

fn case_of(row: &Bound<'_, PyDict>) -> PyResult<usize> {
    row.get_item("case")?.map_or(Ok(0), |case| case.extract())
}

/// A case that is asked for.
pub struct Asked {
    /// Its number.
    pub case: usize,
    /// What is set of it, by the names of axes.
    pub set: BTreeMap<String, f64>,
    /// The method's place in the sweep's list.
    pub method: usize,
    /// How it is simulated.
    pub options: RunOptions,
    /// The most memory that it may take.
    pub limit: Limit,
}

/// What a case comes to.
struct Followed {
    record: Record,
    motion: Option<Motion>,
    /// What is to be said of the method.
    doubt: Option<String>,
}

/// Follows a case to the end of its time.
///
/// # Errors
/// Where there is no such case, or it would take too much memory.
pub fn simulate(py: Python<'_>, sweep: &ReadSweep, asked: Asked) -> PyResult<Simulation> {
    let words = |error: ChoiceError| match error {
        ChoiceError::File(error) => sweep.lines.file_error(py, &error),
        ChoiceError::Beside(reason) => sweep.about_file(reason),
        _ => refused(error),
    };
    let set = asked.set.iter();
    let set = set.map(|(name, value)| {
        axis_in_units(name)
            .map(|(axis, factor)| (axis, factor * value))
            .map_err(refused)
    });
    let set = set.collect::<PyResult<Vec<_>>>()?;
    let choice = Choice::new(&sweep.plan, asked.case, &set).map_err(words)?;
    let plan = Arc::clone(&sweep.plan);
    let followed = wait_for(py, move || follow(&plan, choice, &asked))?;
    let followed = followed.map_err(|error| match error.downcast::<ChoiceError>() {
        Ok(error) => words(error),
        Err(error) => sweep.lines.any_error(py, &error),
    })?;
    if let Some(doubt) = &followed.doubt {
        warn(py, doubt)?;
    }
    let row = PyDict::new(py);
    put_row(&LabelTable::of(&sweep.plan), &followed.record, &row)?;
    let motion = followed.motion.map(|motion| Py::new(py, motion));
    Ok(Simulation {
        row: row.unbind(),
        motion: motion.transpose()?,
        failure: followed.record.outcome.err().map(|why| why.to_string()),
    })
}

/// The row of a case and its motion, as the command has them of a case by one method.
fn follow(plan: &Plan, choice: Choice, asked: &Asked) -> anyhow::Result<Followed> {
    let (method, limit) = (asked.method, &asked.limit);
    let options = RunOptions {
        // A run refuses the method before any row: what it would do can be seen here.
        allow_unstable: asked.options.allow_unstable || !plan.design.varies_string(),
        ..asked.options
    };
    let failed = |index, values, reason: Failure| Followed {
        record: Record::failed(index, method, values, reason),
        motion: None,
        doubt: None,
    };
    let setting = match common_setting(plan, std::slice::from_ref(&choice))? {
        Ok(setting) => setting,
        // Values that make no string: a case without an answer.
        Err(reason) => return Ok(failed(choice.index, choice.values, Failure::new(reason))),
    };
    let mut plan = Plan {
        setting,
        ..plan.clone()
    };
    let mut chosen = choice.case(&plan)?;
    admit_history(&plan, &chosen, limit)?;
    let build = |plan: &Plan, longest| {
        let setting = plan.setting.for_labels();
        MethodSystem::build_for(plan, &setting, plan.methods[method], longest)
    };
    let refuse = |error: anyhow::Error, chosen: &ChosenCase| {
        // Where all cases share the string, a run would not begin.
        match plan.design.varies_string() {
            true => Ok(failed(
                chosen.case.index,
                chosen.case.values.clone(),
                Failure::new(format_args!("{error:#}")),
            )),
            false => Err(error),
        }
    };
    let mut system = match build(&plan, chosen.longest) {
        Ok(system) => system,
        Err(error) => return refuse(error, &chosen),
    };
    let mut found = None;
    if plan
        .setting
        .lateral
        .as_ref()
        .is_some_and(|lateral| lateral.finding.is_some())
    {
        let row = answer(&system, &chosen.case, method, options, &plan);
        let sites = match &row.outcome {
            Ok(_) => row.found.as_ref().map(|found| found.sites.clone()),
            Err(_) => None,
        };
        let Some(sites) = sites else {
            return Ok(Followed {
                record: row,
                motion: None,
                doubt: None,
            });
        };
        plan.setting = plan.setting_with_sites(&plan.setting, &sites)?;
        chosen.case = chosen.case.at_sites_of(&plan.setting)?;
        admit_history(&plan, &chosen, limit)?;
        system = build(&plan, chosen.longest)?;
        // That of a run, which says in how many rounds they were found.
        found = Some(row);
    }
    let doubt = system.instability().filter(|_| options.allow_unstable);
    let followed = FollowedMethod::new(&plan, system, chosen.longest)?;
    let (record, simulation) = followed.simulate(&plan, &chosen.case, method, options, true)?;
    let sites = plan.setting.sites.distances_from_bit();
    Ok(Followed {
        record: found.unwrap_or(record),
        motion: simulation.map(|simulation| Motion {
            sites: sites.to_vec(),
            trajectory: simulation.trajectory,
        }),
        doubt: doubt.map(|doubt| doubt.to_string()),
    })
}

/// Refuses what would take more memory than is allowed.
fn admit_history(plan: &Plan, chosen: &ChosenCase, limit: &Limit) -> anyhow::Result<()> {
    let survey = Survey {
        longest: chosen.longest,
        ..Survey::default()
    };
    let purpose = Purpose::Histories {
        cases: 1,
        shapes: 0,
    };
    admit(plan, &plan.setting, &survey, purpose, limit)?;
    Ok(())
}
