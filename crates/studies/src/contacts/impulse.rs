//! The impulses on the string: the same momentum at the same places for any number of contacts.

use super::places::Range;

/// A distributed impulse acts at this number of places of the range, at even distances: as many as
/// the most contacts of the study, so that it is the same for every number of them.
const PLACES: usize = 64;

/// A lateral impulse on the string.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum LateralImpulse {
    /// At one place.
    Local {
        /// Distance from the bit, m.
        from_bit: f64,
        /// About its multiple of I₀, which just brings the place to the wall; the amount is
        /// rounded.
        ratio: f64,
        /// Amount, N s.
        amount: f64,
    },
    /// All along the range of contacts.
    Distributed {
        /// Amount, N s per metre.
        per_metre: f64,
        /// Where.
        range: Range,
    },
}

impl LateralImpulse {
    /// An impulse at one place of about `ratio` times I₀ (N s): its amount is rounded to two
    /// digits, and is the same by every method.
    pub fn local(from_bit: f64, ratio: f64, least_impulse: f64) -> Self {
        let amount = ratio * least_impulse;
        let digits = 10f64.powf(amount.log10().floor() - 1.0);
        LateralImpulse::Local {
            from_bit,
            ratio,
            amount: (amount / digits).round() * digits,
        }
    }

    /// All of its momentum, N s.
    pub fn amount(&self) -> f64 {
        match self {
            LateralImpulse::Local { amount, .. } => *amount,
            LateralImpulse::Distributed { per_metre, range } => per_metre * range.length(),
        }
    }

    /// Where a distributed impulse acts, m from the bit.
    pub fn places_along(range: &Range) -> Vec<f64> {
        range.even(PLACES)
    }

    /// Where it acts (m from the bit), and with what amounts (N s).
    pub fn by_place(&self) -> Vec<(f64, f64)> {
        match self {
            LateralImpulse::Local {
                from_bit, amount, ..
            } => vec![(*from_bit, *amount)],
            LateralImpulse::Distributed { range, .. } => {
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
    fn an_impulse_transfers_all_of_its_momentum() {
        let range = Range {
            from: 0.0,
            to: 200.0,
        };
        let along = LateralImpulse::Distributed {
            per_metre: 150.0,
            range,
        };
        for (impulse, amount) in [
            (along, 30_000.0),
            (LateralImpulse::local(50.0, 3.0, 1126.0), 3400.0),
        ] {
            let handed: f64 = impulse.by_place().iter().map(|(_, part)| part).sum();
            assert!((handed - amount).abs() < 1e-9, "{handed}");
            assert_eq!(impulse.amount(), amount);
        }
    }
}
