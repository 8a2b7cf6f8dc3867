//! What the loss of a string makes of its tubes, at one frequency or several side by side.

use std::cell::RefCell;

use num_complex::Complex64;

use super::number::Number;
use crate::drillstring::Tube;
use crate::loss::Loss;
use crate::loss::mud::Annulus;

/// Radii of a tube and of the hole around it, m.
type Radii = [f64; 3];

/// A string's loss at the Laplace variable s. What mud does to a tube is found once for all
/// tubes that are alike: the exact flow takes more time than the waves along a tube.
#[derive(Debug)]
pub struct Lossy<'a, T> {
    loss: &'a Loss,
    /// Unless nothing depends on it.
    s: Option<T>,
    /// Torques per length and speed that are known.
    turning: Known<T>,
    /// And forces.
    moving: Known<T>,
}

/// What is known of tubes of some radii.
type Known<T> = RefCell<Vec<(Radii, T)>>;

impl<'a, T: Number> Lossy<'a, T> {
    /// At `s`, rad/s, which is asked for only where the loss depends on it.
    pub fn new(loss: &'a Loss, s: impl FnOnce() -> T) -> Self {
        Self {
            loss,
            s: loss.has_memory().then(s),
            turning: RefCell::default(),
            moving: RefCell::default(),
        }
    }

    /// Torque per length and speed by which mud holds back a tube that turns in a hole of a radius
    /// (m), N m s/rad per m; `None` where there is no viscous mud.
    pub fn mud_against_turning(&self, tube: &Tube, hole: Option<f64>) -> Option<T> {
        self.mud(tube, hole, &self.turning, Annulus::against_turning)
    }

    /// Force per length and speed by which mud holds back a tube that moves across a hole of a
    /// radius (m), its inertia included, N s/m per m; `None` where there is no viscous mud.
    pub fn mud_against_moving(&self, tube: &Tube, hole: Option<f64>) -> Option<T> {
        self.mud(tube, hole, &self.moving, Annulus::against_moving)
    }

    fn mud(
        &self,
        tube: &Tube,
        hole: Option<f64>,
        known: &Known<T>,
        drag: impl Fn(&Annulus, Complex64) -> Complex64,
    ) -> Option<T> {
        let s = self.s?;
        let annulus = (self.loss).annulus([tube.inner_radius, tube.outer_radius], hole)?;
        let radii = [annulus.inner, annulus.outer, annulus.hole];
        let before = known.borrow().iter().find(|it| it.0 == radii).copied();
        if let Some((_, drag)) = before {
            return Some(drag);
        }
        let drag = s.each(|s| drag(&annulus, s));
        known.borrow_mut().push((radii, drag));
        Some(drag)
    }

    /// What the moduli are multiplied by; `None` where the material has no loss.
    pub fn stiffening(&self) -> Option<T> {
        let s = self.s.filter(|_| !self.loss.relaxations().is_empty())?;
        Some(s.each(|s| self.loss.stiffening(s)))
    }
}
