//! Closed forms and formulations that the library does not use, against what is inside
//! it. What its public face gives is validated in `tests`.

mod bending_waves;
mod finite_elements;
#[path = "../../tests/oracles/mod.rs"]
mod oracles;
mod torsion_waves;
