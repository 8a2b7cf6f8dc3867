//! `[design]`: the keys of the cases.

use std::collections::BTreeMap;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::quantities::Axis;

/// The kinds of design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DesignKind {
    /// Every combination of the axes' values.
    Grid,
    /// Independent random values.
    MonteCarlo,
    /// The rows of a CSV file.
    List,
    /// Random values in blocks that tell the axes apart.
    Sensitivity,
    /// From a coarse scan to the limits over two axes.
    Trace,
}

impl DesignKind {
    /// Whether its values are drawn.
    pub fn is_random(self) -> bool {
        matches!(self, DesignKind::MonteCarlo | DesignKind::Sensitivity)
    }
}

/// Where random points lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum PointsName {
    /// Anywhere, each by itself.
    #[default]
    Random,
    /// Evenly: scrambled points of Sobol's sequence.
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DesignTable {
    /// Which kind.
    pub kind: DesignKind,
    /// The axes of a grid, of random values or of a trace.
    #[serde(default)]
    pub axes: BTreeMap<Axis, AxisRange>,
    /// Random axes that go together.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub correlations: Vec<CorrelationTable>,
    /// Number of Monte Carlo cases, or of blocks of a sensitivity design.
    pub cases: Option<usize>,
    /// Where random points lie. Default random.
    #[serde(skip_serializing_if = "are_random")]
    pub points: Option<PointsName>,
    /// Seed of random values, and of the points that a trace draws where a limit is ragged.
    /// Default 0.
    pub seed: Option<u64>,
    /// CSV file of a list, beside the file that names it.
    pub file: Option<PathBuf>,
    /// Step of a trace along its limits, a part of either axis. Default 0.005.
    #[serde(skip_serializing_if = "is_usual")]
    pub tolerance: Option<f64>,
}

/// The values of one axis.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct AxisRange {
    /// First value, or lower end of a Monte Carlo range.
    pub from: Option<f64>,
    /// Last value, or upper end.
    pub to: Option<f64>,
    /// Number of values from `from` to `to`, of a grid or of the coarse scan of a trace.
    pub count: Option<usize>,
    /// Even steps in the value or in its logarithm, which maps are drawn in, too. Default `linear`.
    pub spacing: Spacing,
    /// Grid values one by one, instead of `from`, `to` and `count`.
    pub values: Option<Vec<f64>>,
    /// How random values are spread between `from` and `to`. Default uniform.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distribution: Option<DistributionName>,
    /// Of a normal distribution, before its ends are cut off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean: Option<f64>,
    /// Of a normal distribution.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard_deviation: Option<f64>,
    /// Of a log-normal distribution, before its ends are cut off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub median: Option<f64>,
    /// Of a log-normal distribution: a factor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geometric_standard_deviation: Option<f64>,
    /// The most frequent value of a triangular distribution.
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CorrelationTable {
    /// Which.
    pub axes: [Axis; 2],
    /// The coefficient of correlation of their normal scores.
    pub coefficient: f64,
}

/// How random values are spread.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
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
