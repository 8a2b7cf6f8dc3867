//! Walls that give way, and what descends in energy between them.
//!
//! A Hertzian wall is begun from the rigid one, pressed in by as much as its forces ask for;
//! Newton steps are halved until energy falls (with friction, what is out of balance). Where the
//! string would buckle, a Newton step may lead uphill: its tangent is then stiffened until it has
//! no negative pivot (J. Nocedal and S. J. Wright, *Numerical Optimization*, 2006, section 3.4), so
//! that what is found is where energy is least around it.

use super::{Equilibrium, Touch};
use crate::beam::FREEDOMS;
use crate::wall::hertzian;

/// The stiffness of soft walls that take the place of rigid ones, and that to which it grows,
/// N/m^1.5.
const STIFFNESSES: (f64, f64) = (1e6, 1e14);
const STIFFER: f64 = 100.0;

/// Of a stiffness that elements have at an unknown, what a tangent is first stiffened by where it
/// has negative pivots, and by how many times more until it has none.
const FIRST_STIFFENING: f64 = 1e-10;
const MORE_STIFFENING: f64 = 10.0;

impl Equilibrium<'_> {
    /// By soft walls that are made ever stiffer; whether it is found.
    pub(super) fn settle_by_soft_walls(&mut self) -> bool {
        let (softest, stiffest) = STIFFNESSES;
        let mut stiffness = softest;
        while stiffness <= stiffest {
            for contact in 0..self.contacts.len() {
                self.soften_wall(contact, stiffness);
            }
            if !self.settle(true) {
                return false;
            }
            stiffness *= STIFFER;
        }
        self.harden_walls();
        self.settle(false)
    }

    /// Gives the wall at a contact a stiffness (N/m^1.5), pressed in by as much as its force asks for.
    pub(super) fn soften_wall(&mut self, contact: usize, stiffness: f64) {
        let clearance = self.contacts[contact].clearance;
        let (outwards, normal) = match self.touches[contact] {
            Touch::Held => return,
            Touch::Off => ([0.0; 2], 0.0),
            Touch::On { outwards, normal } => (outwards, normal),
            Touch::Hertzian(before) => {
                let wall = hertzian(clearance, before, self.place(contact));
                (wall.outwards, wall.normal)
            }
        };
        if normal > 0.0 {
            let pressed_in = libm::cbrt((normal / stiffness).powi(2));
            self.set_place(contact, outwards.map(|it| (clearance + pressed_in) * it));
        }
        self.touches[contact] = Touch::Hertzian(stiffness);
    }

    /// Puts the string on what it touches of Hertzian walls, as if they were rigid.
    fn harden_walls(&mut self) {
        for contact in 0..self.contacts.len() {
            if let Touch::Hertzian(stiffness) = self.touches[contact] {
                let clearance = self.contacts[contact].clearance;
                let wall = hertzian(clearance, stiffness, self.place(contact));
                let (outwards, normal) = (wall.outwards, wall.normal);
                self.touches[contact] = match normal > 0.0 {
                    true => Touch::On { outwards, normal },
                    false => Touch::Off,
                };
                self.put_on_wall(contact);
            }
        }
    }

    /// A step downhill in energy, without friction, by a tangent that is stiffened by as much as
    /// it needs; by how much is kept for the next step.
    pub(super) fn step_downhill(&self, stiffened: &mut [f64; 2]) -> Vec<f64> {
        for part in stiffened.iter_mut() {
            *part /= MORE_STIFFENING;
            if *part < FIRST_STIFFENING {
                *part = 0.0;
            }
        }
        loop {
            let (step, negative) = self.step(*stiffened);
            if !self.has_energy() || negative == [0, 0] {
                return step;
            }
            for (part, negative) in stiffened.iter_mut().zip(negative) {
                if negative > 0 {
                    *part = (*part * MORE_STIFFENING).max(FIRST_STIFFENING);
                }
            }
        }
    }

    /// Whether equilibrium is where an energy is least: friction has none.
    pub(super) fn has_energy(&self) -> bool {
        self.frictions.iter().all(|it| *it == 0.0)
    }

    /// What equilibrium makes least: without friction the energy, J; with it, what is out of
    /// balance, N.
    pub(super) fn merit(&self) -> f64 {
        match self.has_energy() {
            true => self.energy(),
            false => self.out_of_balance(),
        }
    }

    /// Energy of bending and of what lies along the string, and of Hertzian walls, J.
    fn energy(&self) -> f64 {
        let mut energy = 0.0;
        for (upper, element) in self.beam.elements.iter().enumerate() {
            let stiffness = element.stiffness(self.weight_on_bit);
            for plane in 0..2 {
                let loads = element.nodal_loads(plane, self.weight_on_bit);
                let moved =
                    |it: usize| self.moved[FREEDOMS * (upper + it / 2) + 2 * plane + it % 2];
                for row in 0..4 {
                    let force: f64 = (0..4).map(|it| stiffness[row][it] * moved(it)).sum();
                    energy += moved(row) * (0.5 * force - loads[row]);
                }
            }
        }
        let walls = (0..self.contacts.len()).map(|contact| match self.touches[contact] {
            Touch::Hertzian(stiffness) => {
                let wall = hertzian(
                    self.contacts[contact].clearance,
                    stiffness,
                    self.place(contact),
                );
                0.4 * wall.normal * wall.pressed_in
            }
            _ => 0.0,
        });
        energy + walls.sum::<f64>()
    }
}
