//! The commands, as a user types them.

mod accuracy;
mod analyse;
mod certain;
mod certain_of_lying;
mod command_line;
mod cutting;
mod documents;
mod drive_delay;
mod drive_limit;
mod export;
mod lying;
mod lying_shape;
mod lying_turned;
mod motor;
mod one_slip;
mod sensitivity;
mod trace;
mod walls;
mod whirl_sampling;
mod window;
mod window_of_lying;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/refusals.rs"]
mod refusals;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
