//! A string that may touch at some contacts and is hit: does it whirl to the end?

use std::f64::consts::TAU;

use anyhow::{Result, bail};
use linear::Method;
use rayon::prelude::*;
use sim::{LateralRegime, SimulationError, Stopping, Trajectory};

use super::impulse::LateralImpulse;
use super::places::{index_of, with_others};
use super::search::{Least, scan};
use super::subject::{StudiedString, impulse_settings, impulse_start};
use campaign::engine::{Case, MethodSystem, Recipe};

/// Clearance of a place that is hit but is no contact, m: no string comes so far.
const OUT_OF_REACH: f64 = 1e6;

/// A whirl goes round this often in the closing window at least: one that slides ever more slowly
/// has its label until it all but stops ([`sim::watch::rules::Rules::least_turns`]).
const LEAST_TURNS: f64 = 1.0;

/// Whirl that lasts to the end of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whirl {
    /// Rate of precession of the contact that decides the label, turns a second, negative against
    /// the rotation.
    pub turns_per_s: f64,
    /// Which contact that is, m from the bit.
    pub from_bit: f64,
    /// The part of its contact in which it rolls.
    pub rolling_fraction: f64,
}

/// A string of the study with its contacts, ready to be hit.
pub struct Touching<'a> {
    subject: &'a StudiedString,
    system: MethodSystem,
    /// Of each site from the surface down, whether it is a contact.
    is_contact: Vec<bool>,
}

impl<'a> Touching<'a> {
    /// Builds a string with a number of contacts, with impulses at these places (m from the bit),
    /// by a method.
    ///
    /// # Errors
    /// Where the method cannot treat it.
    pub fn build(
        subject: &'a StudiedString,
        count: usize,
        hit: &[f64],
        method: Method,
    ) -> Result<Self> {
        let contacts = subject.range.even(count);
        let setting = subject.touching_at(&with_others(&contacts, hit))?;
        let distances = setting.sites.distances_from_bit().iter();
        let is_contact = distances.map(|place| index_of(&contacts, *place).is_some());
        let is_contact = is_contact.collect();
        let time = subject.duration(&setting)?;
        Ok(Self {
            system: Recipe::alone(&setting, method, subject.sweep.bit.is_some(), time).build()?,
            subject,
            is_contact,
        })
    }

    /// Sampling frequency, Hz.
    pub fn sampling_frequency(&self) -> f64 {
        self.system.setting.sampling_frequency
    }

    /// The case of an impulse at a friction.
    fn case(&self, impulse: &LateralImpulse, friction: f64) -> Result<Case> {
        let setting = &self.system.setting;
        let mut case = self.subject.case(setting, friction)?;
        let start = impulse_start(setting);
        let places = setting.sites.distances_from_bit();
        if let Some(lateral) = &mut case.scene.lateral {
            for (wall, is_contact) in lateral.walls.iter_mut().zip(&self.is_contact) {
                if !is_contact {
                    wall.clearance = OUT_OF_REACH;
                }
            }
            let by_place = impulse.by_place().into_iter();
            let at_sites = by_place.filter_map(|(place, amount)| {
                Some(impulse_settings(index_of(places, place)?, amount, start).with_amount(amount))
            });
            lateral.impulses = at_sites.collect();
        }
        Ok(case)
    }

    /// The whirl that lasts to the end after an impulse, if any does.
    fn whirl(&self, case: &Case) -> Result<Option<Whirl>, SimulationError> {
        let outcome = self.system.simulate(case, Stopping::Early, None)?;
        let window = case.scene.timing.closing_window;
        let places = self.system.setting.sites.distances_from_bit();
        let backward = outcome.lateral().filter(|it| {
            it.regime == LateralRegime::BackwardWhirl
                && -it.precession_rate * window >= LEAST_TURNS * TAU
        });
        Ok(backward.map(|it| Whirl {
            turns_per_s: it.precession_rate / TAU,
            from_bit: places[it.site],
            rolling_fraction: it.rolling_fraction,
        }))
    }

    /// The least friction at which whirl lasts after each impulse, all of them at once; `tick` is
    /// called after every simulation. An impulse has no answer where one of its cases failed, or
    /// the method chatters where a site sticks.
    pub fn limits(
        &self,
        impulses: &[LateralImpulse],
        tick: &(dyn Fn() + Sync),
    ) -> Vec<Result<Least<Whirl>>> {
        let seen = |impulse: &LateralImpulse, friction: f64| -> Result<Option<Whirl>> {
            if let Some(instability) = self.system.instability() {
                bail!("{instability}");
            }
            let whirl = self.whirl(&self.case(impulse, friction)?)?;
            tick();
            Ok(whirl)
        };
        let frictions: Vec<f64> = scan().collect();
        let cases: Vec<(usize, f64)> = (0..impulses.len())
            .flat_map(|impulse| frictions.iter().map(move |friction| (impulse, *friction)))
            .collect();
        // Whirl takes longest, and there is most of it at the greatest friction.
        let scanned = cases.par_iter().rev().with_max_len(1);
        let scanned = scanned.map(|(impulse, friction)| seen(&impulses[*impulse], *friction));
        let mut scanned: Vec<Result<Option<Whirl>>> = scanned.collect();
        scanned.reverse();
        let mut scanned = scanned.into_iter();
        let mut by_impulse = Vec::with_capacity(impulses.len());
        for impulse in impulses {
            let of_impulse = frictions.iter().zip(scanned.by_ref());
            let of_impulse: Result<Vec<_>> = of_impulse
                .map(|(friction, whirl)| Ok((*friction, whirl?)))
                .collect();
            by_impulse.push((impulse, of_impulse));
        }
        let found = by_impulse.into_par_iter().with_max_len(1);
        found
            .map(|(impulse, scanned)| Least::find(scanned?, |friction| seen(impulse, friction)))
            .collect()
    }

    /// The share of the contacts that touch their wall for most of the closing window, in a case
    /// that is followed to its end.
    ///
    /// # Errors
    /// Where the case gives no answer.
    pub fn share_touching(&self, impulse: &LateralImpulse, friction: f64) -> Result<f64> {
        let case = self.case(impulse, friction)?;
        let mut motion = Trajectory::default();
        (self.system).simulate(&case, Stopping::Full, Some(&mut motion))?;
        let window = case.scene.timing.closing_window * self.sampling_frequency();
        let window = window.round() as usize;
        let touches = motion.normal_forces.iter().zip(&self.is_contact);
        let contacts = touches.filter(|(_, is_contact)| **is_contact);
        let touches_mostly = |forces: &[f64]| {
            let closing = &forces[forces.len().saturating_sub(window)..];
            2 * closing.iter().filter(|force| **force > 0.0).count() > closing.len()
        };
        let mostly: Vec<bool> = contacts.map(|(forces, _)| touches_mostly(forces)).collect();
        let touching = mostly.iter().filter(|touches| **touches).count();
        Ok(touching as f64 / mostly.len() as f64)
    }
}
