//! A case followed by one method to the end of its time.

use sim::{Outcome, Trajectory};

use crate::records::WallPush;

/// One method's answer to one case.
pub struct Simulation {
    /// Number of the case.
    pub case: usize,
    /// Name of the method.
    pub method: &'static str,
    /// What it is called in pictures.
    pub name: String,
    /// Its time history.
    pub trajectory: Trajectory,
    /// What a run answers.
    pub answer: Outcome,
    /// The site that decides the lateral label of that, m from the bit.
    pub site_from_bit_m: Option<f64>,
    /// The hardest push into a wall, where there was one.
    pub wall_push: Option<WallPush>,
    /// What came out, followed to the end of the time.
    pub followed: Outcome,
}
