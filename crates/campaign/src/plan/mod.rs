//! What is run: the keys of a sweep file and the cases of its design, checked together
//! and resolved to SI.

mod axial_force;
mod band_doubts;
mod bit;
mod bit_doubts;
mod candidates;
mod certify;
mod choice;
mod compare;
mod conditions;
mod contacts;
mod cutting;
mod data;
mod doubts;
mod drive_limit;
mod drive_torque;
mod finding;
mod full_gauge;
#[cfg(test)]
mod guide;
mod hole;
mod impulses;
#[cfg(test)]
mod in_hole;
mod lateral;
mod lying;
mod map;
mod methods;
mod motor;
mod motor_stall;
mod sampling;
mod setting;
mod sheet;
mod sites;
mod start;
mod steady_drilling;
mod stress;
mod string;
mod string_friction;
mod sweep;
#[cfg(test)]
mod tests;
mod texts;
mod tools;
mod top_drive;
mod wall;
mod well_course;
mod whirl;
mod whirl_doubts;

pub use bit::{Bit, TorqueError};
pub use choice::{Candidate, Choice, Islands, Tried};
pub use compare::Comparison;
pub use conditions::Conditions;
pub use cutting::{Begins, CuttingSettings, SteadyDrilling};
pub use data::Data;
pub use finding::Finding;
pub use impulses::{ImpulseAmount, ImpulseSettings, LARGEST_IMPULSE};
pub use lateral::LateralSettings;
pub use lying::{Lying, LyingStart};
pub use map::{MapMark, MapSettings};
pub use setting::Setting;
pub use sheet::POUND_PER_FOOT;
pub use start::Starts;
pub use string_friction::{StringFriction, is_in_pieces};
pub use sweep::Sweep;
pub use wall::WallSettings;
pub use whirl::steps_of_turn;
