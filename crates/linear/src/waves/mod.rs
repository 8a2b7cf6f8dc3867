//! Exact frequency responses of the string at any complex Laplace variable s
//! (Sections 2.2 and 2.5 of the paper): wave solutions of each uniform tube,
//! joined into a chain, reduced to the surface and the sites.

pub mod bending;
pub mod block;
pub mod chain;
pub mod inversion;
pub mod lateral;
pub mod network;
pub mod torsion;
