//! A string of one's own: how stiff it is, and what its bit does after a step of
//! torque, by two methods. `cargo run --release -p linear --example own_string`

use linear::{Drillstring, Material, Method, Section, Sites, TorsionRequest, Tube, estimates};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let tube = |[length, inner_radius, outer_radius]: [f64; 3]| Tube {
        length,
        inner_radius,
        outer_radius,
    };
    let cells = |repeat, tubes: &[[f64; 3]]| Section {
        repeat,
        parts: tubes.iter().copied().map(tube).collect(),
    };
    let steel = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };
    let drillpipe = cells(200, &[[9.05, 0.0543, 0.0635], [0.45, 0.0476, 0.0841]]);
    let collars = cells(20, &[[9.5, 0.0357, 0.1016]]);
    let string = Drillstring::new(steel, vec![drillpipe, collars], 0.1)?;
    let request = TorsionRequest {
        sites: Sites::bit(),
        torque_inputs: vec![0],
        sampling_frequency: estimates::sampling_frequency(&string),
        longest_time: 30.0,
    };
    let stiffness = estimates::torsional_stiffness(&string);
    println!("{stiffness:.1} N m/rad between surface and bit");
    for method in [Method::Quadrature, Method::Hilbert(Default::default())] {
        let responses = linear::torsion_responses(&string, &method, &request)?;
        let undershoot = estimates::largest_undershoot(&responses.from_torque[0][0]);
        let (name, taps) = (method.name(), responses.taps());
        println!("{name}: {taps} taps, undershoot {undershoot:.3e} rad/s per N m");
    }
    Ok(())
}
