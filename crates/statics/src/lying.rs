//! A string that lies in its hole: from what it is made of to its static states.

use linear::Drillstring;

use crate::beam::Beam;
use crate::conditions::{Bit, Conditions, Top};
use crate::contact::Contact;
use crate::equilibrium::Equilibrium;
use crate::error::{StaticsError, finite, not_negative, positive};
use crate::state::StaticState;

/// Steps from no weight on bit to the whole, of a string that its contacts keep from buckling.
const STEPS_OF_WEIGHT: usize = 10;

/// The coefficient of friction grows by no more than this in a step.
const STEP_OF_FRICTION: f64 = 0.05;

/// A string with the places where it may touch its hole.
///
/// ```
/// use linear::{Drillstring, Material, Section, Tube};
/// use statics::{Bit, Conditions, Contact, Course, LyingString};
///
/// let steel = Material { shear_modulus: 80e9, density: 7850.0 };
/// let collar = Tube { length: 30.0, inner_radius: 0.0357, outer_radius: 0.1016 };
/// let string = Drillstring::new(steel, vec![Section { repeat: 1, parts: vec![collar] }], 0.0)?;
/// // Held in the middle at both ends, and touching nowhere: half of its weight at the bit.
/// let contact = Contact {
///     distance_from_bit: 15.0,
///     clearance: 5.0,
///     radius: 0.1016,
///     stiffness: None,
/// };
/// let course = Course::Straight { inclination: std::f64::consts::FRAC_PI_2 };
/// let conditions = Conditions { bit: Bit::Pinned, ..Conditions::new(206e9, course) };
/// let state = LyingString::new(&string, &conditions, &[contact])?.at_rest()?;
/// let weight = 7850.0 * collar.area() * 9.80665 * 30.0;
/// assert!((state.side_force_at_bit()[0] / (-0.5 * weight) - 1.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct LyingString {
    pub(crate) beam: Beam,
    /// From the surface down.
    contacts: Vec<Contact>,
    bit_is_pinned: bool,
    weight_on_bit: f64,
    torque: f64,
}

impl LyingString {
    /// A string under conditions, with its contacts in any order.
    ///
    /// # Errors
    /// Where a number is not that of a string in a hole, contacts are not on the string or too
    /// close to each other, or the survey ends above the bit.
    pub fn new(
        string: &Drillstring,
        conditions: &Conditions,
        contacts: &[Contact],
    ) -> Result<Self, StaticsError> {
        let length = string.length();
        positive("Young's modulus in Pa", conditions.youngs_modulus)?;
        finite("weight on bit in N", conditions.weight_on_bit)?;
        not_negative("a torque in N m", conditions.torque)?;
        if let Top::At(distance) | Top::OnWall(distance) = conditions.top {
            positive("the distance of a cut from the bit in m", distance)?;
        }
        if let Some(longest) = conditions.longest_element {
            positive("the length of elements in m", longest)?;
        }
        conditions.course.check(length)?;
        contacts.iter().try_for_each(|it| it.check(length))?;
        let mut contacts = contacts.to_vec();
        contacts.sort_by(|a, b| b.distance_from_bit.total_cmp(&a.distance_from_bit));
        if let Top::At(distance) | Top::OnWall(distance) = conditions.top {
            contacts.retain(|it| it.distance_from_bit < distance);
        }
        let touches_at_bit = contacts
            .last()
            .is_some_and(|it| it.distance_from_bit == 0.0);
        match conditions.bit {
            Bit::Contact if !touches_at_bit => return Err(StaticsError::NoContactAtBit),
            Bit::Free => contacts.retain(|it| it.distance_from_bit > 0.0),
            Bit::Pinned if !touches_at_bit => contacts.push(Contact {
                distance_from_bit: 0.0,
                clearance: 1.0,
                radius: 0.0,
                stiffness: None,
            }),
            Bit::Contact | Bit::Pinned => {}
        }
        if contacts.is_empty() {
            return Err(StaticsError::NoContacts);
        }
        Ok(Self {
            beam: Beam::new(string, conditions, &contacts)?,
            contacts,
            bit_is_pinned: conditions.bit == Bit::Pinned,
            weight_on_bit: conditions.weight_on_bit,
            torque: conditions.torque,
        })
    }

