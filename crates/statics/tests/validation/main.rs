//! The static string against independent elements and an ODE solver, and against closed forms.

mod carried_pipe;
mod closed_forms;
mod field_case;
mod random_wells;
mod uniform_pipe;
