//! What can go wrong with a case.

use sim::SimulationError;
use thiserror::Error;

use super::instability::Instability;
use crate::plan::TorqueError;
use crate::sweep_file::SweepFileError;
use crate::words::counted;

/// Why there is no case, or no answer to it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Neither the file nor an axis gives a condition.
    #[error("has no {0}")]
    Missing(&'static str),
    /// The rock gives no torque.
    #[error(transparent)]
    Torque(#[from] TorqueError),
    /// One of the cases of a sweep, by its number, and what is wrong with it.
    #[error("case {0}: {1}")]
    Numbered(usize, Box<CaseError>),
    /// A case that the random ranges allow, though it may not be drawn.
    #[error("at an end of the random ranges: {0}")]
    AtAnEnd(Box<CaseError>),
    /// It has no state to begin with in which it lies in its hole.
    #[error(transparent)]
    Lying(#[from] statics::StaticsError),
    /// Its values make no string.
    #[error(transparent)]
    String(#[from] SweepFileError),
    /// A method has no responses of its string.
    #[error("{0:#}")]
    Responses(anyhow::Error),
    /// The sites that were found do not keep it within its wall.
    #[error(
        "with {sites} sites, found in {}, the string still goes {by_mm:.1} mm beyond \
         the wall {from_bit:.1} m from the bit: {why}",
        counted(*rounds, "round")
    )]
    Beyond {
        /// How far, mm.
        by_mm: f64,
        /// Where, m from the bit.
        from_bit: f64,
        /// How often it was run again.
        rounds: usize,
        /// How many sites it has by then.
        sites: usize,
        /// Why no more are made.
        why: &'static str,
    },
    /// Its labels would mean little.
    #[error("{0} (--allow-unstable simulates it)")]
    Unstable(Instability),
    /// The simulation has no answer, at a site (number and distance from the bit, m) where
    /// it is one site's doing.
    #[error("{error}{}", in_words(*site))]
    Simulation {
        /// What the simulation says.
        error: SimulationError,
        /// The site.
        site: Option<(usize, f64)>,
    },
    /// The simulation panicked.
    #[error("the simulation panicked")]
    Panicked,
}

fn in_words(site: Option<(usize, f64)>) -> String {
    match site {
        None => String::new(),
        Some((site, 0.0)) => format!(" (site {site} is the bit)"),
        Some((site, distance)) => format!(" (site {site} is {distance} m from the bit)"),
    }
}
