//! `[design]`: the keys of the cases.

use std::collections::BTreeMap;
use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::quantities::Axis;

/// The kinds of design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DesignKind {
    /// Every combination of the axes' values.
    Grid,
    /// Points drawn at random.
    MonteCarlo,
    /// The rows of a file.
    List,
    /// Blocks of random points, from which the influence of each axis follows.
    Sensitivity,
    /// Those cases of a fine grid that show where its limits are.
    Trace,
}

impl DesignKind {
    /// Whether its values are drawn.
    pub fn is_random(self) -> bool {
        matches!(self, DesignKind::MonteCarlo | DesignKind::Sensitivity)
    }
}

/// Where random points lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PointsName {
    /// Anywhere, each by itself.
    #[default]
    Random,
    /// Evenly: scrambled points of Sobol's sequence, over at most 128 axes, of a `sensitivity`
    /// design 64.
    Sobol,
}

/// A file that says what is so anyway asks for the same sweep.
fn are_random(points: &Option<PointsName>) -> bool {
    points.unwrap_or_default() == PointsName::Random
}

/// Step of a trace along its limits, a part of either axis, where the file does not say.
pub const TRACE_TOLERANCE: f64 = 0.005;

/// The same of the step of a trace.
fn is_usual(tolerance: &Option<f64>) -> bool {
    tolerance.unwrap_or(TRACE_TOLERANCE) == TRACE_TOLERANCE
}

/// The cases of a sweep.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DesignTable {
    /// Which cases.
    pub kind: DesignKind,
    /// The axes of a grid, of random points or, two of them, of a trace.
    #[serde(default)]
    pub axes: BTreeMap<Axis, AxisRange>,
    /// Random axes that go together.
    #[schemars(!skip_serializing_if)]
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub correlations: Vec<CorrelationTable>,
    /// Number of random points; of a `sensitivity` design, of its blocks, each of two cases
    /// more than there are axes. It may be raised later: what is done stays, and only the
    /// others are run.
    #[schemars(range(min = 1))]
    pub cases: Option<usize>,
    /// Where random points lie; left out, `"random"`.
    #[serde(skip_serializing_if = "are_random")]
    pub points: Option<PointsName>,
    /// Seed of random points, and of those that a trace draws where a limit is ragged; left
    /// out, 0. A point depends on seed and number alone.
    pub seed: Option<u64>,
    /// The CSV file of a list, in the folder of the file that names it. Its header names axes;
    /// lines with
    /// # are comments.
    pub file: Option<PathBuf>,
    /// Step of a trace along the limits, a part of either axis; left out, 0.005.
    #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 0.5))]
    #[serde(skip_serializing_if = "is_usual")]
    pub tolerance: Option<f64>,
}

/// The values of one axis.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct AxisRange {
    /// First value, or lower end of random ones.
    pub from: Option<f64>,
    /// Last value, or upper end.
    pub to: Option<f64>,
    /// Number of values of a grid, ends included; of the coarse scan of a trace, 2 to 1000,
    /// left out 9.
    #[schemars(range(min = 1, max = 1_000_000))]
    pub count: Option<usize>,
    /// Even steps in the value, or in its logarithm; with `values`, `"log"` says how they are
    /// drawn: maps of an axis that is even in the logarithm are logarithmic.
    pub spacing: Spacing,
    /// Values of a grid one by one, instead of `from`, `to` and `count`.
    pub values: Option<Vec<f64>>,
    /// How random values are spread between `from` and `to`, where they are cut off; left out,
    /// `"uniform"`, in the value or by `spacing = "log"` in its logarithm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distribution: Option<DistributionName>,
    /// Mean of `normal`, before it is cut off, in the unit of the axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean: Option<f64>,
    /// Standard deviation of `normal`, in the unit of the axis.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<f64>,
    /// Median of `log-normal`, before it is cut off, in the unit of the axis.
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median: Option<f64>,
    /// Geometric standard deviation of `log-normal`, a factor: two thirds of all values are
    /// between the median divided by it and the median times it.
    #[schemars(extend("exclusiveMinimum" = 1.0))]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geometric_standard_deviation: Option<f64>,
    /// The most frequent value of `triangular`, between both ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mode: Option<f64>,
}

