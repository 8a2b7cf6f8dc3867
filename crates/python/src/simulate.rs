//! `Sweep.simulate`: a case in full, as `sweep simulate` has it.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;

use campaign::Campaign;
use campaign::engine::{ChoiceError, RunOptions};
use campaign::follow::{FollowError, Followed, Following, KeptSystems};
use campaign::labels::LabelTable;
use campaign::memory::Limit;
use campaign::quantities::Axis;
use campaign::records::Record;
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
    /// Draws its motion over time as `sweep simulate` does, a panel below the other, and gives their
    /// axes; on those of another method of the same case, where they are given. Needs matplotlib.
    #[pyo3(signature = (*, axes = None))]
    fn plot<'py>(
        this: &Bound<'py, Self>,
        axes: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let module = this.py().import("drillstring._plot")?;
        module.call_method1("draw_history", (this, axes))
    }

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

/// Follows a case to the end of its time.
///
/// # Errors
/// Where there is no such case, or it would take too much memory.
pub fn simulate(py: Python<'_>, sweep: &ReadSweep, asked: Asked) -> PyResult<Simulation> {
    let set = asked.set.iter();
    let set = set.map(|(name, value)| {
        axis_in_units(name)
            .map(|(axis, factor)| (axis, factor * value))
            .map_err(refused)
    });
    let set = set.collect::<PyResult<Vec<_>>>()?;
    let campaign = Arc::clone(&sweep.campaign);
    let seen = wait_for(py, move || Seen::of(&campaign, &set, &asked))?;
    let Seen {
        record,
        motion,
        doubt,
    } = seen.map_err(|error| in_words(py, sweep, error))?;
    if let Some(doubt) = doubt {
        warn(py, doubt)?;
    }
    let row = PyDict::new(py);
    put_row(&LabelTable::of(&sweep.campaign.sweep), &record, &row)?;
    let motion = motion.map(|motion| Py::new(py, motion));
    Ok(Simulation {
        row: row.unbind(),
        motion: motion.transpose()?,
        failure: record.outcome.err().map(|why| why.to_string()),
    })
}

/// Why a case is not followed.
enum Refusal {
    Choice(ChoiceError),
    Following(FollowError),
}

fn in_words(py: Python<'_>, sweep: &ReadSweep, error: Refusal) -> PyErr {
    use FollowError::{Case, DifferentSites, Memory, Motion, Sites, Systems};
    match error {
        Refusal::Choice(ChoiceError::File(error)) | Refusal::Following(Sites(error)) => {
            sweep.lines.file_error(py, &error)
        }
        Refusal::Choice(ChoiceError::SharedString(reason)) => sweep.about_file(reason),
        Refusal::Choice(error) => refused(error),
        Refusal::Following(Memory(error) | Systems(error) | Motion(error)) => {
            sweep.lines.any_error(py, &error)
        }
        Refusal::Following(error @ (Case(_) | DifferentSites)) => refused(error),
    }
}

/// A case that was followed to its end.
struct Seen {
    record: Record,
    motion: Option<Motion>,
    /// What is to be said of the method.
    doubt: Option<String>,
}

impl Seen {
    /// The row of a case and its motion, as the command has them of a case by one method.
    fn of(campaign: &Campaign, set: &[(Axis, f64)], asked: &Asked) -> Result<Self, Refusal> {
        let doubt = RefCell::new(None);
        let chosen = campaign.cases(&[asked.case], set, &[asked.method]);
        let (mut rows, motion) = match chosen.map_err(Refusal::Choice)? {
            Err(rows) => (rows, None),
            Ok(chosen) => {
                let following = Following {
                    options: asked.options,
                    memory: Some((&asked.limit, 0)),
                    warn: &|instability| *doubt.borrow_mut() = Some(instability.to_string()),
                };
                let followed = chosen.follow(&following, &mut KeptSystems::default());
                let Followed {
                    sweep,
                    rows,
                    simulations,
                    ..
                } = followed.map_err(Refusal::Following)?;
                let simulation = simulations.into_iter().next();
                let motion = simulation.map(|simulation| Motion {
                    sites: sweep.setting.sites.distances_from_bit().to_vec(),
                    trajectory: simulation.trajectory,
                });
                (rows, motion)
            }
        };
        Ok(Self {
            // One case by one method has one row.
            record: rows.swap_remove(0),
            motion,
            doubt: doubt.into_inner(),
        })
    }
}
