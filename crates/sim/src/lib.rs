//! Time stepping of the few nonlinear sites of a drillstring against its
//! linear responses, each case ending in a regime.
//!
//! After T. Butlin and R. S. Langley, *An efficient model of drillstring
//! dynamics*, Journal of Sound and Vibration (2015). This crate sees taps, never how
//! they were made.
//!
//! ```text
//!   taps from `linear`          Scene: surface speed, bit, walls, impulses, time
//!          │                                      │
//!   System, LateralSystem                         │
//!   (once for all cases)                          │
//!          └──────────────────┬───────────────────┘
//!          every step:  history    what the past adds (Eq. 17): the load line
//!                       laws       meet it: rock, wall (Eqs. 18, 33–38)
//!                       regime, whirl, settling    watch; end when it is certain
//!                             │
//!             Outcome: regimes and measures;  Trajectory, where asked for
//! ```
//!
//! This crate knows nothing of files, threads or methods. A contact law of one's own
//! is a closure, given to [`bit_speeds`]: `examples/own_contact_law.rs`. A scene that
//! cannot be, one that does not fit its system, and a motion that leaves all numbers
//! are each a [`SimulationError`].
//!
//! | paper | here |
//! |---|---|
//! | Eqs. 16–17: load line and history | [`history`], [`stepper`] |
//! | Section 2.2.2, 5.2.1: torque at the bit | [`laws::bit`] |
//! | Section 4.1, Eqs. 33–38: the borehole wall | [`laws::wall`] |
//! | Section 4.2, Fig. 4: weight on bit to torque | [`laws::rock`] |
//! | Eqs. 14–18 for a torque law of one's own | [`own_law`] |
//! | Section 5.2.1: stick-slip or smooth | [`regime`] |
//! | Section 5.2.2: transient contact or whirl | [`whirl`], its bound in [`steady_whirl`] |
//! | Section 2.4: what a failing method shows | [`diagnosis`], [`oscillator`] |
//! | Eqs. 72–73: how long to simulate | [`duration`] |
//! | memory, before it is taken | [`cost`] |
//!
//! ```
//! use linear::{Drillstring, Material, Method, Section, Sites, TorsionRequest, Tube};
//! use sim::{BitTorque, Scene, System, TorsionRegime};
//!
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! let request = TorsionRequest {
//!     sites: Sites::bit(),
//!     torque_inputs: vec![0],
//!     sampling_frequency: 640.0,
//!     longest_time: 20.0,
//! };
//! let responses = linear::torsion_responses(&string, &Method::Quadrature, &request)?;
//! let system = System::new(&responses, 20.0)?;
//! let bit = BitTorque { torque_static: 1200.0, torque_dynamic: 1000.0 };
//! let scene = Scene {
//!     surface_speed: 0.5,
//!     bit: Some(bit),
//!     lateral: None,
//!     timing: sim::torsion_timing(&string, 0.5, &bit),
//! };
//! let outcome = sim::simulate(&system, &scene, sim::Stopping::Early, None)?;
//! assert_eq!(outcome.torsion.map(|torsion| torsion.regime), Some(TorsionRegime::Smooth));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cost;
pub mod diagnosis;
pub mod duration;
mod error;
pub mod excitation;
mod future;
mod held;
pub mod history;
pub mod lateral;
pub mod laws;
pub mod oscillator;
pub mod own_law;
pub mod regime;
pub mod scene;
pub mod settling;
pub mod steady_whirl;
pub mod stepper;
pub mod trajectory;
pub mod whirl;

pub use duration::{Timing, torsion_timing};
pub use error::SimulationError;
pub use excitation::{EccentricMass, Impulse};
pub use lateral::{LateralSystem, simulate_lateral};
pub use laws::bit::BitTorque;
pub use laws::rock::Rock;
pub use laws::wall::Wall;
pub use own_law::{LoadLine, bit_speeds};
pub use regime::{TorsionMeasures, TorsionRegime};
pub use scene::{Lateral, Scene, SceneError};
pub use settling::{Ended, Stopping};
pub use steady_whirl::{SteadyWhirl, WhirlingSite};
pub use stepper::{Outcome, System, simulate};
pub use trajectory::Trajectory;
pub use whirl::{LateralMeasures, LateralRegime};
