//! What the string is hit with: the same momentum at the same places however many contacts there
//! are.

use super::places::Range;

/// A blow along the string is handed to it at so many places of the range: at even distances, as
/// many as the most contacts of the study, so that it is the same blow at every number of them.
const PLACES: usize = 64;

/// What the string is hit with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Blow {
    /// At one place.
    Knock {
        /// Distance from the bit, m.
        from_bit: f64,
        /// What it is in multiples of I₀, which just brings the place to the wall; about, for the
        /// amount is rounded.
        ratio: f64,
        /// Amount, N s.
        amount: f64,
    },
    /// All along the range of contacts.
    Along {
        /// Amount, N s per metre.
        per_metre: f64,
        /// Where.
        range: Range,
    },
}

impl Blow {
    /// A knock of about so many times I₀ (N s): its amount has two digits, as a person would say
    /// it, and is the same by every method.
    pub fn knock(from_bit: f64, ratio: f64, least_impulse: f64) -> Self {
        let amount = ratio * least_impulse;
        let digits = 10f64.powf(amount.log10().floor() - 1.0);
        Blow::Knock {
            from_bit,
            ratio,
            amount: (amount / digits).round() * digits,
        }
    }

    /// All of its momentum, N s.
    pub fn amount(&self) -> f64 {
        match self {
            Blow::Knock { amount, .. } => *amount,
            Blow::Along { per_metre, range } => per_metre * range.length(),
        }
    }

    /// Where a blow along a range hits, m from the bit.
    pub fn places_along(range: &Range) -> Vec<f64> {
        range.even(PLACES)
    }

    /// Where it hits (m from the bit), and with what (N s).
    pub fn impulses(&self) -> Vec<(f64, f64)> {
        match self {
            Blow::Knock {
                from_bit, amount, ..
            } => vec![(*from_bit, *amount)],
            Blow::Along { range, .. } => {
                let part = self.amount() / PLACES as f64;
                let places = Self::places_along(range).into_iter();
                places.map(|place| (place, part)).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blow_hands_over_all_of_its_momentum() {
        let range = Range {
            from: 0.0,
            to: 200.0,
        };
        let along = Blow::Along {
            per_metre: 150.0,
            range,
        };
        for (blow, amount) in [(along, 30_000.0), (Blow::knock(50.0, 3.0, 1126.0), 3400.0)] {
            let handed: f64 = blow.impulses().iter().map(|(_, part)| part).sum();
            assert!((handed - amount).abs() < 1e-9, "{handed}");
            assert_eq!(blow.amount(), amount);
        }
    }
}
