//! Newmark's time integration of M ü + C u̇ + K u = f (Eqs. 63–65), solved for
//! the acceleration of each step.
//!
//! With γ = ½, β = ¼ it neither gains nor loses energy, but a sticking site is
//! a feedback loop of infinite gain and the scheme answers it with chatter at
//! the Nyquist frequency. The paper's remedy is a little numerical damping:
//! γ = 0.52 and β = ¼(½ + γ)².

use numerics::NumericsError;
pub use numerics::sparse::Entry;
use numerics::sparse::{Cholesky, SparseMatrix};

use super::fading::Fading;
use crate::checks::check_sampling;
use crate::error::BuildError;
use crate::method::FiniteElement;

/// Mass, lumped damping and stiffness of the degrees of freedom that are free.
#[derive(Debug, Clone)]
pub(crate) struct Matrices {
    mass: SparseMatrix,
    damping: Vec<f64>,
    stiffness: SparseMatrix,
    fading: Option<Fading>,
}

impl Matrices {
    /// Sums element contributions, both triangles; `damping` has one dashpot a
    /// degree of freedom.
    ///
    /// # Errors
    /// Where an entry lies outside the matrix.
    pub fn new(mass: &[Entry], damping: Vec<f64>, stiffness: &[Entry]) -> Result<Self, BuildError> {
        let size = damping.len();
        Ok(Self {
            mass: SparseMatrix::new(size, mass)?,
            damping,
            stiffness: SparseMatrix::new(size, stiffness)?,
            fading: None,
        })
    }

    /// The same with forces that depend on earlier motion.
    pub fn with_fading(self, fading: Option<Fading>) -> Self {
        Self { fading, ..self }
    }

    /// Those forces.
    pub fn fading(&self) -> Option<&Fading> {
        self.fading.as_ref()
    }

    /// Number of degrees of freedom.
    pub fn size(&self) -> usize {
        self.damping.len()
    }

    /// Row, column and value of what the mass matrix has.
    pub fn mass_entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.mass.entries()
    }

    /// The same of the stiffness matrix.
    pub fn stiffness_entries(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.stiffness.entries()
    }

    /// A dashpot a degree of freedom.
    pub fn damping(&self) -> &[f64] {
        &self.damping
    }

    /// M + `damping_gain` C + `stiffness_gain` K.
    fn combined(
        &self,
        damping_gain: f64,
        stiffness_gain: f64,
    ) -> Result<SparseMatrix, NumericsError> {
        let scaled = |matrix: &SparseMatrix, gain: f64| -> Vec<Entry> {
            (matrix.entries())
                .map(|(row, column, value)| Entry::new(row, column, gain * value))
                .collect()
        };
        let mut entries = scaled(&self.mass, 1.0);
        entries.extend(scaled(&self.stiffness, stiffness_gain));
        entries.extend(
            self.damping
                .iter()
                .enumerate()
                .map(|(row, dashpot)| Entry::new(row, row, damping_gain * dashpot)),
        );
        SparseMatrix::new(self.size(), &entries)
    }
}

/// The weights of Newmark's scheme at one step length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Weights {
    /// Weight γ of the new acceleration in the velocity.
    pub gamma: f64,
    /// Weight β of the new acceleration in the displacement.
    pub beta: f64,
    /// Step length, s.
    pub step: f64,
}

impl Weights {
    /// The weights that a method's parameters and sampling frequency (Hz) give.
    ///
    /// # Errors
    /// Where the parameters are out of range.
    pub fn new(parameters: &FiniteElement, sampling_frequency: f64) -> Result<Self, BuildError> {
        parameters.check()?;
        check_sampling(sampling_frequency)?;
        Ok(Self {
            gamma: parameters.gamma,
            beta: parameters.beta(),
            step: 1.0 / sampling_frequency,
        })
    }

    /// What a unit of the new acceleration adds to the displacement.
    pub fn displacement_gain(&self) -> f64 {
        self.beta * self.step * self.step
    }

    /// What a unit of the new acceleration adds to the velocity.
    pub fn velocity_gain(&self) -> f64 {
        self.gamma * self.step
    }

