//! What a limit says of a stretch of the map.

use serde::{Serialize, Serializer};

/// How a stretch of the map stands to a limit, from harmless to unknown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Standing {
    /// All of it is on the right side, farther away than the limit is uncertain.
    Clear,
    /// All of it is where what is limited does not begin by itself, and can last once begun.
    Possible,
    /// The limit may pass it.
    Near,
    /// All of it is on the wrong side.
    Against,
    /// Cases there have no answer, or none that tells.
    Undetermined,
}

impl Standing {
    /// Every one, from harmless to unknown.
    pub const ALL: [Self; 5] = [
        Standing::Clear,
        Standing::Possible,
        Standing::Near,
        Standing::Against,
        Standing::Undetermined,
    ];

    /// Its name in `window.csv`.
    pub fn key(self) -> &'static str {
        match self {
            Standing::Clear => "safe",
            Standing::Possible => "safe_unless_begun",
            Standing::Near => "near",
            Standing::Against => "against",
            Standing::Undetermined => "untold",
        }
    }

    /// Of a range that is clear above `clear_from` and against below `against_below`.
    pub fn above([low, high]: [f64; 2], against_below: f64, clear_from: f64) -> Self {
        if low >= clear_from {
            Standing::Clear
        } else if high <= against_below {
            Standing::Against
        } else {
            Standing::Near
        }
    }
}

/// By its name in `window.csv`.
impl Serialize for Standing {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.key())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_range_that_reaches_into_the_margin_is_near() {
        let of = |range| Standing::above(range, 2.0, 3.0);
        assert_eq!(of([0.0, 2.0]), Standing::Against);
        assert_eq!(of([1.9, 2.1]), Standing::Near);
        assert_eq!(of([2.2, 2.8]), Standing::Near);
        assert_eq!(of([0.0, 9.0]), Standing::Near);
        assert_eq!(of([3.0, 9.0]), Standing::Clear);
    }
}
