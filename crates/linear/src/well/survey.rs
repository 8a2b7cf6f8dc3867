//! The course of a well from a survey, by minimum curvature: between two stations it is an arc
//! of a circle (S. J. Sawaryn and J. L. Thorogood, "A compendium of directional calculations
//! based on the minimum curvature method", *SPE Drilling & Completion* 20, 2005, 24–36).

use thiserror::Error;

/// A direction or a rate of its change: north, east, down.
pub(super) type Vector = [f64; 3];

/// A dogleg below this is straight, rad.
const STRAIGHT: f64 = 1e-12;

/// A station of a survey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// Depth along the well, m.
    pub measured_depth: f64,
    /// Angle from the vertical, rad.
    pub inclination: f64,
    /// Angle from north towards east, rad.
    pub azimuth: f64,
}

/// Why stations are no survey. Stations are counted from 0.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SurveyError {
    /// There are not two.
    #[error("a survey has at least two stations")]
    TooFew,
    /// A number is not finite, or an inclination not from 0 to 180°.
    #[error("station {0} (counted from 0) is no place of a well")]
    NoPlace(usize),
    /// The first is below the surface.
    #[error("a survey begins at the surface, with a measured depth of 0, not of {0} m")]
    BeginsBelow(f64),
    /// A depth is not below the one before.
    #[error("the depth of station {0} (counted from 0) is not below that of the one before")]
    GoesBack(usize),
    /// Two directions in a row are opposite: no arc is the one between them.
    #[error("the well turns round between station {0} and the next")]
    TurnsRound(usize),
}

/// The course of a well.
///
/// ```
/// use linear::well::{Station, Survey};
///
/// let station = |measured_depth: f64, degrees: f64| Station {
///     measured_depth,
///     inclination: degrees.to_radians(),
///     azimuth: 0.0,
/// };
/// let survey = Survey::new(vec![station(0.0, 0.0), station(500.0, 0.0), station(1400.0, 90.0)])?;
/// // An arc builds evenly: 3° per 30 m.
/// assert!((survey.inclination(950.0).to_degrees() - 45.0).abs() < 1e-9);
/// assert!((survey.turn_rate(950.0) * 30.0 - 3f64.to_radians()).abs() < 1e-12);
/// # Ok::<(), linear::well::SurveyError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    stations: Vec<Station>,
}

impl Survey {
    /// Stations from the surface down.
    ///
    /// # Errors
    /// Where they are not those of a well.
    pub fn new(stations: Vec<Station>) -> Result<Self, SurveyError> {
        let is_place = |station: &Station| {
            station.measured_depth.is_finite()
                && (0.0..=std::f64::consts::PI).contains(&station.inclination)
                && station.azimuth.is_finite()
        };
        if let Some(index) = stations.iter().position(|station| !is_place(station)) {
            return Err(SurveyError::NoPlace(index));
        }
        match stations[..] {
            [first, _, ..] if first.measured_depth != 0.0 => {
                return Err(SurveyError::BeginsBelow(first.measured_depth));
            }
            [_, _, ..] => {}
            _ => return Err(SurveyError::TooFew),
        }
        for (index, pair) in stations.windows(2).enumerate() {
            if pair[1].measured_depth <= pair[0].measured_depth {
                return Err(SurveyError::GoesBack(index + 1));
            }
            if dogleg(direction(&pair[0]), direction(&pair[1])) > std::f64::consts::PI - 1e-6 {
                return Err(SurveyError::TurnsRound(index));
            }
        }
        Ok(Self { stations })
    }

    /// Its stations, from the surface down.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Measured depth of the last station, m.
    pub fn depth(&self) -> f64 {
        self.stations[self.stations.len() - 1].measured_depth
    }

    /// The way down, and how it turns per metre, at a measured depth (m) of the survey.
    pub(super) fn course(&self, depth: f64) -> (Vector, Vector) {
        let next = self
            .stations
            .partition_point(|it| it.measured_depth <= depth);
        let next = next.clamp(1, self.stations.len() - 1);
        let (above, below) = (&self.stations[next - 1], &self.stations[next]);
        let (from, to) = (direction(above), direction(below));
        let length = below.measured_depth - above.measured_depth;
        let angle = dogleg(from, to);
        if angle < STRAIGHT {
            return (from, [0.0; 3]);
        }
        let gone = angle * (depth - above.measured_depth) / length;
        let left = angle - gone;
        let sin = angle.sin();
        let along = combine(left.sin() / sin, from, gone.sin() / sin, to);
        let rate = angle / length;
        let turn = combine(-rate * left.cos() / sin, from, rate * gone.cos() / sin, to);
        (along, turn)
    }

