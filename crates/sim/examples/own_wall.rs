//! A user-defined wall: rubber, a linear spring with a damper and no friction, around a
//! site that an impulse sends against it. `cargo run --release -p drillstring-sim --example own_wall`

use linear::{
    Bending, ChannelRequest, Drillstring, Material, Method, Request, Section, Sites,
    SurfaceSupport, Tube,
};
use sim::laws::contact::{Approach, Contact, ContactError, Touch};
use sim::{BitTorque, Impulse, Lateral, Scene, Stepper, System, Timing, WallLaw};

struct Rubber {
    clearance: f64, // m
    stiffness: f64, // N/m
    damping: f64,   // N s/m
}

impl WallLaw for Rubber {
    fn clearance(&self) -> f64 {
        self.clearance
    }

    fn radius(&self) -> f64 {
        0.1
    }

    /// The wall pushes along the free position p_h; the load line leaves the radius
    /// |p_h| − h₀F, which F = k (r − c) + d (r − r_before) f_s must meet.
    fn meet(&self, approach: &Approach) -> Result<Contact, ContactError> {
        let [x, y] = approach.free_position;
        let [distance, before] =
            [approach.free_position, approach.previous_position].map(|[x, y]: [f64; 2]| x.hypot(y));
        if distance <= self.clearance {
            return Contact::free(approach.free_position);
        }
        let damping = self.damping * approach.sampling.rate_in_step();
        let push = self.stiffness * (distance - self.clearance) + damping * (distance - before);
        let force = (push / (1.0 + approach.compliance * (self.stiffness + damping))).max(0.0);
        let radius = distance - approach.compliance * force;
        if !radius.is_finite() {
            return Err(ContactError::NotFinite);
        }
        let along = |size: f64| [x / distance * size, y / distance * size];
        Ok(Contact {
            touch: Touch::Sliding,
            position: along(radius),
            force: along(-force),
            normal_force: force,
            ..Contact::NONE
        })
    }
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
    let bending = Bending {
        youngs_modulus: 210e9,
        damping: 2000.0,
        compression: 0.0,
    };
    let request = Request {
        sites: Sites::bit(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Bending {
                bending,
                support: SurfaceSupport::Free,
            },
        ],
        sampling_frequency: 640.0,
        longest_time: 3.0,
    };
    let system = System::new(&linear::responses(&string, &Method::Quadrature, &request)?)?;
    let rubber = Rubber {
        clearance: 0.015,
        stiffness: 1e7,
        damping: 1e4,
    };
    let impulse = Impulse {
        site: 0,
        amount: 1000.0,
        start: 1.0,
        duration: 0.02,
        direction: 0.0,
    };
    let scene: Scene<BitTorque, _> = Scene {
        start: sim::Start::Rest,
        surface_speed: 6.0,
        bit: None,
        friction: Vec::new(),
        axial: None,
        lateral: Some(Lateral {
            walls: vec![rubber],
            impulses: vec![impulse],
            eccentric_masses: Vec::new(),
            lying: None,
            shocks: None,
        }),
        timing: Timing {
            duration: 3.0,
            closing_window: 1.0,
        },
    };
    let mut stepper = Stepper::new(&system, &scene)?;
    let (mut touches, mut hardest) = (0, 0.0f64);
    while let Some(step) = stepper.step()? {
        let contact = &step.contacts[0];
        touches += usize::from(contact.touches());
        hardest = hardest.max(contact.normal_force);
    }
    println!("{touches} steps in contact, {hardest:.0} N at most");
    Ok(())
}
