//! The plainest string: a row of equal pipes of ten metres.

use linear::{Drillstring, Material, Section, Tube};

/// What they are made of.
pub const STEEL: Material = Material {
    shear_modulus: 80e9,
    density: 7840.0,
};

/// One of them, of any length (m).
pub fn pipe(length: f64) -> Tube {
    Tube {
        length,
        inner_radius: 0.05,
        outer_radius: 0.1,
    }
}

/// A number of them, with a distributed damping (N m s/rad per metre).
pub fn row(pipes: usize, torsional_damping: f64) -> Drillstring {
    let section = Section {
        repeat: pipes,
        parts: vec![pipe(10.0)],
    };
    Drillstring::new(STEEL, vec![section], torsional_damping).expect("a row of pipes is a string")
}
