//! The regimes of a user-defined friction law: torque against speed, with a valley between dry
//! friction that falls and viscous friction that rises.
//! `cargo run --release -p drillstring-sim --example own_regimes`

use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
use sim::{Scene, Simulator, Start, Stopping, TabulatedFriction, Timing, Wall};

/// Torque against a bit that turns at a speed (rad/s), N m.
fn torque(speed: f64) -> f64 {
    let (dry, more, decay_speed, viscous) = (3000.0, 900.0, 1.0, 60.0); // N m; rad/s; N m s/rad
    dry + more * (-speed / decay_speed).exp() + viscous * speed
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };
    let parts = vec![Tube {
        length: 10.0,
        inner_radius: 0.05,
        outer_radius: 0.0635,
    }];
    let string = Drillstring::new(steel, vec![Section { repeat: 100, parts }], 1.0)?;
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: 640.0,
        longest_time: 60.0,
    };
    let simulator = Simulator::new(&linear::responses(&string, &Method::Held, &request)?)?;
    let law = TabulatedFriction::sampled(torque, 40.0, 4000);
    for surface_speed in [1.0, 2.0, 4.0, 8.0] {
        let scene: Scene<_, Wall> = Scene {
            surface_speed,
            start: Start::Rest,
            bit: Some(law.clone()),
            friction: Vec::new(),
            axial: None,
            lateral: None,
            timing: Timing {
                duration: 60.0,
                closing_window: 15.0,
            },
        };
        let outcome = simulator.simulate_laws(&scene, Stopping::Early, None)?;
        if let Some(bit) = outcome.torsion() {
            let (label, sticks, time) = (bit.regime.name(), bit.sticks, outcome.simulated);
            println!("{surface_speed} rad/s: {label}, stuck {sticks} times in {time:.1} s");
        }
    }
    Ok(())
}