impl AxisRange {
    /// The numbers that belong to one distribution each, by their keys.
    pub fn of_distributions(&self) -> [(&'static str, Option<f64>, DistributionName); 5] {
        use DistributionName::{LogNormal, Normal, Triangular};
        [
            ("mean", self.mean, Normal),
            ("standard_deviation", self.standard_deviation, Normal),
            ("median", self.median, LogNormal),
            (
                "geometric_standard_deviation",
                self.geometric_standard_deviation,
                LogNormal,
            ),
            ("mode", self.mode, Triangular),
        ]
    }
}

/// Two random axes that go together.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CorrelationTable {
    /// Which axes.
    pub axes: [Axis; 2],
    /// The coefficient of correlation of their normal scores: of what a normal distribution has
    /// at the same part of all. Of two normal axes it is their own.
    #[schemars(range(min = -0.999, max = 0.999))]
    pub coefficient: f64,
}

/// How random values are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum DistributionName {
    /// Evenly.
    #[default]
    Uniform,
    /// Evenly in the logarithm.
    LogUniform,
    /// By a bell curve.
    Normal,
    /// By a bell curve in the logarithm.
    LogNormal,
    /// Rising and falling evenly.
    Triangular,
}

impl DistributionName {
    /// Its name in a sweep file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::LogUniform => "log-uniform",
            Self::Normal => "normal",
            Self::LogNormal => "log-normal",
            Self::Triangular => "triangular",
        }
    }
}

impl AxisRange {
    /// In what its values are spread: their logarithm by a distribution of that, too.
    pub fn spread(&self) -> Spacing {
        use DistributionName::{LogNormal, LogUniform};
        match self.distribution {
            Some(LogUniform | LogNormal) => Spacing::Log,
            _ => self.spacing,
        }
    }

    /// Its least and its greatest value, where it has any.
    pub fn ends(&self) -> Option<[f64; 2]> {
        let values = self.values.iter().flatten().copied();
        let all = values.chain(self.from).chain(self.to);
        all.fold(None, |ends: Option<[f64; 2]>, value| {
            let [low, high] = ends.unwrap_or([value; 2]);
            Some([low.min(value), high.max(value)])
        })
    }
}

/// How values are spread between two ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// Evenly.
    #[default]
    Linear,
    /// Evenly in the logarithm.
    Log,
}

impl Spacing {
    /// Of an axis whose cases begin at `least`: a logarithm has no place for zero.
    pub fn from_least(self, least: f64) -> Self {
        if least > 0.0 { self } else { Self::Linear }
    }

    /// The value a fraction of the way up from `from` to `to`.
    pub fn between(self, from: f64, to: f64, fraction: f64) -> f64 {
        // Rounding may miss the end, and step beyond it before.
        if fraction >= 1.0 {
            return to;
        }
        let value = match self {
            Spacing::Linear => from + (to - from) * fraction,
            Spacing::Log => from * (to / from).powf(fraction),
        };
        value.min(to)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What tells a sweep from others is how its file is written again.
    #[test]
    fn what_is_so_anyway_asks_for_the_same_sweep() {
        let written = |keys: &str| {
            let table: DesignTable = toml::from_str(keys).expect("a design");
            toml::to_string(&table).expect("written")
        };
        let trace = written("kind = \"trace\"");
        assert_eq!(written("kind = \"trace\"\ntolerance = 0.005"), trace);
        assert_ne!(written("kind = \"trace\"\ntolerance = 0.01"), trace);
        let random = written("kind = \"monte-carlo\"");
        assert_eq!(
            written("kind = \"monte-carlo\"\npoints = \"random\""),
            random
        );
        assert_ne!(
            written("kind = \"monte-carlo\"\npoints = \"sobol\""),
            random
        );
    }
}
