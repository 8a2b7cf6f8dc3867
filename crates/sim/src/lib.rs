//! Time stepping of the few nonlinear sites of a drillstring against its
//! linear responses, each case ending in a regime.
//!
//! After T. Butlin and R. S. Langley, *An efficient model of drillstring
//! dynamics*, Journal of Sound and Vibration (2015). This crate sees a string as lines, one of
//! each motion: impulse responses (the paper's), elements, or pieces that hand on waves.
//!
//! ```text
//!   Responses, elements or pieces  Scene: surface speed, bit, friction, walls,
//!          from `linear`                  impulses, time
//!          │                                      │
//!       System, Simulator                         │
//!   (once for all cases)                          │
//!          └──────────────────┬───────────────────┘
//!   stepper, every step:  line         what the past adds (Eq. 17): the load lines
//!                         port         the laws of each port meet them: rock, pipe, wall
//!                         coupling     until all ports agree
//!   simulator:            shortcuts    what need not be stepped
//!                         watch        regimes; whether the rest is settled
//!                             │
//!             Outcome: regimes and measures;  Trajectory, where asked for
//! ```
//!
//! This crate knows nothing of files, threads or methods. A law of one's own goes through the
//! same steps ([`Stepper`]), and has regimes and ends early too ([`Simulator::simulate_laws`]):
//! `examples/own_contact_law.rs` has one for the bit, `examples/own_regimes.rs` its regimes,
//! `examples/own_wall.rs` one for the wall. A scene out of range, one that does
//! not fit its system, and a motion that leaves all numbers are each a
//! [`SimulationError`].
//!
//! | paper | here |
//! |---|---|
//! | Eqs. 16–17, 59–61: history and load lines | [`convolution`], [`stepper`] |
//! | the same by stepping elements, poles, or pieces | `line/`, [`linear::SteppedString`], [`linear::BendingPoles`], [`linear::Cascade`] |
//! | Eqs. 59–60 at all sites of a step at once | `coupling/` |
//! | a drive that gives no more than its greatest torque | `limited_drive`, [`LimitedDrive`] |
//! | friction along the string | [`laws::pipe`], [`Scene`] |
//! | Sections 2.2.2, 5.2.1: torque at the bit | [`laws::bit`], or as a table [`laws::table`] |
//! | Section 4.1, Eqs. 33–38: the borehole wall | [`laws::wall`] |
//! | Section 4.2, Fig. 4: weight on bit to torque | [`laws::rock`] |
//! | Section 5.2.1: stick-slip or smooth | [`watch::torsion`] |
//! | bending moments and displacements after a case, by its forces; stress | [`AtPlaces`], [`StressMeasures`] |
//! | Section 5.2.2: transient contact or whirl | [`watch::lateral`], its bound in [`steady_whirl`] |
//! | Section 5: what a case is, and what disturbs it | [`scene`], [`excitation`] |
//! | one case from rest to its label | [`simulator`], [`Outcome`], [`trajectory`] |
//! | Section 2.4: what a failing method shows | [`diagnosis`], [`oscillator`] |
//! | Eqs. 72–73: how long to simulate | [`timing`] |
//! | whether steady drilling lasts, in steps | [`SteppedLoop`] |
//! | exact waves, to hold all of these to | [`waveguide`] |
//! | every tolerance of regimes and of ending early | [`watch::rules`] |
//! | memory, asked for before it is taken | [`plan`] |
//!
//! ```
//! use linear::{Drillstring, Material, Method, Section, Sites, Tube};
//! use linear::{ChannelRequest, Request};
//! use sim::{BitTorque, Scene, Simulator, Start, TorsionRegime};
//!
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: 640.0,
//!     longest_time: 20.0,
//! };
//! let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! let simulator = Simulator::new(&responses)?;
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0, decay_speed: 0.0 };
//! let scene = Scene {
//!     surface_speed: 0.5,
//!     start: Start::Rest,
//!     bit: Some(bit),
//!     friction: Vec::new(),
//!     axial: None,
//!     lateral: None,
//!     timing: sim::torsion_timing(&string, 0.5, &bit, &Start::Rest),
//! };
//! let outcome = simulator.simulate(&scene, sim::Stopping::Early, None)?;
//! assert_eq!(outcome.torsion().map(|torsion| torsion.regime), Some(TorsionRegime::Smooth));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod at_places;
mod axial_motion;
pub mod convolution;
mod coupling;
pub mod diagnosis;
mod error;
pub mod excitation;
mod label;
mod lateral_motion;
pub mod laws;
mod limited_drive;
mod line;
mod lying;
mod motion;
pub mod oscillator;
mod outcome;
pub mod plan;
mod port;
mod ranges;
mod rates_at_places;
mod recording;
mod sampling;
pub mod scene;
mod shortcuts;
pub mod simulator;
mod start;
pub mod steady_whirl;
mod stepped_loop;
pub mod stepper;
mod surface;
mod surface_torque;
mod system;
pub mod timing;
pub mod trajectory;
pub mod watch;
pub mod waveguide;
mod wavering;
mod words;

pub use at_places::AtPlaces;
pub use error::SimulationError;
pub use excitation::{EccentricMass, Impulse};
pub use label::{Label, Labels};
pub use laws::bit::BitTorque;
pub use laws::contact::WallLaw;
pub use laws::cutting::{Blades, Cutting, FlatContact};
pub use laws::motor::MudMotor;
pub use laws::pipe::PipeFriction;
pub use laws::rock::Rock;
pub use laws::table::TabulatedFriction;
pub use laws::torque::{LoadLine, TorqueLaw};
pub use laws::wall::Wall;
pub use limited_drive::LimitedDrive;
pub use line::pieces::SurfaceStep;
pub use lying::Lying;
pub use motion::{Motion, PerMotion};
pub use outcome::{Ended, Measures, Outcome, Stopping};
pub use plan::SimulatorPlan;
pub use ranges::SceneError;
pub use rates_at_places::RatesAtPlaces;
pub use recording::{Recording, RecordingError};
pub use sampling::Sampling;
pub use scene::{Axial, Kick, Lateral, Scene, Timing};
pub use simulator::Simulator;
pub use start::Start;
pub use steady_whirl::{SitesWhirl, SteadyWhirl, WhirlingSite, WhirlingSites};
pub use stepped_loop::SteppedLoop;
pub use stepper::{Step, Stepper};
pub use surface::SurfaceProfile;
pub use surface_torque::SurfaceTorque;
pub use system::System;
pub use timing::torsion_timing;
pub use trajectory::Trajectory;
pub use watch::along::StringTorque;
pub use watch::axial::{AxialAcceleration, AxialMeasures, AxialRegime};
pub use watch::band::{InBand, USUAL_BAND, highest_band, steps_to_settle};
pub use watch::lateral::{LateralMeasures, LateralRegime, LyingMeasures, Push};
pub use watch::shocks::{ShakenPlace, ShockMeasures};
pub use watch::stress::{Peak, StressMeasures, StressedPlace};
pub use watch::surface::SurfaceMeasures;
pub use watch::torsion::{TorsionMeasures, TorsionRegime};
