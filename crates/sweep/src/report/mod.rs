//! What results folders say, for people: `sweep summary` and `sweep report`.
//!
//! `results` reads a folder in one pass over its cases, so that memory does not grow
//! with them; `comparison` compares two folders. `sections` makes words and tables of
//! both, which a terminal (`text`) and a page (`page`) show alike; of maps
//! `live_map` makes a drawing that answers who points at it. `analysed` and `deciding` are of
//! counts of random cases, as `sweep analyse` tells them.

mod agreement;
mod analysed;
mod character_map;
mod comparison;
mod deciding;
mod document;
mod escaping;
mod failures;
mod html;
mod limit;
mod live_map;
mod page;
mod provenance;
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
pub use page::{is_page, page};
pub use results::Results;
pub use sections::sections;
pub use summary::SummaryFound;
pub use text::text;
