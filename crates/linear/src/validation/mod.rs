//! Closed forms and formulations that the library does not use, against what is inside
//! it. What its public face gives is validated in `tests`.

#[allow(dead_code, reason = "the other crates use the rest")]
#[path = "../../../problems/src/academic.rs"]
pub(crate) mod academic;
mod bending_waves;
mod finite_elements;
#[allow(dead_code, reason = "the other crates use the rest")]
#[path = "../../../problems/src/oracles.rs"]
mod oracles;
mod torsion_waves;
