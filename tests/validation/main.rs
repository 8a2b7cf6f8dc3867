//! What is computed, held to the paper, to closed forms and to other methods.

mod axial_force;
mod cutting_in_fig09;
mod early_stop;
mod forward_contact;
mod found_sites;
mod hole;
mod limited_drive_labels;
mod on_bottom;
mod paper_lateral;
mod paper_torsion;
mod poles_labels;
mod recorded_start;
mod recorded_well;
mod rows;
mod string_friction;
mod surface_torque;
mod time_rule;
mod top_drive;
mod tradeoff;
mod whirl_limit;
mod whirl_that_lasts;

#[allow(dead_code, reason = "other test programs use more of it")]
#[path = "../support/mod.rs"]
mod support;
