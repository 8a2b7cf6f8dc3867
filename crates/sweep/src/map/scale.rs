//! Classes of a quantity between round numbers, distinguished by shade.

use campaign::words::short;
use plot::Fraction;

/// As many classes as there are shades.
const CLASSES: usize = Fraction::EVERY.len();

/// Steps of a scale in parts of a power of ten.
const ROUND: [f64; 4] = [1.0, 2.0, 2.5, 5.0];

/// Ends of classes that double, or a little more, in parts of a power of ten.
const DOUBLING: [f64; 3] = [1.0, 2.0, 5.0];

/// Even classes tell little where one has a larger part of all values.
const MOST_IN_ONE: f64 = 0.7;

/// Classes of the values between their ends.
#[derive(Debug, PartialEq)]
pub struct Classes {
    /// In ascending order: no value is below the first or above the last.
    ends: Vec<f64>,
}

impl Classes {
    /// Even classes; of amounts that would nearly all be in one, for few are much larger, classes
    /// that double from one to the next.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.retain(|value| value.is_finite());
        values.sort_by(f64::total_cmp);
        let even = Self::even(&values);
        let mut fullest = [0; CLASSES];
        for value in &values {
            fullest[even.class(*value)] += 1;
        }
        let most = fullest.into_iter().max().unwrap_or_default() as f64;
        if even.count() == 1 || most <= MOST_IN_ONE * values.len() as f64 {
            return even;
        }
        Self::doubling(&values).unwrap_or(even)
    }

    fn even(sorted: &[f64]) -> Self {
        let [low, high] = [sorted.first(), sorted.last()].map(|end| end.copied().unwrap_or(0.0));
        let span = (high - low).max(1e-9 * low.abs().max(high.abs()));
        let span = if span > 0.0 { span } else { 1.0 };
        let power = 10f64.powf((span / CLASSES as f64).log10().floor());
        let powers = [power, 10.0 * power];
        let steps = powers
            .into_iter()
            .flat_map(|power| ROUND.map(|part| part * power));
        let count = |step: f64| {
            let from = (low / step).floor();
            ((high / step).ceil() - from).max(1.0) as usize
        };
        let step = steps.into_iter().find(|step| count(*step) <= CLASSES);
        let step = step.unwrap_or(100.0 * power);
        let from = (low / step).floor();
        let ends = (0..=count(step)).map(|end| (from + end as f64) * step);
        Self {
            ends: ends.collect(),
        }
    }

    /// Down from the greatest, the last one to nothing; none where there is no amount.
    fn doubling(sorted: &[f64]) -> Option<Self> {
        let (least, greatest) = (*sorted.first()?, *sorted.last()?);
        if least < 0.0 || greatest <= 0.0 {
            return None;
        }
        let above = greatest.log10().ceil() as i32;
        let ends =
            (above - 3..=above).flat_map(|power| DOUBLING.map(|part| part * 10f64.powi(power)));
        let ends: Vec<f64> = ends.collect();
        let top = ends.iter().position(|end| *end >= greatest)?;
        let lowest = top + 1 - CLASSES.min(top + 1);
        let ends = std::iter::once(0.0).chain(ends[lowest..=top].iter().copied());
        Some(Self {
            ends: ends.collect(),
        })
    }

    fn count(&self) -> usize {
        self.ends.len() - 1
    }

    fn class(&self, value: f64) -> usize {
        let inner = &self.ends[1..self.count()];
        inner.partition_point(|end| *end <= value)
    }

    /// The shade of a value: the greater, the darker.
    pub fn shade(&self, value: f64) -> Fraction {
        self.shade_of(self.class(value))
    }

    /// Fewer classes than shades are spread over them.
    fn shade_of(&self, class: usize) -> Fraction {
        Fraction::EVERY[class * (CLASSES - 1) / (self.count() - 1).max(1)]
    }

    /// Each shade with its range, from the lowest up.
    pub fn words(&self) -> Vec<(Fraction, String)> {
        let pairs = self.ends.windows(2).enumerate();
        pairs
            .map(|(class, ends)| {
                let words = format!("{} to {}", short(ends[0]), short(ends[1]));
                (self.shade_of(class), words)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(values: &[f64]) -> Vec<String> {
        let classes = Classes::of(values.to_vec());
        classes
            .words()
            .into_iter()
            .map(|(_, words)| words)
            .collect()
    }

    #[test]
    fn classes_end_at_round_numbers_and_hold_all() {
        let tenths: Vec<f64> = (0..=11).map(|tenth| 0.1 * f64::from(tenth)).collect();
        assert_eq!(
            words(&tenths),
            [
                "0 to 0.2",
                "0.2 to 0.4",
                "0.4 to 0.6",
                "0.6 to 0.8",
                "0.8 to 1",
                "1 to 1.2"
            ]
        );
        assert_eq!(words(&[-3.0, 9.0]).len(), 6);
        assert_eq!(words(&[7.0]).len(), 1);
        assert_eq!(words(&[]).len(), 1);
        for (low, high) in [(0.0, 1e-12), (-5e4, 3e5), (1e6, 1.001e6), (0.1, 0.7)] {
            let classes = Classes::of(vec![low, high]);
            assert!((2..=CLASSES).contains(&classes.count()), "{classes:?}");
            assert!(classes.ends[0] <= low + 1e-9 * high.abs());
            assert!(classes.ends[classes.count()] >= high * (1.0 - 1e-9));
            assert!(classes.shade(low) != classes.shade(high));
        }
    }

    #[test]
    fn where_few_are_much_larger_classes_double() {
        let mut values = vec![0.001; 100];
        values.extend((1..=60).map(|value| 1.0 + 0.01 * f64::from(value)));
        values.push(40.0);
        assert_eq!(
            words(&values),
            [
                "0 to 1", "1 to 2", "2 to 5", "5 to 10", "10 to 20", "20 to 50"
            ]
        );
        // Amounts on both sides of zero always have even classes.
        values.push(-40.0);
        assert_eq!(words(&values)[0], "-40 to -20");
    }
}
