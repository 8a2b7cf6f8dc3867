//! Steady backward whirl of several sites at once that balances every force: what friction is
//! known to be enough for one.
//!
//! Sets of sites slide along their walls at one rate while the others are clear
//! ([`super::contacts`]).
//!
//! What is found is checked; what is not found may be there all the same, and so may whirl
//! in which some sites roll and others slide. So the least friction found is an upper bound of the
//! least with which whirl is steady, as [`WhirlingSites::least_friction`] is a lower one. Whether
//! the motion is stable is another matter.

use linear::Complex64;

use super::MOST_FRICTION;
use super::contacts::{Contacts, Rate, State};
use super::many_sites::WhirlingSites;

/// Up to this number of sites all sets are tried; of more, neighbours, …
const ALL_SETS: usize = 5;

/// … of up to this number.
const NEIGHBOURS: usize = 3;

/// Rates that are tried, evenly spaced up to the fastest.
const RATES: u32 = 200;

/// The best rate is then followed to this part of itself.
const NEAREST_RATE: f64 = 1e-6;

/// Several sites in steady backward whirl, all of which slide, or just do.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct WhirlTogether {
    /// Rate of precession ω, against the rotation, rad/s.
    pub rate: f64,
    /// The coefficient of friction at the speeds at which they slide.
    pub friction: f64,
    /// The sites that touch.
    pub contacts: Vec<WhirlContact>,
}

/// A site that touches in steady backward whirl.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct WhirlContact {
    /// The site.
    pub site: usize,
    /// Radius of the centre, m.
    pub radius: f64,
    /// Its phase ahead of the first, rad.
    pub phase: f64,
    /// Normal force, N.
    pub normal_force: f64,
}

impl<H: Fn(f64) -> Vec<Complex64>> WhirlingSites<H> {
    /// Of the steady whirls found at a surface speed (rad/s), that which needs the least friction;
    /// none where none is found that needs less than [`MOST_FRICTION`]. Of up to five sites all
    /// sets are tried, of more those of up to three neighbours, at 200 rates.
    pub fn least_together(&self, surface_speed: f64) -> Option<WhirlTogether> {
        let ratios = self.walls.iter().map(|wall| wall.radius / wall.clearance);
        let fastest = surface_speed * ratios.fold(0.0, f64::max);
        if fastest <= 0.0 {
            return None;
        }
        let spacing = fastest / f64::from(RATES);
        let sets = sets(self.walls.len());
        let mut best: Option<(&[usize], State)> = None;
        for step in 1..=RATES {
            let here = self.at(surface_speed, spacing * f64::from(step));
            for set in &sets {
                let Some(contacts) = Contacts::new(&here, set) else {
                    continue;
                };
                for start in contacts.starts() {
                    let most = best
                        .as_ref()
                        .map_or(MOST_FRICTION, |(_, best)| best.friction);
                    let found = contacts.solved(start);
                    if let Some(found) = found.filter(|found| found.friction < most) {
                        best = Some((set, found));
                    }
                }
            }
        }
        let (set, state) = best?;
        Some(self.followed(surface_speed, spacing, set, state))
    }

    fn at(&self, surface_speed: f64, rate: f64) -> Rate<'_> {
        Rate {
            walls: &self.walls,
            surface_speed,
            rate,
            receptance: (self.receptance)(rate),
        }
    }

    /// The least friction next to a whirl of a set, by rates ever nearer.
    fn followed(
        &self,
        surface_speed: f64,
        mut distance: f64,
        set: &[usize],
        mut best: State,
    ) -> WhirlTogether {
        while distance > NEAREST_RATE * best.rate {
            let next = [-distance, distance].into_iter().find_map(|step| {
                let rate = best.rate + step;
                let here = (rate > 0.0).then(|| self.at(surface_speed, rate))?;
                let found = Contacts::new(&here, set)?.solved(best.clone());
                found.filter(|found| found.friction < best.friction)
            });
            match next {
                Some(next) => best = next,
                None => distance *= 0.5,
            }
        }
        let contact = |(index, site): (usize, &usize)| WhirlContact {
            site: *site,
            radius: best.touching[index].radius,
            phase: best.phases[index],
            normal_force: best.touching[index].normal_force,
        };
        WhirlTogether {
            rate: best.rate,
            friction: best.friction,
            contacts: set.iter().enumerate().map(contact).collect(),
        }
    }
}

/// The sets of sites that are tried.
fn sets(sites: usize) -> Vec<Vec<usize>> {
    if sites <= ALL_SETS {
        let of = |set: usize| (0..sites).filter(|site| set >> site & 1 == 1).collect();
        return (1..1 << sites).map(of).collect();
    }
    (1..=NEIGHBOURS)
        .flat_map(|count| (0..=sites - count).map(move |first| (first..first + count).collect()))
        .collect()
}
