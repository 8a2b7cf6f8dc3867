//! Scenes of a bit that cuts, and its steps.

use std::f64::consts::TAU;

use linear::{
    Channel, ChannelRequest, ChannelResponses, GrowingTorque, Method, Request, Responses, Sites,
    SteadyMotion,
};
use problems::dashpots::{self, BelowDashpots};
use sim::laws::cutting::CutStep;
use sim::laws::rock::CuttingLaw;
use sim::{
    Axial, Blades, Cutting, FlatContact, Kick, MudMotor, Scene, SimulationError, Start, Stepper,
    SurfaceProfile, System, Timing,
};

/// A bit of four blades of a radius of 0.108 m, whose flats carry all they can at once.
pub fn bit(specific_energy: f64, wear_flat: f64) -> Cutting {
    Cutting {
        rock: CuttingLaw {
            bit_radius: 0.108,
            specific_energy,
            cutting_ratio: 0.6,
            friction: 0.6,
            contact_strength: 60e6,
            contact_growth: 1.0,
            wear_flat,
            poor_cleaning: None,
        },
        contact: FlatContact::AtOnce,
        blades: Blades::Even(4),
        relief: f64::INFINITY,
    }
}

/// A bit of one blade that meets itself after a turn, of a radius of one; its flats carry all they can
/// at once.
pub fn one_blade(specific_energy: f64, [cutting_ratio, friction]: [f64; 2], flats: f64) -> Cutting {
    Cutting {
        rock: CuttingLaw {
            bit_radius: 1.0,
            specific_energy,
            cutting_ratio,
            friction,
            contact_strength: flats,
            contact_growth: 1.0,
            wear_flat: 1.0,
            poor_cleaning: None,
        },
        contact: FlatContact::AtOnce,
        blades: Blades::Even(1),
        relief: f64::INFINITY,
    }
}

/// Responses of the bit of a string in torsion and along the axis, for cases of a duration in steps
/// of a time, s.
pub fn responses(below: &BelowDashpots, method: &Method, [step, duration]: [f64; 2]) -> Responses {
    let request = Request {
        sites: Sites::bit(),
        channels: vec![
            ChannelRequest::Torsion { torques: vec![0] },
            ChannelRequest::Axial {
                rod: Box::new(below.rod.clone()),
                forces: vec![0],
            },
        ],
        sampling_frequency: 1.0 / step,
        longest_time: duration,
    };
    linear::responses(&below.string, method, &request).unwrap()
}

/// Responses of given speeds after a load of a step, in steps of a time, s.
pub fn given([torsion, axial]: [Vec<f64>; 2], step: f64) -> Responses {
    let count = torsion.len();
    let mut surface = vec![0.0; count];
    surface[0] = 1.0;
    let channel = |channel, taps: Vec<f64>| ChannelResponses {
        channel,
        loads: vec![0],
        from_surface: vec![surface.clone()],
        from_loads: vec![vec![taps]],
        ending: linear::passivity::Ending::Ringing,
    };
    let below = BelowDashpots::new(&[dashpots::pipe(2000.0)], [0.7; 2]);
    Responses {
        string: below.string.id(),
        method: Method::Held,
        sites: Sites::bit(),
        sampling_frequency: 1.0 / step,
        longest_time: (count as f64 - 1.0) * step,
        channels: vec![
            channel(Channel::Torsion, torsion),
            channel(Channel::Axial, axial),
        ],
    }
}

/// Of a tube whose upper end sends back a part −η of a wave that takes a number of steps there and back:
/// speeds after a load, of a compliance.
pub fn ringing(compliance: f64, round_trip: f64, sent_back: f64, count: usize) -> Vec<f64> {
    let mut taps = vec![0.0; count];
    taps[0] = compliance;
    let mut echo = 2.0 * compliance;
    let trips = (1..).map(|trip| (f64::from(trip) * round_trip).round() as usize);
    for at in trips.take_while(|at| *at < count) {
        echo *= -sent_back;
        taps[at] = echo;
    }
    taps
}

