//! Cases in full: their motion to the end of their time, as tables, pictures (Figs. 7, 8,
//! 10–13, 15 and 16, frequencies and phases of the bit, contact with the wall, the string in its hole, the rock below a bit that cuts)
//! and words.

mod contact_map;
mod film;
mod known;
mod lines;
mod marks;
mod orbits;
mod over_time;
mod phases;
mod spectra;
mod spectrum;
mod string_tables;
mod surface;
mod tables;
#[cfg(test)]
mod validation;
mod vibration;
mod whole_string;

pub use contact_map::contact_picture;
pub use film::film_picture;
pub use lines::case_lines;
pub use orbits::orbit_picture;
pub use over_time::history_picture;
pub use phases::phase_picture;
pub use spectra::spectra_picture;
pub use string_tables::{film_csv, string_csv};
pub use surface::{cut_picture, surface_picture};
pub use tables::{case_csv, contacts_csv, history_csv};
pub use whole_string::{string_picture, whole_strings};
