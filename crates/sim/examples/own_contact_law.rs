//! A user-defined contact law: a bit with dry and viscous friction.
//! `cargo run --release -p drillstring-sim --example own_contact_law`

use linear::{ChannelRequest, Drillstring, Material, Method, Request, Section, Sites, Tube};
use sim::{LoadLine, Scene, Stepper, System, Timing, Wall};

/// The torque that holds the bit, N m, or beyond 1000 N m slows it.
fn torque(line: LoadLine) -> f64 {
    let (dry, viscous) = (1000.0, 200.0); // N m; N m s/rad
    let beyond = line.free_speed.abs() / line.compliance - dry;
    let speed = beyond.max(0.0) / (1.0 / line.compliance + viscous);
    -line.free_speed.signum() * (dry + beyond.min(0.0) + viscous * speed)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let steel = Material {
        shear_modulus: 80e9,
        density: 7850.0,
    };
    let parts = vec![Tube {
        length: 10.0,
        inner_radius: 0.05,
        outer_radius: 0.1,
    }];
    let string = Drillstring::new(steel, vec![Section { repeat: 50, parts }], 1.0)?;
    let request = Request {
        sites: Sites::bit(),
        channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
        sampling_frequency: 640.0,
        longest_time: 10.0,
    };
    let system = System::new(&linear::responses(&string, &Method::Quadrature, &request)?)?;
    let scene: Scene<_, Wall> = Scene {
        start: sim::Start::Rest,
        surface_speed: 2.0,
        bit: Some(torque),
        friction: Vec::new(),
        axial: None,
        lateral: None,
        timing: Timing {
            duration: 10.0,
            closing_window: 2.0,
        },
    };
    let mut stepper = Stepper::new(&system, &scene)?;
    while let Some(step) = stepper.step()? {
        if step.time.fract() == 0.0 && step.time > 0.0 {
            println!("{:2} s  {:.4} rad/s", step.time, step.speeds[0]);
        }
    }
    Ok(())
}
