//! Axes, their ranges, ticks and tick labels, without any drawing.

use super::numbers::{decade_label, linear_label, nice_step, power};

/// Room around the data at each end of an axis, as a fraction of the range.
const PADDING: f64 = 0.03;
/// Larger numbers are skipped, as differences of them could overflow.
const LARGEST: f64 = 1e300;
/// Smaller numbers on a logarithmic axis are skipped, as they lose digits.
const SMALLEST: f64 = 1e-300;
/// Ranges below this fraction of the values (or below [`SMALLEST`]) count as
/// a single value.
const RESOLUTION: f64 = 1e-9;

/// One axis of a plot.
#[derive(PartialEq)]
pub struct Axis {
    /// Title with the unit, e.g. `Weight W (kN)`.
    pub label: String,
    /// Whether the axis has a logarithmic scale; it then skips values that are
    /// not positive.
    pub logarithmic: bool,
}

impl Axis {
    /// The unit in which its title ends, if it does.
    pub(crate) fn unit(&self) -> &str {
        let in_brackets = self.label.strip_suffix(')');
        in_brackets
            .and_then(|label| label.rsplit_once('('))
            .map_or("", |(_, unit)| unit)
    }

    /// An axis with a linear scale.
    pub fn linear(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            logarithmic: false,
        }
    }

    /// An axis with a logarithmic scale.
    pub fn logarithmic(label: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            logarithmic: true,
        }
    }
}

/// The mapping of values to an axis.
#[derive(Clone, Copy)]
pub(crate) struct Scale {
    /// Ends of the axis; their decimal logarithms on a logarithmic axis.
    low: f64,
    high: f64,
    pub logarithmic: bool,
}

/// A mark on an axis.
pub(crate) struct Tick {
    /// Position between the axis ends, from 0 to 1.
    pub fraction: f64,
    /// The number at it; minor ticks have none.
    pub label: Option<String>,
}

impl Scale {
    /// The scale on which all `values` that it can show have a place.
    pub fn new(logarithmic: bool, values: impl Iterator<Item = f64>) -> Scale {
        let (low, high) = values
            .filter_map(|value| transform(value, logarithmic))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        let (low, high) = padded(low, high, logarithmic);
        Scale {
            low,
            high,
            logarithmic,
        }
    }

    /// The scale from the one end of an axis to the other where these are given, else that on which
    /// all `values` have a place.
    pub fn with_ends(
        ends: Option<[f64; 2]>,
        logarithmic: bool,
        values: impl Iterator<Item = f64>,
    ) -> Scale {
        let ends = ends.map(|ends| ends.map(|end| transform(end, logarithmic)));
        match ends {
            Some([Some(low), Some(high)]) => Scale {
                low,
                high,
                logarithmic,
            },
            _ => Scale::new(logarithmic, values),
        }
    }

    /// The values at the ends of the axis.
    pub fn ends(&self) -> [f64; 2] {
        [self.low, self.high].map(|end| match self.logarithmic {
            true => 10f64.powf(end),
            false => end,
        })
    }

    /// The place of a value, 0 and 1 being the ends of the axis; none if the
    /// scale cannot show it at all.
    pub fn fraction(&self, value: f64) -> Option<f64> {
        transform(value, self.logarithmic).map(|v| (v - self.low) / (self.high - self.low))
    }

    /// Ticks at round numbers, at most about `most` of them with a label.
    pub fn ticks(&self, most: usize) -> Vec<Tick> {
        let ticks = if self.logarithmic {
            self.logarithmic_ticks(most)
        } else {
            linear_ticks(self.low, self.high, most)
        };
        let ticks = ticks.into_iter().filter_map(|(value, label)| {
            let fraction = self.fraction(value)?;
            Some(Tick { fraction, label })
        });
        ticks.collect()
    }

    /// Whole decades, with 2 and 5 between them if there is room; on an axis
    /// too short for that, the round numbers of a linear one. Between labels for each
    /// decade there are ticks without at 1, 2, …, 9.
    fn logarithmic_ticks(&self, most: usize) -> Vec<Labelled> {
        let fine = self.decade_ticks(&[1, 2, 5], 1);
        if fine.len() < 3 {
            let [low, high] = self.ends();
            return linear_ticks(low, high, most);
        }
        let every = ((self.high - self.low).ceil() / most as f64).ceil();
        let labelled = if fine.len() <= most {
            fine
        } else if every <= 1.0 {
            self.decade_ticks(&[1], 1)
        } else {
            return self.decade_ticks(&[1], every as i32);
        };
        let minor = self.decade_ticks(&[1, 2, 3, 4, 5, 6, 7, 8, 9], 1);
        let minor = minor.into_iter().map(|(value, _)| (value, None));
        minor.chain(labelled).collect()
    }

    /// The numbers `digit`·10ⁿ on the axis, for n a multiple of `every`.
    fn decade_ticks(&self, digits: &[i32], every: i32) -> Vec<Labelled> {
        let exponents = self.low.floor() as i32..=self.high.ceil() as i32;
        exponents
            .filter(|exponent| exponent % every == 0)
            .flat_map(|exponent| digits.iter().map(move |&digit| (digit, exponent)))
            .map(|(digit, exponent)| (power(digit, exponent), decade_label(digit, exponent)))
            .filter(|(value, _)| (self.low..=self.high).contains(&value.log10()))
            .map(|(value, label)| (value, Some(label)))
            .collect()
    }
}

/// A number and how it is written, unless that of a minor tick.
type Labelled = (f64, Option<String>);

