//! All sites of a step at once: those that feel one another within it are solved in
//! turn, each with the others' latest loads, until what has changed of these no longer
//! matters. Sites that these cannot bring to their walls wait until the others have settled.

use crate::site::Load;
use crate::system::System;

/// A site is solved again if the others' loads have changed since by what changes its own
/// force by more than this fraction of the largest: ten thousand times rounding, and a
/// thousandth of what a wall's law is held to (`laws::obeyed`).
const COUPLING_TOLERANCE: f64 = 1e-12;

/// Turns after which sites that do not settle are given up.
const MOST_TURNS: usize = 200;

/// The loads of all sites that may bear one.
#[derive(Debug)]
pub(crate) struct Coupling {
    loads: Loads,
    normal_forces: Vec<f64>,
    /// What the others' loads have changed by since a site was solved, as force at it, N.
    pending: Vec<f64>,
    /// What of that leaves a site without a load as it was solved last, N.
    slack: Vec<f64>,
    /// What the load of a site is worth at every other, site by site; nothing without walls.
    shares: Vec<Share>,
}

/// A site solved within a step, the loads of the others given.
pub(crate) struct Solved {
    pub(crate) load: Load,
    /// N.
    pub(crate) normal_force: f64,
    /// The force at the site, N, that the loads of others have to change by before it may bear
    /// one; zero where it does.
    pub(crate) slack: f64,
}

/// Loads by site; of many sites few bear one.
#[derive(Debug)]
pub(crate) struct Loads {
    all: Vec<Load>,
    /// The sites whose load is not zero, in rising order.
    acting: Vec<usize>,
}

/// The force at a site that a load at another is worth. A site gives way by its own response,
/// or turns by it.
#[derive(Debug, Clone, Copy)]
struct Share {
    /// Of a force.
    of_force: f64,
    /// Of a torque, 1/m.
    of_torque: f64,
}

impl Coupling {
    /// Of the loads of a system, at whose walls the string has these radii, m; it may have
    /// none.
    pub(crate) fn new(system: &System, radii: &[f64]) -> Self {
        let count = system.loaded.len();
        let share = |site: usize, radius: f64, other: usize| {
            let turned = system.from_torques.share(site, other);
            Share {
                of_force: (system.from_forces.as_ref())
                    .map_or(0.0, |forces| forces.share(site, other)),
                of_torque: if turned == 0.0 { 0.0 } else { turned / radius },
            }
        };
        let of_load = |loaded| {
            let sites = radii.iter().enumerate();
            sites.map(move |(site, &radius)| share(site, radius, loaded))
        };
        Self {
            loads: Loads::none(count),
            normal_forces: vec![0.0; count],
            pending: vec![0.0; count],
            slack: vec![0.0; count],
            shares: (0..count).flat_map(of_load).collect(),
        }
    }

    /// The loads of the step solved last.
    pub(crate) fn loads(&self) -> &[Load] {
        &self.loads.all
    }

    /// Forgets what acted in the last step.
    pub(crate) fn clear(&mut self) {
        self.loads.clear();
    }

    /// The torque on the one site that bears a load.
    pub(crate) fn set_torque(&mut self, index: usize, torque: f64) {
        let load = Load {
            torque,
            ..self.loads.all[index]
        };
        self.loads.replace(index, load);
    }

    /// Solves a step by solving one site after the other, from the loads of the last
    /// step on. Gives whether they settled.
    #[inline]
    pub(crate) fn settle<E>(
        &mut self,
        mut solve: impl FnMut(usize, &Loads) -> Result<Solved, E>,
    ) -> Result<bool, E> {
        self.pending.fill(f64::INFINITY);
        for _ in 0..MOST_TURNS {
            let largest = self.normal_forces.iter().copied().fold(0.0, f64::max);
            let matters = COUPLING_TOLERANCE * largest;
            let mut is_settled = true;
            for site in 0..self.pending.len() {
                if self.pending[site] > self.slack[site].max(matters) {
                    self.solve_site(site, &mut solve)?;
                    is_settled = false;
                }
            }
            if is_settled {
                for site in 0..self.pending.len() {
                    if self.pending[site] > matters {
                        self.solve_site(site, &mut solve)?;
                    }
                }
                return Ok(true);
            }
        }
        Ok(false)
    }

    #[inline]
    fn solve_site<E>(
        &mut self,
        site: usize,
        solve: &mut impl FnMut(usize, &Loads) -> Result<Solved, E>,
    ) -> Result<(), E> {
        let solved = solve(site, &self.loads)?;
        self.normal_forces[site] = solved.normal_force;
        self.slack[site] = solved.slack;
        self.replace(site, solved.load);
        Ok(())
    }

