//! A channel of a string that is stepped: loads at the sites in, motion of the sites out.

use super::chain::{Chain, ChainMotion, Column, NodeState};
use crate::drillstring::Drillstring;
use crate::elements::fading;
use crate::elements::newmark::{Matrices, Weights};
use crate::error::BuildError;

/// A string in one channel, as elements with `FREEDOMS` degrees of freedom at a node, that moves in
/// `PLANES` planes; its response to a load is that of the taps of the same elements.
#[derive(Debug, Clone)]
pub struct SteppedChannel<const FREEDOMS: usize, const PLANES: usize> {
    weights: Weights,
    chain: Chain<FREEDOMS>,
    seen: Seen,
    nodes: Vec<usize>,
    /// From a unit load at each site.
    columns: Vec<Column<FREEDOMS>>,
}

/// What is seen of a site.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Seen {
    Displacement,
    Velocity,
}

/// The motion of a string in a channel, ready for the loads of a step.
#[derive(Debug, Clone)]
pub struct SteppedMotion<const FREEDOMS: usize, const PLANES: usize>(ChainMotion<FREEDOMS, PLANES>);

impl<const FREEDOMS: usize, const PLANES: usize> SteppedChannel<FREEDOMS, PLANES> {
    /// Of matrices whose first node has `held` degrees of freedom less, with loads at some
    /// nodes.
    pub(super) fn new(
        matrices: &Matrices,
        held: usize,
        weights: Weights,
        seen: Seen,
        nodes: Vec<usize>,
    ) -> Result<Self, BuildError> {
        let chain = Chain::new(matrices, held, weights)?;
        Ok(Self {
            columns: nodes.iter().map(|&node| chain.column(node)).collect(),
            weights,
            chain,
            seen,
            nodes,
        })
    }

    /// Bytes of a number of nodes of a string, with loads at a number of sites that all of them
    /// feel.
    pub(crate) fn bytes(string: &Drillstring, nodes: f64, sites: usize) -> f64 {
        let relaxations = fading::most(string.loss());
        Chain::<FREEDOMS>::bytes(nodes, relaxations)
            + sites as f64 * Chain::<FREEDOMS>::column_bytes(nodes)
    }

    /// Bytes of the motion of a number of nodes of a string.
    pub(crate) fn motion_bytes(string: &Drillstring, nodes: f64) -> f64 {
        ChainMotion::<FREEDOMS, PLANES>::bytes(nodes, fading::most(string.loss()))
    }

    /// Number of sites.
    pub fn sites(&self) -> usize {
        self.nodes.len()
    }

    /// Motion of a site within the step of a unit load at another: the first tap between them.
    pub fn instant(&self, output: usize, input: usize) -> f64 {
        let gain = match self.seen {
            Seen::Displacement => self.weights.displacement_gain(),
            Seen::Velocity => self.weights.velocity_gain(),
        };
        gain * self.columns[input].at(self.nodes[output])
    }

    /// The string at rest, before the loads of the first step.
    pub fn rest(&self) -> SteppedMotion<FREEDOMS, PLANES> {
        SteppedMotion(self.chain.rest())
    }

    /// Motion of every site in this step as far as no load acts in it, by planes and in each by
    /// sites.
    pub fn write_free(&self, motion: &SteppedMotion<FREEDOMS, PLANES>, free: &mut [f64]) {
        for (site, &node) in self.nodes.iter().enumerate() {
            let seen = self.seen_at(motion, node);
            let planes = free.chunks_exact_mut(self.nodes.len());
            for (plane, seen) in planes.zip(seen) {
                plane[site] = seen;
            }
        }
    }

    /// Ends a step with loads on the sites, by planes and in each by sites.
    pub fn end_step(&self, motion: &mut SteppedMotion<FREEDOMS, PLANES>, loads: &[f64]) {
        self.load(motion, loads);
        self.advance(motion);
    }

    /// Adds what loads on the sites do to a step.
    pub(in crate::elements) fn load(
        &self,
        motion: &mut SteppedMotion<FREEDOMS, PLANES>,
        loads: &[f64],
    ) {
        let sites = self.nodes.len();
        for (site, column) in self.columns.iter().enumerate() {
            let load: [f64; PLANES] = std::array::from_fn(|plane| loads[plane * sites + site]);
            if load.iter().any(|load| *load != 0.0) {
                motion.0.add(column, load);
            }
        }
    }

    /// Proceeds to the next step.
    pub(in crate::elements) fn advance(&self, motion: &mut SteppedMotion<FREEDOMS, PLANES>) {
        self.chain.advance(&mut motion.0);
    }

    /// The first `count` taps of every site, from a unit load at a site in the first step.
    pub(crate) fn taps_from(&self, site: usize, count: usize) -> Vec<Vec<f64>> {
        let mut first = vec![0.0; count];
        first[0] = 1.0;
        self.driven(&self.columns[site], &first)
    }

    /// Motion of every site in every step under loads on the first node.
    pub(crate) fn driven_from_above(&self, loads: &[f64]) -> Vec<Vec<f64>> {
        self.driven(&self.chain.column(0), loads)
    }

    fn driven(&self, column: &Column<FREEDOMS>, loads: &[f64]) -> Vec<Vec<f64>> {
        let mut seen = vec![Vec::with_capacity(loads.len()); self.nodes.len()];
        let mut motion = self.rest();
        for &load in loads {
            if load != 0.0 {
                motion.0.add(column, [load; PLANES]);
            }
            for (seen, &node) in seen.iter_mut().zip(&self.nodes) {
                seen.push(self.seen_at(&motion, node)[0]);
            }
            self.advance(&mut motion);
        }
        seen
    }

    /// All of a node in a step.
    pub(in crate::elements) fn state_at(
        &self,
        motion: &SteppedMotion<FREEDOMS, PLANES>,
        node: usize,
    ) -> NodeState<FREEDOMS, PLANES> {
        motion.0.state(node, &self.weights)
    }

    /// Motion of a node in a step, in every plane.
    pub(in crate::elements) fn seen_at(
        &self,
        motion: &SteppedMotion<FREEDOMS, PLANES>,
        node: usize,
    ) -> [f64; PLANES] {
        match self.seen {
            Seen::Displacement => motion.0.displacement(node, &self.weights),
            Seen::Velocity => motion.0.velocity(node, &self.weights),
        }
    }
}
