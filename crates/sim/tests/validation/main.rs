//! Held to closed forms, to other methods and to other programs.

mod bits;
mod cutting;
mod energy;
mod falling_friction;
mod forward_whirl;
mod held;
mod limited_drive;
mod lines;
mod low_side;
mod many_sites;
mod motor;
mod own_law;
mod own_regimes;
mod pieces;
mod poles;
mod start;
mod stepped;
mod stribeck;
mod string_friction;
mod surface_torque;
mod wall;
mod whirl;
