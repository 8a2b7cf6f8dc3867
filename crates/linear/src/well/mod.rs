//! The well that the string lies in: its course, how the string presses on its wall, and what
//! pulls it along.
//!
//! In a straight inclined well the wall bears the weight across it, and the hook what pulls along:
//!
//! ```
//! use linear::well::{PressedBy, SideForce, Station, Survey};
//! use linear::{Drillstring, Material, Section, Tube};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7840.0 };
//! let pipe = Tube { length: 10.0, inner_radius: 0.05, outer_radius: 0.06 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 100, parts: vec![pipe] }], 0.0)?;
//! let inclination = 60f64.to_radians();
//! let station = |measured_depth: f64| Station { measured_depth, inclination, azimuth: 0.0 };
//! let survey = Survey::new(vec![station(0.0), station(1500.0)])?;
//! let pressing = SideForce::new(&string, &survey, None, PressedBy::WeightAndTension);
//! let weight = 7840.0 * pipe.area() * 9.806_65 * 1000.0;
//! assert!((pressing.hook_load() / (weight * inclination.cos()) - 1.0).abs() < 1e-9);
//! // N m per coefficient of friction, at the radius of the pipe.
//! let torque: f64 = pressing.friction_torques(5, 1e5).iter().sum();
//! assert!((torque / (weight * inclination.sin() * 0.06) - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axial_force;
mod quasi_static_twist;
mod short_lengths;
mod side_force;
mod supports;
mod survey;

pub use axial_force::HangingString;
pub use quasi_static_twist::{QuasiStaticTwist, TooFine, least_pieces};
pub use side_force::{PressedBy, PressedLength, SideForce};
pub use survey::{Station, Survey, SurveyError};

/// Acceleration of gravity, m/s².
pub const GRAVITY: f64 = 9.806_65;
