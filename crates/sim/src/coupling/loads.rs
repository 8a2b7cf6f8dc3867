//! The loads of all sites, of which most bear none.

/// What acts on a port in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Load {
    /// Force, N.
    pub(crate) force: [f64; 2],
    /// Torque, N m.
    pub(crate) torque: f64,
}

/// Loads by site; of many sites few bear one.
#[derive(Debug)]
pub(crate) struct Loads {
    pub(super) all: Vec<Load>,
    /// The sites whose load is not zero, in rising order.
    pub(super) acting: Vec<usize>,
}

impl Loads {
    pub(super) fn none(sites: usize) -> Self {
        Self {
            all: vec![Load::default(); sites],
            acting: Vec::with_capacity(sites),
        }
    }

    pub(super) fn clear(&mut self) {
        for site in self.acting.drain(..) {
            self.all[site] = Load::default();
        }
    }

    /// Gives a site a load, and what it was before.
    pub(super) fn replace(&mut self, site: usize, load: Load) -> Load {
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
    pub(super) fn besides(&self, site: usize) -> impl Iterator<Item = (usize, &Load)> {
        let others = self.acting.iter().filter(move |other| **other != site);
        others.map(|&other| (other, &self.all[other]))
    }

    /// The largest torque, N m.
    pub(super) fn largest_torque(&self) -> f64 {
        let torques = self.acting.iter().map(|&port| self.all[port].torque.abs());
        torques.fold(0.0, f64::max)
    }
}