    /// The least that any motion loses in a step, as the logarithm of what it was over what is
    /// left, where damping is at least `least_damping` (1/s) times the inertia of its shape and
    /// stiffness at least `least_stiffness` (1/s) times the damping.
    ///
    /// A motion whose shape has the inertia m, damping c and stiffness k is multiplied in each
    /// step by a root z of (m + γhc + βh²k)(z − 1)² + h(c + (γ + ½)hk)(z − 1) + h²k. All roots
    /// are within a circle where three inequalities hold (E. I. Jury, *Theory and Application of
    /// the z-Transform Method*, Wiley 1964), each of them linear in m, c and k: where they hold
    /// at the edges of a cone of (m, c, k), they hold within it. Its edges are what has
    /// no more than the least damping and stiffness, what has no inertia, and the infinitely
    /// stiff, which keeps a step's share for any length of the step.
    pub(crate) fn least_loss(&self, least_damping: f64, least_stiffness: f64) -> f64 {
        let (damping, stiffness) = (self.step * least_damping, self.step * least_stiffness);
        let edges = [
            (1.0, damping, damping * stiffness),
            (0.0, 1.0, stiffness),
            (0.0, 0.0, 1.0),
        ];
        let losses = edges.map(|shape| self.loss(shape));
        // With γ = ½ what is infinitely damped loses nothing, and rounding may call that a gain.
        losses.into_iter().fold(f64::INFINITY, f64::min).max(0.0)
    }

    /// What the stiffest shapes of elements lose in a step: with γ near ½ little, and with the least β
    /// nothing.
    pub(crate) fn loss_of_the_stiffest(&self) -> f64 {
        self.loss((0.0, 0.0, 1.0)).max(0.0)
    }

    /// What a motion loses in a step, of inertia m, damping hc and stiffness h²k.
    fn loss(&self, (inertia, damping, stiffness): (f64, f64, f64)) -> f64 {
        let Self { gamma, beta, .. } = *self;
        let square = inertia + gamma * damping + beta * stiffness;
        let linear = damping + (gamma + 0.5) * stiffness;
        let discriminant = damping * (damping - (2.0 * gamma - 1.0) * stiffness)
            - 4.0 * inertia * stiffness
            + ((gamma + 0.5).powi(2) - 4.0 * beta) * stiffness * stiffness;
        if discriminant < 0.0 {
            // The product of both roots.
            let less = (damping + (gamma - 0.5) * stiffness) / square;
            return -0.5 * (-less).ln_1p();
        }
        let sum = linear + discriminant.sqrt();
        let slow = -(-2.0 * stiffness / sum).ln_1p();
        let fast = -(1.0 - 0.5 * sum / square).abs().ln();
        slow.min(fast)
    }
}

/// Displacement, velocity and acceleration of every degree of freedom.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Displacements (rotations, rad).
    pub(crate) displacement: Vec<f64>,
    /// Velocities.
    pub(crate) velocity: Vec<f64>,
    /// Accelerations.
    pub(crate) acceleration: Vec<f64>,
}

impl Motion {
    /// At rest.
    pub(crate) fn rest(size: usize) -> Self {
        Self {
            displacement: vec![0.0; size],
            velocity: vec![0.0; size],
            acceleration: vec![0.0; size],
        }
    }

    /// Moves displacement and velocity one step on, the new acceleration left
    /// out: what [`Motion::accelerate`] then adds.
    pub(crate) fn predict(&mut self, weights: &Weights) {
        let Weights { gamma, beta, step } = *weights;
        for ((displacement, velocity), acceleration) in (self.displacement.iter_mut())
            .zip(&mut self.velocity)
            .zip(&mut self.acceleration)
        {
            *displacement += step * (*velocity + step * (0.5 - beta) * *acceleration);
            *velocity += step * (1.0 - gamma) * *acceleration;
            *acceleration = 0.0;
        }
    }

    /// Adds `scale · change` to the acceleration of this step, with what
    /// follows for velocity and displacement.
    pub(crate) fn accelerate(&mut self, weights: &Weights, scale: f64, change: &[f64]) {
        let displacement_gain = weights.displacement_gain();
        let velocity_gain = weights.velocity_gain();
        for (((displacement, velocity), acceleration), change) in (self.displacement.iter_mut())
            .zip(&mut self.velocity)
            .zip(&mut self.acceleration)
            .zip(change)
        {
            let change = scale * change;
            *displacement += displacement_gain * change;
            *velocity += velocity_gain * change;
            *acceleration += change;
        }
    }
}

/// Newmark's scheme for one set of matrices, its effective mass factorised.
#[derive(Debug)]
pub(crate) struct Integrator {
    weights: Weights,
    matrices: Matrices,
    effective_mass: Cholesky,
}

