//! Held to closed forms, to other methods and to other programs.

mod axial_force;
mod axial_modes;
mod bending_responses;
mod convergence;
mod elements;
mod falling_torque;
mod held;
mod held_above;
mod lengths;
mod loss;
mod moments;
mod natural_frequencies;
mod quasi_static_twist;
mod regenerative;
mod sampling;
mod side_force;
mod top_drive;
