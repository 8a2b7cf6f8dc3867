//! The axis of the hole, and axes across it that are carried along without twist.
//!
//! With t the way down, h to the high side and r to the right looking down (h × r = t), the
//! displacement of the string is that across the hole along two axes e₁ and e₂ that are h and r at
//! the bit and from there on turn about t as little as they can (R. L. Bishop, "There is more than
//! one way to frame a curve", *The American Mathematical Monthly* 82, 1975, 246–251). Both planes
//! then obey one equation, and what turns is the load, by the angle ψ = ∫ cos I dA between h and
//! e₁ (I inclination, A azimuth). Along an arc of a circle the axes are turned with it.

use linear::well::Survey;

use crate::error::StaticsError;

/// North, east, down.
pub(crate) type Vector = [f64; 3];

/// Steeper than this, in the sine of the inclination, a hole has no high side.
const VERTICAL: f64 = 1e-9;

/// The course of the hole around the string.
///
/// ```
/// use statics::Course;
///
/// let sixty = Course::Straight { inclination: 60f64.to_radians() };
/// assert!(matches!(sixty, Course::Straight { .. }));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Course {
    /// Straight.
    Straight {
        /// Angle from the vertical, rad.
        inclination: f64,
    },
    /// As surveyed, from the surface to the bit at least: arcs of circles between stations.
    Surveyed(Survey),
}

/// The axes at a place of the hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axes {
    /// The way down.
    pub(crate) along: Vector,
    /// Those across it, carried along from the bit.
    pub(crate) across: [Vector; 2],
}

impl Course {
    pub(crate) fn check(&self, length: f64) -> Result<(), StaticsError> {
        match self {
            Course::Straight { inclination } => {
                let is_angle = (0.0..=std::f64::consts::PI).contains(inclination);
                let (quantity, value) = ("an inclination in rad", *inclination);
                match is_angle {
                    true => Ok(()),
                    false => Err(StaticsError::Quantity { quantity, value }),
                }
            }
            // As deep up to rounding.
            Course::Surveyed(survey) if survey.depth() < length * (1.0 - 1e-9) => {
                let depth = survey.depth();
                Err(StaticsError::SurveyTooShort { depth, length })
            }
            Course::Surveyed(_) => Ok(()),
        }
    }

    /// The axes at the bit, at a measured depth (m): the high side and the right.
    pub(crate) fn at_bit(&self, depth: f64) -> Axes {
        let (along, azimuth) = match self {
            Course::Straight { inclination } => {
                let (sin, cos) = inclination.sin_cos();
                ([sin, 0.0, cos], 0.0)
            }
            Course::Surveyed(survey) => {
                let stations = survey.stations();
                let below = stations.partition_point(|it| it.measured_depth < depth);
                let azimuth = stations[below.min(stations.len() - 1)].azimuth;
                (survey.direction(depth), azimuth)
            }
        };
        let high = high_side(along).unwrap_or([azimuth.cos(), azimuth.sin(), 0.0]);
        Axes {
            along,
            across: [high, cross(along, high)],
        }
    }

    /// How the way down turns per metre at a measured depth (m).
    pub(crate) fn curvature(&self, depth: f64) -> Vector {
        match self {
            Course::Straight { .. } => [0.0; 3],
            Course::Surveyed(survey) => survey.curvature(depth),
        }
    }

    /// The depths (m) where an arc ends.
    pub(crate) fn ends_of_arcs(&self) -> impl Iterator<Item = f64> {
        let stations = match self {
            Course::Straight { .. } => &[],
            Course::Surveyed(survey) => survey.stations(),
        };
        stations.iter().map(|station| station.measured_depth)
    }
}

impl Axes {
    /// What the hole turns about, and how fast (rad/m), along an arc that has a curvature
    /// somewhere; none of a straight one.
    fn turning(&self, curvature: Vector) -> Option<(Vector, f64)> {
        let rate = dot(curvature, curvature).sqrt();
        let axis = cross(self.along, curvature);
        let length = dot(axis, axis).sqrt();
        (length > 0.0).then(|| (axis.map(|it| it / length), rate))
    }

