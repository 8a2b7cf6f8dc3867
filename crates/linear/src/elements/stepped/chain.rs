//! Newmark's scheme on elements in a row, a pass down the string and one back for each step.
//!
//! [`super::super::newmark`] keeps displacement, velocity and acceleration of every step. Here
//! the first two are kept as they are predicted for the present one (Eqs. 64 and 65 without the
//! new acceleration a): ṽ and ũ, from which the next follow as ṽ + h a and
//! ũ + h ṽ + (½ + γ) h² a. So an acceleration may be added to after the fact, which is what
//! loads do that depend on where the string would be without them, and prediction, internal
//! forces and elimination are one pass over the nodes.

use std::ops::Range;

use super::super::newmark::{Matrices, Weights};
use super::blocks::{
    Block, Blocks, Values, add, difference, inverse, product, subtract, subtract_transposed, times,
    transposed,
};
use super::memory::{Memory, Remembered};
use super::node::NodeMotion;
use crate::error::BuildError;

/// What a load accelerates by a smaller part than this of the most is left out: it is below
/// rounding.
const NEGLIGIBLE: f64 = 1e-18;

/// The matrices at a node, and between it and the next one.
#[derive(Debug, Clone)]
struct Link<const D: usize> {
    damping: [f64; D],
    stiffness: Block<D>,
    /// From this node to the next.
    stiffness_below: Block<D>,
    /// Of the effective mass M + γh C + βh² K = L D Lᵀ: D⁻¹ at the node,
    pivot_inverse: Block<D>,
    /// and L from it to the next.
    factor_below: Block<D>,
}

/// Elements in a row with D degrees of freedom at a node, their effective mass factorised.
#[derive(Debug, Clone)]
pub(super) struct Chain<const D: usize> {
    weights: Weights,
    links: Vec<Link<D>>,
    /// Where loss has one.
    memory: Option<Memory<D>>,
}

/// The motion of a chain in a number of planes, ready for the loads of a step.
#[derive(Debug, Clone)]
pub(super) struct ChainMotion<const D: usize, const P: usize> {
    nodes: Vec<NodeMotion<D, P>>,
    remembered: Option<Remembered<D, P>>,
}

/// A node in a step, by degrees of freedom and planes.
#[derive(Debug, Clone, Copy)]
pub(in crate::elements) struct NodeState<const D: usize, const P: usize> {
    pub(in crate::elements) displacement: Values<D, P>,
    pub(in crate::elements) acceleration: Values<D, P>,
    /// What earlier displacements are relaxed into, where the material does.
    pub(in crate::elements) faded: Values<D, P>,
}

/// Accelerations of the nodes around a unit load.
#[derive(Debug, Clone)]
pub(super) struct Column<const D: usize> {
    first: usize,
    accelerations: Vec<[f64; D]>,
}

