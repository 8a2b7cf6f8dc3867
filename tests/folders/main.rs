//! Results folders: what is written, stopped, shared, damaged and refused.

mod failures;
mod interruption;
mod outputs;
mod resources;
mod results_folder;
mod shards;
mod slurm;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/crc32.rs"]
mod crc32;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/refusals.rs"]
mod refusals;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/soon.rs"]
mod soon;
#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
