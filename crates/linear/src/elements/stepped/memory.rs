//! Forces of earlier motion on elements in a row: what mud and material that lose energy remember.

use super::super::fading::{Faded, Fading};
use super::blocks::{Block, Blocks, Values, add, add_row, times, transposed};
use super::node::NodeMotion;
use crate::elements::newmark::Weights;

/// What of fading forces acts at once within a step.
#[derive(Debug, Clone)]
pub(super) struct AtOnce {
    /// A dashpot a degree of freedom that is free.
    pub dashpots: Vec<f64>,
    /// The part of the elastic stiffness by which it is greater.
    pub stiffness: f64,
}

/// Relaxations of a chain, stepped by the trapezoidal rule.
#[derive(Debug, Clone)]
pub(super) struct Memory<const D: usize> {
    /// What is kept from step to step of each relaxation of drag, and what a unit speed of each node
    /// adds to it, node by node.
    drag_kept: Vec<f64>,
    drag_added: Vec<f64>,
    /// The same of those of the material, alike everywhere.
    material: Vec<Faded>,
    /// The stiffness that fades, of each node and between it and the next.
    elastic: Vec<[Block<D>; 2]>,
}

/// What is remembered of a motion, in every plane, one for each relaxation.
#[derive(Debug, Clone)]
pub(super) struct Remembered<const D: usize, const P: usize> {
    /// Forces, by nodes.
    drag: Vec<[f64; P]>,
    /// Displacements, by nodes.
    material: Vec<Values<D, P>>,
}

impl<const D: usize> Memory<D> {
    /// Of what fades; and what is a force at once: drag of each degree of freedom, and the part of
    /// the elastic stiffness.
    pub fn new(fading: &Fading, held: usize, nodes: usize, weights: &Weights) -> (Self, AtOnce) {
        let step = weights.step;
        let drag: Vec<Faded> = (fading.drag.iter())
            .map(|it| Faded::new(it.rate, step))
            .collect();
        let mut dashpots = vec![0.0; fading.drag.first().map_or(0, |it| it.dashpots.len())];
        let mut drag_added = vec![0.0; nodes * drag.len()];
        for (index, (relaxation, faded)) in fading.drag.iter().zip(&drag).enumerate() {
            for (place, dashpot) in relaxation.dashpots.iter().enumerate() {
                dashpots[place] += faded.at_once * dashpot;
                // Drag is on the first degree of freedom of a node alone.
                if (place + held) % D == 0 {
                    let node = (place + held) / D;
                    drag_added[node * drag.len() + index] = faded.added * dashpot;
                }
            }
        }
        let stepped = fading.material.iter().map(|relaxation| {
            let faded = Faded::new(relaxation.rate, step);
            let weight = relaxation.weight;
            let added = faded.added * weight;
            (weight * faded.at_once, Faded { added, ..faded })
        });
        let (at_once, material): (Vec<f64>, Vec<Faded>) = stepped.unzip();
        let mut elastic = Blocks::new(if material.is_empty() { 0 } else { nodes });
        for entry in fading.elastic.iter().filter(|_| !material.is_empty()) {
            elastic.add(entry.row + held, entry.col + held, entry.val);
        }
        let memory = Self {
            drag_kept: drag.iter().map(|it| it.kept).collect(),
            drag_added,
            material,
            elastic: std::iter::zip(elastic.own, elastic.below)
                .map(|(own, below)| [own, below])
                .collect(),
        };
        let stiffness = at_once.iter().sum();
        (
            memory,
            AtOnce {
                dashpots,
                stiffness,
            },
        )
    }

    /// Bytes of a number of nodes, with at most this number of relaxations of drag.
    pub fn bytes(nodes: f64, [drag, _]: [usize; 2]) -> f64 {
        nodes * (drag * size_of::<f64>() + size_of::<[Block<D>; 2]>()) as f64
    }

    /// Of a string that has been at rest.
    pub fn rest<const P: usize>(&self) -> Remembered<D, P> {
        Remembered {
            drag: vec![[0.0; P]; self.drag_added.len()],
            material: vec![[[0.0; P]; D]; self.elastic.len() * self.material.len()],
        }
    }

    /// Predicts the next step of all nodes, and leaves the forces of what is remembered in the place
    /// of their accelerations.
    pub fn predict<const P: usize>(
        &self,
        remembered: &mut Remembered<D, P>,
        nodes: &mut [NodeMotion<D, P>],
        weights: &Weights,
    ) {
        let mut above = [[0.0; P]; D];
        for index in 0..nodes.len() {
            let (displacement, velocity) = nodes[index].now(weights);
            nodes[index].predict(weights);
            let force = self.drag(remembered, index, velocity[0]);
            add_row(&mut nodes[index].acceleration[0], force);
            if self.elastic.is_empty() {
                continue;
            }
            let faded = self.faded(remembered, index, &displacement);
            let [own, _] = &self.elastic[index];
            add(&mut nodes[index].acceleration, times(own, &faded));
            if let Some(upper) = index.checked_sub(1) {
                let [_, between] = &self.elastic[upper];
                add(&mut nodes[index].acceleration, times(between, &above));
                add(
                    &mut nodes[upper].acceleration,
                    times(&transposed(*between), &faded),
                );
            }
            above = faded;
        }
    }

    /// The force of earlier speeds on a node, which has a speed now.
    fn drag<const P: usize>(
        &self,
        remembered: &mut Remembered<D, P>,
        node: usize,
        speed: [f64; P],
    ) -> [f64; P] {
        let count = self.drag_kept.len();
        let own = node * count..(node + 1) * count;
        let added = self.drag_kept.iter().zip(&self.drag_added[own.clone()]);
        let mut force = [0.0; P];
        for (carried, (kept, added)) in remembered.drag[own].iter_mut().zip(added) {
            for (carried, speed) in carried.iter_mut().zip(speed) {
                *carried = kept * *carried + added * speed;
            }
            add_row(&mut force, *carried);
        }
        force
    }

    /// How far earlier displacements of a node are relaxed into, which is displaced now.
    fn faded<const P: usize>(
        &self,
        remembered: &mut Remembered<D, P>,
        node: usize,
        displacement: &Values<D, P>,
    ) -> Values<D, P> {
        let count = self.material.len();
        let own = &mut remembered.material[node * count..(node + 1) * count];
        let mut sum = [[0.0; P]; D];
        for (carried, faded) in own.iter_mut().zip(&self.material) {
            for (freedom, carried) in carried.iter_mut().enumerate() {
                for (carried, displacement) in carried.iter_mut().zip(displacement[freedom]) {
                    *carried = faded.kept * *carried + faded.added * displacement;
                }
                add_row(&mut sum[freedom], *carried);
            }
        }
        sum
    }
}

impl<const D: usize, const P: usize> Remembered<D, P> {
    /// How far earlier displacements of one of a number of nodes are relaxed into.
    pub fn faded(&self, node: usize, nodes: usize) -> Values<D, P> {
        let count = self.material.len() / nodes;
        let mut sum = [[0.0; P]; D];
        for carried in &self.material[node * count..(node + 1) * count] {
            add(&mut sum, *carried);
        }
        sum
    }

    /// Bytes of a number of nodes, with at most this number of relaxations of drag and of the material.
    pub fn bytes(nodes: f64, [drag, material]: [usize; 2]) -> f64 {
        nodes * (drag * size_of::<[f64; P]>() + material * size_of::<Values<D, P>>()) as f64
    }
}
