//! What results folders say, for people: `sweep summary` and `sweep report`.
//!
//! `results` reads a folder in one pass over its cases, so that memory does not grow
//! with them; `comparison` compares two folders. `sections` makes words and tables of
//! both, which a terminal (`text`) and a page (`page`) show alike: first the `opening`, in the
//! `phrases` of a driller, for which `lattice` finds where regimes begin. Of maps `live_map` makes a
//! drawing that answers who points at it, of counts `bars` and `ranges` make pictures. `analysed` and
//! `deciding` are of counts of random cases, as `sweep analyse` tells them.

mod agreement;
mod analysed;
mod bars;
mod character_map;
mod comparison;
mod deciding;
mod document;
mod escaping;
mod failures;
mod html;
mod lattice;
mod limit;
mod live_map;
mod opening;
mod page;
mod phrases;
mod provenance;
mod ranges;
mod results;
mod sections;
mod summary;
mod text;

pub use analysed::analysed_sections;
pub use comparison::compare;
pub use document::Table;
pub use escaping::escaped;
pub use html::table;
pub use live_map::shown;
pub use page::{is_page, page, policy};
pub use results::Results;
pub use sections::sections;
pub use summary::SummaryFound;
pub use text::text;
