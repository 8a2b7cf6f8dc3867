//! Laws of the bit and of the wall: built in, a table, or a function of Python that is called in
//! every step.

use std::cell::{Cell, RefCell};

use pyo3::prelude::*;
use sim::laws::contact::{self, Contact, ContactError, Touch};
use sim::laws::torque::TorqueStep;
use sim::{LoadLine, SceneError, TabulatedFriction, TorqueLaw, WallLaw};

use crate::convert;
use crate::errors::refused;
use crate::wait::call_python;

/// Times that laws are asked between two looks at signals.
const BETWEEN_LOOKS: usize = 4096;

/// What ends a motion: what a law of Python raised, or a signal. Laws are asked nothing more.
pub struct Interruption<'py> {
    py: Python<'py>,
    raised: RefCell<Option<PyErr>>,
    asked: Cell<usize>,
}

impl<'py> Interruption<'py> {
    /// None yet.
    pub fn none(py: Python<'py>) -> Self {
        Self {
            py,
            raised: RefCell::default(),
            asked: Cell::new(0),
        }
    }

    /// What was raised.
    pub fn take(&self) -> Option<PyErr> {
        self.raised.take()
    }

    /// Calls a law, unless something was raised already: then there is no answer.
    fn ask<T>(&self, call: impl FnOnce() -> PyResult<T>) -> Option<T> {
        if self.raised.borrow().is_some() {
            return None;
        }
        self.look();
        call_python(call)
            .map_err(|error| self.raised.replace(Some(error)))
            .ok()
    }

    /// Looks at signals now and then: Ctrl-C is not seen by laws that are not of Python.
    fn look(&self) {
        let asked = self.asked.get() + 1;
        self.asked.set(asked % BETWEEN_LOOKS);
        if asked == BETWEEN_LOOKS {
            if let Err(error) = self.py.check_signals() {
                self.raised.replace(Some(error));
            }
        }
    }

    /// Whether nothing was raised, so that a motion continues.
    fn is_none(&self) -> bool {
        self.look();
        self.raised.borrow().is_none()
    }
}

/// A law of the bit.
pub struct Bit<'a, 'py> {
    law: BitLaw<'py>,
    interruption: &'a Interruption<'py>,
}

enum BitLaw<'py> {
    /// That of the paper.
    BuiltIn(sim::BitTorque),
    /// Torque against speed as a table.
    Table(TabulatedFriction),
    /// A function from time (s), free speed (rad/s) and compliance (rad/s per N m) to the torque.
    Own(Bound<'py, PyAny>),
}

/// A law of the wall at a site.
pub struct Wall<'a, 'py> {
    law: ContactLaw<'py>,
    interruption: &'a Interruption<'py>,
}

enum ContactLaw<'py> {
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
    },
}

impl<'a, 'py> Bit<'a, 'py> {
    /// A `BitTorque`, a `TabulatedFriction` or a function.
    ///
    /// # Errors
    /// Where it is something else.
    pub fn of(law: Bound<'py, PyAny>, interruption: &'a Interruption<'py>) -> PyResult<Self> {
        let law = if law.is_callable() {
            BitLaw::Own(law)
        } else if law.hasattr("torques")? {
            BitLaw::Table(law.extract::<convert::TabulatedFriction>()?.resolve()?)
        } else {
            BitLaw::BuiltIn(law.extract::<convert::BitTorque>()?.into())
        };
        Ok(Self { law, interruption })
    }
}

/// The answer of a law that is asked nothing more.
const NO_ANSWER: TorqueStep<f64> = TorqueStep {
    torque: f64::NAN,
    speed: f64::NAN,
    state: f64::NAN,
};

impl TorqueLaw for Bit<'_, '_> {
    /// The speed, rad/s.
    type State = f64;

