//! `Sweep`: a sweep file, read and ready to run.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use campaign::engine::{Recipe, RunOptions};
use campaign::memory::{Limit, Size};
use linear::Method;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use results::window::WindowAsked;

use crate::about::about_sweep;
use crate::errors::{Lines, refused};
use crate::folders::{own_folder, window};
use crate::limits::{limit_curves, limits, whirl_limits};
use crate::read::{ReadSweep, Texts};
use crate::responses::Responses;
use crate::run::run;
use crate::simulate::{Asked, Simulation, simulate};
use crate::static_string::{Parts, static_string};
use crate::string::{Drillstring, check_number_of_sites};
use crate::wait::wait_for;

/// A sweep, ready to run.
#[pyclass(frozen, module = "drillstring._drillstring")]
pub struct Sweep(ReadSweep);

#[pymethods]
impl Sweep {
    /// Reads a sweep file, with these methods instead of the file's.
    #[staticmethod]
    #[pyo3(signature = (path, *, methods = None))]
    fn read(py: Python<'_>, path: PathBuf, methods: Option<Vec<String>>) -> PyResult<Self> {
        let methods = methods.unwrap_or_default();
        Self::of(py, path, methods, Texts::new(), Lines::Named)
    }

    /// The same of a text; files that it names are in a folder.
    #[staticmethod]
    #[pyo3(signature = (text, *, name = "sweep", folder = PathBuf::new(), methods = None))]
    fn from_toml(
        py: Python<'_>,
        text: String,
        name: &str,
        folder: PathBuf,
        methods: Option<Vec<String>>,
    ) -> PyResult<Self> {
        let path = folder.join(format!("{name}.toml"));
        let texts = Texts::from([(path.clone(), text)]);
        Self::of(py, path, methods.unwrap_or_default(), texts, Lines::Named)
    }

    /// The same of a table as JSON.
    #[staticmethod]
    fn _from_json(
        py: Python<'_>,
        json: &str,
        name: &str,
        folder: PathBuf,
        methods: Option<Vec<String>>,
    ) -> PyResult<Self> {
        let path = folder.join(format!("{name}.toml"));
        let table: toml::Table = serde_json::from_str(json)
            .map_err(|error| refused(format_args!("{}: {error}", path.display())))?;
        let text = toml::to_string(&table)
            .map_err(|error| refused(format_args!("{}: {error}", path.display())))?;
        let texts = Texts::from([(path.clone(), text)]);
        Self::of(py, path, methods.unwrap_or_default(), texts, Lines::Unnamed)
    }

    /// What was pickled.
    #[staticmethod]
    fn _from_texts(
        py: Python<'_>,
        path: PathBuf,
        methods: Vec<String>,
        texts: Texts,
        has_lines: bool,
    ) -> PyResult<Self> {
        let lines = if has_lines {
            Lines::Named
        } else {
            Lines::Unnamed
        };
        Self::of(py, path, methods, texts, lines)
    }

    /// What [`Sweep::_from_texts`] makes it of.
    fn _parts(&self) -> (PathBuf, Vec<String>, Texts, bool) {
        let ReadSweep {
            path,
            methods,
            texts,
            lines,
            ..
        } = &self.0;
        let has_lines = *lines == Lines::Named;
        (path.clone(), methods.clone(), texts.clone(), has_lines)
    }

    /// The file's name without its ending.
    #[getter]
    fn name(&self) -> &str {
        &self.0.campaign.sweep.name
    }

    /// One line for pictures.
    #[getter]
    fn title(&self) -> &str {
        &self.0.campaign.sweep.title
    }

