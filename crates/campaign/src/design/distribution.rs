//! How the values of a random axis are spread between its ends: each from one number that is
//! uniform between 0 and 1, by the inverse of the distribution function.

use statrs::distribution::{ContinuousCDF, Normal};

use super::axes::check_ends;
use crate::quantities::Axis;
use crate::sweep_file::{AxisRange, DistributionName, Source, Spacing, SweepFileError};

/// A spread of values between two ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution {
    pub from: f64,
    pub to: f64,
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Uniform(Spacing),
    Normal(Truncated),
    /// Of the logarithm.
    LogNormal(Truncated),
    Triangular {
        mode: f64,
    },
}

/// A normal distribution between two ends.
#[derive(Debug, Clone, PartialEq)]
struct Truncated {
    mean: f64,
    deviation: f64,
    /// Whether it is turned round, so that the ends are not both far above the mean: of
    /// numbers close to 1 rounding would leave nothing.
    is_mirrored: bool,
    /// What is below either end, turned round or not.
    below: [f64; 2],
}

/// Less than this part of a distribution between its ends means that these are not meant.
const LEAST_PART: f64 = 1e-9;

impl Distribution {
    /// What the keys of an axis say.
    ///
    /// # Errors
    /// Where one is missing, does not belong to the distribution, or makes no sense.
    pub fn resolve(source: &Source, axis: Axis, range: &AxisRange) -> Result<Self, SweepFileError> {
        let key = format!("design.axes.{}", axis.name());
        let (Some(from), Some(to), None, None) = (range.from, range.to, range.count, &range.values)
        else {
            return Err(source.error(&key, "a random axis has `from` and `to`"));
        };
        let message = "is counted in whole numbers: make it an axis of a grid or a list";
        source.refuse_if(axis.is_counted(), &key, message)?;
        check_ends(source, axis, range, (from, to))?;
        let numbers = Numbers {
            source,
            key: &key,
            range,
        };
        let shape = numbers.shape(from, to)?;
        Ok(Self { from, to, shape })
    }

    /// Evenly between two ends, or so in the logarithm.
    pub fn uniform(from: f64, to: f64, spacing: Spacing) -> Self {
        let shape = Shape::Uniform(spacing);
        Self { from, to, shape }
    }

    /// The value below which a part (0 to 1) of all are.
    pub fn at(&self, part: f64) -> f64 {
        let (from, to) = (self.from, self.to);
        let value = match &self.shape {
            Shape::Uniform(spacing) => return spacing.between(from, to, part),
            Shape::Normal(normal) => normal.at(part),
            Shape::LogNormal(normal) => normal.at(part).exp(),
            Shape::Triangular { mode } => {
                let (rise, fall, whole) = (mode - from, to - mode, to - from);
                if part * whole < rise {
                    from + (part * whole * rise).sqrt()
                } else {
                    to - ((1.0 - part) * whole * fall).sqrt()
                }
            }
        };
        value.clamp(from, to)
    }
}

impl Truncated {
    /// Between two ends, if there is anything of it between them.
    fn new(mean: f64, deviation: f64, from: f64, to: f64) -> Option<Self> {
        let ends = [from, to].map(|end| (end - mean) / deviation);
        let is_mirrored = ends[0] > 0.0;
        let below = if is_mirrored {
            [-ends[1], -ends[0]].map(below_normal)
        } else {
            ends.map(below_normal)
        };
        (below[1] - below[0] > LEAST_PART).then_some(Self {
            mean,
            deviation,
            is_mirrored,
            below,
        })
    }

    fn at(&self, part: f64) -> f64 {
        let [low, high] = self.below;
        let (part, sign) = if self.is_mirrored {
            (1.0 - part, -1.0)
        } else {
            (part, 1.0)
        };
        let score = normal_score(low + part * (high - low));
        self.mean + sign * self.deviation * score
    }
}

/// The part of a normal distribution of mean 0 and deviation 1 that is below a number.
pub fn below_normal(score: f64) -> f64 {
    Normal::standard().cdf(score)
}

/// The number below which a fraction of that distribution lies; finite, since fractions are kept
/// from 0 and 1.
pub fn normal_score(part: f64) -> f64 {
    let least = f64::EPSILON * f64::EPSILON;
    Normal::standard().inverse_cdf(part.clamp(least, 1.0 - f64::EPSILON))
}

/// Reads the numbers of a distribution.
struct Numbers<'a> {
    source: &'a Source,
    key: &'a str,
    range: &'a AxisRange,
}

