//! A drillstring that lies in its hole, at rest or in steady sliding rotation: what it lies on, how
//! it bends, and how that stresses it.
//!
//! The hole is inclined or curved, and so wide that the string touches it at a few places, the
//! contacts: blades, the ends of collars, tool joints. SI units; distances are from the bit,
//! displacements from the middle of the hole, along h (to the high side at the bit) and r (to the right
//! there, looking down), carried along the hole without twist.
//!
//! | what | where |
//! |---|---|
//! | the axis of the hole and the axes across it | [`Course`], `course.rs` |
//! | the string as elements, its loads and couples | `beam.rs` |
//! | contact, rigid and Hertzian, with and without sliding friction | [`Contact`], `equilibrium.rs`, `wall.rs` |
//! | static states | [`LyingString`], [`StaticState`] |
//! | stress | [`linear::Stress`] |
//! | equations of a single span and of a straight string, to compare with | [`closed_forms`] |
//!
//! What is left out: torque in bending (some newtons), friction along the hole, friction of a
//! string that does not turn (which has many states), shapes after buckling between contacts.
//!
//! ```
//! use linear::{Drillstring, Material, Section, Tube};
//! use statics::{Conditions, Contact, Course, LyingString};
//!
//! let steel = Material { shear_modulus: 80e9, density: 7850.0 };
//! let collar = Tube { length: 10.0, inner_radius: 0.0357, outer_radius: 0.1016 };
//! let string = Drillstring::new(steel, vec![Section { repeat: 30, parts: vec![collar] }], 0.0)?;
//! let at = |distance_from_bit: f64, clearance: f64| Contact {
//!     distance_from_bit,
//!     clearance,
//!     radius: 0.15,
//!     stiffness: Some(1e9),
//! };
//! // A bit, a stabiliser, and collars that may touch every ten metres.
//! let mut contacts = vec![at(0.0, 1.6e-3), at(18.0, 1.6e-3)];
//! contacts.extend((3..20).map(|it| at(10.0 * f64::from(it), 0.05)));
//! let inclined = Course::Straight { inclination: 1.0 };
//! let conditions = Conditions { weight_on_bit: 80e3, ..Conditions::new(206e9, inclined) };
//! let string = LyingString::new(&string, &conditions, &contacts)?;
//! let at_rest = string.at_rest()?;
//! assert!(at_rest.is_stable());
//! // It turns: friction carries it up the right side of the hole.
//! let sliding = string.sliding(0.3)?;
//! let climb = sliding.contacts()[15].climb();
//! assert!((climb - 0.3_f64.atan()).abs() < 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod banded;
mod beam;
pub mod closed_forms;
mod conditions;
mod contact;
mod course;
mod equilibrium;
mod error;
mod lying;
mod snaking;
mod state;
mod wall;

pub use conditions::{Bit, Conditions, Top};
pub use contact::Contact;
pub use course::Course;
pub use error::StaticsError;
pub use lying::LyingString;
pub use snaking::{Leaving, LeavingWay};
pub use state::{ContactState, Place, StaticState};
