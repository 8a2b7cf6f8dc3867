//! A sweep file as it was read, and what is asked of it before anything is built.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use campaign::engine::Survey;
use campaign::memory::Limit;
use campaign::sweep_file::MethodName;
use campaign::text_file::read_text;
use campaign::{Campaign, SurveyError};
use pyo3::prelude::*;

use crate::errors::{Lines, refused, warn};
use crate::wait::wait_for;

/// Every method that a sweep file may name.
const METHODS: [MethodName; 6] = [
    MethodName::Held,
    MethodName::Quadrature,
    MethodName::Hilbert,
    MethodName::FiniteElement,
    MethodName::DirectIdft,
    MethodName::Trapezoidal,
];

/// The texts of files, by their paths.
pub type Texts = BTreeMap<PathBuf, String>;

/// A sweep file that was read.
pub struct ReadSweep {
    /// What it says.
    pub campaign: Arc<Campaign>,
    /// Whether its errors name lines.
    pub lines: Lines,
    /// Where it is, or would be.
    pub path: PathBuf,
    /// The methods that replace its own.
    pub methods: Vec<String>,
    /// The texts of all files that were read for it.
    pub texts: Texts,
}

impl ReadSweep {
    /// Reads a sweep file, with these methods instead of the file's; files whose texts are given
    /// are not read.
    ///
    /// # Errors
    /// Where it does not make sense.
    pub fn new(
        py: Python<'_>,
        path: PathBuf,
        methods: Vec<String>,
        texts: Texts,
        lines: Lines,
    ) -> PyResult<Self> {
        let named = methods.iter().map(|name| method_named(name));
        let named = named.collect::<PyResult<Vec<_>>>()?;
        let read = || {
            let texts = RefCell::new(texts);
            let text_of = |path: &Path, most: u64| -> io::Result<String> {
                if let Some(text) = texts.borrow().get(path) {
                    return Ok(text.clone());
                }
                let text = read_text(path, most)?;
                texts.borrow_mut().insert(path.to_owned(), text.clone());
                Ok(text)
            };
            let campaign = Campaign::open(&path, &named, &text_of)?;
            Ok((campaign, texts.take()))
        };
        let (campaign, texts) = py
            .detach(read)
            .map_err(|error| lines.file_error(py, &error))?;
        // Which is what takes time of reading a sweep.
        let campaign = match campaign.sweep.content.accuracy {
            None => campaign,
            Some(_) => {
                let choose = move || campaign.choose(false, &Limit::of(None), &|_| {});
                wait_for(py, choose)?.map_err(|error| lines.file_error(py, &error))?
            }
        };
        for doubt in campaign.sweep.doubts() {
            warn(py, doubt)?;
        }
        Ok(Self {
            campaign: Arc::new(campaign),
            lines,
            path,
            methods,
            texts,
        })
    }

    /// The place of a method in the sweep's list, of the first where none is named.
    ///
    /// # Errors
    /// Where it is not in it.
    pub fn place_of(&self, method: Option<&str>) -> PyResult<usize> {
        let Some(name) = method else {
            return Ok(0);
        };
        let methods = self.campaign.sweep.methods.iter();
        let names: Vec<&str> = methods.map(|method| method.name()).collect();
        names
            .iter()
            .position(|known| *known == name)
            .ok_or_else(|| {
                let known = names.join(", ");
                refused(format_args!(
                    "`{name}` is not one of the sweep's methods: {known}"
                ))
            })
    }

    /// A look at every case before any is run.
    ///
    /// # Errors
    /// Where a case is refused, or an impulse of it is not felt.
    pub fn look(&self, py: Python<'_>) -> PyResult<Survey> {
        let campaign = Arc::clone(&self.campaign);
        let seen = wait_for(py, move || campaign.survey())?;
        seen.map_err(|error| match error {
            SurveyError::Case(reason) => self.about_file(reason),
            SurveyError::File(error) => self.lines.file_error(py, &error),
        })
    }

    /// An error that does not say which file it is about.
    pub fn about_file(&self, error: impl Display) -> PyErr {
        refused(format_args!("{}: {error}", self.path.display()))
    }
}

fn method_named(name: &str) -> PyResult<MethodName> {
    let found = METHODS.into_iter().find(|method| method.name() == name);
    found.ok_or_else(|| {
        let known = METHODS.map(MethodName::name).join(", ");
        refused(format_args!("unknown method `{name}`; known: {known}"))
    })
}