impl<const D: usize> Chain<D> {
    /// Of matrices that join neighbouring nodes only; the first node has `held` degrees of
    /// freedom less.
    ///
    /// # Errors
    /// Where the effective mass is not positive definite.
    pub fn new(matrices: &Matrices, held: usize, weights: Weights) -> Result<Self, BuildError> {
        let (velocity_gain, displacement_gain) =
            (weights.velocity_gain(), weights.displacement_gain());
        let nodes = (matrices.size() + held) / D;
        let mut stiffness = Blocks::new(nodes);
        let mut effective = Blocks::new(nodes);
        for (row, column, value) in matrices.stiffness_entries() {
            stiffness.add(row + held, column + held, value);
            effective.add(row + held, column + held, displacement_gain * value);
        }
        for (row, column, value) in matrices.mass_entries() {
            effective.add(row + held, column + held, value);
        }
        let mut damping = vec![[0.0; D]; nodes];
        for (place, dashpot) in matrices.damping().iter().enumerate() {
            let place = place + held;
            damping[place / D][place % D] = *dashpot;
            effective.add(place, place, velocity_gain * dashpot);
        }
        let memory = matrices.fading().map(|fading| {
            let (memory, at_once) = Memory::new(fading, held, nodes, &weights);
            for (place, dashpot) in at_once.dashpots.iter().enumerate() {
                let place = place + held;
                damping[place / D][place % D] += dashpot;
                effective.add(place, place, velocity_gain * dashpot);
            }
            for entry in &fading.elastic {
                let (row, column) = (entry.row + held, entry.col + held);
                let value = at_once.stiffness * entry.val;
                stiffness.add(row, column, value);
                effective.add(row, column, displacement_gain * value);
            }
            memory
        });
        // What is held has no force on it and is never accelerated.
        for place in 0..held {
            effective.add(place, place, 1.0);
        }
        let mut links = Vec::with_capacity(nodes);
        let mut taken = [[0.0; D]; D];
        for (node, damping) in damping.into_iter().enumerate() {
            let pivot = difference(effective.own[node], taken);
            let pivot_inverse = inverse(pivot).ok_or_else(|| BuildError::Factorisation {
                reason: format!("the effective mass is not positive definite at node {node}"),
            })?;
            let below = effective.below[node];
            let factor_below = product(below, pivot_inverse);
            taken = product(factor_below, transposed(below));
            links.push(Link {
                damping,
                stiffness: stiffness.own[node],
                stiffness_below: stiffness.below[node],
                pivot_inverse,
                factor_below,
            });
        }
        Ok(Self {
            weights,
            links,
            memory,
        })
    }

    /// Bytes of a number of nodes, with at most this number of relaxations of drag and of the material.
    pub fn bytes(nodes: f64, relaxations: [usize; 2]) -> f64 {
        let memory = match relaxations {
            [0, 0] => 0.0,
            some => Memory::<D>::bytes(nodes, some),
        };
        size_of::<Link<D>>() as f64 * nodes + memory
    }

    /// Bytes of a column that all of a number of nodes feel.
    pub fn column_bytes(nodes: f64) -> f64 {
        size_of::<[f64; D]>() as f64 * nodes
    }

    /// At rest.
    pub fn rest<const P: usize>(&self) -> ChainMotion<D, P> {
        let still = NodeMotion {
            displacement: [[0.0; P]; D],
            velocity: [[0.0; P]; D],
            acceleration: [[0.0; P]; D],
        };
        ChainMotion {
            nodes: vec![still; self.links.len()],
            remembered: self.memory.as_ref().map(Memory::rest),
        }
    }

    /// The next step, no load acting.
    pub fn advance<const P: usize>(&self, motion: &mut ChainMotion<D, P>) {
        let nodes = &mut motion.nodes[..self.links.len()];
        let remembers = match (&self.memory, &mut motion.remembered) {
            (Some(memory), Some(remembered)) => {
                memory.predict(remembered, nodes, &self.weights);
                true
            }
            _ => false,
        };
        if let Some(first) = nodes.first_mut().filter(|_| !remembers) {
            first.predict(&self.weights);
        }
        // What the node above leaves on the right-hand side of the next.
        let mut carried = [[0.0; P]; D];
        for (index, link) in self.links.iter().enumerate() {
            let (above, below) = nodes.split_at_mut(index + 1);
            let node = &mut above[index];
            let mut force = carried;
            add(&mut force, node.acceleration);
            if let Some(below) = below.first_mut() {
                if !remembers {
                    below.predict(&self.weights);
                }
                subtract_transposed(&mut force, &link.stiffness_below, &below.displacement);
            }
            for ((force, damping), velocity) in
                force.iter_mut().zip(link.damping).zip(&node.velocity)
            {
                for (force, velocity) in force.iter_mut().zip(velocity) {
                    *force -= damping * velocity;
                }
            }
            subtract(&mut force, &link.stiffness, &node.displacement);
            carried = [[0.0; P]; D];
            subtract(&mut carried, &link.stiffness_below, &node.displacement);
            subtract(&mut carried, &link.factor_below, &force);
            node.acceleration = force;
        }
        let mut below = [[0.0; P]; D];
        for (node, link) in nodes.iter_mut().zip(&self.links).rev() {
            let mut acceleration = times(&link.pivot_inverse, &node.acceleration);
            subtract_transposed(&mut acceleration, &link.factor_below, &below);
            node.acceleration = acceleration;
            below = acceleration;
        }
    }

