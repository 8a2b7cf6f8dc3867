//! A bit that cuts what its blades have left: held to independent programs, to exact delay lines
//! next to it, to the linear limit, to its laws and to its energy.

mod cycles;
mod delay_lines;
mod energy;
mod growth;
mod laws;
mod places;
mod ratios;
mod scene;