    /// Its contacts, from the surface down.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// The same string under another weight on bit (N).
    pub fn under(&self, weight_on_bit: f64) -> Self {
        Self {
            weight_on_bit,
            ..self.clone()
        }
    }

    /// Whether nothing but its contacts keeps it from buckling.
    pub fn buckles_without_contacts(&self) -> bool {
        let mut free = self.lying(self.weight_on_bit);
        free.let_go();
        free.negative_pivots() != [0, 0]
    }

    /// Whether it would buckle if it were held at all contacts: no spring there keeps it straight.
    pub fn buckles_between_contacts(&self) -> bool {
        let mut held = self.lying(self.weight_on_bit);
        held.hold_all();
        held.negative_pivots() != [0, 0]
    }

    /// The string without friction, as it lies at rest.
    ///
    /// There is one such state while the string does not [buckle without its
    /// contacts](Self::buckles_without_contacts). Beyond that there may be several, and this is
    /// the one that it has as weight on bit grows from zero;
    /// [`StaticState::is_stable`] says whether it stays there.
    ///
    /// # Errors
    /// Where the string buckles between its contacts, or no state is found.
    pub fn at_rest(&self) -> Result<StaticState, StaticsError> {
        let lying = self.resting()?;
        Ok(self.state(&lying))
    }

    /// The string in steady rotation, clockwise looking down, sliding on every contact with the
    /// same coefficient of friction; turning the other way round where that is negative. Each
    /// contact climbs by its own angle. It is followed from rest as friction grows; that it is
    /// the only state is not known.
    ///
    /// # Errors
    /// As [`Self::at_rest`], and where friction is not finite.
    pub fn sliding(&self, friction: f64) -> Result<StaticState, StaticsError> {
        self.sliding_with(&vec![friction; self.contacts.len()])
    }

    /// The same with a coefficient of friction for each contact, from the surface down.
    ///
    /// # Errors
    /// As [`Self::sliding`], and where there are not as many as contacts.
    pub fn sliding_with(&self, frictions: &[f64]) -> Result<StaticState, StaticsError> {
        let (given, contacts) = (frictions.len(), self.contacts.len());
        if given != contacts {
            return Err(StaticsError::OtherContacts { given, contacts });
        }
        let amounts = frictions.iter().map(|friction| friction.abs());
        let most = amounts.fold(0.0, f64::max);
        for friction in frictions {
            not_negative("the amount of a friction", friction.abs())?;
        }
        let mut lying = self.resting()?;
        let steps = (most / STEP_OF_FRICTION).ceil();
        for step in 1..=steps as usize {
            let part = step as f64 / steps;
            lying.frictions = frictions.iter().map(|friction| part * friction).collect();
            if !(lying.settle_rigid() && lying.settle_hertzian()) {
                return Err(self.not_found(part * most));
            }
        }
        Ok(self.state(&lying))
    }

    pub(crate) fn state(&self, lying: &Equilibrium) -> StaticState {
        StaticState::new(lying, &self.beam, &self.contacts, self.torque)
    }

    pub(crate) fn lying(&self, weight_on_bit: f64) -> Equilibrium<'_> {
        Equilibrium::on_all_contacts(
            &self.beam,
            &self.contacts,
            self.bit_is_pinned,
            weight_on_bit,
        )
    }

    fn resting(&self) -> Result<Equilibrium<'_>, StaticsError> {
        if self.buckles_between_contacts() {
            return Err(StaticsError::BucklesBetweenContacts {
                weight_on_bit: self.weight_on_bit,
            });
        }
        let steps = match self.buckles_without_contacts() {
            true => STEPS_OF_WEIGHT,
            false => 1,
        };
        let first = if steps == 1 { self.weight_on_bit } else { 0.0 };
        let mut lying = self.lying(first);
        let mut is_found = lying.settle_rigid();
        for step in 1..=steps {
            lying.weight_on_bit = self.weight_on_bit * step as f64 / steps as f64;
            is_found = lying.settle_rigid();
        }
        match is_found && lying.settle_hertzian() {
            true => Ok(lying),
            false => Err(self.not_found(0.0)),
        }
    }

    pub(crate) fn not_found(&self, friction: f64) -> StaticsError {
        StaticsError::NotFound {
            weight_on_bit: self.weight_on_bit,
            friction,
        }
    }
}
