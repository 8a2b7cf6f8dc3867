//! What is shown of a sweep: regime maps of a results folder ([`map`]), single cases to their end
//! ([`histories`]), what a folder says, for terminals and as a page ([`report`]), and the page on which a
//! case is simulated anew ([`explore`]).
//!
//! Nothing here runs a sweep or writes a file: all comes from `campaign` and `results`, is drawn by `plot`,
//! and is given back as pictures, text or HTML.

pub mod explore;
pub mod histories;
pub mod map;
pub mod report;
