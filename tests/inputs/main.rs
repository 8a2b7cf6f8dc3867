//! What a user may give: sweep files, sheets, surveys, workbooks, axes; and what is refused.

mod axes;
mod bad_input;
mod bha_sheet;
mod extremes;
mod files;
mod listed_results;
mod random_axes;
mod schema;
mod standard_input;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/refusals.rs"]
mod refusals;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/soon.rs"]
mod soon;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/workbook.rs"]
mod workbook;
