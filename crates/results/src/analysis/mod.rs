//! What a results folder says in numbers: how often each regime occurs, in all and over ranges of
//! the axes, how sure that is, and which axis decides. Rows are read one by one, and only
//! counts are kept.

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
pub use interval::{Interval, cases_for, wilson};
pub use of_tables::{Analysis, NoAnalysis, blocks, count_cases, size_of_blocks};
pub use rows::{COUNT_COLUMNS, CountRow, INDEX_COLUMNS, IndexRow, count_rows, index_rows};
pub use sensitivity::sensitivity;
