//! One file or folder for each command, and what they share: how the program ends and
//! what it says, threads and progress, sweeps that are read and results folders.

pub mod analyse;
pub mod check;
mod choosing;
mod contacts;
mod cost;
mod csv_table;
mod drawing;
pub mod explore;
pub mod export;
mod folder;
pub mod inspect;
mod listed;
mod margin;
pub mod merge;
pub mod new;
mod outcome;
mod outputs;
pub mod plot;
mod prepare;
mod progress;
mod promises;
pub mod reference;
pub mod report;
pub mod run;
pub mod schema;
pub mod shell;
pub mod simulate;
mod stability;
pub mod status;
pub mod stop;
pub mod study;
pub mod terminal;
mod threads;
mod tradeoff;
mod warnings;
pub mod window;
