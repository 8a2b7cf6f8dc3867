//! What is known of the points of a lattice.

use super::lattice::Lattice;

/// What a point is in one layer, such as a motion by a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Class {
    /// Without the regime.
    Without,
    /// With the regime.
    With,
    /// It has no label, or one that does not tell.
    Undetermined,
    /// It was not simulated.
    Unknown,
}

/// The classes of the points of a lattice, in a few layers that are known together.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// Of which lattice.
    pub lattice: Lattice,
    layers: Vec<Vec<Class>>,
}

impl Known {
    /// Nothing yet.
    pub fn nothing(lattice: Lattice, layers: usize) -> Self {
        Self {
            lattice,
            layers: vec![vec![Class::Unknown; lattice.points()]; layers],
        }
    }

    /// How many layers there are.
    pub fn layers(&self) -> usize {
        self.layers.len()
    }

    /// Sets what a point is in a layer.
    pub fn set(&mut self, layer: usize, point: usize, class: Class) {
        self.layers[layer][point] = class;
    }

    /// What the point at a place is in a layer.
    pub fn at(&self, layer: usize, place: [usize; 2]) -> Class {
        self.layers[layer][self.lattice.number(place)]
    }

    /// Whether the point at a place is known in every layer.
    pub fn has(&self, place: [usize; 2]) -> bool {
        let point = self.lattice.number(place);
        let mut layers = self.layers.iter();
        layers.all(|layer| layer[point] != Class::Unknown)
    }

    /// Whether points are alike in a layer.
    pub fn are_alike(&self, layer: usize, places: &[[usize; 2]]) -> bool {
        let mut classes = places.iter().map(|place| self.at(layer, *place));
        let first = classes.next();
        classes.all(|class| Some(class) == first)
    }

    /// Takes what another one knows of a place.
    pub(super) fn take(&mut self, layer: usize, place: [usize; 2], other: &Known) {
        let point = self.lattice.number(place);
        self.layers[layer][point] = other.layers[layer][point];
    }

    /// Takes a point to be what another one is.
    pub(super) fn take_from(&mut self, layer: usize, place: [usize; 2], other: [usize; 2]) {
        let [point, other] = [place, other].map(|place| self.lattice.number(place));
        self.layers[layer][point] = self.layers[layer][other];
    }
}
