//! The linear part of a drillstring, computed once: discrete impulse responses
//! between the surface and the few sites where something nonlinear acts.
//!
//! After T. Butlin and R. S. Langley, *An efficient model of drillstring
//! dynamics*, Journal of Sound and Vibration (2015), whose equation numbers
//! are quoted throughout. SI units; ξ and depth run down from the surface;
//! rotations and external torques are positive in one and the same direction
//! at every node, so that every driving-point speed response is positive-real.
//!
//! ```text
//!              Drillstring, Sites                sections from the surface down
//!                │            │
//!        waves (exact,     elements (matrices,
//!        any complex s;    Newmark's scheme)
//!        or a lattice)        │
//!                │            │
//!   filters: held, hilbert,   │
//!   quadrature, direct-idft   │
//!                │            │
//!                └─────┬──────┘
//!        Responses, a block for each Channel     taps A(0), A(1), …: all that leaves
//!                      │
//!             passivity, estimates               what can be said before simulating
//! ```
//!
//! This crate knows nothing of contacts. The user's own string, in full:
//! `examples/own_string.rs`.
//!
//! | paper | here |
//! |---|---|
//! | Table 2, Fig. 5: the string, and its sites | [`drillstring`], [`Sites`] |
//! | Eqs. 1–3: waves in a tube | `waves/torsion.rs` |
//! | Eqs. 19–26: bending waves in a tube | `waves/bending.rs` |
//! | Eqs. 4–11, 25: the chain of sections | `assembly/chain.rs` |
//! | Eqs. 12–13, 41–48: surface and sites | `assembly/torsion.rs`, [`waves::network`] |
//! | the surface under a drive instead of a speed | [`TopDrive`] |
//! | sharp fronts: waves handed on from piece to piece | [`waves::lattice`] |
//! | Eqs. 50–58: bending at the sites | `assembly/bending.rs`, [`waves::lateral`] |
//! | Section 2.4: digital filters | [`filters`] |
//! | which method, and its parameters | [`method`] |
//! | where Eqs. 5–10 fail without their scaling | [`waves::transfer`] |
//! | Section 2.4, Fig. 3: stability in sticking | [`passivity`] |
//! | Section 3: finite elements, Newmark | [`elements`] |
//! | the same stepped, for many sites | [`stepped`] |
//! | the same by poles that all sites share | [`poles`] |
//! | what takes energy, at any complex frequency: damping, viscous mud, material | [`loss`] |
//! | Section 5.2.2: the band-limited impulse | [`pulse`] |
//! | Eqs. 72–75: estimates | [`estimates`] |
//! | steady rotation, and steady winding of a held bit | [`steady`] |
//! | steady rotation under a torque that falls with speed | [`falling_torque`] |
//! | transforms, for convolution with the taps | [`fft`] |
//! | memory, asked for before it is taken | [`budget`] |
//! | how far responses are from the exact ones | [`deviation`] |
//! | the string in pieces, for torques at many places | [`cascade`] |
//! | the well, how the string presses on its wall, and what pulls it | [`well`] |
//! | how fast bending decays at least | [`bending_decay`] |
//! | buckling, by finite elements | [`bending_modes`] |
//! | bending moments by forces, of any method | `responses/moments.rs` |
//! | stress in a tube | [`Stress`] |
//! | natural frequencies and mode shapes without damping | [`natural_frequencies`] |
//! | torsional modes with damping and drive | [`modes`] |
//! | all cores, or the only one of a browser's page | [`parallel`] |
//! | Eqs. 59–61: what a simulation needs | [`mod@responses`], by [`Channel`] and [`Port`] |
//!
//! ```
//! use linear::{Drillstring, Material, Method, Section, Sites, Tube};
//! use linear::{ChannelRequest, Request};
//!
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.1 };
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 50, parts: vec![pipe] }], 10.0)?;
//! let request = Request {
//!     sites: Sites::bit(),
//!     channels: vec![ChannelRequest::Torsion { torques: vec![0] }],
//!     sampling_frequency: linear::estimates::sampling_frequency(&string),
//!     longest_time: 20.0,
//! };
//! let responses = linear::responses(&string, &Method::Quadrature, &request)?;
//! let torsion = responses.torsion().ok_or("torsion was asked for")?;
//! // In the end the bit turns as fast as the surface.
//! let speed: f64 = torsion.from_surface[0].iter().sum();
//! assert!((speed - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(test)]
extern crate self as linear;

mod assembly;
pub mod axial;
mod bending;
pub mod bending_decay;
pub mod bending_modes;
pub mod budget;
pub mod cascade;
mod channel;
mod checks;
pub mod controllers;
mod derivative;
pub mod deviation;
mod distributed_loss;
pub mod drillstring;
pub mod drive_delay;
pub mod elements;
mod error;
pub mod estimates;
pub mod falling_torque;
pub mod filters;
mod in_mud;
pub mod loss;
pub mod method;
pub mod modes;
pub mod natural_frequencies;
pub mod parallel;
pub mod passivity;
pub mod poles;
pub mod pulse;
pub mod regenerative;
pub mod responses;
pub mod sampling;
mod sites;
mod spans;
pub mod steady;
pub mod stepped;
mod stress;
mod surroundings;
mod top_drive;
#[cfg(test)]
mod validation;
pub mod waves;
pub mod well;

pub use axial::{Axial, Hoist};
pub use bending::{Bending, SurfaceSupport};
pub use budget::Budget;
pub use cascade::{Cascade, CascadePlan};
pub use channel::{Channel, Port};
pub use drillstring::{Drillstring, Material, Section, StringId, Tube};
pub use error::{BuildError, DrillstringError, ResponseError};
pub use method::Method;
pub use num_complex::Complex64;
pub use numerics::fft;
pub use poles::{BendingPoles, PolePlan};
pub use pulse::RaisedCosine;
pub use responses::{
    ChannelRequest, ChannelResponses, DrivenSurface, DrivenSurfacePlan, Earlier, ImpulseTrains,
    IntegralRule, MarginPlan, PlacePlan, PlaceQuantity, PlaceResponses, Request, ResponsePlan,
    Responses, SurfaceTorquePlan, responses, surface_torque,
};
pub use sites::Sites;
pub use steady::{GrowingTorque, SteadyMotion};
pub use stepped::{SteppedPlan, SteppedString};
pub use stress::Stress;
pub use surroundings::{AxialForce, Hole, HoleSection, Mud};
pub use top_drive::TopDrive;