    /// Names of the linear methods.
    #[getter]
    fn methods(&self) -> Vec<&'static str> {
        self.0
            .campaign
            .sweep
            .methods
            .iter()
            .map(|method| method.name())
            .collect()
    }

    /// Names of what the design varies.
    #[getter]
    fn axes(&self) -> Vec<String> {
        self.0
            .campaign
            .sweep
            .design
            .axes()
            .iter()
            .map(|axis| axis.name())
            .collect()
    }

    /// Number of cases.
    #[getter]
    fn cases(&self) -> usize {
        self.0.campaign.sweep.design.cases()
    }

    /// The values of a case along the axes.
    fn values<'py>(&self, py: Python<'py>, case: usize) -> PyResult<Bound<'py, PyDict>> {
        let cases = self.0.campaign.sweep.design.cases();
        if case >= cases {
            let last = cases - 1;
            return Err(refused(format_args!(
                "case {case}: there are cases 0 to {last}"
            )));
        }
        let values = PyDict::new(py);
        for (axis, value) in self
            .axes()
            .into_iter()
            .zip(self.0.campaign.sweep.design.values(case))
        {
            values.set_item(axis, value)?;
        }
        Ok(values)
    }

    /// The string as the file says it.
    #[getter]
    fn string(&self) -> Drillstring {
        let string = self.0.campaign.sweep.setting.string.clone();
        Drillstring { string }
    }

    /// Distances of the sites from the bit, m, from the surface down.
    #[getter]
    fn sites(&self) -> Vec<f64> {
        self.0
            .campaign
            .sweep
            .setting
            .sites
            .distances_from_bit()
            .to_vec()
    }

    /// Sampling frequency, Hz.
    #[getter]
    fn sampling_frequency(&self) -> f64 {
        self.0.campaign.sweep.setting.sampling_frequency
    }

    /// The file with its bases as JSON.
    fn _json(&self) -> PyResult<String> {
        serde_json::to_string(&self.0.campaign.sweep.content).map_err(refused)
    }

    /// The impulse responses by which a run steps the string as the file says it: those of its
    /// first method, or of one that is named.
    #[pyo3(signature = (method = None))]
    fn responses(&self, py: Python<'_>, method: Option<&str>) -> PyResult<Responses> {
        let method = self.0.campaign.sweep.methods[self.0.place_of(method)?];
        // Elements are stepped where sites are many.
        if !matches!(method, Method::FiniteElement(_)) {
            check_number_of_sites(&self.0.campaign.sweep.setting.sites)?;
        }
        let longest = self.0.look(py)?.longest;
        let campaign = Arc::clone(&self.0.campaign);
        let built = wait_for(py, move || {
            let setting = campaign.sweep.setting.for_labels();
            Recipe::of(&campaign.sweep, &setting, method, longest).build()
        })?;
        let system = built.map_err(|error| self.0.lines.any_error(py, &error))?;
        Responses::new(system.responses)
    }

    /// Follows a case to the end of its time, with some quantities set to other values, by the
    /// sweep's first method or by one that is named.
    #[pyo3(signature = (
        case = 0, *, set = None, method = None, full = false, allow_unstable = false,
        memory = None
    ))]
    #[expect(clippy::too_many_arguments, reason = "keywords")]
    fn simulate(
        &self,
        py: Python<'_>,
        case: usize,
        set: Option<BTreeMap<String, f64>>,
        method: Option<&str>,
        full: bool,
        allow_unstable: bool,
        memory: Option<&str>,
    ) -> PyResult<Simulation> {
        let options = RunOptions {
            full,
            allow_unstable,
        };
        let asked = Asked {
            case,
            set: set.unwrap_or_default(),
            method: self.0.place_of(method)?,
            options,
            limit: limit_of(memory)?,
        };
        simulate(py, &self.0, asked)
    }

    /// The analytic limit, by the columns of `boundary.csv`.
    #[pyo3(signature = (*, memory = None))]
    fn _limits<'py>(&self, py: Python<'py>, memory: Option<&str>) -> PyResult<Bound<'py, PyDict>> {
        limits(py, &self.0, limit_of(memory)?)
    }

    /// The same as curves.
    #[pyo3(signature = (*, memory = None))]
    fn _limit_curves<'py>(
        &self,
        py: Python<'py>,
        memory: Option<&str>,
    ) -> PyResult<Vec<Bound<'py, PyDict>>> {
        limit_curves(py, &self.0, limit_of(memory)?)
    }

    /// How the string lies at rest in its hole: numbers as JSON, and the columns of
    /// `static_string.csv` and `static_contacts.csv`; nothing where it does not.
    #[pyo3(signature = (*, bit = None))]
    fn _static_string<'py>(
        &self,
        py: Python<'py>,
        bit: Option<&str>,
    ) -> PyResult<Option<Parts<'py>>> {
        static_string(py, &self.0, bit)
    }

    /// What a table of its run is of.
    fn _about<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        about_sweep(py, &self.0.campaign.sweep)
    }

    /// The limit of whirl between two surface speeds (rpm), by the columns of `boundary.csv`.
    fn _whirl_limits<'py>(
        &self,
        py: Python<'py>,
        least: f64,
        most: f64,
    ) -> PyResult<Bound<'py, PyDict>> {
        whirl_limits(py, &self.0, [least, most])
    }

    /// The operating window by results folders of its string, by the columns of `window.csv`; and
    /// the best point.
    #[pyo3(signature = (folders, *, orders, held_at, margin, risk, bins, clearance, accept_chatter))]
    #[expect(clippy::too_many_arguments, reason = "keywords")]
    fn _window<'py>(
        &self,
        py: Python<'py>,
        folders: Option<Vec<PathBuf>>,
        orders: Vec<f64>,
        held_at: Option<Vec<f64>>,
        margin: f64,
        risk: f64,
        bins: usize,
        clearance: f64,
        accept_chatter: bool,
    ) -> PyResult<(Bound<'py, PyDict>, Option<Bound<'py, PyDict>>)> {
        let asked = WindowAsked {
            orders,
            held_at,
            margin,
            risk,
            bins,
            accept_chatter,
        };
        let folders = folders.unwrap_or_else(|| vec![own_folder(&self.0)]);
        window(py, &self.0, folders, asked, clearance)
    }

    /// Runs every case by every method, and gives the columns of `labels.csv` by name.
    #[pyo3(signature = (
        *, threads = None, progress = None, full = false, allow_unstable = false, memory = None
    ))]
    fn _run<'py>(
        &self,
        py: Python<'py>,
        threads: Option<usize>,
        progress: Option<Bound<'py, PyAny>>,
        full: bool,
        allow_unstable: bool,
        memory: Option<&str>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let options = RunOptions {
            full,
            allow_unstable,
        };
        run(py, &self.0, threads, progress, options, limit_of(memory)?)
    }

    fn __repr__(&self) -> String {
        let (name, cases) = (&self.0.campaign.sweep.name, self.cases());
        format!(
            "<Sweep {name}: {cases} cases by {}>",
            self.methods().join(", ")
        )
    }
}

impl Sweep {
    fn of(
        py: Python<'_>,
        path: PathBuf,
        methods: Vec<String>,
        texts: Texts,
        lines: Lines,
    ) -> PyResult<Self> {
        ReadSweep::new(py, path, methods, texts, lines).map(Self)
    }
}

/// The most memory that something may take, as the command has it.
fn limit_of(memory: Option<&str>) -> PyResult<Limit> {
    let size = memory.map(str::parse::<Size>).transpose();
    Ok(Limit::of(size.map_err(refused)?))
}
