//! The Python package `drillstring`: a thin shell around [`campaign`], [`linear`] and [`sim`].
//!
//! There is no physics in it. `convert` reads the small classes of the package, `errors` are
//! exceptions, `wait` keeps Ctrl-C alive while threads of Rust work; the others are the classes
//! that hold what these threads have made. What it looks like from Python:
//! `python/drillstring/_drillstring.pyi`.

mod about;
mod arrays;
mod convert;
mod errors;
mod folders;
mod laws;
mod limits;
mod look;
mod motion;
mod outcome;
mod read;
mod responses;
mod results_folder;
mod run;
mod simulate;
mod static_string;
mod string;
mod sweep;
mod table;
mod wait;

use pyo3::prelude::*;

/// What `drillstring` imports.
#[pymodule]
mod _drillstring {
    use pyo3::prelude::*;

    #[pymodule_export]
    use crate::errors::{DrillstringError, DrillstringWarning, SweepFileError};
    #[pymodule_export]
    use crate::folders::_analyse;
    #[pymodule_export]
    use crate::laws::Approach;
    #[pymodule_export]
    use crate::look::{
        _column_words, _method_colour, _motion_title, _site_title, _symbols, _symbols_of_cases,
    };
    #[pymodule_export]
    use crate::motion::Motion;
    #[pymodule_export]
    use crate::outcome::Outcome;
    #[pymodule_export]
    use crate::responses::Responses;
    #[pymodule_export]
    use crate::results_folder::_read_results;
    #[pymodule_export]
    use crate::simulate::Simulation;
    #[pymodule_export]
    use crate::string::{Drillstring, Modes};
    #[pymodule_export]
    use crate::sweep::Sweep;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("_TEMPLATE", campaign::sweep_file::TEMPLATE)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
