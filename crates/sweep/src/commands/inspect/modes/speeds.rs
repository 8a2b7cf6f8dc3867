//! What shakes the string: multiples of its surface speed.

use serde::Serialize;

use crate::commands::status::UsageError;
use campaign::plan::Sweep;
use campaign::quantities::Axis;

/// Surface speeds of rotary drilling, rpm, where the sweep has no axis of them.
const USUAL: [f64; 2] = [0.0, 200.0];

/// More of them fit neither a line nor a legend.
const MOST_ORDERS: usize = 6;

/// Multiples of the surface speed, over a range of it.
#[derive(Serialize)]
pub struct Excitation {
    /// How often each excites per turn: 1 for an eccentric mass, more for the blades or cones of a
    /// bit.
    pub orders: Vec<f64>,
    /// The least and the greatest surface speed, rpm.
    #[serde(rename = "surface_speed_rpm")]
    pub speeds: [f64; 2],
    /// Whether these are those of the sweep.
    #[serde(rename = "speeds_are_of_sweep")]
    pub are_of_sweep: bool,
}

impl Excitation {
    /// Over the surface speeds of a sweep; where they are no axis, over the usual ones and its
    /// own.
    ///
    /// # Errors
    /// Where there are too many multiples.
    pub fn of(sweep: &Sweep, orders: &[f64]) -> Result<Self, UsageError> {
        let ends = sweep.design.ends(Axis::SurfaceSpeedRpm);
        let is_range = |ends: &[f64; 2]| ends[0] < ends[1];
        let own = sweep.conditions.surface_speed_rpm.unwrap_or(0.0);
        let own = ends.map_or(own, |[_, most]| most);
        let ends = ends.filter(is_range);
        let mut orders = orders.to_vec();
        orders.sort_by(f64::total_cmp);
        orders.dedup();
        if orders.len() > MOST_ORDERS {
            let message = format!("--orders: {} are more than {MOST_ORDERS}", orders.len());
            return Err(UsageError(message));
        }
        Ok(Self {
            orders,
            speeds: ends.unwrap_or([USUAL[0], USUAL[1].max(own)]),
            are_of_sweep: ends.is_some(),
        })
    }

    /// The highest frequency, Hz.
    pub fn highest(&self) -> f64 {
        let most = self.orders.iter().copied().fold(0.0, f64::max);
        frequency(most, self.speeds[1])
    }

    /// The surface speed at which a multiple meets a frequency (Hz), rpm.
    pub fn meets(order: f64, frequency: f64) -> f64 {
        60.0 * frequency / order
    }

    /// That speed, where it is in the range.
    pub fn critical(&self, order: f64, frequency: f64) -> Option<f64> {
        let speed = Self::meets(order, frequency);
        let [least, most] = self.speeds;
        (least <= speed && speed <= most).then_some(speed)
    }
}

/// That of a multiple of a surface speed (rpm), Hz.
pub fn frequency(order: f64, speed: f64) -> f64 {
    order * speed / 60.0
}
