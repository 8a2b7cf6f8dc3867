//! Errors as exceptions, in the words of the command.

use std::fmt::Display;

use campaign::sweep_file::SweepFileError as FileError;
use pyo3::create_exception;
use pyo3::exceptions::{PyUserWarning, PyValueError};
use pyo3::prelude::*;

create_exception!(
    drillstring,
    DrillstringError,
    PyValueError,
    "Invalid input, or a case without an answer."
);

create_exception!(
    drillstring,
    SweepFileError,
    DrillstringError,
    "A sweep file that is refused; `file`, `line` and `key` say where, `message` why."
);

create_exception!(
    drillstring,
    DrillstringWarning,
    PyUserWarning,
    "What is worth knowing though nothing is wrong with it."
);

/// An error in its own words.
pub fn refused(error: impl Display) -> PyErr {
    DrillstringError::new_err(error.to_string())
}

/// Tells where a sweep file is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lines {
    /// As they stand in the file.
    Named,
    /// There are none: the sweep was made from a table in memory.
    Unnamed,
}

impl Lines {
    /// An error of a sweep file.
    pub fn file_error(self, py: Python<'_>, error: &FileError) -> PyErr {
        let file = error.file().display().to_string();
        let line = error.line().filter(|_| self == Lines::Named);
        let words = match self {
            Lines::Named => error.to_string(),
            Lines::Unnamed => {
                let key = error
                    .key()
                    .map_or_else(String::new, |key| format!(": `{key}`"));
                format!("{file}{key}: {}", error.message())
            }
        };
        let exception = SweepFileError::new_err(words);
        let value = exception.value(py);
        let set = || {
            value.setattr("file", &file)?;
            value.setattr("line", line)?;
            value.setattr("key", error.key())?;
            value.setattr("message", error.message())
        };
        set().err().unwrap_or(exception)
    }

    /// Any error, which may be one of the sweep file.
    pub fn any_error(self, py: Python<'_>, error: &anyhow::Error) -> PyErr {
        match error.downcast_ref::<FileError>() {
            Some(error) => self.file_error(py, error),
            None => refused(format_args!("{error:#}")),
        }
    }
}

/// What its modules are called.
const PACKAGE: &str = "drillstring";

/// Warns of something, at the line of the user's that called the package: its own lines say nothing
/// to a reader, and a warning is shown once for each line.
///
/// # Errors
/// Where warnings are errors.
pub fn warn(py: Python<'_>, words: impl Display) -> PyResult<()> {
    let message = std::ffi::CString::new(words.to_string().replace('\0', " "));
    let category = py.get_type::<DrillstringWarning>();
    PyErr::warn(
        py,
        &category,
        &message.unwrap_or_default(),
        own_frames(py)? + 1,
    )
}

/// How many of the innermost frames of Python are of the package itself.
fn own_frames(py: Python<'_>) -> PyResult<i32> {
    let mut frame = py.import("sys")?.call_method0("_getframe")?;
    let mut count = 0;
    while !frame.is_none() {
        let module = frame
            .getattr("f_globals")?
            .call_method1("get", ("__name__", ""))?;
        let module: String = module.extract()?;
        if module != PACKAGE && !module.starts_with(&format!("{PACKAGE}.")) {
            break;
        }
        count += 1;
        frame = frame.getattr("f_back")?;
    }
    Ok(count)
}