/// Of a string so heavy that no torque changes its speed.
pub fn immovable(count: usize) -> Vec<f64> {
    let mut taps = vec![0.0; count];
    taps[0] = 1e-12;
    taps
}

/// A case of a bit that cuts.
pub struct Drilling {
    system: System,
    scene: Scene,
}

impl Drilling {
    /// It drills steadily at a speed (rad/s) and a rate (m/s), kicked.
    pub fn steadily(
        responses: &Responses,
        cutting: &Cutting,
        [speed, rate]: [f64; 2],
        kick: Kick,
    ) -> Self {
        let advance = rate / speed * TAU / cutting.blades() as f64;
        let [torque, _] = cutting.steady(advance);
        let steady = |torque: f64| GrowingTorque { torque, rate: 0.0 };
        let start = Start::Steady(SteadyMotion {
            speeds: vec![speed],
            at_bit: steady(-torque),
            at_surface: steady(torque),
        });
        let axial = Axial {
            cutting: cutting.clone(),
            feed: rate,
            start_rate: rate,
            kick: Some(kick),
        };
        Self::new(responses, 0.0, (speed, start, axial))
    }

    /// The same bit, steadily drilling below a motor that turns it against the string.
    pub fn above_motor(mut self, motor: MudMotor) -> Self {
        self.system = self.system.above_motor(motor).unwrap();
        if let Start::Steady(motion) = &mut self.scene.start {
            let faster = motor.relative_speed(-motion.at_bit.torque);
            motion.speeds[0] -= faster;
            self.scene.surface_speed -= faster;
        }
        self
    }

    /// It begins at rest; the surface turns at a speed (rad/s) and is let down at a feed (m/s), both
    /// reached in a time, s.
    pub fn from_rest(
        responses: &Responses,
        cutting: &Cutting,
        rise: f64,
        [speed, feed]: [f64; 2],
    ) -> Self {
        let axial = Axial {
            cutting: cutting.clone(),
            feed,
            start_rate: 0.0,
            kick: None,
        };
        Self::new(responses, rise, (speed, Start::Rest, axial))
    }

    fn new(responses: &Responses, rise: f64, (speed, start, axial): (f64, Start, Axial)) -> Self {
        let profile = SurfaceProfile::Rise(rise);
        let system = System::started(responses, &profile).unwrap();
        Self {
            system: system.moving_along(responses, &profile).unwrap(),
            scene: Scene {
                surface_speed: speed,
                start,
                bit: None,
                friction: Vec::new(),
                axial: Some(axial),
                lateral: None,
                timing: Timing {
                    duration: responses.longest_time,
                    closing_window: 0.5 * responses.longest_time,
                },
            },
        }
    }

    /// What the bit does in every step.
    pub fn steps(&self) -> Vec<CutStep> {
        self.try_steps().unwrap()
    }

    /// The same, or what ends it.
    pub fn try_steps(&self) -> Result<Vec<CutStep>, SimulationError> {
        let mut stepper = Stepper::new(&self.system, &self.scene)?;
        let mut steps = Vec::new();
        while let Some(now) = stepper.step()? {
            steps.push(now.cut.unwrap());
        }
        Ok(steps)
    }
}

pub fn mean(steps: &[CutStep], of: impl Fn(&CutStep) -> f64) -> f64 {
    steps.iter().map(of).sum::<f64>() / steps.len() as f64
}

pub fn most(steps: &[CutStep], of: impl Fn(&CutStep) -> f64) -> f64 {
    steps.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

/// The part of steps of which something holds.
pub fn part(steps: &[CutStep], of: impl Fn(&CutStep) -> bool) -> f64 {
    mean(steps, |step| f64::from(u8::from(of(step))))
}

pub fn assert_part(what: &str, found: f64, expected: f64, part: f64) {
    assert!(
        (found / expected - 1.0).abs() < part,
        "{what}: {found} {expected}"
    );
}