impl Numbers<'_> {
    fn shape(&self, from: f64, to: f64) -> Result<Shape, SweepFileError> {
        let name = self.range.distribution.unwrap_or_default();
        self.refuse_foreign(name)?;
        let is_logarithmic = matches!(
            name,
            DistributionName::LogUniform | DistributionName::LogNormal
        );
        self.refuse_if(
            is_logarithmic && from <= 0.0,
            "from",
            "a logarithm needs numbers above zero",
        )?;
        match name {
            DistributionName::Uniform => Ok(Shape::Uniform(self.range.spacing)),
            DistributionName::LogUniform => Ok(Shape::Uniform(Spacing::Log)),
            DistributionName::Normal => {
                let mean = self.needed("mean", self.range.mean)?;
                let key = "standard_deviation";
                let deviation = self.needed(key, self.range.standard_deviation)?;
                self.refuse_if(deviation <= 0.0, key, "is above zero")?;
                let normal = Truncated::new(mean, deviation, from, to);
                Ok(Shape::Normal(self.inside(normal)?))
            }
            DistributionName::LogNormal => {
                let median = self.needed("median", self.range.median)?;
                self.refuse_if(median <= 0.0, "median", "is above zero")?;
                let key = "geometric_standard_deviation";
                let factor = self.needed(key, self.range.geometric_standard_deviation)?;
                let message = "is a factor above 1: two thirds of all are between the median \
                               over it and the median times it";
                self.refuse_if(factor <= 1.0, key, message)?;
                let normal = Truncated::new(median.ln(), factor.ln(), from.ln(), to.ln());
                Ok(Shape::LogNormal(self.inside(normal)?))
            }
            DistributionName::Triangular => {
                let mode = self.needed("mode", self.range.mode)?;
                let message = format!("{mode} is not between {from} and {to}");
                self.refuse_if(!(from..=to).contains(&mode), "mode", &message)?;
                Ok(Shape::Triangular { mode })
            }
        }
    }

    /// A number that belongs to another distribution would be ignored: refuse it.
    fn refuse_foreign(&self, name: DistributionName) -> Result<(), SweepFileError> {
        for (key, value, owner) in self.range.of_distributions() {
            let message = format!("belongs to `distribution = \"{}\"`", owner.name());
            self.refuse_if(value.is_some() && owner != name, key, &message)?;
        }
        let has_both = self.range.distribution.is_some() && self.range.spacing == Spacing::Log;
        let message = "says what `distribution` says: leave one out";
        self.refuse_if(has_both, "spacing", message)
    }

    fn needed(&self, key: &str, value: Option<f64>) -> Result<f64, SweepFileError> {
        let name = self.range.distribution.unwrap_or_default().name();
        let value = value.ok_or_else(|| {
            let message = format!("the distribution \"{name}\" needs `{key}`");
            self.source.error(self.key, message)
        })?;
        self.refuse_if(!value.is_finite(), key, "is no number")?;
        Ok(value)
    }

    fn inside(&self, normal: Option<Truncated>) -> Result<Truncated, SweepFileError> {
        normal.ok_or_else(|| {
            let message = "hardly anything of the distribution is between `from` and `to`";
            self.source.error(self.key, message)
        })
    }

    fn refuse_if(&self, is_so: bool, key: &str, message: &str) -> Result<(), SweepFileError> {
        self.source
            .refuse_if(is_so, &format!("{}.{key}", self.key), message.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The part of a distribution below a value, from its density by the midpoint rule.
    fn below(density: impl Fn(f64) -> f64, (from, to): (f64, f64), value: f64) -> f64 {
        let steps = 20_000;
        let sum_to = |end: f64| -> f64 {
            let step = (end - from) / f64::from(steps);
            let at = |index: i32| density(from + (f64::from(index) + 0.5) * step);
            (0..steps).map(at).sum::<f64>() * step
        };
        sum_to(value) / sum_to(to)
    }

    fn holds(distribution: &Distribution, density: impl Fn(f64) -> f64 + Copy) {
        let ends = (distribution.from, distribution.to);
        assert!((distribution.at(0.0) - ends.0).abs() < 1e-9 * (1.0 + ends.0.abs()));
        assert!((distribution.at(1.0) - ends.1).abs() < 1e-9 * (1.0 + ends.1.abs()));
        for part in [0.01, 0.2, 0.5, 0.77, 0.99] {
            let found = below(density, ends, distribution.at(part));
            assert!(
                (found - part).abs() < 1e-6,
                "{distribution:?}: {part} {found}"
            );
        }
    }

    fn normal(mean: f64, deviation: f64, from: f64, to: f64) -> Distribution {
        let shape = Shape::Normal(Truncated::new(mean, deviation, from, to).unwrap());
        Distribution { from, to, shape }
    }

    #[test]
    fn parts_of_all_are_below_what_the_density_says() {
        let bell = |mean: f64, deviation: f64| {
            move |value: f64| (-0.5 * ((value - mean) / deviation).powi(2)).exp()
        };
        // In the middle, cut on one side, far out on either.
        for (mean, deviation, from, to) in [
            (3.0, 0.5, 0.0, 6.0),
            (3.0, 2.0, 2.5, 9.0),
            (0.0, 1.0, 4.0, 5.0),
            (0.0, 1.0, -5.5, -4.0),
        ] {
            let found = normal(mean, deviation, from, to);
            holds(&found, bell(mean, deviation));
        }
        let (from, to) = (0.1f64, 10.0f64);
        let logs = Truncated::new(1.5f64.ln(), 2f64.ln(), from.ln(), to.ln()).unwrap();
        let shape = Shape::LogNormal(logs);
        let density = |value: f64| bell(1.5f64.ln(), 2f64.ln())(value.ln()) / value;
        holds(&Distribution { from, to, shape }, density);
        for mode in [1.0, 1.25, 3.0] {
            let shape = Shape::Triangular { mode };
            let (from, to) = (1.0, 3.0);
            let density = |value: f64| {
                if value < mode {
                    (value - from) / (mode - from)
                } else {
                    (to - value) / (to - mode).max(1e-300)
                }
            };
            holds(&Distribution { from, to, shape }, density);
        }
    }

    #[test]
    fn nothing_is_drawn_outside() {
        let found = normal(0.0, 1.0, 5.5, 7.0);
        for step in 0..=1000 {
            assert!((5.5..=7.0).contains(&found.at(f64::from(step) / 1000.0)));
        }
        assert!(Truncated::new(0.0, 1.0, 7.0, 8.0).is_none());
    }
}
