//! What the paper's own way of stepping costs: the sum over a filter term by term
//! (Eq. 17), or the whole finite-element model in every step (Eq. 66).

use std::hint::black_box;
use std::time::Instant;

use anyhow::{Context, Result};
use linear::elements::newmark::Weights;
use linear::elements::reduction::{CondensedBeam, CondensedString};
use linear::method::FiniteElement;
use sim::convolution::Kernel;

use super::configuration::{PAPER_FREQUENCY, PAPER_TRANSFORM};
use crate::scenes::shipped;

/// Steps timed.
const STEPS: usize = 2000;

/// Planes in which a string bends.
const PLANES: usize = 2;

/// Time per simulated second, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PaperSteps {
    /// By filters: in torsion; with contact at one site.
    pub filter: [f64; 2],
    /// By elements, likewise.
    pub elements: [f64; 2],
}

impl PaperSteps {
    /// Times both ways.
    ///
    /// # Errors
    /// Where the finite-element model cannot be built.
    pub fn measure() -> Result<Self> {
        let sweep = shipped("fig12.toml")?;
        let setting = &sweep.setting;
        let lateral = setting.lateral.as_ref().context("fig12 has a wall")?;
        let parameters = FiniteElement::default();
        let weights = Weights::new(&parameters, PAPER_FREQUENCY)?;
        let elements = parameters.elements_per_cell;
        let string = CondensedString::new(&setting.string, &setting.sites, elements, weights)?;
        let beam = CondensedBeam::new(
            &setting.string,
            &lateral.bending,
            lateral.support,
            &setting.sites,
            elements,
            weights,
        )?;
        let taps = (0.5 * PAPER_TRANSFORM * PAPER_FREQUENCY) as usize;
        let (kernel, inputs) = (Kernel::new(&vec![1e-3; taps]), vec![1.0; taps]);
        let sum = per_second(|| {
            black_box(kernel.past_sum(black_box(&inputs)));
        });
        let mut state = string.rest();
        let torsion = per_second(|| string.step_free(&mut state, 1.0));
        let mut motion = beam.rest();
        let plane = per_second(|| beam.step_free(&mut motion));
        Ok(Self {
            filter: [sum, (1 + PLANES) as f64 * sum],
            elements: [torsion, torsion + PLANES as f64 * plane],
        })
    }
}

/// Time of the steps of one simulated second, s.
fn per_second(mut step: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..STEPS {
        step();
    }
    start.elapsed().as_secs_f64() / STEPS as f64 * PAPER_FREQUENCY
}