    /// What a unit load on the first degree of freedom of a node accelerates.
    pub fn column(&self, loaded: usize) -> Column<D> {
        let mut values = vec![[[0.0; 1]; D]; self.links.len()];
        values[loaded][0] = [1.0];
        let links = self.links.iter().enumerate().skip(loaded);
        for (node, link) in links.take(self.links.len() - loaded - 1) {
            let above = values[node];
            subtract(&mut values[node + 1], &link.factor_below, &above);
        }
        let mut below = [[0.0; 1]; D];
        for (value, link) in values.iter_mut().zip(&self.links).rev() {
            let mut acceleration = times(&link.pivot_inverse, value);
            subtract_transposed(&mut acceleration, &link.factor_below, &below);
            *value = acceleration;
            below = acceleration;
        }
        let Range { start, end } = felt(&values);
        let accelerations = values[start..end].iter().map(|node| node.map(|[one]| one));
        Column {
            first: start,
            accelerations: accelerations.collect(),
        }
    }
}

/// The nodes that feel a load.
fn felt<const D: usize>(values: &[Values<D, 1>]) -> Range<usize> {
    let of_node = |node: &Values<D, 1>| node.iter().fold(0.0, |most: f64, [it]| most.max(it.abs()));
    let most = values.iter().map(of_node).fold(0.0, f64::max);
    let is_felt = |node: &Values<D, 1>| of_node(node) > NEGLIGIBLE * most;
    let first = values.iter().position(is_felt).unwrap_or(0);
    let last = values.iter().rposition(is_felt).unwrap_or(0);
    first..last + 1
}

impl<const D: usize, const P: usize> ChainMotion<D, P> {
    /// Bytes of a number of nodes, with at most this number of relaxations of drag and of the material.
    pub fn bytes(nodes: f64, relaxations: [usize; 2]) -> f64 {
        let remembered = Remembered::<D, P>::bytes(nodes, relaxations);
        size_of::<NodeMotion<D, P>>() as f64 * nodes + remembered
    }

    /// Adds what loads in every plane do to the step.
    pub fn add(&mut self, column: &Column<D>, loads: [f64; P]) {
        let nodes = self.nodes[column.first..].iter_mut();
        for (node, unit) in nodes.zip(&column.accelerations) {
            for (acceleration, unit) in node.acceleration.iter_mut().zip(unit) {
                for (acceleration, load) in acceleration.iter_mut().zip(loads) {
                    *acceleration += unit * load;
                }
            }
        }
    }

    /// Displacement of a node in the step, of the first degree of freedom, in every plane.
    pub fn displacement(&self, node: usize, weights: &Weights) -> [f64; P] {
        let (node, gain) = (&self.nodes[node], weights.displacement_gain());
        std::array::from_fn(|plane| {
            node.displacement[0][plane] + gain * node.acceleration[0][plane]
        })
    }

    /// All of a node in the step, its loads applied.
    pub fn state(&self, node: usize, weights: &Weights) -> NodeState<D, P> {
        let (displacement, _) = self.nodes[node].now(weights);
        let remembered = self.remembered.as_ref();
        let faded = remembered.map(|it| it.faded(node, self.nodes.len()));
        NodeState {
            displacement,
            acceleration: self.nodes[node].acceleration,
            faded: faded.unwrap_or([[0.0; P]; D]),
        }
    }

    /// Velocity in the same way.
    pub fn velocity(&self, node: usize, weights: &Weights) -> [f64; P] {
        let (node, gain) = (&self.nodes[node], weights.velocity_gain());
        std::array::from_fn(|plane| node.velocity[0][plane] + gain * node.acceleration[0][plane])
    }
}

impl<const D: usize> Column<D> {
    /// The acceleration of the first degree of freedom of a node.
    pub fn at(&self, node: usize) -> f64 {
        let place = node.checked_sub(self.first);
        let found = place.and_then(|place| self.accelerations.get(place));
        found.map_or(0.0, |accelerations| accelerations[0])
    }
}
