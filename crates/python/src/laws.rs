//! Laws of the bit and of the wall: built in, or a function of Python that is called in every
//! step.

use std::cell::RefCell;

use pyo3::prelude::*;
use sim::laws::bit::BitMotion;
use sim::laws::contact::{self, Contact, ContactError, Touch};
use sim::laws::torque::TorqueStep;
use sim::{LoadLine, SceneError, TorqueLaw, WallLaw};

use crate::convert;
use crate::errors::refused;

/// What a law of Python raised: it is asked nothing more, and the motion ends.
pub type Raised = RefCell<Option<PyErr>>;

/// A law of the bit.
pub enum Bit<'a, 'py> {
    /// That of the paper.
    BuiltIn(sim::BitTorque),
    /// A function from time (s), free speed (rad/s) and compliance (rad/s per N m) to the torque.
    Own(Bound<'py, PyAny>, &'a Raised),
}

/// A law of the wall at a site.
pub enum Wall<'a, 'py> {
    /// That of the paper.
    BuiltIn(sim::Wall),
    /// An object with a clearance, a radius and what it answers to an approach.
    Own {
        /// Its method `force`.
        force: Bound<'py, PyAny>,
        /// Clearance, m.
        clearance: f64,
        /// Radius of the string, m.
        radius: f64,
        /// What it raised.
        raised: &'a Raised,
    },
}

/// Calls a law, unless one has raised already: then there is no answer.
fn ask<T>(raised: &Raised, call: impl FnOnce() -> PyResult<T>) -> Option<T> {
    if raised.borrow().is_some() {
        return None;
    }
    call().map_err(|error| raised.replace(Some(error))).ok()
}

impl<'a, 'py> Bit<'a, 'py> {
    /// A `BitTorque` or a function.
    ///
    /// # Errors
    /// Where it is neither.
    pub fn of(law: Bound<'py, PyAny>, raised: &'a Raised) -> PyResult<Self> {
        if law.is_callable() {
            return Ok(Bit::Own(law, raised));
        }
        Ok(Bit::BuiltIn(law.extract::<convert::BitTorque>()?.into()))
    }
}

impl TorqueLaw for Bit<'_, '_> {
    type State = BitMotion;

    fn meet(&self, before: &BitMotion, line: LoadLine) -> TorqueStep<BitMotion> {
        match self {
            Bit::BuiltIn(law) => law.meet(before, line),
            Bit::Own(law, raised) => {
                let arguments = (line.time, line.free_speed, line.compliance);
                let torque = ask(raised, || law.call1(arguments)?.extract::<f64>());
                let torque = torque.unwrap_or(f64::NAN);
                TorqueStep {
                    torque,
                    speed: line.free_speed + line.compliance * torque,
                    state: *before,
                }
            }
        }
    }

    fn largest_drop(&self) -> f64 {
        match self {
            Bit::BuiltIn(law) => law.largest_drop(),
            Bit::Own(..) => 0.0,
        }
    }

    fn check(&self) -> Result<(), SceneError> {
        match self {
            Bit::BuiltIn(law) => law.check(),
            Bit::Own(..) => Ok(()),
        }
    }
}

impl<'a, 'py> Wall<'a, 'py> {
    /// A `Wall`, or an object of one's own with a method `force`.
    ///
    /// # Errors
    /// Where it is neither.
    pub fn of(law: Bound<'py, PyAny>, raised: &'a Raised) -> PyResult<Self> {
        let Some(force) = law.getattr_opt("force")? else {
            return Ok(Wall::BuiltIn(law.extract::<convert::Wall>()?.into()));
        };
        let length = |name: &str| {
            let value: f64 = law.getattr(name)?.extract()?;
            match value.is_finite() && value >= 0.0 {
                true => Ok(value),
                false => Err(refused(format_args!(
                    "the {name} {value} of a wall is not zero or a positive number of metres"
                ))),
            }
        };
        Ok(Wall::Own {
            force,
            clearance: length("clearance")?,
            radius: length("radius")?,
            raised,
        })
    }
}

impl WallLaw for Wall<'_, '_> {
    fn clearance(&self) -> f64 {
        match self {
            Wall::BuiltIn(law) => law.clearance(),
            Wall::Own { clearance, .. } => *clearance,
        }
    }

    fn radius(&self) -> f64 {
        match self {
            Wall::BuiltIn(law) => law.radius(),
            Wall::Own { radius, .. } => *radius,
        }
    }

    fn meet(&self, approach: &contact::Approach) -> Result<Contact, ContactError> {
        let (force, raised) = match self {
            Wall::BuiltIn(law) => return law.meet(approach),
            Wall::Own { force, raised, .. } => (force, raised),
        };
        let answer = ask(raised, || {
            let answer = force.call1((Approach::of(approach),))?;
            answer.extract::<Option<(f64, f64, f64)>>()
        });
        match answer {
            None => Err(ContactError::NotFinite),
            Some(None) => Contact::free(approach.free_position),
            Some(Some((x, y, torque))) => {
                let contact = under([x, y], torque, approach);
                let numbers = [x, y, torque, contact.position[0], contact.position[1]];
                match numbers.iter().all(|number| number.is_finite()) {
                    true => Ok(contact),
                    false => Err(ContactError::NotFinite),
                }
            }
        }
    }

    fn check(&self) -> Result<(), SceneError> {
        match self {
            Wall::BuiltIn(law) => law.check(),
            // Checked when it was made.
            Wall::Own { .. } => Ok(()),
        }
    }
}

/// The contact in which a force (N) acts on the string, and its friction by a torque (N m): where
/// the load line then has the string, and what part of the force pushes it inwards.
fn under(force: [f64; 2], torque: f64, approach: &contact::Approach) -> Contact {
    let place = |axis: usize| approach.free_position[axis] + approach.compliance * force[axis];
    let position = [place(0), place(1)];
    let [x, y] = position;
    let radius = x.hypot(y);
    let normal_force = -(force[0] * x + force[1] * y) / radius;
    let along_wall = (force[1] * x - force[0] * y) / radius;
    Contact {
        touch: Touch::Sliding,
        position,
        force,
        normal_force,
        friction_ratio: along_wall / normal_force,
        torque,
        ..Contact::NONE
    }
}

/// What a step brings to a site, as a wall of one's own is told it.
#[pyclass(frozen, get_all, module = "drillstring")]
pub struct Approach {
    /// Position without contact, m.
    free_position: (f64, f64),
    /// Position at the end of the step before, m.
    previous_position: (f64, f64),
    /// Displacement per force within the step, m/N.
    compliance: f64,
    /// Rotation speed without contact, rad/s.
    free_speed: f64,
    /// Rotation speed per torque within the step, rad/s per N m.
    spin_compliance: f64,
    /// Velocity per distance from the previous position, 1/s.
    rate: f64,
}

impl Approach {
    fn of(approach: &contact::Approach) -> Self {
        Self {
            free_position: approach.free_position.into(),
            previous_position: approach.previous_position.into(),
            compliance: approach.compliance,
            free_speed: approach.spin.free_speed,
            spin_compliance: approach.spin.compliance,
            rate: approach.sampling.rate_in_step(),
        }
    }
}