/// The points that both axes can show.
pub(crate) fn visible(
    [x, y]: &[Axis; 2],
    points: impl Iterator<Item = (f64, f64)>,
) -> impl Iterator<Item = (f64, f64)> {
    let (x, y) = (x.logarithmic, y.logarithmic);
    points.filter(move |point| transform(point.0, x).is_some() && transform(point.1, y).is_some())
}

/// The value along the axis, or none if the axis cannot show it.
fn transform(value: f64, logarithmic: bool) -> Option<f64> {
    if logarithmic {
        (SMALLEST..=LARGEST).contains(&value).then(|| value.log10())
    } else {
        (value.abs() <= LARGEST).then_some(value)
    }
}

/// Adds the padding; makes a range of none for no data or a single value.
fn padded(low: f64, high: f64, logarithmic: bool) -> (f64, f64) {
    if low > high {
        return if logarithmic { (-1.0, 0.0) } else { (0.0, 1.0) };
    }
    let size = low.abs().max(high.abs());
    if high - low > (RESOLUTION * size).max(SMALLEST) {
        let room = PADDING * (high - low);
        return (low - room, high + room);
    }
    let room = if logarithmic {
        0.1
    } else if size > SMALLEST {
        0.05 * size
    } else {
        0.5
    };
    (low - room, high + room)
}

/// Round numbers from `low` to `high`, about `most` of them, with labels; but two at least, for one
/// shows no distance.
fn linear_ticks(low: f64, high: f64, most: usize) -> Vec<Labelled> {
    let finer = (0..FINER).map(|halvings| ticks_of_step(low, high, most << halvings));
    let mut finer = finer.skip_while(|ticks| ticks.len() < 2);
    finer
        .next()
        .unwrap_or_else(|| ticks_of_step(low, high, most))
}

/// Times that a step is halved at most.
const FINER: u32 = 4;

/// Round numbers from `low` to `high`, about `most` of them.
fn ticks_of_step(low: f64, high: f64, most: usize) -> Vec<Labelled> {
    let (digit, exponent) = nice_step((high - low) / most as f64);
    let step = power(digit, exponent);
    let largest = low.abs().max(high.abs());
    // Counting in whole steps keeps rounding errors from adding up.
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    (first..=last)
        .map(|count| {
            let value = count as f64 * step;
            (value, Some(linear_label(value, largest, exponent)))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(logarithmic: bool, values: &[f64], most: usize) -> Vec<String> {
        let ticks = Scale::new(logarithmic, values.iter().copied()).ticks(most);
        ticks.into_iter().filter_map(|tick| tick.label).collect()
    }

    /// Wherever it is, and however narrow the panel.
    #[test]
    fn an_axis_has_two_ticks_at_least() {
        for (from, to) in [
            (0.0, 0.6),
            (0.26, 0.34),
            (59.9, 61.2),
            (1.1, 1.9),
            (-3.0, 7.0),
        ] {
            for most in 1..6 {
                let found = labels(false, &[from, to], most);
                assert!(found.len() >= 2, "{from} to {to} in {most}: {found:?}");
            }
        }
    }

    #[test]
    fn linear_labels_are_round_and_short() {
        let tenths = ["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6"];
        assert_eq!(labels(false, &[0.0, 0.6], 8), tenths);
        assert_eq!(
            labels(false, &[-10.0, 10.0], 5),
            ["−10", "−5", "0", "5", "10"]
        );
        assert_eq!(labels(false, &[0.0, 2e6], 3), ["0", "1×10⁶", "2×10⁶"]);
        assert_eq!(labels(false, &[0.0, 2e-5], 3), ["0", "1×10⁻⁵", "2×10⁻⁵"]);
    }

    #[test]
    fn logarithmic_labels_suit_the_range() {
        assert_eq!(labels(true, &[0.01, 10.0], 6), ["0.01", "0.1", "1", "10"]);
        assert_eq!(labels(true, &[1.0, 20.0], 8), ["1", "2", "5", "10", "20"]);
        assert_eq!(labels(true, &[1e-6, 1e6], 4), ["10⁻⁴", "1", "10000"]);
        assert_eq!(labels(true, &[2.2, 2.8], 4), ["2.2", "2.4", "2.6", "2.8"]);
    }

    #[test]
    fn the_range_is_padded_and_skips_what_it_cannot_show() {
        let scale = Scale::new(false, [0.0, f64::NAN, 100.0, f64::INFINITY].into_iter());
        assert!((scale.low + 3.0).abs() < 1e-9 && (scale.high - 103.0).abs() < 1e-9);
        assert_eq!(scale.fraction(f64::NAN), None);
        let scale = Scale::new(true, [-5.0, 0.0, 1.0, 100.0].into_iter());
        assert!((scale.low + 0.06).abs() < 1e-9 && (scale.high - 2.06).abs() < 1e-9);
        assert_eq!(scale.fraction(0.0), None);
    }

    #[test]
    fn extreme_data_still_give_a_finite_range() {
        for values in [
            &[][..],
            &[0.0],
            &[5e-324],
            &[7.0, 7.0],
            &[1e16, 1e16 + 2.0],
            &[-1e300, 1e300],
        ] {
            for logarithmic in [false, true] {
                let scale = Scale::new(logarithmic, values.iter().copied());
                assert!(scale.low < scale.high, "{values:?}");
                let ticks = scale.ticks(6);
                assert!(
                    ticks.len() >= 2 && ticks.len() < 100,
                    "{values:?}: {}",
                    ticks.len()
                );
                assert!(
                    ticks
                        .iter()
                        .all(|t| (-1e-6..=1.000001).contains(&t.fraction))
                );
            }
        }
    }
}
