//! Strings with known answers, for the tests and benchmarks of the other crates.

pub mod academic;
pub mod dashpots;
pub mod delay_lines;
pub mod field_assembly;
pub mod masses;
pub mod methods;
pub mod oracles;
pub mod pipes;
pub mod plain_lattice;
pub mod wells;
pub mod whirling_collar;
