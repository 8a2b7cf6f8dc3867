//! What results folders say, for people: `sweep summary` and `sweep report`.
//!
//! `results` reads a folder into numbers in one pass over its cases, so that
//! memory does not grow with them; `comparison` holds one folder against another.
//! `sections` says both in words and tables, once, so that a terminal (`text`) and
//! a page (`page`) show the same numbers.

mod agreement;
mod character_map;
mod comparison;
mod document;
mod failures;
mod html;
mod limit;
mod page;
mod provenance;
mod results;
mod sections;
mod text;

pub use comparison::Comparison;
pub use page::{is_page, page};
pub use results::Results;
pub use sections::sections;
pub use text::text;
