//! Parts of a sweep for several machines.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::design::MOST_CASES;

/// Part `index` of `of`, counted from 0. The whole sweep is part 0 of 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Shard {
    /// Which part.
    pub index: usize,
    /// Of how many.
    pub of: usize,
}

impl Shard {
    /// The whole sweep.
    pub const WHOLE: Shard = Shard { index: 0, of: 1 };

    /// Whether the case at a position among the cases of its string is of this
    /// part. Where there are enough strings, they are dealt whole, so that each
    /// is built in one place; else the cases are dealt, neighbours apart, for
    /// they take about the same time. A string of one case is always dealt whole, so
    /// that the part of a random case does not depend on how many there are.
    pub fn has(self, strings: usize, string: usize, cases: usize, position: usize) -> bool {
        if strings >= self.of || cases == 1 {
            string % self.of == self.index
        } else {
            position % self.of == self.index
        }
    }

    /// Whether this is the whole sweep.
    pub fn is_whole(self) -> bool {
        self.of == 1
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}

/// Why a text names no part of a sweep.
#[derive(Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ShardError {
    /// It is not written as one.
    #[error("expected I/N with I from 0 to N − 1, such as 0/4")]
    NoShard,
    /// Some parts could only be empty.
    #[error("N is more than {}, the most cases of a sweep", MOST_CASES)]
    TooMany,
}

impl FromStr for Shard {
    type Err = ShardError;

    fn from_str(text: &str) -> Result<Self, ShardError> {
        let numbers = text.split_once('/').and_then(|(index, of)| {
            let number = |text: &str| text.trim().parse::<usize>().ok();
            number(index).zip(number(of))
        });
        let (index, of) = (numbers.filter(|(index, of)| index < of)).ok_or(ShardError::NoShard)?;
        if of > MOST_CASES {
            return Err(ShardError::TooMany);
        }
        Ok(Self { index, of })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Which shards have a case.
    fn holders(of: usize, strings: usize, string: usize, cases: usize, at: usize) -> Vec<usize> {
        let has = |index: &usize| Shard { index: *index, of }.has(strings, string, cases, at);
        (0..of).filter(has).collect()
    }

    #[test]
    fn every_case_is_in_one_shard() {
        for (strings, cases) in [(1, 10), (3, 4), (12, 1)] {
            for of in [1, 2, 3, 5, 20] {
                for string in 0..strings {
                    for position in 0..cases {
                        let holders = holders(of, strings, string, cases, position);
                        assert_eq!(holders.len(), 1);
                    }
                }
            }
        }
    }

    #[test]
    fn the_part_of_a_random_case_does_not_depend_on_their_number() {
        for of in [1, 2, 7] {
            // All of one string, or a string for each.
            let parts = |cases: usize, case: usize| {
                let of_one = holders(of, 1, 0, cases, case);
                [of_one, holders(of, cases, case, 1, 0)]
            };
            for case in 0..3 {
                assert_eq!(parts(3, case), parts(20, case), "{case} of {of}");
            }
        }
    }

    #[test]
    fn what_is_no_shard_is_refused() {
        let (many, too_many) = (format!("0/{MOST_CASES}"), format!("0/{}", MOST_CASES + 1));
        assert!(many.parse::<Shard>().is_ok());
        assert_eq!(too_many.parse::<Shard>(), Err(ShardError::TooMany));
        for text in ["", "1", "4/4", "-1/4", "0/0", "a/b", "1/2/3"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
        assert_eq!("3/4".parse(), Ok(Shard { index: 3, of: 4 }));
    }
}
