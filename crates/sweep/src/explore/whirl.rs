//! The limit of whirl next to a case between walls: of the string as it is in the file.

use anyhow::Result;
use campaign::plan::{LateralSettings, Sweep};
use campaign::quantities::Axis;
use serde::Serialize;

use super::controls::Control;
use limits::{Boundary, many_sites_limit, whirl_limit};

/// The limit of whirl over surface speed, one of three.
#[derive(Debug, Clone, Serialize)]
pub struct LimitLine {
    /// What it is.
    pub name: String,
    /// Surface speeds (rpm) and frictions, in the order in which they are joined; there is no
    /// limit between the pieces.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

/// The quantities that the limit of whirl relates.
pub const AXES: [Axis; 2] = [Axis::SurfaceSpeedRpm, Axis::FRICTION];

/// The limits of whirl over the speeds of a page's slider; none without a wall, or where speed
/// or friction have no slider.
///
/// # Errors
/// Where a site is not on the string.
pub fn whirl_lines(sweep: &Sweep, controls: &[Control]) -> Result<Option<Vec<LimitLine>>> {
    let of = |axis: Axis| controls.iter().find(|control| control.axis == axis);
    let [speed, friction] = AXES.map(of);
    let (Some(lateral), Some(speed), Some(_)) =
        (sweep.setting.whirling_with_string(), speed, friction)
    else {
        return Ok(None);
    };
    let range = [speed.least, speed.most].map(|end| end * speed.size);
    lines(sweep, lateral, range).map(Some)
}

fn lines(sweep: &Sweep, lateral: &LateralSettings, range: [f64; 2]) -> Result<Vec<LimitLine>> {
    let mut points = whirl_limit(&sweep.setting, lateral, range)?;
    points.extend(many_sites_limit(&sweep.setting, lateral, range)?);
    let curves = Boundary::Whirl(points).curves(&AXES, sweep.content.units);
    let lines = curves.into_iter().map(|curve| LimitLine {
        name: curve.name,
        pieces: curve.pieces,
    });
    Ok(lines.collect())
}
