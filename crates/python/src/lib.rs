//! The Python package `drillstring`: a thin shell around [`campaign`], [`linear`] and [`sim`].
//!
//! There is no physics in it. `convert` reads the small classes of the package, `errors` are
//! exceptions, `wait` keeps Ctrl-C alive while threads of Rust work; the others are the classes
//! that hold what these threads have made. What it looks like from Python:
//! `python/drillstring/_drillstring.pyi`.

mod arrays;
mod convert;
mod errors;
mod folders;
mod laws;
mod limits;
mod motion;
mod outcome;
mod read;
mod responses;

mod run;
mod simulate;
mod string;
mod sweep;
mod table;
mod wait;

use pyo3::prelude::*;

/// What `drillstring` imports.
#[pymodule]
mod _drillstring {
    #[pymodule_export]
    use crate::errors::{DrillstringError, DrillstringWarning, SweepFileError};
    #[pymodule_export]
    use crate::folders::_analyse;
    #[pymodule_export]
    use crate::laws::Approach;
    #[pymodule_export]
    use crate::motion::Motion;
    #[pymodule_export]
    use crate::outcome::Outcome;
    #[pymodule_export]
    use crate::responses::Responses;
    #[pymodule_export]
    use crate::simulate::Simulation;
    #[pymodule_export]
    use crate::string::{Drillstring, Modes};
    #[pymodule_export]
    use crate::sweep::Sweep;
}
