//! Why there is no operating window.

use std::path::PathBuf;

use linear::{BuildError, DrillstringError};
use thiserror::Error;

use campaign::quantities::Axis;
use limits::BoundaryError;

/// Why there is no operating window.
#[derive(Debug, Error)]
pub enum WindowError {
    /// Results are of another string than the sweep.
    #[error("{} and {} are not of one string: {difference}", folder.display(), file.display())]
    OtherString {
        /// The results.
        folder: PathBuf,
        /// The sweep file.
        file: PathBuf,
        /// The first key that differs, with its values.
        difference: String,
    },
    /// Cases do not differ in an axis of the window.
    #[error(
        "{}: its cases do not differ in {}, and a window is over that and {}",
        folder.display(), missing.name(), other.name()
    )]
    NotOver {
        /// The results.
        folder: PathBuf,
        /// The axis.
        missing: Axis,
        /// The other one.
        other: Axis,
    },
    /// Results without a case.
    #[error("{} has no case to draw yet", .0.display())]
    NoCase(PathBuf),
    /// Cases without labels.
    #[error("no case has a label: there is no limit to draw")]
    NoLabel,
    /// Results of different ranges.
    #[error("{} have no range of weight and speed in common", names(.0))]
    NothingInCommon(Vec<PathBuf>),
    /// Places that hold a string which does not bend.
    #[error("the string does not bend: the file has no [wall]")]
    NotBent,
    /// Places that hold a string which lies on the low side of its hole.
    #[error("the string lies on the low side of its hole: its contacts hold it")]
    Lies,
    /// Nothing that holds the string.
    #[error("what holds the string sideways? The file has no [[sites]]")]
    NotHeld,
    /// Places that hold the string and are not on it.
    #[error("{0}")]
    HeldAt(DrillstringError),
    /// The analytic limits are not known.
    #[error(transparent)]
    Boundary(#[from] BoundaryError),
    /// The string has no such motion.
    #[error(transparent)]
    String(#[from] DrillstringError),
    /// Its lateral natural frequencies are not found.
    #[error(transparent)]
    Frequencies(#[from] BuildError),
    /// Results that cannot be read, or say nothing of a limit.
    #[error("{0:#}")]
    Results(anyhow::Error),
}

fn names(folders: &[PathBuf]) -> String {
    let names: Vec<String> = folders.iter().map(|it| it.display().to_string()).collect();
    names.join(" and ")
}