    fn meet(&self, before: &f64, line: LoadLine) -> TorqueStep<f64> {
        match &self.law {
            BitLaw::Own(law) => {
                let arguments = (line.time, line.free_speed, line.compliance);
                let call = || law.call1(arguments)?.extract::<f64>();
                let torque = self.interruption.ask(call).unwrap_or(f64::NAN);
                let speed = line.speed_under(torque);
                TorqueStep {
                    torque,
                    speed,
                    state: speed,
                }
            }
            _ if !self.interruption.is_none() => NO_ANSWER,
            BitLaw::Table(law) => law.meet(before, line),
            BitLaw::BuiltIn(law) => {
                let step = law.meet(&law.turning_at(*before), line);
                TorqueStep {
                    torque: step.torque,
                    speed: step.speed,
                    state: step.speed,
                }
            }
        }
    }

    fn turning_at(&self, speed: f64) -> f64 {
        speed
    }

    fn largest_drop(&self) -> f64 {
        match &self.law {
            BitLaw::BuiltIn(law) => law.largest_drop(),
            BitLaw::Table(law) => law.largest_drop(),
            BitLaw::Own(_) => 0.0,
        }
    }

    fn holds(&self) -> Option<f64> {
        match &self.law {
            BitLaw::BuiltIn(law) => law.holds(),
            BitLaw::Table(law) => law.holds(),
            BitLaw::Own(_) => None,
        }
    }

    fn is_constant_in_slip(&self) -> bool {
        match &self.law {
            BitLaw::BuiltIn(law) => law.is_constant_in_slip(),
            BitLaw::Table(law) => law.is_constant_in_slip(),
            BitLaw::Own(_) => false,
        }
    }

    fn is_autonomous(&self) -> bool {
        !matches!(self.law, BitLaw::Own(_))
    }

    fn check(&self) -> Result<(), SceneError> {
        match &self.law {
            BitLaw::BuiltIn(law) => law.check(),
            BitLaw::Table(law) => law.check(),
            BitLaw::Own(_) => Ok(()),
        }
    }
}

impl<'a, 'py> Wall<'a, 'py> {
    /// A `Wall`, or a user-defined object with a method `force`.
    ///
    /// # Errors
    /// Where it is neither.
    pub fn of(law: Bound<'py, PyAny>, interruption: &'a Interruption<'py>) -> PyResult<Self> {
        let Some(force) = law.getattr_opt("force")? else {
            let law = ContactLaw::BuiltIn(law.extract::<convert::BuiltInWall>()?.into());
            return Ok(Self { law, interruption });
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
        let law = ContactLaw::Own {
            force,
            clearance: length("clearance")?,
            radius: length("radius")?,
        };
        Ok(Self { law, interruption })
    }
}

impl WallLaw for Wall<'_, '_> {
    fn clearance(&self) -> f64 {
        match &self.law {
            ContactLaw::BuiltIn(law) => law.clearance(),
            ContactLaw::Own { clearance, .. } => *clearance,
        }
    }

    fn radius(&self) -> f64 {
        match &self.law {
            ContactLaw::BuiltIn(law) => law.radius(),
            ContactLaw::Own { radius, .. } => *radius,
        }
    }

    fn meet(&self, approach: &contact::Approach) -> Result<Contact, ContactError> {
        let force = match &self.law {
            ContactLaw::BuiltIn(_) if !self.interruption.is_none() => {
                return Err(ContactError::NotFinite);
            }
            ContactLaw::BuiltIn(law) => return law.meet(approach),
            ContactLaw::Own { force, .. } => force,
        };
        let answer = self.interruption.ask(|| {
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

    fn rolling_limit(&self) -> Option<f64> {
        match &self.law {
            ContactLaw::BuiltIn(law) => law.rolling_limit(),
            ContactLaw::Own { .. } => None,
        }
    }

    fn slides_evenly(&self) -> bool {
        match &self.law {
            ContactLaw::BuiltIn(law) => law.slides_evenly(),
            ContactLaw::Own { .. } => false,
        }
    }

    fn check(&self) -> Result<(), SceneError> {
        match &self.law {
            ContactLaw::BuiltIn(law) => law.check(),
            // Checked when it was made.
            ContactLaw::Own { .. } => Ok(()),
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

/// The approach of a site in a step, as a user-defined wall receives it.
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
