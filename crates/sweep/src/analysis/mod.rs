//! What a results folder says in numbers: how often each regime occurs, in all and over ranges of
//! the axes, how sure that is, and which axis decides. Rows are read one by one, and only
//! counts are kept.

mod bins;
mod counts;
mod interval;
mod sensitivity;

pub use bins::Bins;
pub use counts::{Counts, Group};
pub use interval::{Interval, cases_for, wilson};
pub use sensitivity::sensitivity;
