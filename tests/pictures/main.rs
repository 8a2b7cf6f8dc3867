//! Pictures and pages.

mod explore;
mod maps;
mod page_engine;
mod pictures;
mod report;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/tables.rs"]
mod tables;
