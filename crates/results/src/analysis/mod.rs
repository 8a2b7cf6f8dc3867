//! What a results folder says in numbers: how often each regime occurs, in all and over ranges of
//! the axes, how sure that is, and which axis decides. Rows are read one by one, and only
//! counts are kept.
//!
//! How sure a fraction is, and which axis decides:
//!
//! ```
//! use results::analysis::{more_cases, sensitivity, wilson};
//!
//! let fraction = wilson(81, 263).ok_or("there are cases")?;
//! assert!((fraction.low - 0.2553).abs() < 1e-4 && (fraction.high - 0.3662).abs() < 1e-4);
//! // Half the width takes about four times the cases.
//! let [wide, narrow] = [0.1, 0.05].map(|width| more_cases(0.3, 0, width) as f64);
//! assert!((narrow / wide - 4.0).abs() < 0.1);
//!
//! // Cases with a regime, and all of them, in ranges of an axis that decides alone.
//! let decides = sensitivity(&[[0, 500], [0, 500], [500, 500], [500, 500]]).ok_or("labels differ")?;
//! assert!(decides.value > 0.99);
//! # Ok::<(), &str>(())
//! ```

mod bins;
mod blocks;
mod counts;
mod indices;
mod interval;
mod of_tables;
mod rows;
mod sensitivity;

pub use bins::Bins;
pub use blocks::MethodBlocks;
pub use counts::Counts;
#[cfg(test)]
pub use counts::Group;
pub use indices::{DRAWN, IndexUnavailable, Indices, LEAST_BLOCKS};
pub use interval::{Interval, more_cases, wilson};
pub use of_tables::{Analysis, NoAnalysis, blocks, count_cases, size_of_blocks};
pub use rows::{COUNT_COLUMNS, CountRow, INDEX_COLUMNS, IndexRow, count_rows, index_rows};
pub use sensitivity::sensitivity;