    /// Those a distance (m, negative upwards) along an arc that has a curvature somewhere.
    pub(crate) fn moved(&self, curvature: Vector, distance: f64) -> Self {
        let Some((axis, rate)) = self.turning(curvature) else {
            return *self;
        };
        let (sin, cos) = (rate * distance).sin_cos();
        let turned = |vector: Vector| {
            let (aside, along) = (cross(axis, vector), dot(axis, vector) * (1.0 - cos));
            std::array::from_fn(|it| vector[it] * cos + aside[it] * sin + axis[it] * along)
        };
        Self {
            along: turned(self.along),
            across: self.across.map(turned),
        }
    }

    /// Curvature along each of the axes across, the same all along an arc that has a curvature
    /// somewhere.
    pub(crate) fn bend(&self, curvature: Vector) -> [f64; 2] {
        self.turning(curvature).map_or([0.0; 2], |(axis, rate)| {
            self.components(cross(axis, self.along)).map(|it| rate * it)
        })
    }

    /// What of a vector is along each of the axes across.
    fn components(&self, vector: Vector) -> [f64; 2] {
        self.across.map(|axis| dot(axis, vector))
    }

    /// The angle by which the high side is turned from the first axis towards the second, rad; 0
    /// where the hole is vertical.
    pub(crate) fn high_side_angle(&self) -> f64 {
        high_side(self.along).map_or(0.0, |high| {
            let [first, second] = self.components(high);
            second.atan2(first)
        })
    }
}

/// To the high side across a way down; none of a vertical one.
fn high_side(along: Vector) -> Option<Vector> {
    let sin = along[0].hypot(along[1]);
    let high = [along[0] * along[2], along[1] * along[2], -sin * sin];
    (sin > VERTICAL).then(|| high.map(|it| it / sin))
}

pub(crate) fn dot(one: Vector, other: Vector) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

fn cross(one: Vector, other: Vector) -> Vector {
    [0, 1, 2].map(|it| {
        let (next, last) = ((it + 1) % 3, (it + 2) % 3);
        one[next] * other[last] - one[last] * other[next]
    })
}

#[cfg(test)]
mod tests {
    use linear::well::Station;

    use super::*;

    /// Carried up a well that builds and turns, axes stay across it; the high side is turned from
    /// the first by ∫ cos I dA.
    #[test]
    fn axes_are_carried_along_without_twist() {
        // A cone of inclination 40° is no arc of a circle; short arcs are near it.
        let (inclination, stations) = (40f64.to_radians(), 2000);
        let station = |index: i32| Station {
            measured_depth: f64::from(index) * 0.5,
            inclination,
            azimuth: 1.5 * f64::from(index) / f64::from(stations),
        };
        let survey = Survey::new((0..=stations).map(station).collect()).unwrap();
        let course = Course::Surveyed(survey);
        let mut axes = course.at_bit(1000.0);
        assert!(axes.high_side_angle().abs() < 1e-12);
        for index in (0..stations).rev() {
            let curvature = course.curvature(0.5 * f64::from(index) + 0.25);
            axes = axes.moved(curvature, -0.5);
        }
        let Course::Surveyed(survey) = &course else {
            unreachable!("it is surveyed")
        };
        for (one, other) in axes.along.iter().zip(survey.direction(0.0)) {
            assert!((one - other).abs() < 1e-11);
        }
        let [first, second] = axes.across;
        assert!(dot(first, second).abs() < 1e-11 && dot(first, axes.along).abs() < 1e-11);
        // From the bit up the azimuth falls.
        let expected = -1.5 * inclination.cos();
        assert!((axes.high_side_angle() - expected).abs() < 1e-6);
    }
}