    /// The way down at a measured depth (m) of the survey: north, east, down.
    pub fn direction(&self, depth: f64) -> [f64; 3] {
        self.course(depth).0
    }

    /// How the way down turns per metre at a measured depth (m) of the survey, rad/m: north, east,
    /// down. It is across the well, towards the inside of its bend.
    pub fn curvature(&self, depth: f64) -> [f64; 3] {
        self.course(depth).1
    }

    /// How fast the well turns at a measured depth (m) of the survey, rad/m.
    pub fn turn_rate(&self, depth: f64) -> f64 {
        length(self.course(depth).1)
    }

    /// The depths (m) of the stations between two depths, without those.
    pub(super) fn depths_between(&self, top: f64, bottom: f64) -> impl Iterator<Item = f64> {
        let first = (self.stations).partition_point(|it| it.measured_depth <= top);
        let depths = self.stations[first..].iter().map(|it| it.measured_depth);
        depths.take_while(move |depth| *depth < bottom)
    }

    /// Inclination at a measured depth (m) of the survey, rad.
    pub fn inclination(&self, depth: f64) -> f64 {
        self.course(depth).0[2].clamp(-1.0, 1.0).acos()
    }
}

fn direction(station: &Station) -> Vector {
    let (sin, cos) = station.inclination.sin_cos();
    [
        sin * station.azimuth.cos(),
        sin * station.azimuth.sin(),
        cos,
    ]
}

/// The angle between two directions, without a loss of digits where it is small.
fn dogleg(one: Vector, other: Vector) -> f64 {
    let apart = length(combine(1.0, one, -1.0, other));
    let together = length(combine(1.0, one, 1.0, other));
    2.0 * apart.atan2(together)
}

pub(super) fn combine(p: f64, one: Vector, q: f64, other: Vector) -> Vector {
    [0, 1, 2].map(|axis| p * one[axis] + q * other[axis])
}

pub(super) fn length(vector: Vector) -> f64 {
    vector.iter().map(|value| value * value).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn station(measured_depth: f64, inclination: f64, azimuth: f64) -> Station {
        Station {
            measured_depth,
            inclination: inclination.to_radians(),
            azimuth: azimuth.to_radians(),
        }
    }

    /// A quarter of a circle from the vertical to the horizontal.
    #[test]
    fn an_arc_turns_evenly() {
        let radius = 300.0;
        let length_of_arc = radius * std::f64::consts::FRAC_PI_2;
        let survey = Survey::new(vec![
            station(0.0, 0.0, 0.0),
            station(500.0, 0.0, 30.0),
            station(500.0 + length_of_arc, 90.0, 30.0),
        ])
        .unwrap();
        assert_eq!(survey.inclination(250.0), 0.0);
        for part in [0.1, 0.5, 0.9] {
            let depth = 500.0 + part * length_of_arc;
            let (along, turn) = survey.course(depth);
            assert!((survey.inclination(depth).to_degrees() - 90.0 * part).abs() < 1e-9);
            assert!((length(along) - 1.0).abs() < 1e-12);
            assert!((length(turn) - 1.0 / radius).abs() < 1e-12);
            let across: f64 = along.iter().zip(turn).map(|(a, b)| a * b).sum();
            assert!(across.abs() < 1e-15);
        }
    }

    #[test]
    fn what_is_no_survey_is_refused() {
        let refused = |stations: &[Station]| Survey::new(stations.to_vec()).unwrap_err();
        let surface = station(0.0, 0.0, 0.0);
        assert_eq!(refused(&[surface]), SurveyError::TooFew);
        let below = station(10.0, 0.0, 0.0);
        assert_eq!(
            refused(&[below, station(20.0, 0.0, 0.0)]),
            SurveyError::BeginsBelow(10.0)
        );
        assert_eq!(refused(&[surface, below, below]), SurveyError::GoesBack(2));
        assert_eq!(
            refused(&[surface, station(9.0, 190.0, 0.0)]),
            SurveyError::NoPlace(1)
        );
        assert_eq!(
            refused(&[surface, station(9.0, 180.0, 0.0)]),
            SurveyError::TurnsRound(0)
        );
    }
}
