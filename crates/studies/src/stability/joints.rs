//! The limit of stick-slip on jointed pipe with collars that damps a wave little: passive and wrong.

use anyhow::Result;
use linear::Method;

use super::families::Cell;
use super::verdict::Findings;
use crate::scenes::{Loss, shipped_with};
use crate::stick_slip;
use campaign::engine::Recipe;
use campaign::plan::Sweep;

/// The string, where its limit is looked for, and where it is, rpm.
pub struct Joints {
    sweep: Sweep,
    bracket: [f64; 2],
    exact: f64,
}

impl Joints {
    /// The same for all cells.
    ///
    /// # Errors
    /// Where its limit is not found.
    pub fn new(loss: Loss) -> Result<Self> {
        let sweep = shipped_with("jointed_collar.toml", loss)?;
        Ok(Self {
            bracket: stick_slip::bracket(&sweep)?,
            exact: stick_slip::true_limit(&sweep, loss)?.limit,
            sweep,
        })
    }

    /// How far the limit of a method is off.
    ///
    /// # Errors
    /// Where the method cannot treat the string.
    pub fn examine(&self, cell: &Cell, method: Method) -> Result<Findings> {
        let Self { sweep, bracket, .. } = self;
        let setting = sweep.setting.sampled_at(cell.sampling_frequency);
        let longest = stick_slip::longest_time(sweep, *bracket)?;
        let system = Recipe::of(sweep, &setting, method, longest).build()?;
        let limit = stick_slip::limit_near(sweep, &system, self.exact);
        Ok(Findings {
            margin_torsion: system.torsion_margin,
            // Not near the exact one is as far off as can be.
            error: Some(limit.map_or(f64::INFINITY, |limit| (limit / self.exact - 1.0).abs())),
            ..Findings::default()
        })
    }
}
