//! Waves in and out of the ports of a piece, over time.

use crate::convolution::Kernel;

/// Inputs to a response as far back as it looks.
#[derive(Debug)]
pub(super) struct Waves {
    values: Vec<f64>,
    reach: usize,
}

impl Waves {
    /// Nothing yet, of an input that these kernels read.
    pub(super) fn none(kernels: &[&Kernel]) -> Self {
        let reach = kernels.iter().map(|kernel| kernel.memory()).max();
        let reach = reach.unwrap_or(0);
        Self {
            values: Vec::with_capacity(Self::room(reach)),
            reach,
        }
    }

    /// Values after which those that nothing looks at any more are forgotten.
    pub(super) fn room(reach: usize) -> usize {
        4 * reach + 64
    }

    pub(super) fn push(&mut self, value: f64) {
        if self.values.len() == Self::room(self.reach) {
            self.values.drain(..self.values.len() - self.reach);
        }
        self.values.push(value);
    }

    /// What came last.
    pub(super) fn last(&self) -> f64 {
        self.values.last().copied().unwrap_or(0.0)
    }

    /// What the past adds to a response.
    pub(super) fn sum(&self, kernel: &Kernel) -> f64 {
        kernel.past_sum(&self.values)
    }
}

/// A piece between two nodes: what comes out at its ends.
#[derive(Debug, Clone)]
pub(super) struct LinkKernels {
    pub(super) impedance: f64,
    pub(super) top: Kernel,
    pub(super) across: Kernel,
    pub(super) bottom: Kernel,
    /// (1 + S(0))⁻¹, which is symmetric: `[top, across, bottom]`.
    inverse: [f64; 3],
}

impl LinkKernels {
    /// Responses of a link.
    pub(super) const RESPONSES: usize = 3;

    pub(super) fn new(link: &linear::cascade::Link) -> Self {
        let [top, across, bottom] =
            [&link.top, &link.across, &link.bottom].map(|taps| Kernel::new(taps));
        let [s, m, t] = [&top, &across, &bottom].map(Kernel::instant);
        let determinant = (1.0 + s) * (1.0 + t) - m * m;
        Self {
            impedance: link.impedance,
            inverse: [
                (1.0 + t) / determinant,
                -m / determinant,
                (1.0 + s) / determinant,
            ],
            top,
            across,
            bottom,
        }
    }

    /// Torques per speed within a step: at the top, between both ends, at the bottom. From
    /// f = Z v − 2 b and a + b = Z v they are Z (2 (1 + S(0))⁻¹ − 1).
    pub(super) fn stiffness(&self) -> [f64; 3] {
        let [top, across, bottom] = self.inverse;
        let z = self.impedance;
        [
            z * (2.0 * top - 1.0),
            z * 2.0 * across,
            z * (2.0 * bottom - 1.0),
        ]
    }

    /// (1 + S(0))⁻¹ of a pair.
    pub(super) fn solved(&self, [at_top, at_bottom]: [f64; 2]) -> [f64; 2] {
        let [top, across, bottom] = self.inverse;
        [
            top * at_top + across * at_bottom,
            across * at_top + bottom * at_bottom,
        ]
    }
}

/// What ends the string at a node.
#[derive(Debug, Clone)]
pub(super) struct EndKernel {
    pub(super) impedance: f64,
    pub(super) reflection: Kernel,
}

impl EndKernel {
    pub(super) fn new(impedance: f64, reflection: &[f64]) -> Self {
        Self {
            impedance,
            reflection: Kernel::new(reflection),
        }
    }

    /// (1 + S(0))⁻¹.
    pub(super) fn inverse(&self) -> f64 {
        1.0 / (1.0 + self.reflection.instant())
    }

    /// Torque per speed within a step.
    pub(super) fn stiffness(&self) -> f64 {
        self.impedance * (2.0 * self.inverse() - 1.0)
    }
}
