//! The loads of all ports, of which most bear none.

/// What acts on a port in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Load {
    /// Force, N.
    pub(crate) force: [f64; 2],
    /// Torque, N m.
    pub(crate) torque: f64,
}

/// Loads by port; of many ports few bear one.
#[derive(Debug)]
pub(crate) struct Loads {
    pub(super) all: Vec<Load>,
    /// The ports whose load is not zero, in rising order; where only one ever bears a load, that.
    pub(super) acting: Vec<usize>,
}

impl Loads {
    pub(super) fn none(ports: usize) -> Self {
        Self {
            all: vec![Load::default(); ports],
            acting: Vec::with_capacity(ports),
        }
    }

    pub(super) fn clear(&mut self) {
        for port in self.acting.drain(..) {
            self.all[port] = Load::default();
        }
    }

    /// Gives a port a load, and what it was before.
    pub(super) fn replace(&mut self, port: usize, load: Load) -> Load {
        let before = std::mem::replace(&mut self.all[port], load);
        let [did, does] = [before, load].map(|load| load != Load::default());
        if did != does {
            match self.acting.binary_search(&port) {
                Ok(place) => drop(self.acting.remove(place)),
                Err(place) => self.acting.insert(place, port),
            }
        }
        before
    }

    /// Gives a load to the only port that ever bears one.
    #[inline]
    pub(super) fn set_only(&mut self, port: usize, load: Load) {
        self.all[port] = load;
        if self.acting.is_empty() {
            self.acting.push(port);
        }
    }

    /// Those that act on other ports than this one.
    #[inline]
    pub(super) fn others_than(&self, port: usize) -> impl Iterator<Item = (usize, &Load)> {
        let others = self.acting.iter().filter(move |other| **other != port);
        others.map(|&other| (other, &self.all[other]))
    }

    /// The largest torque, N m.
    pub(super) fn largest_torque(&self) -> f64 {
        let torques = self.acting.iter().map(|&port| self.all[port].torque.abs());
        torques.fold(0.0, f64::max)
    }
}
