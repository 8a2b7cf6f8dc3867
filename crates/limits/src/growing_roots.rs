//! How steady drilling stands at the operating points of a sweep: where it is, and how many ways of
//! vibration grow about it, by the count of the roots of D(s) ([`linear::regenerative`]).

use campaign::plan::Sweep;
use campaign::records::{to_kn, to_m_h, to_rpm};
use linear::regenerative::SteadyCut;
use linear::{DrillstringError, parallel};
use serde::Serialize;

/// More operating points are not counted at.
const MOST: usize = 400;

/// Steady drilling at an operating point.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DrillingPoint {
    /// The case of the design that it is of; other cases with its surface speed and weight differ
    /// elsewhere.
    pub case: usize,
    /// What is set at the surface.
    pub surface_speed_rpm: f64,
    /// The weight that is set, where that is the hook load,
    pub weight_on_bit_kn: Option<f64>,
    /// or the speed at which the string is let down.
    pub feed_m_h: Option<f64>,
    /// What follows: the rate of penetration of steady drilling, with the bit as fast as this.
    pub rate_of_penetration_m_h: f64,
    /// Speed of the bit.
    pub bit_speed_rpm: f64,
    /// Torque on it.
    pub torque_nm: f64,
    /// Weight on it.
    pub weight_kn: f64,
    /// Roots of D(s) that grow: zero where steady drilling lasts; none where they cannot be counted.
    pub growing_roots: Option<usize>,
}

/// Those of a sweep whose bit cuts, case by case or, of many, evenly among them; axes that change the
/// string have the string of the file. None of a string that rubs along its well, which is not linear.
///
/// # Errors
/// Where the string cannot be cut up.
pub fn drilling_points(sweep: &Sweep) -> Result<Vec<DrillingPoint>, DrillstringError> {
    let setting = &sweep.setting;
    let (Some(bit), None) = (&sweep.bit, &setting.friction) else {
        return Ok(Vec::new());
    };
    let Some(cutting) = setting.cutting_loop()? else {
        return Ok(Vec::new());
    };
    let cases = sweep.design.cases();
    let points = (0..cases.min(MOST)).filter_map(|place| {
        let case = match cases > MOST {
            true => place * (cases - 1) / (MOST - 1),
            false => place,
        };
        let conditions = sweep.conditions_at(&sweep.design.values(case));
        let (drilling, cut) = setting.steady_drilling(bit, &conditions)?;
        let point = DrillingPoint {
            case,
            surface_speed_rpm: conditions.surface_speed_rpm?,
            weight_on_bit_kn: conditions.weight_on_bit_kn,
            feed_m_h: conditions.feed_m_h,
            rate_of_penetration_m_h: to_m_h(drilling.rate),
            bit_speed_rpm: to_rpm(drilling.speed),
            torque_nm: drilling.torque,
            weight_kn: to_kn(drilling.weight),
            growing_roots: None,
        };
        Some((point, cut))
    });
    let points: Vec<(DrillingPoint, Option<SteadyCut>)> = points.collect();
    let stiffest = (points.iter().filter_map(|(_, cut)| cut.as_ref()))
        .max_by(|one, other| one.weight.total_cmp(&other.weight));
    let cutting = match stiffest {
        Some(cut) => cutting.sampled_for(cut),
        None => cutting,
    };
    Ok(parallel::each(points, |(point, cut)| DrillingPoint {
        growing_roots: cut.and_then(|cut| cutting.growing(&cut)),
        ..point
    }))
}
