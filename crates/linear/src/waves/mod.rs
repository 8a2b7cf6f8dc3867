//! Exact frequency responses of the string at any complex Laplace variable s
//! (Sections 2.2 and 2.5 of the paper): wave solutions of each uniform tube,
//! joined into a chain, reduced to the surface and the sites (`assembly`).

pub(crate) mod bending;
pub mod inversion;
pub mod lateral;
pub mod lattice;
pub mod network;
pub(crate) mod torsion;
pub mod transfer;

pub use crate::assembly::matrix::ResponseMatrix;
pub use crate::assembly::torsion::TorsionAdmittance;
