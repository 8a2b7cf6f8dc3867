//! A string that may touch at some contacts and is hit: does it whirl to the end?

use std::f64::consts::TAU;

use anyhow::{Result, bail};
use linear::Method;
use rayon::prelude::*;
use sim::{LateralRegime, SimulationError, Stopping, Trajectory};

use super::blow::Blow;
use super::places::{index_of, with_others};
use super::search::{Least, scan};
use super::subject::{Subject, blow_start, impulse};
use campaign::engine::{Case, MethodSystem, Recipe};

/// Clearance of a place that is hit but is no contact, m: no string comes so far.
const OUT_OF_REACH: f64 = 1e6;

/// A whirl goes round this often in the closing window at least: what leans on the wall and creeps
/// along it has the label of whirl, too.
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
    subject: &'a Subject,
    system: MethodSystem,
    /// Of each site from the surface down, whether it is a contact.
    is_contact: Vec<bool>,
}

impl<'a> Touching<'a> {
    /// Builds a string with so many contacts, that may be hit at these places (m from the bit), by
    /// a method.
    ///
    /// # Errors
    /// Where the method cannot treat it.
    pub fn build(subject: &'a Subject, count: usize, hit: &[f64], method: Method) -> Result<Self> {
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

    /// The case of a blow at a friction.
    fn case(&self, blow: &Blow, friction: f64) -> Result<Case> {
        let setting = &self.system.setting;
        let mut case = self.subject.case(setting, friction)?;
        let start = blow_start(setting);
        let places = setting.sites.distances_from_bit();
        if let Some(lateral) = &mut case.scene.lateral {
            for (wall, is_contact) in lateral.walls.iter_mut().zip(&self.is_contact) {
                if !is_contact {
                    wall.clearance = OUT_OF_REACH;
                }
            }
            let impulses = blow.impulses().into_iter();
            let at_sites = impulses.filter_map(|(place, amount)| {
                Some(impulse(index_of(places, place)?, amount, start).with_amount(amount))
            });
            lateral.impulses = at_sites.collect();
        }
        Ok(case)
    }

    /// The whirl that lasts to the end after a blow, if one does.
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

    /// The least friction at which whirl lasts after each blow, all of them at once; `tick` is
    /// told of every simulation. A blow has no answer where one of its cases has none, or the method
    /// chatters where a site sticks.
    pub fn limits(&self, blows: &[Blow], tick: &(dyn Fn() + Sync)) -> Vec<Result<Least<Whirl>>> {
        let seen = |blow: &Blow, friction: f64| -> Result<Option<Whirl>> {
            if let Some(instability) = self.system.instability() {
                bail!("{instability}");
            }
            let whirl = self.whirl(&self.case(blow, friction)?)?;
            tick();
            Ok(whirl)
        };
        let frictions: Vec<f64> = scan().collect();
        let cases: Vec<(usize, f64)> = (0..blows.len())
            .flat_map(|blow| frictions.iter().map(move |friction| (blow, *friction)))
            .collect();
        // Whirl takes longest, and there is most of it at the greatest friction.
        let scanned = cases.par_iter().rev().with_max_len(1);
        let scanned = scanned.map(|(blow, friction)| seen(&blows[*blow], *friction));
        let mut scanned: Vec<Result<Option<Whirl>>> = scanned.collect();
        scanned.reverse();
        let mut scanned = scanned.into_iter();
        let mut of_blows = Vec::with_capacity(blows.len());
        for blow in blows {
            let of_blow = frictions.iter().zip(scanned.by_ref());
            let of_blow: Result<Vec<_>> = of_blow
                .map(|(friction, whirl)| Ok((*friction, whirl?)))
                .collect();
            of_blows.push((blow, of_blow));
        }
        let found = of_blows.into_par_iter().with_max_len(1);
        found
            .map(|(blow, scanned)| Least::find(scanned?, |friction| seen(blow, friction)))
            .collect()
    }

    /// The share of the contacts that touch their wall for most of the closing window, in a case
    /// that is followed to its end.
    ///
    /// # Errors
    /// Where the case gives no answer.
    pub fn share_touching(&self, blow: &Blow, friction: f64) -> Result<f64> {
        let case = self.case(blow, friction)?;
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