impl Integrator {
    /// Factorises M + γh C + βh² K.
    ///
    /// # Errors
    /// Where that is not positive definite, or forces depend on earlier motion.
    pub fn new(matrices: Matrices, weights: Weights) -> Result<Self, BuildError> {
        if matrices.fading.is_some() {
            return Err(BuildError::LossNotStepped);
        }
        let effective = matrices.combined(weights.velocity_gain(), weights.displacement_gain())?;
        Ok(Self {
            weights,
            matrices,
            effective_mass: Cholesky::new(&effective)?,
        })
    }

    /// The weights in use.
    pub fn weights(&self) -> &Weights {
        &self.weights
    }

    /// Number of degrees of freedom.
    pub fn size(&self) -> usize {
        self.matrices.size()
    }

    /// Turns forces into the accelerations they cause within the step.
    pub fn solve(&self, forces: &mut [f64]) {
        self.effective_mass.solve(forces);
    }

    /// Adds −C u̇ − K u of a predicted motion to `forces`.
    pub fn add_internal_forces(&self, motion: &Motion, forces: &mut [f64]) {
        for ((force, dashpot), velocity) in (forces.iter_mut())
            .zip(&self.matrices.damping)
            .zip(&motion.velocity)
        {
            *force -= dashpot * velocity;
        }
        (self.matrices.stiffness).add_product(-1.0, &motion.displacement, forces);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The roots of the scheme for one shape, by its recurrence in z: displacement, velocity and
    /// acceleration of one step from those of the step before.
    fn loss_by_stepping(weights: Weights, (inertia, damping, stiffness): (f64, f64, f64)) -> f64 {
        let Weights { gamma, beta, .. } = weights;
        let mut motion = [1.0, 0.3, -0.2];
        let (mut loss, count) = (0.0, 4000);
        for step in 0..count {
            let [displacement, velocity, acceleration] = motion;
            let moved = displacement + velocity + (0.5 - beta) * acceleration;
            let turned = velocity + (1.0 - gamma) * acceleration;
            let mass = inertia + gamma * damping + beta * stiffness;
            let next = -(damping * turned + stiffness * moved) / mass;
            motion = [moved + beta * next, turned + gamma * next, next];
            let size = motion
                .iter()
                .fold(0.0, |most: f64, part| most.max(part.abs()));
            motion = motion.map(|part| part / size);
            if step >= count / 2 {
                loss -= size.ln();
            }
        }
        loss / f64::from(count - count / 2)
    }

    fn weights(gamma: f64, beta: f64) -> Weights {
        let step = 1.0;
        Weights { gamma, beta, step }
    }

    /// At β = γ/2 a shape of infinite stiffness changes its sign at each step and never decays, at
    /// γ = ½ one of infinite damping neither.
    #[test]
    fn at_the_limits_of_stability_nothing_is_lost() {
        for weights in [weights(0.7, 0.35), weights(0.5, 0.25)] {
            assert_eq!(weights.least_loss(0.1, 0.02), 0.0);
        }
    }

    /// Of shapes within the cone, and at its edges.
    #[test]
    fn no_shape_loses_less_than_the_edges_of_its_cone() {
        let rule = |gamma: f64| weights(gamma, 0.25 * (0.5 + gamma).powi(2));
        for weights in [rule(0.52), rule(0.6), weights(0.55, 0.4), weights(0.7, 0.4)] {
            for (least_damping, least_stiffness) in [(1e-3, 1e-2), (0.1, 0.02), (0.5, 2.0)] {
                let least = weights.least_loss(least_damping, least_stiffness);
                assert!(least > 0.0);
                let mut closest = f64::INFINITY;
                for (more_damped, stiffer) in
                    (-4..9).flat_map(|one| (-4..12).map(move |other| (one, other)))
                {
                    let damping = least_damping * (1.0 + 4f64.powi(more_damped));
                    let stiffness = damping * least_stiffness * (1.0 + 4f64.powi(stiffer));
                    let shape = (1.0, damping, stiffness);
                    let loss = loss_by_stepping(weights, shape);
                    assert!(
                        (weights.loss(shape) - loss).abs() < 2e-3 * loss + 2e-3,
                        "{shape:?}: {loss}"
                    );
                    assert!(
                        weights.loss(shape) >= least * (1.0 - 1e-9),
                        "{shape:?}: {loss} {least}"
                    );
                    closest = closest.min(weights.loss(shape) / least);
                }
                assert!(closest < 1.3, "{closest}");
            }
        }
    }
}
