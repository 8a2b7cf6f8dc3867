//! What is seen of a motion while it is stepped: regimes and measures, and whether the
//! rest is settled.

pub mod along;
pub mod axial;
pub(crate) mod band;
pub mod lateral;
pub(crate) mod motor;
pub(crate) mod rubbing;
pub mod rules;
pub(crate) mod settling;
pub(crate) mod shocks;
pub(crate) mod stress;
pub mod surface;
pub(crate) mod swing;
pub mod torsion;
mod turning;
