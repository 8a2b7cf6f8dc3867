//! Results folders: where they are, what they hold before a run, and whether the run may continue
//! from it.

mod damage;
mod found;
mod hold;
mod names;
mod owned_files;
mod place;
mod raise;
mod tables;

pub use damage::{in_words, tell_if_unverified};
pub use found::{FolderState, header_of, look};
pub use hold::{hold, tidy};
pub use names::{LOG, MANIFEST, REPORT};
pub use owned_files::{OwnedFiles, remove_page};
pub use place::{make_folder, results_folder};
pub use raise::{log_of_results, raise_log};
pub use tables::{refuse_empty, tables_of};
