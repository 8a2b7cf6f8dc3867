//! The user's own string: its stiffness, and the response of its bit to a step of torque, by two
//! methods. `cargo run --release -p drillstring-linear --example own_string`

use linear::{
    ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube, estimates,
};

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
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: estimates::sampling_frequency(&string),
        longest_time: 30.0,
    };
    let stiffness = estimates::torsional_stiffness(&string);
    println!("{stiffness:.1} N m/rad between surface and bit");
    for method in [Method::Quadrature, Method::Hilbert(Default::default())] {
        let responses = linear::responses(&string, &method, &request)?;
        let taps = responses
            .at_bit()
            .ok_or("a torque at the bit was asked for")?;
        let undershoot = estimates::largest_undershoot(taps);
        let (name, taps) = (method.name(), taps.len());
        println!("{name}: {taps} taps, undershoot {undershoot:.3e} rad/s per N m");
    }
    Ok(())
}