    /// The load of a site that has been solved, and what it changes for the others.
    #[inline]
    fn replace(&mut self, site: usize, load: Load) {
        let before = self.loads.replace(site, load);
        let [x, y] = [0, 1].map(|axis| (load.force[axis] - before.force[axis]).abs());
        let torque = (load.torque - before.torque).abs();
        self.pending[site] = 0.0;
        if x + y + torque == 0.0 {
            return;
        }
        let shares = self.shares.chunks_exact(self.pending.len()).nth(site);
        for (pending, share) in (self.pending.iter_mut()).zip(shares.into_iter().flatten()) {
            *pending += share.of_force * (x + y);
            *pending += share.of_torque * torque;
        }
        self.pending[site] = 0.0;
    }
}

impl Loads {
    fn none(sites: usize) -> Self {
        Self {
            all: vec![Load::default(); sites],
            acting: Vec::with_capacity(sites),
        }
    }

    fn clear(&mut self) {
        for site in self.acting.drain(..) {
            self.all[site] = Load::default();
        }
    }

    /// Gives a site a load, and what it was before.
    fn replace(&mut self, site: usize, load: Load) -> Load {
        let before = std::mem::replace(&mut self.all[site], load);
        let [did, does] = [before, load].map(|load| load != Load::default());
        if did != does {
            match self.acting.binary_search(&site) {
                Ok(place) => drop(self.acting.remove(place)),
                Err(place) => self.acting.insert(place, site),
            }
        }
        before
    }

    /// Those that act on other sites than this one.
    #[inline]
    pub(crate) fn besides(&self, site: usize) -> impl Iterator<Item = (usize, &Load)> {
        let others = self.acting.iter().filter(move |other| **other != site);
        others.map(|&other| (other, &self.all[other]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sites whose force is what they would bear alone less shares of the others' forces.
    struct Linear {
        alone: [f64; 3],
        shares: [[f64; 3]; 3],
    }

    impl Linear {
        fn coupling(&self) -> Coupling {
            let share = |of_force: &f64| Share {
                of_force: of_force.abs(),
                of_torque: 0.0,
            };
            Coupling {
                loads: Loads::none(3),
                normal_forces: vec![0.0; 3],
                pending: vec![0.0; 3],
                slack: vec![0.0; 3],
                shares: (0..9)
                    .map(|pair| share(&self.shares[pair % 3][pair / 3]))
                    .collect(),
            }
        }

        fn force(&self, site: usize, loads: &Loads) -> f64 {
            let shares = self.shares[site];
            let others = loads.besides(site);
            self.alone[site]
                - others
                    .map(|(other, load)| shares[other] * load.force[0])
                    .sum::<f64>()
        }

        /// Whether they settle, at which loads, and how often a site was solved.
        fn settle(&self) -> (bool, Loads, usize) {
            let (mut coupling, mut solved) = (self.coupling(), 0);
            let settled = coupling.settle(|site, loads| {
                solved += 1;
                let force = self.force(site, loads);
                let load = Load {
                    force: [force, 0.0],
                    torque: 0.0,
                };
                Ok::<_, ()>(Solved {
                    load,
                    normal_force: force.abs(),
                    slack: 0.0,
                })
            });
            (settled == Ok(true), coupling.loads, solved)
        }
    }

    #[test]
    fn all_sites_agree_when_they_have_settled() {
        let system = Linear {
            alone: [3.0, -1.0, 2.0],
            shares: [[0.0, 0.4, 0.1], [0.3, 0.0, -0.2], [0.05, 0.3, 0.0]],
        };
        let (is_settled, loads, _) = system.settle();
        assert!(is_settled);
        for (site, load) in loads.all.iter().enumerate() {
            let off = load.force[0] - system.force(site, &loads);
            assert!(
                off.abs() <= 3.0 * COUPLING_TOLERANCE,
                "site {site}: {off:e}"
            );
        }
    }

    /// The one in the middle alone feels another, which is solved before it.
    #[test]
    fn a_site_is_solved_once_if_nothing_it_feels_changes_after() {
        let system = Linear {
            alone: [3.0, -1.0, 2.0],
            shares: [[0.0; 3], [0.3, 0.0, 0.0], [0.0; 3]],
        };
        let (is_settled, loads, solved) = system.settle();
        assert!(is_settled);
        assert_eq!(solved, 3);
        assert!((loads.all[1].force[0] + 1.9).abs() < 1e-15);
    }

    #[test]
    fn sites_that_drive_one_another_further_and_further_are_given_up() {
        let system = Linear {
            alone: [1.0; 3],
            shares: [[0.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0; 3]],
        };
        let (is_settled, _, solved) = system.settle();
        assert!(!is_settled);
        assert!(solved <= 3 * MOST_TURNS);
    }
}
